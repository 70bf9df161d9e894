//! Noise in place of a preset: it is refused with a place and a remedy, in a time and a report of
//! reasonable length.

mod processor;

use std::fs;
use std::time::Duration;

use ballast::scene::Scene;

/// Whether a line of the report names a place: `name:LINE:COLUMN`.
fn names_a_place(report: &str) -> bool {
    report.lines().any(|line| {
        let mut numbers = line.rsplit(':').map(|part| part.trim().parse::<usize>());
        line.trim_start().starts_with("--> ")
            && matches!(numbers.next(), Some(Ok(1..)))
            && matches!(numbers.next(), Some(Ok(1..)))
    })
}

/// A fixed stream of numbers, so that a failure can be repeated (splitmix64).
struct Noise(u64);

impl Noise {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn pick<'a>(&mut self, words: &[&'a str]) -> &'a str {
        words[(self.next() % words.len() as u64) as usize]
    }
}

/// Pieces of presets: noise made of them gets past the first line of the parser.
const PIECES: &[&str] = &[
    "[",
    "]",
    "[[",
    "]]",
    "{",
    "}",
    "=",
    " = ",
    ".",
    ",",
    "\"",
    "'",
    "\"\"\"",
    "#",
    "\n",
    "\n",
    "\n",
    "model",
    "particle",
    "material",
    "wall",
    "at",
    "radius",
    "m",
    "1",
    "-1e300",
    "nan",
    "inf",
    "0x",
    "1979-05",
    "true",
    "[model]\n",
    "[[particle]]\n",
    "[material.m]\n",
    "at = [0, 0]\n",
    "radius = 1\n",
    "\\u00e9",
    "é",
    "☃",
    "\t",
    "\r\n",
    "body = \"disc\"\n",
];

const TEN_MB: usize = 10_000_000;

/// Ten megabytes are refused within this processor time; a parser that goes back and forth would
/// take hours.
const PATIENCE: Duration = Duration::from_secs(60);

fn is_refused(what: &str, text: &str) {
    let start = processor::time();
    let Err(rejection) = Scene::parse("noise.toml", text, &[]) else {
        panic!("{what} was accepted");
    };
    let report = rejection.to_string();
    assert!(names_a_place(&report), "{what}: {report}");
    assert!(report.contains("= help: "), "{what}: {report}");
    assert!(report.len() < 20_000, "{what}: {} bytes", report.len());
    assert!(processor::time().saturating_sub(start) < PATIENCE, "{what}");
}

#[test]
fn ten_megabytes_of_anything_are_refused() {
    for piece in [
        "x",
        "[",
        "[[a]]\n",
        "a.",
        "\"",
        "'''",
        "{a=",
        "a=[",
        "\n",
        "# \n",
        "=",
        "[a.b]\n",
        "\\",
        "é",
        "1,",
        "\t",
        "[particle]\n",
        "[[particle]]\n",
        "[[wall]]\nname=\"w\"\n",
        "- ",
    ] {
        is_refused(
            &format!("{piece:?} again and again"),
            &piece.repeat(TEN_MB / piece.len()),
        );
    }
    let lines: Vec<String> = (0..TEN_MB / 12).map(|k| format!("k{k} = {k}\n")).collect();
    is_refused("a million unknown keys", &lines.concat());
    let mut noise = Noise(1);
    let printable: String = (0..TEN_MB)
        .map(|_| char::from(b' ' + (noise.next() % 95) as u8))
        .collect();
    is_refused("printable noise", &printable);
    let mut pieces = String::new();
    while pieces.len() < TEN_MB {
        pieces.push_str(noise.pick(PIECES));
    }
    is_refused("pieces of presets", &pieces);
}

#[test]
fn short_noise_is_refused_or_accepted_but_never_more() {
    let mut noise = Noise(2);
    let good = fs::read_to_string(concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/presets/two-discs.toml"
    ))
    .expect("the preset is there");
    for _ in 0..3000 {
        let mut text = String::new();
        for _ in 0..noise.next() % 60 {
            text.push_str(noise.pick(PIECES));
        }
        // Noise alone, and a good preset with noise in a random place.
        let mut at = (noise.next() % good.len() as u64) as usize;
        while !good.is_char_boundary(at) {
            at -= 1;
        }
        let spoilt = format!("{}{text}{}", &good[..at], &good[at..]);
        for text in [&text, &spoilt] {
            if let Err(rejection) = Scene::parse("noise.toml", text, &[]) {
                let report = rejection.to_string();
                assert!(names_a_place(&report), "{text}\n{report}");
                assert!(report.contains("= help: "), "{text}\n{report}");
            }
        }
        if let Err(rejection) = Scene::load("two-discs", std::slice::from_ref(&text)) {
            assert!(rejection.to_string().contains("= help: "), "{text}");
        }
    }
}

#[test]
fn a_hundred_thousand_particles_are_read() {
    let mut text = String::from(
        "[model]\nbody = \"disc\"\n[material.m]\ndensity = 1e3\nnormal_stiffness = 1e6\n",
    );
    for k in 0..100_000 {
        let at = [f64::from(k % 300), f64::from(k / 300)];
        let particle = format!("[[particle]]\nat = {at:?}\nradius = 0.5\nmaterial = \"m\"\n");
        text.push_str(&particle);
    }
    let start = processor::time();
    let scene = Scene::parse("many.toml", &text, &[]).expect("it is a good preset");
    assert_eq!(scene.setup.particles.len(), 100_000);
    assert!(processor::time().saturating_sub(start) < PATIENCE);
    let wrong = text.replace("radius = 0.5", "radius = 0.6");
    let rejection = Scene::parse("many.toml", &wrong, &[]).expect_err("all overlap");
    assert!(rejection.count() >= 1000);
    assert!(rejection.to_string().len() < 20_000);
}
