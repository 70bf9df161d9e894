//! The command line: what can be asked of `ballast` from a shell.
//!
//! Standard output carries data only; progress and messages go to standard error. Exit status: 0
//! done, 1 the run failed with everything recorded so far kept, 2 bad input or usage, 3 `verify`
//! failed, 128 + signal when interrupted with everything saved.

mod aligned;
mod bench;
mod check;
mod crowd;
mod export;
mod instructions;
mod large_pages;
mod lists;
mod misspelt;
mod output;
mod pages;
mod placed;
mod plot;
mod progress;
mod recorded;
mod run;
mod sample;
mod study;
mod values;
mod verify;
mod workbench;

use std::path::PathBuf;
use std::process::ExitCode;

use crate::engine::Isa;
use crate::language::command::PictureOf;
use crate::scene::Seeds;
use crate::session::Place;
use clap::{Args, CommandFactory, Parser, Subcommand};
use values::{cycles, pace, positive, seconds, some_cycles, threads};

pub use large_pages::LargePages;

/// Bad input or usage.
const BAD_INPUT: u8 = 2;
/// The run failed; what was recorded is kept.
const FAILED: u8 = 1;

/// Two-dimensional discrete element simulation of granular material.
#[derive(Debug, Parser)]
#[command(
    name = "ballast",
    version,
    about,
    max_term_width = 100,
    args_conflicts_with_subcommands = true,
    subcommand_precedence_over_arg = true
)]
struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
    #[command(flatten)]
    workbench: Workbench,
    /// Vector instructions: baseline, avx2 or avx512; the widest there are if not given. Results do
    /// not depend on it. The variable BALLAST_ISA says the same
    #[arg(long, value_name = "NAME", global = true)]
    isa: Option<Isa>,
}

/// Options of the workbench, which opens when no command is given.
#[derive(Debug, Args)]
struct Workbench {
    /// Preset to open (embedded name or file), or checkpoint to go on from
    preset: Option<String>,
    /// Override a key of the preset
    #[arg(long = "set", value_name = "KEY=VALUE")]
    set: Vec<String>,
    /// Do not run at once
    #[arg(long)]
    paused: bool,
    /// Frames per second at most
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = positive)]
    fps: Option<f64>,
    /// Kilobytes per second at most
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = positive)]
    kbps: Option<f64>,
    /// Cycles per second at first; 0: as many as possible
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = pace)]
    pace: Option<f64>,
    /// Teletype dialogue: no cursor, no colours
    #[arg(long)]
    plain: bool,
    /// Number of threads [default: as many as suit the scene's size, one processor left to the screen]
    #[arg(long, value_name = "N", value_parser = threads())]
    threads: Option<u16>,
    /// For tests: panic at this cycle
    #[arg(long, value_name = "CYCLE", hide = true)]
    panic_at: Option<u64>,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Run a preset or replay a journal, without a screen
    Run(Run),
    /// Check a preset; print what is modelled, sizes, time step and its limits, memory, time
    Check(Check),
    /// List the embedded presets
    Presets,
    /// Print an embedded preset, ready to be edited
    Show {
        /// Name of the preset
        name: String,
    },
    /// List the contact laws
    Laws,
    /// List the history columns
    Columns,
    /// List the console commands, or explain one
    Commands {
        /// Command to explain
        name: Option<String>,
    },
    /// List the keys of a preset
    Keys,
    /// Run presets against their [[expect]]: PASS, DIFFERS (with the reason) or FAIL
    Verify(Verify),
    /// Run a preset with several time steps and laws: wall time, rates, errors, the Pareto front
    Study(Study),
    /// Draw columns of histories, or a checkpoint, as SVG
    Plot(Plot),
    /// Time standard scenes or presets: contact updates and cycles per second, memory, share of each pass
    Bench(Bench),
    /// Write a scene for another program
    Export {
        #[command(subcommand)]
        to: Export,
    },
    /// Print completions for a shell
    Completions {
        /// bash, zsh, fish, elvish or powershell
        shell: clap_complete::Shell,
    },
    /// Print the manual page
    Man,
}

/// Options of `run`.
#[derive(Debug, Args)]
#[command(override_usage = "ballast run [OPTIONS] <PRESET>\n       \
                            ballast run [OPTIONS] --resume <FILE> [PRESET]")]
