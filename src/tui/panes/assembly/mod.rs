//! Discs, walls, contact forces, velocities, changes.

mod changes;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{Pane, PaneId};
use crate::measure::frame::{Disc, Picture, Touch};
use crate::measure::sight::Sight;
use crate::measure::survey::Part;
use crate::tui::app::App;
use crate::tui::dots::{Dots, Ink};
use crate::tui::look::{Chains, Compared, Points, Role};
use crate::tui::scale::{round_down, short};
use crate::tui::view::fitted;
use crate::tui::write::{self, Lines};

/// The pane.
pub const PANE: Pane = Pane {
    name: "assembly",
    summary: "discs, walls (double lines), driven discs (crossed); bars along contacts are wider the \
              larger the force; c shows what has changed since the reference",
    title: |app, _| {
        if app.look.compared != Compared::Off {
            return changes::title(app);
        }
        let chains = match app.look.chains {
            Chains::Off => "",
            Chains::Force => ", contact forces",
            Chains::Tangential => ", tangential forces",
        };
        let title = format!("assembly{chains}");
        if app.look.velocities && app.frame.is_some() {
            let scale = plain(app.stroke);
            return format!("{title}  velocities, {STROKE} columns = {scale} m/s");
        }
        title
    },
    draw,
    wants: |app, id, wants| {
        if app.look.compared != Compared::Off {
            wants.survey = wants.survey.with(Part::Changes);
        }
        wants.sight = sight(app, id);
        wants.velocities |= app.look.velocities;
    },
    ..Pane::PLAIN
};

/// Columns that the longest stroke of a velocity may cover.
const STROKE: f64 = 6.0;

fn draw(app: &App, _: PaneId, area: Rect, buffer: &mut Buffer) {
    let Some(frame) = &app.frame else {
        return;
    };
    let picture = &frame.picture;
    if picture.discs.is_empty() && picture.walls.is_empty() {
        let text = "no particles: `create` makes one, b lists presets";
        write::at(&app.look, (area, buffer), (0, 0), text, Role::Label);
        return;
    }
    let selected = app
        .selected
        .and_then(|id| picture.discs.iter().find(|disc| disc.id == id));
    let words = selected.map(|disc| about(disc, &picture.touches));
    let words = words.map(|text| write::wrapped(&text, usize::from(area.width)));
    // What is said of a disc may take more than one line, but not the place of the picture.
    let below = words.as_ref().map_or(1, |lines| lines.len() as u16);
    let body = Rect {
        height: area.height - below.min(area.height / 4),
        ..area
    };
    let mut dots = Dots::new(app.look.points, body.width, body.height);
    let map = Map::new(app, picture, &dots);
    draw_walls(picture, &map, app.look.points, &mut dots);
    // The space lattice stands for the discs.
    if app.look.discs && app.look.compared != Compared::Contacts {
        for disc in &picture.discs {
            draw_disc(disc, &map, &mut dots);
        }
    }
    let is_compared = app.look.compared != Compared::Off;
    let against = frame.survey.against.as_ref().filter(|_| is_compared);
    let mean = if is_compared {
        0.0
    } else {
        mean_force(picture, app.look.chains)
    };
    draw_bars(picture, app, mean, &map, &mut dots);
    if let Some(against) = against {
        changes::draw(picture, against, app.look.compared, &map, &mut dots);
    }
    if app.look.velocities && !is_compared {
        draw_velocities(picture, app.stroke, &map, &mut dots);
    }
    if let Some(disc) = selected {
        dots.circle(map.at(disc.at), map.radii(disc.radius), Ink::Selected);
    }
    dots.paint(&app.look, body, buffer);
    if let (Some(against), Compared::Rotations) = (against, app.look.compared) {
        changes::write_senses(app, picture, against, &map, (body, &mut *buffer));
    }
    if let Some(disc) = selected {
        write_number(app, disc, map.at(disc.at), &dots, (body, buffer));
    }
    if body.height < area.height {
        let line = Rect {
            y: body.bottom(),
            height: area.height - body.height,
            ..area
        };
        match (words, against) {
            (Some(words), _) => {
                let mut lines = Lines::new(&app.look, line, buffer);
                let fitting = words.iter().take(usize::from(line.height));
                fitting.for_each(|words| lines.line(words, Role::Value));
            }
            (None, Some(against)) => changes::write_legend(app, against, (line, buffer)),
            (None, None) => write_scale(app, &map, mean, (line, buffer)),
        }
    }
}

