//! The README's tables and its picture are made from the code and from data; `UPDATE=1 cargo test --test readme`
//! writes them anew.
#![expect(
    clippy::unwrap_used,
    reason = "a test that cannot go on has failed; its panic says where"
)]

use std::fmt::Write;

use ballast::engine::contact::laws::LAWS;
use ballast::measure::columns::{MARKS, listing};
use ballast::scene::catalogue::PRESETS;
use ballast::scene::{About, Scene};

const README: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/README.md");

fn laws() -> String {
    let mut text = String::from("| law | what it is | keys | source |\n|---|---|---|---|\n");
    for law in LAWS {
        let keys: Vec<String> = law
            .parameters
            .iter()
            .map(|p| format!("`{}` [{}]", p.key, p.unit))
            .collect();
        let _ = writeln!(
            text,
            "| `{}` | {} | {} | {} |",
            law.name,
            law.summary,
            keys.join(", "),
            law.source
        );
    }
    text
}

fn presets() -> String {
    let mut text = String::from("| preset | what it shows | source |\n|---|---|---|\n");
    for preset in PRESETS {
        let about = About::of(preset.text);
        let _ = writeln!(
            text,
            "| `{}` | {} | {} |",
            preset.name, about.shows, about.source
        );
    }
    text
}

fn columns() -> String {
    let mut text = String::from("| column | unit | what it is |\n|---|---|---|\n");
    for (prefix, card) in listing() {
        let (name, unit, summary) = (card.name, card.unit, card.summary);
        let mark = card.marks().replace('*', " \\*").replace('+', " \\+");
        let _ = writeln!(text, "| `{prefix}{name}`{mark} | {unit} | {summary} |");
    }
    for mark in MARKS {
        let _ = write!(text, "\n\\{mark}\n");
    }
    text
}

/// The workbench on the falling pile, as a screen of text.
fn picture() -> String {
    use ballast::session::frames::Shown;
    use ballast::session::{Budget, Options, Session};
    use ballast::tui::app::App;
    use ballast::tui::link::{Line, Link};
    use ballast::tui::look;
    use ratatui::buffer::Buffer;
    use ratatui::layout::Rect;

    let scene = Scene::load("disc-pile", &[]).unwrap();
    let mut session = Session::open(scene, Options::default()).unwrap();
    let utf8 = |name: &str| (name == "LANG").then(|| "C.UTF-8".to_owned());
    let mut app = App::new(
        look::from_environment(utf8),
        Link::new(Line {
            budget: None,
            fps: 10.0,
        }),
    );
    let mut shown = Shown::default();
    let area = Rect::new(0, 0, 112, 36);
    app.draw(area, &mut Buffer::empty(area));
    for cycle in [0, 4000, 7000, 8300] {
        let budget = Budget {
            until_cycle: Some(cycle),
            time: None,
        };
        session.advance(budget, false).unwrap();
        // Else a busy machine keeps measures of the frame before.
        shown.forget();
        app.take_frame(Box::new(session.frame(
            app.wants(),
            1500.0,
            true,
            &mut shown,
        )));
    }
    app.pace = Some(1500.0);
    let mut buffer = Buffer::empty(area);
    app.draw(area, &mut buffer);
    let mut text = String::from("```\n");
    for y in 0..area.height {
        let row: String = (0..area.width).map(|x| buffer[(x, y)].symbol()).collect();
        text.push_str(row.trim_end());
        text.push('\n');
    }
    text.push_str("```\n");
    text
}

/// From what `benches/larger_steps.py` wrote.
fn larger_steps() -> String {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/data/bench/larger-steps.csv");
    let mut text = String::from(
        "| FRAC | density | cycles | sin Φ at 0.05 % | 0.1 % | 0.2 % | 0.35 % | mean unbalanced |\n\
         |---|---|---|---|---|---|---|---|\n",
    );
    for row in csv::Reader::from_path(file).unwrap().records() {
        let row = row.unwrap();
        let density = match &row[1] {
            "1" => "true".to_owned(),
            factor => format!("{factor} x"),
        };
        let cycles: u64 = row[2].parse().unwrap();
        let phi: Vec<&str> = (3..7).map(|k| row[k].trim_start_matches('0')).collect();
        let unbalanced = 100.0 * row[7].parse::<f64>().unwrap();
        let digits = usize::from(unbalanced < 1.0) + 1;
        let _ = writeln!(
            text,
            "| {} | {density} | {} {:03} | {} | {unbalanced:.digits$} % |",
            &row[0],
            cycles / 1000,
            cycles % 1000,
            phi.join(" | "),
        );
    }
    text
}

/// The text with everything between a marker and the next end replaced.
fn filled(text: &str, marker: &str, content: &str) -> String {
    let (head, rest) = text
        .split_once(marker)
        .unwrap_or_else(|| panic!("README lacks {marker}"));
    let (_, tail) = rest
        .split_once("<!-- end -->")
        .expect("each marker has its end");
    format!("{head}{marker}\n{}\n<!-- end -->{tail}", content.trim_end())
}

#[test]
fn tables_and_picture_are_those_of_the_code() {
    let text = std::fs::read_to_string(README).unwrap();
    let mut wanted = text.clone();
    for (marker, content) in [
        ("<!-- picture -->", picture()),
        ("<!-- table: laws -->", laws()),
        ("<!-- table: presets -->", presets()),
        ("<!-- table: larger steps -->", larger_steps()),
        ("<!-- table: keys -->", ballast::scene::reference_table()),
        (
            "<!-- table: commands -->",
            ballast::language::reference_table(),
        ),
        ("<!-- table: columns -->", columns()),
        (
            "<!-- table: panes -->",
            ballast::tui::panes::reference_table(),
        ),
        (
            "<!-- table: keymap -->",
            ballast::tui::keys::reference_table(),
        ),
    ] {
        wanted = filled(&wanted, marker, &content);
    }
    if std::env::var_os("UPDATE").is_some() {
        std::fs::write(README, &wanted).unwrap();
        return;
    }
    assert!(
        text == wanted,
        "README is out of date: UPDATE=1 cargo test --test readme"
    );
}

/// Every line of the README that a user would type into a shell is a line the program takes.
#[test]
fn commands_of_the_tour_are_understood() {
    let text = std::fs::read_to_string(README).unwrap();
    let mut seen = 0;
    for line in text
        .split("```sh")
        .skip(1)
        .filter_map(|block| block.split("```").next())
    {
        for command in line.lines().filter(|line| line.starts_with("ballast ")) {
            let words: Vec<&str> = command
                .split('#')
                .next()
                .unwrap()
                .split_whitespace()
                .collect();
            for name in words
                .iter()
                .filter(|word| PRESETS.iter().any(|p| p.name == **word))
            {
                Scene::load(name, &[]).unwrap();
            }
            seen += 1;
        }
    }
    assert!(seen >= 5);
}
