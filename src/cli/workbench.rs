//! `ballast [PRESET]`: the workbench.

use super::output::{complain, load, tell};
use super::{BAD_INPUT, FAILED, Workbench};
use crate::scene::catalogue::PRESETS;
use crate::tui::workbench::{Start, run};
use crate::tui::{plain, terminal};

/// Opens it; answers the exit status.
pub(super) fn open(options: &Workbench) -> u8 {
    let first = PRESETS.first().map_or("", |preset| preset.name);
    let name = options.preset.as_deref().unwrap_or(first);
    let dumb = std::env::var("TERM").is_ok_and(|term| term == "dumb");
    let plain = options.plain || (dumb && terminal::is_there());
    if !plain && !terminal::is_there() {
        complain(&format!(
            "the workbench needs a terminal; run without one with\n  ballast run {name}\nor talk \
             to it line by line with\n  ballast {name} --plain"
        ));
        return BAD_INPUT;
    }
    let Some(scene) = load(name, &options.set) else {
        return BAD_INPUT;
    };
    let threads = usize::from(options.threads);
    if plain {
        let (mut input, mut output) = (std::io::stdin().lock(), std::io::stdout().lock());
        return plain::talk(scene, threads, &mut input, &mut output).unwrap_or_else(|error| {
            complain(&error.to_string());
            FAILED
        });
    }
    let start = Start {
        paused: options.paused,
        fps: options.fps,
        kbps: options.kbps,
        pace: options.pace,
        threads,
        panic_at: options.panic_at,
    };
    match run(scene, &start) {
        Ok(ended) => {
            tell(&ended.farewell);
            ended.status
        }
        Err(error) => {
            complain(&error.to_string());
            FAILED
        }
    }
}
