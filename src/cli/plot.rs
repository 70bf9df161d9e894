//! `ballast plot`: pictures without a screen.

use std::path::Path;

use super::output::{complain, print, tell};
use super::run::same;
use super::{BAD_INPUT, FAILED, Plot};
use crate::language::command::{Layers, PictureOf};
use crate::record::checkpoint;
use crate::record::whole_file;
use crate::session::{Refusal, RunError, Session};
use crate::study::plot::{Mark, Table, Wanted, chart};

/// Draws; answers the exit status.
pub(super) fn plot(options: &Plot) -> u8 {
    let drawn = output(options).and_then(|()| match checkpoint_of(options) {
        Some(path) => picture(options, path),
        None => history(options),
    });
    let svg = match drawn {
        Ok(svg) => svg,
        Err(refusal) => {
            complain(&refusal.to_string());
            return BAD_INPUT;
        }
    };
    if options.output.as_os_str() == "-" {
        return print(&svg);
    }
    if let Err(error) = whole_file::write(&options.output, svg.as_bytes()) {
        complain(&error.to_string());
        return FAILED;
    }
    if !options.quiet {
        tell(&format!("wrote {}", options.output.display()));
    }
    0
}

/// Whether the file to write makes sense.
fn output(options: &Plot) -> Result<(), Refusal> {
    let file = &options.output;
    let name = file.display();
    if let Some(input) = options.files.iter().find(|input| same(file, input)) {
        return Err(Refusal::new(
            format!("{} would be both read and written", input.display()),
            "give -o another name",
        ));
    }
    let svg = file
        .extension()
        .is_some_and(|ending| ending.eq_ignore_ascii_case("svg"));
    if svg || file.as_os_str() == "-" || (file.exists() && !file.is_file()) {
        return Ok(());
    }
    Err(Refusal::new(
        format!("-o {name}: pictures are SVG"),
        format!("write -o {}", file.with_extension("svg").display()),
    ))
}

/// The first of the files that is a checkpoint.
fn checkpoint_of(options: &Plot) -> Option<&Path> {
    let found = options.files.iter().find(|path| checkpoint::is_one(path));
    found.map(std::path::PathBuf::as_path)
}

/// What a checkpoint holds.
fn picture(options: &Plot, path: &Path) -> Result<String, Refusal> {
    let name = path.display();
    if options.files.len() > 1 {
        return Err(Refusal::new(
            format!("{name} is a checkpoint, and there are other files"),
            "draw checkpoints one by one; only histories go into one chart",
        ));
    }
    let about_histories = options.x.is_some()
        || !options.y.is_empty()
        || options.stage.is_some()
        || !options.marks.is_empty()
        || options.title.is_some();
    if about_histories {
        return Err(Refusal::new(
            format!(
                "{name} is a checkpoint, and --x, --y, --stage, --marks and --title are about histories"
            ),
            "leave them out for a picture of the assembly, or name the CSV file of the run",
        ));
    }
    let word = options.picture.as_deref().unwrap_or("assembly");
    let of = PictureOf::ALL.into_iter().find(|of| of.word() == word);
    let of = of.unwrap_or(PictureOf::Assembly(Layers::NONE));
    let failed = |error: RunError| {
        let said = error.to_string();
        let (message, remedy) = said
            .rsplit_once("; ")
            .unwrap_or((&said, "name another file"));
        Refusal::new(message, remedy)
    };
    let mut session = Session::resume(path, 1).map_err(failed)?;
    session.picture(of)
}

/// Columns of histories.
fn history(options: &Plot) -> Result<String, Refusal> {
    if let Some(of) = &options.picture {
        return Err(Refusal::new(
            format!("--picture {of} is about checkpoints, and there is none"),
            "name a checkpoint (.ballast), or leave it out",
        ));
    }
    let tables = options.files.iter().map(|path| Table::read(path));
    let tables: Vec<Table> = tables.collect::<Result<_, _>>()?;
    if options.y.is_empty() {
        return Err(Refusal::new(
            "nothing is to be drawn",
            "name columns of the history, for instance --x deviator_strain --y sin_phi",
        ));
    }
    let marks = options.marks.iter().map(|text| Mark::parse(text));
    let marks: Vec<Vec<Mark>> = marks.collect::<Result<_, _>>()?;
    let drawing = chart(
        &tables,
        &Wanted {
            x: options.x.clone().unwrap_or_else(|| "time".into()),
            y: options.y.clone(),
            stage: options.stage.clone(),
            marks: marks.concat(),
            title: options.title.clone(),
        },
    )?;
    drawing.notices.iter().for_each(|notice| tell(notice));
    Ok(drawing.svg)
}
