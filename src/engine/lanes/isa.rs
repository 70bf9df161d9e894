//! Which vector instructions are used: the widest there are, or what was asked for.

use std::fmt;
use std::str::FromStr;
use std::sync::OnceLock;

/// What was asked for, for all worlds made from then on.
static CHOSEN: OnceLock<Isa> = OnceLock::new();

/// Vector instructions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Isa {
    /// What every processor of the kind has: one lane.
    Baseline,
    /// Four lanes.
    Avx2,
    /// Eight lanes.
    Avx512,
}

/// What was chosen, or the widest.
impl Default for Isa {
    fn default() -> Self {
        *CHOSEN.get_or_init(Self::widest)
    }
}

impl Isa {
    /// Chooses for all worlds made from now on; too late, and `false`, when one was made.
    pub fn choose(self) -> bool {
        CHOSEN.set(self).is_ok()
    }

    /// All of them, narrowest first.
    pub const ALL: [Self; 3] = [Self::Baseline, Self::Avx2, Self::Avx512];

    /// The widest that this processor has.
    pub fn widest() -> Self {
        *Self::ALL
            .iter()
            .rfind(|isa| isa.is_here())
            .unwrap_or(&Self::Baseline)
    }

    /// Whether this processor has it.
    #[cfg(target_arch = "x86_64")]
    pub fn is_here(self) -> bool {
        match self {
            Self::Baseline => true,
            Self::Avx2 => is_x86_feature_detected!("avx2") && is_x86_feature_detected!("popcnt"),
            Self::Avx512 => {
                is_x86_feature_detected!("avx512f")
                    && is_x86_feature_detected!("avx512dq")
                    && is_x86_feature_detected!("avx512vl")
                    && Self::Avx2.is_here()
            }
        }
    }

    /// Whether this processor has it.
    #[cfg(not(target_arch = "x86_64"))]
    pub fn is_here(self) -> bool {
        self == Self::Baseline
    }

    /// Contacts that are worked on at once.
    pub fn lanes(self) -> usize {
        match self {
            Self::Baseline => 1,
            Self::Avx2 => 4,
            Self::Avx512 => 8,
        }
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Baseline => "baseline",
            Self::Avx2 => "avx2",
            Self::Avx512 => "avx512",
        }
    }
}

impl fmt::Display for Isa {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Isa {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, String> {
        let isa = Self::ALL.into_iter().find(|isa| isa.name() == name);
        let isa = isa.ok_or_else(|| {
            let names = Self::ALL.map(Self::name).join(", ");
            format!("no instructions `{name}`: choose one of {names}")
        })?;
        if isa.is_here() {
            Ok(isa)
        } else {
            Err(format!(
                "this processor has no {isa}: the widest it has is {}",
                Self::widest()
            ))
        }
    }
}
