//! Rules for one Rust file.

use crate::text::{code_only, find, names_after};

/// Each module with the modules it may use. One way only: what is below never knows what is above.
const LAYERS: [(&str, &str); 11] = [
    ("engine", ""),
    ("measure", "engine"),
    ("control", "measure engine"),
    ("language", "control measure engine"),
    ("scene", "language control measure engine"),
    ("record", "language control measure engine"),
    ("session", "scene record language control measure engine"),
    (
        "study",
        "session scene record language control measure engine",
    ),
    (
        "tui",
        "session scene record language control measure engine",
    ),
    (
        "cli",
        "tui study session scene record language control measure engine",
    ),
    ("main", "cli"),
];

/// Files and folders that may hold unsafe code, each added here by hand: the loops over contacts and
/// particles with what they stand on, the team of threads, and the allocator of the program.
const UNSAFE_FILES: &[&str] = &[
    "src/cli/large_pages.rs",
    "src/engine/lanes/",
    "src/engine/contact/columns.rs",
    "src/engine/contact/diagram/lanes",
    "src/engine/contact/exact.rs",
    "src/engine/contact/kernel.rs",
    "src/engine/contact/memories.rs",
    "src/engine/contact/numbers.rs",
    "src/engine/contact/pass.rs",
    "src/engine/motion/",
    "src/engine/threads/",
    "tests/allocations.rs",
];

/// Methods of std's floats that another platform rounds otherwise, or (`mul_add`) runs far slower.
const PLATFORM_MATHS: &str = "sin cos tan asin acos atan atan2 sin_cos sinh cosh tanh asinh acosh \
                              atanh exp exp2 exp_m1 ln ln_1p log log2 log10 powf powi cbrt hypot \
                              mul_add";

/// Modules whose results enter a simulation.
const EXACT: [&str; 4] = ["engine", "measure", "control", "scene"];

/// Parts of std that engine and measure have no business with.
const OUTSIDE_WORLD: [&str; 6] = ["fs", "io", "time", "env", "net", "process"];

/// Longest file that needs no excuse [lines].
const LONGEST: usize = 500;

/// What all rules say about a file.
pub(crate) fn all(path: &str, text: &str) -> Vec<String> {
    let code = code_only(text);
    [
        dependencies(path, &code),
        file_size(path, text),
        soundness(path, text),
        unfinished(path, &code),
        platform_maths(path, &code),
        outside_world(path, &code),
    ]
    .concat()
}

/// `engine` for `src/engine/setup.rs`, `cli` for `src/cli.rs`; nothing outside `src`.
fn module_of(path: &str) -> Option<&str> {
    let inside = path.strip_prefix("src/")?;
    Some(inside.split(['/', '.']).next().unwrap_or(inside))
}

fn dependencies(path: &str, code: &str) -> Vec<String> {
    let Some(module) = module_of(path).filter(|module| *module != "lib") else {
        return Vec::new();
    };
    let layer = LAYERS.iter().find(|(name, _)| *name == module);
    let Some((_, allowed)) = layer else {
        return vec![format!(
            "{path}: module `{module}` has no place in the LAYERS of tests/tidy/code_rules.rs"
        )];
    };
    // As many steps as lead from this file's module to the root of the crate.
    let own_step = usize::from(!path.ends_with("/mod.rs"));
    let to_root = "super::".repeat(path.matches('/').count() - 1 + own_step);
    let roots = ["crate::", "ballast::", to_root.as_str()];
    let used = roots.iter().flat_map(|root| names_after(code, root));
    used.filter(|(_, name)| {
        LAYERS.iter().any(|(module, _)| module == name)
            && name != module
            && !allowed.split(' ').any(|allowed| allowed == name)
    })
    .map(|(line, name)| {
        format!(
            "{path}:{line}: `{module}` must not use `{name}`: dependencies point one way, so that \
             lower parts can be understood and tested without upper ones"
        )
    })
    .collect()
}

fn file_size(path: &str, text: &str) -> Vec<String> {
    let lines = text.lines().count();
    let mut start = text.lines().take(5);
    if lines <= LONGEST || start.any(|line| line.contains("// Long because:")) {
        return Vec::new();
    }
    vec![format!(
        "{path}: {lines} lines: a file is read in one sitting; split it, or say \
         `// Long because: ...` in its first five lines"
    )]
}

