//! The strongest contacts at each dot of a screen.

use super::sight::{Grid, Place, Sight};

/// Contacts shorter than a dot that are drawn in the same dot.
const BARS: usize = 2;

/// Force [N] and contact.
type Held = (f64, usize);

const NONE: Held = (f64::NEG_INFINITY, usize::MAX);

/// Chooses contacts: all that are larger than a dot, and of smaller ones the strongest at each dot.
#[derive(Debug)]
pub(super) struct Strongest {
    grid: Grid,
    /// Those at each dot, the strongest first.
    held: Vec<[Held; BARS]>,
    always: Vec<usize>,
}

impl Strongest {
    pub(super) fn new(sight: &Sight) -> Self {
        let grid = Grid::new(sight);
        Self {
            held: vec![[NONE; BARS]; grid.count()],
            grid,
            always: Vec::new(),
        }
    }

    /// Takes contact k whatever there is.
    pub(super) fn choose(&mut self, k: usize) {
        self.always.push(k);
    }

    /// Looks at contact k, whose bar reaches so far around this point [m]. Of equal ones the earlier
    /// stays.
    pub(super) fn look(&mut self, k: usize, (middle, half): ([f64; 2], f64), force: f64) {
        match self.grid.place(middle, half) {
            Place::Outside => {}
            Place::Large => self.always.push(k),
            Place::Dot(dot) => {
                let mut rest = (force, k);
                for held in &mut self.held[dot] {
                    if rest.0 > held.0 {
                        std::mem::swap(held, &mut rest);
                    }
                }
            }
        }
    }

    /// Those chosen, ascending.
    pub(super) fn chosen(self) -> Vec<usize> {
        let held = self.held.into_iter().flatten().map(|(_, k)| k);
        let mut chosen = self.always;
        chosen.extend(held.filter(|&k| k != NONE.1));
        chosen.sort_unstable();
        chosen
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_strongest_stay_in_whichever_order_they_come() {
        let forces = [1.0, 5.0, 3.0, 5.0, 0.0, f64::NAN, 4.0];
        let chosen = |order: &[usize]| {
            let sight = Sight {
                dots: [10, 10],
                ..Sight::whole([[0.0, 0.0], [10.0, 10.0]])
            };
            let mut strongest = Strongest::new(&sight);
            for &k in order {
                strongest.look(k, ([3.5, 3.5], 0.1), forces[k]);
            }
            strongest.look(8, ([7.5, 3.5], 0.1), 0.0);
            strongest.look(9, ([3.5, 3.5], 1.0), 0.0);
            strongest.look(10, ([-3.5, 3.5], 1.0), 9.0);
            strongest.chosen()
        };
        assert_eq!(chosen(&[0, 1, 2, 3, 4, 5, 6]), [1, 3, 8, 9]);
        assert_eq!(chosen(&[5, 6, 3, 4, 2, 1, 0]), [1, 3, 8, 9]);
        assert_eq!(chosen(&[0, 2, 4, 6]), [2, 6, 8, 9]);
        assert_eq!(chosen(&[4]), [4, 8, 9]);
    }
}
