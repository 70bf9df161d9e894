//! The newest values of the recorded columns.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{Pane, PaneId};
use crate::language::Observable;
use crate::measure::columns::{Column, Kind};
use crate::tui::app::App;
use crate::tui::look::{Points, Role};
use crate::tui::scale::{count, short};
use crate::tui::write::Lines;

/// The pane.
pub const PANE: Pane = Pane {
    name: "numbers",
    summary: "newest row of the history; enlarged, all its columns",
    title: |app, _| match app.series.rows().last() {
        Some(row) => format!("newest row  cycle {}", super::status::grouped(row.cycle)),
        None => "numbers".into(),
    },
    draw,
    ..Pane::PLAIN
};

/// Columns that are looked at first, most useful first. What was asked for by name, a wall or a
/// particle, stands between [`FIRST`] and [`NEXT`].
const FIRST: [&str; 4] = ["sin_phi", "isotropic_stress", "coordination", "unbalanced"];

/// Then these; the others follow in their order.
const NEXT: [&str; 6] = [
    "kinetic",
    "sliding_fraction",
    "contacts",
    "max_force",
    "mean_force",
    "energy_error",
];

/// Columns of text that a name and its number side by side need.
const ROOMY: u16 = 26;

/// Places of the columns, most useful first.
fn order(columns: &[Observable]) -> Vec<usize> {
    let rank = |column: &Observable| {
        let Observable::Column(Column::Global(row)) = column else {
            return FIRST.len();
        };
        let name = row.card.name;
        if let Some(at) = FIRST.iter().position(|first| *first == name) {
            return at;
        }
        let at = NEXT.iter().position(|next| *next == name);
        FIRST.len() + 1 + at.unwrap_or(NEXT.len())
    };
    let mut order: Vec<usize> = (0..columns.len()).collect();
    order.sort_by_key(|&k| rank(&columns[k]));
    order
}

fn draw(app: &App, _: PaneId, area: Rect, buffer: &mut Buffer) {
    let Some(row) = app.series.rows().last() else {
        draw_without_rows(app, area, buffer);
        return;
    };
    let order = order(&app.series.columns);
    let height = usize::from(area.height).max(1);
    // More columns of text if one does not do and there is room.
    let stacks = order
        .len()
        .div_ceil(height)
        .clamp(1, usize::from(area.width / 48).max(1));
    let width = area.width / stacks as u16;
    for (stack, places) in order.chunks(height).take(stacks).enumerate() {
        let place = Rect {
            x: area.x + stack as u16 * width,
            width,
            ..area
        };
        let mut lines = Lines::new(&app.look, place, buffer);
        let names = places
            .iter()
            .map(|&k| app.series.columns[k].name().chars().count());
        let longest = names.max().unwrap_or(0);
        for &k in places {
            let value = row.values.get(k).copied().unwrap_or(f64::NAN);
            write_column(app, k, value, (longest, place.width), &mut lines);
        }
    }
}

fn write_column(
    app: &App,
    k: usize,
    value: f64,
    (longest, width): (usize, u16),
    lines: &mut Lines<'_>,
) {
    let column = &app.series.columns[k];
    let number = if column.kind() == Kind::Count {
        count(value)
    } else {
        short(value)
    };
    let width = usize::from(width);
    let unit = if column.unit() == "-" {
        ""
    } else {
        column.unit()
    };
    let mut name = column.name();
    if width < usize::from(ROOMY) {
        // No room for columns: the number right behind the name.
        let room = width.saturating_sub(number.len() + 1);
        name = name.chars().take(room).collect();
        lines.parts(&[
            (&name, Role::Label),
            (" ", Role::Label),
            (&number, Role::Value),
        ]);
        return;
    }
    // Names before pictures: what there is no room for is the curve.
    let names = width.saturating_sub(18).min(longest.max(24));
    if name.chars().count() > names {
        name = name.chars().take(names).collect();
    }
    let text = format!("{name:names$} ");
    let number = format!("{number:>10} {unit:5} ");
    let used = text.len() + number.len();
    let room = width.saturating_sub(used + 1).min(32);
    let sparkline = if room >= 6 {
        sparkline(app, k, room)
    } else {
        String::new()
    };
    lines.parts(&[
        (&text, Role::Label),
        (&number, Role::Value),
        (&sparkline, Role::Curve),
    ]);
}

/// Before the first row: what a frame knows by itself.
fn draw_without_rows(app: &App, area: Rect, buffer: &mut Buffer) {
    let Some(frame) = &app.frame else {
        return;
    };
    let mut lines = Lines::new(&app.look, area, buffer);
    let assembly = &frame.assembly;
    for (name, value) in [
        ("coordination", short(assembly.coordination)),
        ("unbalanced", short(assembly.unbalanced)),
        ("contacts", assembly.contacts.to_string()),
        ("mean_force [N]", short(assembly.mean_force)),
    ] {
        let text = if area.width < ROOMY {
            format!("{name} {value}")
        } else {
            format!("{name:14} {value:>10}")
        };
        lines.line(&text, Role::Value);
    }
    let text = format!("no rows yet, one every {} cycles", frame.every);
    lines.line(&text, Role::Label);
}

/// The history of a column in so many characters. Cycles end at a round number as in charts, so
/// that only its end moves.
fn sparkline(app: &App, column: usize, width: usize) -> String {
    let levels: &[char] = if app.look.points == Points::Ascii {
        &['_', '.', '-', '=', '+', '*', '#', '@']
    } else {
        &['▁', '▂', '▃', '▄', '▅', '▆', '▇', '█']
    };
    let span = super::chart::cycles(app);
    let mut cells: Vec<(f64, u32)> = vec![(0.0, 0); width];
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    for (cycle, value) in app.series.points(column) {
        low = low.min(value);
        high = high.max(value);
        let share = (cycle as f64 - span.start) / (span.end - span.start);
        let at = (share * (width - 1) as f64)
            .round()
            .clamp(0.0, (width - 1) as f64) as usize;
        cells[at].0 += value;
        cells[at].1 += 1;
    }
    let name = app.series.columns[column].bare_name();
    let scale = super::chart::axis(name, low, high, 5);
    cells
        .into_iter()
        .map(|(sum, count)| {
            if count == 0 {
                return ' ';
            }
            let place = scale.place(sum / f64::from(count)) * (levels.len() - 1) as f64;
            levels[(place.round().max(0.0) as usize).min(levels.len() - 1)]
        })
        .collect::<String>()
        .trim_end()
        .to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_most_useful_come_first() {
        let names = ["dt", "kinetic", "wall:left:f1", "coordination", "contacts"];
        let columns = names.map(|name| Observable::Column(Column::parse(name).unwrap()));
        let ordered: Vec<&str> = order(&columns).into_iter().map(|k| names[k]).collect();
        assert_eq!(
            ordered,
            ["coordination", "wall:left:f1", "kinetic", "contacts", "dt"]
        );
    }
}
