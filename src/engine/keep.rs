//! Some items of a list stay.

/// Removes the items that do not stay; those beyond the end of `stays` do not.
pub(super) fn only<T>(items: &mut Vec<T>, stays: &[bool]) {
    let mut stays = stays.iter();
    items.retain(|_| stays.next().is_some_and(|stays| *stays));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_stays_keeps_its_order() {
        let mut items = vec![1, 2, 3, 4];
        only(&mut items, &[true, false, true]);
        assert_eq!(items, [1, 3]);
    }
}
