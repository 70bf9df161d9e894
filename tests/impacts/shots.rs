//! One sphere shot at a wall of the same material, or at a twin.

use ballast::engine::World;
use ballast::engine::setup::{
    Body, Damping, LawChoice, Material, Setup, TimeStepChoice, WallSetup,
};

use crate::common::{floor, material, moving, scene, world};

/// What is shot at what, and how.
#[derive(Clone)]
pub(crate) struct Shot {
    pub(crate) law: LawChoice,
    pub(crate) body: Body,
    pub(crate) radius: f64,
    pub(crate) young: f64,
    pub(crate) poisson: f64,
    pub(crate) density: f64,
    pub(crate) friction: f64,
    /// Towards the wall and along it [m/s].
    pub(crate) velocity: [f64; 2],
    pub(crate) spin: f64,
    pub(crate) damping: Damping,
    /// Steps while the contact lasts, without damping.
    pub(crate) steps: f64,
    /// Share of the first step that has passed at the touch.
    pub(crate) phase: f64,
    /// Angle by which the whole scene is turned.
    pub(crate) turned: f64,
    /// Against a twin of opposite velocity instead of a wall.
    pub(crate) twin: bool,
    pub(crate) change: fn(&mut Setup),
}

impl Shot {
    /// The thesis' case (Randall 1989, 5.4): a steel sphere of 1 mm at 0.4 m/s, ν = 0.28, μ = 0.12.
    pub(crate) fn thesis(law: LawChoice, angle: f64) -> Self {
        let (s, c) = (angle.to_radians().sin(), angle.to_radians().cos());
        Self {
            law,
            body: Body::Sphere,
            radius: 1e-3,
            young: 210e9,
            poisson: 0.28,
            density: 7800.0,
            friction: 0.12,
            velocity: [0.4 * c, 0.4 * s],
            spin: 0.0,
            damping: Damping::default(),
            steps: 350.0,
            phase: 0.0,
            turned: 0.0,
            twin: false,
            change: |_| (),
        }
    }

    /// E* of two like bodies [Pa].
    pub(crate) fn young_eff(&self) -> f64 {
        self.young / (2.0 * (1.0 - self.poisson * self.poisson))
    }

    /// 2 (1 - ν)/(2 - ν), the ratio of the tangential to the normal stiffness.
    pub(crate) fn kappa(&self) -> f64 {
        2.0 * (1.0 - self.poisson) / (2.0 - self.poisson)
    }

    /// Mass, and I/(M R²).
    pub(crate) fn mass(&self) -> (f64, f64) {
        let r = self.radius;
        match self.body {
            Body::Sphere => (
                4.0 / 3.0 * std::f64::consts::PI * r * r * r * self.density,
                0.4,
            ),
            Body::Disc => (std::f64::consts::PI * r * r * self.density, 0.5),
        }
    }

    /// Largest overlap, largest force and duration of a Hertz impact.
    pub(crate) fn hertz(&self) -> [f64; 3] {
        let (m, _) = self.mass();
        let (m, r) = if self.twin {
            (0.5 * m, 0.5 * self.radius)
        } else {
            (m, self.radius)
        };
        let v = if self.twin {
            2.0 * self.velocity[0]
        } else {
            self.velocity[0]
        };
        let e = self.young_eff();
        let depth = (15.0 * m * v * v / (16.0 * e * r.sqrt())).powf(0.4);
        let force = 4.0 / 3.0 * e * r.sqrt() * depth.powf(1.5);
        // 4/5 B(2/5, 1/2) α/v.
        [depth, force, 2.943_275_179_6 * depth / v]
    }

    /// The world before the impact.
    pub(crate) fn world(&self) -> World {
        let mut setup = scene(Material {
            name: "steel".into(),
            density: self.density,
            young: Some(self.young),
            poisson: Some(self.poisson),
            ..material(1.0, 1.0, self.friction)
        });
        let dt = self.hertz()[2] / self.steps;
        setup.law = self.law;
        setup.body = self.body;
        setup.damping = self.damping;
        setup.time_step = TimeStepChoice::Seconds(dt);
        setup.frac = 1.0;
        let (s, c) = self.turned.sin_cos();
        let turn = |x: [f64; 2]| [c * x[0] - s * x[1], s * x[0] + c * x[1]];
        let r = self.radius;
        let [towards, along] = self.velocity;
        // Down on the floor; touches `phase` of a step after a boundary.
        let gap = towards * dt * (2.0 - self.phase) * if self.twin { 2.0 } else { 1.0 };
        let at = turn([0.0, r + gap]);
        let v = turn([along, -towards]);
        setup.particles = vec![moving(at[0], at[1], r, v, self.spin)];
        if self.twin {
            let at = turn([0.0, -r]);
            let v = turn([-along, towards]);
            setup.particles.push(moving(at[0], at[1], r, v, self.spin));
        } else {
            setup.walls = vec![WallSetup {
                point: [0.0; 2],
                direction: turn([1.0, 0.0]),
                h1: f64::NEG_INFINITY,
                h2: f64::INFINITY,
                ..floor()
            }];
        }
        // The halo has to keep the list still while the contact lasts.
        setup.tol = Some(0.5 * r);
        (self.change)(&mut setup);
        world(setup)
    }

    /// Shoots; answers what came out.
    pub(crate) fn fire(&self) -> Flight {
        let mut world = self.world();
        let mut flight = Flight::default();
        let mut touched = false;
        for _ in 0..(40.0 * self.steps) as usize {
            world.cycle().expect("no fault");
            let now = world
                .contacts()
                .status
                .iter()
                .any(|s| *s != ballast::engine::neighbours::Status::Apart);
            if now {
                let r = world.reaction(0);
                flight.steps += 1;
                flight.largest[0] = flight.largest[0].max(r.normal);
                flight.largest[1] = flight.largest[1].max(r.tangential.abs());
                flight.deepest = flight.deepest.max(world.geometry(0).overlap);
                flight.forces.push([r.normal, r.tangential]);
            }
            if touched && !now {
                break;
            }
            touched |= now;
        }
        world.settle();
        let (v, spin) = world.velocity(0);
        let (s, c) = self.turned.sin_cos();
        flight.v = [c * v[0] + s * v[1], c * v[1] - s * v[0]];
        flight.v = [flight.v[1], flight.v[0]];
        flight.spin = spin;
        flight.dt = world.dt();
        flight.energy_error = world.bookings().map_or(f64::NAN, |b| b.energy_error);
        flight
    }
}

/// What came out of an impact.
#[derive(Debug, Clone, Default)]
pub(crate) struct Flight {
    /// Away from the wall and along it [m/s].
    pub(crate) v: [f64; 2],
    pub(crate) spin: f64,
    /// Steps with contact, and their length [s].
    pub(crate) steps: usize,
    pub(crate) dt: f64,
    /// Largest normal and tangential force [N].
    pub(crate) largest: [f64; 2],
    pub(crate) deepest: f64,
    /// Normal and tangential force in each step of the contact [N].
    pub(crate) forces: Vec<[f64; 2]>,
    pub(crate) energy_error: f64,
}

impl Flight {
    /// Velocity of the surface along the wall [m/s].
    pub(crate) fn slip(&self, radius: f64) -> f64 {
        // The floor lies below: the contact point is at -R in y, and turning forwards moves it on.
        self.v[1] + self.spin * radius
    }
}