struct Run {
    /// Preset (embedded name or file) or journal
    #[arg(required_unless_present = "resume")]
    preset: Option<String>,
    /// Write the history to this file; - is standard output
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
    /// Override a key of the preset, for instance model.frac=0.2
    #[arg(long = "set", value_name = "KEY=VALUE")]
    set: Vec<String>,
    /// Seed of everything random
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    seed: Option<u64>,
    /// Run each seed from A to B, both included, each to files of its own: FILE-seedA.csv and so on;
    /// FILE gets mean, standard deviation, minimum and maximum of every row
    #[arg(
        long,
        value_name = "A..B",
        conflicts_with_all = ["seed"],
        long_help = "Run each seed from A to B, both included, as many at a time as there are \
        --threads (without it, as many as there are processors), each run on one thread.\n\n\
        With --csv FILE.csv each seed has the files it would have alone, under the name \
        FILE-seedK: .csv, .journal, .ballast. FILE.csv holds mean, standard deviation (of one \
        value, n - 1), minimum and maximum of every column over the seeds, row by row: cycle, time \
        (means), stage, row (from 0 in each stage), n (seeds that have this row), then COLUMN:mean, \
        COLUMN:sd, COLUMN:min, COLUMN:max. Where a stage ends later in some seeds, its last rows are \
        those of these seeds alone. A value that is nan does not count. A seed whose run failed or \
        was stopped keeps its own files and is left out of FILE.csv. --csv - prints FILE.csv and writes no other file."
    )]
    seeds: Option<Seeds>,
    /// Number of threads; the result does not depend on it [default: as many as suit the scene's
    /// size; with --seeds as many as there are processors]
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = threads())]
    threads: Option<u16>,
    /// Stop at this cycle
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = cycles)]
    cycles: Option<u64>,
    /// Keep the last checkpoint in this file
    #[arg(long, value_name = "FILE")]
    checkpoint: Option<PathBuf>,
    /// Write the checkpoint every so many seconds [default: 60]
    #[arg(long, value_name = "SECONDS", allow_negative_numbers = true, value_parser = seconds)]
    every: Option<f64>,
    /// Go on from a checkpoint
    #[arg(long, value_name = "FILE")]
    resume: Option<PathBuf>,
    /// Neither use nor keep prepared samples of presets with [start]
    #[arg(long)]
    no_cache: bool,
    /// No progress and no summary
    #[arg(long, short)]
    quiet: bool,
    /// Beginning of the names of files that no option names; set for the runs of an ensemble
    #[arg(skip)]
    stem: Option<String>,
}

/// Options of `check`.
#[derive(Debug, Args)]
struct Check {
    /// Preset (embedded name or file)
    preset: String,
    /// Override a key of the preset
    #[arg(long = "set", value_name = "KEY=VALUE")]
    set: Vec<String>,
}

/// Options of `study`. What is not given is as the table [study] of the preset says.
#[derive(Debug, Args)]
#[command(
    long_about = "Run a preset with several time steps and laws, each over the same simulated \
    time, and print how long each takes and how wrong it is: wall time (median of repeated runs \
    without rows and energies), particle-steps and contact updates per second, the smallest stability \
    bound, whether the run stayed stable, the energy the ledger misses, and the error of what is asked \
    with its order of convergence. Exact answers are taken from [[answer]] or narrow [[expect]], \
    else from the finest run. Writes the numbers as CSV and a picture as SVG."
)]
struct Study {
    /// Preset (embedded name or file)
    preset: String,
    /// Multiples of the time step (FRAC) to run with [default: the preset's, 1/2, 1/4, 1/8 of it]
    #[arg(long, value_name = "X,X,...", value_delimiter = ',', allow_negative_numbers = true, value_parser = positive)]
    frac: Vec<f64>,
    /// Contact laws to run with [default: the preset's]
    #[arg(long, value_name = "LAW,LAW,...", value_delimiter = ',')]
    law: Vec<String>,
    /// Another key to vary, for instance material.disc.friction=0.1,0.3; every combination is run
    #[arg(long, value_name = "KEY=VALUE,VALUE,...")]
    sweep: Vec<String>,
    /// What errors are of: columns, expressions, quantities such as last(kinetic), names of answers
    #[arg(long = "for", value_name = "COLUMN,COLUMN,...")]
    questions: Vec<String>,
    /// Run that the others are compared with [default: the first law with the smallest frac]
    #[arg(long, value_name = "LAW@FRAC")]
    reference: Option<String>,
    /// Mark the fastest run whose error is within this
    #[arg(long, value_name = "ERROR", allow_negative_numbers = true, value_parser = positive)]
    within: Option<f64>,
    /// Search the largest FRAC with which the run neither faults nor gains energy, instead
    #[arg(long, conflicts_with_all = ["frac", "questions", "reference", "within", "output"])]
    stability: bool,
    /// Write STEM.csv and STEM.svg [default: PRESET-study]
    #[arg(long, short, value_name = "STEM")]
    output: Option<PathBuf>,
    /// Override a key of the preset
    #[arg(long = "set", value_name = "KEY=VALUE")]
    set: Vec<String>,
    /// Number of threads
    #[arg(long, value_name = "N", default_value_t = 1, allow_negative_numbers = true, value_parser = threads())]
    threads: u16,
    /// No progress and no messages
    #[arg(long, short)]
    quiet: bool,
}

