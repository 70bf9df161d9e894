//! Redundancy: how many contact forces there are for each equation of equilibrium (Cundall & Strack
//! 1983; Thornton 2015, ch. 7). Above 1 an assembly could lose contacts and still stand; at 1 it is
//! isostatic and begins to yield as a whole.
//!
//! A contact whose friction is not used up carries two unknown forces, one that slides or has no
//! friction only its normal force; where rolling is resisted there is a moment too, rolling or not. A
//! particle has an equation for every direction in which it is free
//! to move and one for its spin where anything can turn it. Rattlers, free particles with no contact
//! or with one, are left out, and their contacts with them: they bear nothing.

use super::assembly::degrees;
use super::link::Link;
use super::tensor::ratio;
use crate::engine::World;

/// Unknowns and equations of a region. Contacts at its edge count by half.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Redundancy {
    /// Forces at contacts.
    pub unknowns: f64,
    /// Equations of the particles inside.
    pub equations: f64,
}

impl Redundancy {
    /// Counts over the particles marked as inside.
    pub fn of(world: &World, inside: &[bool]) -> Self {
        let degrees = degrees(world);
        let fixed = &world.particles().fixed;
        let is_held = |p: usize| world.particles().is_held(p);
        let bears = |p: usize| degrees[p] > 1 || is_held(p);
        let rolling = world.pass().rolling();
        let turns = world.pass().tangential() && world.model().rotation;
        let mut unknowns = 0.0;
        for link in Link::all(world).filter(Link::is_touching) {
            if bears(link.first) && link.second().is_none_or(bears) {
                let shears = link.frictional && !link.sliding;
                let rolls = rolling && world.pair_of(link.place).resists_rolling();
                let own = 1 + u8::from(shears) + u8::from(rolls);
                unknowns += link.weight(inside) * f64::from(own);
            }
        }
        let own = (0..degrees.len()).filter(|&p| inside[p] && bears(p));
        let equations = own.map(|p| {
            let [x, y, spin] = fixed[p];
            f64::from(u8::from(!x) + u8::from(!y) + u8::from(turns && !spin))
        });
        Self {
            unknowns,
            equations: equations.sum(),
        }
    }

    /// Unknowns over equations.
    pub fn ratio(&self) -> f64 {
        ratio(self.unknowns, self.equations)
    }
}
