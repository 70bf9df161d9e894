//! `ballast plot`: what is drawn is read back from the SVG.

#[path = "program/mod.rs"]
mod program;

use std::fs;
use std::path::Path;

use program::{ballast, said};

/// Half a pixel of rounding at each of two points [pixels].
const PIXEL: f64 = 1.0;

type Points = Vec<[f64; 2]>;

/// Runs `ballast plot` with these words and gives the picture.
fn drawn(folder: &Path, words: &str) -> String {
    let words: Vec<&str> = words.split('|').collect();
    let output = ballast(folder, &[&["plot"][..], &words, &["-o", "it.svg"]].concat());
    assert_eq!(output.status.code(), Some(0), "{}", said(&output));
    let svg = fs::read_to_string(folder.join("it.svg")).expect("it is written");
    assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"));
    assert!(!svg.contains("NaN") && !svg.contains("inf\""));
    svg
}

/// An attribute of an element.
fn attribute<'a>(element: &'a str, name: &str) -> &'a str {
    let start = format!("{name}=\"");
    let (_, rest) = element.split_once(&start).expect("it has the attribute");
    rest.split('"').next().unwrap_or_default()
}

/// Points of the elements of this name whose line or fill has this colour and width or opacity.
fn points(svg: &str, element: &str, colour: &str, also: &str) -> Vec<Points> {
    let start = format!("<{element} ");
    let elements = svg.split('<').map(|rest| format!("<{rest}"));
    elements
        .filter(|text| text.starts_with(&start) && text.contains(colour) && text.contains(also))
        .map(|text| {
            let pairs = attribute(&text, "points").split_whitespace();
            pairs
                .map(|pair| {
                    let (x, y) = pair.split_once(',').expect("two numbers");
                    [x, y].map(|number| number.parse().expect("a number"))
                })
                .collect()
        })
        .collect()
}

/// All texts.
fn texts(svg: &str) -> Vec<String> {
    let texts = svg.split("<text ").skip(1);
    texts
        .map(|text| {
            let inside = text.split_once('>').expect("it is whole").1;
            let inside = inside.split("</text>").next().unwrap_or_default();
            inside.trim().to_owned()
        })
        .collect()
}

fn says(svg: &str, text: &str) -> bool {
    texts(svg).iter().any(|known| known == text)
}

/// Whether points are where an affine map per axis takes these numbers, as found from the two that
/// lie farthest apart.
fn assert_mapped(points: &[[f64; 2]], numbers: &[[f64; 2]]) {
    assert_eq!(points.len(), numbers.len());
    for axis in [0, 1] {
        let key = |k: &usize| (numbers[*k][axis] * 1e9) as i64;
        let low = (0..numbers.len()).min_by_key(key).expect("there are some");
        let high = (0..numbers.len()).max_by_key(key).expect("there are some");
        let scale =
            (points[high][axis] - points[low][axis]) / (numbers[high][axis] - numbers[low][axis]);
        assert!(scale.abs() > 20.0, "the curve fills the chart: {scale}");
        for (point, number) in points.iter().zip(numbers) {
            let wanted = points[low][axis] + scale * (number[axis] - numbers[low][axis]);
            assert!((point[axis] - wanted).abs() <= PIXEL, "{point:?}");
        }
    }
}

const BLUE: &str = "#0072B2";
const RED: &str = "#D55E00";

/// A sine over 37 rows of two stages.
fn sine(k: usize) -> [f64; 2] {
    let x = k as f64 / 36.0;
    [x, (3.0 * x).sin()]
}

fn history() -> String {
    let rows = (0..37).map(|k| {
        let [x, y] = sine(k);
        let stage = if k < 20 { "load" } else { "shear" };
        format!("{k},{x:?},{stage},{y:?},{:?},{}\n", 2.0 * y, k % 5)
    });
    let header = "cycle,time,stage,sin_phi,mine,contacts\n".to_owned();
    rows.fold(header, |text, row| text + &row)
}

fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("a.csv"), history()).expect("it can be written");
    folder
}

