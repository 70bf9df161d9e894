//! What was measured, as rows of text and as CSV.

use super::{Measured, Memory};
use crate::engine::phase::Phase;
use crate::record::number::Cell;
use crate::record::table::CsvTable;
use crate::session::figure::rough;

/// Head and rows for people: rates, memory, what is moved, then shares of the time in per cent.
pub fn rows(all: &[Measured], memory: &Memory) -> Vec<Vec<String>> {
    let mut head: Vec<String> = [
        "scene",
        "law",
        "isa",
        "threads",
        "particles",
        "contacts",
        "pairs",
        "busy",
        "cycles/s",
        "M updates/s",
        "ns/update",
        "list lasts",
        "B/particle",
        "B/pair",
        "MB/cycle",
        "GB/s",
        "of copy %",
    ]
    .map(str::to_owned)
    .to_vec();
    head.extend(Phase::ALL.map(|(name, _)| format!("{name} %")));
    let mut rows = vec![head];
    for measured in all {
        let lasts = measured
            .list_lasts
            .map_or_else(|| "all".to_owned(), |cycles| format!("{cycles:.0}"));
        let mut row = vec![
            measured.scene.clone(),
            measured.law.to_owned(),
            measured.isa.clone(),
            measured.threads.to_string(),
            measured.particles.to_string(),
            format!("{:.0}", measured.contacts),
            measured.pairs.to_string(),
            format!("{:.2}", measured.busy),
            rough(measured.rate),
            rough(1e-6 * measured.updates()),
            rough(1e9 / measured.updates()),
            lasts,
            measured.bytes.particle.to_string(),
            measured.bytes.contact.to_string(),
            rough(1e-6 * measured.traffic.bytes() as f64),
            rough(1e-9 * measured.moved()),
            share_of_copy(measured, memory).map_or_else(
                || "cached".to_owned(),
                |share| format!("{:.1}", 100.0 * share),
            ),
        ];
        row.extend(measured.shares.map(|share| format!("{:.1}", 100.0 * share)));
        rows.push(row);
    }
    rows
}

fn share_of_copy(measured: &Measured, memory: &Memory) -> Option<f64> {
    memory.share(measured.traffic.bytes(), measured.rate)
}

/// The same with all digits, and the machine.
pub fn csv(all: &[Measured], memory: &Memory, machine: &str) -> CsvTable {
    let mut names = vec![
        "scene",
        "law",
        "isa",
        "threads",
        "particles",
        "contacts",
        "pairs",
        "cycles",
        "busy",
        "cycles_per_s",
        "contact_updates_per_s",
        "cycles_per_list",
        "bytes_per_particle",
        "bytes_per_pair",
        "bytes_of_law",
        "peak_bytes",
        "bytes_per_cycle",
        "bytes_per_s",
        "copy_bytes_per_s",
        "share_of_copy",
    ];
    let shares = Phase::ALL.map(|(name, _)| format!("share_{name}"));
    names.extend(shares.iter().map(String::as_str));
    names.extend(["mean_stress", "state_hash", "machine"]);
    let mut table = CsvTable::new(&names);
    for measured in all {
        let bytes = measured.bytes;
        let mut row = vec![
            Cell::name(&measured.scene),
            Cell::name(measured.law),
            Cell::name(&measured.isa),
            Cell::Count(measured.threads as u64),
            Cell::Count(measured.particles as u64),
            Cell::Real(measured.contacts),
            Cell::Count(measured.pairs as u64),
            Cell::Count(measured.cycles),
            Cell::Real(measured.busy),
            Cell::Real(measured.rate),
            Cell::Real(measured.updates()),
            Cell::Real(measured.list_lasts.unwrap_or(f64::NAN)),
            Cell::Count(bytes.particle as u64),
            Cell::Count(bytes.contact as u64),
            Cell::Count(bytes.law as u64),
            measured.peak.map_or(Cell::Real(f64::NAN), Cell::Count),
            Cell::Count(measured.traffic.bytes() as u64),
            Cell::Real(measured.moved()),
            Cell::Real(memory.copy),
            Cell::Real(share_of_copy(measured, memory).unwrap_or(f64::NAN)),
        ];
        row.extend(measured.shares.map(Cell::Real));
        row.extend([
            Cell::Real(measured.stress),
            Cell::Hash(measured.state),
            Cell::name(machine),
        ]);
        table.row(&row);
    }
    table
}
