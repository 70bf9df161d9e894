//! What is kept for each contact follows the list to its new places, within its own buffer.

use std::cmp::Ordering;

use super::images::Images;

/// No place in the old list.
pub(in crate::engine) const NEW: u32 = u32::MAX;

/// Moves items to new places: the k-th stood `shift` places before `old[k]`, or is `fresh` where that
/// is [`NEW`]. Old places ascend, as both lists are sorted, so no second copy is needed. Room is kept
/// for so many.
pub(in crate::engine) fn carry<T: Copy>(
    items: &mut Vec<T>,
    old: &[u32],
    shift: u32,
    room: usize,
    mut fresh: impl FnMut(usize) -> T,
) {
    // Together first ...
    let mut kept = 0;
    for &from in old {
        if let Some(&item) = items.get(from.wrapping_sub(shift) as usize) {
            items[kept] = item;
            kept += 1;
        }
    }
    let had = items.len();
    items.truncate(kept);
    items.reserve(room.max(old.len()) - kept);
    let Some(&any) = items.first() else {
        items.extend((0..old.len()).map(&mut fresh));
        return;
    };
    items.resize(old.len(), any);
    // ... then apart, from the back, until the rest is where it belongs.
    for (k, &from) in old.iter().enumerate().rev() {
        if kept == k + 1 {
            break;
        }
        if (from.wrapping_sub(shift) as usize) < had {
            kept -= 1;
            items[k] = items[kept];
        } else {
            items[k] = fresh(k);
        }
    }
}

/// Looks sorted new pairs, from a certain one on, and their images up among sorted old ones: notes the
/// place of each there, or [`NEW`]. `bodies` answers which two a pair is of.
pub(super) fn places<T>(
    bodies: impl Fn(&T) -> [u32; 2],
    (old, old_images): (&[T], &Images),
    (new, new_images): (&[T], &Images),
    from: usize,
    noted: &mut [u32],
) {
    // Orders as the two do.
    let number = |pair: &T| {
        let [i, j] = bodies(pair);
        u64::from(i) << 32 | u64::from(j)
    };
    let new = &new[from..];
    let Some(first) = new.first().map(number) else {
        return;
    };
    let mut at = old.partition_point(|pair| number(pair) < first);
    let (mut old_images, mut new_images) = (old_images.ahead(at), new_images.ahead(from));
    for ((k, pair), noted) in (from..).zip(new).zip(noted) {
        let wanted = number(pair);
        while old.get(at).is_some_and(|pair| number(pair) < wanted) {
            at += 1;
        }
        *noted = NEW;
        // In a small cell two bodies meet more than once.
        while old.get(at).is_some_and(|pair| number(pair) == wanted) {
            match old_images.at(at).cmp(&new_images.at(k)) {
                Ordering::Less => at += 1,
                Ordering::Equal => {
                    *noted = at as u32;
                    break;
                }
                Ordering::Greater => break,
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Pairs of few bodies and few images, ascending, without and with their images.
    fn list(all: std::collections::BTreeSet<([u32; 2], [i16; 2])>) -> (Vec<[u32; 2]>, Images) {
        let mut images = Images::default();
        for (k, (_, image)) in all.iter().enumerate() {
            images.push(k, *image);
        }
        (all.into_iter().map(|(pair, _)| pair).collect(), images)
    }

    proptest! {
        #[test]
        fn pairs_are_found_where_asking_all_finds_them(
            all in prop::collection::vec(
                ((0..4u32, 0..4u32), -1..2i16, any::<bool>(), any::<bool>()), 0..60),
        ) {
            let meant = |before: bool| {
                let those = all.iter().filter(|item| if before { item.2 } else { item.3 });
                those.map(|&((i, j), n, ..)| ([i, j], [n, 0])).collect()
            };
            let (old, new) = (list(meant(true)), list(meant(false)));
            let each = |(pairs, images): &(Vec<[u32; 2]>, Images)| -> Vec<_> {
                pairs.iter().copied().zip(images.each()).collect()
            };
            let before = each(&old);
            let asked = each(&new).into_iter().map(|pair| {
                before.iter().position(|old| *old == pair).map_or(NEW, |k| k as u32)
            });
            let asked: Vec<_> = asked.collect();
            for cut in [0, new.0.len() / 3, new.0.len()] {
                let mut noted = vec![0; new.0.len()];
                let (head, tail) = noted.split_at_mut(cut);
                places(|pair| *pair, (&old.0, &old.1), (&new.0, &new.1), 0, head);
                places(|pair| *pair, (&old.0, &old.1), (&new.0, &new.1), cut, tail);
                prop_assert_eq!(&noted, &asked);
            }
        }

        #[test]
        fn items_stand_where_a_second_copy_would_have_them(
            size in 0..40usize,
            shift in 0..3u32,
            steps in prop::collection::vec((any::<bool>(), 0..4u32), 0..60),
        ) {
            let before: Vec<usize> = (0..size).map(|k| 1000 + k).collect();
            let mut next = 0;
            let old: Vec<u32> = steps
                .iter()
                .map(|&(new, skip)| {
                    let place = next + skip;
                    if new || place as usize >= size {
                        return NEW;
                    }
                    next = place + 1;
                    place + shift
                })
                .collect();
            let copied: Vec<usize> = (old.iter().enumerate())
                .map(|(k, &from)| before.get(from.wrapping_sub(shift) as usize).copied().unwrap_or(k))
                .collect();
            let mut items = before;
            carry(&mut items, &old, shift, 0, |k| k);
            prop_assert_eq!(items, copied);
        }
    }
}
