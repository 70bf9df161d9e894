//! A screen made by hand: seven discs on a floor between two walls, a history, warnings.

use ballast::measure::fabric::Fabric;
use nalgebra::{Matrix2, Vector2};
use std::sync::Arc;

use ballast::engine::contact::inner::Inner;
use ballast::engine::contact::traction::Traction;
use ballast::engine::ledger::{Bookings, Energies};
use ballast::engine::world::FraccMonitor;
use ballast::language::Observable;
use ballast::measure::assembly::Assembly;
use ballast::measure::changes::{Bond, Changes};
use ballast::measure::columns::Column;
use ballast::measure::frame::{Disc, Picture, Stroke, Touch};
use ballast::measure::histogram::Histogram;
use ballast::measure::means::Means;
use ballast::measure::obliquity::Obliquity;
use ballast::measure::profile::{Profile, Ring};
use ballast::measure::rose::{PETALS, Rose};
use ballast::measure::strain::Strain;
use ballast::measure::stress::Stress;
use ballast::measure::survey::{Against, Displaced, Slid, Survey, Tensors};
use ballast::session::frames::{ChartRow, Frame};
use ballast::session::inspect::{Inspection, Moment};
use ballast::tui::app::{App, Said};
use ballast::tui::link::{Line, Link};
use ballast::tui::look::{Chains, Compared, Look, Points, Theme};

/// Usual settings.
pub(crate) const LOOK: Look = Look {
    theme: Theme::Colour,
    points: Points::Braille,
    chains: Chains::Force,
    discs: true,
    velocities: false,
    compared: Compared::Off,
};

const COLUMNS: [&str; 8] = [
    "fracc",
    "contacts",
    "coordination",
    "unbalanced",
    "kinetic",
    "max_force",
    "wall:floor:f2",
    "sliding_fraction",
];

/// A screen without a frame.
pub(crate) fn empty(look: Look) -> App {
    let line = Line {
        budget: None,
        fps: 10.0,
    };
    App::new(look, Link::new(line))
}

/// A screen in the middle of a run.
pub(crate) fn app(look: Look) -> App {
    let mut app = empty(look);
    app.folder = "/home/someone/.local/state/ballast/runs/0001".into();
    let mut before = frame();
    before.fracc.warnings = 0;
    app.take_frame(Box::new(before));
    let mut now = frame();
    now.restarted = false;
    now.rows.clear();
    app.take_frame(Box::new(now));
    for said in [
        Said::Line("friction 0.3".into()),
        Said::Answer("friction of disc is 0.3".into()),
        Said::Line("frictoin 0.2".into()),
        Said::Error("`frictoin` is no command; did you mean `friction`?".into()),
        Said::Notice("stage settle ended after max_cycles = 4000".into()),
    ] {
        app.say(said);
    }
    app
}

/// What is measured of a picture.
fn survey(picture: &Picture) -> Survey {
    let directions = directions(picture);
    let touches = &picture.touches;
    let mean = touches.iter().map(|touch| touch.n).sum::<f64>() / touches.len() as f64;
    let friction = 0.3;
    let obliquities = touches.iter().zip(0_i32..);
    let obliquity = obliquities.map(|(touch, k)| {
        let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
        [touch.n / mean, sign * touch.t / (friction * touch.n), 1.0]
    });
    let forces: Vec<(f64, f64)> = touches.iter().map(|touch| (touch.n, 1.0)).collect();
    let stresses: Vec<(f64, f64)> = touches
        .iter()
        .map(|touch| (1e6 * touch.n.cbrt(), 1.0))
        .collect();
    let zero = Matrix2::zeros();
    let total = Matrix2::new(60.0, 12.0, 10.0, 130.0);
    let tensors = Tensors {
        stress: Stress {
            total,
            fabric: total,
            normal_variation: zero,
            normal: total,
            shear: zero,
            mean_normal: mean,
        },
        fabric: directions.1,
        strain: Some(Strain {
            tensor: Matrix2::new(-2e-3, 1e-4, 3e-4, 6e-3),
            particles: 7,
        }),
    };
    Survey {
        directions: Some(directions),
        tensors: Some(tensors),
        obliquity: Some(Obliquity {
            contacts: obliquity.collect(),
        }),
        contact_stress: Some(Histogram::from_zero(&stresses, 16)),
        normal_force: Some(Histogram::from_zero(&forces, 16)),
        against: Some(against(picture)),
        profile: Some(profile()),
    }
}

