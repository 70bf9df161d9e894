//! Names of walls and columns.

use super::definition::Definitions;
use super::mistake::{Mistake, shown};
use crate::measure::columns::{Column, Kind, Partner};
use std::ops::Range;

/// Names that every row of a history has, whatever columns it was asked for.
const ALWAYS_PRESENT: [&str; 3] = ["cycle", "time", "stage"];

/// Longest name that is looked up.
const LONGEST: usize = 200;

/// Whether this can name a wall, a region or a material in a column: a letter, then letters, digits and underscores. Anything else
/// would not survive in `wall:NAME:f1` inside an expression.
pub fn is_name(text: &str) -> bool {
    let mut letters = text.chars();
    letters.next().is_some_and(char::is_alphabetic)
        && letters.all(|c| c.is_alphanumeric() || c == '_')
}

/// Looks a column up. Only names of walls, regions and materials tell upper from lower case.
/// Definitions are no columns, but may be what was meant.
pub fn column(
    text: &str,
    span: Range<usize>,
    definitions: &Definitions,
) -> Result<Column, Mistake> {
    if text.len() > LONGEST {
        let message = format!("{} is no column", shown(text));
        return Err(Mistake::new(message, "names are shorter", span));
    }
    let parts: Vec<&str> = text.split(':').collect();
    let name = match parts.as_slice() {
        [family, body, what] => {
            let (family, what) = (family.to_ascii_lowercase(), what.to_ascii_lowercase());
            format!("{family}:{body}:{what}")
        }
        _ => text.to_ascii_lowercase(),
    };
    if ALWAYS_PRESENT.contains(&name.as_str()) {
        let message = format!("`{name}` is no column to choose");
        let remedy = "every row of a history has cycle, time and stage";
        return Err(Mistake::new(message, remedy, span));
    }
    if parts.len() != 3
        && let Some(form) = form(parts[0])
    {
        let message = format!("{} is no column", shown(text));
        return Err(Mistake::new(message, format!("write it as {form}"), span));
    }
    let column = Column::parse(&name).map_err(|unknown| {
        let remedy = match parts.len() {
            1 if unknown.message.ends_with("is no column") => definitions.near(&name),
            _ => unknown.remedy,
        };
        Mistake::new(unknown.message, remedy, span.clone())
    })?;
    if let Column::Wall(wall, _) | Column::Contact(_, Partner::Wall(wall), _) = &column
        && !is_name(wall)
    {
        return Err(no_wall_name(wall, span));
    }
    let named = match &column {
        Column::Region(region, _) => Some(("region", region)),
        Column::Material(material, _) => Some(("material in a column", material)),
        _ => None,
    };
    if let Some((what, name)) = named.filter(|(_, name)| !is_name(name)) {
        return Err(no_name(what, name, span));
    }
    Ok(column)
}

/// The same for a place where a number is needed.
pub(crate) fn numeric_column(
    text: &str,
    span: Range<usize>,
    definitions: &Definitions,
) -> Result<Column, Mistake> {
    let column = column(text, span.clone(), definitions)?;
    if column.kind() == Kind::Hash {
        let message = format!(
            "`{}` is a hash, which no number can be computed from",
            column.name()
        );
        return Err(Mistake::new(message, "leave it out of expressions", span));
    }
    Ok(column)
}

/// How a family of columns is written.
fn form(family: &str) -> Option<&'static str> {
    match family.to_ascii_lowercase().as_str() {
        "wall" => Some("wall:NAME:f1"),
        "contact" => Some("contact:I-J:n or contact:I-WALL:n"),
        "particle" => Some("particle:I:x or particle:I-J:x"),
        "region" => Some("region:NAME:porosity"),
        "material" => Some("material:NAME:coordination"),
        _ => None,
    }
}

/// A word that cannot name a wall.
pub(crate) fn no_wall_name(wall: &str, span: Range<usize>) -> Mistake {
    no_name("wall", wall, span)
}

pub(crate) fn no_name(what: &str, name: &str, span: Range<usize>) -> Mistake {
    Mistake::new(
        format!("{} cannot name a {what}", shown(name)),
        "a name is a letter followed by letters, digits and `_`",
        span,
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn column(text: &str, span: Range<usize>) -> Result<Column, Mistake> {
        super::column(text, span, &Definitions::default())
    }

    #[test]
    fn case_matters_in_wall_names_only() {
        for (written, canonical) in [
            ("KINETIC", "kinetic"),
            ("Wall:Left:F1", "wall:Left:f1"),
            ("CONTACT:1-2:N", "contact:1-2:n"),
            ("Contact:1-Floor:t", "contact:1-Floor:t"),
            ("PARTICLE:3:VX", "particle:3:vx"),
            ("REGION:Core:SIN_PHI", "region:Core:sin_phi"),
        ] {
            assert_eq!(column(written, 0..1).unwrap().name(), canonical);
        }
    }

    #[test]
    fn wrong_columns_say_what_would_be_right() {
        for (wrong, text) in [
            ("kinetc", "`kinetc` is no column; did you mean `kinetic`?"),
            (
                "wall:left",
                "`wall:left` is no column; write it as wall:NAME:f1",
            ),
            (
                "wall:9:f1",
                "`9` cannot name a wall; a name is a letter followed by letters, digits and `_`",
            ),
            (
                "region:porosity",
                "`region:porosity` is no column; write it as region:NAME:porosity",
            ),
            (
                "region:1:porosity",
                "`1` cannot name a region; a name is a letter followed by letters, digits and `_`",
            ),
            (
                "Time",
                "`time` is no column to choose; every row of a history has cycle, time and stage",
            ),
        ] {
            let mistake = column(wrong, 3..7).unwrap_err();
            assert_eq!(mistake.to_string(), text);
            assert_eq!(mistake.span, 3..7);
        }
        assert!(column(&"x".repeat(1 << 20), 0..1).is_err());
        assert!(numeric_column("state_hash", 0..1, &Definitions::default()).is_err());
        assert!(column("state_hash", 0..1).is_ok());
    }
}
