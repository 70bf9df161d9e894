//! What a world is built from: plain data, checked by the scene before it gets here.

use serde::{Deserialize, Serialize};

pub use super::boundary::straining::Tensor;
pub use super::contact::laws::LawChoice;

/// What a round particle is: decides mass, moment of inertia and thickness, never the law.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Body {
    /// Cylinder of unit length: m = ρπR², I = mR²/2, thickness 1 m.
    Disc,
    /// Sphere whose centre lies in the plane: m = (4/3)πR³ρ, I = (2/5)mR², thickness = mean diameter.
    Sphere,
}

/// How the normal force follows from the motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum NormalForm {
    /// From the overlap itself.
    Total,
    /// Summed from increments of relative velocity, as printed in 1979: drifts, historical replay only.
    Incremental,
}

/// What a Hertz-Mindlin shear force does while the normal force falls.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Unloading {
    /// It falls with the contact radius.
    Rescale,
    /// It stays, up to the friction limit.
    Keep,
}

/// The step that FRAC multiplies.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum TimeStepChoice {
    /// Rayleigh step with the linear form of α (Randall 1989, (4.33), (4.34)).
    Rayleigh,
    /// Rayleigh step with α from the root of (4.32).
    RayleighExact,
    /// 2 √(m/k) of the lightest particle and the stiffest spring (Cundall & Strack 1979).
    Critical,
    /// A number of seconds.
    Seconds(f64),
}

/// Acceleration that acts on every free particle.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Gravity {
    /// The same everywhere [m/s²].
    Uniform([f64; 2]),
    /// Towards a point with constant magnitude (Randall 1989, 6.4.2).
    Centripetal {
        /// The point [m].
        towards: [f64; 2],
        /// Magnitude [m/s²].
        g: f64,
    },
}

/// Strength of the dashpot at a contact.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Dashpot {
    /// No dashpot.
    None,
    /// Fraction b of critical: c = 2 b √(M* k).
    Fraction(f64),
    /// Stiffness-proportional: c = β k, β in seconds (Cundall & Strack 1979, (28)).
    Beta(f64),
    /// Whatever gives this coefficient of restitution in a normal impact.
    Restitution(f64),
}

/// Damping of the scene.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Damping {
    /// Normal dashpot between particles.
    pub contact: Dashpot,
    /// Normal dashpot between particle and wall; `None`: as `contact`.
    pub wall: Option<Dashpot>,
    /// Tangential dashpot as a fraction of critical; `None`: the law's own default.
    pub tangential: Option<f64>,
    /// Whether the normal dashpot may pull.
    pub pull: bool,
    /// Mass-proportional damping α [1/s] (Cundall & Strack 1979, (34)).
    pub global: f64,
    /// Factor on the velocities in each cycle: 1 none, 0 all (Randall 1989, 6.5.1).
    pub con1: f64,
    /// Cundall's local non-viscous damping: force λ|ΣF| against the velocity.
    pub local: f64,
    /// Whether dashpots act on the velocity at the boundary instead of the half step before it.
    pub centred: bool,
    /// Overlap above which a contact is damped critically, over the smaller diameter (Randall 1989,
    /// 6.4.3).
    pub overlap_critical: Option<f64>,
}

impl Default for Damping {
    fn default() -> Self {
        Self {
            contact: Dashpot::None,
            wall: None,
            tangential: None,
            pull: false,
            global: 0.0,
            con1: 1.0,
            local: 0.0,
            centred: false,
            overlap_critical: None,
        }
    }
}

/// A material. Stiffnesses belong to the linear law, elastic constants to the Hertzian ones.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Material {
    /// Name in the preset.
    pub name: String,
    /// Density [kg/m³].
    pub density: f64,
    /// Young's modulus [Pa].
    pub young: Option<f64>,
    /// Poisson's ratio [-].
    pub poisson: Option<f64>,
    /// Friction coefficient tan φ_μ [-]; a pair uses the smaller.
    pub friction: f64,
    /// Cohesion [N]; a pair uses the smaller.
    pub cohesion: f64,
    /// Pull that a bond bears [N]; a pair uses the smaller.
    pub bond_tension: f64,
    /// Shear that a bond bears without normal force [N]; a pair uses the smaller.
    pub bond_shear: f64,
    /// Normal stiffness [N/m].
    pub normal_stiffness: Option<f64>,
    /// Shear stiffness [N/m].
    pub shear_stiffness: Option<f64>,
    /// Coefficient of rolling friction μ_r [-]; a pair uses the smaller.
    pub rolling_friction: f64,
    /// Infinitely stiff partner (walls).
    pub rigid: bool,
}

