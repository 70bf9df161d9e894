//! A scene as it is now, written for LAMMPS: data file, input script, the contact law in two forms, and
//! a README of what maps and what does not.
//!
//! What LAMMPS lacks is refused with its reason, or written as what comes nearest where that is asked
//! for. What contacts remember cannot be handed over: they start without shear there.

mod classic;
mod law;
mod misfit;
mod motion;
mod notes;
mod prescribed;
mod strain;
mod typical;
mod walls;

use std::path::Path;

use super::{Refusal, Session, tables};
use crate::engine::World;
use crate::language::command::DumpOf;
use crate::record::error::{Attempt, RecordError};
use crate::record::lammps::{Atom, Data};
use crate::record::number::real;
use crate::record::whole_file;
use law::Words;
use misfit::Fit;

/// Cycles of a deck whose scene names none.
const STEPS: u64 = 10_000;

/// What a deck consists of.
pub struct Deck {
    /// Names and texts.
    pub files: Vec<(String, String)>,
    /// What is worth knowing at once.
    pub notices: Vec<String>,
}

impl Deck {
    /// Writes the files into a folder, which is made if need be.
    pub fn write(&self, folder: &Path) -> Result<(), RecordError> {
        std::fs::create_dir_all(folder)
            .map_err(|error| RecordError::new(folder, Attempt::Create, error))?;
        for (name, text) in &self.files {
            whole_file::write(&folder.join(name), text.as_bytes())?;
        }
        Ok(())
    }
}

impl Session {
    /// The state now for LAMMPS. `nearest`: what it lacks is written as what comes nearest.
    pub fn lammps(&mut self, nearest: bool) -> Result<Deck, Refusal> {
        self.world.settle();
        let world = &self.world;
        if world.particles().is_empty() {
            return Err(Refusal::new(
                "there are no particles to write",
                "export a scene with particles, or at a later stage",
            ));
        }
        let mut fit = Fit::default();
        let kinds = kinds(world);
        let corners = corners(world);
        law::body(world, &mut fit);
        let words = Words::new(world, &mut fit);
        let pairs = words.granular(&kinds, &mut fit);
        let walls = walls::walls(world, &words, &kinds, corners, &mut fit);
        let fixes = motion::fixes(world, &self.control, &mut fit);
        let classic = words.classic(&kinds, &mut fit);
        state(world, &mut fit);
        fit.accept(&self.scene.name, nearest)?;

        let name = plain(&self.scene.name);
        let title = format!(
            "{}, cycle {}, written by ballast {} (SI units)",
            self.scene.name,
            world.cycle_number(),
            env!("CARGO_PKG_VERSION")
        );
        let steps = self.stage_length().unwrap_or(STEPS);
        let script = script(world, &title, &name, steps, &walls.regions, &fixes);
        let notes = notes::readme(&title, &name, &fit, &words, classic.as_ref().err().copied());
        let mut files = vec![
            (
                format!("{name}.data"),
                data(world, &title, &kinds, corners).text(),
            ),
            (format!("in.{name}"), script),
            ("law.granular".into(), pairs + &walls.granular),
        ];
        if let Ok(classic) = classic {
            files.push(("law.classic".into(), classic + &walls.classic));
        }
        files.push(("README.md".into(), notes));
        files.push((format!("{name}.csv"), self.forces()));
        let mut notices: Vec<String> = (fit.misfits.iter())
            .filter_map(|misfit| {
                let nearest = misfit.nearest.as_ref()?;
                Some(format!("{}: written instead: {nearest}", misfit.what))
            })
            .collect();
        notices.extend(memory(&self.world));
        Ok(Deck { files, notices })
    }
}

impl Session {
    /// Particles with the forces on them here, to compare the first step with.
    fn forces(&mut self) -> String {
        let table = tables::all(&self.sample(), DumpOf::Particles);
        String::from_utf8_lossy(table.bytes()).into_owned()
    }
}

/// What contacts remember, which is lost.
fn memory(world: &World) -> Option<String> {
    let (mut sheared, mut touching) = (0, 0);
    for k in 0..world.contacts().len() {
        let [n, t] = world.springs(k);
        touching += usize::from(n > 0.0);
        sheared += usize::from(t != 0.0);
    }
    (sheared > 0).then(|| {
        format!(
            "{sheared} of {touching} contacts carry shear now; LAMMPS cannot be told, they start \
             without: export where nothing rubs yet for the same forces"
        )
    })
}

