//! Contacts in the older form, `gran/hertz/history` and `gran/hooke/history`: faster, and with one set
//! of coefficients for all pairs.

use super::law::Words;
use super::misfit::Fit;
use super::typical::{Partners, Typical};
use crate::record::number::real;

/// Coefficients of a contact in the older form.
struct Numbers {
    normal: f64,
    shear: f64,
    gamma: f64,
    /// Tangential viscosity over the normal one.
    ratio: f64,
    friction: f64,
    limit: &'static str,
}

impl Words<'_> {
    /// The pair style and its coefficients.
    pub(super) fn classic(&self, kinds: &[usize], fit: &mut Fit) -> Result<String, &'static str> {
        let &[kind] = kinds else {
            return Err("it has one set of coefficients, and there are several materials");
        };
        let style = if self.linear {
            "gran/hooke/history"
        } else {
            "gran/hertz/history"
        };
        let partners = Partners {
            a: kind,
            b: kind,
            wall: false,
        };
        let n = self.numbers(partners, fit);
        Ok(format!(
            "pair_style {style} {} {} {} {} {} {}{}\npair_coeff * *\n",
            real(n.normal),
            real(n.shear),
            real(n.gamma),
            real(n.gamma * n.ratio),
            real(n.friction),
            u8::from(n.ratio > 0.0),
            n.limit
        ))
    }

    /// A wall, as the models that the older form stands for: given in its own words, LAMMPS divides the
    /// viscosities by each other, and forces of undamped walls are no numbers.
    pub(super) fn classic_wall(&self, partners: Partners, fit: &mut Fit) -> String {
        let (normal, tangential, damping) = if self.linear {
            ("hooke", "linear_history_classic", "mass_velocity")
        } else {
            ("hertz", "mindlin_classic", "viscoelastic")
        };
        let n = self.numbers(partners, fit);
        format!(
            "granular {normal} {} {} tangential {tangential} {} {} {} damping {damping}{}",
            real(n.normal),
            real(n.gamma),
            real(n.shear),
            real(n.ratio),
            real(n.friction),
            n.limit
        )
    }

    fn numbers(&self, partners: Partners, fit: &mut Fit) -> Numbers {
        let pair = self.pair(partners);
        let (normal, shear) = if self.linear {
            (pair.normal_stiffness, pair.shear_stiffness)
        } else {
            (4.0 / 3.0 * pair.young, 8.0 * pair.shear)
        };
        let rubs = pair.is_frictional();
        Numbers {
            normal,
            shear,
            gamma: self.gamma(partners, fit),
            ratio: if rubs {
                self.tangential_ratio(pair, &mut Fit::default())
            } else {
                0.0
            },
            friction: if rubs { pair.friction } else { 0.0 },
            limit: if pair.pull { "" } else { " limit_damping" },
        }
    }

    fn gamma(&self, partners: Partners, fit: &mut Fit) -> f64 {
        if !self.pair(partners).is_damped() {
            return 0.0;
        }
        let typical = Typical::of(self.world, partners, self.linear);
        if !typical.touches {
            let who = if partners.wall {
                "some walls touch no particle now"
            } else {
                "no particles touch each other now"
            };
            let overlap = if self.linear {
                ""
            } else {
                ", with an overlap of a thousandth of the effective radius"
            };
            fit.differs(format!(
                "{who}: the dashpot of `law.classic` is right for a contact of particles of mean mass \
                 and radius{overlap}"
            ));
        }
        typical.gamma
    }

    /// How the older form differs, for the notes.
    pub(super) fn classic_note(&self) -> &'static str {
        if self.linear {
            "the dashpot is in proportion to the effective mass, not to its root, and right in the mean \
             of the contacts that touch now"
        } else {
            "the shear force is 8 G* a times the whole tangential displacement, so that it grows and \
             falls with a; the dashpot is in proportion to effective mass and contact radius, and right in \
             the mean of the contacts that touch now"
        }
    }
}
