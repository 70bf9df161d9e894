//! Oblique impacts of a sphere on a half-space, with an integrator of their own.

use ballast::engine::contact::incremental_hertz::{IncrementalHertz, SummedHertz};
use ballast::engine::contact::two_reversals::Reversals;

use crate::ball_1989::Ball;
use crate::memory_diagram::Diagram;
use crate::spheres::{Spheres, moduli};

/// Contact time over α\*/v_n for a Hertzian impact.
const CONTACT_TIME: f64 = 2.943_275;

/// How the normal force comes about.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Form {
    /// From the overlap.
    Total,
    /// Summed, literally.
    Summed,
    /// Summed, the first force from the overlap.
    SummedFromOverlap,
}

/// Who gives the tangential force.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Shear {
    Law,
    Ball,
    Exact,
}

/// One impact.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Impact {
    spheres: Spheres,
    mass: f64,
    /// Normal and tangential velocity of the surface [m/s].
    pub(crate) incoming: [f64; 2],
}

impl Impact {
    /// Randall's section 5.4: R = 1 mm, 0.4 m/s, ν = 0.28, μ = 0.12, at this angle [degrees].
    pub(crate) fn thesis(angle: f64) -> Self {
        let [young_eff, shear_eff] = moduli(210e9, 0.28);
        let angle = angle.to_radians();
        Self {
            spheres: Spheres {
                young_eff,
                shear_eff,
                r_eff: 1e-3,
                friction: 0.12,
            },
            mass: 4.0 / 3.0 * std::f64::consts::PI * 1e-9 * 7800.0,
            incoming: [0.4 * angle.cos(), 0.4 * angle.sin()],
        }
    }

    /// ν = 0.3 and this ψ₁, χ = 1.4412.
    fn maw(psi: f64) -> Self {
        let [young_eff, shear_eff] = moduli(1.0, 0.3);
        let spheres = Spheres {
            young_eff,
            shear_eff,
            r_eff: 1.0,
            friction: 0.1,
        };
        Self {
            spheres,
            mass: 1.0,
            incoming: [1e-3, 1e-3 * psi * spheres.friction * spheres.kappa()],
        }
    }

    fn chi(&self) -> f64 {
        1.75 / self.spheres.kappa()
    }

    /// ψ of a velocity over the normal impact velocity.
    fn psi(&self, v_t: f64) -> f64 {
        v_t / (self.incoming[0] * self.spheres.friction * self.spheres.kappa())
    }

    pub(crate) fn outgoing(&self, steps: usize, phase: f64, form: Form) -> [f64; 2] {
        self.run(steps, phase, form, Shear::Law)
    }

    /// Velocities afterwards, in this many steps per contact; the phase says how far before the
    /// touch, in steps, the sphere starts.
    fn run(&self, steps: usize, phase: f64, form: Form, shear: Shear) -> [f64; 2] {
        let pair = &self.spheres;
        let [mut v_n, mut v_t] = self.incoming;
        let deepest = (1.25 * self.mass * v_n * v_n / pair.load(1.0)).powf(0.4);
        let dt = CONTACT_TIME * deepest / v_n / steps as f64;
        let law = pair.law();
        let summed = IncrementalHertz::new(pair.young_eff, pair.r_eff);
        let (mut memory, mut sum) = (Reversals::default(), SummedHertz::default());
        let mut ball = Ball::new(*pair, &[]);
        let mut diagram = Diagram::new(*pair);
        let mut x = -phase * v_n * dt;
        let mut touched = false;
        loop {
            x += v_n * dt;
            if x <= 0.0 && touched {
                break;
            }
            let overlap = match form {
                _ if x <= 0.0 => 0.0,
                Form::Total => x,
                Form::SummedFromOverlap if !touched => {
                    sum = SummedHertz::new(pair.load(x));
                    x
                }
                _ => {
                    summed.sum(v_n * dt, &mut sum);
                    summed.depth(&sum)
                }
            };
            touched |= x > 0.0;
            if touched && overlap <= 0.0 {
                break;
            }
            let d = v_t * dt;
            let force = match shear {
                _ if overlap <= 0.0 => 0.0,
                Shear::Law => law.advance(overlap, d, &mut memory).force,
                Shear::Ball => ball.advance(overlap, d),
                Shear::Exact => diagram.advance(overlap, d),
            };
            v_n -= pair.load(overlap) / self.mass * dt;
            // The surface of a sphere, whose spin adds 5/2.
            v_t -= 3.5 * force / self.mass * dt;
        }
        [v_n, v_t]
    }
}

