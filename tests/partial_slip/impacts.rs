//! Oblique impacts of a sphere, in the units of the problem: approach over the largest approach,
//! time over that by the impact velocity, displacement over μ k times it, force over μ N_max.

use ballast::engine::contact::diagram::{Diagram, Partial};

use crate::histories::{number, rows};

/// Contact time of an elastic impact.
const CONTACT_TIME: f64 = 2.943_275_1;

/// Velocities (normal, tangential) after an impact with 1 and ψ₁, in steps of the contact time over
/// `steps`; the first touch comes `phase` of a step after a step.
pub(crate) fn impact(chi: f64, psi: f64, steps: f64, phase: f64) -> [f64; 2] {
    let law = Partial::new(1.0, 1.0, 1.0, 16);
    let mut memory = Diagram::<16>::default();
    let dt = CONTACT_TIME / steps;
    let (mut x, mut v) = (-phase * dt, [1.0, psi]);
    loop {
        x += v[0] * dt;
        if x <= 0.0 {
            return [-v[0], v[1]];
        }
        let force = law.advance(x, v[1] * dt, &mut memory).force;
        v[0] -= 1.25 * x * x.sqrt() * dt;
        v[1] -= 2.5 * chi * force * dt;
    }
}

pub(crate) fn impact2(chi: f64, psi: f64, steps: f64, phase: f64) -> [f64; 2] {
    let mut law = crate::annuli::Annuli::new(1.0, crate::annuli::Keep::All);
    let dt = CONTACT_TIME / steps;
    let (mut x, mut v) = (-phase * dt, [1.0, psi]);
    loop {
        x += v[0] * dt;
        if x <= 0.0 {
            return [-v[0], v[1]];
        }
        law.step(x, v[1] * dt);
        let force = law.force();
        v[0] -= 1.25 * x * x.sqrt() * dt;
        v[1] -= 2.5 * chi * force * dt;
    }
}

#[test]
fn maw() {
    let mut worst = [0.0_f64; 3];
    for row in rows("maw_oblique") {
        let chi = number(&row, 2);
        for (k, n) in [35.0, 350.0, 3500.0].into_iter().enumerate() {
            let [_, out] = impact(chi, number(&row, 3), n, 0.5);
            worst[k] = worst[k].max((out - number(&row, 4)).abs());
        }
    }
    eprintln!("{worst:?}");
}

#[test]
fn table() {
    for (nu, mu) in [(0.28_f64, 0.12_f64)] {
        let k = (2.0 - nu) / (2.0 * (1.0 - nu));
        let chi = 3.5 / (2.0 * k);
        for (off, name) in [(0.5, "unb"), (0.5, "b")] {
            let mut last = 0.0;
            for n in [10.0, 20.0, 35.0, 100.0, 350.0, 3500.0] {
                let mut sums = [0.0; 3];
                let mut worst = [0.0_f64; 2];
                for a in 1..=17 {
                    let th = (5.0 * a as f64).to_radians();
                    let psi = th.tan() / (mu * k);
                    let exact = impact2(chi, psi, 20_000.0, 0.5);
                    for p in 0..8 {
                        let out = (if name == "unb" { impact2 } else { impact })(
                            chi,
                            psi,
                            n,
                            (p as f64 + off) / 8.0,
                        );
                        let en = (out[0] - 1.0) * th.cos();
                        let et = (out[1] - exact[1]) * th.cos() * mu * k / 3.5;
                        sums[0] += en * en;
                        sums[1] += et * et;
                        sums[2] += en * en + et * et * (1.0 + 2.5 * 2.5 * 0.4);
                        worst[0] = worst[0].max(en.abs());
                        worst[1] = worst[1].max(et.abs());
                    }
                }
                let r = sums.map(|s: f64| (s / 136.0).sqrt());
                eprintln!("{nu} {mu} {name} {n} {r:?} {worst:?} ratio {}", last / r[2]);
                last = r[2];
            }
        }
    }
}
