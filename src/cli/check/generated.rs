//! What each `[[generate]]` placed.

use super::Report;
use crate::scene::{Generated, Scene, SizeGenerated};
use crate::session::figure::{figure, per_cent};

/// Sizes that are told one by one; of more the extremes are.
const FEW: usize = 8;

/// A line for each table.
pub(super) fn describe(report: &mut Report, scene: &Scene) {
    for generated in &scene.generated {
        let porosity = match generated.porosity {
            Some(porosity) => format!("; porosity {} of the region", per_cent(porosity)),
            None => String::new(),
        };
        let text = format!("{}: {}{porosity}", generated.title, sizes(generated));
        report.line("generated", text);
        report.warnings.extend(generated.shortfall());
    }
}

fn sizes(generated: &Generated) -> String {
    let sizes = &generated.sizes;
    if sizes.len() <= FEW {
        let each: Vec<String> = sizes.iter().map(one).collect();
        return each.join(", ");
    }
    let asked = sizes.iter().map(|size| size.asked).sum::<Option<usize>>();
    let radii = [sizes.last(), sizes.first()].map(|size| size.map_or(0.0, |size| size.radius));
    format!(
        "{} of {} m to {} m",
        of(generated.count(), asked),
        figure(radii[0]),
        figure(radii[1])
    )
}

fn one(size: &SizeGenerated) -> String {
    format!(
        "{} of {} m",
        of(size.placed, size.asked),
        figure(size.radius)
    )
}

fn of(placed: usize, asked: Option<usize>) -> String {
    match asked {
        Some(asked) if asked != placed => format!("{placed} of {asked} particles"),
        _ => format!("{placed} particles"),
    }
}
