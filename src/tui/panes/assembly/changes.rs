//! The assembly against the reference: contacts broken and made, rotations, displacements.

use std::f64::consts::PI;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{Map, STROKE, mark, plain};
use crate::measure::changes::Bond;
use crate::measure::frame::{Disc, Picture};
use crate::measure::survey::{Against, Displaced, Slid};
use crate::tui::app::App;
use crate::tui::dots::{Dots, Ink, per_cell};
use crate::tui::look::{Compared, Points, Role};
use crate::tui::panes::status::grouped;
use crate::tui::scale::round_up;
use crate::tui::write;

/// What arcs of rotations may cover at most: three quarters of a turn.
const FULL_ARC: f64 = 1.5 * PI;

/// Draws what is compared.
pub(super) fn draw(
    picture: &Picture,
    against: &Against,
    compared: Compared,
    map: &Map,
    dots: &mut Dots,
) {
    match compared {
        Compared::Off => {}
        Compared::Contacts => draw_lattice(against, map, dots),
        Compared::Rotations => {
            let scale = rotation_scale(against);
            for (disc, moved) in moved(picture, against) {
                draw_turn(disc, moved.rotation / scale, map, dots);
            }
        }
        Compared::Sliding => {
            let slid = against.slid.as_deref().unwrap_or_default();
            draw_slid(picture, slid, map, dots);
        }
        Compared::Displacements => {
            let scale = STROKE * map.cell / displacement_scale(against);
            for (disc, moved) in moved(picture, against) {
                let from = map.at(disc.at);
                let down = map.per_metre[1] / map.per_metre[0];
                let way = [scale * moved.u[0], -scale * moved.u[1] * down];
                if way[0].abs().max(way[1].abs()) >= 0.5 {
                    let to = [from[0] + way[0], from[1] + way[1]];
                    dots.line(from, to, Ink::Velocity);
                }
            }
        }
    }
}

/// A bar across each contact that slid, as long as it slid: at most a mean diameter, or bars would hide
/// each other.
fn draw_slid(picture: &Picture, slid: &[Slid], map: &Map, dots: &mut Dots) {
    let half = picture.means.radius * map.per_metre[0] / slid_scale(slid);
    let down = map.per_metre[1] / map.per_metre[0];
    for Slid { at, along, way } in slid {
        let middle = map.at(*at);
        let reach = half * way;
        let end = |side: f64| {
            [
                middle[0] + side * reach * along[0],
                middle[1] - side * reach * along[1] * down,
            ]
        };
        let thick = if map.cell > 1.0 { 2 } else { 1 };
        dots.bar(end(-1.0), end(1.0), thick, Ink::Force(3));
    }
}

/// Way that the longest bar stands for [m].
fn slid_scale(slid: &[Slid]) -> f64 {
    let ways = slid.iter().map(|slid| slid.way);
    round_up(ways.filter(|way| way.is_finite()).fold(0.0, f64::max))
}

/// Discs that were there at the reference. Numbers ascend in both lists.
fn moved<'a>(
    picture: &'a Picture,
    against: &'a Against,
) -> impl Iterator<Item = (&'a Disc, &'a Displaced)> {
    let mut rest = against.displaced.iter().peekable();
    picture.discs.iter().filter_map(move |disc| {
        // Discs that cannot be seen are left out of large pictures.
        while rest.next_if(|moved| moved.ball < disc.id).is_some() {}
        let moved = rest.next_if(|moved| moved.ball == disc.id)?;
        Some((disc, moved))
    })
}

fn draw_lattice(against: &Against, map: &Map, dots: &mut Dots) {
    // A character is thick enough.
    let thick = if map.cell > 1.0 { 3 } else { 1 };
    for (bond, ends) in &against.lattice {
        let [from, to] = ends.map(|end| map.at(end));
        match bond {
            Bond::Kept => dots.line(from, to, Ink::Force(1)),
            Bond::Made => dots.bar(from, to, thick, Ink::Force(4)),
            Bond::Broken => dots.dotted(from, to, Ink::Velocity),
        }
    }
}

/// Rows of the radius below which an arc would not be read: the sign stands alone.
const ARC_ROWS: f64 = 2.0;

/// An arc from the top of a disc on: to the left for a turn counter-clockwise.
fn draw_turn(disc: &Disc, share: f64, map: &Map, dots: &mut Dots) {
    let (centre, radii) = (map.at(disc.at), map.radii(disc.radius));
    let is_small = radii[1] < ARC_ROWS * map.row;
    if !share.is_finite() || share == 0.0 || is_small || !dots.sees(centre, radii) {
        return;
    }
    let ink = if share > 0.0 {
        Ink::Curve
    } else {
        Ink::SecondCurve
    };
    let at = |angle: f64| {
        [
            centre[0] + 0.6 * radii[0] * angle.cos(),
            centre[1] - 0.6 * radii[1] * angle.sin(),
        ]
    };
    let arc = share.clamp(-1.0, 1.0) * FULL_ARC;
    let steps = (arc.abs() * radii[0]).ceil().clamp(1.0, 200.0) as u32;
    let step = |k: u32| at(0.5 * PI + arc * f64::from(k) / f64::from(steps));
    for k in 0..steps {
        dots.line(step(k), step(k + 1), ink);
    }
}