/// Options of `plot`.
#[derive(Debug, Args)]
#[command(
    override_usage = "ballast plot [OPTIONS] --y <COLUMN,...> -o <FILE.svg> <HISTORY.csv>...\n       \
                      ballast plot [--picture <NAME>] -o <FILE.svg> <CHECKPOINT>",
    long_about = "Draw columns of histories over each other as SVG. The file that `run --seeds` \
    writes about an ensemble gives the mean over the seeds, a band of one standard deviation on both \
    sides, and thin lines along the least and the greatest; rows that not all seeds have are left out. \
    Several files go into one chart with a legend. Units stand at the axes: columns of one axis have \
    one unit. A checkpoint gives a picture of its assembly, or what --picture names."
)]
struct Plot {
    /// Histories, or one checkpoint
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// Write the picture to this file; - is standard output
    #[arg(long, short, value_name = "FILE.svg")]
    output: PathBuf,
    /// Column across [default: time]
    #[arg(long, value_name = "COLUMN")]
    x: Option<String>,
    /// Columns up
    #[arg(long, value_name = "COLUMN,...", value_delimiter = ',')]
    y: Vec<String>,
    /// Only the rows of this stage
    #[arg(long, value_name = "NAME")]
    stage: Option<String>,
    /// A number to compare with; X or Y left empty gives a line. Or a CSV file of them: x,y,label
    #[arg(long, value_name = "X,Y,LABEL", allow_hyphen_values = true)]
    marks: Vec<String>,
    /// Title instead of the names of the columns
    #[arg(long, value_name = "TEXT")]
    title: Option<String>,
    /// Of a checkpoint: assembly, path, mohr, histogram or rose
    #[arg(long, value_name = "NAME", value_parser = PICTURES)]
    picture: Option<String>,
    /// No messages but errors
    #[arg(long, short)]
    quiet: bool,
}

/// Options of `bench`.
#[derive(Debug, Args)]
#[command(
    long_about = "Time standard scenes or presets and print contact updates and cycles per second, memory of each \
    particle and pair, and the share of the time that each part of a cycle takes. Samples are prepared \
    once and kept. Rates are the median of five stretches, in wall time: run it on a quiet machine. \
    A preset is timed from where its last stage begins, its commands issued, or from where --at says. \
    `ballast export lammps SCENE` writes the same standard scene for LAMMPS, and a preset with the same --at."
)]
struct Bench {
    /// Standard scenes, or presets (embedded name or file) [default: the standard scenes but the
    /// large ones]
    scenes: Vec<String>,
    /// List them instead
    #[arg(long)]
    list: bool,
    /// Run each so long [s]
    #[arg(long, value_name = "SECONDS", default_value_t = 2.0, allow_negative_numbers = true, value_parser = seconds)]
    seconds: f64,
    /// Run each so many cycles instead
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = some_cycles)]
    cycles: Option<u64>,
    /// Start the clock at this stage, its commands issued, or so many cycles into it
    #[arg(long, value_name = "STAGE[/CYCLES]", value_parser = Place::parse)]
    at: Option<Place>,
    /// Override a key of each scene
    #[arg(long = "set", value_name = "KEY=VALUE")]
    set: Vec<String>,
    /// Write the numbers as CSV to this file; -: to standard output, instead of the table
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
    /// Number of threads
    #[arg(long, value_name = "N", default_value_t = 1, allow_negative_numbers = true, value_parser = threads())]
    threads: u16,
    /// No progress and no messages
    #[arg(long, short)]
    quiet: bool,
}

/// Programs that scenes are written for.
#[derive(Debug, Subcommand)]
enum Export {
    /// Write a deck that runs in LAMMPS as it is: data file, input script, contact law, README
    Lammps(Lammps),
}

