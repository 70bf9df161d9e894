//! The strain of a cell, and what steers it or other walls.

use super::misfit::Fit;
use crate::control::Control;
use crate::engine::World;
use crate::engine::boundary::Kind;
use crate::record::number::real;

/// The line that strains the cell, if it is.
pub(super) fn boundary(world: &World, fit: &mut Fit) -> String {
    let mut text = String::new();
    if let Some(boundary) = world.boundary() {
        let rate = boundary.straining.target();
        if rate != boundary.straining.rate() {
            fit.differs("the strain rate is at its end at once: a ramp is not written");
        }
        match &boundary.kind {
            Kind::Cell(cell) => {
                let [a, b] = cell.edges;
                if a[1] != 0.0 || b[0] != 0.0 {
                    fit.refuses("a cell whose edges are not along x and y");
                }
                if rate[0][1] != 0.0 || rate[1][0] != 0.0 {
                    fit.lacks("shear of the cell", "its strain rate in x and y alone");
                }
                fit.maps("periodic cell, with its strain rate as fix deform ... trate ... remap v");
                fit.differs(
                    "velocities are whole there and those beside the flow here: inertia of the flow \
                     itself, of second order in the strain rate, is in LAMMPS alone",
                );
                if rate != [[0.0; 2]; 2] {
                    fit.differs(
                        "LAMMPS gives images of particles the velocity of the straining cell from \
                         its second step on: forces of the first compare in a cell at rest only",
                    );
                    text += &format!(
                        "fix cell all deform 1 x trate {} y trate {} remap v\n",
                        real(-rate[0][0]),
                        real(-rate[1][1])
                    );
                }
            }
            Kind::Walls if rate != [[0.0; 2]; 2] => fit.lacks(
                "walls that move as lines of a strained plane",
                "walls that keep the velocities they have now",
            ),
            Kind::Walls | Kind::Ring(_) => {}
        }
    }
    if world.continuum().is_some() && world.cell().is_none() {
        fit.lacks(
            "a continuum whose flow carries all particles",
            "particles with the velocity it gives them now, and no flow from there on",
        );
    }
    text
}

/// What LAMMPS does not steer.
pub(super) fn steering(control: &Control, fit: &mut Fit) {
    if control.servo.is_some() || !control.walls.is_empty() {
        fit.lacks(
            "servos: LAMMPS steers neither strain rate nor walls by these stresses",
            "what they impose now, from there on",
        );
    }
    if control.growth.is_some() {
        fit.lacks("radii that change", "radii as they are now");
    }
}
