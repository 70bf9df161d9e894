//! The assembly as a picture: discs, walls, and a rectangle through each contact along its force, as
//! long as the radii together and as wide as the force is large (Strack & Cundall 1978).
//!
//! Written by hand: a plotting library places discs on whole pixels, and an assembly of thousands
//! needs better.

use crate::language::command::Layers;
use crate::measure::frame::{Disc, Picture, Touch};
use crate::session::figure::rough;

/// Longer side of the assembly [pixels].
const SIZE: f64 = 900.0;

/// Room around it, and for a line of text below [pixels].
const MARGIN: f64 = 16.0;
const FOOT: f64 = 28.0;

/// Width of a letter of that [pixels].
const LETTER: f64 = 6.6;

/// Width of the widest rectangle over the mean radius.
const WIDEST: f64 = 1.0;

/// Length of the longest arrow over the mean radius.
const FASTEST: f64 = 3.0;

/// The picture as SVG.
pub(super) fn svg(picture: &Picture, cycle: u64, layers: Layers) -> String {
    let map = Map::of(picture);
    let (width, height) = (
        map.size[0] + 2.0 * MARGIN,
        map.size[1] + 2.0 * MARGIN + FOOT,
    );
    let mut text = String::from("<g fill=\"#f2f2f2\" stroke=\"#808080\" stroke-width=\"0.6\">\n");
    for disc in &picture.discs {
        let [x, y] = map.at(disc.at);
        let radius = disc.radius * map.scale;
        let fill = if disc.driven { " fill=\"#d0d0d0\"" } else { "" };
        text.push_str(&format!(
            "<circle cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"{radius:.2}\"{fill}/>\n"
        ));
    }
    text.push_str("</g>\n<g stroke=\"black\" stroke-width=\"2\" stroke-linecap=\"round\">\n");
    for wall in &picture.walls {
        let [[x1, y1], [x2, y2]] = wall.ends.map(|end| map.at(end));
        text.push_str(&format!(
            "<line x1=\"{x1:.2}\" y1=\"{y1:.2}\" x2=\"{x2:.2}\" y2=\"{y2:.2}\"/>\n"
        ));
    }
    text.push_str("</g>\n<g stroke=\"#0072b2\">\n");
    let sizes = sizes(picture);
    let most = picture.touches.iter().map(Touch::force).fold(0.0, f64::max);
    let radii: f64 = picture.discs.iter().map(|disc| disc.radius).sum();
    let widest = WIDEST * map.scale * radii / picture.discs.len().max(1) as f64;
    for touch in picture.touches.iter().filter(|touch| touch.force() > 0.0) {
        let [[x1, y1], [x2, y2]] = ends(touch, &sizes).map(|end| map.at(end));
        let bar = widest * touch.force() / most;
        let colour = if touch.sliding {
            " stroke=\"#d55e00\""
        } else {
            ""
        };
        text.push_str(&format!(
            "<line x1=\"{x1:.2}\" y1=\"{y1:.2}\" x2=\"{x2:.2}\" y2=\"{y2:.2}\" \
             stroke-width=\"{bar:.3}\"{colour}/>\n"
        ));
    }
    text.push_str("</g>\n");
    let mut foot = format!(
        "cycle {cycle}: {} particles, {} contacts, widest bar {} N; orange: sliding; scale bar {} m",
        picture.discs.len(),
        picture.touches.len(),
        rough(most),
        rough(map.bar()),
    );
    if layers.velocities {
        let fastest = picture.discs.iter().map(Disc::speed).fold(0.0, f64::max);
        foot.push_str(&format!("; longest arrow {} m/s", rough(fastest)));
        let longest = FASTEST * widest / WIDEST;
        arrows(&mut text, picture, &map, longest / fastest);
    }
    if layers.numbers {
        numbers(&mut text, picture, &map);
    }
    let (x, y) = (MARGIN, height - 0.4 * FOOT);
    let reach = x + map.bar() * map.scale;
    // As wide as the text below it, where the assembly is narrow.
    let width = width.max(foot.len() as f64 * LETTER + 2.0 * MARGIN);
    let head = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width:.0}\" height=\"{height:.0}\" \
         viewBox=\"0 0 {width:.1} {height:.1}\">\n<rect width=\"100%\" height=\"100%\" \
         fill=\"white\"/>\n"
    );
    text.push_str(&format!(
        "<line x1=\"{x:.2}\" y1=\"{up:.2}\" x2=\"{reach:.2}\" y2=\"{up:.2}\" stroke=\"black\" \
         stroke-width=\"3\"/>\n<text x=\"{x:.2}\" y=\"{y:.2}\" font-family=\"sans-serif\" \
         font-size=\"13\">{foot}</text>\n</svg>\n",
        up = y - 16.0,
    ));
    head + &text
}

