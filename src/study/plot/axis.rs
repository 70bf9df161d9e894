//! What stands beside the axes.

use super::table::without_told;
use crate::measure::columns::Column;
use crate::session::Refusal;

/// More names than this do not fit beside an axis.
const NAMED: usize = 3;

/// The unit of a column of a history, `-` if it is a bare number; none for a column that a preset
/// made, whose unit is not known.
fn unit(name: &str) -> Option<&'static str> {
    match without_told(name) {
        "time" => Some("s"),
        "cycle" | "row" | "n" => Some("-"),
        name => Column::parse(name).ok().map(|column| column.card().unit),
    }
}

/// The name of an axis of these columns. They must have one unit.
pub(super) fn name(columns: &[String]) -> Result<String, Refusal> {
    let mut known = columns.iter().filter_map(|name| Some((name, unit(name)?)));
    let first = known.next();
    if let Some((first, is)) = first
        && let Some((other, differs)) = known.find(|(_, unit)| *unit != is)
    {
        return Err(Refusal::new(
            format!("`{first}` is in [{is}] and `{other}` in [{differs}]: an axis has one unit"),
            "draw them into a file each",
        ));
    }
    let names = match columns {
        few if few.len() <= NAMED => few.join(", "),
        many => format!("{} columns", many.len()),
    };
    Ok(match first {
        Some((_, unit)) => format!("{names} [{unit}]"),
        None => names,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_those_of_the_columns() {
        let named = |names: &[&str]| {
            let names: Vec<String> = names.iter().map(|&name| name.to_owned()).collect();
            name(&names)
        };
        assert_eq!(named(&["time"]).unwrap(), "time [s]");
        assert_eq!(
            named(&["stress_11:sd", "isotropic_stress"]).unwrap(),
            "stress_11:sd, isotropic_stress [Pa]"
        );
        assert_eq!(named(&["wall:floor:f2"]).unwrap(), "wall:floor:f2 [N]");
        // Of the preset's own columns none is known, and they go with any.
        assert_eq!(named(&["ratio"]).unwrap(), "ratio");
        assert_eq!(named(&["ratio", "sin_phi"]).unwrap(), "ratio, sin_phi [-]");
        let four = ["kinetic", "potential", "rotational", "boundary_work"];
        assert_eq!(named(&four).unwrap(), "4 columns [J]");
        let mixed = named(&["sin_phi", "isotropic_stress"]).unwrap_err();
        assert!(mixed.message.contains("[-] and"), "{mixed}");
    }
}
