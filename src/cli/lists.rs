//! What there is: presets, laws, columns, commands, keys. All from the lists in the code.

use std::fmt::Write;

use super::output::{complain, print};
use crate::engine::contact::laws::LAWS;
use crate::language::COMMANDS;
use crate::measure::columns::{MARKS, assembly, listing, nearest};
use crate::scene::catalogue::{self, PRESETS};
use crate::scene::{About, reference_text};
use crate::session::figure::per_cent;

/// Names and titles of the embedded presets.
pub(super) fn presets() -> u8 {
    let width = PRESETS
        .iter()
        .map(|preset| preset.name.len())
        .max()
        .unwrap_or(0);
    let mut text = String::new();
    for preset in PRESETS {
        let title = About::of(preset.text).title;
        let _ = writeln!(text, "{:width$}  {title}", preset.name);
    }
    print(&text)
}

/// The text of an embedded preset.
pub(super) fn show(name: &str) -> u8 {
    if let Some(preset) = catalogue::find(name) {
        return print(preset.text);
    }
    let near = nearest(name, PRESETS.iter().map(|preset| preset.name));
    complain(&format!(
        "there is no embedded preset {name}; {near}; `ballast presets` lists them"
    ));
    super::BAD_INPUT
}

/// Contact laws with their parameters.
pub(super) fn laws() -> u8 {
    let mut text = String::new();
    for law in LAWS {
        let _ = writeln!(text, "{}: {}", law.name, law.summary);
        for parameter in law.parameters {
            let unit = format!("[{}]", parameter.unit);
            let _ = writeln!(
                text,
                "    {:18} {unit:6} {}",
                parameter.key, parameter.summary
            );
        }
        let [without, with] = law.memory;
        let _ = writeln!(
            text,
            "    memory per contact: {without} bytes, with friction {with}"
        );
        let gain = match law.gain {
            None => "no closed cycle gains energy".to_owned(),
            Some(gain) => format!(
                "a closed cycle can gain energy: at worst found {} of what a full slide there and back loses",
                per_cent(gain)
            ),
        };
        let _ = writeln!(text, "    {gain}");
        let _ = writeln!(text, "    {}", law.source);
    }
    text.push_str(
        "unloading = \"keep\" lets hertz-mindlin gain energy: loaded at a large contact, unloaded at a small one\n\
         normal = \"incremental\" gains none, it loses: an elastic Hertz impact rebounds with 0.9746 at 35 steps\n",
    );
    print(&text)
}

/// History columns with their units.
pub(super) fn columns() -> u8 {
    let mut text = String::new();
    // Those that have no other name stand in the listing already.
    let of_regions = assembly().filter(|row| row.is_regional());
    let of_regions = of_regions.map(|row| ("region:NAME:", &row.card));
    let rows: Vec<[String; 3]> = listing()
        .into_iter()
        .chain(of_regions)
        .map(|(prefix, card)| {
            let name = format!("{prefix}{}", card.name);
            let unit = format!("[{}]", card.unit);
            [name, unit, format!("{:1} {}", card.marks(), card.summary)]
        })
        .collect();
    let width = |k: usize| rows.iter().map(|row| row[k].len()).max().unwrap_or(0);
    let (names, units) = (width(0), width(1));
    for [name, unit, summary] in &rows {
        let _ = writeln!(text, "{name:names$}  {unit:units$}  {summary}");
    }
    for mark in MARKS {
        let _ = writeln!(text, "{mark}");
    }
    text.push_str("particle:I-J:x and so on are means over the particles I to J\n");
    print(&text)
}

/// Console commands, or the page of one.
pub(super) fn commands(name: Option<&str>) -> u8 {
    let Some(name) = name else {
        let rows = COMMANDS
            .iter()
            .map(|card| format!("{}\n    {}\n", card.usage, card.summary));
        return print(&rows.collect::<String>());
    };
    match crate::language::list::find(name, 0..name.len()) {
        Ok(card) => print(&card.page()),
        Err(mistake) => {
            complain(&format!("{}; {}", mistake.message, mistake.remedy));
            super::BAD_INPUT
        }
    }
}

/// Keys of a preset.
pub(super) fn keys() -> u8 {
    print(&reference_text())
}
