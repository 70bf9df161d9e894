//! A servo that adds to the strain rate of the boundary what a stress path needs.
//!
//! Cundall's boundary servo of 1983 (Randall 1989, 4.1): "adjusting the appropriate components of the
//! boundary strain tensor". Mean stress, difference of the direct stresses and shear stress are steered
//! by the isotropic, the deviatoric and the shear part of the strain rate, one direct stress by the strain
//! rate along it, each in proportion to what is missing and to its integral: the latter makes what has
//! to go on, dilation for instance, cost nothing.
//!
//! All of them count on the stress per isotropic strain M = Σ k l²/2V of contacts of stiffness k and
//! length l. A strain along direction 1 alone changes stress 11 by Σ (k n1⁴ + ks n1² n2²) l²/V, where n
//! are the contact normals and ks is the shear stiffness: by (3 + ks/k) M/4 if the normals are isotropic,
//! which is M at most, and by 2 M if all point along 1, at which the time constant is halved and still
//! what waves allow (see `pace`).

use nalgebra::Matrix2;
use serde::{Deserialize, Serialize};

use super::pace::Pace;
use super::{EVERY, Target};
use crate::engine::World;
use crate::engine::boundary::Tensor;
use crate::measure::bearing::Bearing;
use crate::measure::region::{Content, Shape};
use crate::measure::tensor::Principal;

/// Time constant of the integral, in time constants of the servo.
const INTEGRAL: f64 = 4.0;

/// A part of the stress that can be steered.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Component {
    /// (σ11 + σ22)/2.
    Mean,
    /// σ11 - σ22.
    Deviator,
    /// (σ12 + σ21)/2.
    Shear,
    /// σ11.
    S11,
    /// σ22.
    S22,
}

impl Component {
    /// Three that make a whole stress.
    pub const WHOLE: [Self; 3] = [Self::Mean, Self::Deviator, Self::Shear];

    /// Whether a goal for this part and one for the other say too much together, or contradict: two
    /// direct stresses make a mean and a difference, and one of each is a mixture that no strain rate
    /// belongs to alone.
    pub fn excludes(self, other: Self) -> bool {
        let one = |part| matches!(part, Self::S11 | Self::S22);
        let both = |part| matches!(part, Self::Mean | Self::Deviator);
        self == other || (one(self) && both(other)) || (both(self) && one(other))
    }

    /// This part of a stress [Pa].
    pub fn of(self, stress: &Tensor) -> f64 {
        let [[s11, s12], [s21, s22]] = *stress;
        match self {
            Self::Mean => 0.5 * (s11 + s22),
            Self::Deviator => s11 - s22,
            Self::Shear => 0.5 * (s12 + s21),
            Self::S11 => s11,
            Self::S22 => s22,
        }
    }

    /// The strain rate that this part of the stress answers to [1/s].
    fn rate(self, rate: f64) -> Tensor {
        match self {
            Self::Mean => [[rate, 0.0], [0.0, rate]],
            // The stress is a difference of two.
            Self::Deviator => [[0.5 * rate, 0.0], [0.0, -0.5 * rate]],
            Self::Shear => [[0.0, 0.5 * rate], [0.5 * rate, 0.0]],
            Self::S11 => [[rate, 0.0], [0.0, 0.0]],
            Self::S22 => [[0.0, 0.0], [0.0, rate]],
        }
    }
}

/// A servo on the boundary.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Servo {
    /// What is steered, and to what [Pa].
    pub goals: Vec<(Component, Target)>,
    /// 1: as fast as is safe for most assemblies.
    pub gain: f64,
    /// What each goal has missed so far, as a strain rate [1/s].
    missed: Vec<f64>,
}

impl Servo {
    /// Ready to steer.
    pub fn new(goals: Vec<(Component, Target)>, gain: f64) -> Self {
        let missed = vec![0.0; goals.len()];
        Self {
            goals,
            gain,
            missed,
        }
    }

    /// Stress that is steered [Pa]: of a region, or of everything.
    pub fn measured(world: &World, shape: Shape) -> Tensor {
        tensor(&Bearing::of(world, &Content::of(world, shape)).stress)
    }

    pub(super) fn steer(&mut self, world: &mut World, shape: Shape) {
        let cycle = world.cycle_number();
        let content = Content::of(world, shape);
        let bearing = Bearing::of(world, &content);
        let stress = tensor(&bearing.stress);
        let wanted = |target: &Target| target.at(cycle);
        let scale = self
            .goals
            .iter()
            .fold(0.0, |most: f64, (_, target)| most.max(wanted(target).abs()));
        let circle = Principal::of(&bearing.stress);
        let scale = scale.max(circle.centre().abs() + circle.radius());
        let pace = Pace::of(world, &content, bearing.modulus, scale);
        let interval = EVERY as f64 * world.dt();
        let mut rate = [[0.0; 2]; 2];
        for ((component, target), missed) in self.goals.iter().zip(&mut self.missed) {
            let missing = wanted(target) - component.of(&stress);
            let limit = |rate: f64| rate.clamp(-pace.fastest, pace.fastest);
            let share = if pace.modulus > 0.0 && pace.time.is_finite() {
                // A servo cannot be faster than it looks.
                let time = (pace.time / self.gain).max(2.0 * interval);
                let proportional = missing / (pace.modulus * time);
                if proportional.abs() < pace.fastest {
                    *missed = limit(*missed + proportional * interval / (INTEGRAL * time));
                }
                limit(proportional + *missed)
            } else {
                // Nothing touches: towards where something may.
                limit(pace.fastest.copysign(missing))
            };
            let part = component.rate(share);
            for (row, more) in rate.iter_mut().zip(part) {
                row[0] += more[0];
                row[1] += more[1];
            }
        }
        world.steer_boundary(rate);
    }
}

fn tensor(stress: &Matrix2<f64>) -> Tensor {
    [
        [stress[(0, 0)], stress[(0, 1)]],
        [stress[(1, 0)], stress[(1, 1)]],
    ]
}
