//! `[about]`: what a preset is for, in words.

use super::draft::Draft;
use super::key::{Absent, Bounds, Form, Key};
use super::reader::Reader;
use super::section::{Section, Shape};
use crate::language::{Command, Definitions};

/// What a preset says about itself.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct About {
    /// Title.
    pub title: String,
    /// What it shows, one line.
    pub shows: String,
    /// What to watch.
    pub look: String,
    /// Commands worth trying.
    pub try_: Vec<String>,
    /// Where the experiment comes from.
    pub source: String,
    /// Whether the tests run it to its end.
    pub quick: bool,
    /// Cycles per second at which the workbench starts it; `None`: as many as possible.
    pub pace: Option<f64>,
}

impl About {
    /// Of a preset that is known to be good, without making its scene: that may hold a million particles.
    pub fn of(text: &str) -> Self {
        let table: toml::Table = text.parse().unwrap_or_default();
        let about = table.get("about").and_then(toml::Value::as_table);
        let value = |name: &str| about.and_then(|about| about.get(name));
        let text = |name| {
            value(name)
                .and_then(toml::Value::as_str)
                .unwrap_or_default()
                .to_owned()
        };
        let commands = value("try").and_then(toml::Value::as_array);
        let commands = commands
            .into_iter()
            .flatten()
            .filter_map(toml::Value::as_str);
        Self {
            title: text("title"),
            shows: text("shows"),
            look: text("look"),
            try_: commands.map(str::to_owned).collect(),
            source: text("source"),
            quick: value("quick")
                .and_then(toml::Value::as_bool)
                .unwrap_or_default(),
            pace: value("pace")
                .and_then(|pace| pace.as_float().or_else(|| Some(pace.as_integer()? as f64))),
        }
    }
}

/// The declaration.
pub(crate) const SECTION: Section = Section {
    name: "about",
    shape: Shape::Single,
    required: false,
    summary: "what the preset is for, in words",
    keys: KEYS,
    read,
};

const KEYS: &[Key] = &[
    text("title", "title in lists"),
    text("shows", "one line on what it shows"),
    text("look", "what to watch while it runs"),
    Key {
        form: Form::Texts,
        ..text("try", "list of console commands worth trying")
    },
    text("source", "publication the experiment comes from"),
    Key {
        form: Form::Flag,
        absent: Absent::Flag(false),
        ..text("quick", "mark of presets that the tests run to their end")
    },
    Key {
        form: Form::Number(Bounds::POSITIVE),
        unit: "1/s",
        absent: Absent::Said("as many as possible"),
        ..text(
            "pace",
            "cycles per second at which the workbench shows it at first",
        )
    },
];

const fn text(name: &'static str, summary: &'static str) -> Key {
    Key {
        name,
        form: Form::Text,
        unit: "-",
        absent: Absent::Said("empty"),
        summary,
    }
}

fn read<'a>(reader: &Reader<'a>, draft: &mut Draft<'a>) {
    let text = |name| {
        reader
            .text(name)
            .map_or_else(String::new, |(text, _)| text.into())
    };
    draft.about = About {
        title: text("title"),
        shows: text("shows"),
        look: text("look"),
        try_: commands(reader, "try", &draft.known.definitions),
        source: text("source"),
        quick: reader.flag("quick").unwrap_or_default(),
        pace: reader.number("pace"),
    };
}

/// Commands a reader may type later: they must be commands, but may name what is not there yet.
fn commands(reader: &Reader<'_>, name: &str, definitions: &Definitions) -> Vec<String> {
    let texts = reader.texts(name).unwrap_or_default();
    for (text, place) in &texts {
        let parsed = Command::parse_with(text, definitions);
        super::phrase::accept(reader.report, parsed, text, *place);
    }
    texts.into_iter().map(|(text, _)| text.to_owned()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Scene;
    use crate::scene::catalogue::PRESETS;

    #[test]
    fn what_is_skimmed_is_what_is_read() {
        for preset in PRESETS {
            let scene = Scene::parse(preset.name, preset.text, &[]).expect(preset.name);
            assert_eq!(About::of(preset.text), scene.about, "{}", preset.name);
        }
    }
}
