//! Contact laws in the words of LAMMPS: `pair_style granular`, put together from parts as laws are
//! here, and the older and faster `gran/hertz/history` and `gran/hooke/history`.

use super::misfit::Fit;
use super::typical::{Partners, Typical};
use crate::engine::World;
use crate::engine::contact::dashpot::{hertz_restitution_for_fraction, restitution_for_fraction};
use crate::engine::pair::Pair;
use crate::engine::setup::{Body, NormalForm, Unloading};
use crate::record::number::real;

/// How contacts are written.
pub(super) struct Words<'w> {
    pub(super) world: &'w World,
    pub(super) linear: bool,
    /// Shear of the law, if contacts with friction have one.
    shear: &'static str,
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
        if model.law.has_bonds() {
            fit.refuses(
                "law bonded, whose contacts pull: pair_style granular of LAMMPS knows no bonds",
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
        }
    }

    /// `pair_style granular` and its coefficients for all pairs of these materials.
    pub(super) fn granular(&self, kinds: &[usize], fit: &mut Fit) -> String {
        let mut text = "pair_style granular\n".to_owned();
        for (k, &a) in kinds.iter().enumerate() {
            for (l, &b) in kinds.iter().enumerate().skip(k) {
                let wall = false;
                let model = self.model(Partners { a, b, wall }, fit);
                text += &format!("pair_coeff {} {} {model}\n", k + 1, l + 1);
            }
        }
        text
    }

    /// A contact as `pair_coeff` and `fix wall/gran/region granular` take it.
    pub(super) fn model(&self, partners: Partners, fit: &mut Fit) -> String {
        let pair = self.pair(partners);
        let (normal, damping) = self.normal(partners, fit);
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

    /// What the table says of two materials.
    pub(super) fn pair(&self, Partners { a, b, wall }: Partners) -> &'w Pair {
        self.world.pair_table().get(a, b, wall)
    }

    fn normal(&self, partners: Partners, fit: &mut Fit) -> (String, &'static str) {
        let pair = self.pair(partners);
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
            let mass = Typical::of(self.world, partners, false).mass;
            (2.0 * beta * pair.young / mass, "viscoelastic")
        } else {
            // LAMMPS does not run without a model of damping.
            (0.0, "velocity")
        };
        (
            format!("{word} {} {}", real(stiffness), real(value)),
            damping,
        )
    }

    /// Viscosity of the tangential dashpot over that of the normal one.
    pub(super) fn tangential_ratio(&self, pair: &Pair, fit: &mut Fit) -> f64 {
        let ([b, bt], [beta, beta_t]) = (pair.fraction, pair.beta);
        if bt == 0.0 && beta_t == 0.0 {
            return 0.0;
        }
        let stiffness = if self.linear {
            pair.shear_stiffness / pair.normal_stiffness
        } else {
            4.0 * pair.shear / pair.young
        };
        let ratio = if b > 0.0 && bt > 0.0 {
            bt / b * stiffness.sqrt()
        } else if beta > 0.0 && beta_t > 0.0 {
            beta_t / beta * stiffness
        } else {
            fit.lacks(
                "tangential dashpots beside normal ones of another kind, or none",
                "no tangential dashpots",
            );
            return 0.0;
        };
        fit.differs(RUBBING);
        ratio
    }
}

/// Where tangential dashpots of LAMMPS are others.
const RUBBING: &str = "tangential dashpots where spring and dashpot together exceed friction: both \
    programs give mu N, but LAMMPS then takes the dashpot off the spring that it remembers, while here \
    the dashpot gives way and the spring keeps its displacement. At the first step of a run LAMMPS \
    remembers no spring yet: a contact whose dashpot alone exceeds friction has no tangential force at \
    all there, and mu N here";

/// Restitution that LAMMPS can take the logarithm of.
const SMALLEST: f64 = 1e-6;

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
