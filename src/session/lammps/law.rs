//! Contact laws in the words of LAMMPS: `pair_style granular`, put together from parts as laws are
//! here, and the older and faster `gran/hertz/history` and `gran/hooke/history`.

use super::misfit::Fit;
use crate::engine::World;
use crate::engine::contact::dashpot::{hertz_restitution_for_fraction, restitution_for_fraction};
use crate::engine::pair::Pair;
use crate::engine::setup::{Body, NormalForm, Unloading};
use crate::record::number::real;

/// How contacts are written.
pub(super) struct Words<'w> {
    world: &'w World,
    linear: bool,
    /// Shear of the law, if contacts with friction have one.
    shear: &'static str,
    /// Means over the contacts that touch.
    means: Means,
}

/// Means over the contacts that touch.
#[derive(Debug, Clone, Copy, Default)]
struct Means {
    /// Effective mass [kg].
    mass: f64,
    /// Viscosity of the normal dashpot over effective mass and, of Hertz, contact radius
    /// [1/s or 1/(m s)].
    gamma: f64,
}

impl<'w> Words<'w> {
    /// Of a world; says what does not fit.
    pub(super) fn new(world: &'w World, fit: &mut Fit) -> Self {
        let model = world.model();
        let plan = world.plan();
        let law = model.law.card().name;
        let linear = model.law.has_constant_springs();
        let partial = law.starts_with("mindlin-deresiewicz") && plan.friction;
        let shear = match (linear, model.unloading) {
            (true, _) => "linear_history",
            (false, Unloading::Keep) if !partial => "mindlin/force",
            _ => "mindlin_rescale/force",
        };
        if partial {
            fit.lacks(
                format!("law {law}: LAMMPS knows no slip inside a contact before all of it slides"),
                "Mindlin's initial stiffness until the whole contact slides (here: law hertz-mindlin)",
            );
        } else if plan.friction {
            fit.maps(format!("law {law}, as tangential {shear}"));
        } else {
            fit.maps(format!("law {law} without friction"));
        }
        if model.normal == NormalForm::Incremental {
            fit.lacks(
                "normal forces summed from increments: LAMMPS takes them from the overlap",
                "normal forces from the overlap",
            );
        }
        if plan.rolling {
            fit.lacks(
                "rolling resistance: its spring of LAMMPS is another one",
                "contacts that do not resist rolling",
            );
        }
        let damping = &model.damping;
        if damping.centred {
            fit.lacks(
                "dashpots that act on the velocity at the boundary",
                "dashpots that act on the velocity of the half step before",
            );
        }
        if damping.overlap_critical.is_some() {
            fit.lacks(
                "critical damping above an overlap",
                "the same damping at any overlap",
            );
        }
        Self {
            world,
            linear,
            shear,
            means: Means::of(world, linear),
        }
    }

    /// `pair_style granular` and its coefficients for all pairs of these materials.
    pub(super) fn granular(&self, kinds: &[usize], fit: &mut Fit) -> String {
        let mut text = "pair_style granular\n".to_owned();
        for (k, &a) in kinds.iter().enumerate() {
            for (l, &b) in kinds.iter().enumerate().skip(k) {
                let pair = self.world.pair_table().get(a, b, false);
                let model = self.model(pair, fit);
                text += &format!("pair_coeff {} {} {model}\n", k + 1, l + 1);
            }
        }
        text
    }

    /// A contact as `pair_coeff` and `fix wall/gran/region granular` take it.
    pub(super) fn model(&self, pair: &Pair, fit: &mut Fit) -> String {
        let (normal, damping) = self.normal(pair, fit);
        let tangential = if pair.is_frictional() {
            if pair.cohesion > 0.0 {
                fit.refuses("cohesion, which widens the limit of friction: LAMMPS has none");
            }
            let stiffness = if self.linear {
                pair.shear_stiffness
            } else {
                8.0 * pair.shear
            };
            format!(
                "{} {} {} {}",
                self.shear,
                real(stiffness),
                real(self.tangential_ratio(pair, fit)),
                real(pair.friction)
            )
        } else {
            "linear_nohistory 0.0 0.0".to_owned()
        };
        let limit = if pair.pull { "" } else { " limit_damping" };
        format!("{normal} tangential {tangential} damping {damping}{limit}")
    }

    fn normal(&self, pair: &Pair, fit: &mut Fit) -> (String, &'static str) {
        let (word, stiffness) = if self.linear {
            ("hooke", pair.normal_stiffness)
        } else {
            ("hertz", 4.0 / 3.0 * pair.young)
        };
        let (b, beta) = (pair.fraction[0], pair.beta[0]);
        let (value, damping) = if b > 0.0 {
            let e = if self.linear {
                restitution_for_fraction(b, true)
            } else {
                hertz_restitution_for_fraction(b, true)
            };
            if e < SMALLEST {
                fit.lacks(
                    format!("damping of {b} of critical, which has no restitution"),
                    format!("damping that gives a restitution of {SMALLEST}"),
                );
            }
            (e.max(SMALLEST), "coeff_restitution")
        } else if beta > 0.0 && self.linear {
            (beta * stiffness, "velocity")
        } else if beta > 0.0 {
            fit.lacks(
                "dashpots in proportion to the stiffness of Hertz: those of LAMMPS are in \
                 proportion to the mass too",
                "damping viscoelastic, the same at the mean effective mass of the contacts now",
            );
            (2.0 * beta * pair.young / self.means.mass, "viscoelastic")
        } else {
            (0.0, "none")
        };
        (
            format!("{word} {} {}", real(stiffness), real(value)),
            damping,
        )
    }

