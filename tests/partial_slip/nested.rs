use crate::annuli::{Annuli, Keep};
use ballast::engine::contact::diagram::{Diagram, Partial};
use std::f64::consts::PI;

/// A smooth history with nested reversals in both: overlap and displacement.
fn at(s: f64) -> [f64; 2] {
    // swings that die away
    let amp = 0.7 * (1.0 - s);
    [
        1.0 + 0.25 * (1.0 - s) * (2.0 * PI * 4.3 * s).sin(),
        amp * (2.0 * PI * 7.0 * s).sin(),
    ]
}
fn grow(s: f64) -> [f64; 2] {
    [
        0.2 + 0.8 * s + 0.1 * (1.0 - s) * (2.0 * PI * 9.3 * s).sin(),
        0.6 * (1.0 - s) * (2.0 * PI * 11.0 * s).sin() + 0.3 * s,
    ]
}

fn third(s: f64) -> [f64; 2] {
    // overlap rises, swings die away about a growing mean; sticks while it grows
    let a = 1.0 - (1.0 - s) * (0.5 + 0.45 * (2.0 * PI * 2.5 * s).cos());
    [a, 0.35 * (1.0 - s) * (2.0 * PI * 2.5 * s + 0.6).cos()]
}
fn fourth(s: f64) -> [f64; 2] {
    let a = 0.6 + 0.4 * (1.0 - s) * (2.0 * PI * 5.0 * s - 0.5 * PI).sin();
    [a, 0.25 * (1.0 - s) * (2.0 * PI * 5.0 * s + 0.9).cos()]
}
fn fifth(s: f64) -> [f64; 2] {
    let a = 0.6 + 0.4 * (1.0 - s) * (2.0 * PI * 3.0 * s - 0.5 * PI).sin();
    [a, 0.1 * (1.0 - s) * (2.0 * PI * 10.0 * s + 0.9).cos()]
}
fn sixth(s: f64) -> [f64; 2] {
    let a = 0.6 + 0.4 * (1.0 - s) * (2.0 * PI * 3.0 * s - 0.5 * PI).sin();
    [
        a,
        0.25 * (1.0 - s) * (2.0 * PI * 3.0 * s + 0.3).cos() + 0.0 * s,
    ]
}
#[test]
fn nested() {
    for f in [at as fn(f64) -> [f64; 2], grow, third, fourth, fifth, sixth] {
        let mut finals = vec![];
        for n in [1000usize, 10_000, 100_000, 1_000_000] {
            let law = Partial::new(1.0, 1.0, 1.0, 16);
            let law8 = Partial::new(1.0, 1.0, 1.0, 8);
            let mut memory = Diagram::<16>::default();
            let mut memory8 = Diagram::<16>::default();
            let mut all = Annuli::new(1.0, Keep::All);
            let mut plain = Annuli::new(1.0, Keep::SmallestTriangle(16));
            let mut last = 0.0;
            let mut worst = [0.0_f64; 3];
            let mut out = vec![];
            let mut most = 0;
            for k in 0..=n {
                let [a, d] = f(k as f64 / n as f64);
                law.advance(a, d - last, &mut memory);
                law8.advance(a, d - last, &mut memory8);
                plain.step(a, d - last);
                all.step(a, d - last);
                last = d;
                most = most.max(all.len());
                if k % (n / 200) == 0 {
                    let x = all.force();
                    worst[0] = worst[0].max((law.force(&memory) - x).abs() / a.powf(1.5));
                    worst[1] = worst[1].max((law.force(&memory8) - x).abs() / a.powf(1.5));
                    worst[2] = worst[2].max((plain.force() - x).abs() / a.powf(1.5));
                    out.push([law.force(&memory), x]);
                }
            }
            finals.push(out);
            eprintln!("{n} {worst:?} {} {} {most}", memory.len(), all.len());
        }
        for k in 0..3 {
            let e = |j: usize| {
                finals[k]
                    .iter()
                    .zip(&finals[3])
                    .map(|(a, b)| (a[j] - b[j]).abs())
                    .fold(0.0_f64, f64::max)
            };
            eprintln!("{k} bounded {} unbounded {}", e(0), e(1));
        }
    }
}