#[test]
fn every_row_is_a_point_where_its_numbers_say() {
    let folder = folder();
    let svg = drawn(folder.path(), "a.csv|--y|sin_phi");
    let lines = points(&svg, "polyline", BLUE, "stroke-width=\"2\"");
    assert_eq!(lines.len(), 1);
    let numbers: Vec<_> = (0..37).map(sine).collect();
    assert_mapped(&lines[0], &numbers);
    for text in ["time [s]", "sin_phi [-]", "sin_phi over time"] {
        assert!(says(&svg, text), "no {text} in {:?}", texts(&svg));
    }
    // One stage, another column across, a title that XML has to be told of.
    let svg = drawn(
        folder.path(),
        "a.csv|--x|cycle|--y|sin_phi|--stage|shear|--title|a < b & \"c\"",
    );
    let lines = points(&svg, "polyline", BLUE, "stroke-width=\"2\"");
    assert_eq!(lines[0].len(), 17);
    assert!(says(&svg, "cycle [-]") && says(&svg, "stage shear"));
    assert!(svg.contains("a &lt; b &amp; "), "{:?}", texts(&svg));
}

#[test]
fn several_columns_and_files_have_lines_of_their_own_and_a_legend() {
    let folder = folder();
    fs::write(folder.path().join("other.csv"), history()).expect("it can be written");
    let svg = drawn(folder.path(), "a.csv|--y|sin_phi,mine");
    let [blue, red] = [BLUE, RED].map(|colour| points(&svg, "polyline", colour, "width=\"2\""));
    // A line and its sample in the legend, which has two points.
    for (lines, factor) in [(&blue, 1.0), (&red, 2.0)] {
        let sizes: Vec<usize> = lines.iter().map(Vec::len).collect();
        assert_eq!(sizes, [37, 2]);
        let numbers: Vec<_> = (0..37).map(|k| [sine(k)[0], factor * sine(k)[1]]).collect();
        assert_mapped(&lines[0], &numbers);
    }
    assert!(says(&svg, "sin_phi") && says(&svg, "mine") && says(&svg, "sin_phi, mine [-]"));
    let svg = drawn(folder.path(), "a.csv|other.csv|--y|sin_phi");
    assert!(says(&svg, "a") && says(&svg, "other"));
    let svg = drawn(folder.path(), "a.csv|other.csv|--y|sin_phi,mine");
    assert!(says(&svg, "a: mine") && says(&svg, "other: sin_phi"));
}

#[test]
fn what_is_not_defined_leaves_a_gap() {
    let folder = tempfile::tempdir().expect("a folder");
    let text = "cycle,time,stage,sin_phi\n0,0,s,nan\n1,1,s,1\n2,2,s,2\n3,3,s,nan\n4,4,s,3\n\
                5,5,s,nan\n6,6,s,1\n7,7,s,0\n8,8,s,1\n";
    fs::write(folder.path().join("a.csv"), text).expect("it can be written");
    let svg = drawn(folder.path(), "a.csv|--y|sin_phi");
    let lines = points(&svg, "polyline", BLUE, "stroke-width=\"2\"");
    let sizes: Vec<usize> = lines.iter().map(Vec::len).filter(|n| *n > 1).collect();
    assert_eq!(sizes, [2, 3]);
    // The row that stands alone is a dot.
    let dots = svg.split('<').filter(|text| text.starts_with("circle"));
    assert_eq!(dots.count(), 1);
}

