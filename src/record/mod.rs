//! What is written to disk and read back: histories, checkpoints, journals, whole files. Knows no
//! world: it is handed names, cells and values, and keeps its promises about files whatever they mean.
//!
//! The promises: a row or an event is in its file completely or not at all; a checkpoint or picture
//! is the old one or the new one, never half of either; what cannot be written is said, with the
//! file, the reason in plain words and a remedy.

pub mod checkpoint;
pub mod error;
pub mod history;
pub mod interrupt;
pub mod journal;
pub mod lammps;
pub mod number;
#[cfg(test)]
mod own_process;
pub mod shell_word;
pub mod table;
pub mod vtk;
pub mod whole_file;
mod whole_lines;
