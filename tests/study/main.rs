//! Studies: what they say about problems whose error is known in closed form, that they notice a
//! wrong reference, the files they write, and `ballast study` from outside.

mod closed_forms;
mod files;
#[path = "../program/heeding.rs"]
mod heeding;
mod interruption;
mod limits;
#[path = "../program/mod.rs"]
mod program;
mod shell;

use ballast::scene::Scene;
use ballast::study::outcome::Outcome;
use ballast::study::plan::{NoPlan, Plan};

/// Plans the study of a preset with some options `--set`.
fn plan(text: &str, options: &[&str]) -> Result<Plan, NoPlan> {
    let options: Vec<String> = options.iter().map(|option| (*option).to_owned()).collect();
    let scene = Scene::parse("scene", text, &options).unwrap_or_else(|why| panic!("{why}"));
    Plan::of(scene)
}

/// Carries the study of a preset out.
#[track_caller]
fn study(text: &str, options: &[&str]) -> Outcome {
    let plan = plan(text, options).unwrap_or_else(|why| panic!("{why:?}"));
    Outcome::of(plan, 1, &mut |_| true).expect("it runs")
}

/// A disc of radius 1 that starts on the floor with 1 m/s downwards, and bounces for ever.
struct Bounce {
    /// Angular frequency of the disc on its spring [rad/s].
    omega: f64,
    /// The preset's time step [s].
    dt: f64,
}

/// Gravity [m/s²] and speed at the start [m/s].
const G: f64 = 9.81;
const V: f64 = 1.0;

/// The preset's FRAC.
const FRAC: f64 = 0.1;

impl Bounce {
    fn new() -> Self {
        let omega = (1e6 / (1000.0 * std::f64::consts::PI)).sqrt();
        let dt = FRAC * 2.0 / omega;
        Self { omega, dt }
    }

    /// Time on the spring between two flights [s].
    fn contact(&self) -> f64 {
        2.0 * (std::f64::consts::PI - (V * self.omega / G).atan()) / self.omega
    }

    /// Exact height of the centre [m].
    fn height(&self, time: f64) -> f64 {
        let period = self.contact() + 2.0 * V / G;
        let time = time % period;
        if time < self.contact() {
            return 1.0 - self.sunk(self.omega * time, V / self.omega);
        }
        let flight = time - self.contact();
        1.0 + V * flight - 0.5 * G * flight * flight
    }

    /// Overlap at a phase, for an amplitude of the part that the speed at the start makes [m].
    fn sunk(&self, phase: f64, amplitude: f64) -> f64 {
        G / (self.omega * self.omega) * (1.0 - phase.cos()) + amplitude * phase.sin()
    }

    /// Height after so many cycles in contact as the leapfrog has it: its phase advances by
    /// 2 asin(ω dt/2) in a cycle, its speed at the start fits sin of that over dt.
    fn leapfrog(&self, cycles: f64, dt: f64) -> f64 {
        let step = 2.0 * (0.5 * self.omega * dt).asin();
        1.0 - self.sunk(cycles * step, V * dt / step.sin())
    }

    /// Scale of the error [m].
    fn scale(&self) -> f64 {
        V / self.omega
    }

    /// The preset, run for so many cycles; `more` comes behind.
    fn preset(cycles: u64, more: &str) -> String {
        format!(
            "[model]\nbody = \"disc\"\nfrac = {FRAC}\ngravity = [0, -{G}]\n\
             [material.m]\ndensity = 1e3\nnormal_stiffness = 1e6\n\
             [[particle]]\nat = [0, 1]\nradius = 1\nmaterial = \"m\"\nvelocity = [0, -{V}]\n\
             [[wall]]\nname = \"floor\"\nmaterial = \"m\"\nfrom = [-1, 0]\nto = [1, 0]\n\
             [history]\nevery = 1\ncolumns = [\"particle:1:y\"]\n\
             [[stage]]\nname = \"fall\"\nmax_cycles = {cycles}\n{more}"
        )
    }

    /// The same with the exact height at its end as the answer, falsified by `wrong` [m].
    fn answered(&self, cycles: u64, wrong: f64) -> String {
        let exact = self.height(cycles as f64 * self.dt) + wrong;
        let answer = format!(
            "[[answer]]\nto = \"height\"\nwhat = [\"last(particle:1:y)\"]\nvalue = [{exact:?}]\n\
             scale = {:?}\nsource = \"closed form\"\n",
            self.scale()
        );
        Self::preset(cycles, &answer)
    }
}