/// What the state is, for the notes.
fn state(world: &World, fit: &mut Fit) {
    fit.maps("positions, radii, masses, velocities, spins and time step, all to the last digit");
    if let Some(lost) = memory(world) {
        fit.differs(lost);
    } else {
        fit.maps("contacts carry no shear now, so their start without any is the same");
    }
    if world.model().frac_auto.is_some() {
        fit.differs("the time step is the present one: it does not follow the stiffness");
    }
    fit.differs(
        "lever arms between particles: here the branch is split in proportion to the radii, for \
         tangential velocities and moments alike; LAMMPS takes R for the velocities, and for moments \
         R - overlap/2 (granular) or R (classic). At walls all take R",
    );
}

/// Materials that particles are of, by index.
fn kinds(world: &World) -> Vec<usize> {
    let mut kinds: Vec<usize> = (world.particles().material.iter())
        .map(|&kind| usize::from(kind))
        .collect();
    kinds.sort_unstable();
    kinds.dedup();
    kinds
}

/// Lower left and upper right corner of the cell or of the assembly with room around it [m], relative
/// to the origin of the world.
fn corners(world: &World) -> [[f64; 2]; 2] {
    if let Some(cell) = world.cell() {
        let [a, b] = cell.edges;
        let high = [0, 1].map(|k| cell.corner[k] + a[k] + b[k]);
        return [cell.corner, high];
    }
    let [low, high] = world.particles().extent();
    let room = 4.0 * largest(world);
    [low.map(|x| x - room), high.map(|x| x + room)]
}

fn largest(world: &World) -> f64 {
    let rows = world.particles().row.iter();
    rows.fold(0.0, |most: f64, row| most.max(row.radius))
}

fn data(world: &World, title: &str, kinds: &[usize], corners: [[f64; 2]; 2]) -> Data {
    let p = world.particles();
    let origin = world.origin();
    let outer = |x: [f64; 2]| [x[0] + origin[0], x[1] + origin[1]];
    let atom = |k: usize| {
        let (velocity, spin) = world.velocity(k);
        let x = p.row[k].x;
        let kind = kinds.binary_search(&usize::from(p.material[k]));
        let home = world.cell().map_or(x, |cell| cell.home(x));
        // Who comes home from an image leaves the flow between the two behind.
        let (there, here) = (world.flow_at(x), world.flow_at(home));
        Atom {
            id: p.id[k],
            kind: kind.unwrap_or(0) + 1,
            radius: p.row[k].radius,
            mass: p.mass[k],
            at: outer(home),
            velocity: [0, 1].map(|axis| velocity[axis] + (here[axis] - there[axis])),
            spin,
        }
    };
    Data {
        title: title.to_owned(),
        corners: corners.map(outer),
        depth: largest(world),
        kinds: kinds.len(),
        atoms: (0..p.len()).map(atom).collect(),
    }
}

fn script(
    world: &World,
    title: &str,
    name: &str,
    steps: u64,
    regions: &str,
    fixes: &str,
) -> String {
    let boundary = if world.cell().is_some() {
        "p p p"
    } else {
        "m m p"
    };
    let mean = world
        .particles()
        .row
        .iter()
        .map(|row| row.radius)
        .sum::<f64>()
        / world.particles().len() as f64;
    format!(
        "# {title}\n\
         # run in this folder: lmp -in in.{name}\n\
         variable law index granular      # or classic: gran/hertz/history, gran/hooke/history\n\
         variable steps index {steps}\n\
         variable every index {every}\n\
         variable skin index {skin}\n\
         units si\n\
         dimension 2\n\
         boundary {boundary}\n\
         atom_style sphere\n\
         comm_modify vel yes\n\
         newton off\n\
         read_data {name}.data\n\
         {regions}\
         include law.${{law}}\n\
         neighbor ${{skin}} bin\n\
         neigh_modify every 1 delay 0 check yes\n\
         timestep {dt}\n\
         {fixes}\
         compute touching all contact/atom\n\
         compute ends all reduce sum c_touching\n\
         variable contacts equal c_ends/2\n\
         # stress over this thickness [Pa]: in two dimensions press is a force per length\n\
         variable thickness equal {thickness}\n\
         variable mean_stress equal c_thermo_press/v_thickness\n\
         thermo ${{every}}\n\
         thermo_style custom step lx ly press v_mean_stress v_contacts ke\n\
         run ${{steps}}\n",
        every = (steps / 20).max(1),
        skin = real(0.2 * mean),
        dt = real(world.dt()),
        thickness = real(world.thickness()),
    )
}

/// A name that files and shells take.
fn plain(name: &str) -> String {
    let plain = |c: char| if c.is_ascii_alphanumeric() { c } else { '-' };
    name.chars().map(plain).collect()
}