fn soundness(path: &str, text: &str) -> Vec<String> {
    let code = code_only(text);
    let lines: Vec<&str> = text.lines().collect();
    let found = find(&code, &["unsafe", "unsafe_code"]).into_iter();
    found
        .filter_map(|(line, word)| {
            if !UNSAFE_FILES.iter().any(|place| path.starts_with(place)) {
                return Some(format!(
                    "{path}:{line}: `{word}`: unsafe code lives in {UNSAFE_FILES:?} only, where \
                     reviewers look for it"
                ));
            }
            // What a function demands stands where it is declared first, in its trait.
            let declares = lines[line - 1].contains("unsafe fn");
            let once = text.contains("SAFETY of all blocks");
            let argued = word != "unsafe" || declares || once || is_argued(&lines[..line]);
            (!argued).then(|| {
                format!("{path}:{line}: say in a `SAFETY:` comment right above why this is sound")
            })
        })
        .collect()
}

/// Whether the paragraph that these lines end with says why it is safe.
fn is_argued(lines: &[&str]) -> bool {
    let paragraph = lines
        .iter()
        .rev()
        .take_while(|line| !line.trim().is_empty());
    paragraph
        .take(12)
        .any(|line| line.contains("SAFETY:") || line.contains("# Safety"))
}

fn unfinished(path: &str, code: &str) -> Vec<String> {
    let words = [
        "todo!",
        "unimplemented!",
        "dbg!",
        "#[ignore",
        "#[should_panic",
    ];
    let found = find(code, &words).into_iter();
    found
        .map(|(line, word)| {
            format!(
                "{path}:{line}: `{word}`: nothing unfinished lands, and every test runs and says \
                 what it expects"
            )
        })
        .collect()
}

fn platform_maths(path: &str, code: &str) -> Vec<String> {
    if !module_of(path).is_some_and(|module| EXACT.contains(&module)) {
        return Vec::new();
    }
    let names = PLATFORM_MATHS.split_whitespace();
    let calls: Vec<String> = names
        .flat_map(|name| [format!(".{name}("), format!("f64::{name}")])
        .collect();
    let found = find(code, &calls).into_iter();
    found
        .map(|(line, call)| {
            format!(
                "{path}:{line}: `{call}` gives other bits or another speed on another platform; \
                 use the crate libm, or products and sqrt"
            )
        })
        .collect()
}

fn outside_world(path: &str, code: &str) -> Vec<String> {
    if !matches!(module_of(path), Some("engine" | "measure")) {
        return Vec::new();
    }
    let parts = names_after(code, "std::").into_iter();
    let parts = parts.filter(|(_, part)| OUTSIDE_WORLD.contains(&part.as_str()));
    let prints = find(code, &["println!", "print!", "eprintln!", "eprint!"]);
    let prints = prints.into_iter().map(|(line, word)| (line, word.into()));
    parts
        .chain(prints)
        .map(|(line, what): (usize, String)| {
            format!(
                "{path}:{line}: `{what}`: engine and measure know no file, clock or screen, so \
                 that a world is the same wherever it runs"
            )
        })
        .collect()
}

/// Asserts that each example draws one complaint and each counterexample none.
#[track_caller]
fn bites(rule: fn(&str, &str) -> Vec<String>, bad: &[(&str, &str)], good: &[(&str, &str)]) {
    for (path, text) in bad {
        let complaints = rule(path, text);
        assert_eq!(complaints.len(), 1, "{path}: {text}: {complaints:?}");
        assert!(complaints[0].starts_with(path), "{complaints:?}");
    }
    for (path, text) in good {
        assert_eq!(rule(path, text), [""; 0], "{path}: {text}");
    }
}