/// Against a reference at which disc 5 leant on disc 6 and not on disc 4.
fn against(picture: &Picture) -> Against {
    let bond = |touch: &Touch| match (touch.first, touch.second) {
        (4, Some(5)) => Bond::Made,
        _ => Bond::Kept,
    };
    let touches = picture.touches.iter();
    let mut lattice: Vec<_> = touches.map(|touch| (bond(touch), touch.ends)).collect();
    if let [.., fifth, sixth, _] = &picture.discs[..] {
        lattice.push((Bond::Broken, [fifth.at, sixth.at]));
    }
    let moved = picture.discs.iter().map(|disc| {
        let k = f64::from(disc.id);
        Displaced {
            ball: disc.id,
            u: [0.01 * (k - 4.0), -0.005 * k],
            rotation: 0.02 * (k - 3.0),
        }
    });
    let slid = picture.touches.iter().filter(|touch| touch.t > 0.0);
    let slid = slid.zip(1_u32..).map(|(touch, k)| Slid {
        at: [0, 1].map(|axis| 0.5 * (touch.ends[0][axis] + touch.ends[1][axis])),
        along: [touch.normal[1], -touch.normal[0]],
        way: 2e-4 * f64::from(k),
    });
    Against {
        since: 12_000,
        changes: Changes {
            broken: 1.0,
            made: 1.0,
            kept: 9.0,
            rotation: 0.04,
            rotation_max: 0.08,
            slid: 1e-4,
            slid_max: 9e-4,
        },
        lattice,
        displaced: moved.collect(),
        slid: Some(slid.collect()),
    }
}

/// Five rings about the middle of the floor, the outermost nearly empty.
fn profile() -> Profile {
    let rings = (0..5).map(|k| {
        let edge = |k: u32| 0.15 * f64::from(k);
        let mut ring = Ring {
            inner: edge(k),
            outer: edge(k + 1),
            disc_area: 0.0,
            particles: 1,
        };
        ring.disc_area = ring.area() * (0.8 - 0.15 * f64::from(k));
        ring
    });
    Profile {
        centre: [0.4, 0.0],
        rings: rings.collect(),
    }
}

/// What is measured where nothing touches.
pub(crate) fn survey_of_nothing() -> Survey {
    let mut survey = survey(&Picture::default());
    let (rose, _) = survey.directions.as_mut().expect("it is there");
    rose.contacts.fill(0.0);
    let tensors = survey.tensors.as_mut().expect("it is there");
    tensors.stress.total.fill(0.0);
    tensors.strain = None;
    survey.profile = Some(Profile {
        centre: [0.0; 2],
        rings: Vec::new(),
    });
    survey
}

/// Directions of the contacts of a picture, as the measures would count them.
fn directions(picture: &Picture) -> (Rose, Fabric) {
    let mut rose = Rose {
        contacts: vec![0.0; PETALS],
        force: vec![0.0; PETALS],
        shear: vec![0.0; PETALS],
        sliding: vec![0.0; PETALS],
    };
    let (mut plain, mut weighted) = (Matrix2::zeros(), Matrix2::zeros());
    let mut by_tangential = Matrix2::zeros();
    let shear: f64 = picture.touches.iter().map(|touch| touch.t.abs()).sum();
    let count = picture.touches.len() as f64;
    let force: f64 = picture.touches.iter().map(|touch| touch.n).sum();
    for touch in &picture.touches {
        let angle = touch.normal[1].atan2(touch.normal[0]).to_degrees();
        let petal = (angle / 10.0).round().rem_euclid(18.0) as usize;
        rose.contacts[petal] += 1.0;
        rose.force[petal] += touch.n;
        rose.shear[petal] += touch.t.abs();
        rose.sliding[petal] += f64::from(u8::from(touch.sliding));
        let e = Vector2::from(touch.normal);
        plain += e * e.transpose() / count;
        weighted += e * e.transpose() * touch.n / force;
        by_tangential += e * e.transpose() * touch.t.abs() / shear;
    }
    let fabric = Fabric {
        plain,
        weighted,
        by_tangential,
        contacts: count,
    };
    (rose, fabric)
}

