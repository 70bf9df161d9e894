//! Where panes stand, by the size of the screen.
//!
//! Below 60 x 15 numbers only; then compact, from 110 x 34 normal, from 180 x 50 wide. The prompt
//! has its line at every size.

use ratatui::layout::{Constraint, Layout, Rect};

use super::panes::PaneId;

/// Kind of screen.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Class {
    /// One line of numbers.
    Numbers,
    /// 80 x 24.
    Compact,
    /// 120 x 40.
    Normal,
    /// 200 x 60.
    Wide,
}

/// Where everything stands.
#[derive(Debug, Clone, PartialEq)]
pub struct Arrangement {
    /// Kind of screen.
    pub class: Class,
    /// Status line.
    pub status: Rect,
    /// Panes in the order of their numbers.
    pub panes: Vec<(PaneId, Rect)>,
    /// The last thing said, where the dialogue itself has no pane.
    pub last: Rect,
    /// Prompt.
    pub prompt: Rect,
    /// Line of hints.
    pub hints: Rect,
}

/// The kind of a screen of this size.
pub fn class(width: u16, height: u16) -> Class {
    match (width, height) {
        (w, h) if w < 60 || h < 15 => Class::Numbers,
        (w, h) if w < 110 || h < 34 => Class::Compact,
        (w, h) if w < 180 || h < 50 => Class::Normal,
        _ => Class::Wide,
    }
}

/// Most lines that the last thing said may take below the panes of a screen.
pub fn most_at_bottom(area: Rect) -> u16 {
    (area.height / 4).max(1)
}

/// Arranges a screen; `zoomed` is the one pane that fills it, `last` how many lines the last thing said
/// gets below the panes. A contact that is followed takes the place of the last chart.
pub fn arrange(area: Rect, zoomed: Option<PaneId>, follows: bool, last: u16) -> Arrangement {
    let class = class(area.width, area.height);
    let line = |y: u16| {
        let inside = y < area.height;
        Rect {
            x: area.x,
            y: area.y + y.min(area.height.saturating_sub(1)),
            width: area.width,
            height: u16::from(inside),
        }
    };
    if class == Class::Numbers {
        // Status first, prompt next, then what else fits.
        let last = last.min(area.height.saturating_sub(2));
        let body = Rect {
            y: area.y + area.height.min(1),
            height: area.height.saturating_sub(2 + last),
            ..area
        };
        let prompt = line(area.height.saturating_sub(1));
        let last = Rect {
            y: body.bottom(),
            height: last,
            ..area
        };
        let none = Rect { height: 0, ..area };
        let body_fits = !body.is_empty();
        let pane = zoomed.unwrap_or(PaneId::Numbers);
        return Arrangement {
            class,
            status: if area.height > 1 { line(0) } else { none },
            panes: if body_fits {
                vec![(pane, body)]
            } else {
                Vec::new()
            },
            last,
            prompt,
            hints: none,
        };
    }
    let [status, body, last, prompt, hints] = Layout::vertical([
        Constraint::Length(1),
        Constraint::Min(0),
        Constraint::Length(last),
        Constraint::Length(1),
        Constraint::Length(1),
    ])
    .areas(area);
    let mut panes = match (zoomed, class) {
        (Some(pane), _) => vec![(pane, body)],
        (None, Class::Compact) => compact(body),
        (None, Class::Normal) => normal(body),
        (None, _) => wide(body),
    };
    let is_chart = |(id, _): &(PaneId, Rect)| matches!(id, PaneId::Chart(_));
    if follows
        && zoomed.is_none()
        && let Some(last) = panes.iter().rposition(is_chart)
    {
        panes[last].0 = PaneId::Contact;
    }
    Arrangement {
        class,
        status,
        panes,
        last,
        prompt,
        hints,
    }
}

fn compact(body: Rect) -> Vec<(PaneId, Rect)> {
    // A braille dot is about square: the assembly gets twice as many columns as rows.
    let width = (2 * body.height + 2).min(body.width * 11 / 20);
    let [left, right] =
        Layout::horizontal([Constraint::Length(width), Constraint::Min(0)]).areas(body);
    let [chart, numbers] = Layout::vertical([
        Constraint::Min(0),
        Constraint::Length(8.min(body.height / 2)),
    ])
    .areas(right);
    vec![
        (PaneId::Assembly, left),
        (PaneId::Chart(0), chart),
        (PaneId::Numbers, numbers),
    ]
}

fn normal(body: Rect) -> Vec<(PaneId, Rect)> {
    let [top, bottom] = Layout::vertical([Constraint::Min(0), Constraint::Length(9)]).areas(body);
    let [left, right] = Layout::horizontal([Constraint::Fill(1), Constraint::Fill(1)]).areas(top);
    let [a, b, c] = Layout::vertical([Constraint::Fill(1); 3]).areas(right);
    let [dialogue, rose, monitor] = Layout::horizontal([
        Constraint::Fill(2),
        Constraint::Length(22),
        Constraint::Fill(1),
    ])
    .areas(bottom);
    vec![
        (PaneId::Assembly, left),
        (PaneId::Chart(0), a),
        (PaneId::Chart(1), b),
        (PaneId::Chart(2), c),
        (PaneId::Dialogue, dialogue),
        (PaneId::Rose(0), rose),
        (PaneId::Monitor, monitor),
    ]
}

fn wide(body: Rect) -> Vec<(PaneId, Rect)> {
    let [top, bottom] = Layout::vertical([Constraint::Min(0), Constraint::Length(10)]).areas(body);
    let [left, middle, right] = Layout::horizontal([
        Constraint::Fill(5),
        Constraint::Fill(3),
        Constraint::Length(42),
    ])
    .areas(top);
    let [a, b, c, d] = Layout::vertical([Constraint::Fill(1); 4]).areas(middle);
    let [rose, weighted, monitor] = Layout::vertical([
        Constraint::Fill(5),
        Constraint::Fill(4),
        Constraint::Fill(3),
    ])
    .areas(right);
    let [dialogue, numbers, energy] = Layout::horizontal([
        Constraint::Fill(2),
        Constraint::Fill(1),
        Constraint::Fill(1),
    ])
    .areas(bottom);
    vec![
        (PaneId::Assembly, left),
        (PaneId::Chart(0), a),
        (PaneId::Chart(1), b),
        (PaneId::Chart(2), c),
        (PaneId::Chart(3), d),
        (PaneId::Rose(0), rose),
        (PaneId::Rose(1), weighted),
        (PaneId::Monitor, monitor),
        (PaneId::Dialogue, dialogue),
        (PaneId::Numbers, numbers),
        (PaneId::Energy, energy),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn nothing_overlaps_or_leaves_the_screen(
            width in 0u16..220,
            height in 0u16..70,
            follows in any::<bool>(),
            last in 0u16..16,
        ) {
            let area = Rect::new(0, 0, width, height);
            let a = arrange(area, None, follows, last);
            let mut rects: Vec<Rect> = a.panes.iter().map(|(_, rect)| *rect).collect();
            rects.extend([a.status, a.last, a.prompt, a.hints]);
            rects.retain(|rect| !rect.is_empty());
            for (k, rect) in rects.iter().enumerate() {
                prop_assert_eq!(rect.intersection(area), *rect);
                for other in &rects[..k] {
                    prop_assert!(rect.intersection(*other).is_empty(), "{:?} {:?}", rect, other);
                }
            }
            prop_assert!(height == 0 || a.prompt.height == 1);
        }
    }
}
