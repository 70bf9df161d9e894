//! `ballast check`: what a preset models, what it costs, and how its time step stands.

mod generated;
mod modelled;
mod order;
mod sizes;
mod start;
mod trial;
mod unused;

use std::fmt::{self, Write};

use super::output::{load, print, unopened};
use super::{BAD_INPUT, Check};
use crate::engine::World;
use crate::engine::setup::TimeStepChoice;
use crate::scene::Scene;
use crate::session::figure::figure;
use crate::session::{Options, Session};
use crate::study::trial::Trial;
use crate::tui::write::wrapped;

/// Checks it; answers the exit status.
pub(super) fn check(options: &Check) -> u8 {
    let Some(scene) = load(&options.preset, &options.set) else {
        return BAD_INPUT;
    };
    let mut report = Report::default();
    let title = &scene.about.title;
    let colon = if title.is_empty() { "" } else { ": " };
    report.text = format!("{}{colon}{title}\n", scene.name);
    match start::describe(&mut report, &scene) {
        Err(status) => return status,
        Ok(false) => {
            written(&mut report, &scene, &options.preset);
            return print(&report.finish());
        }
        Ok(true) => {}
    }
    let session = match Session::open(scene, Options::default()) {
        Ok(session) => session,
        Err(error) => return unopened(&error),
    };
    // As it was completed by its sample; the particles themselves stand in the world only.
    let scene = session.scene().clone();
    let world = session.world();
    modelled::describe(&mut report, &scene, world);
    generated::describe(&mut report, &scene);
    sizes::describe(&mut report, &scene, world);
    order::describe(&mut report, world);
    step(&mut report, world);
    unused::warn(&mut report, world);
    let trial = Trial::of(session);
    trial::describe(&mut report, &scene, &trial);
    written(&mut report, &scene, &options.preset);
    print(&report.finish())
}

/// Usual width of a terminal [columns].
const WIDTH: usize = 80;

/// Columns that labels take.
const INDENT: usize = 15;

/// Lines with a label each, and what there is to worry about.
#[derive(Default)]
struct Report {
    text: String,
    warnings: Vec<String>,
}

impl Report {
    fn line(&mut self, label: &str, text: impl fmt::Display) {
        self.lines(label, &[text.to_string()]);
    }

    /// Texts below each other, none wider than a terminal.
    fn lines(&mut self, label: &str, texts: &[String]) {
        let mut label = format!("{label}:");
        for line in texts.iter().flat_map(|text| wrapped(text, WIDTH - INDENT)) {
            // A String takes every line.
            let _ = writeln!(self.text, "{label:INDENT$}{line}");
            label.clear();
        }
    }

    fn finish(mut self) -> String {
        for warning in std::mem::take(&mut self.warnings) {
            self.line("warning", warning);
        }
        self.text
    }
}

fn step(report: &mut Report, world: &World) {
    let model = world.model();
    let base = figure(world.base_step());
    let of = match model.time_step {
        TimeStepChoice::Rayleigh => format!("of the Rayleigh step {base} s"),
        TimeStepChoice::RayleighExact => format!("of the exact Rayleigh step {base} s"),
        TimeStepChoice::Critical => format!("of the critical step 2 sqrt(m/k) = {base} s"),
        TimeStepChoice::Seconds(_) => format!("of the given {base} s"),
    };
    let (dt, frac) = (figure(world.dt()), figure(world.frac()));
    if let Some(share) = model.frac_auto {
        let share = figure(share);
        let text = format!(
            "dt = {dt} s at first, frac = {frac} {of}: it follows {share} of the stability bound"
        );
        return report.line("time step", text);
    }
    let text = match model.time_step {
        TimeStepChoice::Seconds(_) if model.frac == 1.0 => format!("dt = {dt} s as given"),
        _ => format!("dt = {dt} s, frac = {frac} {of}"),
    };
    report.line("time step", text);
}

/// What a run leaves behind.
fn written(report: &mut Report, scene: &Scene, preset: &str) {
    let (columns, every) = (scene.history.columns.len(), scene.history.every);
    let mut text = match every {
        1 => format!("{columns} columns, a row every cycle"),
        _ => format!("{columns} columns, a row every {every} cycles"),
    };
    let cycles: Option<u64> = scene.stages.iter().map(|stage| stage.max_cycles).sum();
    if let Some(cycles) = cycles.filter(|&cycles| cycles > 0) {
        // The first row, and one at the end of each stage.
        let rows = cycles / every + 1 + scene.stages.len() as u64;
        let bytes = rows as f64 * (CELL * (columns as f64 + 2.0));
        let _ = write!(text, ", {rows} rows at most, about {}", size(bytes));
    }
    report.line("history", text);
    report.line(
        "files",
        format!(
            "--csv {name}.csv writes that, {name}.journal and {name}.ballast; without it nothing \
             but after a signal or failure",
            name = scene.name
        ),
    );
    if let Some(dump) = &scene.dump {
        let names = dump
            .what
            .iter()
            .map(|of| format!("{}.{of}.CYCLE.{}", scene.name, dump.format.ending()));
        let names: Vec<String> = names.collect();
        let text = format!("{} every {} cycles", names.join(" and "), dump.every);
        report.line("dumps", text);
    }
    let expects = match scene.expects.len() {
        0 => "none".to_owned(),
        number => format!("{number}; test them with ballast verify {preset}"),
    };
    report.line("expectations", expects);
    if scene.stages.is_empty() {
        let warning = "no [[stage]]: ballast run needs --cycles N".to_owned();
        report.warnings.push(warning);
    }
}

/// Usual length of a cell with its comma [bytes].
const CELL: f64 = 18.0;

/// A number of bytes as people say it.
fn size(bytes: f64) -> String {
    let mut value = bytes;
    for unit in ["B", "KiB", "MiB", "GiB"] {
        if value < 1024.0 {
            return if unit == "B" {
                format!("{value:.0} B")
            } else {
                format!("{value:.1} {unit}")
            };
        }
        value /= 1024.0;
    }
    format!("{value:.1} TiB")
}

/// A duration as people say it.
pub(super) fn duration(seconds: f64) -> String {
    match seconds {
        s if s < 1.0 => "less than a second".into(),
        s if s < 120.0 => format!("{s:.0} s"),
        s if s < 7200.0 => format!("{:.0} min", s / 60.0),
        s if s < 172_800.0 => format!("{:.0} h", s / 3600.0),
        s => format!("{:.0} days", s / 86_400.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_and_durations_are_said_as_people_say_them() {
        assert_eq!(size(0.0), "0 B");
        assert_eq!(size(1536.0), "1.5 KiB");
        assert_eq!(size(3.0 * 1024.0 * 1024.0), "3.0 MiB");
        assert_eq!(duration(0.3), "less than a second");
        assert_eq!(duration(90.0), "90 s");
        assert_eq!(duration(7200.0), "2 h");
        assert_eq!(duration(864_000.0), "10 days");
    }
}
