//! FORD and THETA of Randall's section 4.3, written down as they stand, with the corrections and
//! with each misprint at will. Forward Euler, the tangent at the start of each step.

use crate::spheres::Spheres;

/// What is taken as printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Misprint {
    /// (3.82): exponent -1/3 while reloading.
    Exponent,
    /// (3.95) to (3.97): (1 - force)/force.
    Dimensions,
    /// (4.24): T\* for T\*\*.
    TurningPoint,
    /// 4.3.2: Δs > μ Δs_c + DD.
    FrictionTwice,
    /// (4.17): progress -Δs while unloading counted as lost.
    Progress,
    /// (4.18): progress not counted while N falls.
    ProgressInFall,
    /// 4.3.1: only T > μN slides.
    OneSided,
    /// T\*\* = 0 means none.
    Sentinel,
    /// The reversal is found after θ.
    LateReversal,
    /// DD grows during pure normal loading.
    ShortOfNothing,
    /// DD survives a reversal.
    ShortfallKept,
    /// At ΔN = 0 no part of a step is at full stiffness.
    NoCatchUp,
    /// (4.20), (4.21) left out.
    NoShift,
}

/// Every misprint.
pub(crate) const MISPRINTS: [Misprint; 13] = [
    Misprint::Exponent,
    Misprint::Dimensions,
    Misprint::TurningPoint,
    Misprint::FrictionTwice,
    Misprint::Progress,
    Misprint::ProgressInFall,
    Misprint::OneSided,
    Misprint::Sentinel,
    Misprint::LateReversal,
    Misprint::ShortOfNothing,
    Misprint::ShortfallKept,
    Misprint::NoCatchUp,
    Misprint::NoShift,
];

/// The program with its memory.
#[derive(Debug, Clone)]
pub(crate) struct Ball {
    spheres: Spheres,
    misprints: Vec<Misprint>,
    load: f64,
    pub(crate) force: f64,
    pub(crate) first: Option<f64>,
    second: Option<f64>,
    dd: f64,
}

impl Ball {
    pub(crate) fn new(spheres: Spheres, misprints: &[Misprint]) -> Self {
        Self {
            spheres,
            misprints: misprints.to_vec(),
            load: 0.0,
            force: 0.0,
            first: None,
            second: None,
            dd: 0.0,
        }
    }

    fn prints(&self, misprint: Misprint) -> bool {
        self.misprints.contains(&misprint)
    }

    /// T\* or T\*\*, as a sentinel of zero would show it.
    fn value(&self, point: Option<f64>) -> Option<f64> {
        point.filter(|value| !self.prints(Misprint::Sentinel) || *value != 0.0)
    }

    fn direction(&self, ds: f64) -> f64 {
        let sign = |x: f64| 1.0_f64.copysign(x);
        match self.value(self.first) {
            Some(first) => sign(first),
            None if self.force != 0.0 => sign(self.force),
            None => sign(ds),
        }
    }

    /// Whether the step begins unloading, or reloading.
    fn reversal(&mut self, old: f64, s: f64) -> [bool; 2] {
        let begins = [
            s < 0.0 && self.value(self.first).is_none(),
            s > 0.0 && self.value(self.first).is_some() && self.value(self.second).is_none(),
        ];
        if begins[0] {
            self.first = Some(old);
        } else if begins[1] {
            self.second = Some(old);
        }
        if (begins[0] || begins[1]) && !self.prints(Misprint::ShortfallKept) {
            self.dd = 0.0;
        }
        begins
    }

