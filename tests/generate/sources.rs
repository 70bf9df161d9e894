//! Lattices, distributions and files.

use std::fs;
use std::path::Path;

use crate::program::{ballast, said};
use crate::{least_apart, preset, scene, scene_with};
use ballast::engine::setup::ParticleSetup;
use ballast::scene::Scene;

fn lattice(kind: &str, region: &str, more: &str) -> Scene {
    scene(&format!(
        "[[generate]]\nmaterial = \"m\"\nlattice = \"{kind}\"\nradius = 0.5\nin = {{ {region} }}\n{more}\n"
    ))
}

fn places(scene: &Scene) -> Vec<[f64; 2]> {
    scene.setup.particles.iter().map(|p| p.at).collect()
}

#[test]
fn a_square_lattice_fills_a_rectangle_from_its_corner() {
    let scene = lattice(
        "square",
        "rectangle = { min = [-1, 2], max = [2, 4.5] }",
        "",
    );
    let expected = [
        [-0.5, 2.5],
        [0.5, 2.5],
        [1.5, 2.5],
        [-0.5, 3.5],
        [0.5, 3.5],
        [1.5, 3.5],
    ];
    assert_eq!(places(&scene), expected);
    assert_eq!(least_apart(&scene.setup.particles), 0.0);
}

#[test]
fn a_hexagonal_lattice_has_rows_half_root_three_apart() {
    let scene = lattice(
        "hexagonal",
        "rectangle = { min = [0, 0], max = [3, 2] }",
        "",
    );
    let row = 0.5 * 3f64.sqrt();
    let expected = [
        [0.5, 0.5],
        [1.5, 0.5],
        [2.5, 0.5],
        [1.0, 0.5 + row],
        [2.0, 0.5 + row],
    ];
    assert_eq!(places(&scene), expected);
}

#[test]
fn a_lattice_in_a_circle_has_a_site_at_its_centre() {
    for (kind, count) in [("square", 5), ("hexagonal", 7)] {
        let scene = lattice(kind, "circle = { centre = [7, -3], radius = 1.5 }", "");
        assert_eq!(scene.setup.particles.len(), count, "{kind}");
        assert!(places(&scene).contains(&[7.0, -3.0]));
    }
}

#[test]
fn a_periodic_lattice_closes() {
    // Overlapping by a hundredth of the diameter: D = 2R - alpha.
    let more = "spacing = 0.99\nperiodic = true";
    let (s, row) = (0.99, 0.99 * 0.5 * 3f64.sqrt());
    let cells = [
        ("square", format!("[{}, {}]", 10.0 * s, 7.0 * s), 70),
        ("hexagonal", format!("[{}, {}]", 10.0 * s, 8.0 * row), 80),
    ];
    for (kind, size, count) in cells {
        let region = format!("rectangle = {{ min = [0, 0], max = {size} }}");
        let scene = lattice(kind, &region, more);
        assert_eq!(scene.setup.particles.len(), count, "{kind}");
        let density = count as f64 / scene.generated[0].area.unwrap();
        let cell = if kind == "square" { s * s } else { s * row };
        assert!(
            (density * cell - 1.0).abs() < 1e-12,
            "{kind}: one particle for each cell"
        );
    }
}

