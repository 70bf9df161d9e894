//! Files for other programs, read back: VTK against the tables and the world, pictures against what
//! they are of.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use ballast::measure::frame::Picture;
use ballast::measure::polygon::ForcePolygon;
use ballast::measure::sample::Sample;
use ballast::scene::Scene;
use ballast::session::{Budget, Options, Session};

/// The pile while it runs out: most contacts slide, some discs are alone.
fn pile(options: &[String]) -> Session {
    let scene = Scene::load("disc-pile", options).expect("it is embedded");
    Session::open(scene, Options::default()).expect("it opens")
}

fn advance(session: &mut Session, cycle: u64) {
    let budget = Budget {
        until_cycle: Some(cycle),
        time: None,
    };
    session.advance(budget, false).expect("nothing goes wrong");
}

fn tell(session: &mut Session, line: &str) -> String {
    session.type_line(line).expect(line).lines.join("\n")
}

/// A file of legacy VTK, binary: written after its description alone.
struct Vtk {
    points: Vec<[f64; 3]>,
    /// Points of each cell.
    cells: Vec<Vec<i32>>,
    /// `POINT_DATA` or `CELL_DATA`.
    of: String,
    /// Numbers of each name, and how many belong together.
    values: BTreeMap<String, (usize, Vec<f64>)>,
}

/// Lines of text and numbers between them.
struct Bytes<'a>(&'a [u8]);

impl Bytes<'_> {
    fn line(&mut self) -> String {
        let end = self.0.iter().position(|byte| *byte == b'\n');
        let (line, rest) = self.0.split_at(end.expect("a line ends"));
        self.0 = &rest[1..];
        String::from_utf8(line.to_vec()).expect("it is text")
    }

    fn take<const N: usize>(&mut self) -> [u8; N] {
        let (number, rest) = self.0.split_at(N);
        self.0 = rest;
        number.try_into().expect("so many bytes")
    }

    fn words(&mut self) -> Vec<String> {
        self.line().split(' ').map(str::to_owned).collect()
    }
}

fn count(word: &str) -> usize {
    word.parse().expect("a number")
}

fn vtk(file: &Path) -> Vtk {
    let bytes = fs::read(file).expect("it is there");
    let mut bytes = Bytes(&bytes);
    assert_eq!(bytes.line(), "# vtk DataFile Version 3.0");
    assert!(bytes.line().len() < 256);
    assert_eq!(
        (bytes.line(), bytes.line()),
        ("BINARY".into(), "DATASET POLYDATA".into())
    );
    let head = bytes.words();
    assert_eq!((head[0].as_str(), head[2].as_str()), ("POINTS", "double"));
    let points = (0..count(&head[1])).map(|_| [0; 3].map(|_| f64::from_be_bytes(bytes.take())));
    let points = points.collect();
    assert_eq!(bytes.line(), "");
    let head = bytes.words();
    assert!(["VERTICES", "LINES"].contains(&head[0].as_str()));
    let mut numbers = 0;
    let mut cells = Vec::new();
    for _ in 0..count(&head[1]) {
        let size = i32::from_be_bytes(bytes.take());
        cells.push(
            (0..size)
                .map(|_| i32::from_be_bytes(bytes.take()))
                .collect(),
        );
        numbers += 1 + size as usize;
    }
    assert_eq!(numbers, count(&head[2]));
    assert_eq!(bytes.line(), "");
    let of = bytes.words();
    assert_eq!(count(&of[1]), cells.len());
    let fields = bytes.words();
    let mut values = BTreeMap::new();
    for _ in 0..count(&fields[2]) {
        let head = bytes.words();
        let (width, tuples) = (count(&head[1]), count(&head[2]));
        assert_eq!(tuples, cells.len());
        let numbers = (0..width * tuples).map(|_| match head[3].as_str() {
            "double" => f64::from_be_bytes(bytes.take()),
            _ => f64::from(u32::from_be_bytes(bytes.take())),
        });
        let numbers: Vec<f64> = numbers.collect();
        values.insert(head[0].clone(), (width, numbers));
        assert_eq!(bytes.line(), "");
    }
    assert!(bytes.0.is_empty(), "nothing is left over");
    Vtk {
        points,
        cells,
        of: of[0].clone(),
        values,
    }
}

