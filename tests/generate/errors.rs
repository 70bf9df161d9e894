//! What is refused, where, and with which remedy.

use crate::refusal;

/// What is replaced by what in a good table, and parts of the report.
const CASES: &[(&str, &str, [&str; 3])] = &[
    (
        "max = [1, 1]",
        "max = [1, 0]",
        [
            "the `rectangle` has no area",
            "g.toml:8:",
            "`min` is the lower left corner",
        ],
    ),
    (
        "radius = 0.1",
        "radius = 0.6",
        [
            "radius 0.6 m is larger than the region",
            "g.toml:9:",
            "0.5 m at most",
        ],
    ),
    (
        "count = 3",
        "count = -3",
        [
            "`count` of `grading` 1 cannot be `-3`",
            "g.toml:9:",
            "whole number from 0",
        ],
    ),
    (
        "\"m\"",
        "\"n\"",
        [
            "there is no material `n` for generate 1",
            "g.toml:7:",
            "there is m",
        ],
    ),
    (
        "grading = [{ radius = 0.1, count = 3 }]",
        "grading = []",
        [
            "the `grading` of generate 1 is empty",
            "g.toml:9:",
            "expected a size or more",
        ],
    ),
    (
        "grading = [{ radius = 0.1, count = 3 }]",
        "gap = 0.1",
        ["generate 1 places nothing", "g.toml:6:", "add grading = "],
    ),
    (
        "rectangle = { min = [0, 0], max = [1, 1] }",
        "polygon = [[0, 0], [1, 1], [1, 0], [0, 1]]",
        [
            "crosses or touches itself: sides 1-2 and 3-4",
            "g.toml:8:",
            "list the corners once around",
        ],
    ),
    (
        "rectangle = { min = [0, 0], max = [1, 1] }",
        "polygon = [[0, 0], [1, 1], [2, 2]]",
        [
            "crosses or touches itself",
            "g.toml:8:",
            "meet at corners only",
        ],
    ),
    (
        "rectangle = { min = [0, 0], max = [1, 1] }",
        "polygon = [[0, 0], [1, 1]]",
        [
            "the `polygon` has no area",
            "g.toml:8:",
            "three corners or more",
        ],
    ),
    (
        "rectangle = { min = [0, 0], max = [1, 1] }",
        "",
        [
            "`in` of generate 1 is nowhere",
            "neither `circle`, `rectangle` nor `polygon`",
            "write circle = ",
        ],
    ),
    (
        "min = [0, 0], max = [1, 1]",
        "min = [1e15, 0], max = [2e15, 1]",
        [
            "the region of generate 1 is too far away",
            "g.toml:8:",
            "move the scene towards the origin",
        ],
    ),
    (
        "count = 3",
        "count = 10_000_001",
        ["`count` of `grading` 1 cannot be", "g.toml:9:", "10000000"],
    ),
    (
        "radius = 0.1, count = 3",
        "radius = 1e-5",
        ["may fit", "10000000 at most", "give a `count`"],
    ),
    (
        "grading",
        "spacing = 1\nlattice = \"square\"\ngrading",
        [
            "`grading` and `lattice` of generate 1 exclude each other",
            "means nothing with `grading`",
            "leave it out",
        ],
    ),
    (
        "grading",
        "order = \"curve\"\ngrading",
        [
            "`order` of generate 1 means nothing with `grading`",
            "g.toml:9:",
            "leave it out",
        ],
    ),
    (
        "grading = [{ radius = 0.1, count = 3 }]",
        "lattice = \"square\"",
        [
            "generate 1 has no `radius`",
            "needs the radius",
            "add radius",
        ],
    ),
    (
        "grading = [{ radius = 0.1, count = 3 }]",
        "lattice = \"square\"\nradius = 0.6",
        [
            "no site of the lattice lies in the region",
            "g.toml:8:",
            "a smaller spacing",
        ],
    ),
    (
        "grading = [{ radius = 0.1, count = 3 }]",
        "lattice = \"square\"\nradius = 1e-5",
        [
            "the lattice has 2500000000 particles",
            "g.toml:10:",
            "10000000 at most",
        ],
    ),
    (
        "grading = [{ radius = 0.1, count = 3 }]",
        "lattice = \"hexagonal\"\nradius = 0.05\nperiodic = true",
        [
            "does not close: the cell is 1 m high",
            "a multiple of 0.1732",
            "make it 1.0392",
        ],
    ),
    (
        "grading = [{ radius = 0.1, count = 3 }]",
        "distribution = { kind = \"normal\", mean = 0.01, count = 3, exponent = 2 }",
        [
            "the distribution `normal` has no `deviation`",
            "a normal distribution has no `exponent`",
            "g.toml:9:",
        ],
    ),
    (
        "grading = [{ radius = 0.1, count = 3 }]",
        "distribution = { kind = \"normal\", mean = 0.01, deviation = 0.004, count = 3 }",
        [
            "the radii go from -0.00",
            "expected 0 < min <= max",
            "give both `min` and `max`",
        ],
    ),
    (
        "grading = [{ radius = 0.1, count = 3 }]",
        "distribution = { kind = \"normal\", mean = 0.01, deviation = 0.001, min = 0.02, max = 0.03, count = 3 }",
        [
            "hardly any radius",
            "less than 1 % of it does",
            "towards the mean",
        ],
    ),
];

#[test]
fn what_is_wrong_is_told_with_its_place() {
    let good = "[[generate]]\nmaterial = \"m\"\n\
                in = { rectangle = { min = [0, 0], max = [1, 1] } }\n\
                grading = [{ radius = 0.1, count = 3 }]\n";
    for (from, to, parts) in CASES {
        assert!(good.contains(from), "{from}");
        let refused = refusal(&good.replace(from, to));
        for part in parts {
            assert!(refused.contains(part), "{to}: {part}\n{refused}");
        }
    }
}

#[test]
fn a_preset_without_particles_names_both_ways() {
    let refused = refusal("");
    assert!(
        refused.contains("no [[particle]] and no [[generate]]"),
        "{refused}"
    );
}
