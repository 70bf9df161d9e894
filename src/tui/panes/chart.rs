//! A column of the history over cycles.

use std::ops::Range;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{Pane, PaneId};
use crate::tui::app::App;
use crate::tui::dots::{Dots, Ink};
use crate::tui::look::{Points, Role};
use crate::tui::scale::{Scale, round_up, short};
use crate::tui::write;

/// The pane.
pub const PANE: Pane = Pane {
    name: "chart",
    summary: "a column over cycles; [ and ] choose another",
    title,
    draw,
    ..Pane::PLAIN
};

/// Drawn dotted into the same chart as its first.
const COMPANIONS: [(&str, &str); 1] = [("sin_phi", "sin_phi_shear")];

/// Ratios that run through decades: their axis counts powers of ten.
const DECADES: [&str; 2] = ["unbalanced", "unbalanced_max"];

/// The axis of a column over these values.
pub(super) fn axis(name: &str, low: f64, high: f64, steps: usize) -> Scale {
    if DECADES.contains(&name) {
        Scale::decades(low, high, steps)
    } else {
        Scale::over(low, high, steps)
    }
}

fn column_name(app: &App, id: PaneId) -> &str {
    let slot = match id {
        PaneId::Chart(slot) => slot,
        _ => 0,
    };
    app.charts.get(slot).map_or("", String::as_str)
}

fn companion(app: &App, name: &str) -> Option<usize> {
    let (_, second) = COMPANIONS.iter().find(|(first, _)| *first == name)?;
    app.series.position(second)
}

/// The newest value as it is shown; empty before the first row.
fn newest(app: &App, column: usize) -> String {
    let row = app.series.rows().last();
    let value = row.map(|row| row.values.get(column).copied().unwrap_or(f64::NAN));
    value.map(short).unwrap_or_default()
}

fn title(app: &App, id: PaneId) -> String {
    let name = column_name(app, id);
    let Some(column) = app.series.position(name) else {
        return if name.is_empty() { "chart" } else { name }.to_owned();
    };
    let observable = &app.series.columns[column];
    let more = match companion(app, name) {
        Some(second) => format!("dotted: shear part {}", newest(app, second)),
        None => observable.summary(),
    };
    format!(
        "{name} [{}] {}  {more}",
        observable.unit(),
        newest(app, column)
    )
}

fn draw(app: &App, id: PaneId, area: Rect, buffer: &mut Buffer) {
    let name = column_name(app, id);
    let say = |text: &str, buffer: &mut Buffer| {
        for (row, line) in write::wrapped(text, usize::from(area.width))
            .iter()
            .enumerate()
        {
            write::at(
                &app.look,
                (area, buffer),
                (0, row as u16),
                line,
                Role::Label,
            );
        }
    };
    let Some(column) = app.series.position(name) else {
        return say("not recorded; [ and ] choose another column", buffer);
    };
    let every = app.frame.as_ref().map_or(0, |frame| frame.every);
    if app.series.rows().is_empty() {
        return say(&format!("no rows yet, one every {every} cycles"), buffer);
    }
    let second = companion(app, name);
    let decades = DECADES.contains(&name);
    let Some((low, high)) = extent(app, column, second, decades) else {
        return say("undefined in every row so far", buffer);
    };
    let steps = usize::from(area.height / 3).clamp(1, 8);
    let scale = axis(name, low, high, steps);
    let labels = scale.ticks();
    let widest = labels
        .iter()
        .map(|(_, label)| label.len())
        .max()
        .unwrap_or(0) as u16;
    // The curve has priority over its numbers.
    let gutter = if area.width >= 3 * (widest + 1) {
        widest + 1
    } else {
        0
    };
    let foot = u16::from(area.height >= 4);
    let body = Rect {
        x: area.x + gutter,
        width: area.width - gutter,
        height: area.height - foot,
        ..area
    };
    let span = cycles(app);
    let mut dots = Dots::new(app.look.points, body.width, body.height);
    if let Some(second) = second {
        draw_curve(app, second, &span, &scale, &mut dots, Ink::SecondCurve);
    }
    draw_curve(app, column, &span, &scale, &mut dots, Ink::Curve);
    dots.paint(&app.look, body, buffer);
    if gutter > 0 {
        write_labels(app, &scale, &labels, gutter, (area, body, buffer));
    }
    if foot > 0 {
        write_cycles(app, &span, body, buffer);
    }
}

/// Smallest and largest value that has a place on the axis.
fn extent(app: &App, column: usize, second: Option<usize>, decades: bool) -> Option<(f64, f64)> {
    let values = [Some(column), second]
        .into_iter()
        .flatten()
        .flat_map(|column| app.series.points(column).map(|(_, value)| value))
        .filter(|value| !decades || *value > 0.0);
    values.fold(None, |extent, value| {
        let (low, high) = extent.unwrap_or((value, value));
        Some((value.min(low), value.max(high)))
    })
}

