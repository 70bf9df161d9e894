//! Particles as a data file of LAMMPS (`atom_style sphere`): every number reads back as its own bits.

use std::fmt::Write;

use super::number::real;

/// One particle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Atom {
    /// Its number.
    pub id: u32,
    /// Its type, from 1.
    pub kind: usize,
    /// Radius [m].
    pub radius: f64,
    /// Mass [kg].
    pub mass: f64,
    /// Centre [m].
    pub at: [f64; 2],
    /// Velocity [m/s].
    pub velocity: [f64; 2],
    /// Spin [rad/s].
    pub spin: f64,
}

impl Atom {
    /// The density with which a sphere of this radius has this mass [kg/m³].
    fn density(&self) -> f64 {
        let r = self.radius;
        self.mass / (4.0 / 3.0 * std::f64::consts::PI * r * r * r)
    }
}

/// What the file holds.
#[derive(Debug, Clone, PartialEq)]
pub struct Data {
    /// First line.
    pub title: String,
    /// Lower left and upper right corner of the box [m].
    pub corners: [[f64; 2]; 2],
    /// The box reaches so far below and above the plane [m].
    pub depth: f64,
    /// Number of types.
    pub kinds: usize,
    /// All particles.
    pub atoms: Vec<Atom>,
}

impl Data {
    /// The text of the file.
    pub fn text(&self) -> String {
        // Some hundred characters for each particle.
        let mut text = String::with_capacity(160 * self.atoms.len() + 400);
        let title = self.title.replace(char::is_control, " ");
        let [low, high] = self.corners;
        // A String takes every line.
        let _ = write!(
            text,
            "{title}\n\n{} atoms\n{} atom types\n\n{} {} xlo xhi\n{} {} ylo yhi\n{} {} zlo zhi\n",
            self.atoms.len(),
            self.kinds,
            real(low[0]),
            real(high[0]),
            real(low[1]),
            real(high[1]),
            real(-self.depth),
            real(self.depth)
        );
        text += "\nAtoms # sphere\n\n";
        for atom in &self.atoms {
            let _ = writeln!(
                text,
                "{} {} {} {} {} {} 0",
                atom.id,
                atom.kind,
                real(2.0 * atom.radius),
                real(atom.density()),
                real(atom.at[0]),
                real(atom.at[1])
            );
        }
        text += "\nVelocities\n\n";
        for atom in &self.atoms {
            let _ = writeln!(
                text,
                "{} {} {} 0 0 0 {}",
                atom.id,
                real(atom.velocity[0]),
                real(atom.velocity[1]),
                real(atom.spin)
            );
        }
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_keep_all_their_digits() {
        let atom = Atom {
            id: 7,
            kind: 2,
            radius: 0.1 + 0.2,
            mass: 1.0 / 3.0,
            at: [1e-9, -2.0 / 3.0],
            velocity: [1e-300, 0.0],
            spin: -5.5,
        };
        let data = Data {
            title: "two\nlines".into(),
            corners: [[-1.0, -2.0], [1.0, 2.0]],
            depth: 0.5,
            kinds: 2,
            atoms: vec![atom],
        };
        let text = data.text();
        assert!(text.starts_with("two lines\n\n1 atoms\n2 atom types\n"));
        let row = |after: &str| -> Vec<f64> {
            let (_, rest) = text.split_once(after).expect("the section is there");
            let line = rest.trim_start().lines().next().expect("it has a line");
            let numbers = line.split(' ').map(|word| word.parse().expect("a number"));
            numbers.collect()
        };
        let atoms = row("Atoms # sphere\n");
        assert_eq!(atoms[..3], [7.0, 2.0, 2.0 * atom.radius]);
        assert_eq!(atoms[4..], [1e-9, -2.0 / 3.0, 0.0]);
        let r = 0.5 * atoms[2];
        let mass = 4.0 / 3.0 * std::f64::consts::PI * r * r * r * atoms[3];
        assert!((mass / atom.mass - 1.0).abs() < 4.0 * f64::EPSILON);
        assert_eq!(row("Velocities\n"), [7.0, 1e-300, 0.0, 0.0, 0.0, 0.0, -5.5]);
    }
}
