//! `ballast bench`: how fast standard scenes run.

use super::aligned::aligned;
use super::output::{complain, print, tell, unopened};
use super::progress::Progress;
use super::sample::with_sample;
use super::{BAD_INPUT, Bench, FAILED};
use crate::measure::columns::nearest;
use crate::record::whole_file;
use crate::scene::Scene;
use crate::session::figure::rough;
use crate::session::{Options, Place, Reached, Session};
use crate::study::bench::{
    Length, Measured, Memory, STANDARD, Standard, csv, find, machine, measure, rows,
};

/// Times them; answers the exit status.
pub(super) fn bench(options: &Bench) -> u8 {
    if options.list {
        let rows: Vec<Vec<String>> = (STANDARD.iter())
            .map(|scene| vec![scene.name.to_owned(), scene.summary.to_owned()])
            .collect();
        return print(&format!("{}\n", aligned(&rows, 1, 1).join("\n")));
    }
    let scenes = match chosen(&options.scenes) {
        Ok(scenes) => scenes,
        Err(status) => return status,
    };
    let length = options
        .cycles
        .map_or(Length::Seconds(options.seconds), Length::Cycles);
    let mut all: Vec<Measured> = Vec::new();
    for standard in scenes {
        let session = opened(standard, usize::from(options.threads), options.quiet);
        let mut session = match session {
            Ok(session) => session,
            Err(status) => return status,
        };
        if !options.quiet {
            tell(&format!("{}: {}", standard.name, standard.summary));
        }
        match measure(standard.name, &mut session, length) {
            Ok(measured) => all.push(measured),
            Err(fault) => {
                complain(&format!("{}: {fault}", standard.name));
                return FAILED;
            }
        }
    }
    // After the scenes: their memory is given back by now.
    let memory = Memory::measured(all.first().map_or(1, |first| first.threads));
    let table = csv(&all, &memory, &machine());
    match &options.csv {
        Some(path) if path.as_os_str() == "-" => {
            return print(&String::from_utf8_lossy(table.bytes()));
        }
        Some(path) => {
            if let Err(error) = whole_file::write(path, table.bytes()) {
                complain(&error.to_string());
                return FAILED;
            }
        }
        None => {}
    }
    let gigabytes = rough(1e-9 * memory.copy);
    let mut text = format!("{}; a copy in memory: {gigabytes} GB/s\n\n", machine());
    let rows = rows(&all, &memory);
    text += &aligned(&rows, 3, rows[0].len()).join("\n");
    text += "\n\nrates are in wall time; busy: share of it with a processor for each thread, 1 on a quiet machine; updates \
             are of touching contacts; list lasts: cycles until pairs are looked for again; MB/cycle: what a cycle has to \
             read and write at least, and of copy: how near that comes to a copy of memory, for scenes that the caches \
             do not hold\n";
    print(&text)
}

/// The scenes of these names; none: all but the large ones.
fn chosen(names: &[String]) -> Result<Vec<&'static Standard>, u8> {
    if names.is_empty() {
        return Ok(STANDARD.iter().filter(|scene| !scene.large).collect());
    }
    let known = || STANDARD.iter().map(|scene| scene.name);
    let scenes = names.iter().map(|name| {
        find(name).ok_or_else(|| {
            complain(&format!(
                "there is no standard scene `{name}`; {}",
                nearest(name, known())
            ));
            BAD_INPUT
        })
    });
    scenes.collect()
}

/// A standard scene where its clock starts; or the exit status.
pub(super) fn opened(standard: &Standard, threads: usize, quiet: bool) -> Result<Session, u8> {
    let set: Vec<String> = standard.set.iter().map(|set| (*set).to_owned()).collect();
    let scene = Scene::load(standard.preset, &set).map_err(|error| unopened(&error.into()))?;
    let place = Place {
        stage: standard.stage.to_owned(),
        cycles: 0,
    };
    let scene = with_sample(scene, threads, quiet)?;
    let how = Options {
        threads,
        expendable: true,
        ..Options::default()
    };
    let mut session = Session::open(scene, how).map_err(|error| unopened(&error))?;
    let mut progress = Progress::new(&session, None, quiet);
    let reached = session.reach(Some(&place), &mut |session| progress.show(session));
    progress.clear();
    match reached.map_err(|error| unopened(&error))? {
        Reached::There => Ok(session),
        Reached::Nowhere(refusal) => {
            complain(&refusal.to_string());
            Err(BAD_INPUT)
        }
    }
}