/// Writes the senses of rotation into discs that have room for them.
pub(super) fn write_senses(
    app: &App,
    picture: &Picture,
    against: &Against,
    map: &Map,
    (area, buffer): (Rect, &mut Buffer),
) {
    let [across, down] = per_cell(app.look.points).map(|n| n as f64);
    for (disc, moved) in moved(picture, against) {
        let (centre, radii) = (map.at(disc.at), map.radii(disc.radius));
        let column = (centre[0] / across).floor();
        let row = (centre[1] / down).floor();
        let inside = column >= 0.0
            && row >= 0.0
            && column < f64::from(area.width)
            && row < f64::from(area.height);
        if !inside || radii[1] < 0.6 * down || moved.rotation == 0.0 {
            continue;
        }
        let sense = if moved.rotation > 0.0 { "+" } else { "-" };
        let place = (column as u16, row as u16);
        write::at(&app.look, (area, &mut *buffer), place, sense, Role::Value);
    }
}

/// Rotation that the longest arc stands for [rad].
fn rotation_scale(against: &Against) -> f64 {
    let turns = against.displaced.iter().map(|moved| moved.rotation.abs());
    round_up(turns.filter(|turn| turn.is_finite()).fold(0.0, f64::max))
}

/// Displacement that the longest stroke stands for [m].
fn displacement_scale(against: &Against) -> f64 {
    let ways = against.displaced.iter().map(|moved| {
        let [x, y] = moved.u;
        (x * x + y * y).sqrt()
    });
    round_up(ways.filter(|way| way.is_finite()).fold(0.0, f64::max))
}

/// What is seen, in a title.
pub(super) fn title(app: &App) -> String {
    let what = match app.look.compared {
        Compared::Off => return String::new(),
        Compared::Contacts => "contacts",
        Compared::Rotations => "rotations",
        Compared::Displacements => "displacements",
        Compared::Sliding => "sliding",
    };
    let frame = app.frame.as_ref();
    let since = frame
        .and_then(|frame| frame.survey.against.as_ref())
        .map_or(String::new(), |against| {
            format!(" since cycle {}", grouped(against.since))
        });
    format!("assembly, {what}{since}")
}

/// Writes what marks mean.
pub(super) fn write_legend(app: &App, against: &Against, (line, buffer): (Rect, &mut Buffer)) {
    let count = |wanted: Bond| {
        against
            .lattice
            .iter()
            .filter(|(bond, _)| *bond == wanted)
            .count()
    };
    let unless = |largest: f64, still: &str, text: String| {
        let text = if largest > 0.0 {
            text
        } else {
            still.to_owned()
        };
        vec![(text, Role::Label)]
    };
    let parts = match app.look.compared {
        Compared::Off => return,
        Compared::Contacts => {
            let dotted = if app.look.points == Points::Ascii {
                "~"
            } else {
                "⠄⠠"
            };
            let entry = |bond, name| (format!(" {} {name}  ", count(bond)), Role::Label);
            vec![
                (mark(app.look.points, 4).to_owned(), Role::Force(4)),
                entry(Bond::Made, "new"),
                (mark(app.look.points, 1).to_owned(), Role::Force(1)),
                entry(Bond::Kept, "kept"),
                (dotted.to_owned(), Role::Velocity),
                entry(Bond::Broken, "broken"),
            ]
        }
        Compared::Rotations => {
            let largest = against.displaced.iter().map(|moved| moved.rotation.abs());
            let scale = plain(rotation_scale(against));
            let text = format!("+, arc to the left: counter-clockwise; 3/4 turn = {scale} rad");
            unless(
                largest.fold(0.0, f64::max),
                "no disc has turned since then",
                text,
            )
        }
        Compared::Sliding => match &against.slid {
            None => {
                let text = "not booked: name mean_slid in [history] columns and start again";
                vec![(text.to_owned(), Role::Label)]
            }
            Some(slid) => {
                let scale = plain(slid_scale(slid));
                let text = format!(
                    "a mean diameter = {scale} m slid; {} of {} contacts",
                    slid.len(),
                    count(Bond::Kept) + count(Bond::Made)
                );
                unless(slid.len() as f64, "no contact has slid since then", text)
            }
        },
        Compared::Displacements => {
            let scale = plain(displacement_scale(against));
            let text = format!("{STROKE} columns = {scale} m, from where discs are now");
            let ways = against
                .displaced
                .iter()
                .map(|moved| moved.u[0].abs() + moved.u[1].abs());
            unless(
                ways.fold(0.0, f64::max),
                "no disc has moved since then",
                text,
            )
        }
    };
    let mut column = 0;
    for (text, role) in parts {
        column = write::at(&app.look, (line, &mut *buffer), (column, 0), &text, role);
    }
}
