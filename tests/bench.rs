//! `ballast bench`: its numbers hang together, and a clock changes no bit.

#[path = "program/mod.rs"]
mod program;

use ballast::engine::World;
use ballast::engine::phase::Phase;
use ballast::scene::Scene;
use ballast::session::Options;
use ballast::session::start::resolve;
use program::{ballast, said};
use std::sync::{Arc, Mutex};

/// Four spheres in a cell, repeated three times across and twice up.
const SAMPLE: &str = r#"
[model]
law = "hertz-mindlin"
[material.glass]
density = 2650.0
young = 70e9
poisson = 0.25
friction = 0.3
[cell]
size = [3.9988e-3, 3.9988e-3]
[[generate]]
in = { rectangle = { min = [0, 0], max = [3.9988e-3, 3.9988e-3] } }
material = "glass"
lattice = "square"
radius = 1e-3
spacing = 1.9994e-3
"#;

const START: &str = r#"
[start]
preset = "sample.toml"
repeat = [3, 2]
"#;

fn worlds(folder: &std::path::Path) -> [World; 2] {
    let stage = "[[stage]]\nname = \"still\"\nmax_cycles = 1\n";
    let head = SAMPLE.split("[cell]").next().expect("it has a beginning");
    let sample = folder.join("sample.toml");
    std::fs::write(&sample, format!("{SAMPLE}{stage}")).expect("it can be written");
    let repeated = folder.join("repeated.toml");
    std::fs::write(&repeated, format!("{head}{START}{stage}")).expect("it can be written");
    [sample, repeated].map(|path| {
        let scene = Scene::load(&path.display().to_string(), &[]).expect("it is accepted");
        let options = Options {
            no_cache: true,
            ..Options::default()
        };
        let started = resolve(scene, &options, &mut |_| true).expect("its sample is prepared");
        let mut scene = started.scene;
        let brought = scene.brought();
        World::build_from(scene.take_setup(), &brought, 1).expect("it is built")
    })
}

#[test]
fn a_repeated_sample_is_the_same_in_every_copy() {
    let folder = tempfile::tempdir().expect("a folder");
    let [one, six] = worlds(folder.path());
    let n = one.particles().len();
    assert_eq!(six.particles().len(), 6 * n);
    let touching = |world: &World| {
        (0..world.contacts().len())
            .filter(|&k| world.springs(k)[0] > 0.0)
            .count()
    };
    assert!(
        touching(&one) == 2 * n && touching(&six) == 12 * n,
        "{} {}",
        touching(&one),
        touching(&six)
    );
    let area = |world: &World| world.cell().expect("it has one").area();
    assert!((area(&six) / area(&one) - 6.0).abs() < 1e-14);
    // The same force everywhere: coordinates of copies lose no more than their last digits.
    let force = |world: &World, k: usize| world.springs(k)[0];
    let first = force(&one, 0);
    assert!(first > 0.0);
    for k in 0..six.contacts().len() {
        assert!((force(&six, k) / first - 1.0).abs() < 1e-9, "{k}");
    }
}

#[test]
fn copies_need_a_cell_and_whole_numbers() {
    let folder = tempfile::tempdir().expect("a folder");
    let text = |repeat: &str, sample: &str| {
        let head = SAMPLE.split("[cell]").next().expect("it has a beginning");
        format!(
            "{head}[start]\npreset = \"{sample}\"\nrepeat = {repeat}\n[[stage]]\nname = \"s\"\nmax_cycles = 1\n"
        )
    };
    let open = SAMPLE.replace("[cell]\nsize = [3.9988e-3, 3.9988e-3]\n", "");
    let stage = "[[stage]]\nname = \"s\"\nmax_cycles = 1\n";
    std::fs::write(folder.path().join("open.toml"), open + stage).expect("it can be written");
    for (preset, hint) in [
        (
            text("[2.5, 1]", "open.toml"),
            "two whole numbers from 1 to 1000",
        ),
        (
            text("[2, 2]", "open.toml"),
            "along the edges of its cell, and it has none",
        ),
        (
            text("[2, 2]\nkeep = \"all\"", "open.toml"),
            "exclude each other",
        ),
    ] {
        std::fs::write(folder.path().join("it.toml"), preset).expect("it can be written");
        let output = ballast(folder.path(), &["run", "it.toml", "--no-cache", "-q"]);
        assert_eq!(output.status.code(), Some(2), "{}", said(&output));
        assert!(
            said(&output).contains(hint),
            "no `{hint}` in {}",
            said(&output)
        );
    }
}

#[test]
fn a_step_moves_what_it_works_on_and_no_more_than_there_is() {
    let folder = tempfile::tempdir().expect("a folder");
    let [one, six] = worlds(folder.path());
    let moved = |world: &World| world.traffic().bytes();
    for world in [&one, &six] {
        let (n, contacts) = (world.particles().len(), world.contacts().len());
        let bytes = world.bytes();
        let all = bytes.particle * n + bytes.contact * contacts;
        // Nothing is moved more often than it is read by both passes and written by one.
        assert!(moved(world) < 3 * all, "{} {all}", moved(world));
        // Two velocities, two places, a spin, an angle, read and written; two forces of each contact.
        let least = 2 * 6 * 8 * n + 2 * 2 * 8 * contacts;
        assert!(moved(world) > least, "{} {least}", moved(world));
    }
    let contacts = [&one, &six].map(|world| world.contacts().len());
    assert_eq!(contacts[1], 6 * contacts[0]);
    assert_eq!(moved(&six), 6 * moved(&one));
}

