//! Wrong presets through the program: each is refused with a place, a reason and a remedy, quickly,
//! and no file is made.

mod program;

use std::fmt::Write;
use std::fs;
use std::path::Path;
use std::time::{Duration, Instant};

use program::{ballast, said};

/// Longest time a wrong preset may take. Ten megabytes take a good part of a second where nothing
/// else runs; going back and forth in them would take hours.
const PATIENCE: Duration = Duration::from_secs(300);

/// Asserts that `check`, `run` and `verify` refuse a preset; answers what `run` said.
#[track_caller]
fn refuse(name: &str, text: &[u8], set: &[String]) -> String {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    fs::write(folder.join("p.toml"), text).expect("it can be written");
    let mut messages = Vec::new();
    for words in [
        &["check", "p.toml"][..],
        &["verify", "p.toml"],
        &[
            "run",
            "p.toml",
            "--csv",
            "x.csv",
            "--checkpoint",
            "x.state",
            "--cycles",
            "5",
        ],
    ] {
        let mut words: Vec<&str> = words.to_vec();
        for option in set {
            words.extend(["--set", option]);
        }
        let start = Instant::now();
        let output = ballast(folder, &words);
        let took = start.elapsed();
        let said = said(&output);
        assert_eq!(output.status.code(), Some(2), "{name}: {words:?}: {said}");
        assert!(took < PATIENCE, "{name}: {words:?} took {took:?}");
        assert!(output.stdout.is_empty(), "{name}: {words:?}");
        assert!(!said.contains("panicked"), "{name}: {said}");
        assert_eq!(names(folder), ["p.toml"], "{name}: {words:?}");
        messages.push(said);
    }
    let first = messages.remove(0);
    assert!(messages.iter().all(|message| *message == first), "{name}");
    first
}

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("the folder is there");
    let names = entries.map(|entry| entry.expect("it can be read").file_name());
    let mut names: Vec<String> = names.map(|name| name.to_string_lossy().into()).collect();
    names.sort();
    names
}

/// Whether a line of a message is `--> FILE:LINE:COLUMN`.
fn names_a_place(message: &str) -> bool {
    message.lines().any(|line| {
        let Some(place) = line.trim_start().strip_prefix("--> ") else {
            return false;
        };
        let mut parts = place.rsplit(':');
        let mut number = || parts.next().and_then(|part| part.parse::<u32>().ok());
        number().is_some_and(|n| n > 0) && number().is_some_and(|n| n > 0)
    })
}

#[test]
fn the_corpus_of_wrong_presets_is_refused_by_the_program() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/data/scenes/bad");
    let mut cases = 0;
    for file in fs::read_dir(folder).expect("the corpus can be read") {
        let path = file.expect("the corpus can be read").path();
        let text = fs::read_to_string(&path).expect("the corpus can be read");
        for (k, part) in text.split("+++\n").enumerate() {
            cases += 1;
            let name = format!("{} {}", path.display(), k + 1);
            let starting = |mark: &str| -> Vec<String> {
                let lines = part.lines().filter_map(|line| line.strip_prefix(mark));
                lines.map(str::to_owned).collect()
            };
            let preset: String = part
                .lines()
                .filter(|line| !line.starts_with("#^ ") && !line.starts_with("#+ "))
                .flat_map(|line| [line, "\n"])
                .collect();
            let message = refuse(&name, preset.as_bytes(), &starting("#+ "));
            for fragment in starting("#^ ") {
                assert!(
                    message.contains(&fragment),
                    "{name}: no `{fragment}`:\n{message}"
                );
            }
            assert!(names_a_place(&message), "{name}:\n{message}");
            assert!(message.contains("= help: "), "{name}:\n{message}");
        }
    }
    assert!(cases >= 50, "{cases} cases");
}

/// A good preset; the wrong ones below differ from it in one thing.
const GOOD: &str = r#"[model]
law = "linear"
body = "disc"
[material.m]
density = 1000.0
normal_stiffness = 1e6
[[particle]]
at = [0.0, 0.0]
radius = 1.0
material = "m"
[[particle]]
at = [2.0, 0.0]
radius = 1.0
material = "m"
[[stage]]
name = "a"
max_cycles = 5
"#;

