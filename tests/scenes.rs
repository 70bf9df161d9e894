//! Presets that are right and presets that are wrong: the corpus in `data/scenes`.
//!
//! A file holds several presets between lines `+++`. In `bad`, lines that begin with `#^ ` say what
//! the report on the preset above has to contain; lines that begin with `#+ ` are options `--set`.

use std::fs;

use ballast::engine::setup::{
    Body, Damping, Dashpot, Gravity, LawChoice, NormalForm, TimeStepChoice,
};
use ballast::language::{Command, Observable};
use ballast::scene::{Band, Scene, catalogue};

/// One preset of a corpus file.
struct Case {
    name: String,
    text: String,
    overrides: Vec<String>,
    fragments: Vec<String>,
}

fn corpus(folder: &str) -> Vec<Case> {
    let folder = format!("{}/data/scenes/{folder}", env!("CARGO_MANIFEST_DIR"));
    let mut cases = Vec::new();
    for file in fs::read_dir(&folder).expect("the corpus can be read") {
        let path = file.expect("the corpus can be read").path();
        let text = fs::read_to_string(&path).expect("the corpus can be read");
        let stem = path
            .file_stem()
            .expect("the corpus can be read")
            .to_str()
            .expect("the corpus can be read");
        for (k, part) in text.split("+++\n").enumerate() {
            let starting = |mark: &str| -> Vec<String> {
                part.lines()
                    .filter_map(|line| line.strip_prefix(mark))
                    .map(str::to_owned)
                    .collect()
            };
            cases.push(Case {
                name: format!("{stem} {}", k + 1),
                text: part
                    .lines()
                    .filter(|line| !line.starts_with("#^ ") && !line.starts_with("#+ "))
                    .flat_map(|line| [line, "\n"])
                    .collect(),
                overrides: starting("#+ "),
                fragments: starting("#^ "),
            });
        }
    }
    cases
}

/// Whether a line of the report names a place: `name:LINE:COLUMN`.
fn names_a_place(report: &str) -> bool {
    report.lines().any(|line| {
        let mut numbers = line.rsplit(':').map(|part| part.trim().parse::<usize>());
        line.trim_start().starts_with("--> ")
            && matches!(numbers.next(), Some(Ok(1..)))
            && matches!(numbers.next(), Some(Ok(1..)))
    })
}

#[test]
fn good_presets_are_accepted() {
    let cases = corpus("good");
    assert!(cases.len() >= 5);
    for case in cases {
        if let Err(rejection) = Scene::parse(&case.name, &case.text, &case.overrides) {
            panic!("{}:\n{rejection}", case.name);
        }
    }
}