/// What is seen where the assembly has more than can be; the frame of the pane is nothing against the
/// margin that is added.
fn sight(app: &App, id: PaneId) -> Option<Sight> {
    let picture = &app.frame.as_ref()?.picture;
    picture.whole?;
    let area = app.place_of(id)?;
    let dots = Dots::new(app.look.points, area.width, area.height);
    let map = Map::new(app, picture, &dots);
    Some(Sight {
        window: [map.low, map.high],
        dots: dots.size().map(|n| n as u32),
    })
}

/// From metres to dots.
struct Map {
    low: [f64; 2],
    high: [f64; 2],
    /// Dots per metre, across and down.
    per_metre: [f64; 2],
    /// Dots across one cell.
    cell: f64,
    /// Dots down one cell.
    row: f64,
}

impl Map {
    fn new(app: &App, picture: &Picture, dots: &Dots) -> Self {
        let [across, down] = dots.size().map(|n| n as f64);
        let aspect = dots.aspect();
        let [low, high] = app.view.window(fitted(picture), across, down * aspect);
        let [cell, row] = crate::tui::dots::per_cell(app.look.points);
        let per_metre = across.max(1.0) / (high[0] - low[0]);
        Self {
            low,
            high,
            per_metre: [per_metre, per_metre / aspect],
            cell: cell as f64,
            row: row as f64,
        }
    }

    fn at(&self, x: [f64; 2]) -> [f64; 2] {
        [
            (x[0] - self.low[0]) * self.per_metre[0],
            (self.high[1] - x[1]) * self.per_metre[1],
        ]
    }

    fn radii(&self, radius: f64) -> [f64; 2] {
        self.per_metre.map(|scale| radius * scale)
    }
}

fn draw_walls(picture: &Picture, map: &Map, points: Points, dots: &mut Dots) {
    for wall in &picture.walls {
        let [from, to] = wall.ends.map(|end| map.at(end));
        let d = [to[0] - from[0], to[1] - from[1]];
        let length = (d[0] * d[0] + d[1] * d[1]).sqrt();
        if points != Points::Braille || !(length > 0.0 && length.is_finite()) {
            dots.line(from, to, Ink::Wall);
            continue;
        }
        // Double, or it would look like a bar.
        for side in [-1.0, 1.0] {
            let beside =
                |end: [f64; 2]| [end[0] - side * d[1] / length, end[1] + side * d[0] / length];
            dots.line(beside(from), beside(to), Ink::Wall);
        }
    }
}

/// The outline; driven discs get a cross, those that have turned a spoke, where there is room.
fn draw_disc(disc: &Disc, map: &Map, dots: &mut Dots) {
    let (centre, radii) = (map.at(disc.at), map.radii(disc.radius));
    let ink = if disc.driven { Ink::Wall } else { Ink::Disc };
    dots.circle(centre, radii, ink);
    if !dots.sees(centre, radii) {
        return;
    }
    let at = |share: f64, angle: f64| {
        [
            centre[0] + share * radii[0] * angle.cos(),
            centre[1] - share * radii[1] * angle.sin(),
        ]
    };
    if disc.driven && radii[1] >= 3.0 {
        for angle in [0.25, 0.75].map(|turn| turn * std::f64::consts::PI) {
            dots.line(at(-0.5, angle), at(0.5, angle), ink);
        }
    } else if disc.angle != 0.0 && radii[1] >= 5.0 {
        dots.line(at(0.5, disc.angle), at(1.0, disc.angle), ink);
    }
}

