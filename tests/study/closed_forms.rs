//! Errors and orders against closed forms, and references that are wrong.

use super::{Bounce, FRAC, study};

const FRACS: [f64; 5] = [0.2, 0.1, 0.05, 0.025, 0.0125];
const ALL: &str = "study.frac=[0.0125, 0.1, 0.2, 0.05, 0.025]";

/// Twelve cycles end within the first contact, after two thirds of it.
const IN_CONTACT: u64 = 12;

#[test]
fn the_error_on_a_spring_is_that_of_the_leapfrog() {
    let bounce = Bounce::new();
    let end = IN_CONTACT as f64 * bounce.dt;
    assert!(end < 0.7 * bounce.contact() && end > 0.5 * bounce.contact());
    let outcome = study(&bounce.answered(IN_CONTACT, 0.0), &[ALL]);
    let [replies] = outcome.replies.as_slice() else {
        panic!("one question was asked");
    };
    for (k, frac) in FRACS.into_iter().enumerate() {
        let cycles = IN_CONTACT as f64 * FRAC / frac;
        assert_eq!(outcome.runs[k].cycles as f64, cycles.round());
        let predicted = bounce.leapfrog(cycles, end / cycles) - bounce.height(end);
        let error = predicted.abs() / bounce.scale();
        let found = replies.judgements[k].error;
        // Heights near 1 m are rounded at 1e-16 m, and errors are lengths over 0.06 m.
        assert!((found - error).abs() < 1e-12, "{frac}: {found} {error}");
        assert!(error > 1e-6, "there is an error to find: {error}");
        if k > 0 {
            // The next term of the phase is (ω dt)²·3/80 of the first: 6e-3 at the coarsest pair.
            let order = replies.orders[k];
            assert!((order - 2.0).abs() < 0.02, "{frac}: {order}");
        }
    }
    assert!(replies.orders[0].is_nan());
    assert!(outcome.notes.is_empty(), "{:?}", outcome.notes);
}

#[test]
fn without_an_answer_the_finest_run_serves_and_its_own_error_is_allowed_for() {
    let bounce = Bounce::new();
    let question = "study.for=[\"particle:1:y\"]";
    let outcome = study(&Bounce::preset(IN_CONTACT, ""), &[ALL, question]);
    let [replies] = outcome.replies.as_slice() else {
        panic!("one question was asked");
    };
    let finest = FRACS.len() - 1;
    assert_eq!(outcome.plan.reference, finest);
    assert!(replies.judgements[finest].error.is_nan() && outcome.runs[finest].error.is_nan());
    assert!(!outcome.runs[finest].on_front);
    // Magnitudes are those of y itself, which starts at 1 m and falls.
    assert_eq!(replies.scale, 1.0);
    for (frac, order) in FRACS.iter().zip(&replies.orders).take(finest).skip(1) {
        assert!((order - 2.0).abs() < 0.05, "{frac}: {order}");
    }
    // Had the reference been taken for exact, the last order would be 2.3.
    let step = |cycles: f64| {
        let cycle = |at: f64| {
            bounce.leapfrog(at * cycles, IN_CONTACT as f64 * bounce.dt / cycles)
                - bounce.height(at * IN_CONTACT as f64 * bounce.dt)
        };
        // All rows of the preset.
        let rows = (0..=IN_CONTACT).map(|row| cycle(row as f64 / IN_CONTACT as f64).abs());
        rows.fold(0.0, f64::max)
    };
    let own = step(IN_CONTACT as f64 * FRAC / FRACS[finest]);
    let found = replies.reference_error;
    assert!((found / own - 1.0).abs() < 0.1, "{found} {own}");
}

#[test]
fn rows_are_compared_at_the_same_times_only() {
    let bounce = Bounce::new();
    let question = "study.for=[\"particle:1:y\"]";
    let fracs = "study.frac=[0.2, 0.0125]";
    let outcome = study(&Bounce::preset(IN_CONTACT, ""), &[fracs, question]);
    // The coarse run has a row at every second row of the preset.
    let rows = (0..=6).map(|row| {
        let time = 2.0 * f64::from(row) * bounce.dt;
        let fine = bounce.leapfrog(16.0 * f64::from(row), bounce.dt / 8.0);
        let coarse = bounce.leapfrog(f64::from(row), 2.0 * bounce.dt);
        assert!((fine - bounce.height(time)).abs() < 1e-4);
        (coarse - fine).abs()
    });
    let largest = rows.fold(0.0, f64::max);
    let judgement = &outcome.replies[0].judgements[0];
    assert!(
        (judgement.error - largest).abs() < 1e-13,
        "{} {largest}",
        judgement.error
    );
    let last = bounce.leapfrog(6.0, 2.0 * bounce.dt) - bounce.leapfrog(96.0, bounce.dt / 8.0);
    assert!((judgement.ends[0] - last.abs()).abs() < 1e-13);
    // Rows one coarse cycle apart differ by more than ten times as much.
    assert!(bounce.height(0.0) - bounce.height(2.0 * bounce.dt) > 10.0 * largest);
}

