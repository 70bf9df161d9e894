//! Keys that are named without their table.

use crate::scene::SECTIONS;
use crate::scene::section::{Section, Shape};

/// More places than this are a list of the reference rather than advice.
const FEW: usize = 4;

/// Where a key of this name is, if there is one.
pub(super) fn elsewhere(key: &str) -> Option<String> {
    let has = |section: &&Section| section.keys.iter().any(|known| known.name == key);
    let paths: Vec<String> = SECTIONS
        .iter()
        .filter(has)
        .take(FEW)
        .map(|section| match section.shape {
            Shape::Single => format!("`{}.{key}`", section.name),
            Shape::Named => format!("`{}.NAME.{key}`", section.name),
            Shape::Listed if section.has_names() => format!("`{}.NAME.{key}`", section.name),
            Shape::Listed => format!("`{}.NUMBER.{key}`", section.name),
        })
        .collect();
    (!paths.is_empty()).then(|| format!("did you mean {}?", paths.join(" or ")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_key_is_found_in_its_table() {
        let frac = elsewhere("frac").unwrap();
        assert!(frac.starts_with("did you mean `model.frac`"), "{frac}");
        let friction = elsewhere("friction").unwrap();
        assert!(friction.contains("`material.NAME.friction`"), "{friction}");
        let radius = elsewhere("radius").unwrap();
        assert!(radius.contains("`particle.NUMBER.radius`"), "{radius}");
        assert_eq!(elsewhere("nonsense"), None);
    }
}