/// The force that a bar stands for [N].
fn bar_force(touch: &Touch, chains: Chains) -> f64 {
    match chains {
        Chains::Off => 0.0,
        Chains::Force => touch.force(),
        Chains::Tangential => touch.t.abs(),
    }
}

/// Mean over all contacts that carry something [N].
fn mean_force(picture: &Picture, chains: Chains) -> f64 {
    match chains {
        Chains::Off => 0.0,
        Chains::Force => picture.means.force,
        Chains::Tangential => picture.means.tangential,
    }
}

/// Class of a force, 1 to 4, by multiples of the mean; 0 for none.
fn class(force: f64, mean: f64) -> u8 {
    let share = force / mean;
    if !(force > 0.0 && share.is_finite()) {
        return 0;
    }
    1 + [0.5, 1.0, 2.0]
        .iter()
        .filter(|bound| share >= **bound)
        .count() as u8
}

/// Bars along the branches, as long as the radii together, wider for larger forces.
fn draw_bars(picture: &Picture, app: &App, mean: f64, map: &Map, dots: &mut Dots) {
    if mean <= 0.0 {
        return;
    }
    for touch in &picture.touches {
        let class = class(bar_force(touch, app.look.chains), mean);
        if class == 0 {
            continue;
        }
        let width = match app.look.points {
            // A bar wider than it is long would hide the disc.
            Points::Braille | Points::HalfBlock => {
                let share = if touch.second.is_some() { 0.5 } else { 1.0 };
                let room = share * touch.length * map.per_metre[0];
                class.min(room.clamp(1.0, 4.0).round() as u8)
            }
            Points::Ascii => 1,
        };
        let (middle, half) = touch.bar();
        let along = match app.look.chains {
            Chains::Tangential => touch.normal,
            _ => touch.along(),
        };
        let end = |sign: f64| [0, 1].map(|k| middle[k] + sign * half * along[k]);
        let (from, to) = (map.at(end(-1.0)), map.at(end(1.0)));
        dots.bar(from, to, width, Ink::Force(class));
    }
}

/// Strokes from the centres.
fn draw_velocities(picture: &Picture, fastest: f64, map: &Map, dots: &mut Dots) {
    let scale = STROKE * map.cell / fastest;
    for disc in &picture.discs {
        let from = map.at(disc.at);
        let down = map.per_metre[1] / map.per_metre[0];
        let to = [
            from[0] + scale * disc.velocity[0],
            from[1] - scale * disc.velocity[1] * down,
        ];
        if (to[0] - from[0]).abs().max((to[1] - from[1]).abs()) >= 0.5 {
            dots.line(from, to, Ink::Velocity);
        }
    }
}

/// The number of the selected disc, in its middle.
fn write_number(
    app: &App,
    disc: &Disc,
    centre: [f64; 2],
    dots: &Dots,
    (area, buffer): (Rect, &mut Buffer),
) {
    if !dots.sees(centre, [0.0; 2]) {
        return;
    }
    let text = disc.id.to_string();
    let [across, down] = crate::tui::dots::per_cell(app.look.points);
    let column = (centre[0] / across as f64 - 0.5 * text.len() as f64).round();
    let row = centre[1] / down as f64;
    let place = (column.max(0.0) as u16, row as u16);
    write::at(&app.look, (area, buffer), place, &text, Role::Selected);
}

/// A disc in a few words.
fn about(disc: &Disc, touches: &[Touch]) -> String {
    let (force, contacts) = contact_force(disc.id, touches);
    let size = (force[0] * force[0] + force[1] * force[1]).sqrt();
    format!(
        "disc {}: x {} y {} m  v {} m/s  {contacts} contacts, sum {} N",
        disc.id,
        short(disc.at[0]),
        short(disc.at[1]),
        short(disc.speed()),
        short(size),
    )
}

