//! Names that columns refer to, and answers to wrong ones.

/// What exists in a scene: columns name walls, particles, regions and materials.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Names {
    /// Wall names in order.
    pub walls: Vec<String>,
    /// Numbers of the particles that exist, ascending.
    pub particles: Vec<u32>,
    /// Region names in order.
    pub regions: Vec<String>,
    /// Material names in order.
    pub materials: Vec<String>,
    /// Whether walls and particles come from a sample that is not known yet: then any may exist.
    pub open: bool,
}

/// A name that is no column, or that nothing has.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{message}; {remedy}")]
pub struct UnknownColumn {
    /// What is wrong with it.
    pub message: String,
    /// What would be right.
    pub remedy: String,
}

impl Names {
    /// Whether there is a wall of this name.
    pub fn wall(&self, name: &str) -> Result<(), UnknownColumn> {
        if self.open {
            return Ok(());
        }
        one_of("wall", &self.walls, name)
    }

    /// Whether there is a region of this name.
    pub fn region(&self, name: &str) -> Result<(), UnknownColumn> {
        if self.regions.is_empty() {
            return Err(UnknownColumn {
                message: format!("there is no region `{name}`"),
                remedy: "the preset has no [[measure]]".into(),
            });
        }
        one_of("region", &self.regions, name)
    }

    /// Whether there is a material of this name.
    pub fn material(&self, name: &str) -> Result<(), UnknownColumn> {
        one_of("material", &self.materials, name)
    }

    /// Whether there is a particle of this number.
    pub fn particle(&self, id: u32) -> Result<(), UnknownColumn> {
        if self.open || self.particles.binary_search(&id).is_ok() {
            return Ok(());
        }
        Err(UnknownColumn {
            message: format!("there is no particle {id}"),
            remedy: match (self.particles.first(), self.particles.last()) {
                (Some(first), Some(last)) => format!("they are numbered {first} to {last}"),
                _ => "the scene has none".into(),
            },
        })
    }
}

fn one_of(kind: &str, known: &[String], name: &str) -> Result<(), UnknownColumn> {
    if known.iter().any(|one| one == name) {
        return Ok(());
    }
    Err(UnknownColumn {
        message: format!("there is no {kind} `{name}`"),
        remedy: nearest(name, known.iter().map(String::as_str)),
    })
}

/// A word longer than this [bytes] resembles nothing, and comparing it takes time.
const LONGEST: usize = 160;

/// The name that a wrong one was meant for, if it is near enough to be that.
pub fn near<'a>(wrong: &str, known: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    if wrong.len() > LONGEST {
        return None;
    }
    let likeness = |name: &str| strsim::jaro_winkler(&wrong.to_lowercase(), &name.to_lowercase());
    let best = known
        .map(|name| (likeness(name), name))
        .max_by(|a, b| a.0.total_cmp(&b.0));
    let (score, name) = best?;
    (score > 0.8 || is_near(wrong, name)).then_some(name)
}

/// "did you mean ...?" when something is near, else the list of what there is if it is short.
pub fn nearest<'a>(wrong: &str, known: impl Iterator<Item = &'a str>) -> String {
    let known: Vec<&str> = known.collect();
    match near(wrong, known.iter().copied()) {
        Some(name) => format!("did you mean `{name}`?"),
        None if known.is_empty() => "there is none".into(),
        None if known.len() <= 12 => format!("there is {}", known.join(", ")),
        None => format!("none of the {} names is like it", known.len()),
    }
}

/// Whether a third of the word at most has to be changed for the name.
fn is_near(wrong: &str, name: &str) -> bool {
    let distance = strsim::damerau_levenshtein(&wrong.to_lowercase(), &name.to_lowercase());
    3 * distance <= wrong.chars().count()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn far_fetched_names_are_not_offered() {
        let names: Vec<String> = (0..20).map(|k| format!("rolling-disc-{k}")).collect();
        let answer = |wrong: &str| nearest(wrong, names.iter().map(String::as_str));
        assert_eq!(answer("nothing"), "none of the 20 names is like it");
        assert_eq!(answer("roling-disc-3"), "did you mean `rolling-disc-3`?");
    }

    #[test]
    fn the_nearest_name_is_found_only_when_it_is_near() {
        let names = ["velocity", "spin"];
        assert_eq!(near("velocty", names.into_iter()), Some("velocity"));
        assert_eq!(near("zzz", names.into_iter()), None);
        assert_eq!(near(&"velocity".repeat(1000), names.into_iter()), None);
    }
}