/// What a pair of materials does differently from what its two materials imply.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PairOverride {
    /// Indices of the two materials.
    pub materials: [usize; 2],
    /// Friction coefficient [-].
    pub friction: Option<f64>,
    /// Coefficient of rolling friction [-].
    pub rolling_friction: Option<f64>,
    /// Cohesion [N].
    pub cohesion: Option<f64>,
    /// Pull that a bond bears [N].
    pub bond_tension: Option<f64>,
    /// Shear that a bond bears without normal force [N].
    pub bond_shear: Option<f64>,
    /// Coefficient of restitution [-], instead of the scene's contact damping.
    pub restitution: Option<f64>,
    /// Normal stiffness [N/m].
    pub normal_stiffness: Option<f64>,
    /// Shear stiffness [N/m].
    pub shear_stiffness: Option<f64>,
}

/// One particle.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ParticleSetup {
    /// Centre [m].
    pub at: [f64; 2],
    /// Radius [m].
    pub radius: f64,
    /// Index of the material.
    pub material: usize,
    /// Velocity at the start [m/s].
    pub velocity: [f64; 2],
    /// Spin at the start [rad/s], positive counter-clockwise.
    pub spin: f64,
    /// Angle at the start [rad].
    pub angle: f64,
    /// Applied force [N].
    pub force: [f64; 2],
    /// Whether velocity in x, velocity in y and spin are prescribed: they keep their given value.
    pub fixed: [bool; 3],
}

/// One straight wall: the part of a line between two multiples of its direction.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct WallSetup {
    /// Name in the preset.
    pub name: String,
    /// Index of the material.
    pub material: usize,
    /// Point P of the line [m].
    pub point: [f64; 2],
    /// Unit vector along the line.
    pub direction: [f64; 2],
    /// The wall begins at P + h1 e; may be minus infinity [m].
    pub h1: f64,
    /// The wall ends at P + h2 e; may be infinity [m].
    pub h2: f64,
    /// Velocity of the wall [m/s].
    pub velocity: [f64; 2],
    /// Angular velocity about `about` [rad/s].
    pub angular_velocity: f64,
    /// Point the wall turns about [m]; moves with `velocity`.
    pub about: [f64; 2],
}

/// What holds an assembly together from outside.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum BoundarySetup {
    /// A ring of boundary particles: everything outside a circle.
    Ring {
        /// Centre [m]; the imposed strain leaves it where it is.
        centre: [f64; 2],
        /// Radius [m].
        radius: f64,
        /// Whether boundary particles may turn.
        turning: bool,
    },
    /// The walls: they move as lines of the strained plane would.
    Walls {
        /// Point [m] that the imposed strain leaves where it is.
        centre: [f64; 2],
    },
    /// A periodic cell.
    Cell {
        /// Lower left corner [m].
        corner: [f64; 2],
        /// Its two edges [m].
        edges: [[f64; 2]; 2],
    },
}

/// Everything a world is built from.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Setup {
    /// Disc or sphere.
    pub body: Body,
    /// Contact law.
    pub law: LawChoice,
    /// Total or incremental normal force.
    pub normal: NormalForm,
    /// What a Hertz-Mindlin shear force does while the normal force falls.
    pub unloading: Unloading,
    /// Largest number of nodes in the memory of a contact with exact partial slip.
    pub nodes: u8,
    /// Step that `frac` multiplies.
    pub time_step: TimeStepChoice,
    /// Multiple of that step.
    pub frac: f64,
    /// Share of the stability bound that the step keeps to instead.
    pub frac_auto: Option<f64>,
    /// Whether particles can turn.
    pub rotation: bool,
    /// Body force, if any.
    pub gravity: Option<Gravity>,
    /// Damping.
    pub damping: Damping,
    /// Materials, in the order of the preset.
    pub materials: Vec<Material>,
    /// Overrides for pairs of materials.
    pub pairs: Vec<PairOverride>,
    /// Particles, numbered from 1 in this order.
    pub particles: Vec<ParticleSetup>,
    /// Walls, in the order of the preset.
    pub walls: Vec<WallSetup>,
    /// What strain and stress are imposed by, if anything.
    pub boundary: Option<BoundarySetup>,
    /// Strain rate that the boundary imposes from the start [1/s].
    pub strain_rate: Tensor,
    /// Halo within which a pair is listed [m]; `None`: chosen from how far particles move, a tenth of the
    /// smallest radius at first.
    pub tol: Option<f64>,
    /// FRACC is evaluated every so many cycles.
    pub fracc_every: u32,
    /// Whether any overlap is accepted at the start.
    pub overlap_allowed: bool,
    /// Whether energies are booked.
    pub ledger: bool,
}

impl Setup {
    /// What overrides a pair of materials, named in either order; the last that does.
    pub fn pair(&self, [a, b]: [usize; 2]) -> Option<&PairOverride> {
        let same = |pair: &&PairOverride| pair.materials == [a, b] || pair.materials == [b, a];
        self.pairs.iter().rfind(same)
    }

    /// The same without particles and walls, of which there may be many.
    pub(super) fn without_bodies(&self) -> Self {
        Self {
            particles: Vec::new(),
            walls: Vec::new(),
            materials: self.materials.clone(),
            pairs: self.pairs.clone(),
            ..*self
        }
    }
}
