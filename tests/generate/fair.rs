//! Nowhere is preferred: against distributions that are known.

use crate::scene_with;

/// Largest chi-square of `freedom` degrees that chance exceeds less than once in a million times:
/// P(x > k + 2 sqrt(k t) + 2 t) <= exp(-t) (Laurent & Massart 2000, lemma 1).
fn bound(freedom: f64) -> f64 {
    let t = 6.0 * 10f64.ln();
    freedom + 2.0 * (freedom * t).sqrt() + 2.0 * t
}

fn chi_square(counts: &[usize]) -> f64 {
    let expected = counts.iter().sum::<usize>() as f64 / counts.len() as f64;
    let off = |&count: &usize| (count as f64 - expected).powi(2) / expected;
    counts.iter().map(off).sum()
}

#[test]
fn one_disc_is_as_likely_anywhere() {
    let tables = "[[generate]]\nmaterial = \"m\"\ngrading = [{ radius = 0.1, count = 1 }]\n\
                  in = { rectangle = { min = [0, 0], max = [1.2, 1.2] } }\n";
    let mut counts = [0; 25];
    for seed in 0..2000 {
        let scene = scene_with(tables, &[&format!("model.seed={seed}")]);
        let [i, j] = scene.setup.particles[0]
            .at
            .map(|x| ((x - 0.1) * 5.0) as usize);
        counts[5 * j + i] += 1;
    }
    assert!(chi_square(&counts) < bound(24.0), "{counts:?}");
}

/// Numbers of another kind than the program's: xorshift64* of Vigna 2016.
struct Other(u64);

impl Other {
    fn fraction(&mut self) -> f64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 11) as f64 / (1u64 << 53) as f64
    }
}

#[test]
fn full_boxes_are_those_of_plain_rejection() {
    // Discs of radius 0.16 in a unit square until it is full: where they are and how many, against
    // the textbook's way, in which a million attempts in vain stand for "full".
    const RUNS: usize = 1500;
    let cell = |x: f64| ((x - 0.16) / 0.68 * 4.0).min(3.0) as usize;
    let bins = |places: &[[f64; 2]], counts: &mut [usize]| {
        for place in places {
            counts[4 * cell(place[1]) + cell(place[0])] += 1;
        }
        counts[16 + places.len().clamp(3, 6) - 3] += 1;
    };
    let (mut ours, mut theirs) = ([0; 20], [0; 20]);
    let mut other = Other(88_172_645_463_325_252);
    for seed in 0..RUNS {
        let tables = "[[generate]]\nmaterial = \"m\"\ngrading = [{ radius = 0.16 }]\n\
                      in = { rectangle = { min = [0, 0], max = [1, 1] } }\n";
        let scene = scene_with(tables, &[&format!("model.seed={seed}")]);
        let places: Vec<[f64; 2]> = scene.setup.particles.iter().map(|p| p.at).collect();
        bins(&places, &mut ours);
        let (mut places, mut vain): (Vec<[f64; 2]>, _) = (Vec::new(), 0);
        while vain < 20_000 {
            let at = [0; 2].map(|_| 0.16 + 0.68 * other.fraction());
            let free = places
                .iter()
                .all(|p| (p[0] - at[0]).hypot(p[1] - at[1]) >= 0.32);
            vain = if free { 0 } else { vain + 1 };
            if free {
                places.push(at);
            }
        }
        bins(&places, &mut theirs);
    }
    let two_samples = |range: std::ops::Range<usize>| {
        let (a, b) = (&ours[range.clone()], &theirs[range]);
        let [all_a, all_b] = [a, b].map(|x| x.iter().sum::<usize>() as f64);
        let off = |(&a, &b): (&usize, &usize)| {
            let (a, b) = (a as f64, b as f64);
            let d = a * (all_b / all_a).sqrt() - b * (all_a / all_b).sqrt();
            if a + b > 0.0 { d * d / (a + b) } else { 0.0 }
        };
        a.iter().zip(b).map(off).sum::<f64>()
    };
    assert!(two_samples(0..16) < bound(15.0), "{ours:?} {theirs:?}");
    assert!(two_samples(16..20) < bound(3.0), "{ours:?} {theirs:?}");
}

#[test]
fn a_full_periodic_cell_is_as_full_as_known() {
    // Random sequential addition of equal discs ends at a coverage of 0.547067 (Zhang & Torquato
    // 2013). Their number varies less than that of independent points, by sqrt(N).
    let tables = "[[generate]]\nmaterial = \"m\"\ngrading = [{ radius = 0.002 }]\nperiodic = true\n\
                  in = { rectangle = { min = [0, 0], max = [1, 1] } }\n";
    let scene = scene_with(tables, &[]);
    let coverage = 1.0 - scene.generated[0].porosity.unwrap();
    let count = scene.setup.particles.len() as f64;
    assert!(count > 40_000.0);
    assert!(
        (coverage - 0.547_067).abs() < 0.547 / count.sqrt(),
        "{coverage}"
    );
}