#[test]
fn one_mistake_in_a_good_preset_is_named_with_its_remedy() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("good.toml"), GOOD).expect("it can be written");
    let output = ballast(folder.path(), &["run", "good.toml"]);
    assert_eq!(output.status.code(), Some(0), "{}", said(&output));
    for (old, new, place, hint) in [
        ("density", "densty", "p.toml:5:1", "`density`"),
        ("1000.0", "\"heavy\"", "p.toml:5:11", "density"),
        ("1000.0", "-1000.0", "p.toml:5:11", "density"),
        ("1000.0", "nan", "p.toml:5:11", "density"),
        ("1000.0", "inf", "p.toml:5:11", "density"),
        ("1000.0", "", "p.toml:5:", "density"),
        ("radius = 1.0", "radius = -1.0", "p.toml:9:10", "radius"),
        ("radius = 1.0", "radius = 0", "p.toml:9:10", "radius"),
        ("radius = 1.0\n", "", "p.toml:7:1", "radius"),
        ("[2.0, 0.0]", "[1.5, 0.0]", "p.toml:12:", "overlap"),
        ("[2.0, 0.0]", "[0.0, 0.0]", "p.toml:12:", "overlap"),
        ("[2.0, 0.0]", "[2.0]", "p.toml:12:6", "at"),
        ("[2.0, 0.0]", "[2.0, nan]", "p.toml:12:", "at"),
        (
            "material = \"m\"\n[[stage]]",
            "material = \"n\"\n[[stage]]",
            "p.toml:14:12",
            "there is m",
        ),
        ("[material.m]", "[materail.m]", "p.toml:4:2", "`material`"),
        ("\"linear\"", "\"liner\"", "p.toml:2:7", "`linear`"),
        ("\"disc\"", "\"disk\"", "p.toml:3:8", "`disc`"),
        (
            "max_cycles = 5",
            "max_cycles = 10_000_000_000_000_000_000",
            "p.toml:17:14",
            "",
        ),
        (
            "max_cycles = 5",
            "max_cycles = 0",
            "p.toml:17:14",
            "max_cycles",
        ),
        (
            "max_cycles = 5",
            "max_cycles = 1.5",
            "p.toml:17:14",
            "max_cycles",
        ),
        (
            "max_cycles = 5",
            "do = [\"frictoin 1\"]",
            "p.toml:17:",
            "`friction`",
        ),
        (
            "max_cycles = 5",
            "until = \"kinetc < 1\"",
            "p.toml:17:",
            "`kinetic`",
        ),
        ("max_cycles = 5", "until = \"kinetic <\"", "p.toml:17:", ""),
        ("max_cycles = 5", "", "p.toml:15:1", "max_cycles"),
        ("[[stage]]", "[stage]", "p.toml:15:", "[[stage]]"),
        ("[model]", "[model", "p.toml:1:", "]"),
        ("name = \"a\"", "name = \"a", "p.toml:16:", ""),
        (
            "name = \"a\"",
            "name = \"a\"\nname = \"b\"",
            "p.toml:17:1",
            "name",
        ),
    ] {
        assert!(GOOD.contains(old), "{old}");
        let wrong = GOOD.replacen(old, new, 1);
        let message = refuse(new, wrong.as_bytes(), &[]);
        assert!(message.contains(place), "{new}: no {place} in\n{message}");
        assert!(message.contains(hint), "{new}: no {hint} in\n{message}");
        assert!(message.contains("= help: "), "{new}:\n{message}");
    }
}

#[test]
fn what_is_no_preset_at_all_is_refused_quickly() {
    let mut noise = Vec::with_capacity(10 << 20);
    let mut state = 1_u64;
    while noise.len() < 10 << 20 {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        noise.extend_from_slice(&state.to_le_bytes());
    }
    let printable: Vec<u8> = noise.iter().map(|byte| b' ' + byte % 95).collect();
    let mut particles = String::new();
    for k in 0..200_000 {
        let _ = write!(particles, "[[particle]]\nat = [{k}.0, 0.0]\n");
    }
    for (name, text) in [
        ("nothing", Vec::new()),
        ("blanks", b"\n  \n\t\n".to_vec()),
        ("a comment", b"# nothing else\n".to_vec()),
        ("noise", noise),
        ("printable noise", printable),
        ("zeros", vec![0; 1 << 20]),
        ("brackets", vec![b'['; 10 << 20]),
        ("braces", [b"a = ".to_vec(), vec![b'{'; 10 << 20]].concat()),
        ("particles without anything", particles.into_bytes()),
        ("a large file", vec![b'#'; 17 << 20]),
        ("a picture", b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR".to_vec()),
        ("a history", b"cycle,time,stage\n0,0.0,a\n".to_vec()),
        ("JSON", b"{\"model\": {}}".to_vec()),
        ("a count", b"[[generate]]\ncount = 10000000000\n".to_vec()),
    ] {
        let message = refuse(name, &text, &[]);
        assert!(message.contains("p.toml"), "{name}:\n{message}");
        assert!(message.contains("help: "), "{name}:\n{message}");
        assert!(
            message.len() < 20_000,
            "{name}: {} bytes said",
            message.len()
        );
    }
}
