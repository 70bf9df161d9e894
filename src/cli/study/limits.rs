//! `ballast study --stability`: the largest stable FRAC.

use super::progress::Progress;
use super::refused;
use crate::cli::Study;
use crate::cli::aligned::aligned;
use crate::cli::output::{print, tell};
use crate::record::interrupt::Interrupt;
use crate::scene::Scene;
use crate::session::figure::figure;
use crate::study::limits::{Limit, limits as search};

/// Finds and prints them; answers the exit status.
pub(super) fn limits(options: &Study, scene: &Scene, interrupt: &Interrupt) -> u8 {
    let mut progress = Progress::new(options.quiet);
    let found = search(scene, usize::from(options.threads), &mut |beat| {
        progress.show(&beat);
        interrupt.caught().is_none()
    });
    progress.clear();
    let found = match found {
        Ok(found) => found,
        Err(why) => return refused(&why),
    };
    let printed = print(&table(scene, &found));
    match interrupt.caught() {
        Some(signal) => {
            tell(&format!("{}: the search is not finished", signal.name));
            signal.exit_status()
        }
        None => printed,
    }
}

fn table(scene: &Scene, found: &[Limit]) -> String {
    let head = [
        "",
        "stable",
        "unstable",
        "frac limit",
        "runs",
        "what happens",
    ];
    let mut rows = vec![head.map(str::to_owned).to_vec()];
    rows.extend(found.iter().map(|limit| {
        let stable = match limit.stable {
            0.0 => "-".to_owned(),
            frac => figure(frac),
        };
        vec![
            limit.series.name(),
            stable,
            limit.unstable.map_or("-".to_owned(), figure),
            figure(limit.frac_limit),
            limit.runs.to_string(),
            limit.reason.clone(),
        ]
    }));
    let mut text = format!(
        "{}: largest FRAC with which the run neither faults nor gains energy, smallest with which it \
         does,\nand the smallest stability bound of its contacts\n",
        scene.name
    );
    for line in aligned(&rows, 1, 5) {
        text.push_str(&line);
        text.push('\n');
    }
    text
}
