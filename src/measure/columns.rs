//! The columns of a history: names, units and what each needs. Help, checks, CSV headers and the
//! README table derive from these lists.

use serde::{Deserialize, Serialize};

/// What a cell of a column holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A real number.
    Real,
    /// A whole number.
    Count,
    /// Sixteen hexadecimal digits.
    Hash,
}

/// A column's row in the list.
#[derive(Debug, PartialEq)]
pub struct Card {
    /// Name in presets, commands and CSV headers.
    pub name: &'static str,
    /// Unit, `-` if none.
    pub unit: &'static str,
    /// One line.
    pub summary: &'static str,
    /// What its cells hold.
    pub kind: Kind,
    /// Whether energies must be booked in every cycle for it.
    pub ledger: bool,
    /// Whether it is among the columns of a history that names none.
    pub usual: bool,
    /// Whether it is measured over a region: the default one, or `region:NAME:` before its name.
    pub regional: bool,
}

const fn real(name: &'static str, unit: &'static str, summary: &'static str) -> Card {
    Card {
        name,
        unit,
        summary,
        kind: Kind::Real,
        ledger: false,
        usual: true,
        regional: false,
    }
}

const fn count(name: &'static str, summary: &'static str) -> Card {
    Card {
        name,
        unit: "-",
        summary,
        kind: Kind::Count,
        ledger: false,
        usual: true,
        regional: false,
    }
}

const fn energy(name: &'static str, summary: &'static str) -> Card {
    Card {
        name,
        unit: "J",
        summary,
        kind: Kind::Real,
        ledger: true,
        usual: true,
        regional: false,
    }
}

const fn regional(name: &'static str, unit: &'static str, summary: &'static str) -> Card {
    Card {
        regional: true,
        ..real(name, unit, summary)
    }
}

/// Columns of the whole assembly, in the order a history without a list shows them.
pub const COLUMNS: &[Card] = &[
    real("dt", "s", "time step"),
    real(
        "fracc",
        "-",
        "largest FRACC of any particle since the last row",
    ),
    real(
        "frac_limit",
        "-",
        "largest stable FRAC by the stiffness bound of the present contacts",
    ),
    count("contacts", "touching contacts, wall contacts included"),
    real("coordination", "-", "coordination number 2C/N"),
    real(
        "coordination_mechanical",
        "-",
        "coordination number without rattlers",
    ),
    real(
        "sliding_fraction",
        "-",
        "sliding contacts / contacts with friction",
    ),
    regional("porosity", "-", "1 - area of discs / area of the region"),
    regional("stress_11", "Pa", "stress, compression positive"),
    regional(
        "stress_12",
        "Pa",
        "stress: branches along 1, forces along 2",
    ),
    regional(
        "stress_21",
        "Pa",
        "stress: branches along 2, forces along 1",
    ),
    regional("stress_22", "Pa", "stress, compression positive"),
    regional("isotropic_stress", "Pa", "mean principal stress"),
    regional("deviator_stress", "Pa", "major - minor principal stress"),
    regional("sin_phi", "-", "mobilised friction (s1 - s2)/(s1 + s2)"),
    regional(
        "sin_phi_shear",
        "-",
        "part of sin_phi that tangential forces carry",
    ),
    regional(
        "anisotropy",
        "-",
        "difference of the principal values of the fabric tensor",
    ),
    regional(
        "anisotropy_angle",
        "deg",
        "major axis of the fabric tensor, 0 to 180",
    ),
    regional(
        "anisotropy_weighted",
        "-",
        "anisotropy weighted by normal force",
    ),
    real("mean_force", "N", "mean contact force"),
    real("max_force", "N", "largest contact force"),
    real(
        "unbalanced",
        "-",
        "mean out-of-balance force / mean contact force",
    ),
    real(
        "unbalanced_max",
        "-",
        "largest out-of-balance force / largest contact force",
    ),
    Card {
        ledger: false,
        ..energy("kinetic", "translational kinetic energy")
    },
    Card {
        ledger: false,
        ..energy("rotational", "rotational kinetic energy")
    },
    Card {
        ledger: false,
        ..energy("elastic_normal", "energy of the normal springs")
    },
    Card {
        ledger: false,
        ..energy("elastic_tangential", "energy of the tangential springs")
    },
    Card {
        ledger: false,
        ..energy(
            "potential",
            "energy in the field of gravity, 0 at the start",
        )
    },
    energy("friction_loss", "energy lost by sliding, cumulative"),
    energy(
        "damping_loss",
        "energy lost in contact dashpots, cumulative",
    ),
    energy(
        "global_loss",
        "energy lost by global, local and CON1 damping, cumulative",
    ),
    energy(
        "boundary_work",
        "work of walls, driven particles, applied forces and commands",
    ),
    Card {
        unit: "-",
        ..energy(
            "energy_error",
            "what the ledger fails to close by, relative",
        )
    },
    Card {
        kind: Kind::Hash,
        usual: false,
        ..real(
            "state_hash",
            "-",
            "hash of positions, velocities and contact memory",
        )
    },
];

