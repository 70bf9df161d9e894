//! What the program lists about itself is complete, and wrong names are answered with near ones.

mod program;

use std::fs;
use std::path::Path;

use ballast::engine::contact::laws::LAWS;
use ballast::language::COMMANDS;
use ballast::measure::columns::listing;
use ballast::scene::Scene;
use ballast::scene::catalogue::{PRESETS, Preset};
use program::{ballast, said};

/// What is asked of the program besides the workbench.
fn subcommands() -> Vec<String> {
    let help = listed(&["--help"]);
    let (_, list) = help.split_once("\nCommands:\n").expect("there are some");
    let names = list.lines().take_while(|line| !line.is_empty());
    let names = names.filter(|line| !line.starts_with("      "));
    let names = names.filter_map(|line| line.split_whitespace().next());
    let names: Vec<String> = names
        .filter(|name| *name != "help")
        .map(Into::into)
        .collect();
    for known in ["run", "bench", "plot", "export"] {
        assert!(
            names.iter().any(|name| name == known),
            "{known} in {names:?}"
        );
    }
    names
}

/// Standard output of a call that succeeds and has nothing to say beside it.
#[track_caller]
fn listed(words: &[&str]) -> String {
    let output = ballast(Path::new("."), words);
    assert_eq!(
        output.status.code(),
        Some(0),
        "{words:?}: {}",
        said(&output)
    );
    assert_eq!(said(&output), "", "{words:?}");
    let text = String::from_utf8(output.stdout).expect("it is text");
    assert!(
        text.ends_with('\n') && !text.contains('\u{1b}'),
        "{words:?}"
    );
    text
}

/// The message of a call that is refused.
#[track_caller]
fn refused(words: &[&str], hints: &[&str]) {
    let output = ballast(Path::new("."), words);
    let said = said(&output);
    assert_eq!(output.status.code(), Some(2), "{words:?}: {said}");
    assert!(output.stdout.is_empty(), "{words:?}");
    for hint in hints {
        assert!(said.contains(hint), "{words:?}: no `{hint}` in {said}");
    }
}

/// Whether a line starts with these words, whatever blanks stand between them.
fn has_line(text: &str, start: &[&str]) -> bool {
    let fits = |line: &str| {
        let mut words = line.split_whitespace();
        start.iter().all(|word| words.next() == Some(word))
    };
    text.lines().any(fits)
}

#[test]
fn presets_are_listed_with_their_titles_and_shown_as_they_are() {
    let list = listed(&["presets"]);
    assert_eq!(list.lines().count(), PRESETS.len());
    for preset in PRESETS {
        let line = list.lines().find(|line| line.starts_with(preset.name));
        let title = line.expect("it is listed")[preset.name.len()..].trim();
        assert!(!title.is_empty() && preset.text.contains(title), "{title}");
        assert_eq!(
            listed(&["show", preset.name]),
            preset.text,
            "{}",
            preset.name
        );
        let file = format!(
            "{}/presets/{}.toml",
            env!("CARGO_MANIFEST_DIR"),
            preset.name
        );
        assert_eq!(fs::read_to_string(file).expect("it is there"), preset.text);
    }
}

#[test]
fn a_preset_that_was_shown_and_saved_runs_alike() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    for name in [
        "two-discs",
        "nine-disc-speed",
        "rolling-disc",
        "square-lattice",
    ] {
        fs::write(folder.join("mine.toml"), listed(&["show", name])).expect("it can be written");
        let run = |preset: &str| {
            let output = ballast(folder, &["run", preset, "--csv", "-", "--cycles", "500"]);
            assert_eq!(output.status.code(), Some(0), "{}", said(&output));
            output.stdout
        };
        assert!(run(name) == run("mine.toml"), "{name}");
        let check = ballast(folder, &["check", "mine.toml"]);
        assert_eq!(check.status.code(), Some(0), "{}", said(&check));
    }
}