#[test]
fn dependencies_bite() {
    bites(
        dependencies,
        &[
            ("src/engine/step.rs", "use crate::measure::Frame;"),
            ("src/engine/contact/mod.rs", "use super::super::scene::A;"),
            ("src/measure/mod.rs", "fn f() { super::session::go() }"),
            (
                "src/record/x.rs",
                "use crate::{engine::A, session::{B, C}};",
            ),
            ("src/main.rs", "ballast::session::go();"),
            ("src/novel/mod.rs", ""),
        ],
        &[
            ("src/measure/mod.rs", "use crate::engine::World;"),
            (
                "src/engine/step.rs",
                "use super::plan; use crate::engine::A;",
            ),
            ("src/engine/contact/law.rs", "use super::super::scene::A;"),
            ("src/main.rs", "ballast::cli::main()"),
            ("src/lib.rs", "pub use crate::session::A;"),
            ("tests/laws.rs", "use ballast::session::A;"),
        ],
    );
}

#[test]
fn layers_point_one_way() {
    for (k, (_, allowed)) in LAYERS.iter().enumerate() {
        for name in allowed.split_whitespace() {
            let below = LAYERS[..k].iter().any(|(module, _)| *module == name);
            assert!(below, "{name} must be listed before its users");
        }
    }
}

#[test]
fn file_size_bites() {
    let long = "x\n".repeat(LONGEST + 1);
    let excused = format!("//! List.\n// Long because: it is one list.\n{long}");
    let late = format!("{long}// Long because: no.\n");
    let path = "src/engine/step.rs";
    bites(
        file_size,
        &[(path, &long), (path, &late)],
        &[(path, &excused), (path, &long[2..])],
    );
}

#[test]
fn soundness_bites() {
    let threads = "src/engine/threads/mod.rs";
    bites(
        soundness,
        &[
            ("src/engine/step.rs", "// SAFETY: none\nunsafe { f() }"),
            ("src/engine/step.rs", "#![allow(unsafe_code)]"),
            (threads, "let x = unsafe { f() };"),
            (threads, "// SAFETY: of another\n\nunsafe { f() }"),
        ],
        &[
            (
                threads,
                "// SAFETY: ranges are disjoint\nlet x =\n    unsafe { f() };",
            ),
            (threads, "#![allow(unsafe_code, reason = \"\")]"),
            (
                "src/engine/step.rs",
                "// no unsafe here\nlet x = \"unsafe\";",
            ),
        ],
    );
    assert!(
        UNSAFE_FILES.len() <= 12,
        "twelve are already a lot to review"
    );
}

#[test]
fn unfinished_bites() {
    let by_code = |path: &str, text: &str| unfinished(path, &code_only(text));
    let path = "tests/laws.rs";
    bites(
        by_code,
        &[
            (path, "fn f() { todo!() }"),
            (path, "unimplemented!(\"later\")"),
            (path, "dbg!(x)"),
            (path, "#[ignore = \"slow\"]"),
            (path, "#[should_panic(expected = \"x\")]"),
        ],
        &[(path, "// todo!\nlet x = \"dbg!(x)\"; todo();")],
    );
}

#[test]
fn platform_maths_bites() {
    bites(
        platform_maths,
        &[
            ("src/engine/motion.rs", "let y = x.sin();"),
            ("src/measure/rose.rs", "let y = x.powf(1.5);"),
            ("src/measure/rose.rs", "let y = x.powi(2);"),
            ("src/scene/build.rs", "let y = a.atan2(b);"),
            ("src/engine/motion.rs", "let y = x.mul_add(a, b);"),
            ("src/engine/motion.rs", "xs.map(f64::exp)"),
        ],
        &[
            ("src/engine/motion.rs", "let y = libm::sin(x) + x.sqrt();"),
            ("src/engine/motion.rs", "x.sinus(); f64::expected(x)"),
            ("src/tui/rose.rs", "let y = x.sin();"),
        ],
    );
}

#[test]
fn outside_world_bites() {
    bites(
        outside_world,
        &[
            ("src/engine/step.rs", "use std::time::Instant;"),
            ("src/engine/step.rs", "use std::{mem, io::Write};"),
            ("src/measure/frame.rs", "std::fs::read(path)"),
            ("src/measure/frame.rs", "println!(\"x\")"),
            ("src/measure/frame.rs", "eprintln!(\"x\")"),
        ],
        &[
            ("src/engine/step.rs", "use std::{mem, thread};"),
            ("src/session/step.rs", "use std::time::Instant;"),
        ],
    );
}
