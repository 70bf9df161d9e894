//! Roses: how contact normals are distributed over directions.
//!
//! A normal has no sense, so directions run from 0 to 180 degrees, and a picture repeats them
//! turned by 180. Petals are centred on multiples of their width: the directions of regular
//! packings fall into their middle and not on an edge, where rounding would decide.

use super::link::Link;
use super::region::Content;
use super::tensor::half_turn;
use crate::engine::World;

/// Petals when nothing else is asked for: 10 degrees each.
pub const PETALS: usize = 18;

/// Distribution of the normals of touching contacts in a region; wall contacts count once, contacts
/// at its edge by half.
#[derive(Debug, Clone, PartialEq)]
pub struct Rose {
    /// Contacts per petal.
    pub contacts: Vec<f64>,
    /// Normal force per petal [N].
    pub force: Vec<f64>,
    /// Size of the tangential force per petal [N].
    pub shear: Vec<f64>,
    /// Sliding contacts per petal.
    pub sliding: Vec<f64>,
}

impl Rose {
    /// Sorts the contacts of a region into so many petals.
    ///
    /// # Panics
    /// Without petals.
    pub fn of(world: &World, content: &Content, petals: usize) -> Self {
        assert!(petals > 0, "a rose needs petals");
        let mut rose = Self {
            contacts: vec![0.0; petals],
            force: vec![0.0; petals],
            shear: vec![0.0; petals],
            sliding: vec![0.0; petals],
        };
        let width = 180.0 / petals as f64;
        for link in Link::all(world).filter(Link::is_touching) {
            let weight = link.weight(&content.inside);
            let angle = half_turn(libm::atan2(link.e[1], link.e[0]).to_degrees());
            let petal = (angle / width).round() as usize % petals;
            rose.contacts[petal] += weight;
            rose.force[petal] += weight * link.normal;
            rose.shear[petal] += weight * link.tangential.abs();
            rose.sliding[petal] += weight * f64::from(u8::from(link.sliding));
        }
        rose
    }

    /// Direction of the middle of a petal, in [0, 180) [degrees].
    pub fn direction(&self, petal: usize) -> f64 {
        180.0 * petal as f64 / self.contacts.len() as f64
    }

    /// Petals of the full circle: the given ones, then the same turned by 180 degrees.
    pub fn mirrored(petals: &[f64]) -> Vec<f64> {
        petals.iter().chain(petals).copied().collect()
    }
}
