//! Checkpoints: any value that serde knows, in a file that can tell whether it is whole.
//!
//! | bytes | content |
//! |---|---|
//! | 8 | `BALLAST` and a line end |
//! | 4 | format version, little-endian |
//! | 8 | length of the payload, little-endian |
//! | 4 | CRC-32 of the payload, little-endian |
//! | rest | payload: the value in postcard's binary form (floats as their bits), compressed by zstd |
//!
//! The form does not describe itself: when what goes into a checkpoint changes, [`FORMAT`] must.

mod aside;
mod fault;
mod packing;
mod unpacking;

use std::fs::File;
use std::io::{self, Cursor, Read};
use std::path::Path;

use serde::Serialize;
use serde::de::DeserializeOwned;

pub use aside::Aside;
pub use fault::CheckpointFault;

use packing::pack;
use unpacking::read_from;

use super::error::{Attempt, RecordError};
use super::whole_file;

/// The format this program writes and reads.
pub const FORMAT: u32 = 12;

const MAGIC: &[u8; 8] = b"BALLAST\n";
const HEADER: usize = 24;

/// Largest payload and largest content that is read or written [bytes]: ten million particles fit,
/// and no forged length makes the program ask for all memory there is.
const LARGEST: u64 = 4 << 30;

/// Fastest level of zstd: checkpoints are made in the middle of a run.
const LEVEL: i32 = 1;

/// What is compressed or read at a time [bytes].
const CHUNK: usize = 1 << 16;

/// Why a checkpoint was not written or read.
#[derive(Debug)]
enum Failure {
    /// It, or the value, is to blame.
    Fault(CheckpointFault),
    /// The operating system refused.
    Io(io::Error),
}

impl From<CheckpointFault> for Failure {
    fn from(fault: CheckpointFault) -> Self {
        Self::Fault(fault)
    }
}

impl From<io::Error> for Failure {
    fn from(error: io::Error) -> Self {
        Self::Io(error)
    }
}

/// Asked again and again while a checkpoint is written; true ends that with [`CheckpointFault::PutOff`].
pub type PutOff<'a> = &'a dyn Fn() -> bool;

/// Nothing is more urgent.
pub const AT_ONCE: PutOff<'static> = &|| false;

/// Writes `value` to `path`, whole or not at all, as it comes: nowhere do all of its bytes stand in memory.
pub fn write<T: Serialize>(path: &Path, value: &T, put_off: PutOff<'_>) -> Result<(), RecordError> {
    whole_file::write_with(path, |to| {
        pack(value, to, put_off).map_err(|failure| match failure {
            Failure::Fault(fault) => named(path, fault),
            Failure::Io(error) => RecordError::new(path, Attempt::Write, error),
        })
    })
}

/// Reads back what [`write()`] wrote.
pub fn read<T: DeserializeOwned>(path: &Path) -> Result<T, RecordError> {
    let failed = |attempt| move |error| RecordError::new(path, attempt, error);
    let mut file = File::open(path).map_err(failed(Attempt::Open))?;
    let held = file.metadata().map_err(failed(Attempt::Open))?.len();
    read_from(&mut file, held).map_err(|failure| match failure {
        Failure::Fault(fault) => named(path, fault),
        Failure::Io(error) => RecordError::new(path, Attempt::Read, error),
    })
}

/// The bytes of a checkpoint.
pub fn encode<T: Serialize>(value: &T) -> Result<Vec<u8>, CheckpointFault> {
    let mut bytes = Cursor::new(Vec::new());
    match pack(value, &mut bytes, AT_ONCE) {
        Ok(()) => Ok(bytes.into_inner()),
        Err(Failure::Fault(fault)) => Err(fault),
        Err(Failure::Io(error)) => Err(CheckpointFault::Unwritable(error.to_string())),
    }
}

/// The value in the bytes of a checkpoint.
pub fn decode<T: DeserializeOwned>(bytes: &[u8]) -> Result<T, CheckpointFault> {
    let read = read_from(&mut Cursor::new(bytes), bytes.len() as u64);
    read.map_err(|failure| match failure {
        Failure::Fault(fault) => fault,
        Failure::Io(error) => CheckpointFault::Content(error.to_string()),
    })
}

fn named(path: &Path, fault: CheckpointFault) -> RecordError {
    RecordError::Checkpoint {
        path: path.to_path_buf(),
        fault,
    }
}