#[test]
fn wrong_presets_are_refused_with_place_reason_and_remedy() {
    let cases = corpus("bad");
    assert!(cases.len() >= 60, "{} cases", cases.len());
    let mut failures = Vec::new();
    for case in cases {
        assert!(!case.fragments.is_empty(), "{} expects nothing", case.name);
        let Err(rejection) = Scene::parse("p.toml", &case.text, &case.overrides) else {
            failures.push(format!("{} was accepted", case.name));
            continue;
        };
        let report = rejection.to_string();
        let remedies = report.matches("= help: ").count();
        let mut missing: Vec<&str> = case
            .fragments
            .iter()
            .map(String::as_str)
            .filter(|fragment| !report.contains(fragment))
            .collect();
        if !names_a_place(&report) {
            missing.push("(a line and a column)");
        }
        if remedies != rejection.count().min(20) {
            missing.push("(a remedy for each problem)");
        }
        if !missing.is_empty() {
            failures.push(format!("{}: no {missing:?} in\n{report}", case.name));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n\n"));
}

#[test]
fn embedded_presets_are_accepted() {
    for preset in catalogue::PRESETS {
        if let Err(rejection) = Scene::load(preset.name, &[]) {
            panic!("{rejection}");
        }
    }
}

const SMALL: &str = "[model]\nbody = \"disc\"\n[material.m]\ndensity = 1e3\n\
                     normal_stiffness = 1e6\n[[particle]]\nat = [0, 0]\nradius = 1\nmaterial = \"m\"\n";

#[test]
fn what_is_left_out_has_the_documented_value() {
    let scene = Scene::parse("small", SMALL, &[]).expect("it is a good preset");
    let setup = &scene.setup;
    assert_eq!(setup.law, LawChoice::linear());
    assert_eq!(setup.normal, NormalForm::Total);
    assert_eq!(setup.time_step, TimeStepChoice::Critical);
    assert_eq!(setup.frac, 0.1);
    assert_eq!(setup.gravity, None);
    assert_eq!(setup.damping, Damping::default());
    assert_eq!((setup.tol, setup.fracc_every), (None, 1));
    assert!(setup.rotation && !setup.overlap_allowed);
    assert_eq!(setup.materials[0].shear_stiffness, None);
    assert_eq!(setup.materials[0].friction, 0.0);
    assert_eq!(setup.particles[0].fixed, [false; 3]);
    assert_eq!((scene.seed, scene.history.every), (1, 100));
    assert_eq!(scene.history.columns, Observable::usual());
    assert!(!scene.history.named && scene.check_every.is_none());
    // What makes cycles longer has to be named.
    assert!(!setup.ledger && scene.booked_for().is_empty());

    let seconds = ["model.time_step=1e-5".to_owned()];
    let scene = Scene::parse("small", SMALL, &seconds).expect("it is a good preset");
    assert_eq!(scene.setup.time_step, TimeStepChoice::Seconds(1e-5));
    assert_eq!(scene.setup.frac, 1.0);
    let sphere = [
        "model.body=sphere",
        "model.law=linear",
        "material.m.young=1e9",
    ]
    .into_iter()
    .chain(["material.m.poisson=0.2"])
    .map(str::to_owned)
    .collect::<Vec<String>>();
    let scene = Scene::parse("small", SMALL, &sphere).expect("it is a good preset");
    assert_eq!(scene.setup.time_step, TimeStepChoice::Rayleigh);
}

#[test]
fn energies_are_booked_only_if_something_reads_them() {
    let ledger = |more: &str| {
        let text = format!("{SMALL}[history]\ncolumns = [\"contacts\"]\n{more}");
        let scene = Scene::parse("small", &text, &[]).expect("it is a good preset");
        assert_eq!(scene.setup.ledger, !scene.booked_for().is_empty());
        scene.setup.ledger
    };
    let both = "[[stage]]\nname = \"a\"\nuntil = \"friction_loss > 1 and slip_loss > kinetic\"\n\
                [history]\ncolumns = [\"contacts\", \"slip_loss\"]\n";
    let scene = Scene::parse("small", &format!("{SMALL}{both}"), &[]).expect("it is a good preset");
    assert_eq!(scene.booked_for(), ["slip_loss", "friction_loss"]);
    // What commands of stages wait for counts, too.
    let typed = "[[stage]]\nname = \"a\"\ndo = [\"solve until damping_loss > 1 max 10\"]\n";
    let scene = Scene::parse("small", &format!("{SMALL}{typed}"), &[]).expect("a good preset");
    assert_eq!(scene.booked_for(), ["damping_loss"]);
    assert!(scene.setup.ledger);
    assert!(!ledger(""));
    assert!(!ledger(
        "[[stage]]\nname = \"a\"\nuntil = \"kinetic < 1\"\n"
    ));
    assert!(ledger(
        "[[stage]]\nname = \"a\"\nuntil = \"friction_loss > 1\"\n"
    ));
    assert!(ledger(
        "[[expect]]\nwhat = \"last(energy_error)\"\nvalue = 0\nwithin = 1e-9\n"
    ));
}

#[test]
fn overrides_are_put_where_their_path_says() {
    let case = corpus("good")
        .into_iter()
        .find(|case| case.name == "overrides 1")
        .expect("it is in the corpus");
    let scene = Scene::parse("p", &case.text, &case.overrides).expect("it is a good preset");
    let setup = &scene.setup;
    assert_eq!(setup.frac, 0.2);
    assert_eq!(
        setup.gravity,
        Some(Gravity::Centripetal {
            towards: [0.0, 0.0],
            g: 9.81
        })
    );
    assert_eq!(setup.damping.contact, Dashpot::Fraction(0.1));
    assert_eq!(setup.materials[0].friction, 0.5);
    assert_eq!(setup.materials[0].shear_stiffness, Some(1e6));
    assert_eq!(setup.pairs[0].restitution, Some(0.9));
    assert_eq!(setup.particles[1].radius, 1e-3);
    assert_eq!(setup.particles[0].at, [0.25, 0.0]);
    assert_eq!(setup.walls[0].velocity, [0.0, -1.0]);
    assert_eq!(setup.walls[0].angular_velocity, 1.0);
    let until = scene.stages[0].until.as_ref().map(ToString::to_string);
    assert_eq!(until.as_deref(), Some("cycle >= 100"));
    assert_eq!(scene.stages[0].commands[1], Command::Zero);
    assert_eq!(scene.history.columns.len(), 1);
    assert_eq!(scene.overrides, case.overrides);
    // The last of two counts.
    let twice = ["model.frac=0.3".to_owned(), "model.frac=0.4".to_owned()];
    let scene = Scene::parse("p", SMALL, &twice).expect("it is a good preset");
    assert_eq!(scene.setup.frac, 0.4);
}

#[test]
fn every_key_reaches_the_setup() {
    let case = corpus("good")
        .into_iter()
        .find(|case| case.name == "forms 2")
        .expect("it is in the corpus");
    let scene = Scene::parse("p", &case.text, &[]).expect("it is a good preset");
    let setup = &scene.setup;
    assert_eq!(setup.body, Body::Sphere);
    assert_eq!(setup.normal, NormalForm::Incremental);
    assert_eq!(setup.time_step, TimeStepChoice::RayleighExact);
    assert_eq!((setup.fracc_every, setup.tol), (10, Some(1e-4)));
    assert_eq!(scene.seed, u64::MAX);
    assert_eq!(scene.check_every, Some(5));
    let damping = &setup.damping;
    assert_eq!(damping.wall, Some(Dashpot::Fraction(0.3)));
    assert_eq!((damping.tangential, damping.pull), (Some(0.0), true));
    assert_eq!(
        (damping.global, damping.con1, damping.local),
        (1.5, 0.99, 0.7)
    );
    let names: Vec<&str> = setup.materials.iter().map(|m| m.name.as_str()).collect();
    assert_eq!(names, ["glass", "lead-glass", "stone"]);
    assert!(setup.materials[2].rigid);
    assert_eq!(setup.pairs[0].materials, [0, 2]);
    assert_eq!(setup.pairs[0].cohesion, Some(0.0));
    let first = &setup.particles[0];
    assert_eq!((first.spin, first.angle), (2.0, 0.5));
    assert_eq!((first.velocity, first.force), ([0.0, -1.0], [0.0, 1e-3]));
    assert_eq!(first.fixed, [true, false, false]);
    assert_eq!(setup.particles[1].fixed, [true; 3]);
    let [floor, slope] = setup.walls.as_slice() else {
        panic!("there are two walls");
    };
    assert_eq!((floor.point, floor.direction), ([-0.1, 0.0], [1.0, 0.0]));
    assert_eq!((floor.h1, floor.h2, floor.about), (0.0, 0.2, [-0.1, 0.0]));
    assert_eq!(slope.direction, [0.6, 0.8]);
    assert_eq!(
        (slope.h1, slope.h2, slope.about),
        (0.0, f64::INFINITY, [2.0, 2.0])
    );
    let stage = &scene.stages[0];
    assert_eq!(stage.max_cycles, Some(2_000_000));
    assert_eq!((stage.check_every, stage.commands.len()), (Some(1), 2));
    let expect = &scene.expects[0];
    assert_eq!(expect.within, Band::Relative(0.1));
    let differs = expect.differs.as_ref().expect("it was written");
    assert_eq!((differs.ours, differs.within), (2.0, Band::Absolute(0.1)));
    assert_eq!(scene.about.try_.len(), 3);
}

#[test]
fn marks_and_line_ends_of_other_systems_are_accepted() {
    let text = format!("\u{feff}{}", SMALL.replace('\n', "\r\n"));
    assert!(Scene::parse("small", &text, &[]).is_ok());
    let wrong = text.replace("radius = 1", "radius = -1");
    let report = Scene::parse("small", &wrong, &[])
        .expect_err("it is wrong")
        .to_string();
    assert!(report.contains("--> small:8:10"), "{report}");
}

#[test]
fn files_that_are_no_presets_are_refused() {
    let folder = tempfile::tempdir().expect("there is room");
    let path = |name: &str| folder.path().join(name).display().to_string();
    let refusal = |path: &str| {
        let report = Scene::load(path, &[]).expect_err("it is wrong").to_string();
        assert!(report.contains("= help: "), "{report}");
        report
    };
    for (name, bytes, text) in [
        ("empty.toml", &b""[..], "is empty"),
        ("blank.toml", b" \n\t\n", "is empty"),
        ("latin.toml", b"[model]\n# gr\xf6\xdfe\n", "latin.toml:2:5"),
        ("nul.toml", b"[model]\nfrac\0 = 1\n", "nul.toml:2:5"),
    ] {
        fs::write(path(name), bytes).expect("there is room");
        let report = refusal(&path(name));
        assert!(report.contains(text), "{report}");
    }
    let large = fs::File::create(path("large.toml")).expect("there is room");
    large.set_len(1 << 40).expect("a file may have holes");
    assert!(refusal(&path("large.toml")).contains("larger than"));
    assert!(refusal(&path("nul.tml")).contains("nul.toml"));
    assert!(refusal(&folder.path().display().to_string()).contains("is a folder"));
    assert!(refusal("two-disks").contains("did you mean `two-discs`?"));
    assert!(refusal("").contains("embedded presets: "));
}
