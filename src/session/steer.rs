//! Commands for servos, and their place in a run.

use super::figure::figure;
use super::{Refusal, Session, change};
use crate::control::{Component, EVERY, Growth, Servo, Target, WallGoal, WallServo};
use crate::engine::boundary::{Boundary, Ring};
use crate::language::Command;
use crate::language::command::{Imposed, ServoGoal, WallChange};
use crate::measure::region::Shape;

impl Session {
    /// Steers what is steered, before a cycle.
    pub(super) fn steer(&mut self) {
        self.control.steer(&mut self.world, &self.scene.regions);
    }

    /// Commands that change the world, servos included: what moves a boundary or a wall as told ends
    /// what steered it.
    pub(super) fn change_world(&mut self, command: &Command) -> Result<String, Refusal> {
        match command {
            Command::Servo(None) => {
                self.control.release(&mut self.world);
                Ok("no servo".into())
            }
            Command::Servo(Some(goal)) => Ok(self.set_servo(goal)),
            Command::Grow(None) => {
                self.control.growth = None;
                Ok("the radii stay as they are".into())
            }
            Command::Grow(Some(grow)) => {
                let cycle = self.world.cycle_number();
                if grow.over == 0 {
                    self.control.growth = None;
                    self.world.scale_radii(grow.factor);
                } else {
                    self.control.growth = Some(Growth::new(grow.factor, cycle, grow.over));
                }
                Ok(command.to_string())
            }
            Command::Stress(Imposed { tensor, over }) => {
                self.control.release(&mut self.world);
                if self.world.load_boundary(*tensor, *over) {
                    return Ok("the ring carries the stress".into());
                }
                self.world.set_strain_rate([[0.0; 2]; 2], 0);
                Ok(self.set_servo(&ServoGoal {
                    goals: Component::WHOLE
                        .map(|part| (part, part.of(tensor)))
                        .to_vec(),
                    over: *over,
                    gain: 1.0,
                }))
            }
            Command::Wall(name, WallChange::Servo { force, over, gain }) => {
                let cycle = self.world.cycle_number();
                let target = Target::new(self.pressed(name), *force, cycle, *over);
                Ok(self.set_wall_servo(name, WallGoal::Normal(target), *gain))
            }
            Command::Wall(name, WallChange::Force { force, gain }) => {
                Ok(self.set_wall_servo(name, WallGoal::Force(*force), *gain))
            }
            other => {
                match other {
                    Command::Boundary(_) => self.control.release(&mut self.world),
                    Command::Wall(name, WallChange::Velocity(_) | WallChange::Delete) => {
                        self.control.release_wall(name);
                    }
                    _ => {}
                }
                change::world(&mut self.world, other)
            }
        }
    }

    fn set_servo(&mut self, goal: &ServoGoal) -> String {
        let cycle = self.world.cycle_number();
        self.world.settle();
        let shape = self.scene.regions.first();
        let now = Servo::measured(&self.world, shape.map_or(Shape::All, |region| region.shape));
        let target = |&(part, value): &(Component, f64)| {
            // Without contacts there is no stress to come from.
            let from = Some(part.of(&now)).filter(|from| from.is_finite());
            (
                part,
                Target::new(from.unwrap_or(0.0), value, cycle, goal.over),
            )
        };
        let goals = goal.goals.iter().map(target).collect();
        let ring = self.world.boundary().and_then(Boundary::ring);
        if ring.is_some_and(Ring::is_loaded) {
            // What carried a stress is moved from now on.
            self.world.set_strain_rate([[0.0; 2]; 2], 0);
        }
        self.control.servo = Some(Servo::new(goals, goal.gain));
        format!("servo {goal}")
    }

    fn set_wall_servo(&mut self, name: &str, goal: WallGoal, gain: f64) -> String {
        self.control.release_wall(name);
        self.control.walls.push(WallServo::new(name, goal, gain));
        let mut said = format!(
            "wall {name} is steered; the particles press with {} N",
            figure(self.pressed(name))
        );
        let found = self.world.walls().iter().position(|wall| wall.name == name);
        let highest = found.and_then(|w| WallServo::highest_gain(&self.world, w));
        if let Some(highest) = highest.filter(|highest| gain > *highest) {
            said += &format!(
                "; a gain above {} is no faster: a servo looks every {EVERY} cycles",
                figure(highest)
            );
        }
        said
    }

    /// Normal force on a wall now [N].
    fn pressed(&self, name: &str) -> f64 {
        let found = self.world.walls().iter().position(|wall| wall.name == name);
        found.map_or(0.0, |w| {
            let force = crate::measure::wall_force::WallForce::of(&self.world, w).force;
            let [e1, e2] = self.world.walls()[w].direction;
            (force[0] * e2 - force[1] * e1).abs()
        })
    }
}
