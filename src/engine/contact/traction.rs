//! The tangential traction inside a contact, for people: what an inspector draws.

/// Traction below the friction limit by this share of it is at the limit up to rounding.
const ROUNDING: f64 = 1e-9;

/// Traction of Hertz distributions laid over each other: q(r) = Σ weight · p(r; overlap), with
/// p(r; overlap) the Hertz pressure at that overlap (Ciavarella 1998, Jäger 1998).
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Traction {
    /// Overlaps, from the innermost to the present one [m], and the traction's share of μ times
    /// the pressure increment between the one before (0 at first) and this one: -1 to 1.
    pub steps: Vec<(f64, f64)>,
    /// Friction coefficient.
    pub friction: f64,
}

/// How an annulus of the contact stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Zone {
    /// Carries less than the friction limit.
    Stick,
    /// At the friction limit along +t.
    SlipForward,
    /// At the friction limit along -t.
    SlipBackward,
}

impl Traction {
    /// Overlap of the contact [m].
    pub fn overlap(&self) -> f64 {
        self.steps.last().map_or(0.0, |step| step.0)
    }

    /// Contact radius over that of the whole contact, per step: √(overlap/overlap now).
    pub fn radii(&self) -> Vec<f64> {
        let whole = self.overlap();
        let ratio = |&(overlap, _): &(f64, f64)| (overlap / whole).sqrt();
        self.steps.iter().map(ratio).collect()
    }

    /// Traction at r/a from 0 to 1, in units of μ p0 with p0 the largest pressure.
    pub fn at(&self, r: f64) -> f64 {
        let shape = |radius: f64| (radius * radius - r * r).max(0.0).sqrt();
        let mut inner = 0.0;
        let mut sum = 0.0;
        for (radius, &(_, share)) in self.radii().iter().zip(&self.steps) {
            let outer = shape(*radius);
            sum += share * (outer - inner);
            inner = outer;
        }
        sum
    }

    /// Tangential force in units of μ N: the traction summed over the contact.
    pub fn force(&self) -> f64 {
        let mut inner = 0.0;
        let mut sum = 0.0;
        for (radius, &(_, share)) in self.radii().iter().zip(&self.steps) {
            let outer = radius * radius * radius;
            sum += share * (outer - inner);
            inner = outer;
        }
        sum
    }

    /// c/a: radius of the part that sticks over that of the contact; 0 while the whole contact is
    /// at the friction limit, 1 while nothing is.
    pub fn stick_ratio(&self) -> f64 {
        let Some((_, outermost)) = self.steps.last() else {
            return 1.0;
        };
        let radii = self.radii();
        let at_limit = |share: f64| share * outermost.signum() >= 1.0 - ROUNDING;
        let stuck = self.steps.iter().rposition(|&(_, share)| !at_limit(share));
        stuck.map_or(0.0, |k| radii[k])
    }

    /// Normal pressure at r/a in units of p0.
    pub fn pressure(r: f64) -> f64 {
        (1.0 - r * r).max(0.0).sqrt()
    }

    /// Whether the annulus at r/a sticks or slips.
    pub fn zone(&self, r: f64) -> Zone {
        let limit = Self::pressure(r);
        let q = self.at(r);
        // The traction of a slip annulus is a sum of roots: equal to the limit up to rounding.
        if q >= limit * (1.0 - ROUNDING) {
            Zone::SlipForward
        } else if q <= -limit * (1.0 - ROUNDING) {
            Zone::SlipBackward
        } else {
            Zone::Stick
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Cattaneo and Mindlin: full slip outside c, inside it μp less the pressure at c.
    #[test]
    fn cattaneo() {
        let c = 0.6f64;
        let traction = Traction {
            steps: vec![(c * c, 0.0), (1.0, 1.0)],
            friction: 0.3,
        };
        for k in 0..100 {
            let r = f64::from(k) / 100.0;
            let whole = (1.0 - r * r).sqrt();
            let stick = (c * c - r * r).max(0.0).sqrt();
            assert!((traction.at(r) - (whole - stick)).abs() < 1e-15);
            let zone = if r < c {
                Zone::Stick
            } else {
                Zone::SlipForward
            };
            assert_eq!(traction.zone(r), zone, "{r}");
        }
        assert_eq!(traction.stick_ratio(), c);
        // T/(μN) = 1 - (c/a)³ (Cattaneo 1938).
        assert!((traction.force() - (1.0 - c * c * c)).abs() < 1e-15);
    }

    /// Nothing slips, everything slides, and an older slip that the newest has turned back.
    #[test]
    fn the_part_that_sticks() {
        let ratio = |steps: &[(f64, f64)]| {
            let traction = Traction {
                steps: steps.to_vec(),
                friction: 0.3,
            };
            traction.stick_ratio()
        };
        assert_eq!(ratio(&[]), 1.0);
        assert_eq!(ratio(&[(1.0, 0.9)]), 1.0);
        assert_eq!(ratio(&[(1.0, -1.0)]), 0.0);
        assert_eq!(ratio(&[(0.25, 0.0), (0.64, 1.0), (1.0, -1.0)]), 0.8);
        assert_eq!(ratio(&[(0.25, 0.0), (0.64, -1.0), (1.0, -1.0)]), 0.5);
    }
}