/// Columns of one wall, written `wall:NAME:f1`.
pub const WALL_COLUMNS: &[Card] = &[
    real("f1", "N", "force of the particles on the wall, direction 1"),
    real("f2", "N", "force of the particles on the wall, direction 2"),
    real(
        "moment",
        "N m",
        "moment of that force about the wall's turning point",
    ),
    real(
        "eccentricity",
        "-",
        "distance of the normal force from mid-length / half length",
    ),
];

/// Columns of one contact, written `contact:I-J:n` or `contact:I-WALL:n`.
pub const CONTACT_COLUMNS: &[Card] = &[
    real("n", "N", "normal force, compression positive"),
    real("t", "N", "tangential force"),
    real("alpha", "m", "overlap"),
    Card {
        ledger: true,
        ..real("delta", "m", "tangential displacement since first touch")
    },
];

/// Columns of one particle, written `particle:I:x`.
pub const PARTICLE_COLUMNS: &[Card] = &[
    real("x", "m", "position, direction 1"),
    real("y", "m", "position, direction 2"),
    real("angle", "rad", "rotation, counter-clockwise"),
    real("vx", "m/s", "velocity, direction 1"),
    real("vy", "m/s", "velocity, direction 2"),
    real("spin", "rad/s", "angular velocity, counter-clockwise"),
];

/// The second body of a contact.
#[derive(Debug, Clone, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Partner {
    /// A particle, by number.
    Particle(u32),
    /// A wall, by name.
    Wall(String),
}

/// A column that has been looked up. Indices point into the list of its family.
#[derive(Debug, Clone, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Column {
    /// Index into [`COLUMNS`].
    Global(usize),
    /// Wall name and index into [`WALL_COLUMNS`].
    Wall(String, usize),
    /// Lower particle number, partner and index into [`CONTACT_COLUMNS`].
    Contact(u32, Partner, usize),
    /// Particle number and index into [`PARTICLE_COLUMNS`].
    Particle(u32, usize),
    /// Region name and index into [`COLUMNS`], of a regional one.
    Region(String, usize),
}

/// A name that is no column.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{message}; {remedy}")]
pub struct UnknownColumn {
    /// What is wrong with it.
    pub message: String,
    /// What would be right.
    pub remedy: String,
}

/// What exists in a scene: columns name walls and particles.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Names {
    /// Wall names in order.
    pub walls: Vec<String>,
    /// Numbers of the particles that exist, ascending.
    pub particles: Vec<u32>,
    /// Region names in order.
    pub regions: Vec<String>,
}

impl Column {
    /// Looks a column up by its name; says what is near when there is none.
    pub fn parse(name: &str) -> Result<Self, UnknownColumn> {
        let parts: Vec<&str> = name.split(':').collect();
        match parts.as_slice() {
            [global] => find(COLUMNS, global).map(Self::Global),
            ["wall", wall, what] => Ok(Self::Wall((*wall).to_owned(), find(WALL_COLUMNS, what)?)),
            ["particle", id, what] => {
                Ok(Self::Particle(number(id)?, find(PARTICLE_COLUMNS, what)?))
            }
            ["region", region, what] => {
                Ok(Self::Region((*region).to_owned(), find_regional(what)?))
            }
            ["contact", pair, what] => {
                let what = find(CONTACT_COLUMNS, what)?;
                let (first, second) = pair.split_once('-').ok_or_else(|| UnknownColumn {
                    message: format!("`{pair}` names no contact"),
                    remedy: "write it as I-J or I-WALL, for instance contact:1-2:n".into(),
                })?;
                let i = number(first)?;
                if !second.starts_with(|c: char| c.is_ascii_digit()) {
                    return Ok(Self::Contact(i, Partner::Wall(second.to_owned()), what));
                }
                let j = number(second)?;
                if i >= j {
                    return Err(UnknownColumn {
                        message: format!("`{pair}`: the lower number comes first"),
                        remedy: format!("write contact:{}-{}:...", i.min(j), i.max(j)),
                    });
                }
                Ok(Self::Contact(i, Partner::Particle(j), what))
            }
            _ => Err(unknown(name, COLUMNS)),
        }
    }

