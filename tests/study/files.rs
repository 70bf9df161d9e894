//! The files of a study: the numbers as CSV, the picture as SVG.

use ballast::study::{picture, table};

use super::{Bounce, study};

const FRACS: &str = "study.frac=[0.2, 0.1, 0.05]";
const QUESTIONS: &str = "study.for=[\"height\", \"kinetic\"]";

#[test]
fn the_table_has_a_row_for_each_variant_and_question() {
    let text = Bounce::new().answered(12, 0.0);
    let sweep = "study.sweep=[\"particle.1.velocity=[0, -1],[0, -2]\"]";
    let outcome = study(&text, &[FRACS, QUESTIONS, sweep, "study.within=0.01"]);
    let csv = table::csv(&outcome);
    let mut reader = csv::Reader::from_reader(csv.as_slice());
    let header = reader.headers().expect("there is one").clone();
    assert_eq!(header.iter().collect::<Vec<_>>(), table::HEADER);
    let cell = |row: &csv::StringRecord, name: &str| {
        let at = header.iter().position(|known| known == name);
        row[at.expect("the column is there")].to_owned()
    };
    let number = |row: &csv::StringRecord, name: &str| -> f64 {
        cell(row, name).parse().expect("it is a number")
    };
    let rows: Vec<csv::StringRecord> = reader
        .records()
        .map(|row| row.expect("it is whole"))
        .collect();
    assert_eq!(rows.len(), 6 * 2);
    for (k, row) in rows.iter().enumerate() {
        let (run, replies) = (&outcome.runs[k / 2], &outcome.replies[k % 2]);
        assert_eq!(cell(row, "variant"), run.name);
        assert!(!cell(row, "right_answer").is_empty());
        // Numbers read back to the same bits.
        assert_eq!(number(row, "wall_s"), run.timing.median());
        assert_eq!(number(row, "dt_s"), outcome.plan.variants[k / 2].dt);
        let error = replies.judgements[k / 2].error;
        assert_eq!(number(row, "error").to_bits(), error.to_bits());
        assert!(row.iter().take(20).all(|cell| !cell.is_empty()), "{row:?}");
    }
    assert_eq!(cell(&rows[0], "compared_with"), "closed form");
    assert_eq!(cell(&rows[1], "compared_with"), outcome.runs[2].name);
    assert_eq!(cell(&rows[6], "settings"), "particle.1.velocity=[0, -2]");
    let marked = rows.iter().filter(|row| cell(row, "fastest_within") == "1");
    assert!(marked.count() <= 2);
}

/// How often a text occurs.
fn count(text: &str, what: &str) -> usize {
    text.matches(what).count()
}

#[test]
fn the_picture_shows_every_variant_with_axes_and_units() {
    let bounce = Bounce::new();
    let outcome = study(&bounce.answered(12, 0.0), &[FRACS, "study.within=0.001"]);
    let (svg, left_out) = picture::svg(&outcome).expect("it can be drawn");
    assert_eq!(left_out, 0);
    assert!(svg.starts_with("<svg ") && svg.ends_with("</svg>\n"));
    for word in [
        "scene: speed against error",
        "wall time [s], median",
        "relative error of height [-]",
        "Pareto front",
        "within 0.001",
        "linear",
        "0.05",
        "1e-4",
    ] {
        assert!(svg.contains(&format!("\n{word}\n")), "no {word}");
    }
    // Two circles for each point, the second for its rim, a third of radius 0 or around the fastest,
    // and one in the legend.
    assert_eq!(count(&svg, "<circle "), 3 * 3 + 1);
    assert_eq!(count(&svg, "r=\"9\""), 1);
    // Every start tag that is not closed at once has its end.
    let tags = count(&svg, "<") - count(&svg, "</") - count(&svg, "/>");
    assert_eq!(tags, count(&svg, "</"));
}

#[test]
fn what_has_no_error_is_left_out_of_the_picture() {
    // The reference has none, and with one variant besides there is still a picture.
    let text = Bounce::preset(12, "");
    let outcome = study(&text, &["study.frac=[0.2, 0.1]", "study.for=[\"kinetic\"]"]);
    let (svg, left_out) = picture::svg(&outcome).expect("it can be drawn");
    assert_eq!(left_out, 1);
    assert_eq!(count(&svg, "<circle "), 3 + 1);
    let outcome = study(&text, &["study.frac=[0.1]", "study.for=[\"kinetic\"]"]);
    let (svg, left_out) = picture::svg(&outcome).expect("an empty one can be drawn");
    assert_eq!((left_out, count(&svg, "<circle ")), (1, 1));
}

#[test]
fn names_that_mean_something_to_svg_are_quoted() {
    let answer = "[[answer]]\nto = \"a < b & c\"\nwhat = [\"last(particle:1:y)\"]\nvalue = [1]\n";
    let outcome = study(&Bounce::preset(12, answer), &["study.frac=[0.1]"]);
    let (svg, _) = picture::svg(&outcome).expect("it can be drawn");
    assert!(svg.contains("a &lt; b &amp; c"));
}