    /// Viscosity of the tangential dashpot over that of the normal one.
    fn tangential_ratio(&self, pair: &Pair, fit: &mut Fit) -> f64 {
        let ([b, bt], [beta, beta_t]) = (pair.fraction, pair.beta);
        if bt == 0.0 && beta_t == 0.0 {
            return 0.0;
        }
        let stiffness = if self.linear {
            pair.shear_stiffness / pair.normal_stiffness
        } else {
            4.0 * pair.shear / pair.young
        };
        if b > 0.0 && bt > 0.0 {
            bt / b * stiffness.sqrt()
        } else if beta > 0.0 && beta_t > 0.0 {
            beta_t / beta * stiffness
        } else {
            fit.lacks(
                "tangential dashpots beside normal ones of another kind, or none",
                "no tangential dashpots",
            );
            0.0
        }
    }

    /// The older styles; they have one set of coefficients for all pairs.
    pub(super) fn classic(&self, kinds: &[usize]) -> Result<String, &'static str> {
        let &[kind] = kinds else {
            return Err("it has one set of coefficients, and there are several materials");
        };
        let pair = self.world.pair_table().get(kind, kind, false);
        let style = if self.linear {
            "gran/hooke/history"
        } else {
            "gran/hertz/history"
        };
        let numbers = self.classic_numbers(pair);
        Ok(format!("pair_style {style} {numbers}\npair_coeff * *\n"))
    }

    /// A contact in the older form: stiffnesses, damping, friction.
    pub(super) fn classic_numbers(&self, pair: &Pair) -> String {
        let (normal, shear) = if self.linear {
            (pair.normal_stiffness, pair.shear_stiffness)
        } else {
            (4.0 / 3.0 * pair.young, 8.0 * pair.shear)
        };
        // The default of the shear damping is half the normal one.
        let friction = if pair.is_frictional() {
            pair.friction
        } else {
            0.0
        };
        let ratio = self.tangential_ratio(pair, &mut Fit::default());
        let gamma = if pair.is_damped() {
            self.means.gamma
        } else {
            0.0
        };
        let damped = u8::from(ratio > 0.0);
        let limit = if pair.pull { "" } else { " limit_damping" };
        format!(
            "{} {} {} {} {} {damped}{limit}",
            real(normal),
            real(shear),
            real(gamma),
            real(gamma * ratio),
            real(friction)
        )
    }

    /// What walls of the older form are called.
    pub(super) fn classic_wall(&self) -> &'static str {
        if self.linear {
            "hooke/history"
        } else {
            "hertz/history"
        }
    }

    /// How the older form differs, for the notes.
    pub(super) fn classic_note(&self) -> &'static str {
        if self.linear {
            "the dashpot is in proportion to the effective mass, not to its root"
        } else {
            "the shear force is 8 G* a times the whole tangential displacement, so that it grows and \
             falls with a; the dashpot is in proportion to effective mass and contact radius"
        }
    }
}

/// Restitution that LAMMPS can take the logarithm of.
const SMALLEST: f64 = 1e-6;

impl Means {
    fn of(world: &World, linear: bool) -> Self {
        let (mut count, mut mass, mut gamma) = (0.0, 0.0, 0.0);
        for k in 0..world.contacts().pairs.len() {
            let (i, other) = world.bodies(k);
            let overlap = -world.gap(i, other);
            if overlap <= 0.0 {
                continue;
            }
            let effective = world.effective(k);
            let c = world.pass().stiffness(k, overlap).c[0];
            let scale = if linear {
                1.0
            } else {
                (effective.radius * overlap).sqrt()
            };
            count += 1.0;
            mass += effective.mass;
            gamma += c / (effective.mass * scale);
        }
        if count > 0.0 {
            return Self {
                mass: mass / count,
                gamma: gamma / count,
            };
        }
        let particles = world.particles();
        let all: f64 = particles.mass.iter().sum();
        Self {
            mass: 0.5 * all / particles.len() as f64,
            gamma: 0.0,
        }
    }
}

/// How masses are written.
pub(super) fn body(world: &World, fit: &mut Fit) {
    match world.model().body {
        Body::Sphere => fit.maps("spheres: mass and inertia from radius and density"),
        Body::Disc => fit.maps(
            "discs of unit length: densities in the data file are those of spheres of the same mass; \
             inertia m R^2/2 by nve/sphere disc",
        ),
    }
}
