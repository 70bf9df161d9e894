//! Files that runs leave behind, named where a preset is expected: told apart by how they begin.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use crate::record::checkpoint;
use crate::record::journal::looks_like_journal;
use crate::record::shell_word::shell_word;
use crate::scene::catalogue;

/// What a run left behind.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Recorded {
    Checkpoint,
    Journal,
}

/// A journal shows by then that it is one, byte order mark included.
const BEGINNING: u64 = 64;

impl Recorded {
    /// What this name stands for, if it is such a file. An embedded preset comes first, as everywhere.
    pub(super) fn find(name: &str) -> Option<Self> {
        let path = Path::new(name);
        // A pipe that holds a preset must not lose its beginning.
        let regular = std::fs::metadata(path).is_ok_and(|file| file.is_file());
        if catalogue::find(name).is_some() || !regular {
            return None;
        }
        if checkpoint::is_one(path) {
            return Some(Self::Checkpoint);
        }
        let mut start = Vec::new();
        let file = File::open(path).ok()?;
        file.take(BEGINNING).read_to_end(&mut start).ok()?;
        looks_like_journal(&String::from_utf8_lossy(&start)).then_some(Self::Journal)
    }

    /// What to do with it where a preset is wanted.
    pub(super) fn advice(self, name: &str) -> String {
        let word = shell_word(name);
        match self {
            Self::Checkpoint => format!(
                "{name} is a checkpoint and no preset: go on with it in the workbench with\n  ballast \
                 {word}\nor without a screen with\n  ballast run --resume {word} --csv FILE.csv"
            ),
            Self::Journal => format!(
                "{name} is a journal and no preset: repeat its run with\n  ballast run {word} --csv \
                 FILE.csv"
            ),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_are_told_apart_by_their_beginning() {
        let folder = tempfile::tempdir().unwrap();
        for (held, expected) in [
            (&b"BALLAST\n\x09\0\0\0"[..], Some(Recorded::Checkpoint)),
            (b"ballast journal 1\nprogram", Some(Recorded::Journal)),
            (
                "\u{feff}ballast journal 1\n".as_bytes(),
                Some(Recorded::Journal),
            ),
            (b"[about]\n", None),
            (b"BALL", None),
            (b"", None),
        ] {
            let path = folder.path().join("file");
            std::fs::write(&path, held).unwrap();
            assert_eq!(Recorded::find(path.to_str().unwrap()), expected);
        }
        assert_eq!(Recorded::find("two-discs"), None);
        assert_eq!(Recorded::find("/dev/null"), None);
    }
}