/// Cycles shown: up to a round number, so that the curve does not move with every row.
pub(super) fn cycles(app: &App) -> Range<f64> {
    let rows = app.series.rows();
    let first = rows.first().map_or(0, |row| row.cycle) as f64;
    let last = rows.last().map_or(0, |row| row.cycle) as f64;
    // A run taken up again late does not leave its chart empty on the left.
    let start = if 2.0 * first < last || first < 1.0 {
        0.0
    } else {
        let step = round_up(last - first);
        (first / step).floor() * step
    };
    start..start + round_up((last - start).max(1.0))
}

/// What is seen of a curve in one column of dots.
struct Sweep {
    x: i64,
    first: i64,
    last: i64,
    low: i64,
    high: i64,
}

/// Draws smallest to largest value per column of dots, and joins the columns. Rows without a value
/// interrupt the curve.
fn draw_curve(
    app: &App,
    column: usize,
    span: &Range<f64>,
    scale: &Scale,
    dots: &mut Dots,
    ink: Ink,
) {
    let [across, down] = dots.size().map(|n| n as f64 - 1.0);
    let mut sweep: Option<Sweep> = None;
    for row in app.series.rows() {
        let value = row.values.get(column).copied().unwrap_or(f64::NAN);
        let place = scale.place(value);
        if !(value.is_finite() && place.is_finite()) {
            if let Some(done) = sweep.take() {
                finish(&done, None, dots, ink);
            }
            continue;
        }
        let share = (row.cycle as f64 - span.start) / (span.end - span.start);
        let x = (share.clamp(0.0, 1.0) * across).round() as i64;
        let y = ((1.0 - place).clamp(0.0, 1.0) * down).round() as i64;
        match &mut sweep {
            Some(now) if now.x == x => {
                now.last = y;
                now.low = now.low.min(y);
                now.high = now.high.max(y);
            }
            _ => {
                if let Some(done) = sweep.take() {
                    finish(&done, Some((x, y)), dots, ink);
                }
                sweep = Some(Sweep {
                    x,
                    first: y,
                    last: y,
                    low: y,
                    high: y,
                });
            }
        }
    }
    if let Some(done) = sweep {
        finish(&done, None, dots, ink);
    }
}

/// Draws a column, and the line to the next.
fn finish(sweep: &Sweep, next: Option<(i64, i64)>, dots: &mut Dots, ink: Ink) {
    let dotted = ink == Ink::SecondCurve;
    let mut dot = |x: i64, y: i64| {
        if !dotted || x % 3 == 0 {
            dots.dot(x, y, ink);
        }
    };
    debug_assert!((sweep.low..=sweep.high).contains(&sweep.first));
    for y in sweep.low..=sweep.high {
        dot(sweep.x, y);
    }
    let Some((x, y)) = next else { return };
    let (dx, dy) = (x - sweep.x, y - sweep.last);
    let steps = dx.abs().max(dy.abs()).max(1);
    for k in 1..steps {
        dot(sweep.x + dx * k / steps, sweep.last + dy * k / steps);
    }
}

/// Numbers at the left.
fn write_labels(
    app: &App,
    scale: &Scale,
    labels: &[(f64, String)],
    gutter: u16,
    (area, body, buffer): (Rect, Rect, &mut Buffer),
) {
    let rows = f64::from(body.height.max(1) - 1);
    for (value, label) in labels {
        let row = ((1.0 - scale.place(*value)) * rows).round() as u16;
        let column = (gutter - 1).saturating_sub(label.len() as u16);
        write::at(
            &app.look,
            (area, &mut *buffer),
            (column, row),
            label,
            Role::Label,
        );
    }
    let bar = if app.look.points == Points::Ascii {
        "|"
    } else {
        "│"
    };
    for row in 0..body.height {
        write::at(
            &app.look,
            (area, &mut *buffer),
            (gutter - 1, row),
            bar,
            Role::Frame,
        );
    }
}

/// Cycles below: both ends and the middle, as far as they do not touch.
fn write_cycles(app: &App, span: &Range<f64>, body: Rect, buffer: &mut Buffer) {
    let line = Rect {
        y: body.bottom(),
        height: 1,
        ..body
    };
    let width = usize::from(body.width);
    let [first, middle, last] = [span.start, 0.5 * (span.start + span.end), span.end].map(grouped);
    let last = if width >= 24 {
        format!("{last} cycles")
    } else {
        last
    };
    let mut write = |column: usize, text: &str| {
        let place = (column as u16, 0);
        write::at(&app.look, (line, &mut *buffer), place, text, Role::Label);
    };
    let end = width.saturating_sub(last.len());
    let centre = (width / 2).saturating_sub(middle.len() / 2);
    write(end, &last);
    if first.len() + 2 <= end {
        write(0, &first);
    }
    if first.len() + 2 <= centre && centre + middle.len() + 2 <= end {
        write(centre, &middle);
    }
}

fn grouped(cycle: f64) -> String {
    super::status::grouped(cycle.round().max(0.0) as u64)
}
