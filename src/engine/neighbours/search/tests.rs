//! What is found by boxes against what comparing all finds.

use super::*;
use crate::engine::extent::Extent;
use crate::engine::setup::WallSetup;
use proptest::prelude::*;

/// Sizes over three decades, so that levels differ, in an assembly that fits on a few boxes or
/// on many; one in thirteen may have been flung away.
fn assembly() -> impl Strategy<Value = Vec<Row>> {
    let flung = prop_oneof![Just(1.0), Just(3.0), 1.0..1000.0f64];
    (crowd(), flung).prop_map(|(mut rows, away)| {
        for row in rows.iter_mut().step_by(13) {
            row.x = row.x.map(|x| away * x);
        }
        rows
    })
}

fn crowd() -> impl Strategy<Value = Vec<Row>> {
    let row = |(x, y, size): (f64, f64, f64)| Row {
        x: [x, y],
        radius: 1e-3 * libm::pow(1000.0, size),
        ..Row::default()
    };
    prop::collection::vec((-1.0..1.0f64, -0.3..0.3f64, 0.0..1.0f64), 0..420)
        .prop_map(move |rows| rows.into_iter().map(row).collect())
}

fn wall(from: [f64; 2], turn: f64, ends: [f64; 2]) -> Wall {
    let setup = WallSetup {
        name: String::new(),
        material: 0,
        point: from,
        direction: [libm::cos(turn), libm::sin(turn)],
        h1: ends[0],
        h2: ends[1],
        velocity: [0.0; 2],
        angular_velocity: 0.0,
        about: from,
    };
    Wall::new(&setup, [0.0; 2])
}

proptest! {
    #[test]
    fn finds_what_comparing_all_pairs_finds(
        rows in assembly(),
        equal in any::<bool>(),
        tol in 1e-5..0.05f64,
    ) {
        let mut rows = rows;
        if equal {
            for row in &mut rows {
                row.radius = 0.05;
            }
        }
        let mut party = Party::default();
        let mut grid = Grid::default();
        let mut all = Vec::new();
        for p in 0..rows.len() {
            for q in p + 1..rows.len() {
                let [a, b] = [p, q].map(|k| Spot::new(rows[k].x, rows[k].radius));
                if a.is_near(&b, tol) {
                    all.push([p as u32, q as u32]);
                }
            }
        }
        let here: Vec<_> = all.into_iter().map(|pair| (pair, HERE)).collect();
        // Twice, for what is left in the buffers.
        let isas = || Isa::ALL.into_iter().filter(|isa| isa.is_here());
        for (threads, isa) in [1, 1, 3].into_iter().flat_map(|n| isas().map(move |isa| (n, isa))) {
            let threads = &Threads::new(threads);
            let halos = &Halos::everywhere(tol);
            pairs(&mut grid, &rows, Sought { halos, isa, threads }, &mut party);
            prop_assert_eq!(&party.found().in_order(), &here, "{}", isa);
        }
        prop_assert!(equal || rows.len() < 40 || grid.levels.len() > 3);
    }

    #[test]
    fn walls_are_met_where_testing_everything_meets_them(
        rows in assembly(),
        walls in prop::collection::vec(
            ((-1.2..1.2f64, -0.5..0.5f64), 0..9u8, (-1.0..0.0f64, 0.0..1.0f64), 0..4u8), 1..6),
        tol in 1e-5..0.05f64,
    ) {
        let walls: Vec<Wall> = walls
            .into_iter()
            .map(|(at, turn, ends, open)| {
                // Upright, level and slanting, with ends or without.
                let turn = f64::from(turn) * std::f64::consts::FRAC_PI_8;
                let h1 = if open & 1 == 0 { ends.0 } else { f64::NEG_INFINITY };
                let h2 = if open & 2 == 0 { ends.1 } else { f64::INFINITY };
                let mut wall = wall(at.into(), turn, [h1, h2]);
                wall.direction = wall.direction.map(|e| if e.abs() < 1e-9 { 0.0 } else { e });
                wall
            })
            .collect();
        let mut grid = Grid::default();
        let mut party = Party::default();
        let (isa, threads) = (Isa::default(), &Threads::default());
        let halos = &Halos::everywhere(tol);
        pairs(&mut grid, &rows, Sought { halos, isa, threads }, &mut party);
        let [mut by_boxes, mut by_all] = [Vec::new(), Vec::new()];
        wall_pairs(Some(&grid), &rows, &walls, tol, &mut by_boxes);
        wall_pairs(None, &rows, &walls, tol, &mut by_all);
        prop_assert_eq!(by_boxes, by_all);
    }
}

