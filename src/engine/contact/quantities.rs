//! What laws are told and what they answer: named quantities, no world.

use crate::engine::lanes::Lanes;
use crate::engine::pair::Pair;

/// What a law is told about a touching pair.
#[derive(Clone, Copy)]
pub struct Touch<V: Lanes = f64> {
    /// Whether it touches: what is worked out in other lanes is not used.
    pub touching: V::Mask,
    /// Overlap α > 0 [m].
    pub overlap: V,
    /// Approach velocity along the normal [m/s].
    pub approach: V,
    /// Velocity of the first body's surface relative to the second's, along t [m/s].
    pub slide: V,
    /// Spin of the first body less that of the second [rad/s].
    pub roll: V,
    /// Time step [s].
    pub dt: V,
}

/// Normal load that the tangential and the rolling part are given.
#[derive(Clone, Copy)]
pub struct Load<V = f64> {
    /// Spring force [N].
    pub elastic: V,
    /// Spring and dashpot together [N]: the base of the Coulomb limit.
    pub total: V,
    /// Tangent stiffness of the normal spring [N/m].
    pub stiffness: V,
}

impl<V: Lanes> Load<V> {
    /// Friction limit [N]: μ times the normal force, and cohesion [N]. A dashpot that pulls does not
    /// turn it negative.
    #[inline(always)]
    pub fn limit(&self, friction: V, cohesion: V) -> V {
        (friction * self.total + cohesion).positive()
    }
}

/// What the tangential part answers.
#[derive(Clone, Copy)]
pub struct Shear<V: Lanes = f64> {
    /// Spring force [N].
    pub force: V,
    /// Energy lost in this step by sliding of the whole contact, and by slip within it or with a bond
    /// that broke [J].
    pub loss: [V; 2],
    /// Whether the whole contact slid.
    pub sliding: V::Mask,
    /// Friction limit: what spring and dashpot together may reach [N].
    pub limit: V,
}

/// What the rolling part answers.
#[derive(Clone, Copy)]
pub struct Roll<V = f64> {
    /// Moment on the second body, against the first's excess of spin [N m].
    pub moment: V,
    /// Energy lost by rolling in this step [J].
    pub loss: V,
}

/// What a contact does to its first body: force -n e - T t, moment -M beside that of the force.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Reaction<V: Lanes = f64> {
    /// Normal force [N], compression positive.
    pub normal: V,
    /// Tangential force [N].
    pub tangential: V,
    /// Moment of rolling resistance [N m].
    pub moment: V,
    /// The dashpots' share of the two forces [N].
    pub damping: [V; 2],
    /// Friction beyond the spring's own while sliding: μ times the normal dashpot's share [N].
    pub excess: V,
    /// Energy lost in this step by sliding of the whole contact, rolling included, and by slip
    /// within it [J].
    pub loss: [V; 2],
    /// Whether the contact slid.
    pub sliding: V::Mask,
}

/// Stiffness and viscosity of a contact as it stands, for the stability bound.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Stiffness {
    /// Normal and tangential stiffness [N/m].
    pub k: [f64; 2],
    /// Normal and tangential viscosity [N s/m].
    pub c: [f64; 2],
    /// Rolling stiffness [N m].
    pub rolling: f64,
}

/// What a part of a contact is prepared from, once per pair and rebuild.
#[derive(Debug, Clone, Copy)]
pub struct Basis<'a> {
    /// Parameters of the two materials.
    pub pair: &'a Pair,
    /// Effective mass m1 m2/(m1 + m2) [kg]; a wall or driven partner has infinite mass.
    pub m_eff: f64,
    /// Effective radius R1 R2/(R1 + R2) [m]; that of the particle at a wall.
    pub r_eff: f64,
    /// Overlap above which the contact is damped critically [m]; infinite if never.
    pub critical_above: f64,
    /// Most nodes in the memory of a contact with exact partial slip.
    pub nodes: usize,
    /// Whether energies are booked.
    pub booked: bool,
}

/// A [`Basis`] that owns what it is made of.
pub struct BasisOwned {
    /// Parameters of the two materials.
    pub pair: Pair,
    /// Effective mass [kg].
    pub m_eff: f64,
    /// Effective radius [m].
    pub r_eff: f64,
    /// Overlap above which the contact is damped critically [m].
    pub critical_above: f64,
    /// Most nodes in the memory of a contact with exact partial slip.
    pub nodes: usize,
}

impl BasisOwned {
    pub(super) fn lend(&self, booked: bool) -> Basis<'_> {
        Basis {
            pair: &self.pair,
            m_eff: self.m_eff,
            r_eff: self.r_eff,
            critical_above: self.critical_above,
            nodes: self.nodes,
            booked,
        }
    }
}