/// Whether a file begins like a checkpoint, whole or not.
pub fn is_one(path: &Path) -> bool {
    let mut start = Vec::new();
    let read =
        File::open(path).and_then(|file| file.take(MAGIC.len() as u64).read_to_end(&mut start));
    read.is_ok() && start == MAGIC
}

/// What stands before the payload.
struct Header {
    length: u64,
    checksum: u32,
}

impl Header {
    fn bytes(&self) -> [u8; HEADER] {
        let mut bytes = [0; HEADER];
        bytes[..8].copy_from_slice(MAGIC);
        bytes[8..12].copy_from_slice(&FORMAT.to_le_bytes());
        bytes[12..20].copy_from_slice(&self.length.to_le_bytes());
        bytes[20..].copy_from_slice(&self.checksum.to_le_bytes());
        bytes
    }

    fn parse(bytes: &[u8]) -> Result<Self, CheckpointFault> {
        let known = bytes.len().min(MAGIC.len());
        if bytes[..known] != MAGIC[..known] {
            return Err(CheckpointFault::NotACheckpoint);
        }
        let short = CheckpointFault::Truncated {
            held: bytes.len() as u64,
            expected: HEADER as u64,
        };
        let Some((_, rest)) = bytes.split_first_chunk::<8>() else {
            return Err(short);
        };
        let Some((format, rest)) = rest.split_first_chunk::<4>() else {
            return Err(short);
        };
        let found = u32::from_le_bytes(*format);
        if found != FORMAT {
            return Err(CheckpointFault::OtherFormat { found });
        }
        let Some((length, rest)) = rest.split_first_chunk::<8>() else {
            return Err(short);
        };
        let Some((checksum, _)) = rest.split_first_chunk::<4>() else {
            return Err(short);
        };
        Ok(Self {
            length: u64::from_le_bytes(*length),
            checksum: u32::from_le_bytes(*checksum),
        })
    }

    /// Whether a file of `held` bytes holds exactly this header and its payload.
    fn check_length(&self, held: u64) -> Result<(), CheckpointFault> {
        let expected = self.length.saturating_add(HEADER as u64);
        if held < expected {
            return Err(CheckpointFault::Truncated { held, expected });
        }
        if held > expected {
            return Err(CheckpointFault::Trailing {
                bytes: held - expected,
            });
        }
        if self.length > LARGEST {
            return Err(CheckpointFault::TooLarge { bytes: self.length });
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use std::fs;

    use serde::Deserialize;

    use super::unpacking::unpack;
    use super::*;

    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    struct State {
        cycle: u64,
        x: Vec<f64>,
        name: String,
        law: Option<(u32, bool)>,
    }

    fn state() -> State {
        State {
            cycle: 1_000_000,
            x: vec![0.1, -0.0, f64::INFINITY, 5e-324],
            name: "nine discs".into(),
            law: Some((3, true)),
        }
    }

    fn forged(payload: &[u8], length: u64) -> Vec<u8> {
        let mut bytes = MAGIC.to_vec();
        bytes.extend_from_slice(&FORMAT.to_le_bytes());
        bytes.extend_from_slice(&length.to_le_bytes());
        bytes.extend_from_slice(&crc32fast::hash(payload).to_le_bytes());
        bytes.extend_from_slice(payload);
        bytes
    }

    /// The fault found by both ways of reading.
    fn fault_of(bytes: &[u8]) -> CheckpointFault {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("state.ballast");
        fs::write(&path, bytes).unwrap();
        let by_memory = decode::<State>(bytes).unwrap_err();
        match read::<State>(&path).unwrap_err() {
            RecordError::Checkpoint { fault, .. } => assert_eq!(fault, by_memory),
            other => panic!("{other}"),
        }
        by_memory
    }

    #[test]
    fn floats_come_back_as_their_bits() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("state.ballast");
        let odd = f64::from_bits(0x7ff8_dead_beef_0001);
        write(
            &path,
            &State {
                x: vec![odd, -0.0],
                ..state()
            },
            AT_ONCE,
        )
        .unwrap();
        let back: State = read(&path).unwrap();
        let bits: Vec<u64> = back.x.iter().map(|x| x.to_bits()).collect();
        assert_eq!(bits, [odd.to_bits(), (-0.0_f64).to_bits()]);
    }

    #[test]
    fn what_is_put_off_leaves_what_was_there() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("state.ballast");
        // More than goes through at a time.
        let large: Vec<u64> = (0..100_000).collect();
        for old in [None, Some(&large)] {
            if let Some(old) = old {
                write(&path, old, AT_ONCE).unwrap();
            }
            let asked = std::cell::Cell::new(0);
            let second = || asked.replace(asked.get() + 1) > 0;
            let fault = write(&path, &large[1..].to_vec(), &second).unwrap_err();
            let fault = fault.to_string();
            assert!(fault.contains("was put off"), "{fault}");
            assert_eq!(asked.get(), 2);
            let left = fs::read_dir(folder.path()).unwrap().count();
            assert_eq!(left, usize::from(old.is_some()));
            assert_eq!(read::<Vec<u64>>(&path).ok().as_ref(), old);
        }
    }