#[test]
fn laws_columns_and_keys_are_complete() {
    let laws = listed(&["laws"]);
    for law in LAWS {
        assert!(
            laws.contains(&format!("{}: {}", law.name, law.summary)),
            "{laws}"
        );
        for parameter in law.parameters {
            let unit = format!("[{}]", parameter.unit);
            assert!(
                has_line(&laws, &[parameter.key, &unit]),
                "{}",
                parameter.key
            );
        }
    }
    let columns = listed(&["columns"]);
    for (prefix, card) in listing() {
        let name = format!("{prefix}{} ", card.name);
        let mut lines = columns.lines().filter(|line| line.starts_with(&name));
        let line = lines.next().unwrap_or_else(|| panic!("no {name}"));
        assert!(line.contains(&format!("[{}]", card.unit)), "{line}");
        assert!(line.ends_with(card.summary), "{line}");
        assert_eq!(lines.next(), None);
    }
    let keys = listed(&["keys"]);
    for key in [
        "law",
        "frac",
        "normal_stiffness",
        "max_cycles",
        "within_rel",
        "quick",
        "every",
    ] {
        assert!(keys.contains(key), "{key}");
    }
}

#[test]
fn every_command_is_listed_and_has_a_page() {
    let list = listed(&["commands"]);
    for card in COMMANDS {
        let row = format!("{}\n    {}\n", card.usage, card.summary);
        assert!(list.contains(&row), "{row}");
        let page = listed(&["commands", card.name]);
        assert!(
            page.contains(card.name) && page.lines().count() >= 2,
            "{page}"
        );
        // Words are found by their beginnings, as at the prompt.
        let upper = card.name.to_uppercase();
        assert_eq!(listed(&["commands", &upper]), page);
    }
}

/// What `check` tells of an embedded preset.
fn check_is_complete(preset: &Preset) {
    let report = listed(&["check", preset.name]);
    // Most cannot be told before the sample is prepared.
    if preset.text.contains("\n[start]\n") {
        assert!(report.contains("\nstarts from:"), "{report}");
        return;
    }
    for label in [
        "modelled:",
        "not modelled:",
        "sizes:",
        "start:",
        "memory:",
        "time step:",
        "frac limit:",
        "stages:",
        "length:",
        "history:",
        "files:",
        "expectations:",
    ] {
        let lines = report
            .lines()
            .filter(|line| line.starts_with(label))
            .count();
        assert_eq!(lines, 1, "{}: {label} in\n{report}", preset.name);
    }
    let scene = Scene::load(preset.name, &[]).expect("it is embedded");
    let why = report.lines().any(|line| line.starts_with("energies:"));
    assert_eq!(!scene.booked_for().is_empty(), why, "{report}");
    assert!(!report.contains("the run fails"), "{report}");
    assert!(!report.contains("expect instability"), "{report}");
}

#[test]
fn check_tells_what_a_user_wants_to_know() {
    // Each looks for a while how fast the preset runs.
    std::thread::scope(|scope| {
        for few in PRESETS.chunks(PRESETS.len().div_ceil(4)) {
            scope.spawn(|| few.iter().for_each(check_is_complete));
        }
    });
    let unstable = listed(&["check", "square-lattice", "--set", "model.frac=0.3"]);
    assert!(
        unstable.contains("frac = 0.3 is above the limit 0.25"),
        "{unstable}"
    );
    let fails = listed(&["check", "nine-disc-compression", "--set", "model.frac=5"]);
    assert!(
        fails.contains("the run fails: cycle 3: particle 1"),
        "{fails}"
    );
    let deep = listed(&[
        "check",
        "two-discs",
        "--set",
        "particle.1.radius=1.2",
        "--set",
        "model.overlap=\"allow\"",
    ]);
    assert!(deep.contains("particles 1 and 2 overlap by 20 %"), "{deep}");
    // Boundaries with their size, and nothing wider than a terminal.
    let cell = listed(&["check", "load-unload"]);
    assert!(cell.contains("edges 0.0364 0"), "{cell}");
    let ring = listed(&["check", "graded-compression"]);
    assert!(ring.contains("0.02 m in radius"), "{ring}");
    for line in cell.lines().chain(ring.lines()) {
        assert!(line.chars().count() <= 80, "{line}");
    }
    // Nothing is said about what is in order.
    assert!(!listed(&["check", "rolling-disc"]).contains("limit 0.3506 at cycle"));
}