#[test]
fn distributions_have_their_moments() {
    const N: f64 = 20_000.0;
    let drawn = |distribution: &str| -> Vec<f64> {
        let scene = scene(&format!(
            "[[generate]]\nmaterial = \"m\"\nin = {{ rectangle = {{ min = [0, 0], max = [1, 1] }} }}\n\
             distribution = {{ count = 20000, {distribution} }}\n"
        ));
        assert_eq!(scene.setup.particles.len(), 20_000);
        scene.setup.particles.iter().map(|p| p.radius).collect()
    };
    // Mean and variance of the radius in units of 0.001, from their integrals.
    let half = 0.5f64;
    // Normal of mean 2 and deviation 0.5, cut at three deviations: the variance shrinks by
    // 1 - 6 phi(3) / (2 Phi(3) - 1).
    let cut = 1.0 - 6.0 * 0.004_431_848_411_938_008 / 0.997_300_203_936_739_8;
    let cases = [
        (
            "kind = \"uniform\", min = 1e-3, max = 3e-3",
            2.0,
            4.0 / 12.0,
        ),
        (
            "kind = \"normal\", mean = 2e-3, deviation = 0.5e-3",
            2.0,
            half * half * cut,
        ),
        // Density r^-2 between 1 and 3: mean 1.5 ln 3, mean square 3.
        (
            "kind = \"power\", exponent = 2, min = 1e-3, max = 3e-3",
            1.5 * 3f64.ln(),
            3.0 - (1.5 * 3f64.ln()).powi(2),
        ),
        // Density 1/r between 1 and e: mean e - 1, mean square (e^2 - 1)/2.
        (
            "kind = \"power\", exponent = 1, min = 1e-3, max = 2.718281828459045e-3",
            1f64.exp() - 1.0,
            (2f64.exp() - 1.0) / 2.0 - (1f64.exp() - 1.0).powi(2),
        ),
    ];
    for (distribution, mean, variance) in cases {
        let radii = drawn(distribution);
        let found = radii.iter().sum::<f64>() / N * 1e3;
        let square = radii.iter().map(|r| (r * 1e3 - mean).powi(2)).sum::<f64>() / N;
        // Five deviations of the mean; the fourth moments are all below three squared variances.
        assert!(
            (found - mean).abs() < 5.0 * (variance / N).sqrt(),
            "{distribution}: {found}"
        );
        let error = 5.0 * variance * (2.0 / N).sqrt();
        assert!(
            (square - variance).abs() < error,
            "{distribution}: {square} {variance}"
        );
    }
    // The logarithm of a lognormal radius is normal: mean ln m - s^2/2, variance s^2 = ln(1 + (d/m)^2).
    let logs: Vec<f64> = drawn("kind = \"lognormal\", mean = 2e-3, deviation = 1e-3")
        .iter()
        .map(|r| r.ln())
        .collect();
    let s2 = 1.25f64.ln();
    let mean = logs.iter().sum::<f64>() / N;
    let expected = 2e-3f64.ln() - 0.5 * s2;
    assert!(
        (mean - expected).abs() < 5.0 * (s2 / N).sqrt(),
        "{mean} {expected}"
    );
    let variance = logs.iter().map(|x| (x - expected).powi(2)).sum::<f64>() / N;
    assert!(
        (variance - s2 * cut).abs() < 5.0 * s2 * (2.0 / N).sqrt(),
        "{variance}"
    );
}

fn write(folder: &Path, name: &str, text: &str) {
    fs::write(folder.join(name), text).expect("it can be written");
}

fn load(folder: &Path, set: &[&str]) -> Result<Scene, String> {
    let set: Vec<String> = set.iter().map(|&option| option.to_owned()).collect();
    let path = folder.join("g.toml").display().to_string();
    Scene::load(&path, &set).map_err(|rejection| rejection.to_string())
}

const BY_FILE: &str = "[[generate]]\nmaterial = \"m\"\ngrading_file = \"sizes.csv\"\n\
                       in = { rectangle = { min = [0, 0], max = [1, 1] } }\n";

#[test]
fn a_histogram_is_the_same_as_a_table() {
    let folder = tempfile::tempdir().expect("a folder");
    write(folder.path(), "g.toml", &preset(BY_FILE));
    write(
        folder.path(),
        "sizes.csv",
        "# of the sieve\nradius,count\n0.02,40\n0.05, 10\n",
    );
    let by_file = load(folder.path(), &[]).unwrap_or_else(|why| panic!("{why}"));
    let table = BY_FILE.replace(
        "grading_file = \"sizes.csv\"",
        "grading = [{ radius = 0.05, count = 10 }, { radius = 0.02, count = 40 }]",
    );
    assert_eq!(by_file.setup.particles, scene(&table).setup.particles);
    assert_eq!(by_file.setup.particles.len(), 50);
}

