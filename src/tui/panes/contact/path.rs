//! The path of a followed contact: T over δ, T over N, N over α.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use crate::session::inspect::{Inspection, Moment};
use crate::tui::app::App;
use crate::tui::dots::Ink;
use crate::tui::plot::{Axes, Plot};

/// Smallest and largest of some numbers, zero included: forces are read against it.
fn extent(numbers: impl Iterator<Item = f64>) -> (f64, f64) {
    numbers
        .filter(|x| x.is_finite())
        .fold((0.0, 0.0), |(low, high), x| (x.min(low), x.max(high)))
}

/// Touch by touch, and a mark where it is now.
fn draw_path(plot: &mut Plot, contact: &Inspection, at: fn(&Moment) -> (f64, f64)) {
    for touch in contact.trace.chunk_by(|a, b| a.touch == b.touch) {
        plot.curve(touch.iter().map(at), Ink::Curve);
    }
    if let Some(now) = contact.trace.last() {
        plot.mark(at(now));
    }
}

/// What a moment of the record is drawn as.
type Point = fn(&Moment) -> (f64, f64);

fn draw(
    app: &App,
    contact: &Inspection,
    (title, at): (&str, Point),
    area: Rect,
    buffer: &mut Buffer,
) {
    let along = extent(contact.trace.iter().map(|moment| at(moment).0));
    let up = extent(contact.trace.iter().map(|moment| at(moment).1));
    let axes = Axes {
        title,
        ranges: [along, up],
        foot: true,
    };
    let Some(mut plot) = Plot::new(&app.look, &axes, area, buffer) else {
        return;
    };
    draw_path(&mut plot, contact, at);
    plot.paint(&app.look, buffer);
}

pub(super) fn draw_loop(app: &App, contact: &Inspection, area: Rect, buffer: &mut Buffer) {
    let what = (
        "T [N] over delta [m]",
        (|m| (m.delta, m.t)) as fn(&Moment) -> _,
    );
    draw(app, contact, what, area, buffer);
}

pub(super) fn draw_normal(app: &App, contact: &Inspection, area: Rect, buffer: &mut Buffer) {
    let what = (
        "N [N] over alpha [m]",
        (|m| (m.alpha, m.n)) as fn(&Moment) -> _,
    );
    draw(app, contact, what, area, buffer);
}

/// With the lines of ±(μN + c).
pub(super) fn draw_limits(app: &App, contact: &Inspection, area: Rect, buffer: &mut Buffer) {
    let limit = |n: f64| contact.friction * n.max(0.0) + contact.cohesion;
    let along = extent(contact.trace.iter().map(|moment| moment.n));
    let most = contact.trace.iter().map(|m| limit(m.n).max(m.t.abs()));
    let (_, most) = extent(most);
    let title = if contact.shears() {
        "T [N] over N [N]  limit +-mu N"
    } else {
        "T [N] over N [N]  no friction"
    };
    let axes = Axes {
        title,
        ranges: [along, (-most, most)],
        foot: true,
    };
    let Some(mut plot) = Plot::new(&app.look, &axes, area, buffer) else {
        return;
    };
    if contact.shears() {
        for sign in [1.0, -1.0] {
            let ends = [along.0.max(0.0), along.1].map(|n| (n, sign * limit(n)));
            plot.curve(ends.into_iter(), Ink::SecondCurve);
        }
    }
    draw_path(&mut plot, contact, |m| (m.n, m.t));
    plot.paint(&app.look, buffer);
}