/// Columns of a CSV file.
fn table(file: &Path) -> BTreeMap<String, Vec<String>> {
    let text = fs::read_to_string(file).expect("it is there");
    let mut lines = text.lines();
    let names: Vec<&str> = lines.next().expect("a header").split(',').collect();
    let rows: Vec<Vec<&str>> = lines.map(|line| line.split(',').collect()).collect();
    let column = |k: usize| rows.iter().map(|row| row[k].to_owned()).collect();
    let columns = names.iter().enumerate();
    columns
        .map(|(k, name)| ((*name).to_owned(), column(k)))
        .collect()
}

fn numbers(column: &[String]) -> Vec<f64> {
    column
        .iter()
        .map(|cell| cell.parse().expect("a number"))
        .collect()
}

/// Bits, so that NaN is NaN.
fn bits(numbers: &[f64]) -> Vec<u64> {
    numbers.iter().map(|number| number.to_bits()).collect()
}

fn component(vtk: &Vtk, name: &str, k: usize) -> Vec<f64> {
    let (width, numbers) = &vtk.values[name];
    numbers.iter().skip(k).step_by(*width).copied().collect()
}

#[test]
fn vtk_says_what_the_tables_say() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    let mut session = pile(&[]);
    advance(&mut session, 9000);
    for what in ["particles", "contacts"] {
        for (form, ending) in [("", "csv"), ("vtk ", "vtk")] {
            let file = path(&format!("{what}.{ending}"));
            tell(
                &mut session,
                &format!("export {form}{what} {}", file.display()),
            );
        }
    }
    let (points, csv) = (vtk(&path("particles.vtk")), table(&path("particles.csv")));
    assert_eq!(
        (points.of.as_str(), points.points.len()),
        ("POINT_DATA", 105)
    );
    let singles: Vec<Vec<i32>> = (0..105).map(|k| vec![k]).collect();
    assert_eq!(points.cells, singles);
    for (axis, name) in ["x", "y"].into_iter().enumerate() {
        let found: Vec<f64> = points.points.iter().map(|point| point[axis]).collect();
        assert_eq!(bits(&found), bits(&numbers(&csv[name])), "{name}");
    }
    assert!(points.points.iter().all(|point| point[2] == 0.0));
    for (name, k, column) in [
        ("ball", 0, "ball"),
        ("radius", 0, "radius"),
        ("contacts", 0, "contacts"),
        ("velocity", 0, "vx"),
        ("velocity", 1, "vy"),
        ("spin", 0, "spin"),
        ("angle", 0, "angle"),
        ("force", 0, "fx"),
        ("force", 1, "fy"),
        ("moment", 0, "moment"),
        ("displacement", 0, "ux"),
        ("displacement", 1, "uy"),
        ("rotation", 0, "rotation"),
    ] {
        let found = component(&points, name, k);
        assert_eq!(bits(&found), bits(&numbers(&csv[column])), "{column}");
    }
    assert!(component(&points, "velocity", 2).iter().all(|v| *v == 0.0));
    let (lines, csv) = (vtk(&path("contacts.vtk")), table(&path("contacts.csv")));
    assert_eq!(
        (lines.of.as_str(), lines.cells.len()),
        ("CELL_DATA", csv["n"].len())
    );
    for name in ["ball", "n", "t", "overlap", "sliding"] {
        let found = component(&lines, name, 0);
        assert_eq!(bits(&found), bits(&numbers(&csv[name])), "{name}");
    }
    // Lines lead from centre to centre, through the point of the table.
    let centre = |ball: f64| points.points[ball as usize - 1];
    let (first, second) = (component(&lines, "ball", 0), component(&lines, "with", 0));
    let [at, up] = ["x", "y"].map(|name| numbers(&csv[name]));
    for (k, cell) in lines.cells.iter().enumerate() {
        let ends = [0, 1].map(|end| lines.points[cell[end] as usize]);
        assert_eq!(ends[0], centre(first[k]));
        let d = [0, 1].map(|axis| ends[1][axis] - ends[0][axis]);
        let through = d[0] * (up[k] - ends[0][1]) - d[1] * (at[k] - ends[0][0]);
        // Lengths of 0.1 m: roundings of a few units of 1e-17 m².
        assert!(through.abs() < 1e-16, "{through}");
        if second[k] > 0.0 {
            let other = centre(second[k]);
            assert!((0..2).all(|axis| (ends[1][axis] - other[axis]).abs() < 1e-15));
        } else {
            assert!(csv["with"][k].parse::<u32>().is_err());
        }
    }
}

