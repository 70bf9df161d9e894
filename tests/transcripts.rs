//! What the console answers, word for word: the transcripts in data/transcripts.
//!
//! A transcript is a preset, then lines `> command`, each with the lines of its reply below. A line
//! `preset NAME` names an embedded preset; otherwise everything before the first command is one.
//! `...` stands for any number of lines, `{tmp}` for a folder that the test makes, and lines that
//! start with `#` between the parts are comments. Cycles that a command asks for are run, and what
//! the session has to say about them follows the reply. A refused command is answered with `! ` and
//! the reason, and must have changed nothing. `UPDATE=1 cargo test` writes the replies anew, except
//! where they hold `...`.
#![expect(
    clippy::unwrap_used,
    reason = "a test that cannot go on has failed; its panic says where"
)]

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use ballast::language::{COMMANDS, Command};
use ballast::scene::Scene;
use ballast::session::{Budget, Options, Request, Session};

/// One command and what is expected below it.
struct Exchange {
    /// Comments above it.
    comments: Vec<String>,
    line: String,
    reply: Vec<String>,
}

struct Transcript {
    preset: String,
    exchanges: Vec<Exchange>,
}

impl Transcript {
    fn parse(text: &str) -> Self {
        let mut transcript = Self {
            preset: String::new(),
            exchanges: Vec::new(),
        };
        let mut comments = Vec::new();
        for line in text.lines() {
            if let Some(command) = line.strip_prefix("> ") {
                transcript.exchanges.push(Exchange {
                    comments: std::mem::take(&mut comments),
                    line: command.to_owned(),
                    reply: Vec::new(),
                });
            } else if let Some(last) = transcript.exchanges.last_mut() {
                if line.starts_with('#') {
                    comments.push(line.to_owned());
                } else {
                    last.reply.push(line.to_owned());
                }
            } else {
                transcript.preset += line;
                transcript.preset += "\n";
            }
        }
        transcript
    }

    fn text(&self) -> String {
        let mut text = self.preset.clone();
        for exchange in &self.exchanges {
            let lines = exchange.comments.iter().cloned();
            let command = std::iter::once(format!("> {}", exchange.line));
            for line in lines.chain(command).chain(exchange.reply.iter().cloned()) {
                text += &line;
                text += "\n";
            }
        }
        text
    }

    fn open(&self) -> Session {
        let named = self
            .preset
            .lines()
            .find_map(|line| line.strip_prefix("preset "));
        let scene = match named {
            Some(name) => Scene::load(name.trim(), &[]),
            None => Scene::parse("transcript", &self.preset, &[]),
        };
        Session::open(scene.expect("the preset is sound"), Options::default()).unwrap()
    }
}

fn answer(session: &mut Session, line: &str) -> Vec<String> {
    let before = session.world().state_hash();
    let events = session.journal().events.len();
    let reply = match session.type_line(line) {
        Ok(reply) => reply,
        Err(refusal) => {
            assert_eq!(before, session.world().state_hash(), "{line}");
            assert_eq!(events, session.journal().events.len(), "{line}");
            return vec![format!("! {refusal}")];
        }
    };
    let mut lines = reply.lines;
    if reply.request == Some(Request::Run) {
        let from = session.world().cycle_number();
        if let Err(error) = session.advance(Budget::default(), false) {
            lines.push(format!("! {error}"));
        }
        lines.extend(session.take_notices());
        let to = session.world().cycle_number();
        lines.push(format!("[cycles {from} to {to}]"));
    } else if let Some(request) = reply.request {
        lines.push(format!("[{request:?}]"));
    }
    lines.extend(session.take_notices());
    lines
}

/// Whether the lines are those expected, `...` standing for any number.
fn fits(expected: &[String], lines: &[String]) -> bool {
    match expected {
        [] => lines.is_empty(),
        [dots, rest @ ..] if dots == "..." => {
            (0..=lines.len()).any(|skipped| fits(rest, &lines[skipped..]))
        }
        [first, rest @ ..] => lines.first() == Some(first) && fits(rest, &lines[1..]),
    }
}

fn play(path: &Path, update: bool) -> Vec<Command> {
    let text = fs::read_to_string(path).unwrap();
    let mut transcript = Transcript::parse(&text);
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path().display().to_string();
    fs::write(
        folder.path().join("lines.txt"),
        "# sourced by a transcript\nfriction 0.25\n\ncycle 2\nprint step\n",
    )
    .unwrap();
    fs::write(
        folder.path().join("wrong.txt"),
        "friction 0.9\nfrictoin 1\n",
    )
    .unwrap();
    fs::write(
        folder.path().join("itself.txt"),
        format!("zero\nsource {place}/itself.txt\n"),
    )
    .unwrap();
    let mut session = transcript.open();
    let mut done = Vec::new();
    for exchange in &mut transcript.exchanges {
        let line = exchange.line.replace("{tmp}", &place);
        let lines: Vec<String> = answer(&mut session, &line)
            .iter()
            .map(|line| line.replace(&place, "{tmp}"))
            .collect();
        let fit = fits(&exchange.reply, &lines);
        if update && !fit {
            exchange.reply = lines;
        } else {
            assert!(
                fit,
                "{}: > {}\nexpected:\n{}\nanswered:\n{}\n",
                path.display(),
                exchange.line,
                exchange.reply.join("\n"),
                lines.join("\n")
            );
        }
        done.extend(Command::parse(&line));
    }
    if update {
        fs::write(path, transcript.text()).unwrap();
    }
    done
}

#[test]
fn transcripts_are_answered_word_for_word() {
    let update = std::env::var_os("UPDATE").is_some();
    let mut paths: Vec<_> = fs::read_dir("data/transcripts")
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .collect();
    paths.sort();
    let mut verbs = BTreeSet::new();
    for path in &paths {
        verbs.extend(play(path, update).iter().map(|c| c.card().name));
    }
    for card in COMMANDS {
        assert!(
            verbs.contains(card.name),
            "no transcript holds `{}`",
            card.name
        );
    }
}

#[test]
fn dots_stand_for_any_number_of_lines() {
    let lines = |text: &str| {
        text.split_whitespace()
            .map(str::to_owned)
            .collect::<Vec<_>>()
    };
    for expected in [
        "a b c",
        "... c",
        "a ...",
        "...",
        "a ... b ... c",
        "... b ...",
    ] {
        assert!(fits(&lines(expected), &lines("a b c")), "{expected}");
    }
    for expected in ["a b", "... b", "b ...", "", "a b c d", "a ... c c"] {
        assert!(!fits(&lines(expected), &lines("a b c")), "{expected}");
    }
}

#[test]
fn a_transcript_survives_being_rewritten() {
    let text = "[model]\n\n> zero\nreply\n\n# why\n> go\n";
    assert_eq!(Transcript::parse(text).text(), text);
}
