//! The ledger.

use crate::{FRICTION, Rig, overlap_at, reference, spheres};

#[test]
fn loops() {
    let (_, k) = spheres();
    let alpha = overlap_at(88.0);
    let star = FRICTION * k * alpha;
    for top in [0.5_f64, 0.75, 0.9] {
        let delta = star * (1.0 - (1.0 - top).cbrt().powi(2));
        for n in [1, 10, 100, 1000, 100000] {
            let mut rig = Rig::new(reference());
            rig.to(alpha, 0.0);
            rig.line(alpha, delta, n);
            let l0 = rig.lost;
            let w0 = rig.work;
            let u0 = rig.energy();
            rig.line(alpha, -delta, n);
            rig.line(alpha, delta, n);
            eprintln!(
                "{n} {l0:e} {:e} {:e} {:e} {:e} res {:e}",
                w0 - u0 - l0,
                rig.lost - l0,
                rig.work - w0,
                rig.energy() - u0,
                rig.work - rig.energy() - rig.lost
            );
        }
    }
}

#[test]
fn paths() {
    let (_, k) = spheres();
    let alpha = overlap_at(88.0);
    let star = FRICTION * k * alpha;
    let legs = [
        [0.3, 0.1],
        [1.0, 0.5],
        [0.5, 0.1],
        [0.7, 0.35],
        [1.0, -0.3],
        [0.4, 0.1],
        [0.6, 2.0],
        [0.2, 1.0],
        [0.1, 3.0],
        [1.0, 3.2],
        [0.5, 3.2],
    ];
    let mut last = 0.0;
    for n in [10, 20, 40, 80, 160, 320, 640, 1280] {
        let mut rig = Rig::new(reference());
        for [a, d] in legs {
            rig.line(a * alpha, d * star, n);
        }
        let res = (rig.work - rig.energy() - rig.lost) / (0.3 * 88.0 * star);
        eprintln!(
            "{n} {res:e} ratio {} lost {:e} nodes {}",
            last / res,
            rig.lost,
            rig.memory.len()
        );
        last = res;
    }
}