#[test]
fn help_and_manual_name_everything() {
    let help = listed(&["--help"]);
    let manual = listed(&["man"]);
    for subcommand in &subcommands() {
        assert!(has_line(&help, &[subcommand]), "{subcommand} in\n{help}");
        let title = format!("ballast\\-{subcommand}(1)");
        assert!(manual.contains(&title), "{title} in\n{manual}");
        let page = listed(&[subcommand, "--help"]);
        assert!(page.contains("Usage: ballast"), "{page}");
        assert_eq!(listed(&["help", subcommand]), page);
    }
    let run = listed(&["run", "--help"]);
    for option in [
        "--csv",
        "--set",
        "--seed",
        "--threads",
        "--cycles",
        "--checkpoint",
        "--every",
        "--resume",
        "--quiet",
    ] {
        assert!(run.contains(option), "{option} in\n{run}");
    }
    let version = format!("ballast {}\n", env!("CARGO_PKG_VERSION"));
    assert_eq!(listed(&["--version"]), version);
}

#[test]
fn every_shell_gets_completions_for_every_subcommand() {
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let script = listed(&["completions", shell]);
        let options = ["threads", "resume", "cycles"].map(String::from);
        for word in subcommands().iter().chain(&options) {
            assert!(script.contains(word), "{shell}: {word}");
        }
    }
}

#[test]
fn wrong_names_are_answered_with_near_ones() {
    for (words, hints) in [
        (
            &["show", "nine-disc-compresion"][..],
            &["did you mean", "nine-disc-compression"][..],
        ),
        (
            &["show", "zzz"],
            &["there is no embedded preset", "`ballast presets`"],
        ),
        (&["show"], &["<NAME>"]),
        (&["commands", "frictoin"], &["did you mean", "friction"]),
        (&["commands", "zzz"], &["zzz"]),
        (&["check", "two-disc"], &["there is no preset", "two-discs"]),
        (
            &["verify", "two-disc"],
            &["there is no preset", "two-discs"],
        ),
        (&["verify", "two-discs", "rolling-disk"], &["rolling-disc"]),
        (
            &["verify", "two-discs", "--set", "model.farc=1"],
            &["farc", "frac"],
        ),
        (&["completions", "basch"], &["bash"]),
        (&["laws", "--al"], &["--al"]),
        (&["check"], &["<PRESET>"]),
    ] {
        refused(words, hints);
    }
}

#[test]
fn check_says_what_a_law_has_no_use_for() {
    let folder = tempfile::tempdir().expect("a folder");
    let scene = |law: &str, keys: &str, pair: &str| {
        let text = format!(
            "[model]\nlaw = \"{law}\"\nbody = \"sphere\"\n[material.a]\ndensity = 2500\nyoung = 1e9\n\
             poisson = 0.3\nnormal_stiffness = 1e6\n{keys}\n[[pair]]\nmaterials = [\"a\", \"a\"]\n{pair}\n\
             [[particle]]\nat = [0, 0]\nradius = 0.01\nmaterial = \"a\"\n"
        );
        fs::write(folder.path().join("p.toml"), text).expect("it can be written");
        let output = ballast(folder.path(), &["check", "p.toml"]);
        assert_eq!(output.status.code(), Some(0), "{}", said(&output));
        let text = String::from_utf8(output.stdout).expect("it is text");
        text.split_whitespace().collect::<Vec<_>>().join(" ")
    };
    let useless = "does nothing";
    for (law, keys, pair, expected) in [
        (
            "hertz",
            "friction = 0.5",
            "restitution = 0.5",
            "friction of a does nothing",
        ),
        (
            "hertz",
            "",
            "friction = 0.5",
            "friction of the pair a, a does nothing",
        ),
        (
            "hertz",
            "",
            "normal_stiffness = 1e6",
            "normal_stiffness of the pair a, a does nothing",
        ),
        (
            "linear",
            "friction = 0.5\nshear_stiffness = 0",
            "restitution = 0.5",
            "friction of a does nothing",
        ),
    ] {
        let text = scene(law, keys, pair);
        assert!(text.contains(expected), "{expected} in {text}");
    }
    for (law, keys, pair) in [
        ("hertz", "", "restitution = 0.5"),
        ("hertz-mindlin", "friction = 0.5", "friction = 0.4"),
        (
            "linear",
            "friction = 0.5\nshear_stiffness = 1e6",
            "normal_stiffness = 1e6",
        ),
    ] {
        let text = scene(law, keys, pair);
        assert!(!text.contains(useless), "{text}");
    }
}