#[test]
fn marks_stand_where_they_are_and_widen_the_axes() {
    let folder = folder();
    let marks = "x,y,label\n# of a source\n0.5,0.36,\"peak, early\"\n,1.5,limit\n";
    fs::write(folder.path().join("marks.csv"), marks).expect("it can be written");
    let svg = drawn(
        folder.path(),
        "a.csv|--y|sin_phi|--marks|marks.csv|--marks|0.25,-1,low|--marks|1.25,,late",
    );
    for label in ["peak, early", "limit", "low", "late"] {
        assert!(says(&svg, label), "{label}: {:?}", texts(&svg));
    }
    let line = &points(&svg, "polyline", BLUE, "stroke-width=\"2\"")[0];
    // Crosses are two lines through their middle.
    let crosses = points(&svg, "polyline", "#000000", "stroke-width=\"2\"");
    assert_eq!(crosses.len(), 4);
    let mut found = line.clone();
    let mut numbers: Vec<_> = (0..37).map(sine).collect();
    for (cross, at) in crosses.chunks(2).zip([[0.5, 0.36], [0.25, -1.0]]) {
        for stroke in cross {
            found.push([0, 1].map(|k| 0.5 * (stroke[0][k] + stroke[1][k])));
            numbers.push(at);
        }
    }
    assert_mapped(&found, &numbers);
    // The lines are dashed: pieces at one height, and at one place across.
    let pieces: Vec<Points> = points(&svg, "polyline", "#000000", "stroke-width=\"1\"");
    let scale = |axis: usize, number: f64| {
        let (a, b) = (line[0][axis], line[18][axis]);
        let (x, y) = (sine(0)[axis], sine(18)[axis]);
        a + (b - a) * (number - x) / (y - x)
    };
    let (up, across) = (scale(1, 1.5), scale(0, 1.25));
    let near = |point: &[f64; 2], axis: usize, place: f64| (point[axis] - place).abs() <= 2.0;
    let level = pieces.iter().filter(|p| p.iter().all(|p| near(p, 1, up)));
    let upright = pieces
        .iter()
        .filter(|p| p.iter().all(|p| near(p, 0, across)));
    assert!(level.count() > 20 && upright.count() > 20);
}

/// Three rows of an ensemble in each of two stages; the last is that of two seeds only.
const ENSEMBLE: &str = "cycle,time,stage,row,n,sin_phi:mean,sin_phi:sd,sin_phi:min,sin_phi:max,\
                        strain_12:mean,strain_12:sd,strain_12:min,strain_12:max\n\
                        0,0,shear,0,3,1,0.5,0.25,2,0,0,0,0\n\
                        10,1,shear,1,3,2,0.5,1.25,3,0.5,0,0.5,0.5\n\
                        20,2,shear,2,3,4,1,3,5,1,0,1,1\n\
                        25,2.5,shear,3,2,9,1,8,10,2,0,2,2\n";

#[test]
fn an_ensemble_is_its_mean_with_its_spread() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("e.csv"), ENSEMBLE).expect("it can be written");
    let words = [
        "plot",
        "e.csv",
        "--x",
        "strain_12",
        "--y",
        "sin_phi",
        "-o",
        "it.svg",
    ];
    let output = ballast(folder.path(), &words);
    let said = said(&output);
    assert_eq!(
        said,
        "e.csv: 1 rows are left out that not all seeds have\nwrote it.svg\n"
    );
    let svg = fs::read_to_string(folder.path().join("it.svg")).expect("it is written");
    let mean = points(&svg, "polyline", BLUE, "stroke-width=\"2\"");
    let band = points(&svg, "polygon", BLUE, "opacity=\"0.22\"");
    let thin = points(&svg, "polyline", BLUE, "stroke-width=\"1\"");
    assert_eq!([mean.len(), band.len(), thin.len()], [1, 1, 2]);
    let mut found = mean[0].clone();
    let mut numbers = vec![[0.0, 1.0], [0.5, 2.0], [1.0, 4.0]];
    found.extend(&band[0]);
    numbers.extend([[0.0, 0.5], [0.5, 1.5], [1.0, 3.0]]);
    numbers.extend([[1.0, 5.0], [0.5, 2.5], [0.0, 1.5]]);
    found.extend(thin.concat());
    numbers.extend([[0.0, 0.25], [0.5, 1.25], [1.0, 3.0]]);
    numbers.extend([[0.0, 2.0], [0.5, 3.0], [1.0, 5.0]]);
    assert_mapped(&found, &numbers);
    assert!(says(&svg, "sin_phi [-]") && says(&svg, "strain_12 [-]"));
    let caption = "mean over the seeds; band: ± standard deviation; thin: least and greatest";
    assert!(says(&svg, caption), "{:?}", texts(&svg));
    // A part of what is told of it is a column like others.
    let svg = drawn(folder.path(), "e.csv|--y|sin_phi:sd");
    assert!(says(&svg, "sin_phi:sd [-]") && points(&svg, "polygon", BLUE, "").is_empty());
}

