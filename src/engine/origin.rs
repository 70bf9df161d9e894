//! Where a world has its zero.

use super::setup::ParticleSetup;

/// Far from zero, coordinates lose the digits that overlaps need: a scene that lies further away
/// than sixteen times its size is moved to the origin, exactly, by a multiple of a power of two.
pub(super) fn far_origin(particles: &[ParticleSetup]) -> [f64; 2] {
    let mut origin = [0.0; 2];
    for (axis, origin) in origin.iter_mut().enumerate() {
        let low = particles
            .iter()
            .fold(f64::INFINITY, |m, p| m.min(p.at[axis] - p.radius));
        let high = particles
            .iter()
            .fold(f64::NEG_INFINITY, |m, p| m.max(p.at[axis] + p.radius));
        let (middle, size) = (0.5 * (low + high), high - low);
        if middle.abs() > 16.0 * size && size > 0.0 {
            let mut grain = 1.0f64;
            while grain > size {
                grain *= 0.5;
            }
            while grain < 0.5 * size {
                grain *= 2.0;
            }
            *origin = (middle / grain).round() * grain;
        }
    }
    origin
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(x: f64, y: f64) -> ParticleSetup {
        ParticleSetup {
            at: [x, y],
            radius: 0.5,
            material: 0,
            velocity: [0.0; 2],
            spin: 0.0,
            angle: 0.0,
            force: [0.0; 2],
            fixed: [false; 3],
        }
    }

    #[test]
    fn far_scenes_move_exactly() {
        assert_eq!(far_origin(&[at(0.3, 0.0), at(1.2, 0.0)]), [0.0, 0.0]);
        let near = [0.3, 1.2];
        let shift = 1_048_576.0;
        let far = near.map(|x: f64| x + shift);
        let [origin, _] = far_origin(&[at(far[0], 0.0), at(far[1], 0.0)]);
        assert!(origin > 0.0);
        // Nothing of the given coordinate is lost: adding the origin restores its bits.
        for x in far {
            assert_eq!((x - origin) + origin, x);
            assert_eq!((x - origin) - (x - shift), shift - origin);
        }
    }
}