/// Options of `export lammps`.
#[derive(Debug, Args)]
#[command(
    override_usage = "ballast export lammps [OPTIONS] -o <FOLDER> <PRESET>\n       \
                      ballast export lammps [OPTIONS] -o <FOLDER> <CHECKPOINT>",
    long_about = "Write a deck that runs in LAMMPS as it is: data file with every digit, velocities and \
    spins, input script, contact law in two forms, README of what maps and what does not. A preset is \
    written as its first stage begins, its commands issued, or where --at says; a checkpoint as it is. \
    What contacts remember cannot be handed over. What LAMMPS lacks is refused with the reason; \
    --nearest writes what comes nearest and says so."
)]
struct Lammps {
    /// Preset (embedded name or file), standard scene of `bench`, or checkpoint
    preset: String,
    /// Write the files into this folder, which is made if need be
    #[arg(long, short, value_name = "FOLDER")]
    output: PathBuf,
    /// Run up to this stage, its commands issued, or so many cycles into it
    #[arg(long, value_name = "STAGE[/CYCLES]", value_parser = Place::parse)]
    at: Option<Place>,
    /// Write what comes nearest where LAMMPS lacks something
    #[arg(long)]
    nearest: bool,
    /// Override a key of the preset
    #[arg(long = "set", value_name = "KEY=VALUE")]
    set: Vec<String>,
    /// Number of threads
    #[arg(long, value_name = "N", default_value_t = 1, allow_negative_numbers = true, value_parser = threads())]
    threads: u16,
    /// No progress and no messages
    #[arg(long, short)]
    quiet: bool,
}

/// Words for what can be drawn of a checkpoint.
const PICTURES: [&str; 5] = {
    let [a, b, c, d, e] = PictureOf::ALL;
    [a.word(), b.word(), c.word(), d.word(), e.word()]
};

/// Options of `verify`.
#[derive(Debug, Args)]
struct Verify {
    /// Presets (embedded names or files); none: those that take less than ten minutes in all
    ///
    /// Without names, presets are run in the order of `ballast presets` as long as they fit into ten
    /// minutes at the speed of this machine, each counted with all its max_cycles; those left out are
    /// named. A sample that a preset starts from counts too, and is prepared where it is not kept yet,
    /// once for all presets that start from it.
    presets: Vec<String>,
    /// Every embedded preset
    #[arg(long)]
    all: bool,
    /// Write the findings as CSV to this file; -: to standard output, instead of the tables
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
    /// Override a key of every preset
    #[arg(long = "set", value_name = "KEY=VALUE")]
    set: Vec<String>,
    /// Number of threads
    #[arg(long, value_name = "N", default_value_t = 1, allow_negative_numbers = true, value_parser = threads())]
    threads: u16,
}

/// Runs the program.
pub fn main() -> ExitCode {
    let cli = Cli::try_parse();
    let words = std::env::args_os().skip(1);
    if let Some(advice) = misspelt::advice(&cli, words) {
        output::complain(&advice);
        return ExitCode::from(BAD_INPUT);
    }
    let cli = match cli {
        Ok(cli) => cli,
        Err(error) => {
            let status = if error.use_stderr() { BAD_INPUT } else { 0 };
            // Nothing is left to be told when even this cannot be printed.
            drop(error.print());
            return ExitCode::from(status);
        }
    };
    if let Err(refusal) = instructions::choose(&cli) {
        output::complain(&refusal);
        return ExitCode::from(BAD_INPUT);
    }
    let status = match cli.command {
        None => workbench::open(&cli.workbench),
        Some(Command::Run(options)) => run::run(&options),
        Some(Command::Check(options)) => check::check(&options),
        Some(Command::Presets) => lists::presets(),
        Some(Command::Show { name }) => lists::show(&name),
        Some(Command::Laws) => lists::laws(),
        Some(Command::Columns) => lists::columns(),
        Some(Command::Commands { name }) => lists::commands(name.as_deref()),
        Some(Command::Keys) => lists::keys(),
        Some(Command::Verify(options)) => verify::verify(&options),
        Some(Command::Study(options)) => study::study(&options),
        Some(Command::Plot(options)) => plot::plot(&options),
        Some(Command::Bench(options)) => bench::bench(&options),
        Some(Command::Export {
            to: Export::Lammps(options),
        }) => export::lammps(&options),
        Some(Command::Completions { shell }) => pages::completions(shell, &mut Cli::command()),
        Some(Command::Man) => pages::man(Cli::command()),
    };
    ExitCode::from(status)
}
