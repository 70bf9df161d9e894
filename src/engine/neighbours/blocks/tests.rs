//! Boxes around ways against the ways themselves.

use super::*;

/// Particles of radius one half, two apart, row by row.
const COLUMNS: usize = 40;
const ROWS: usize = 80;

fn at(p: usize) -> [f64; 2] {
    [2 * (p % COLUMNS), 2 * (p / COLUMNS)].map(|x| x as f64)
}

/// A list was made of them, with this halo.
struct Listed {
    centres: Vec<[f64; 2]>,
    rows: Vec<Row>,
    halos: Halos,
    blocks: Blocks,
    threads: Threads,
}

impl Listed {
    fn new() -> Self {
        Self::of((0..COLUMNS * ROWS).map(at).collect())
    }

    fn of(centres: Vec<[f64; 2]>) -> Self {
        let row = |&x| Row::new(x, 0.5, [0.0; 2], 0.0);
        let rows = centres.iter().map(row).collect();
        let mut listed = Self {
            centres,
            rows,
            halos: Halos::default(),
            blocks: Blocks::default(),
            threads: Threads::new(2),
        };
        listed.list(0.25);
        listed
    }

    fn list(&mut self, tol: f64) {
        self.centres = self.rows.iter().map(|row| row.x).collect();
        let mut extent = Extent::default();
        self.centres.iter().for_each(|x| extent.take_in(*x));
        self.blocks.learn(&self.halos, 0.0);
        let crowd = (self.rows.len(), [0.5; 2]);
        self.halos.lay(&extent, crowd, tol);
        self.blocks.begin(&self.centres, &mut self.halos, 0.0);
        assert!(self.blocks.are_there());
    }

    /// A cycle of one second.
    fn cycle(&mut self, velocity: impl Fn(usize) -> [f64; 2]) {
        let mut fastest = 0.0f64;
        for (p, row) in self.rows.iter_mut().enumerate() {
            row.v = velocity(p);
            row.x = [row.x[0] + row.v[0], row.x[1] + row.v[1]];
            fastest = fastest.max(libm::hypot(row.v[0], row.v[1]));
        }
        let mut ways = self.blocks.take();
        go_on(&mut ways, &self.rows, 1.0);
        self.blocks.give_back(ways);
        self.blocks.come_nearer(2.0 * fastest);
    }

    fn lasts(&mut self, wall: f64) -> bool {
        let moved = Moved::new(&self.rows, &self.centres, &self.threads);
        self.blocks.last(&self.halos, wall, moved)
    }

    /// Whether any two came nearer to each other by more than the halo of one of them: then they may
    /// not be listed. Looked for in two rows around.
    fn is_broken(&self) -> bool {
        let way = |p: usize| [0, 1].map(|k| self.rows[p].x[k] - self.centres[p][k]);
        let halo = |p: usize| self.halos.of(self.halos.tile(self.centres[p]));
        let all = self.rows.len();
        (0..all).any(|p| {
            (p + 1..all.min(p + 2 * COLUMNS + 3)).any(|q| {
                let (a, b) = (way(p), way(q));
                let far = [0, 1].map(|k| self.centres[p][k] - self.centres[q][k]);
                libm::hypot(far[0], far[1]) < 5.0
                    && libm::hypot(a[0] - b[0], a[1] - b[1]) > halo(p).min(halo(q))
            })
        })
    }
}

/// What is above falls on what lies below. Between them is an edge of tiles, which are six wide.
fn falling(p: usize) -> [f64; 2] {
    [0.0, if at(p)[1] < 61.0 { 0.0 } else { -0.01 }]
}

#[test]
fn who_falls_together_spends_nothing() {
    let mut listed = Listed::new();
    for _ in 0..20 {
        listed.cycle(|_| [0.003, -0.01]);
        assert!(listed.lasts(0.0));
    }
    // But a wall does not fall with them; its halo is that of all in the first list.
    listed.cycle(|_| [0.003, -0.01]);
    listed.blocks.come_nearer(0.05);
    assert!(!listed.lasts(0.05));
}