#[test]
fn dumps_can_be_vtk() {
    let folder = tempfile::tempdir().unwrap();
    let options = [
        "dump.every=40",
        "dump.what=[\"particles\", \"contacts\"]",
        "dump.format=\"vtk\"",
    ];
    let mut session = pile(&options.map(str::to_owned));
    session.write_dumps(&folder.path().join("pile.csv"));
    advance(&mut session, 81);
    for cycle in [0, 40, 80] {
        let name = |what: &str| folder.path().join(format!("pile.{what}.{cycle:010}.vtk"));
        assert_eq!(vtk(&name("particles")).points.len(), 105);
        vtk(&name("contacts"));
    }
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 6);
}

/// A rectangle of a contact force, and how wide it is.
fn bars(svg: &str) -> Vec<([f64; 4], f64)> {
    let number = |line: &str, name: &str| -> f64 {
        let (_, rest) = line.split_once(&format!("{name}=\"")).expect(name);
        let (number, _) = rest.split_once('"').expect("it ends");
        number.parse().expect("a number")
    };
    let lines = svg.lines().filter(|line| line.starts_with("<line"));
    let wide = lines.filter(|line| line.contains("stroke-width") && !line.contains("black"));
    wide.map(|line| {
        let ends = ["x1", "y1", "x2", "y2"].map(|name| number(line, name));
        (ends, number(line, "stroke-width"))
    })
    .collect()
}

#[test]
fn the_assembly_is_drawn_as_it_is() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("a.svg");
    let mut session = pile(&[]);
    advance(&mut session, 9000);
    tell(
        &mut session,
        &format!("export svg assembly {}", file.display()),
    );
    let svg = fs::read_to_string(&file).unwrap();
    assert_eq!(svg.matches("<circle").count(), 105);
    let sample = Sample::of(session.world_mut());
    let picture = Picture::of(sample.world());
    let forces = picture.touches.iter().filter(|touch| touch.force() > 0.0);
    let (bars, forces) = (bars(&svg), forces.collect::<Vec<_>>());
    assert_eq!(bars.len(), forces.len());
    let most = forces.iter().map(|touch| touch.force()).fold(0.0, f64::max);
    let widest = bars.iter().map(|(_, width)| *width).fold(0.0, f64::max);
    let scale = 900.0 / (picture.bounds[1][0] - picture.bounds[0][0]);
    for ((ends, width), touch) in bars.iter().zip(forces) {
        // Places have two decimals, widths three.
        assert!((width / widest - touch.force() / most).abs() < 1e-3 / widest + 1e-12);
        let d = [ends[2] - ends[0], ends[3] - ends[1]];
        let length = (d[0] * d[0] + d[1] * d[1]).sqrt();
        assert!((length - scale * touch.length).abs() < 0.03, "{length}");
        // Along the force: the moment of one about the other vanishes. Down is positive in pictures.
        let e = touch.normal;
        let force = [
            touch.n * e[0] + touch.t * e[1],
            touch.n * e[1] - touch.t * e[0],
        ];
        let off = (d[0] * force[1] + d[1] * force[0]) / touch.force();
        assert!(off.abs() < 0.03, "{off}");
    }
}

/// The number and a velocity of each particle, laid over.
#[test]
fn numbers_and_velocities_are_laid_over() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("a.svg");
    let mut session = pile(&[]);
    advance(&mut session, 2000);
    let mut drawn = |layers: &str| {
        let line = format!("export svg assembly {}{layers}", file.display());
        tell(&mut session, &line);
        fs::read_to_string(&file).unwrap()
    };
    let (bare, laid) = (drawn(""), drawn(" velocities numbers"));
    let counts = |svg: &str| ["<text", "<path d=\"M"].map(|what| svg.matches(what).count());
    assert_eq!(counts(&bare), [1, 0]);
    // One more path is the head of all arrows.
    assert_eq!(counts(&laid), [1 + 105, 1 + 105]);
    assert!(laid.contains(">105</text>") && laid.contains("longest arrow"));
    assert!(!bare.contains("longest arrow"));
    let refusal = session.type_line("export svg assembly a.svg colours");
    assert!(refusal.unwrap_err().to_string().contains("numbers"));
}

