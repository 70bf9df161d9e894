//! The same bytes every time, with any number of threads, checkpointed or not.

use super::{assert_same, bytes, run, scenes, text};

#[test]
fn nine_discs_give_the_same_bytes_every_time() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    let first = run(folder, "nine-disc-compression --csv -").stdout;
    let rows = String::from_utf8_lossy(&first).lines().count();
    // The header, cycle 0 and one row per cycle of the five stages.
    assert_eq!(rows, 2 + 40 + 1000 + 1500 + 400 + 2000);
    for options in [
        "",
        "--threads 1",
        "--threads 2",
        "--threads 3",
        "--quiet",
        "--every 0.01 --checkpoint c.ballast",
        "--every 0.001 --checkpoint c.ballast --threads 2",
    ] {
        let again = run(folder, &format!("nine-disc-compression --csv - {options}"));
        assert_same(&again.stdout, &first, options);
    }
    run(folder, "nine-disc-compression --csv file.csv --every 0.01");
    assert_same(&bytes(folder, "file.csv"), &first, "--csv FILE");
}

#[test]
fn a_scene_that_threads_share_gives_the_same_bytes() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    scenes::write_block(folder);
    run(folder, "block.toml --csv one.csv");
    let one = bytes(folder, "one.csv");
    assert!(text(folder, "one.csv").contains("\n50,"));
    for options in ["--threads 2", "--threads 3 --every 0.01", "--threads 7"] {
        let again = run(folder, &format!("block.toml --csv - {options}"));
        assert_same(&again.stdout, &one, options);
    }
    // Something happens in it: otherwise the same bytes would show nothing.
    let mut hashes: Vec<&str> = std::str::from_utf8(&one)
        .expect("it is text")
        .lines()
        .filter_map(|row| row.split(',').nth(3))
        .collect();
    let rows = hashes.len();
    hashes.sort_unstable();
    hashes.dedup();
    assert_eq!(hashes.len(), rows, "every row has another state");
}

#[test]
fn another_scene_gives_other_bytes() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    let plain = run(folder, "nine-disc-compression --csv -").stdout;
    let set = "nine-disc-compression --csv - --set material.disc.density=1000.0000000001";
    assert_ne!(run(folder, set).stdout, plain);
}
