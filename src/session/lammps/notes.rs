//! The README of a deck.

use super::law::Words;
use super::misfit::Fit;

/// Its text. `no_classic`: why the older form is not written.
pub(super) fn readme(
    title: &str,
    name: &str,
    fit: &Fit,
    words: &Words<'_>,
    no_classic: Option<&str>,
) -> String {
    let classic = no_classic.map_or_else(
        || {
            format!(
                "| `law.classic` | the contact law once more in the older form, which is faster: {} |\n",
                words.classic_note()
            )
        },
        |why| format!("\nThere is no `law.classic`, the older and faster form: {why}.\n"),
    );
    let mut text = format!(
        "# {title}\n\n\
         Made for LAMMPS of 22 July 2025 (package GRANULAR). Run it in this folder:\n\n    \
         lmp -in in.{name}\n    \
         lmp -in in.{name} -var law classic -var steps 100000 -var every 1000\n\n\
         | file | what it holds |\n|---|---|\n\
         | `in.{name}` | the input script; variables: law, steps, every (rows of thermo), skin [m] |\n\
         | `{name}.data` | particles with velocities and spins, every number to its last digit |\n\
         | `law.granular` | the contact law, put together from parts as it is here |\n\
         | `{name}.csv` | particles with the forces on them in Ballast, to compare the first step with |\n\
         {classic}\n\
         ## What is the same\n\n"
    );
    text += &list(fit.maps.iter().map(String::as_str));
    if !fit.misfits.is_empty() {
        text += "\n## What LAMMPS lacks, and what stands in its place\n\n";
        let lines: Vec<String> = (fit.misfits.iter())
            .map(|misfit| {
                let nearest = misfit.nearest.as_deref().unwrap_or("nothing");
                format!("{}. Instead: {nearest}", misfit.what)
            })
            .collect();
        text += &list(lines.iter().map(String::as_str));
    }
    text += "\n## What differs\n\n";
    text += &list(fit.differs.iter().map(String::as_str));
    text += "- stages, conditions, histories and measures are not written: `steps` is the length of the \
             stage it was written in, if it has one\n\
             - compression is negative in LAMMPS' own stress and positive in its `press`; in two \
             dimensions that is a force per length, and `mean_stress` divides it by the thickness\n";
    text
}

fn list<'a>(lines: impl Iterator<Item = &'a str>) -> String {
    let lines: Vec<String> = lines.map(|line| format!("- {line}\n")).collect();
    lines.concat()
}
