//! At constant normal force the law is the closed form of Mindlin & Deresiewicz, whatever the step.

use ballast::engine::contact::two_reversals::{Branch, Reversals, TwoReversals};

use crate::ball_1989::Ball;
use crate::histories::largest;
use crate::spheres::{Path, histories, pair};

/// N of the reference data [N].
const LOAD: f64 = 88.0;

/// A contact at 88 N without tangential force, as if it had been pressed slowly.
struct Pressed {
    law: TwoReversals,
    memory: Reversals,
    overlap: f64,
    slide: f64,
    limit: f64,
    lost: f64,
}

impl Pressed {
    fn new() -> Self {
        let pair = pair();
        let overlap = pair.overlap(LOAD);
        Self {
            law: pair.law(),
            memory: pair.law().seed(overlap, 0.0),
            overlap,
            slide: pair.slide(overlap),
            limit: pair.friction * LOAD,
            lost: 0.0,
        }
    }

    /// Moves by d [m] in n steps; the force [N].
    fn go(&mut self, d: f64, n: usize) -> f64 {
        for _ in 0..n {
            let step = d / n as f64;
            let slip = self.law.advance(self.overlap, step, &mut self.memory);
            self.lost += slip.micro + slip.gross;
        }
        self.law.force(&self.memory)
    }

    /// Displacement of virgin loading to xμN [m] (3.25).
    fn virgin(&self, x: f64) -> f64 {
        self.slide * (1.0 - (1.0 - x).powf(2.0 / 3.0))
    }
}

#[test]
fn reference_curve_comes_out_for_two_reversals() {
    let mut reader = csv::Reader::from_path("data/reference/md_constant_normal.csv").expect("data");
    let rows: Vec<csv::StringRecord> = reader.records().map(|row| row.expect("a row")).collect();
    assert_eq!(rows.len(), 661);
    for stride in [1, 7, 20] {
        let mut contact = Pressed::new();
        let (mut last, mut two, mut nested) = (0.0, 0.0_f64, 0.0_f64);
        for (i, row) in rows.iter().enumerate() {
            // Each corner of the curve is a step of its own.
            let turns = rows.get(i + 1).is_none_or(|next| next[1] != row[1]);
            if i % stride != 0 && !turns {
                continue;
            }
            let number = |i: usize| row[i].parse::<f64>().expect("a number");
            let force = contact.go(number(4) - last, 1);
            last = number(4);
            let error = (force - number(2)).abs() / contact.limit;
            let forgets = row[1].starts_with("re") && (301..=540).contains(&i);
            let worst = if forgets { &mut nested } else { &mut two };
            *worst = worst.max(error);
        }
        assert!(two < 2e-14, "stride {stride}: {two:e}");
        // A third and a fourth reversal are not remembered: the known defect, .072 μN here.
        assert!((0.07..0.073).contains(&nested), "{nested}");
    }
}

#[test]
fn closed_forms_come_out_in_one_step_or_many() {
    let forces = [(0.25, 9.2527), (0.5, 17.0662), (0.75, 23.1), (0.9, 25.5652)];
    let turns = [
        (0.5, 0.54321e-6, 0.030_832e-6, 1.091_85e-6),
        (0.75, 0.8854e-6, 0.095_651e-6, 5.163_19e-6),
        (0.9, 1.1517e-6, 0.186_62e-6, 12.4398e-6),
    ];
    for n in [1, 3, 1000] {
        for (part, force) in forces {
            let mut contact = Pressed::new();
            let got = contact.go(part * contact.slide, n);
            assert!((got - force).abs() < 1e-4, "{part}: {got}");
        }
        for (x, top, residual, loop_energy) in turns {
            let mut contact = Pressed::new();
            let to = contact.virgin(x);
            assert!((to - top).abs() < 1e-10, "{to}");
            let force = contact.go(to, n);
            assert!((force / contact.limit - x).abs() < 1e-13, "{force}");
            // To T = 0, then to -T*, and back: a closed loop.
            let before = contact.lost;
            let at_zero = contact.go(residual - to, n);
            assert!(at_zero.abs() < 2e-3, "{at_zero}");
            let bottom = contact.go(-to - residual, n);
            assert!((bottom / contact.limit + x).abs() < 1e-12, "{bottom}");
            let again = contact.go(2.0 * to, n);
            assert!((again - force).abs() < 1e-12 * contact.limit, "{again}");
            let lost = contact.lost - before;
            assert!((lost - loop_energy).abs() < 1e-10, "{lost:e}");
        }
    }
}

#[test]
fn reload_closes_at_the_first_turning_point() {
    // From T** above, at and below zero.
    for back in [0.2, 0.5, 0.9] {
        let mut contact = Pressed::new();
        let to = contact.virgin(0.6);
        let top = contact.go(to, 5);
        contact.go(-2.0 * back * to, 5);
        contact.go(1.999 * back * to, 5);
        assert_eq!(contact.memory.branch(), Branch::Reloading);
        let closed = contact.go(0.001 * back * to * (1.0 + 1e-9), 5);
        assert!((closed - top).abs() < 1e-8 * contact.limit, "{closed}");
        assert_eq!(contact.memory.branch(), Branch::Virgin);
        let force = contact.go(contact.virgin(0.8) - to, 5);
        assert!((force / contact.limit - 0.8).abs() < 1e-8, "{force}");
    }
}

#[test]
fn other_direction_is_the_mirror_image_to_the_bit() {
    for path in histories() {
        let law = pair().law();
        let [mut a, mut b] = [Reversals::default(); 2];
        for [overlap, d] in path.steps(50) {
            let (s, t) = (
                law.advance(overlap, d, &mut a),
                law.advance(overlap, -d, &mut b),
            );
            assert_eq!(s.force, -t.force, "{}", path.name);
            assert_eq!((s.gross, s.micro, s.sliding), (t.gross, t.micro, t.sliding));
        }
    }
}

#[test]
fn tangents_of_1989_are_of_first_order() {
    // The program took the tangent at the start of the step: ten times the steps, a tenth the error.
    let path = Path::new("", &[[1.0, 0.0], [1.0, 0.7], [1.0, -0.2], [1.0, 0.6]]);
    let error = |n| {
        let mut contact = Pressed::new();
        let mut ball = Ball::new(pair(), &[]);
        largest(
            &path,
            n,
            |overlap, d| ball.advance(overlap, d),
            |overlap, d| {
                contact.overlap = overlap;
                contact.go(d, 1)
            },
        )
    };
    let errors = [10, 100, 1000].map(error);
    assert!((0.01..0.03).contains(&errors[0]), "{errors:?}");
    for pair in errors.windows(2) {
        let order = pair[0] / pair[1];
        assert!((7.0..14.0).contains(&order), "{errors:?}");
    }
}
