//! A column that has been looked up, and how it is written.

use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::card::{Card, Kind, Row};
use super::contact::{CONTACT, ReadContact};
use super::material::{MATERIAL, ReadMaterial};
use super::names::{Names, UnknownColumn, nearest};
use super::particle::{PARTICLE, ReadParticle};
use super::read::Read;
use super::wall::{ReadWall, WALL};

/// The second body of a contact.
#[derive(Debug, Clone, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Partner {
    /// A particle, by number.
    Particle(u32),
    /// A wall, by name.
    Wall(String),
}

/// A column that has been looked up.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum Column {
    /// Of the assembly or of its first region.
    Global(&'static Row<Read>),
    /// Of the wall of this name.
    Wall(String, &'static Row<ReadWall>),
    /// Of the contact between a particle and a partner of a higher number, or a wall.
    Contact(u32, Partner, &'static Row<ReadContact>),
    /// Of the particle of this number.
    Particle(u32, &'static Row<ReadParticle>),
    /// Mean over the particles from one number to a higher one.
    Particles(u32, u32, &'static Row<ReadParticle>),
    /// Of the particles of the material of this name.
    Material(String, &'static Row<ReadMaterial>),
    /// Of the region of this name.
    Region(String, &'static Row<Read>),
}

impl Column {
    /// Looks a column up by its name; says what is near when there is none.
    pub fn parse(name: &str) -> Result<Self, UnknownColumn> {
        let parts: Vec<&str> = name.split(':').collect();
        match parts.as_slice() {
            [global] => find_global(global).map(Self::Global),
            ["wall", wall, what] => Ok(Self::Wall((*wall).to_owned(), find(WALL, what)?)),
            ["particle", ids, what] => {
                let what = find(PARTICLE, what)?;
                match ids.split_once('-') {
                    None => Ok(Self::Particle(number(ids)?, what)),
                    Some((first, last)) => {
                        let (first, last) = ascending("particle", number(first)?, number(last)?)?;
                        Ok(Self::Particles(first, last, what))
                    }
                }
            }
            ["material", material, what] => Ok(Self::Material(
                (*material).to_owned(),
                find(MATERIAL, what)?,
            )),
            ["region", region, what] => {
                Ok(Self::Region((*region).to_owned(), find_regional(what)?))
            }
            ["contact", pair, what] => {
                let what = find(CONTACT, what)?;
                let (first, second) = pair.split_once('-').ok_or_else(|| UnknownColumn {
                    message: format!("`{pair}` names no contact"),
                    remedy: "write it as I-J or I-WALL, for instance contact:1-2:n".into(),
                })?;
                let i = number(first)?;
                if !second.starts_with(|c: char| c.is_ascii_digit()) {
                    return Ok(Self::Contact(i, Partner::Wall(second.to_owned()), what));
                }
                let (i, j) = ascending("contact", i, number(second)?)?;
                Ok(Self::Contact(i, Partner::Particle(j), what))
            }
            _ => Err(unknown(name, globals().map(|row| row.card.name))),
        }
    }

    /// The columns of a history that names none.
    pub fn usual() -> Vec<Self> {
        let usual = globals().filter(|row| row.card.usual);
        usual.map(Self::Global).collect()
    }

    /// What is known of it.
    pub fn card(&self) -> &'static Card {
        match self {
            Self::Global(row) | Self::Region(_, row) => &row.card,
            Self::Wall(_, row) => &row.card,
            Self::Contact(_, _, row) => &row.card,
            Self::Particle(_, row) | Self::Particles(_, _, row) => &row.card,
            Self::Material(_, row) => &row.card,
        }
    }

    /// What its cells hold. Counts of a region are no whole numbers: contacts across its edge count
    /// by half.
    pub fn kind(&self) -> Kind {
        match self {
            Self::Region(..) => Kind::Real,
            _ => self.card().kind,
        }
    }

    /// The name it is written by.
    pub fn name(&self) -> String {
        let card = self.card().name;
        match self {
            Self::Global(_) => card.to_owned(),
            Self::Wall(wall, _) => format!("wall:{wall}:{card}"),
            Self::Contact(i, Partner::Particle(j), _) => format!("contact:{i}-{j}:{card}"),
            Self::Contact(i, Partner::Wall(w), _) => format!("contact:{i}-{w}:{card}"),
            Self::Particle(i, _) => format!("particle:{i}:{card}"),
            Self::Particles(i, j, _) => format!("particle:{i}-{j}:{card}"),
            Self::Material(material, _) => format!("material:{material}:{card}"),
            Self::Region(region, _) => format!("region:{region}:{card}"),
        }
    }

    /// Whether the walls, regions, materials and particles it names exist.
    pub fn check(&self, names: &Names) -> Result<(), UnknownColumn> {
        match self {
            Self::Global(_) => Ok(()),
            Self::Wall(wall, _) => names.wall(wall),
            Self::Material(material, _) => names.material(material),
            Self::Region(region, _) => names.region(region),
            Self::Particle(i, _) => names.particle(*i),
            Self::Particles(i, j, _) => {
                names.particle(*i)?;
                names.particle(*j)
            }
            Self::Contact(i, partner, _) => {
                names.particle(*i)?;
                match partner {
                    Partner::Particle(j) => names.particle(*j),
                    Partner::Wall(wall) => names.wall(wall),
                }
            }
        }
    }
}

/// By its name: checkpoints of an older version find it, wherever it stands in the lists by then.
impl Serialize for Column {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.name().serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for Column {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let name = String::deserialize(deserializer)?;
        Self::parse(&name).map_err(serde::de::Error::custom)
    }
}

/// Columns of the assembly.
fn globals() -> impl Iterator<Item = &'static Row<Read>> + Clone {
    super::ASSEMBLY.iter().flat_map(|family| family.iter())
}

/// Columns that a region can have.
fn regionals() -> impl Iterator<Item = &'static Row<Read>> + Clone {
    let rows = super::ASSEMBLY.iter().flat_map(|family| family.iter());
    rows.filter(|row| row.is_regional())
}

fn number(text: &str) -> Result<u32, UnknownColumn> {
    text.parse()
        .ok()
        .filter(|&id| id > 0)
        .ok_or_else(|| UnknownColumn {
            message: format!("`{text}` is no particle number"),
            remedy: "particles are numbered from 1".into(),
        })
}

fn ascending(family: &str, i: u32, j: u32) -> Result<(u32, u32), UnknownColumn> {
    if i < j {
        return Ok((i, j));
    }
    let remedy = if i == j {
        "name two different particles".into()
    } else {
        format!("write {family}:{j}-{i}:...")
    };
    Err(UnknownColumn {
        message: format!("`{i}-{j}`: the lower number comes first"),
        remedy,
    })
}

fn find<R>(rows: &'static [Row<R>], name: &str) -> Result<&'static Row<R>, UnknownColumn> {
    rows.iter()
        .find(|row| row.card.name == name)
        .ok_or_else(|| unknown(name, rows.iter().map(|row| row.card.name)))
}

fn find_global(name: &str) -> Result<&'static Row<Read>, UnknownColumn> {
    globals()
        .find(|row| row.card.name == name)
        .ok_or_else(|| unknown(name, globals().map(|row| row.card.name)))
}

fn find_regional(name: &str) -> Result<&'static Row<Read>, UnknownColumn> {
    regionals()
        .find(|row| row.card.name == name)
        .ok_or_else(|| UnknownColumn {
            message: format!("`{name}` is no column of a region"),
            remedy: nearest(name, regionals().map(|row| row.card.name)),
        })
}

fn unknown(name: &str, known: impl Iterator<Item = &'static str>) -> UnknownColumn {
    UnknownColumn {
        message: format!("`{name}` is no column"),
        remedy: nearest(name, known),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_survive_a_round_trip() {
        for name in [
            "energy_error",
            "wall:left:f1",
            "contact:1-2:n",
            "contact:12-floor:t",
            "particle:3:vx",
            "particle:3-12:speed",
            "region:core:sin_phi",
            "region:core:strain_12",
            "material:glass:coordination",
        ] {
            assert_eq!(Column::parse(name).unwrap().name(), name);
        }
    }

    #[test]
    fn wrong_names_are_refused_with_the_nearest() {
        for (wrong, hint) in [
            ("coordinaton", "`coordination`"),
            ("wall:left:f3", "`f"),
            ("contact:2-1:n", "contact:1-2"),
            ("particle:9-3:x", "write particle:3-9:..."),
            ("particle:3-3:x", "two different"),
            ("particle:1-0:x", "from 1"),
            ("contact:7:n", "I-J"),
            ("particle:0:x", "from 1"),
            ("region:core:sin_phy", "`sin_phi`"),
            ("region:core:kinetic", "no column of a region"),
            ("material:glass:contact_shear", "`contact_share`"),
        ] {
            let error = Column::parse(wrong).unwrap_err();
            assert!(error.to_string().contains(hint), "{wrong}: {error}");
        }
    }
}
