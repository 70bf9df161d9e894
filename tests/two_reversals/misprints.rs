//! Each misprint of the thesis, and each flaw in the logic of FORD and THETA, on a path that shows
//! it: the corrected program follows the law there, the program with the misprint does not.
//!
//! Not here: CDF = -1 at T = 0 (unloading from T\* = 0 has the formula of loading), T\* kept when a
//! fall of N makes it negative (the next step ends the loop for another reason), and what is not
//! in the law, as the damping of (4.19).

use crate::ball_1989::{Ball, MISPRINTS, Misprint};
use crate::histories::{ball, exact, largest, law};
use crate::spheres::{Path, histories, pair};

/// Steps per leg: the tangents of 1989 then err by less than .001 μN.
const FINE: usize = 1000;

/// A path on which a misprint shows, and the least it then errs by, over μN.
fn shown(misprint: Misprint) -> Option<(Path, f64)> {
    let known = |name: &str| {
        let path = histories().into_iter().find(|path| path.name == name);
        path.expect("one of the histories")
    };
    let shown = match misprint {
        Misprint::Exponent => (known("R_down"), 0.25),
        Misprint::Dimensions => (known("L_after_normal"), 0.9),
        Misprint::TurningPoint => (known("R_down"), 0.1),
        Misprint::FrictionTwice => (known("L_up_slow"), 0.06),
        // Stuck while it unloads and N rises, then unloaded on.
        Misprint::Progress => (
            Path::new(
                "U_catch_up",
                &[[0.6, 0.0], [0.6, 0.45], [1.0, 0.35], [1.0, -0.4]],
            ),
            0.2,
        ),
        // Stuck, then loaded faster than the curve falls with N, then on.
        Misprint::ProgressInFall => (
            Path::new(
                "L_through_fall",
                &[[0.6, 0.0], [0.6, 0.2], [1.0, 0.3], [0.95, 0.6], [0.95, 0.9]],
            ),
            0.11,
        ),
        Misprint::OneSided => (known("slide_up_down").mirrored(), 0.3),
        Misprint::ShortOfNothing => (known("L_after_normal"), 0.19),
        // Stuck, then reversed.
        Misprint::ShortfallKept => (
            Path::new(
                "L_U_short",
                &[[0.6, 0.0], [0.6, 0.25], [1.0, 0.35], [1.0, -0.4]],
            ),
            0.015,
        ),
        Misprint::NoCatchUp => (
            Path::new(
                "L_catch_up",
                &[[0.6, 0.0], [0.6, 0.2], [1.0, 0.3], [1.0, 0.7]],
            ),
            0.1,
        ),
        Misprint::NoShift => (known("U_down"), 0.7),
        // They have tests of their own.
        Misprint::Sentinel | Misprint::LateReversal => return None,
    };
    Some(shown)
}

#[test]
fn every_misprint_shows() {
    for misprint in MISPRINTS {
        let Some((path, least)) = shown(misprint) else {
            continue;
        };
        let right = largest(&path, FINE, ball(&[]), law());
        let wrong = largest(&path, FINE, ball(&[misprint]), law());
        assert!(right < 1e-3, "{misprint:?}: corrected {right}");
        assert!(wrong > least, "{misprint:?}: {wrong}");
    }
}

#[test]
fn turning_point_at_zero_is_no_sentinel() {
    // At constant N from T* = .75 μN to T = 0, and back by half the sliding displacement. A zero
    // that means none lets the second step begin the reloading anew: three coarse steps show it.
    // That the law takes zero for a turning point is a test beside it, exact to round-off.
    let pair = pair();
    let overlap = pair.overlap(88.0);
    let (limit, slide) = (pair.friction * 88.0, pair.slide(overlap));
    let reload = |misprints: &[Misprint], steps: usize| {
        let mut ball = Ball::new(pair, misprints);
        ball.advance(overlap, 0.0);
        let go = |ball: &mut Ball, d: f64, steps: usize| {
            for _ in 0..steps {
                ball.advance(overlap, d / steps as f64);
            }
        };
        let to = slide * (1.0 - 0.25_f64.powf(2.0 / 3.0));
        go(&mut ball, to, FINE);
        go(&mut ball, 0.095_651e-6 - to, FINE);
        assert!((ball.force / limit).abs() < 2e-3, "{}", ball.force);
        ball.force = 0.0;
        go(&mut ball, 0.5 * slide, steps);
        ball.force / limit
    };
    // δ - δ** = 2 δ* (1 - θ²), T = 2μN (1 - θ³); T* is not reached.
    let want = 2.0 * (1.0 - 0.75_f64.powf(1.5));
    let fine = reload(&[], FINE);
    assert!((fine - want).abs() < 1e-3, "{fine}, not {want}");
    let [right, wrong] = [reload(&[], 3), reload(&[Misprint::Sentinel], 3)];
    assert!(wrong - right > 0.02 && right > want, "{wrong} {right}");
}

#[test]
fn late_reversal_shows_in_its_first_step() {
    // Three steps for a leg, the reversed one among them: what is lost is one step's θ. The law is
    // exact on this path, whatever the step.
    let history = histories()
        .into_iter()
        .find(|path| path.name == "U_up_fast");
    let path = history.expect("one of the histories");
    let end = |mut run: Box<dyn FnMut(f64, f64) -> f64>| {
        let steps = path.steps(3).into_iter();
        steps
            .map(|[overlap, d]| run(overlap, d))
            .last()
            .expect("steps")
    };
    let limit = pair().friction * 88.0;
    let truth = end(Box::new(exact()));
    assert!((end(Box::new(law())) - truth).abs() < 1e-13 * limit);
    let right = end(Box::new(ball(&[])));
    let wrong = end(Box::new(ball(&[Misprint::LateReversal])));
    assert!(
        (right - wrong).abs() > 0.01 * limit,
        "{right} {wrong} {truth}"
    );
}