#[test]
fn errors_of_a_file_name_its_line() {
    let folder = tempfile::tempdir().expect("a folder");
    write(folder.path(), "g.toml", &preset(BY_FILE));
    for (text, parts) in [
        (
            "radius,count\n0.02,40\n0.0x,10\n",
            [
                "`sizes.csv`, line 3: `radius` cannot be `0.0x`",
                "numbers like 0.5",
            ],
        ),
        (
            "radius,count\n0.02,0.25\n",
            ["line 2: `count` cannot be 0.25", "not of shares"],
        ),
        (
            "radius,count\n-0.02,4\n",
            ["line 2: `radius` cannot be -0.02", "radii > 0"],
        ),
        (
            "radius,count\n0.02\n",
            ["line 2: 1 cells under a header of 2", "as many in each row"],
        ),
        (
            "radius,number\n0.02,4\n",
            ["line 1: there is no column `number`", "radius, count"],
        ),
        (
            "radius\n0.02\n",
            ["line 1: the header has no `count`", "names the columns"],
        ),
        (
            "radius,count\n0.7,4\n",
            [
                "line 2: a particle of radius 0.7 m is larger than the region",
                "0.5 m at most",
            ],
        ),
        (
            "radius,count\n",
            [
                "the `grading_file` of generate 1 is empty",
                "a size or more",
            ],
        ),
    ] {
        write(folder.path(), "sizes.csv", text);
        let refused = load(folder.path(), &[]).expect_err("it is wrong");
        for part in parts.iter().chain(&["g.toml:8"]) {
            assert!(refused.contains(part), "{text}: {part}\n{refused}");
        }
    }
    fs::remove_file(folder.path().join("sizes.csv")).expect("it was there");
    let refused = load(folder.path(), &[]).expect_err("it is gone");
    assert!(
        refused.contains("cannot be read") && refused.contains("relative to the folder"),
        "{refused}"
    );
}

#[test]
fn what_export_wrote_is_imported_to_the_same_bits() {
    let folder = tempfile::tempdir().expect("a folder");
    let first = preset(
        "[material.n]\ndensity = 2e3\nnormal_stiffness = 1e6\n\
         [[particle]]\nat = [0.1, 0.9]\nradius = 0.05\nmaterial = \"n\"\nvelocity = [0.25, -1]\n\
         [[generate]]\nmaterial = \"m\"\ngrading = [{ radius = 0.03, count = 60 }]\n\
         in = { circle = { centre = [0.5, 0.5], radius = 0.5 } }\nvelocity = [0, 0.125]\n\
         [dump]\nevery = 1\nwhat = [\"particles\"]\n",
    );
    write(folder.path(), "first.toml", &first);
    let output = ballast(
        folder.path(),
        &["run", "first.toml", "--csv", "a.csv", "--cycles", "1"],
    );
    assert!(output.status.success(), "{}", said(&output));
    let dump = folder.path().join("a.particles.0000000000.csv");
    fs::rename(dump, folder.path().join("balls.csv")).expect("cycle 0 was dumped");
    let second = preset(
        "[material.n]\ndensity = 2e3\nnormal_stiffness = 1e6\n[[generate]]\nimport = \"balls.csv\"\n",
    );
    write(folder.path(), "g.toml", &second);
    let imported = load(folder.path(), &[]).unwrap_or_else(|why| panic!("{why}"));
    let original = Scene::parse("first", &first, &[]).expect("it is sound");
    assert_eq!(imported.setup.particles, original.setup.particles);
    // Without the column a material has to be given.
    write(folder.path(), "balls.csv", "x,y,radius\n0,0,1\n3,0,1\n");
    let refused = load(folder.path(), &[]).expect_err("no material");
    assert!(refused.contains("has no `material`"), "{refused}");
    let set = ["generate.0.material=\"m\"", "generate.0.velocity=[1, 2]"];
    let given = load(folder.path(), &set).unwrap_or_else(|why| panic!("{why}"));
    assert!(
        given
            .setup
            .particles
            .iter()
            .all(|p| p.velocity == [1.0, 2.0] && p.material == 0)
    );
    write(
        folder.path(),
        "balls.csv",
        "x,y,radius,material\n0,0,1,m\n0.5,0,1,lead\n",
    );
    let refused = load(folder.path(), &[]).expect_err("no such material");
    assert!(
        refused.contains("line 3: there is no material `lead`"),
        "{refused}"
    );
}

