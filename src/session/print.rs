//! PRINT: tables of what there is.

use super::Reference;
use crate::engine::World;
use crate::language::command::Printout;

/// The lines of a table.
pub(super) fn table(
    world: &mut World,
    _reference: &Reference,
    what: &Printout,
    _averages: bool,
) -> Vec<String> {
    world.settle();
    vec![format!("{what}")]
}
