//! The mean stress of everything inside rigid walls against what the walls measure, as the assembly
//! comes to rest.

use ballast::scene::Scene;
use ballast::session::{Budget, Options, Session};

use crate::grains::grains;

/// Half the width of the box, before its walls move [m].
const HALF: f64 = 0.0105;

/// Half the width of the region that covers it with room to spare [m].
const COVER: f64 = 0.012;

/// 200 spheres of five sizes between smooth rigid walls that carry about 100 kPa and then stay. The stage `still` ends when no force is out of balance, in the
/// mean, by more than 1e-7 of the mean contact force.
fn at_rest() -> Session {
    let corners = [[-HALF, -HALF], [HALF, -HALF], [HALF, HALF], [-HALF, HALF]];
    let names = ["floor", "right", "ceiling", "left"];
    let mut walls = String::new();
    for (k, name) in names.iter().enumerate() {
        let [from, to] = [corners[k], corners[(k + 1) % 4]];
        walls += &format!(
            "[[wall]]\nname = \"{name}\"\nfrom = {from:?}\nto = {to:?}\nmaterial = \"plate\"\n"
        );
    }
    let place = format!("{{ rectangle = {{ min = [-{HALF}, -{HALF}], max = [{HALF}, {HALF}] }} }}");
    let grains = grains(&place);
    let preset = format!(
        r#"
        {grains}
        [material.plate]
        rigid = true
        [boundary]
        kind = "walls"
        {walls}
        [[measure]]
        name = "cover"
        rectangle = {{ min = [-{COVER}, -{COVER}], max = [{COVER}, {COVER}] }}
        [history]
        every = 200
        columns = [
          "stress_11", "stress_22", "stress_12", "stress_21", "mean_force", "unbalanced",
          "wall:floor:f1", "wall:right:f1", "wall:ceiling:f1", "wall:left:f1",
          "wall:floor:f2", "wall:right:f2", "wall:ceiling:f2", "wall:left:f2",
          "wall:floor:moment", "wall:right:moment", "wall:ceiling:moment", "wall:left:moment",
        ]
        [[stage]]
        name = "gather"
        do = ["continuum boundary", "strain rate 20 0 0 20", "con1 0.99"]
        until = "isotropic_stress > 1e4"
        max_cycles = 100_000
        [[stage]]
        name = "compress"
        do = ["con1 0.9999", "strain rate 0 0 0 0", "servo mean 1e5"]
        until = "abs(isotropic_stress - 1e5) < 1e4 and unbalanced < 0.1"
        max_cycles = 100_000
        [[stage]]
        name = "still"
        do = ["servo off", "strain rate 0 0 0 0", "con1 0.99", "continuum none", "friction 0.3 material glass"]
        until = "unbalanced < 1e-7"
        max_cycles = 50_000
        "#
    );
    let scene = Scene::parse("rest", &preset, &[]).expect("the scene is sound");
    let mut session = Session::open(scene, Options::default()).expect("the scene is sound");
    session
        .advance(Budget::default(), false)
        .expect("nothing breaks");
    assert_eq!(session.cut_short(), &[] as &[String]);
    session
}

/// A row of the stage in which the walls stay.
struct Still {
    /// Out-of-balance over contact force [-].
    unbalanced: f64,
    /// Mean contact force [N].
    force: f64,
    /// Components 11, 22, 12, 21 by the contacts of all particles [Pa].
    inside: [f64; 4],
    /// The same by the walls: their forces at their places [Pa].
    walls: [f64; 4],
}

impl Still {
    /// Largest difference of a component, over the mean stress.
    fn off(&self) -> f64 {
        let both = self.inside.iter().zip(self.walls);
        let off = both.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        off / (0.5 * (self.walls[0] + self.walls[1]))
    }
}

fn stills(session: &Session) -> Vec<Still> {
    let (recording, world) = (session.recording(), session.world());
    // Where the walls stand, smooth, so that they push at right angles: floor and ceiling at their
    // height, the others at their distance; where along themselves, their moments say.
    let place = |w: usize, k: usize| world.walls()[w].point[k];
    let about = |w: usize, k: usize| world.walls()[w].about[k];
    let volume = (2.0 * COVER).powi(2) * world.thickness();
    let rows = recording.rows().iter().enumerate();
    rows.filter(|(_, row)| row.stage == 2 && row.stage_cycle > 0)
        .map(|(row, _)| {
            let at = |column: usize| recording.value(row, column);
            let (f1, f2) = (|w: usize| at(6 + w), |w: usize| at(10 + w));
            let moment = |w: usize| at(14 + w);
            let level = |w: usize| moment(w) + about(w, 0) * f2(w);
            let upright = |w: usize| -moment(w) + about(w, 1) * f1(w);
            let sums = [
                place(1, 0) * f1(1) + place(3, 0) * f1(3),
                place(0, 1) * f2(0) + place(2, 1) * f2(2),
                level(0) + level(2),
                upright(1) + upright(3),
            ];
            Still {
                unbalanced: at(5),
                force: at(4),
                inside: [at(0), at(1), at(2), at(3)],
                walls: sums.map(|sum| sum / volume),
            }
        })
        .collect()
}

#[test]
fn walls_measure_the_stress_of_everything_inside() {
    let session = at_rest();
    let (rows, world) = (stills(&session), session.world());
    let volume = (2.0 * COVER).powi(2) * world.thickness();
    // Each out-of-balance force acts at half the diagonal of the box at most.
    let arms = world.particles().len() as f64 * HALF * 2f64.sqrt() / volume;
    for row in &rows {
        let stress = 0.5 * (row.walls[0] + row.walls[1]);
        let bound = arms * row.unbalanced * row.force / stress + 1e-12;
        assert!(row.off() < bound, "{} {bound}", row.off());
    }
    let (first, last) = (&rows[0], &rows[rows.len() - 1]);
    assert!(
        last.unbalanced < 1e-7 && last.off() < 1e-6,
        "{}",
        last.off()
    );
    // While it moves they do differ, so equality is not built in.
    assert!(first.off() > 1e-4, "{} {}", first.off(), first.unbalanced);
}