/// Equal particles on lattices that begin where a box does, some as far apart as they reach less a
/// hair: neighbours stand on the edges of boxes.
#[test]
fn those_on_the_edges_of_boxes_are_found() {
    let (radius, tol) = (0.5, 0.25);
    // Columns, spacings for a reach, how far away half of them stand, and boxes to look at aside: a
    // crowd, a lattice, and strings with so much room between them that boxes are large.
    for (columns, finer, away, aside) in
        [(30, 2.0, 0.0, 4), (30, 1.0, 0.0, 2), (900, 1.0, 300.0, 1)]
    {
        let spacing = (2.0 * radius + tol) / finer * (1.0 - 1e-12);
        let row = |x: [f64; 2]| Row {
            x: x.map(|x| x * spacing),
            radius,
            ..Row::default()
        };
        let at = |k: usize| [(k % columns) as f64, (k / columns) as f64];
        let mut rows: Vec<Row> = (0..900).map(|k| row(at(k))).collect();
        // Half of them, or boxes would be laid over the others only.
        for row in &mut rows[450..] {
            row.x[1] += away;
        }
        let (mut grid, mut party) = (Grid::default(), Party::default());
        let (isa, threads) = (Isa::default(), &Threads::default());
        let halos = &Halos::everywhere(tol);
        pairs(
            &mut grid,
            &rows,
            Sought {
                halos,
                isa,
                threads,
            },
            &mut party,
        );
        let spots: Vec<Spot> = (rows.iter())
            .map(|row| Spot::new(row.x, row.radius))
            .collect();
        let near = |p: usize| {
            let spots = &spots;
            let near = move |q: &usize| spots[p].is_near(&spots[*q], tol);
            (p + 1..900).filter(near).map(move |q| [p as u32, q as u32])
        };
        assert_eq!(
            party.found().early,
            (0..900).flat_map(near).collect::<Vec<_>>()
        );
        assert_eq!(grid.levels[0].aside, aside);
    }
}

proptest! {
    /// Halos that differ from tile to tile: each pair is as near as the halo of the one who looks, which
    /// is the first of its size, or the smaller one.
    #[test]
    fn who_looks_finds_what_is_in_its_own_halo(
        places in prop::collection::vec((-1.0..1.0f64, -0.3..0.3f64, 0..8u8), 200..420),
        shares in prop::collection::vec(0.0..1.0f64, 64),
        sizes in any::<bool>(),
    ) {
        let row = |&(x, y, kind): &(f64, f64, u8)| Row {
            x: [x, y],
            radius: if sizes && kind == 0 { 0.04 } else { 0.01 },
            ..Row::default()
        };
        let rows: Vec<Row> = places.iter().map(row).collect();
        let (mut extent, mut radii) = (Extent::default(), [0.0f64; 2]);
        for row in &rows {
            extent.take_in(row.x);
            radii = [radii[0].max(row.radius), radii[1] + row.radius / rows.len() as f64];
        }
        let mut halos = Halos::everywhere(0.02);
        halos.lay(&extent, (rows.len(), radii), 0.02);
        prop_assume!(!halos.is_one());
        let wanted: Vec<f64> = (0..halos.widths().len()).map(|k| 0.1 * shares[k % 64]).collect();
        halos.widen(&wanted, 1.0);
        let mut all = Vec::new();
        for p in 0..rows.len() {
            for q in p + 1..rows.len() {
                let [a, b] = [p, q].map(|k| Spot::new(rows[k].x, rows[k].radius));
                let looks = if b.radius < a.radius { b } else { a };
                if a.is_near(&b, halos.of(halos.tile(looks.x))) {
                    all.push([p as u32, q as u32]);
                }
            }
        }
        let (mut grid, mut party) = (Grid::default(), Party::default());
        let isas = Isa::ALL.into_iter().filter(|isa| isa.is_here());
        for (threads, isa) in isas.flat_map(|isa| [(1, isa), (3, isa)]) {
            let threads = &Threads::new(threads);
            let sought = Sought { halos: &halos, isa, threads };
            pairs(&mut grid, &rows, sought, &mut party);
            prop_assert_eq!(&party.found().early, &all, "{}", isa);
        }
        prop_assert_eq!(grid.levels.len(), 1 + usize::from(radii[0] > 0.01));
    }
}