#[test]
fn halos_are_wide_where_something_falls_on_something() {
    let mut listed = Listed::new();
    let mut cycles = 0;
    while listed.lasts(0.0) {
        assert!(!listed.is_broken());
        listed.cycle(falling);
        cycles += 1;
    }
    // .97 of .25.
    assert_eq!(cycles, 25);
    listed.list(0.25);
    let halo = |y: f64| listed.halos.of(listed.halos.tile([40.0, y]));
    let [below, at, above] = [0.0, 60.0, 150.0].map(halo);
    assert!(at > 0.5 && at < 2.0, "{at}");
    assert!(
        (below / at - LEAST[0]).abs() < 1e-12 && below == above,
        "{below}"
    );
    assert!((listed.halos.mean() - 0.25).abs() < 1e-12);
    // So that this one lasts longer.
    let mut longer = 0;
    while listed.lasts(0.0) {
        assert!(!listed.is_broken());
        listed.cycle(falling);
        longer += 1;
    }
    assert!(f64::from(longer) >= 0.9 * at / 0.01, "{longer} {at}");
}

#[test]
fn who_is_far_may_come_near() {
    // Two crowds with nobody between them, each of which goes as one.
    let apart = |[x, y]: [f64; 2]| [x, if y < 60.0 { y } else { y + 40.0 }];
    let mut listed = Listed::of((0..COLUMNS * ROWS).map(at).map(apart).collect());
    let falling = |p: usize| [0.0, if at(p)[1] < 60.0 { 0.0 } else { -0.5 }];
    let mut nearer = 0.0;
    for lists in 0..3 {
        nearer = 0.0;
        while listed.lasts(0.0) && nearer < 50.0 {
            listed.cycle(falling);
            nearer += 0.5;
        }
        // There is nothing to widen any halo for, but that of walls.
        assert_eq!(listed.halos.widths()[0], 0.25);
        listed.list(0.25);
        assert!(listed.halos.wall() > 4.9, "{lists}");
    }
    // As near as 97 hundredths of what tiles that do not touch are apart, or half a metre nearer.
    let apart = listed.halos.apart();
    assert!(
        nearer > SPENT * apart && nearer < SPENT * apart + 0.5,
        "{nearer} {apart}"
    );
}

#[test]
fn who_trembles_goes_nowhere() {
    let mut listed = Listed::new();
    let mut sign = 1.0;
    for _ in 0..100 {
        sign = -sign;
        listed.cycle(|p| [if p % 3 == 0 { sign * 0.02 } else { 0.0 }, 0.0]);
        assert!(listed.lasts(0.0));
    }
    // The boxes alone say otherwise.
    listed.cycle(|_| [0.0; 2]);
    let grown = |way: &Extent| way.size()[0] > 0.25;
    for _ in 0..10 {
        listed.cycle(|p| [if p % 3 == 0 { sign * 0.02 } else { 0.0 }, 0.0]);
        sign = -sign;
    }
    assert!(listed.blocks.ways.iter().any(grown));
}

#[test]
fn what_flies_far_or_unknown_ways_end_the_list() {
    let mut listed = Listed::new();
    listed.blocks.lose();
    assert!(!listed.lasts(0.0));
    listed.list(0.25);
    assert!(listed.lasts(0.0));
    // One alone, much faster than any halo.
    listed.cycle(|p| [0.0, if p == 7 * 176 { 0.3 } else { 0.0 }]);
    assert!(!listed.lasts(0.0) && listed.is_broken());
}

#[test]
fn a_checkpoint_has_the_blocks_of_its_list() {
    let mut listed = Listed::new();
    listed.cycle(falling);
    let stored = postcard::to_allocvec(&listed.blocks).expect("they are numbers");
    let mut read: Blocks = postcard::from_bytes(&stored).expect("they are what was stored");
    assert!(read.unpack(&listed.centres, &listed.halos));
    assert_eq!(read.ways, listed.blocks.ways);
    assert!(!read.unpack(&listed.centres[..100], &listed.halos));
    assert!(!read.unpack(&listed.centres, &Halos::everywhere(0.25)));
    assert!(!Blocks::default().unpack(&listed.centres, &listed.halos));
    assert!(Blocks::default().unpack(&listed.centres, &Halos::everywhere(0.25)));
}

#[test]
fn who_is_surprised_is_wary_for_a_while() {
    let mut listed = Listed::new();
    let mut least = vec![];
    for list in 0..8 {
        while listed.lasts(0.0) {
            listed.cycle(|p| match p {
                // Once somebody jumps where all are at rest.
                1000 if list == 3 => [0.0, 0.2],
                _ => falling(p),
            });
        }
        listed.list(0.25);
        least.push(listed.blocks.least() / LEAST[0]);
    }
    // After one cycle of a jump the front, too, comes as a surprise; then all goes as foreseen.
    let expected = [1.0, 1.0, 1.0, 2.0, 4.0, 3.2, 2.56, 2.048];
    for (seen, expected) in least.iter().zip(expected) {
        assert!((seen - expected).abs() < 1e-12, "{least:?}");
    }
}
