//! What others see of the memory of two reversals.

use super::{Branch, Reversals, TwoReversals};

impl Branch {
    /// In words.
    pub fn name(self) -> &'static str {
        match self {
            Self::Virgin => "virgin",
            Self::Unloading => "unloading",
            Self::Reloading => "reloading",
        }
    }
}

impl Reversals {
    /// T\* and T\*\* [N], as far as they have a meaning.
    pub fn turning_points(&self) -> [Option<f64>; 2] {
        let [first, second] = match self.branch {
            Branch::Virgin => [false; 2],
            Branch::Unloading => [true, false],
            Branch::Reloading => [true; 2],
        };
        [
            first.then_some(self.unloaded_from),
            second.then_some(self.reloaded_from),
        ]
    }

    /// DD [m]: what the displacement falls short of the curve.
    pub fn shortfall(&self) -> f64 {
        self.shortfall
    }
}

impl TwoReversals {
    /// Overlap at the outer end of each annulus [m] and the share of μ that its traction takes.
    ///
    /// The law keeps forces, no traction: this is the one of a history at the present normal force
    /// that turned at the same points (Mindlin & Deresiewicz 1953; Randall 1989, 3.2), and it adds up
    /// to the force. After a change of N the true one may differ. `None` where the law itself says so:
    /// the force is short of the curve, and all of the contact sticks.
    pub fn shares(&self, memory: &Reversals) -> Option<Vec<(f64, f64)>> {
        let size = self.size(memory.overlap);
        if size.limit <= 0.0 || memory.shortfall > 0.0 {
            return None;
        }
        let direction = memory.direction(0.0);
        let [force, top, bottom] =
            [memory.force, memory.unloaded_from, memory.reloaded_from].map(|f| direction * f);
        let square = |way: f64, stretch: f64| {
            let root = libm::cbrt((1.0 - way / (stretch * size.limit)).clamp(0.0, 1.0));
            root * root
        };
        let mut ends = match memory.branch {
            Branch::Virgin => vec![square(force, 1.0)],
            Branch::Unloading => vec![square(top, 1.0), square(top - force, 2.0)],
            Branch::Reloading => vec![
                square(top, 1.0),
                square(top - bottom, 2.0),
                square(force - bottom, 2.0),
            ],
        };
        ends.push(1.0);
        let mut shares = vec![0.0];
        shares.extend(
            [direction, -direction]
                .into_iter()
                .cycle()
                .take(ends.len() - 1),
        );
        let mut inside = 0.0;
        let mut steps = Vec::with_capacity(ends.len());
        for (end, share) in ends.into_iter().zip(shares) {
            if end > inside {
                steps.push((end * memory.overlap, share));
                inside = end;
            }
        }
        Some(steps)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::contact::traction::{Traction, Zone};

    /// Two reversals at constant N: the traction carries the force, and its annuli are those of the
    /// closed form c³ = 1 - (T* - T)/(2μN).
    #[test]
    fn the_traction_carries_the_force() {
        let friction = 0.3;
        let law = TwoReversals::new(2e9, 1e9, 0.01, friction);
        let mut memory = law.seed(1e-6, 0.0);
        let limit = law.size(1e-6).limit;
        let slide = law.size(1e-6).slide;
        for (way, zone) in [
            (0.5, Zone::SlipForward),
            (-0.6, Zone::SlipBackward),
            (0.3, Zone::SlipForward),
            (-0.1, Zone::SlipForward),
        ] {
            for _ in 0..50 {
                law.advance(1e-6, way * slide / 50.0, &mut memory);
            }
            let steps = law.shares(&memory).expect("N is constant");
            let traction = Traction { steps, friction };
            let carried = traction.force();
            assert!(
                (carried - memory.force() / limit).abs() < 1e-12,
                "{carried}"
            );
            assert_eq!(traction.zone(0.999), zone, "{memory:?}");
            if memory.branch() == Branch::Unloading {
                let way = (memory.unloaded_from - memory.force) / (2.0 * limit);
                let c = libm::cbrt(1.0 - way);
                assert!((traction.stick_ratio() - c).abs() < 1e-14);
            }
        }
        assert_eq!(memory.branch(), Branch::Reloading);
        assert!(memory.turning_points().iter().all(Option::is_some));
    }

    /// A load that grows faster than the shear leaves the contact stuck: an annulus that slips would
    /// be made up.
    #[test]
    fn nothing_is_made_up_while_the_contact_is_short_of_its_curve() {
        let law = TwoReversals::new(2e9, 1e9, 0.01, 0.3);
        let mut memory = law.seed(1e-6, 0.0);
        law.advance(1e-6, 0.3 * law.size(1e-6).slide, &mut memory);
        assert!(law.shares(&memory).is_some());
        law.advance(1.5e-6, 1e-9, &mut memory);
        assert!(memory.shortfall() > 0.0 && law.shares(&memory).is_none());
    }
}