/// A place that the preset does not know: all of the pile, half of it, nothing.
#[test]
fn places_can_be_measured_that_have_no_name() {
    let folder = tempfile::tempdir().unwrap();
    let mut session = pile(&[]);
    advance(&mut session, 9000);
    let mut print = |place: &str| {
        let reply = session.type_line(&format!("print coordination{place}"));
        reply.unwrap().lines
    };
    let (all, around) = (print(""), print(" in rectangle -1e3 -1e3 1e3 1e3"));
    assert_eq!(all[1..], around[1..]);
    assert!(around[0].contains("rectangle -1000 -1000 1000 1000, 105 particles"));
    let [half, none] = [" in circle 1.5 0 1", " in circle 0 1e3 1"].map(&mut print);
    assert_ne!(half[1..], all[1..]);
    assert!(none[0].ends_with(", 0 particles"), "{}", none[0]);
    assert!(
        all[0].contains("of everything, 105 particles"),
        "{}",
        all[0]
    );
    assert!(!around[0].contains("region"), "{}", around[0]);
    let rings = session
        .type_line("print profile in circle 0 0.5 1 7")
        .unwrap();
    assert!(
        rings.lines[0].contains("circle 0 0.5 1"),
        "{:?}",
        rings.lines
    );
    let file = folder.path().join("rings.csv");
    let line = format!("export profile {} in circle 0 0.5 1 7", file.display());
    tell(&mut session, &line);
    assert_eq!(fs::read_to_string(&file).unwrap().lines().count(), 8);
    let refusal = session.type_line("print stress in circle 0 0").unwrap_err();
    assert!(refusal.to_string().contains("the radius of the circle"));
}

/// A side for each contact, head to tail, and the last for the weight: it closes up to the residual.
#[test]
fn force_polygons_are_drawn() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("p.svg");
    let mut session = pile(&[]);
    advance(&mut session, 9000);
    let line = format!("export svg polygon 7 {}", file.display());
    tell(&mut session, &line);
    let svg = fs::read_to_string(&file).unwrap();
    let sample = Sample::of(session.world_mut());
    let world = sample.world();
    let p = world.particles().index(7).unwrap();
    let polygon = ForcePolygon::of(world, p);
    assert!(polygon.sides.len() > 1);
    for side in &polygon.sides {
        assert!(svg.contains(&format!("\n{}\n", side.by)), "{}", side.by);
    }
    assert!(svg.contains("\nweight, applied\n") && svg.contains("out of balance"));
    session.type_line("gravity none").unwrap();
    advance(&mut session, 1);
    let mut flying = 0;
    for id in 1..=105 {
        let world = session.world_mut();
        let p = world.particles().index(id).unwrap();
        let nothing = ForcePolygon::of(world, p).is_empty();
        flying += u32::from(nothing);
        let line = format!("export svg polygon {id} {}", file.display());
        let drawn = session.type_line(&line).map_err(|why| why.to_string());
        assert_eq!(
            drawn.is_err_and(|why| why.contains("nothing acts")),
            nothing,
            "{id}"
        );
    }
    assert!(flying > 0 && flying < 105);
    let refusal = session.type_line("export svg polygon 7000 p.svg");
    assert!(refusal.unwrap_err().to_string().contains("7000"));
}

#[test]
fn pictures_are_whole_or_refused() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("it.svg");
    let line = |what: &str| format!("export svg {what} {}", file.display());
    let apart = Scene::load("two-discs", &[]).unwrap();
    let mut apart = Session::open(apart, Options::default()).unwrap();
    for (what, remedy) in [
        ("mohr", "run until"),
        ("rose", "run until"),
        ("histogram", "run until"),
        ("path", "history columns isotropic_stress"),
    ] {
        let refusal = apart.type_line(&line(what)).unwrap_err().to_string();
        assert!(refusal.contains(remedy), "{refusal}");
    }
    let columns = "history.columns=[\"sin_phi\", \"isotropic_stress\"]";
    let mut session = pile(&[columns.to_owned()]);
    advance(&mut session, 9000);
    for (what, named) in [
        ("path", "stress path"),
        ("mohr", "circles of Mohr"),
        ("histogram", "T/(μN)"),
        ("rose", "sliding contacts"),
        ("assembly", "105 particles"),
    ] {
        tell(&mut session, &line(what));
        let svg = fs::read_to_string(&file).unwrap();
        assert!(
            svg.starts_with("<svg") && svg.ends_with("</svg>\n"),
            "{what}"
        );
        assert!(svg.contains(named), "{what}");
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{what}");
    }
}