#[test]
fn what_the_program_writes_can_be_drawn() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    let run = ["run", "two-discs", "-q", "--csv"];
    for more in [&["one.csv"][..], &["all.csv", "--seeds", "1..3"]] {
        let output = ballast(folder, &[&run[..], more].concat());
        assert_eq!(output.status.code(), Some(0), "{}", said(&output));
    }
    let rows = fs::read_to_string(folder.join("one.csv")).expect("it is written");
    let rows = rows.lines().count() - 1;
    for file in ["one.csv", "all.csv"] {
        let svg = drawn(folder, &format!("{file}|--y|contact:1-2:n"));
        let lines = points(&svg, "polyline", BLUE, "stroke-width=\"2\"");
        assert_eq!(lines[0].len(), rows, "{file}");
        assert!(says(&svg, "contact:1-2:n [N]"));
    }
}

#[test]
fn a_checkpoint_is_drawn_as_the_console_draws_it() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    let words = "run disc-pile -q --cycles 1500 --checkpoint pile.ballast";
    let output = ballast(folder, &words.split(' ').collect::<Vec<_>>());
    assert_eq!(output.status.code(), Some(0), "{}", said(&output));
    let svg = drawn(folder, "pile.ballast");
    assert_eq!(svg.matches("<circle").count(), 105);
    let mut session = ::ballast::session::Session::resume(&folder.join("pile.ballast"), 1)
        .expect("it is a checkpoint");
    let line = format!("export svg assembly {}", folder.join("now.svg").display());
    let command = ::ballast::language::Command::parse(&line).expect("it is a command");
    let by = ::ballast::session::By::User;
    session.execute(&command, by).expect("it is carried out");
    let now = fs::read_to_string(folder.join("now.svg")).expect("it is written");
    assert_eq!(svg, now);
    let rose = drawn(folder, "pile.ballast|--picture|rose");
    assert!(
        rose.contains("directions of contacts"),
        "{:?}",
        texts(&rose)
    );
    // To standard output, and nothing else there.
    let output = ballast(folder, &["plot", "pile.ballast", "-o", "-"]);
    assert_eq!(String::from_utf8_lossy(&output.stdout), svg);
}

#[test]
fn wrong_words_are_refused_with_what_would_be_right() {
    let folder = folder();
    let write = |name: &str, text: &str| {
        fs::write(folder.path().join(name), text).expect("it can be written");
    };
    write("empty.csv", "");
    write("header.csv", "cycle,time,stage,sin_phi\n");
    write("torn.csv", "cycle,time,stage,sin_phi\n0,0,s,1\n1,1,s\n");
    write(
        "words.csv",
        "cycle,time,stage,sin_phi\n0,0,s,1\n1,1,s,much\n",
    );
    write("nan.csv", "cycle,time,stage,sin_phi\n0,0,s,nan\n");
    write("bare.csv", "time,sin_phi\n0,1\n1,2\n");
    write("marks.csv", "x,y,name\n0,1,a\n");
    write("half.ballast", "BALLAST\n\u{1}");
    for (words, hints) in [
        (
            "a.csv --y sin_phy",
            &["a.csv", "`sin_phy`", "did you mean `sin_phi`?"][..],
        ),
        (
            "a.csv --y sin_phi --x strain",
            &["there is no column `strain`"],
        ),
        ("a.csv --y stage", &["holds names", "--stage"]),
        (
            "a.csv --y sin_phi --stage sheer",
            &["stage `sheer`", "did you mean `shear`?"],
        ),
        ("bare.csv --y sin_phi --stage s", &["no column `stage`"]),
        ("a.csv", &["nothing is to be drawn", "--y"]),
        ("empty.csv --y sin_phi", &["empty.csv: is empty", "header"]),
        ("header.csv --y sin_phi", &["no rows", "history.every"]),
        (
            "torn.csv --y sin_phi",
            &["torn.csv, line 3", "3 cells under a header of 4"],
        ),
        (
            "words.csv --y sin_phi",
            &["words.csv, line 3", "`sin_phi` is `much`"],
        ),
        ("nan.csv --y sin_phi", &["no row has both", "nan"]),
        (
            "no.csv --y sin_phi",
            &["no such file, so no.csv cannot be opened", "check the path"],
        ),
        (". --y sin_phi", &["it is a folder"]),
        (
            "a.csv --y sin_phi --marks 1,x,p",
            &["--marks 1,x,p", "`x` is no number", "X,Y,LABEL"],
        ),
        ("a.csv --y sin_phi --marks ,,p", &["it is nowhere"]),
        ("a.csv --y sin_phi --marks 1,2", &["it has no label"]),
        (
            "a.csv --y sin_phi --marks marks.csv",
            &["no `label`", "x, y, label"],
        ),
        (
            "a.csv --y sin_phi --picture rose",
            &["--picture rose is about checkpoints"],
        ),
        ("half.ballast a.csv --y sin_phi", &["one by one"]),
        ("half.ballast --y sin_phi", &["is a checkpoint", "--y"]),
        ("half.ballast", &["half.ballast"]),
        ("half.ballast --picture tea", &["tea", "assembly"]),
        (
            "a.csv --y sin_phi,wall:floor:f1",
            &["there is no column `wall:floor:f1`"],
        ),
        (
            "a.csv --y sin_phi,time",
            &["`sin_phi` is in [-]", "`time` in [s]", "a file each"],
        ),
        ("a.csv --y sin_phi -o it.png", &["it.png", "it.svg"]),
        ("a.csv --y sin_phi -o a.csv", &["read and written"]),
    ] {
        let mut line: Vec<&str> = std::iter::once("plot").chain(words.split(' ')).collect();
        if !line.contains(&"-o") {
            line.extend(["-o", "it.svg"]);
        }
        let output = ballast(folder.path(), &line);
        let message = said(&output);
        assert_eq!(output.status.code(), Some(2), "{words}: {message}");
        assert!(output.stdout.is_empty(), "{words}");
        for hint in hints {
            assert!(message.contains(hint), "{words}: no `{hint}` in {message}");
        }
    }
    assert!(!folder.path().join("it.svg").exists());
    let line = "plot a.csv --y sin_phi -o no/it.svg";
    let output = ballast(folder.path(), &line.split(' ').collect::<Vec<_>>());
    assert_eq!(output.status.code(), Some(1));
    assert!(said(&output).contains("there is no folder `no`"));
}