    /// THE1, UFL and θ (4.22) to (4.25).
    fn theta(&self, rise: f64, critical: f64, s: f64, cdf: f64) -> (usize, f64, f64) {
        let limit = self.spheres.friction * self.load;
        let t = self.force * cdf;
        let first = self.value(self.first).map_or(0.0, |x| x * cdf);
        let second = self.value(self.second).map_or(0.0, |x| x * cdf);
        let (mut the1, ufl) = if s >= 0.0 && t.abs() < first.abs() {
            (3, 1.0)
        } else if s >= 0.0 {
            (1, 1.0)
        } else if self.value(self.second).is_some() && t > second {
            // Non-linear elastic on the reloading curve, with the signs of (3.94) for reloading.
            (3, 1.0)
        } else {
            (2, -1.0)
        };
        let extra = if self.prints(Misprint::FrictionTwice) {
            self.spheres.friction
        } else {
            1.0
        };
        let catches_up = self.dd > 0.0 && !self.prints(Misprint::NoCatchUp);
        let backwards = the1 == 3 && s < 0.0 && self.dd == 0.0;
        let may_stick = rise > 0.0 && !backwards || rise == 0.0 && catches_up;
        if may_stick && ufl * s < extra * critical + self.dd {
            the1 = 4;
        }
        let from = if self.prints(Misprint::TurningPoint) {
            first
        } else {
            second
        };
        let (way, scale) = match the1 {
            1 => (t + rise, limit),
            2 => (first - t + 2.0 * rise, 2.0 * limit),
            3 => (t - from + 2.0 * rise, 2.0 * limit),
            _ => (0.0, limit),
        };
        let cube = if the1 == 4 {
            1.0
        } else if self.prints(Misprint::Dimensions) {
            (1.0 - way) / scale
        } else {
            1.0 - way / scale
        };
        let theta = cube.clamp(0.0, 1.0).cbrt();
        let theta = if the1 == 3 && self.prints(Misprint::Exponent) {
            1.0 / theta
        } else {
            theta
        };
        (the1, ufl, theta)
    }

    /// One step; the force [N].
    pub(crate) fn advance(&mut self, overlap: f64, ds: f64) -> f64 {
        let stiffness = 8.0 * self.spheres.shear_eff * (self.spheres.r_eff * overlap).sqrt();
        let mu = self.spheres.friction;
        let load = self.spheres.load(overlap);
        let rise = mu * (load - self.load);
        self.load = load;
        if load <= 0.0 {
            *self = Self::new(self.spheres, &self.misprints);
            return 0.0;
        }
        let virgin = self.force == 0.0 && self.value(self.first).is_none();
        if virgin && !self.prints(Misprint::ShortOfNothing) {
            self.dd = 0.0;
        }
        let (old, cdf) = (self.force, self.direction(ds));
        let s = ds * cdf;
        let late = self.prints(Misprint::LateReversal);
        let mut begins = [false; 2];
        if !late {
            begins = self.reversal(old, s);
        }
        let critical = rise / stiffness;
        let (the1, ufl, theta) = self.theta(rise, critical, s, cdf);
        let mut increment = cdf * (theta * (stiffness * s - rise * ufl) + rise * ufl);
        let behind = the1 != 4 && rise >= 0.0 && self.dd > 0.0;
        if behind && !self.prints(Misprint::NoCatchUp) {
            let full = self.dd.min((ufl * s - critical).max(0.0));
            increment += cdf * ufl * (1.0 - theta) * stiffness * full;
        }
        if the1 == 4 || self.dd > 0.0 {
            let progress = if rise < 0.0 && self.prints(Misprint::ProgressInFall) {
                0.0
            } else if self.prints(Misprint::Progress) {
                s
            } else {
                ufl * s
            };
            self.dd = (self.dd + critical - progress).max(0.0);
        }
        if late {
            begins = self.reversal(old, s);
        }
        self.force += increment;
        self.finish(mu * load, rise, cdf, s, begins);
        self.force
    }

    /// Sliding, (4.20), (4.21), and the end of what is remembered.
    fn finish(&mut self, limit: f64, rise: f64, cdf: f64, s: f64, begins: [bool; 2]) {
        let slides = if self.prints(Misprint::OneSided) {
            self.force > limit
        } else {
            self.force.abs() > limit
        };
        if slides {
            self.force = limit.copysign(self.force);
            (self.first, self.second, self.dd) = (None, None, 0.0);
            return;
        }
        if !self.prints(Misprint::NoShift) {
            if let Some(first) = self.first.as_mut().filter(|_| !begins[0]) {
                *first += cdf * rise;
            }
            if let Some(second) = self.second.as_mut().filter(|_| !begins[1]) {
                *second -= cdf * rise;
            }
        }
        let Some(first) = self.value(self.first).map(|x| x * cdf) else {
            return;
        };
        let force = self.force * cdf;
        if first <= 0.0 || force >= first && s > 0.0 || force <= -first {
            (self.first, self.second) = (None, None);
        } else if self.second.is_some_and(|x| force <= x * cdf) && s < 0.0 {
            self.second = None;
        }
    }
}
