//! A checkpoint kept at hand in case it is needed: a small one in memory, a large one in a file that has
//! no name, so that it goes with the process however that ends.

use std::io::{Read, Seek, SeekFrom};
use std::path::Path;

use serde::Serialize;
use tempfile::SpooledTempFile;

use super::packing::pack;
use super::{Attempt, CheckpointFault, Failure, PutOff, RecordError};
use crate::record::whole_file;

/// What stays in memory at most [bytes].
const SMALL: usize = 1 << 20;

/// A checkpoint without a name.
#[derive(Debug)]
pub struct Aside(SpooledTempFile);

impl Aside {
    /// Of a value. A large one goes to the disk that holds `folder`; where that is not known, or has no
    /// room, to memory.
    pub fn of<T: Serialize>(
        value: &T,
        folder: Option<&Path>,
        put_off: PutOff<'_>,
    ) -> Result<Self, CheckpointFault> {
        let on_disk = folder.map(|folder| {
            // A path without a folder is one in the current folder.
            let here = folder.as_os_str().is_empty();
            let folder = if here { Path::new(".") } else { folder };
            Self::filled(value, tempfile::spooled_tempfile_in(SMALL, folder), put_off)
        });
        let kept = match on_disk {
            Some(Err(Failure::Io(_))) | None => {
                Self::filled(value, tempfile::spooled_tempfile(usize::MAX), put_off)
            }
            Some(kept) => kept,
        };
        kept.map_err(|failure| match failure {
            Failure::Fault(fault) => fault,
            Failure::Io(error) => CheckpointFault::Unwritable(error.to_string()),
        })
    }

    fn filled<T: Serialize>(
        value: &T,
        mut to: SpooledTempFile,
        put_off: PutOff<'_>,
    ) -> Result<Self, Failure> {
        pack(value, &mut to, put_off)?;
        Ok(Self(to))
    }

    /// Writes it to `path`, whole or not at all.
    pub fn write(&mut self, path: &Path) -> Result<(), RecordError> {
        let failed = |attempt| move |error| RecordError::new(path, attempt, error);
        let from = &mut self.0;
        whole_file::write_with(path, |to| {
            from.seek(SeekFrom::Start(0))
                .map_err(failed(Attempt::Read))?;
            let mut part = vec![0; super::CHUNK];
            loop {
                let length = from.read(&mut part).map_err(failed(Attempt::Read))?;
                if length == 0 {
                    return Ok(());
                }
                to.write_all(&part[..length])
                    .map_err(failed(Attempt::Write))?;
            }
        })
    }

    /// Whether it is in a file.
    pub fn is_on_disk(&self) -> bool {
        self.0.is_rolled()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::checkpoint::{AT_ONCE, decode, encode, read};

    /// More than stays in memory, of a kind that no compressor makes smaller.
    fn large() -> Vec<u64> {
        let mut state = 1_u64;
        let step = || {
            // xorshift64 of Marsaglia (2003).
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            state
        };
        std::iter::repeat_with(step)
            .take(SMALL / 8 + 1000)
            .collect()
    }

    #[test]
    fn it_is_the_same_checkpoint_wherever_it_is_kept() {
        let folder = tempfile::tempdir().unwrap();
        for (value, on_disk) in [(vec![1, 2, 3], false), (large(), true)] {
            let bytes = encode(&value).unwrap();
            for place in [Some(folder.path()), None] {
                let mut aside = Aside::of(&value, place, AT_ONCE).unwrap();
                assert_eq!(aside.is_on_disk(), on_disk && place.is_some());
                let names = std::fs::read_dir(folder.path()).unwrap().count();
                assert_eq!(names, 0, "it has a name");
                let path = folder.path().join("state.ballast");
                // As often as it is asked for.
                for _ in 0..2 {
                    aside.write(&path).unwrap();
                    assert!(std::fs::read(&path).unwrap() == bytes);
                    assert!(read::<Vec<u64>>(&path).unwrap() == value);
                    std::fs::remove_file(&path).unwrap();
                }
            }
            assert!(decode::<Vec<u64>>(&bytes).unwrap() == value);
        }
    }

    #[test]
    fn where_no_file_can_be_made_memory_keeps_it() {
        let folder = tempfile::tempdir().unwrap();
        let mut aside = Aside::of(&large(), Some(&folder.path().join("no")), AT_ONCE).unwrap();
        assert!(!aside.is_on_disk());
        let path = folder.path().join("state.ballast");
        aside.write(&path).unwrap();
        assert!(read::<Vec<u64>>(&path).unwrap() == large());
    }
}