#[test]
fn over_many_bounces_the_error_falls_by_the_second_order() {
    let bounce = Bounce::new();
    let fracs = "study.frac=[0.05, 0.025, 0.0125, 0.00625, 0.003125]";
    let outcome = study(&bounce.answered(80, 0.0), &[fracs]);
    let errors: Vec<f64> = outcome.runs.iter().map(|run| run.error).collect();
    // Contacts begin and end within a step at other places for each FRAC, so that orders scatter;
    // over four halvings they have to lie between those of 1.7 and 3 in the mean.
    let fall = (errors[0] / errors[4]).log2() / 4.0;
    assert!((1.7..3.0).contains(&fall), "{fall}: {errors:?}");
}

#[test]
fn a_wrong_answer_is_noticed() {
    let bounce = Bounce::new();
    let right = study(&bounce.answered(IN_CONTACT, 0.0), &[ALL]);
    let wrong = study(&bounce.answered(IN_CONTACT, 1e-3), &[ALL]);
    let says = |outcome: &ballast::study::outcome::Outcome| {
        outcome
            .notes
            .iter()
            .any(|note| note.contains("a smaller one will not help"))
    };
    assert!(!says(&right), "{:?}", right.notes);
    assert!(says(&wrong), "{:?}", wrong.notes);
    let last = FRACS.len() - 1;
    assert!((right.replies[0].orders[last] - 2.0).abs() < 0.01);
    assert!(wrong.replies[0].orders[last].abs() < 0.05);
    // What is left is the falsification.
    let left = wrong.runs[last].error * bounce.scale();
    assert!((left - 1e-3).abs() < 3e-5, "{left}");
}

#[test]
fn a_coarse_reference_is_noticed() {
    let bounce = Bounce::new();
    let options = [
        ALL,
        "study.for=[\"particle:1:y\"]",
        "study.reference=\"linear@0.2\"",
    ];
    let outcome = study(&Bounce::preset(IN_CONTACT, ""), &options);
    assert_eq!(outcome.plan.reference, 0);
    let note = "linear@0.2 is not the finest run of its law";
    assert!(
        outcome.notes.iter().any(|n| n.contains(note)),
        "{:?}",
        outcome.notes
    );
    // The finest run is charged with the error of the reference.
    let end = IN_CONTACT as f64 * bounce.dt;
    let own = (bounce.leapfrog(6.0, end / 6.0) - bounce.height(end)).abs();
    let charged = outcome.replies[0].judgements[4].ends[0];
    assert!((charged / own - 1.0).abs() < 0.02, "{charged} {own}");
}

/// Two answers to one question, of two components and one; the second has its own scale.
const TWO: &str = "[[answer]]\nto = \"both\"\nstage = \"fall\"\n\
    what = [\"last(particle:1:y)\", \"last(2 * particle:1:x + 3)\"]\nvalue = [0.5, 1.0]\nscale = 0.25\n\
    [[answer]]\nto = \"both\"\nwhat = [\"max(stage_cycle)\"]\nvalue = [24]\n";

#[test]
fn answers_to_one_question_are_averaged_by_their_squares() {
    let outcome = study(&Bounce::preset(IN_CONTACT, TWO), &["study.frac=[0.05]"]);
    let bounce = Bounce::new();
    let y = bounce.leapfrog(24.0, 0.5 * bounce.dt);
    let first = ((y - 0.5) * (y - 0.5) + 4.0).sqrt() / 0.25;
    // Cycles are counted in those of the preset: twelve, not twenty-four.
    let second: f64 = 12.0 / 24.0;
    let both = (0.5 * (first * first + second * second)).sqrt();
    let judgement = &outcome.replies[0].judgements[0];
    assert!(
        (judgement.error / both - 1.0).abs() < 1e-12,
        "{} {both}",
        judgement.error
    );
    assert!((judgement.largest / first - 1.0).abs() < 1e-12);
    assert!(judgement.value.is_nan());
}

