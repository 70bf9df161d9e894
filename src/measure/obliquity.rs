//! Obliquity: how much of its friction a contact uses, T/(μ N) from -1 to 1 (Randall 1989, figs 6.18
//! to 6.20). Over touching contacts with friction; cohesion may carry one beyond.

use super::histogram::Histogram;
use super::link::Link;
use super::tensor::ratio;
use crate::engine::World;

/// Bars of the histogram.
const BARS: usize = 20;

/// Obliquities of a region, in the order of the list of contacts.
#[derive(Debug, Clone, PartialEq)]
pub struct Obliquity {
    /// Of each contact: its normal force over the mean of all, T/(μ N), and what it counts for: 1, or
    /// 1/2 at the edge of the region.
    pub contacts: Vec<[f64; 3]>,
}

impl Obliquity {
    /// Looks at the contacts of the particles marked as inside.
    pub fn of(world: &World, inside: &[bool]) -> Self {
        let (mut contacts, mut sum, mut count) = (Vec::new(), 0.0, 0.0);
        for link in Link::all(world).filter(Link::is_touching) {
            let weight = link.weight(inside);
            if weight == 0.0 {
                continue;
            }
            sum += weight * link.normal;
            count += weight;
            let limit = world.pair_of(link.place).friction * link.normal;
            if limit > 0.0 {
                contacts.push([link.normal, link.tangential / limit, weight]);
            }
        }
        let mean = ratio(sum, count);
        for contact in &mut contacts {
            contact[0] /= mean;
        }
        Self { contacts }
    }

    /// Mean of |T|/(μ N): the share of friction in use.
    pub fn mean(&self) -> f64 {
        let contacts = self.contacts.iter();
        let (sum, count) = contacts.fold((0.0, 0.0), |(sum, count), [_, share, weight]| {
            (sum + weight * share.abs(), count + weight)
        });
        ratio(sum, count)
    }

    /// Its histogram.
    pub fn histogram(&self) -> Histogram {
        let contacts = self.contacts.iter();
        let values: Vec<(f64, f64)> = contacts
            .map(|&[_, share, weight]| (share, weight))
            .collect();
        Histogram::of(&values, -1.0, 1.0, BARS)
    }
}
