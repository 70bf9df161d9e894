//! Reading a checkpoint as it comes: first its checksum, then its content piece by piece, so that only the
//! value itself takes memory, and no more of it than there is content.

use std::io::{self, BufRead, BufReader, Read, Seek, SeekFrom};

use postcard::de_flavors::Flavor;
use serde::de::DeserializeOwned;

use super::{CHUNK, CheckpointFault, Failure, HEADER, Header, LARGEST};

/// The value in a checkpoint of `held` bytes.
pub(super) fn read_from<T: DeserializeOwned, R: Read + Seek>(
    from: &mut R,
    held: u64,
) -> Result<T, Failure> {
    let mut start = Vec::new();
    from.take(HEADER as u64).read_to_end(&mut start)?;
    // Before the rest is read: a wrong file may be of any size.
    let header = Header::parse(&start)?;
    header.check_length(held)?;
    if checksum(BufReader::with_capacity(CHUNK, &mut *from))? != header.checksum {
        return Err(CheckpointFault::Checksum.into());
    }
    from.seek(SeekFrom::Start(HEADER as u64))?;
    Ok(unpack(from, LARGEST)?)
}

fn checksum(mut from: impl BufRead) -> io::Result<u32> {
    let mut checksum = crc32fast::Hasher::new();
    loop {
        let part = from.fill_buf()?;
        if part.is_empty() {
            return Ok(checksum.finalize());
        }
        checksum.update(part);
        let length = part.len();
        from.consume(length);
    }
}

/// The value in a payload that unfolds to `largest` bytes at most.
pub(super) fn unpack<T: DeserializeOwned>(
    payload: impl Read,
    largest: u64,
) -> Result<T, CheckpointFault> {
    let unreadable = |error: io::Error| CheckpointFault::Content(error.to_string());
    let decoder = zstd::Decoder::new(payload).map_err(unreadable)?;
    let mut content = Content {
        from: BufReader::with_capacity(CHUNK, decoder.take(largest + 1)),
        piece: Vec::new(),
        broke: None,
    };
    let value = T::deserialize(&mut postcard::Deserializer::from_flavor(&mut content));
    let left = io::copy(&mut content.from, &mut io::sink());
    if content.from.get_ref().limit() == 0 {
        return Err(CheckpointFault::TooLarge { bytes: largest + 1 });
    }
    if let Some(error) = content.broke {
        return Err(unreadable(error));
    }
    match (value, left.map_err(unreadable)?) {
        (Ok(value), 0) => Ok(value),
        (Ok(_), left) => Err(CheckpointFault::Content(format!(
            "{left} bytes are left over"
        ))),
        (Err(error), _) => Err(CheckpointFault::Content(error.to_string())),
    }
}

/// The content, for postcard.
struct Content<R> {
    from: BufReader<R>,
    /// The piece that was asked for last.
    piece: Vec<u8>,
    /// Why no more could be read, but that it was all.
    broke: Option<io::Error>,
}

impl<R: Read> Content<R> {
    /// Reads the next bytes into `piece`; its memory grows with what is there, not with what is asked for.
    fn read(&mut self, count: usize) -> postcard::Result<()> {
        self.piece.clear();
        let mut next = (&mut self.from).take(count as u64);
        if let Err(error) = next.read_to_end(&mut self.piece) {
            self.broke = Some(error);
        }
        if self.piece.len() == count {
            Ok(())
        } else {
            Err(postcard::Error::DeserializeUnexpectedEnd)
        }
    }
}

impl<'de, R: Read> Flavor<'de> for &'de mut Content<R> {
    type Remainder = ();
    type Source = R;

    #[inline]
    fn pop(&mut self) -> postcard::Result<u8> {
        if let Some(&byte) = self.from.buffer().first() {
            self.from.consume(1);
            return Ok(byte);
        }
        self.read(1)?;
        Ok(self.piece[0])
    }

    /// What comes and goes cannot be lent.
    fn try_take_n(&mut self, _: usize) -> postcard::Result<&'de [u8]> {
        Err(postcard::Error::WontImplement)
    }

    #[inline]
    fn try_take_n_temp<'a>(&'a mut self, count: usize) -> postcard::Result<&'a [u8]>
    where
        'de: 'a,
    {
        self.read(count)?;
        Ok(&self.piece)
    }

    fn finalize(self) -> postcard::Result<()> {
        Ok(())
    }
}