#[test]
fn a_study_runs_what_ballast_run_runs() {
    use ballast::scene::Scene;
    use ballast::session::{Budget, Options, Progress, Session};
    let text = Bounce::preset(80, "");
    let option = "model.frac=0.05".to_owned();
    let scene = Scene::parse("scene", &text, &[option]).expect("it is right");
    let mut session = Session::open(scene, Options::default()).expect("it can be built");
    let budget = Budget {
        until_cycle: Some(160),
        time: None,
    };
    // Its stage ends after 80 of its cycles; the study goes on to the same time.
    assert!(matches!(
        session.advance(budget, false),
        Ok(Progress::Finished)
    ));
    session.advance(budget, true).expect("it runs");
    let height = session.world().position(0)[1];
    let asked = ["study.frac=[0.05]", "study.for=[\"last(particle:1:y)\"]"];
    let outcome = study(&text, &asked);
    // Bit for bit, though energies are booked in one and not in the other.
    assert_eq!(
        outcome.replies[0].judgements[0].value.to_bits(),
        height.to_bits()
    );
    assert_eq!(outcome.runs[0].time, session.world().time());
}

#[test]
fn rates_and_marks_agree_with_times_and_errors() {
    let bounce = Bounce::new();
    let outcome = study(
        &bounce.answered(IN_CONTACT, 0.0),
        &[ALL, "study.within=1e-3"],
    );
    for run in &outcome.runs {
        let wall = run.timing.median();
        assert!(wall > 0.0 && run.timing.runs() >= 3);
        let steps = run.cycles as f64 / wall;
        assert!((run.particle_steps / steps - 1.0).abs() < 1e-12);
        // The disc touches the floor from the first cycle to the last.
        assert!((run.contact_updates / steps - 1.0).abs() < 1e-12);
        assert!(run.stability.is_stable());
        // One disc on one spring: dt = 2 sqrt(m/k) is the limit itself.
        assert!((run.frac_limit - 1.0).abs() < 1e-12);
        // The ledger of a linear spring closes to rounding.
        assert!(run.energy_error < 1e-12, "{}", run.energy_error);
    }
    // Errors fall with FRAC; the finest is on the front whatever the clock says.
    assert!(outcome.runs[FRACS.len() - 1].on_front);
    let fastest = outcome.fastest.expect("some are within 1e-3");
    let good: Vec<bool> = outcome.runs.iter().map(|run| run.error <= 1e-3).collect();
    assert_eq!(good.iter().filter(|good| **good).count(), 3, "{good:?}");
    for (run, good) in outcome.runs.iter().zip(good) {
        let slower = run.timing.median() >= outcome.runs[fastest].timing.median();
        assert!(!good || slower, "{}", run.name);
    }
}

#[test]
fn contacts_are_counted_in_every_cycle() {
    // Two cycles: each disc on its wall after both, the discs on each other after the second.
    let text = include_str!("../../presets/two-discs.toml");
    let outcome = study(text, &["study.frac=[1]"]);
    let [run] = outcome.runs.as_slice() else {
        panic!("one was asked for");
    };
    let per_cycle = run.contact_updates * run.timing.median() / run.cycles as f64;
    assert!((per_cycle - 2.5).abs() < 1e-12, "{per_cycle}");
    assert!((run.particle_steps / run.contact_updates - 2.0 / 2.5).abs() < 1e-12);
}

#[test]
fn whatever_counts_cycles_covers_the_same_time() {
    let more = "[[stage]]\nname = \"command\"\ndo = [\"cycle 8\", \"frac 0.05\", \"cycle 4\"]\n\
                max_cycles = 20\n\
                [[stage]]\nname = \"condition\"\nuntil = \"stage_cycle >= 8 and cycle >= 40\"\n";
    let asked = [
        "study.frac=[0.4, 0.2, 0.1, 0.025, 0.0125]",
        "study.for=[\"last(time)\"]",
    ];
    let outcome = study(&Bounce::preset(12, more), &asked);
    let bounce = Bounce::new();
    // 20 cycles, then 20 of half the step.
    let time = 30.0 * bounce.dt;
    for run in &outcome.runs {
        assert!(
            (run.time / time - 1.0).abs() < 1e-12,
            "{}: {} {time}",
            run.name,
            run.time
        );
    }
    let cycles: Vec<u64> = outcome.runs.iter().map(|run| run.cycles).collect();
    assert_eq!(cycles, [10, 20, 40, 160, 320]);
}