    #[test]
    fn every_damaged_byte_and_every_truncation_is_an_error() {
        let good = encode(&state()).unwrap();
        assert_eq!(decode::<State>(&good).unwrap(), state());
        for k in 0..good.len() {
            for flip in 1..=255_u8 {
                let mut bad = good.clone();
                bad[k] ^= flip;
                assert!(decode::<State>(&bad).is_err(), "byte {k}, bits {flip:08b}");
            }
            let fault = fault_of(&good[..k]);
            assert!(
                matches!(fault, CheckpointFault::Truncated { .. }),
                "{k}: {fault}"
            );
        }
    }

    #[test]
    fn each_fault_is_told_apart() {
        let good = encode(&state()).unwrap();
        let changed = |k: usize, byte: u8| {
            let mut bytes = good.clone();
            bytes[k] = byte;
            fault_of(&bytes)
        };
        assert_eq!(
            fault_of(b"[about]\ntitle = 1\n"),
            CheckpointFault::NotACheckpoint
        );
        let found = FORMAT + 1;
        let other = CheckpointFault::OtherFormat { found };
        assert_eq!(changed(8, found as u8), other);
        assert_eq!(
            changed(HEADER + 3, !good[HEADER + 3]),
            CheckpointFault::Checksum
        );
        let longer = [good.as_slice(), b"xyz"].concat();
        assert_eq!(fault_of(&longer), CheckpointFault::Trailing { bytes: 3 });

        let other = encode(&(7_u8, "another value")).unwrap();
        assert!(matches!(fault_of(&other), CheckpointFault::Content(_)));
        let followed = encode(&(state(), 1_u8)).unwrap();
        let fault = fault_of(&followed).to_string();
        assert!(fault.contains("1 bytes are left over"), "{fault}");
        let not_zstd = forged(b"plain", 5);
        assert!(matches!(fault_of(&not_zstd), CheckpointFault::Content(_)));
    }

    #[test]
    fn a_forged_length_asks_for_no_memory() {
        let good = encode(&state()).unwrap();
        for length in [LARGEST, u64::MAX - 23, u64::MAX] {
            let fault = fault_of(&forged(&good[HEADER..], length));
            assert!(
                matches!(fault, CheckpointFault::Truncated { .. }),
                "{fault}"
            );
        }
        // A vector of 2^60 numbers that ends at once.
        let content = [&[0_u8][..], &[0xff; 8], &[0x0f]].concat();
        let payload = zstd::bulk::compress(&content, LEVEL).unwrap();
        let fault = fault_of(&forged(&payload, payload.len() as u64));
        assert!(matches!(fault, CheckpointFault::Content(_)), "{fault}");
    }

    #[test]
    fn a_sparse_file_as_large_as_it_says_is_not_loaded() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("huge.ballast");
        let mut bytes = forged(b"", LARGEST + 1);
        bytes.truncate(HEADER);
        fs::write(&path, &bytes).unwrap();
        let file = File::options().write(true).open(&path).unwrap();
        file.set_len(LARGEST + 1 + HEADER as u64).unwrap();
        let error = read::<State>(&path).unwrap_err().to_string();
        assert!(error.contains("at most"), "{error}");
    }

    #[test]
    fn a_small_payload_cannot_unfold_without_end() {
        let content = postcard::to_allocvec(&vec![0_u8; 1 << 20]).unwrap();
        let payload = zstd::bulk::compress(&content, LEVEL).unwrap();
        assert!(payload.len() < 1000);
        let unpacked = |most: usize| unpack::<Vec<u8>>(&payload[..], most as u64);
        assert!(unpacked(content.len()).unwrap() == vec![0; 1 << 20]);
        for most in [content.len() - 1, 1 << 19] {
            let fault = unpacked(most).unwrap_err();
            assert!(matches!(fault, CheckpointFault::TooLarge { .. }), "{fault}");
        }
    }
}