/// The frame.
pub(crate) fn frame() -> Frame {
    let column = |name| Column::parse(name).expect("it is in the list");
    let columns = COLUMNS.map(|name| Observable::Column(column(name)));
    Frame {
        serial: 1,
        title: "Seven discs settle".into(),
        preset: "seven-discs".into(),
        cycle: 14_820,
        time: 0.1482,
        dt: 1e-5,
        frac: 0.1,
        frac_limit: 0.417,
        frac_limit_of: 14_820,
        stage: "settle".into(),
        stages: (2, 3),
        stage_cycles: (3_700, Some(10_000)),
        finished: false,
        running: true,
        rate: 12_300.0,
        measures_of: 14_820,
        assembly: Assembly {
            contacts: 13.0,
            coordination: 3.5,
            coordination_mechanical: 3.7,
            rattlers: 1.0,
            rattler_fraction: 1.0 / 7.0,
            sliding_fraction: 0.071,
            mean_force: 12.5,
            max_force: 48.0,
            unbalanced: 1.2e-3,
            unbalanced_max: 4.0e-3,
        },
        fracc: FraccMonitor {
            largest: Some(0.214),
            warnings: 3,
            last: Some((14_311, 5, 0.347)),
            worst: Some((14_200, 6, 0.391)),
        },
        contact: None,
        picture: picture(),
        energies: Some(Energies {
            kinetic: 0.012,
            rotational: 0.0,
            elastic_normal: 0.31,
            elastic_tangential: 0.04,
            potential: -2.4,
            transit: 0.0,
        }),
        bookings: Some(Bookings {
            bond_loss: 0.0,
            friction_loss: 0.7,
            slip_loss: 0.0,
            damping_loss: 0.95,
            global_loss: 0.0,
            boundary_work: -0.39,
            energy_error: 2.1e-13,
        }),
        survey: survey(&picture()),
        polygon: None,
        columns: columns.to_vec().into(),
        rows: (0..=148).map(row).collect(),
        restarted: true,
        friction: vec![("disc".into(), 0.3)],
        every: 100,
        known: Arc::default(),
    }
}

/// A contact of exact partial slip that was pressed, sheared to 0.7 μN and back to -0.2 μN: closed
/// forms of Mindlin & Deresiewicz (1953).
pub(crate) fn contact() -> Inspection {
    let (friction, n) = (0.3, 20.0);
    let limit = friction * n;
    let mut trace: Vec<Moment> = Vec::new();
    let mut add = |alpha: f64, delta: f64, n: f64, t: f64| {
        let cycle = 14_000 + 10 * trace.len() as u64;
        trace.push(Moment {
            cycle,
            time: 1e-5 * cycle as f64,
            touch: 1,
            alpha,
            delta,
            n,
            t,
        });
    };
    for k in 1..=20 {
        let share: f64 = f64::from(k) / 20.0;
        add(1e-6 * share, 0.0, n * share * share.sqrt(), 0.0);
    }
    // Displacement in units of the one at which all slides.
    let way = |t: f64| 1.0 - (1.0 - t).powf(2.0 / 3.0);
    let slide = 3.6e-7;
    for k in 1..=20 {
        let t = 0.7 * f64::from(k) / 20.0;
        add(1e-6, slide * way(t), n, limit * t);
    }
    for k in 1..=30 {
        let back = 0.9 * f64::from(k) / 30.0;
        let delta = way(0.7) - 2.0 * way(0.5 * back);
        add(1e-6, slide * delta, n, limit * (0.7 - back));
    }
    let ring = |force: f64| (1.0 - force).powf(2.0 / 3.0);
    let steps = vec![
        (1e-6 * ring(0.7), 0.0),
        (1e-6 * ring(0.45), 1.0),
        (1e-6, -1.0),
    ];
    let traction = Traction { steps, friction };
    let c = traction.stick_ratio();
    Inspection {
        name: "2-floor".into(),
        law: "mindlin-deresiewicz-exact",
        state: "touches",
        friction,
        cohesion: 0.0,
        radius: 2.2e-5,
        peak: 2.0e10,
        traction: Some(traction),
        numbers: vec![
            Inner::number("N", n, "N"),
            Inner::number("T", -0.2 * limit, "N"),
            Inner::number("|T|/(mu N)", 0.2, "-"),
            Inner::number("alpha/D_min", 0.09, "> 7%"),
            Inner::number("radius a", 2.2e-5, "m"),
            Inner::number("c/a", c, "-"),
            Inner::number("nodes", 3.0, "-"),
            Inner::word("branch", "unloading"),
            Inner::number("lost: slip", 1.4e-9, "J"),
        ],
        since: (14_000, 10),
        trace,
    }
}

