//! The largest stable FRAC, against closed forms.

use std::fmt::Write;

use ballast::scene::Scene;
use ballast::study::limits::{Limit, limits};

use super::{Bounce, study};

#[track_caller]
fn limit(text: &str, options: &[&str]) -> Limit {
    let options: Vec<String> = options.iter().map(|option| (*option).to_owned()).collect();
    let scene = Scene::parse("scene", text, &options).unwrap_or_else(|why| panic!("{why}"));
    let found = limits(&scene, 1, &mut |_| true).unwrap_or_else(|why| panic!("{why:?}"));
    let [limit] = found.as_slice() else {
        panic!("one series was asked for");
    };
    limit.clone()
}

/// Asserts that a closed form lies between what was seen to be stable and what was not.
#[track_caller]
fn brackets(found: &Limit, exact: f64, off: f64) {
    let unstable = found.unstable.expect("something is unstable");
    assert!(unstable <= 1.0101 * found.stable, "{found:?}");
    assert!(found.stable < exact * (1.0 + off), "{found:?} {exact}");
    assert!(unstable > exact * (1.0 - off), "{found:?} {exact}");
}

/// Discs in a square lattice, pressed together by a thousandth of their radius, in a box; one is
/// nudged.
fn lattice(side: u32, friction: f64, shear: f64) -> String {
    let pitch = 0.999;
    let end = f64::from(side) * pitch;
    let mut text = format!(
        "[model]\nbody = \"disc\"\n[material.m]\ndensity = 1e3\nnormal_stiffness = 1e6\n\
         shear_stiffness = {shear:?}\nfriction = {friction:?}\n"
    );
    for k in 0..side * side {
        let at = [k % side, k / side].map(|n| (f64::from(n) + 0.5) * pitch);
        let _ = writeln!(
            text,
            "[[particle]]\nat = {at:?}\nradius = 0.5\nmaterial = \"m\""
        );
    }
    for (name, from, to) in [
        ("left", [0.0, 0.0], [0.0, end]),
        ("right", [end, 0.0], [end, end]),
        ("bottom", [0.0, 0.0], [end, 0.0]),
        ("top", [0.0, end], [end, end]),
    ] {
        let _ = writeln!(
            text,
            "[[wall]]\nname = \"{name}\"\nmaterial = \"m\"\nfrom = {from:?}\nto = {to:?}"
        );
    }
    text + "[history]\nevery = 10\n[[stage]]\nname = \"nudge\"\n\
            do = [\"particle 1 velocity 1e-6 2e-6\", \"particle 1 spin 3e-6\"]\nmax_cycles = 3000\n"
}

#[test]
fn one_disc_between_four_walls() {
    // Two springs along each axis: 2/sqrt(2k/m) over 2 sqrt(m/k).
    let found = limit(&lattice(1, 0.0, 0.0), &[]);
    brackets(&found, 0.5f64.sqrt(), 1e-9);
    // The bound is the limit itself here.
    assert!(
        (found.frac_limit / 0.5f64.sqrt() - 1.0).abs() < 1e-9,
        "{found:?}"
    );
}

#[test]
fn nine_discs_with_friction() {
    // The largest eigenvalue of the nine discs in their box; overlaps of 1e-3 shorten the arms.
    let found = limit(&lattice(3, 1e3, 1e6), &[]);
    brackets(&found, 0.267_09, 1.5e-3);
    assert!(found.frac_limit < 0.267_09 && found.frac_limit > 0.5 * 0.267_09);
    assert!(
        found.reason.contains("the energy it was given"),
        "{found:?}"
    );
}

#[test]
fn a_bouncing_disc_is_limited_by_the_energy_it_gains() {
    let found = limit(&Bounce::preset(400, ""), &[]);
    // At the limit of its spring, 1, a contact lasts two steps; well below, energy comes from
    // nothing when it begins and ends.
    let unstable = found.unstable.expect("something is unstable");
    assert!(found.stable > 0.1 && unstable < 1.0, "{found:?}");
}

#[test]
fn too_short_a_run_tells_nothing() {
    let found = limit(&Bounce::preset(2, ""), &[]);
    assert_eq!((found.stable, found.unstable), (0.0, None));
    assert!(found.reason.contains("too few to tell"), "{found:?}");
}

#[test]
fn a_study_tells_which_variants_ran_away() {
    let asked = ["study.frac=[0.2, 0.3, 0.6]", "study.for=[\"kinetic\"]"];
    let outcome = study(&lattice(3, 1e3, 1e6), &asked);
    let stable: Vec<bool> = outcome
        .runs
        .iter()
        .map(|run| run.stability.is_stable())
        .collect();
    assert_eq!(stable, [false, false, true]);
    for name in ["linear@0.6", "linear@0.3"] {
        assert!(
            outcome.notes.iter().any(|note| note.starts_with(name)),
            "{:?}",
            outcome.notes
        );
    }
}

#[test]
fn a_variant_that_fails_leaves_the_others_alone() {
    // The last one runs away so fast that a disc is lost.
    let asked = ["study.frac=[0.2, 0.25, 4]", "study.for=[\"kinetic\"]"];
    let outcome = study(&lattice(3, 1e3, 1e6), &asked);
    let [failed, coarse, fine] = outcome.runs.as_slice() else {
        panic!("three were asked for");
    };
    assert!(
        failed.stability.reason().contains("cycle"),
        "{:?}",
        failed.stability
    );
    assert!(failed.error.is_nan() && failed.timing.runs() == 0 && !failed.on_front);
    assert!(coarse.error > 0.0 && coarse.on_front && fine.timing.runs() > 0);
}

#[test]
fn a_failed_reference_is_said() {
    let asked = [
        "study.frac=[0.2]",
        "study.reference=\"4\"",
        "study.for=[\"kinetic\"]",
    ];
    let outcome = study(&lattice(3, 1e3, 1e6), &asked);
    assert!(!outcome.has_reference);
    assert!(outcome.runs.iter().all(|run| run.error.is_nan()));
    let note = "the reference run linear@4 was not finished";
    assert!(
        outcome.notes.iter().any(|n| n.contains(note)),
        "{:?}",
        outcome.notes
    );
}
