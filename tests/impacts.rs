//! Impacts of spheres against closed forms and the exact solution: normal, oblique, damped.
//!
//! Notation of Maw, Barber & Fawcett 1976: χ = (1 + 1/K)/(2k) with I = K M R² and
//! k = E*/(4 G*), ψ = κ V_T/(μ V_N) with κ = 1/k, ψ1 before and ψ2 after the impact.

mod common;

#[path = "impacts/normal.rs"]
mod normal;
#[path = "impacts/oblique.rs"]
mod oblique;
#[path = "impacts/shots.rs"]
mod shots;
#[path = "impacts/sliding.rs"]
mod sliding;