/// Row k of the history. Without contacts at first, so that quotients are undefined.
fn row(k: u64) -> ChartRow {
    let t = k as f64 / 148.0;
    let settled = |value: f64| if k < 20 { f64::NAN } else { value };
    let swing = if k % 12 < 6 { 0.3 } else { -0.3 } * (1.0 - t);
    ChartRow {
        cycle: 100 * k,
        time: 1e-3 * k as f64,
        stage: u32::from(k > 110),
        values: vec![
            0.2 + 0.1 * swing,
            (13.0 * t).round(),
            3.5 * t,
            settled(1.0 / (1.0 + 800.0 * t * t)),
            2.4 * t * (1.0 - t) * (1.0 + swing),
            48.0 * t,
            -86.3 * t * (1.0 + 0.2 * swing),
            settled(0.071),
        ],
    }
}

/// Seven discs of radius 0.1 m: three below, two on them, a driven one at the side, one that falls.
fn picture() -> Picture {
    let places = [
        [0.1, 0.1],
        [0.3, 0.1],
        [0.5, 0.1],
        [0.2, 0.273],
        [0.4, 0.273],
        [0.6, 0.273],
        [0.32, 0.55],
    ];
    let discs: Vec<Disc> = places
        .iter()
        .zip(1..)
        .map(|(&at, id)| Disc {
            id,
            at,
            radius: 0.1,
            velocity: if id == 7 { [0.1, -0.8] } else { [0.0, -0.01] },
            spin: 0.0,
            angle: if id == 7 { 0.6 } else { 0.0 },
            material: 0,
            driven: id == 6,
        })
        .collect();
    let pairs: [(usize, usize, f64); 7] = [
        (1, 2, 2.0),
        (2, 3, 4.0),
        (1, 4, 8.0),
        (2, 4, 15.0),
        (2, 5, 31.0),
        (3, 5, 14.0),
        (4, 5, 1.0),
    ];
    let mut touches: Vec<Touch> = pairs
        .iter()
        .map(|&(first, second, n)| {
            let (from, to) = (places[first - 1], places[second - 1]);
            let branch = [to[0] - from[0], to[1] - from[1]];
            let distance = (branch[0] * branch[0] + branch[1] * branch[1]).sqrt();
            Touch {
                ends: [from, to],
                length: 0.2,
                normal: branch.map(|d| d / distance),
                n,
                t: 0.2 * n,
                sliding: n < 2.0,
                first: first as u32,
                second: Some(second as u32),
                wall: None,
            }
        })
        .collect();
    for (first, n) in [(1, 12.0), (2, 48.0), (3, 16.0)] {
        let from = places[first - 1];
        touches.push(Touch {
            ends: [from, [from[0], 0.0]],
            length: 0.1,
            normal: [0.0, -1.0],
            n,
            t: 0.0,
            sliding: false,
            first: first as u32,
            second: None,
            wall: Some(0),
        });
    }
    let wall = |name: &str, ends| Stroke {
        name: name.into(),
        ends,
    };
    let means = Means::of(&discs, &touches);
    let fastest = discs[6].speed();
    Picture {
        discs,
        touches,
        walls: vec![
            wall("floor", [[0.0, 0.0], [0.8, 0.0]]),
            wall("left", [[0.0, 0.0], [0.0, 0.7]]),
        ],
        bounds: [[0.0, 0.0], [0.8, 0.7]],
        whole: None,
        means,
        fastest,
    }
}