/// The charts that the README shows, and the words they are drawn with.
const CHARTS: [(&str, &str); 6] = [
    (
        "sin-phi",
        "--x|deviator_strain|--y|sin_phi|--title|mobilised friction, constant volume, ten seeds|\
         --marks|0.0005,0.36,thesis, graded: .36 by .05 %|\
         --marks|0.001,0.30,thesis, uniform: .30 just after .1 %",
    ),
    (
        "isotropic-stress",
        "--x|deviator_strain|--y|isotropic_stress|--title|mean stress, constant volume, ten seeds|\
         --marks|0,1e5,thesis: about 100 kPa at the start",
    ),
    (
        "sliding",
        "--x|deviator_strain|--y|sliding_fraction|--title|share of the contacts that slide, ten \
         seeds|--marks|,0.25,thesis: at most 25 %",
    ),
    (
        "anisotropy",
        "--x|deviator_strain|--y|anisotropy|--title|anisotropy of contact normals, ten seeds|\
         --marks|0.001,,thesis: a plateau from about .1 %",
    ),
    (
        "coordination",
        "--x|deviator_strain|--y|coordination|--title|coordination number, ten seeds|\
         --marks|0,3.57,thesis, graded: 3.57|--marks|0,3.15,thesis, uniform: 3.15",
    ),
    (
        "stress-path",
        "--x|isotropic_stress|--y|deviator_stress|--title|stress path, constant volume, ten seeds",
    ),
];

/// `UPDATE=1 cargo test --test plot` draws them anew.
#[test]
fn charts_of_the_thesis_are_those_of_its_histories() {
    let folder = Path::new("data/thesis");
    for (name, words) in CHARTS {
        let files = ["plot", "graded-shear.csv", "uniform-shear.csv"];
        let stage = ["--stage", "shear", "-o", "-"];
        let words: Vec<&str> = words.split('|').collect();
        let output = ballast(folder, &[&files[..], &stage, &words].concat());
        assert_eq!(output.status.code(), Some(0), "{}", said(&output));
        let file = folder.join(format!("{name}.svg"));
        if std::env::var_os("UPDATE").is_some() {
            fs::write(&file, &output.stdout).expect("it can be written");
        }
        let shown = fs::read(&file).expect("it is there");
        assert!(shown == output.stdout, "{name} is not what its rows give");
    }
}
