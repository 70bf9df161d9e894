//! Where the stress of the default region has been while frames carried it: every point up to a
//! limit, then every second one, and so on.

use crate::session::frames::Frame;

/// Points kept at most.
const MOST: usize = 4096;

/// Stress at a cycle boundary.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StressPoint {
    /// Cycle.
    pub cycle: u64,
    /// Index of the stage.
    pub stage: u32,
    /// Mean of the principal stresses, and major less minor one [Pa].
    pub at: (f64, f64),
}

/// The points, oldest first.
#[derive(Debug, Default)]
pub struct Trail {
    points: Vec<StressPoint>,
}

impl Trail {
    /// Takes what a frame carries of it.
    pub fn take(&mut self, frame: &Frame) {
        let newest = self.points.last().map_or(0, |point| point.cycle);
        let cycle = frame.measures_of;
        if frame.restarted || cycle < newest {
            self.points.clear();
        }
        let Some(tensors) = &frame.survey.tensors else {
            return;
        };
        if cycle == newest && !self.points.is_empty() {
            self.points.pop();
        }
        let stress = &tensors.stress;
        self.points.push(StressPoint {
            cycle,
            stage: frame.stages.0 as u32,
            at: (stress.isotropic(), stress.deviator()),
        });
        if self.points.len() > MOST {
            let mut keep = false;
            self.points.retain(|_| {
                keep = !keep;
                keep
            });
        }
    }

    /// The points.
    pub fn points(&self) -> &[StressPoint] {
        &self.points
    }
}