/// ψ₁ and ψ₂ of the corrected law (χ = 1.4412), to which an independent program of it converges.
const ROW: [(f64, f64); 16] = [
    (0.05, 0.0247),
    (0.25, 0.1215),
    (0.5, 0.1747),
    (0.75, 0.1598),
    (1.0, 0.0859),
    (1.2, -0.0636),
    (1.5, -0.3542),
    (2.0, -0.8095),
    (2.5, -1.1572),
    (3.0, -1.3797),
    (3.5, -1.4773),
    (4.0, -1.4365),
    (4.5, -1.2176),
    (4.7647, -1.0),
    (5.7647, 0.0),
    (8.0, 2.2353),
];

#[test]
fn oblique_impacts_give_the_known_row() {
    for (steps, band) in [(350, 2e-3), (3500, 2e-4)] {
        for (psi, want) in ROW {
            let impact = Impact::maw(psi);
            let [v_n, v_t] = impact.run(steps, 0.5, Form::Total, Shear::Law);
            let got = -impact.psi(v_t) * impact.incoming[0] / v_n;
            assert!(
                (got - want).abs() < band,
                "{steps} {psi}: {got}, not {want}"
            );
        }
    }
}

#[test]
fn impacts_that_slide_throughout_are_exact() {
    for psi in [4.8, 5.0, 6.0, 10.0, 40.0] {
        let impact = Impact::maw(psi);
        let [v_n, v_t] = impact.run(350, 0.5, Form::Total, Shear::Law);
        let got = -impact.psi(v_t) * impact.incoming[0] / v_n;
        let want = psi - 4.0 * impact.chi();
        assert!((got - want).abs() < 1e-3, "{psi}: {got}, not {want}");
    }
}

/// Root mean square error of v_n and of the centre's v_t over the impact speed, over 17 angles and
/// eight phases.
fn errors(steps: usize, form: Form, shear: Shear, exact: &[f64]) -> [f64; 2] {
    let mut sums = [0.0; 2];
    for (angle, exact) in ANGLES.iter().zip(exact) {
        let impact = Impact::thesis(*angle);
        for phase in 0..8 {
            let [v_n, v_t] = impact.run(steps, (f64::from(phase) + 0.5) / 8.0, form, shear);
            let errors = [
                (v_n + impact.incoming[0]) / 0.4,
                (v_t - exact) / (3.5 * 0.4),
            ];
            for (sum, error) in sums.iter_mut().zip(errors) {
                *sum += error * error;
            }
        }
    }
    sums.map(|sum| (sum / (8.0 * ANGLES.len() as f64)).sqrt())
}

/// From the normal [degrees].
const ANGLES: [f64; 17] = [
    5.0, 10.0, 15.0, 20.0, 25.0, 30.0, 35.0, 40.0, 45.0, 50.0, 55.0, 60.0, 65.0, 70.0, 75.0, 80.0,
    85.0,
];

/// vn_rms and vt_rms of a scheme of the reference.
fn reference(scheme: &str, steps: usize) -> [f64; 2] {
    let mut reader = csv::Reader::from_path("data/reference/tangential_law_errors.csv").expect("");
    let rows: Vec<csv::StringRecord> = reader.records().map(|row| row.expect("a row")).collect();
    let row = rows
        .iter()
        .find(|row| &row[0] == scheme && row[2] == *steps.to_string());
    let row = row.expect("the scheme at these steps");
    [3, 5].map(|i| row[i].parse().expect("a number"))
}

#[test]
fn errors_against_the_step_are_those_of_the_reference() {
    let exact =
        ANGLES.map(|angle| Impact::thesis(angle).run(4000, 0.5, Form::Total, Shear::Exact)[1]);
    for (scheme, form) in [("3", Form::Total), ("2", Form::SummedFromOverlap)] {
        for (steps, band) in [
            (10, 0.01),
            (20, 0.01),
            (35, 0.01),
            (100, 0.002),
            (350, 0.001),
        ] {
            let [n, t] = reference(scheme, steps);
            // The tangents of 1989 are what the reference ran.
            let [v_n, v_t] = errors(steps, form, Shear::Ball, &exact);
            assert!((v_n / n - 1.0).abs() < 1e-3, "{scheme} {steps}: {v_n}");
            assert!((v_t / t - 1.0).abs() < band, "{scheme} {steps}: {v_t}");
            // The law goes to the same limit, sooner.
            let [_, v_t] = errors(steps, form, Shear::Law, &exact);
            assert!(v_t < t, "{scheme} {steps}: {v_t}");
            let is_there = (v_t / 1.859e-3 - 1.0).abs() < 0.005;
            assert!(is_there || steps < 100 || scheme == "2", "{steps}: {v_t}");
        }
    }
}

#[test]
fn summed_force_is_that_of_the_printed_scheme() {
    // Its normal force does not depend on the tangential one.
    for steps in [10, 35, 100, 350] {
        let [v_n, _] = errors(steps, Form::Summed, Shear::Law, &[0.0; 17]);
        let [want, _] = reference("0", steps);
        assert!((v_n / want - 1.0).abs() < 1e-3, "{steps}: {v_n}");
    }
}
