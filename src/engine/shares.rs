//! Which contacts and which particles a thread works on.
//!
//! A particle's forces are best summed by the thread that worked them out: contacts and particles are
//! cut at the same places, as far as both stay fair.

use super::threads::share;

/// Blocks of contacts are not cut: as many as there are lanes at most.
const BLOCK: usize = 8;

/// Stretches of particles are no longer or shorter than a fair one by more than this part of it.
const UNFAIR: usize = 4;

/// Pairs of one part of a list.
pub(super) fn pairs(total: usize, parts: usize, part: usize) -> std::ops::Range<usize> {
    let fair = share(total, parts, part);
    let whole = |cut: usize| cut / BLOCK * BLOCK;
    let end = if part + 1 < parts {
        whole(fair.end)
    } else {
        total
    };
    whole(fair.start)..end
}

/// Particles of one part: those from the first body of its first pair, `pairs` ascending, in whole blocks
/// of this size, but for the last.
pub(super) fn particles(
    list: &[[u32; 2]],
    count: usize,
    (parts, part): (usize, usize),
    whole: usize,
) -> std::ops::Range<usize> {
    let fair = share(count, parts, part);
    // Either end moves, each by half of it.
    let most = count / parts / (2 * UNFAIR);
    let cut = |fair: usize, part: usize| match list.get(pairs(list.len(), parts, part).start) {
        Some(&[i, _]) if 0 < part && part < parts => {
            (i as usize).clamp(fair - most, fair + most) / whole * whole
        }
        _ if part < parts => fair / whole * whole,
        _ => fair,
    };
    cut(fair.start, part)..cut(fair.end, part + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn stretches(list: &[[u32; 2]], count: usize, parts: usize) -> Vec<std::ops::Range<usize>> {
        (0..parts)
            .map(|part| particles(list, count, (parts, part), 1))
            .collect()
    }

    #[test]
    fn everything_is_somebodys_and_blocks_stay_whole() {
        for total in [0, 1, 7, 8, 65, 1131] {
            for parts in 1..9 {
                let mut next = 0;
                for part in 0..parts {
                    let own = pairs(total, parts, part);
                    assert_eq!((own.start, own.start % BLOCK), (next, 0));
                    next = own.end;
                }
                assert_eq!(next, total);
            }
        }
        // Pairs of a few particles only, and of the last ones: the cuts stay near fair ones.
        let crowd: Vec<[u32; 2]> = (0..1000).map(|k| [k / 500, 900]).collect();
        let late: Vec<[u32; 2]> = (0..80).map(|k| [900 + k / 8, 999]).collect();
        for list in [&crowd, &late, &Vec::new()] {
            for parts in 1..9 {
                let cuts = stretches(list, 1000, parts);
                assert_eq!((cuts[0].start, cuts[parts - 1].end), (0, 1000));
                assert!(cuts.windows(2).all(|two| two[0].end == two[1].start));
                let fair = 1000 / parts;
                let off = cuts.iter().map(|own| own.len().abs_diff(fair)).max();
                assert!(off <= Some(fair / UNFAIR + 1), "{parts}: {cuts:?}");
            }
        }
    }

    #[test]
    fn particles_go_with_their_pairs() {
        let chain: Vec<[u32; 2]> = (0..999).map(|k| [k, k + 1]).collect();
        // Unless there are blocks that must not be cut.
        let cuts: Vec<_> = (0..3)
            .map(|part| particles(&chain, 1000, (3, part), 16))
            .collect();
        assert_eq!(cuts, [0..320, 320..656, 656..1000]);
        for parts in 2..5 {
            for (part, own) in stretches(&chain, 1000, parts).iter().enumerate() {
                assert_eq!(own.start, pairs(999, parts, part).start);
            }
        }
    }
}
