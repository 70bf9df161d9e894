//! Writing a checkpoint as it comes: the binary form goes through the compressor and the checksum into
//! its file by small pieces, so a large world needs no second place in memory.

use std::cell::Cell;
use std::io::{self, BufWriter, Seek, SeekFrom, Write};

use serde::Serialize;

use super::{CHUNK, CheckpointFault, Failure, HEADER, Header, LARGEST, LEVEL, PutOff};

/// Writes the checkpoint of a value where `to` stands, at its beginning; leaves it unfinished once it is
/// asked to be put off.
pub(super) fn pack<T: Serialize, W: Write + Seek>(
    value: &T,
    to: W,
    put_off: PutOff<'_>,
) -> Result<(), Failure> {
    let mut payload = Payload {
        to,
        length: 0,
        checksum: crc32fast::Hasher::new(),
        refused: None,
    };
    payload.to.write_all(&[0; HEADER])?;
    let packed = compress(value, &mut payload, put_off);
    // What the system refused says more than what serde makes of it.
    if let Some(error) = payload.refused {
        return Err(error.into());
    }
    packed?;
    let header = Header {
        length: payload.length,
        checksum: payload.checksum.finalize(),
    };
    let mut to = payload.to;
    to.seek(SeekFrom::Start(0))?;
    to.write_all(&header.bytes())?;
    Ok(to.flush()?)
}

fn compress<T: Serialize>(
    value: &T,
    to: &mut dyn Write,
    asked: PutOff<'_>,
) -> Result<(), CheckpointFault> {
    let put_off = Cell::new(false);
    let unwritable = |error: &dyn std::fmt::Display| {
        if put_off.get() {
            CheckpointFault::PutOff
        } else {
            CheckpointFault::Unwritable(error.to_string())
        }
    };
    let packer = zstd::Encoder::new(to, LEVEL).map_err(|error| unwritable(&error))?;
    let counted = Counted {
        to: packer,
        bytes: 0,
        asked,
        put_off: &put_off,
    };
    let content = postcard::to_io(value, BufWriter::with_capacity(CHUNK, counted))
        .map_err(|error| unwritable(&error))?;
    let Counted {
        to: packer, bytes, ..
    } = content.into_inner().map_err(|error| unwritable(&error))?;
    if bytes > LARGEST {
        return Err(CheckpointFault::TooLarge { bytes });
    }
    packer
        .finish()
        .map(drop)
        .map_err(|error| unwritable(&error))
}

/// Counts what goes through [bytes], until it is asked to be put off.
struct Counted<'a, W> {
    to: W,
    bytes: u64,
    asked: PutOff<'a>,
    put_off: &'a Cell<bool>,
}

impl<W: Write> Write for Counted<'_, W> {
    fn write(&mut self, part: &[u8]) -> io::Result<usize> {
        if self.put_off.get() || (self.asked)() {
            self.put_off.set(true);
            return Err(io::ErrorKind::Other.into());
        }
        let written = self.to.write(part)?;
        self.bytes += written as u64;
        Ok(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.to.flush()
    }
}

/// What follows the header: measured and summed up on its way.
struct Payload<W> {
    to: W,
    length: u64,
    checksum: crc32fast::Hasher,
    /// What the system said when it took no more.
    refused: Option<io::Error>,
}

impl<W: Write> Write for Payload<W> {
    fn write(&mut self, part: &[u8]) -> io::Result<usize> {
        match self.to.write(part) {
            Ok(written) => {
                self.length += written as u64;
                self.checksum.update(&part[..written]);
                Ok(written)
            }
            Err(error) if error.kind() == io::ErrorKind::Interrupted => Err(error),
            Err(error) => {
                let again = io::Error::from(error.kind());
                self.refused.get_or_insert(error);
                Err(again)
            }
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        self.to.flush()
    }
}