#[test]
fn a_clock_hears_of_every_part_and_changes_nothing() {
    let folder = tempfile::tempdir().expect("a folder");
    let [mut plain, _] = worlds(folder.path());
    let [mut timed, _] = worlds(folder.path());
    let heard: Arc<Mutex<Vec<Phase>>> = Arc::default();
    let shared = Arc::clone(&heard);
    timed.set_clock(Some(Box::new(move |phase| {
        shared.lock().expect("nobody panics with it").push(phase);
    })));
    for _ in 0..3 {
        plain.cycle().expect("it runs");
        timed.cycle().expect("it runs");
    }
    assert_eq!(plain.state_hash(), timed.state_hash());
    let heard = heard.lock().expect("nobody panics with it");
    for (name, phase) in Phase::ALL {
        assert!(
            heard.iter().filter(|other| **other == phase).count() >= 3,
            "{name}"
        );
    }
}

#[test]
fn scenes_are_listed_and_wrong_ones_answered() {
    let folder = tempfile::tempdir().expect("a folder");
    let list = ballast(folder.path(), &["bench", "--list"]);
    let text = String::from_utf8_lossy(&list.stdout).into_owned();
    for name in [
        "shear-600",
        "linear-600",
        "dense-20k",
        "dense-100k",
        "hopper-500",
        "dense-million",
    ] {
        assert!(text.contains(name), "{text}");
    }
    let rows = ballast(folder.path(), &["bench", "--help"]);
    assert!(String::from_utf8_lossy(&rows.stdout).contains("--cycles"));
    let wrong = ballast(folder.path(), &["bench", "shear-60"]);
    assert_eq!(wrong.status.code(), Some(2));
    assert!(
        said(&wrong).contains("did you mean `shear-600`?"),
        "{}",
        said(&wrong)
    );
}

#[test]
fn a_preset_is_timed_where_it_is_asked() {
    let folder = tempfile::tempdir().expect("a folder");
    let stages = ["first", "last"].map(|name| {
        format!(
            "[[stage]]\nname = \"{name}\"\nmax_cycles = 20\ndo = [\"damp contact 0.{}\"]\n",
            name.len()
        )
    });
    let preset = format!("{SAMPLE}{}{}", stages[0], stages[1]);
    std::fs::write(folder.path().join("own.toml"), &preset).expect("it can be written");
    let timed = |more: &[&str]| {
        let first = [
            "bench", "own.toml", "--cycles", "50", "--csv", "-", "--quiet",
        ];
        ballast(folder.path(), &[&first, more].concat())
    };
    // Scene, law and state at the end.
    let row = |more: &[&str]| {
        let output = timed(more);
        assert_eq!(output.status.code(), Some(0), "{}", said(&output));
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        let mut lines = text.lines().map(|line| line.split(',').collect::<Vec<_>>());
        let (names, row) = (lines.next().expect("names"), lines.next().expect("a row"));
        assert_eq!(lines.next(), None);
        ["scene", "law", "state_hash"].map(|name| {
            let found = names.iter().position(|other| *other == name);
            row[found.unwrap_or_else(|| panic!("no {name} in {text}"))].to_owned()
        })
    };
    let usual = row(&[]);
    assert_eq!(usual[..2], ["own", "hertz-mindlin"]);
    assert_eq!(usual, row(&["--at", "last"]));
    // Hashes know their cycles.
    let others = [
        row(&["--at", "first"]),
        row(&["--at", "first/7"]),
        row(&["--at", "last/7"]),
    ];
    let all: std::collections::BTreeSet<_> = others.iter().chain([&usual]).collect();
    assert_eq!(all.len(), 4, "{all:?}");
    assert_eq!(row(&["--set", "model.law=\"hertz\""])[1], "hertz");
    for (more, hint) in [
        (["--at", "second"], "own has no stage `second`"),
        (["--set", "model.lw=\"hertz\""], "lw"),
    ] {
        let output = timed(&more);
        assert_eq!(output.status.code(), Some(2), "{}", said(&output));
        assert!(said(&output).contains(hint), "{}", said(&output));
    }
}

/// It is timed by a script that nothing else runs.
#[test]
fn the_scene_of_several_sizes_is_accepted() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/benches/polydisperse.toml");
    let set = [
        "generate.grains.distribution={kind=\"lognormal\", mean=1e-3, deviation=7e-4, min=2e-4, max=5e-3, count=50}",
        "generate.grains.in={rectangle={min=[0.0, 0.0], max=[0.1, 0.1]}}",
        "cell.size=[0.1, 0.1]",
        "particle.1.at=[0.05, 0.05]",
        "particle.1.radius=0.01",
    ];
    let scene = Scene::load(path, &set.map(str::to_owned)).expect("it is accepted");
    assert_eq!(scene.stages.last().expect("it has stages").name, "timed");
}
