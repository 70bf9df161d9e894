//! What things look like: theme, markers, what is drawn of the assembly.

use ratatui::style::{Color, Modifier, Style};
use ratatui::symbols::Marker;

/// Which colours may be used. Meaning never hangs on colour alone.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Theme {
    /// Bold, reverse and underline only.
    Mono,
    /// The terminal's own eight colours.
    Colour,
}

/// What the points of a picture are made of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Points {
    /// Two by four dots per cell.
    Braille,
    /// Upper and lower half of a cell.
    HalfBlock,
    /// One character per cell, ASCII only.
    Ascii,
}

/// Which forces are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Chains {
    /// None.
    Off,
    /// Whole contact forces.
    Force,
    /// Tangential share.
    Tangential,
}

/// What is drawn against the reference.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Compared {
    /// Nothing: forces are.
    Off,
    /// Contacts: kept, new, broken.
    Contacts,
    /// Rotations of discs.
    Rotations,
    /// Displacements of discs.
    Displacements,
    /// Ways that contacts have slid.
    Sliding,
}

impl Compared {
    /// The one after it.
    #[must_use]
    pub fn next(self) -> Self {
        match self {
            Self::Off => Self::Contacts,
            Self::Contacts => Self::Rotations,
            Self::Rotations => Self::Displacements,
            Self::Displacements => Self::Sliding,
            Self::Sliding => Self::Off,
        }
    }
}

/// Settings of the picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Look {
    /// Colours.
    pub theme: Theme,
    /// Points.
    pub points: Points,
    /// Force bars.
    pub chains: Chains,
    /// Whether disc outlines are drawn.
    pub discs: bool,
    /// Whether velocities are drawn.
    pub velocities: bool,
    /// What is drawn against the reference, instead of forces.
    pub compared: Compared,
}

/// Roles that a style is asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Role {
    /// Frame of a pane.
    Frame,
    /// Frame of the pane in focus.
    Focus,
    /// Names beside values.
    Label,
    /// Values.
    Value,
    /// Warnings.
    Warning,
    /// The run has failed.
    Failure,
    /// The run goes on.
    Running,
    /// The run stands.
    Paused,
    /// Discs.
    Disc,
    /// Walls and driven discs.
    Wall,
    /// Force bars of class 1 (weakest) to 4.
    Force(u8),
    /// What is selected.
    Selected,
    /// Curves of charts.
    Curve,
    /// A second curve.
    SecondCurve,
    /// Velocities.
    Velocity,
}

impl Look {
    /// The style of a role.
    pub fn style(&self, role: Role) -> Style {
        let plain = Style::new();
        if self.theme == Theme::Mono {
            return match role {
                Role::Focus | Role::Value | Role::Running | Role::Force(3) => {
                    plain.add_modifier(Modifier::BOLD)
                }
                Role::Warning | Role::Paused => plain.add_modifier(Modifier::UNDERLINED),
                Role::Failure | Role::Selected | Role::Force(4) => {
                    plain.add_modifier(Modifier::REVERSED)
                }
                _ => plain,
            };
        }
        match role {
            Role::Frame | Role::Label | Role::Value | Role::Disc => plain,
            Role::Focus => plain.fg(Color::Cyan).add_modifier(Modifier::BOLD),
            Role::Warning | Role::Force(3) => plain.fg(Color::Yellow),
            Role::Failure => plain.fg(Color::Red).add_modifier(Modifier::BOLD),
            Role::Running => plain.fg(Color::Green).add_modifier(Modifier::BOLD),
            Role::Paused => plain.fg(Color::Yellow).add_modifier(Modifier::BOLD),
            Role::Wall | Role::Force(1) => plain.fg(Color::Blue),
            Role::Force(2) => plain.fg(Color::Green),
            Role::Force(_) => plain.fg(Color::Red),
            Role::Selected => plain.add_modifier(Modifier::REVERSED),
            Role::Curve => plain.fg(Color::Cyan),
            Role::SecondCurve | Role::Velocity => plain.fg(Color::Magenta),
        }
    }

    /// The marker that ratatui's charts use.
    pub fn marker(&self) -> Marker {
        match self.points {
            Points::Braille => Marker::Braille,
            Points::HalfBlock => Marker::HalfBlock,
            Points::Ascii => Marker::Custom('*'),
        }
    }
}

/// Settings for this terminal, from the names of its environment.
pub fn from_environment(get: impl Fn(&str) -> Option<String>) -> Look {
    let locale = ["LC_ALL", "LC_CTYPE", "LANG"]
        .iter()
        .find_map(|name| get(name).filter(|v| !v.is_empty()));
    let utf8 = locale.is_some_and(|value| {
        let value = value.to_lowercase();
        value.contains("utf-8") || value.contains("utf8")
    });
    let term = get("TERM").unwrap_or_default();
    let no_colour = get("NO_COLOR").is_some_and(|value| !value.is_empty());
    let dull = no_colour || term == "dumb" || term == "vt100" || term.ends_with("-mono");
    Look {
        theme: if dull { Theme::Mono } else { Theme::Colour },
        points: if utf8 && term != "linux" {
            Points::Braille
        } else {
            Points::Ascii
        },
        chains: Chains::Force,
        discs: true,
        velocities: false,
        compared: Compared::Off,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn with(pairs: &[(&str, &str)]) -> Look {
        from_environment(|name| {
            pairs
                .iter()
                .find(|(key, _)| *key == name)
                .map(|(_, value)| (*value).to_owned())
        })
    }

    #[test]
    fn the_environment_decides() {
        let usual = with(&[("LANG", "en_GB.UTF-8"), ("TERM", "xterm-256color")]);
        assert_eq!(
            (usual.theme, usual.points),
            (Theme::Colour, Points::Braille)
        );
        let posix = with(&[("LANG", "C"), ("TERM", "xterm")]);
        assert_eq!(posix.points, Points::Ascii);
        // LC_ALL overrules LANG.
        let overruled = with(&[("LC_ALL", "C"), ("LANG", "en_GB.UTF-8"), ("NO_COLOR", "1")]);
        assert_eq!(
            (overruled.theme, overruled.points),
            (Theme::Mono, Points::Ascii)
        );
        assert_eq!(
            with(&[("LANG", "C.UTF-8"), ("TERM", "linux")]).points,
            Points::Ascii
        );
    }
}