/// Sum of the contact forces on a disc [N], and how many they are.
fn contact_force(id: u32, touches: &[Touch]) -> ([f64; 2], usize) {
    let (mut sum, mut count) = ([0.0; 2], 0);
    for touch in touches {
        let sign = if touch.first == id {
            -1.0
        } else if touch.second == Some(id) {
            1.0
        } else {
            continue;
        };
        let e = touch.normal;
        let tangent = [e[1], -e[0]];
        for k in 0..2 {
            sum[k] += sign * (touch.n * e[k] + touch.t * tangent[k]);
        }
        count += usize::from(touch.n > 0.0);
    }
    (sum, count)
}

/// Scale bar, size of the window, what bars mean.
fn write_scale(app: &App, map: &Map, mean: f64, (line, buffer): (Rect, &mut Buffer)) {
    let size = [0, 1].map(|k| map.high[k] - map.low[k]);
    let metres_per_column = map.cell / map.per_metre[0];
    let most = f64::from(line.width) * metres_per_column / 8.0;
    let length = round_down(most);
    let columns = (length / metres_per_column).round().clamp(1.0, 60.0) as usize;
    let text = format!(
        "|{}| {} m  view {} x {} m",
        "-".repeat(columns.saturating_sub(2)),
        plain(length),
        plain(size[0]),
        plain(size[1]),
    );
    let end = write::at(&app.look, (line, &mut *buffer), (0, 0), &text, Role::Label);
    if mean <= 0.0 {
        return;
    }
    let meaning = [(1, "<.5 "), (2, "<1 "), (3, "<2 "), (4, ">2 mean")];
    let width: usize = meaning.iter().map(|(_, text)| text.len() + 1).sum();
    if usize::from(line.width) < usize::from(end) + 2 + width {
        return;
    }
    let mut column = line.width - width as u16;
    for (class, text) in meaning {
        let role = Role::Force(class);
        let mark = mark(app.look.points, class);
        column = write::at(&app.look, (line, &mut *buffer), (column, 0), mark, role);
        column = write::at(
            &app.look,
            (line, &mut *buffer),
            (column, 0),
            text,
            Role::Label,
        );
    }
}

/// A piece of bar of a class.
fn mark(points: Points, class: u8) -> &'static str {
    let marks = match points {
        Points::Braille => ["⠒", "⠶", "⠿", "⣿"],
        Points::HalfBlock => ["▁", "▃", "▅", "█"],
        Points::Ascii => ["-", "=", "%", "@"],
    };
    marks[usize::from(class.clamp(1, 4)) - 1]
}

/// Three digits, without zeros that say nothing.
fn plain(x: f64) -> String {
    let rounded: f64 = format!("{x:.2e}").parse().unwrap_or(x);
    crate::session::figure::figure(rounded)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn four_classes() {
        let classes = [0.0, 0.1, 0.49, 0.5, 0.99, 1.0, 1.99, 2.0, 50.0].map(|f| class(f, 1.0));
        assert_eq!(classes, [0, 1, 1, 2, 2, 3, 3, 4, 4]);
        assert_eq!(class(f64::NAN, 1.0), 0);
        assert_eq!(class(1.0, 0.0), 0);
    }

    #[test]
    fn a_disc_between_two_others_feels_both() {
        let touch = |first, second, normal: [f64; 2], n, t| Touch {
            ends: [[0.0; 2]; 2],
            length: 1.0,
            normal,
            n,
            t,
            sliding: false,
            first,
            second,
            wall: None,
        };
        let touches = [
            touch(1, Some(2), [1.0, 0.0], 5.0, 0.0),
            touch(2, None, [0.0, -1.0], 3.0, 1.0),
            touch(3, Some(4), [1.0, 0.0], 9.0, 9.0),
        ];
        // Pushed to the right by disc 1 and up by the floor, whose friction acts along -t = (1, 0).
        assert_eq!(contact_force(2, &touches), ([6.0, 3.0], 2));
    }
}