    /// The columns of a history that names none.
    pub fn usual() -> Vec<Self> {
        (0..COLUMNS.len())
            .filter(|&k| COLUMNS[k].usual)
            .map(Self::Global)
            .collect()
    }

    /// The row of the list it came from.
    pub fn card(&self) -> &'static Card {
        match self {
            Self::Global(k) | Self::Region(_, k) => &COLUMNS[*k],
            Self::Wall(_, k) => &WALL_COLUMNS[*k],
            Self::Contact(_, _, k) => &CONTACT_COLUMNS[*k],
            Self::Particle(_, k) => &PARTICLE_COLUMNS[*k],
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
            Self::Region(region, _) => format!("region:{region}:{card}"),
        }
    }

    /// Whether the walls, regions and particles it names exist.
    pub fn check(&self, names: &Names) -> Result<(), UnknownColumn> {
        let one_of = |kind: &str, known: &[String], name: &String| {
            if known.contains(name) {
                return Ok(());
            }
            Err(UnknownColumn {
                message: format!("there is no {kind} `{name}`"),
                remedy: nearest(name, known.iter().map(String::as_str)),
            })
        };
        let wall = |w: &String| one_of("wall", &names.walls, w);
        let particle = |id: &u32| {
            if names.particles.binary_search(id).is_ok() {
                return Ok(());
            }
            Err(UnknownColumn {
                message: format!("there is no particle {id}"),
                remedy: match (names.particles.first(), names.particles.last()) {
                    (Some(first), Some(last)) => format!("they are numbered {first} to {last}"),
                    _ => "the scene has none".into(),
                },
            })
        };
        match self {
            Self::Global(_) => Ok(()),
            Self::Wall(w, _) => wall(w),
            Self::Region(name, _) => one_of("region", &names.regions, name),
            Self::Particle(i, _) => particle(i),
            Self::Contact(i, Partner::Particle(j), _) => particle(i).and_then(|()| particle(j)),
            Self::Contact(i, Partner::Wall(w), _) => particle(i).and_then(|()| wall(w)),
        }
    }
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

fn find(list: &'static [Card], name: &str) -> Result<usize, UnknownColumn> {
    list.iter()
        .position(|card| card.name == name)
        .ok_or_else(|| unknown(name, list))
}

fn find_regional(name: &str) -> Result<usize, UnknownColumn> {
    let regional = |card: &&Card| card.regional;
    COLUMNS
        .iter()
        .position(|card| card.regional && card.name == name)
        .ok_or_else(|| UnknownColumn {
            message: format!("`{name}` is no column of a region"),
            remedy: nearest(name, COLUMNS.iter().filter(regional).map(|card| card.name)),
        })
}

fn unknown(name: &str, list: &'static [Card]) -> UnknownColumn {
    UnknownColumn {
        message: format!("`{name}` is no column"),
        remedy: nearest(name, list.iter().map(|card| card.name)),
    }
}

/// "did you mean ...?" when something is near, else the list of what there is.
pub fn nearest<'a>(wrong: &str, known: impl Iterator<Item = &'a str>) -> String {
    let known: Vec<&str> = known.collect();
    let best = known
        .iter()
        .map(|name| {
            (
                strsim::jaro_winkler(&wrong.to_lowercase(), &name.to_lowercase()),
                name,
            )
        })
        .max_by(|a, b| a.0.total_cmp(&b.0));
    match best {
        Some((score, name)) if score > 0.8 => format!("did you mean `{name}`?"),
        Some(_) if known.len() <= 12 => format!("there is {}", known.join(", ")),
        Some((_, name)) => format!("the nearest name is `{name}`"),
        None => "there is none".into(),
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
            "region:core:sin_phi",
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
            ("contact:7:n", "I-J"),
            ("particle:0:x", "from 1"),
            ("region:core:sin_phy", "`sin_phi`"),
            ("region:core:kinetic", "no column of a region"),
        ] {
            let error = Column::parse(wrong).unwrap_err();
            assert!(error.to_string().contains(hint), "{wrong}: {error}");
        }
    }
}