/// An arrow from each centre along its velocity; `scale` in pixels per [m/s].
fn arrows(text: &mut String, picture: &Picture, map: &Map, scale: f64) {
    text.push_str(
        "<defs><marker id=\"head\" viewBox=\"0 0 6 6\" refX=\"5\" refY=\"3\" markerWidth=\"5\" \
         markerHeight=\"5\" orient=\"auto\"><path d=\"M0 0L6 3L0 6z\" fill=\"#009e73\"/></marker></defs>\n\
         <g stroke=\"#009e73\" stroke-width=\"1\" marker-end=\"url(#head)\">\n",
    );
    for disc in picture.discs.iter().filter(|disc| disc.speed() > 0.0) {
        let [x, y] = map.at(disc.at);
        let [dx, dy] = disc.velocity.map(|v| v * scale);
        text.push_str(&format!(
            "<path d=\"M{x:.2} {y:.2}L{:.2} {:.2}\"/>\n",
            x + dx,
            y - dy
        ));
    }
    text.push_str("</g>\n");
}

/// The number of each particle at its centre.
fn numbers(text: &mut String, picture: &Picture, map: &Map) {
    text.push_str(
        "<g font-family=\"sans-serif\" text-anchor=\"middle\" dominant-baseline=\"central\">\n",
    );
    for disc in &picture.discs {
        let [x, y] = map.at(disc.at);
        let size = 0.8 * disc.radius * map.scale;
        text.push_str(&format!(
            "<text x=\"{x:.2}\" y=\"{y:.2}\" font-size=\"{size:.2}\">{}</text>\n",
            disc.id
        ));
    }
    text.push_str("</g>\n");
}

/// Radii [m] by the numbers of the discs, ascending.
fn sizes(picture: &Picture) -> Vec<(u32, f64)> {
    let sizes = picture.discs.iter().map(|disc| (disc.id, disc.radius));
    let mut sizes: Vec<_> = sizes.collect();
    sizes.sort_unstable_by_key(|(id, _)| *id);
    sizes
}

/// Ends of the rectangle of a contact [m]: through it, or through the middle of the radius at a wall,
/// along the force on its first body.
fn ends(touch: &Touch, sizes: &[(u32, f64)]) -> [[f64; 2]; 2] {
    let first = sizes.binary_search_by_key(&touch.first, |(id, _)| *id);
    let share = match (touch.second, first) {
        (Some(_), Ok(place)) => sizes[place].1 / touch.length,
        _ => 0.5,
    };
    let [from, to] = touch.ends;
    let middle = [0, 1].map(|k| from[k] + share * (to[k] - from[k]));
    let along = touch.along();
    [-0.5, 0.5].map(|side| [0, 1].map(|k| middle[k] + side * touch.length * along[k]))
}

/// From metres to pixels.
struct Map {
    low: [f64; 2],
    /// Pixels per metre.
    scale: f64,
    /// Of the assembly [pixels].
    size: [f64; 2],
}

impl Map {
    fn of(picture: &Picture) -> Self {
        let [low, high] = picture.bounds;
        let span = [0, 1].map(|k| (high[k] - low[k]).max(1e-300));
        let scale = SIZE / span[0].max(span[1]);
        Self {
            low,
            scale,
            size: span.map(|span| span * scale),
        }
    }

    fn at(&self, x: [f64; 2]) -> [f64; 2] {
        [
            MARGIN + (x[0] - self.low[0]) * self.scale,
            MARGIN + self.size[1] - (x[1] - self.low[1]) * self.scale,
        ]
    }

    /// Length of the scale bar [m]: 1, 2 or 5 times a power of ten, up to a quarter of the width.
    fn bar(&self) -> f64 {
        let most = 0.25 * self.size[0] / self.scale;
        let decade = format!("1e{:.0}", libm::log10(most).floor());
        let decade: f64 = decade.parse().unwrap_or(1.0);
        let lengths = [5.0, 2.0, 1.0].map(|factor| factor * decade);
        lengths
            .into_iter()
            .find(|length| *length <= most)
            .unwrap_or(decade)
    }
}