#[test]
fn an_import_keeps_the_numbers_of_its_file_or_follows_a_curve() {
    let folder = tempfile::tempdir().expect("a folder");
    let preset_of = |order: &str| {
        preset(&format!(
            "[[generate]]\nmaterial = \"m\"\nimport = \"p.csv\"\n{order}"
        ))
    };
    // A square of 75 by 75 touching discs, its sites in steps of 3371, which shares no factor with 5625.
    let site = |k: usize| (k * 3371) % 5625;
    let row = |k: usize| {
        let (x, y) = (site(k) % 75, site(k) / 75);
        format!("{x},{y},0.5,{k}\n")
    };
    let rows: String = (0..5625).map(row).collect();
    write(folder.path(), "p.csv", &format!("x,y,radius,angle\n{rows}"));
    let particles = |order: &str| {
        write(folder.path(), "g.toml", &preset_of(order));
        let scene = load(folder.path(), &[]).unwrap_or_else(|why| panic!("{why}"));
        scene.setup.particles
    };
    let check = || {
        let output = ballast(folder.path(), &["check", "g.toml"]);
        assert!(output.status.success(), "{}", said(&output));
        String::from_utf8(output.stdout).expect("it is text")
    };
    let poor = "numbers of neighbours differ by";
    let as_in_file = particles("");
    assert!((0..).zip(&as_in_file).all(|(k, p)| p.angle == f64::from(k)));
    let report = check();
    assert!(report.contains(poor), "{report}");
    assert_eq!(particles("order = \"file\"\n"), as_in_file);
    let mut along = particles("order = \"curve\"\n");
    let report = check();
    assert!(!report.contains(poor), "{report}");
    // From number to number hardly a step leads past a neighbour, and all that a row says came along.
    let step = |pair: &[ParticleSetup]| {
        (pair[0].at[0] - pair[1].at[0]).abs() + (pair[0].at[1] - pair[1].at[1]).abs()
    };
    let way: f64 = along.windows(2).map(step).sum();
    assert!(way < 1.2 * 5624.0, "{way}");
    along.sort_by(|a, b| a.angle.total_cmp(&b.angle));
    assert_eq!(along, as_in_file);
    // Elsewhere it would be without effect, and other words mean nothing.
    write(folder.path(), "g.toml", &preset_of("order = \"row\"\n"));
    let refused = load(folder.path(), &[]).expect_err("no such order");
    for part in ["`order`", "row", "file", "curve"] {
        assert!(refused.contains(part), "{part} in {refused}");
    }
}

#[test]
fn imported_particles_that_overlap_are_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    write(
        folder.path(),
        "g.toml",
        &preset("[[generate]]\nmaterial = \"m\"\nimport = \"p.csv\"\n"),
    );
    write(folder.path(), "p.csv", "radius,x,y\n1,0,0\n1,1.5,0\n");
    let refused = load(folder.path(), &[]).expect_err("they overlap");
    assert!(
        refused.contains("particles 1 and 2 overlap by 50 %"),
        "{refused}"
    );
    let allowed = load(folder.path(), &["model.overlap=\"allow\""]);
    assert_eq!(allowed.map(|scene| scene.setup.particles.len()), Ok(2));
}

#[test]
fn journals_and_checkpoints_hold_the_files() {
    let folder = tempfile::tempdir().expect("a folder");
    let tables = BY_FILE.to_owned()
        + "velocity = [0, -1]\n[[wall]]\nname = \"floor\"\nfrom = [0, 0]\nto = [1, 0]\nmaterial = \"m\"\n\
           [[stage]]\nname = \"s\"\nmax_cycles = 60\n";
    write(folder.path(), "g.toml", &preset(&tables));
    // Quotes and three of them in a row, which TOML would take for the end.
    write(
        folder.path(),
        "sizes.csv",
        "# \"a\" '''b'''\nradius,count\n0.02,100\n",
    );
    let run = |words: &[&str]| {
        let output = ballast(folder.path(), words);
        assert!(output.status.success(), "{words:?}: {}", said(&output));
    };
    let read = |name: &str| fs::read_to_string(folder.path().join(name)).expect("it is there");
    run(&["run", "g.toml", "--csv", "a.csv"]);
    run(&["run", "g.toml", "--csv", "half.csv", "--cycles", "30"]);
    fs::remove_file(folder.path().join("sizes.csv")).expect("it was there");
    run(&["run", "a.journal", "--csv", "b.csv"]);
    assert_eq!(read("a.csv"), read("b.csv"));
    run(&["run", "--resume", "half.ballast", "--csv", "half.csv"]);
    let last = |text: &str| text.lines().last().map(str::to_owned);
    assert_eq!(last(&read("half.csv")), last(&read("a.csv")));
}

#[test]
fn sizes_and_places_follow_the_seed() {
    let tables = "[[generate]]\nmaterial = \"m\"\nin = { rectangle = { min = [0, 0], max = [1, 1] } }\n\
                  distribution = { kind = \"uniform\", min = 0.01, max = 0.03, count = 10 }\n";
    let (a, b) = (scene(tables), scene_with(tables, &["model.seed=2"]));
    let radii =
        |scene: &Scene| -> Vec<f64> { scene.setup.particles.iter().map(|p| p.radius).collect() };
    assert!(radii(&a) != radii(&b));
    assert_eq!(a.setup.particles, scene(tables).setup.particles);
}
