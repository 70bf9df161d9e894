//! The step that FRAC multiplies.

use super::pair::PairTable;
use super::particles::Particles;
use super::setup::{Setup, TimeStepChoice};

/// Above this a cycle's largest FRACC is a warning (Randall 1989, 4.5.1).
pub const FRACC_WARNING: f64 = 0.3;

/// Base step [s]; infinite when nothing limits it.
pub fn base(setup: &Setup, pairs: &PairTable, particles: &Particles, walls: &[usize]) -> f64 {
    match setup.time_step {
        TimeStepChoice::Seconds(seconds) => seconds,
        TimeStepChoice::Critical => critical(pairs, particles, walls),
        TimeStepChoice::Rayleigh => rayleigh(setup, particles, rayleigh_linear),
        TimeStepChoice::RayleighExact => rayleigh(setup, particles, rayleigh_root),
    }
}

/// 2 √(m/k): smallest mass that can move, largest spring of any pair that can occur.
fn critical(pairs: &PairTable, particles: &Particles, walls: &[usize]) -> f64 {
    let mut used: Vec<usize> = particles.material.iter().map(|&m| m as usize).collect();
    used.sort_unstable();
    used.dedup();
    let mut stiffest = 0f64;
    for &a in &used {
        let others = used.iter().map(|&b| pairs.get(a, b, false));
        for pair in others.chain(walls.iter().map(|&b| pairs.get(a, b, true))) {
            stiffest = stiffest
                .max(pair.normal_stiffness)
                .max(pair.shear_stiffness);
        }
    }
    let lightest = (0..particles.len())
        .filter(|&p| !particles.is_driven(p))
        .fold(f64::INFINITY, |least, p| least.min(particles.mass[p]));
    2.0 * (lightest / stiffest).sqrt()
}

/// π R √(ρ/G)/α on mean radius, density and shear modulus (Randall 1989, (4.33)).
fn rayleigh(setup: &Setup, particles: &Particles, alpha: fn(f64) -> f64) -> f64 {
    let n = particles.len() as f64;
    let mut sums = [0.0; 4];
    for (row, &material) in particles.row.iter().zip(&particles.material) {
        let m = &setup.materials[material as usize];
        let (young, poisson) = (m.young.unwrap_or(f64::NAN), m.poisson.unwrap_or(f64::NAN));
        for (sum, value) in sums.iter_mut().zip([
            row.radius,
            m.density,
            young / (2.0 * (1.0 + poisson)),
            poisson,
        ]) {
            *sum += value;
        }
    }
    let [radius, density, shear, poisson] = sums.map(|sum| sum / n);
    std::f64::consts::PI * radius * (density / shear).sqrt() / alpha(poisson)
}

/// α of (4.34), within 0.3 % of the root.
pub fn rayleigh_linear(poisson: f64) -> f64 {
    0.1631 * poisson + 0.876_605
}

/// α from the root of (4.32), (2 - α²)⁴ = 16 (1 - α²)(1 - α² c2²/c1²), by bisection.
pub fn rayleigh_root(poisson: f64) -> f64 {
    let ratio = (1.0 - 2.0 * poisson) / (2.0 * (1.0 - poisson));
    let excess = |alpha: f64| {
        let s = alpha * alpha;
        let side = (2.0 - s) * (2.0 - s);
        side * side - 16.0 * (1.0 - s) * (1.0 - s * ratio)
    };
    // The root lies between these, from .689 at ν = -1 to .955 at ½; α = 0 is a false one.
    let (mut low, mut high) = (if poisson < 0.0 { 0.6f64 } else { 0.8 }, 0.96f64);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if excess(middle) < 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Hand checks of Randall 1989, 5.1 and 5.4: 10.55 µs and 1.050 µs.
    #[test]
    fn steps_of_the_thesis() {
        for (radius, poisson, step) in [(1e-2, 0.3, 1.055e-5), (1e-3, 0.28, 1.050e-6)] {
            let shear = 210e9 / (2.0 * (1.0 + poisson));
            let found = std::f64::consts::PI * radius * (7800.0f64 / shear).sqrt()
                / rayleigh_linear(poisson);
            assert!((found / step - 1.0).abs() < 5e-4, "{found}");
        }
    }

    #[test]
    fn rayleigh_alpha() {
        // The exact root for ν = 1/4 is √(2 - 2/√3).
        let exact = (2.0 - 2.0 / 3f64.sqrt()).sqrt();
        assert!(
            (rayleigh_root(0.25) - exact).abs() < 1e-14,
            "{}",
            rayleigh_root(0.25)
        );
        assert!((rayleigh_linear(0.25) - 0.917_38).abs() < 1e-5);
        // At ν = -1 the square s of the root solves (2 - s)⁴ = 16 (1 - s)(1 - ¾ s).
        for poisson in [-0.999, -0.9, -0.5, -0.1] {
            let s = rayleigh_root(poisson) * rayleigh_root(poisson);
            let ratio = (1.0 - 2.0 * poisson) / (2.0 * (1.0 - poisson));
            let side = (2.0 - s) * (2.0 - s);
            let left = side * side / (16.0 * (1.0 - s) * (1.0 - s * ratio)) - 1.0;
            assert!(left.abs() < 1e-13, "ν = {poisson}: {left}");
        }
        assert!((rayleigh_root(-0.999_999_999) - 0.688_892_182_7).abs() < 1e-10);
        for k in 0..=10 {
            let poisson = 0.05 * f64::from(k);
            let error = rayleigh_linear(poisson) / rayleigh_root(poisson) - 1.0;
            assert!(error.abs() < 5e-3, "ν = {poisson}: {error}");
        }
    }
}
