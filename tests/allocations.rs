//! No cycle asks for memory once buffers have grown to what the scene needs; and what `check` says of
//! that is true.
#![expect(
    unsafe_code,
    reason = "a counting allocator can only be written over the system's"
)]

mod common;

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use std::path::Path;
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering};

use ballast::engine::World;
use ballast::engine::neighbours::room;
use ballast::engine::setup::{
    Body, BoundarySetup, Damping, Dashpot, Gravity, Material, Setup, TimeStepChoice,
};
use ballast::engine::wall_contact::{WallPair, WallTouch};
use ballast::scene::Scene;
use ballast::session::{Budget, Options, Session};
use common::*;

/// The system's allocator, counting.
struct Counting;

static REQUESTS: AtomicU64 = AtomicU64::new(0);

/// Bytes that are lent, and the most that were since somebody last asked.
static LENT: AtomicUsize = AtomicUsize::new(0);
static PEAK: AtomicUsize = AtomicUsize::new(0);

/// Whether the process has begun.
static BEGUN: AtomicBool = AtomicBool::new(false);

thread_local! {
    /// Whether this is the thread in which the process began. While a test runs in another one it
    /// belongs to the harness, which says something when a busy machine takes more than a minute.
    static OF_HARNESS: Cell<bool> = const { Cell::new(false) };
}

impl Counting {
    fn count() {
        if !BEGUN.swap(true, Ordering::Relaxed) {
            OF_HARNESS.set(true);
        }
        if !OF_HARNESS.get() {
            REQUESTS.fetch_add(1, Ordering::Relaxed);
        }
    }

    fn lend(bytes: usize) {
        let lent = LENT.fetch_add(bytes, Ordering::Relaxed) + bytes;
        PEAK.fetch_max(lent, Ordering::Relaxed);
    }
}

// SAFETY: every call goes to the system's allocator unchanged.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        Self::count();
        Self::lend(layout.size());
        // SAFETY: the caller keeps the contract of `alloc`.
        unsafe { System.alloc(layout) }
    }

    // SAFETY: as above, unchanged.
    unsafe fn dealloc(&self, at: *mut u8, layout: Layout) {
        LENT.fetch_sub(layout.size(), Ordering::Relaxed);
        // SAFETY: `at` came from `alloc` above, that is from the system.
        unsafe { System.dealloc(at, layout) }
    }

    // SAFETY: as above, unchanged.
    unsafe fn realloc(&self, at: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        Self::count();
        Self::lend(size);
        LENT.fetch_sub(layout.size(), Ordering::Relaxed);
        // SAFETY: `at` came from `alloc` above, that is from the system.
        unsafe { System.realloc(at, layout, size) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// Requests for memory in so many cycles, and times the list was made anew in them.
fn requests(world: &mut World, cycles: u64) -> (u64, u64) {
    let rebuilds = world.contacts().rebuilds;
    let before = REQUESTS.load(Ordering::Relaxed);
    run(world, cycles);
    let after = REQUESTS.load(Ordering::Relaxed);
    (after - before, world.contacts().rebuilds - rebuilds)
}

/// A pile with everything that is modelled per cycle.
fn pile(rows: usize, ledger: bool) -> Setup {
    let mut setup = collapsing_pile(rows, 0.2);
    setup.ledger = ledger;
    // Rebuilds often.
    setup.tol = Some(0.02);
    setup.damping = Damping {
        global: 0.1,
        ..setup.damping
    };
    setup.gravity = Some(Gravity::Centripetal {
        towards: [0.0, -1e4],
        g: 10.0,
    });
    setup.walls[0].velocity = [0.0, 0.1];
    setup.walls[1].angular_velocity = 1e-3;
    setup
}

fn ring() -> BoundarySetup {
    BoundarySetup::Ring {
        centre: [0.0; 2],
        radius: 12.0 * RADIUS,
        turning: false,
    }
}

/// A crowd within each kind of boundary, all of them at work.
fn bounded(boundary: BoundarySetup) -> Setup {
    let mut setup = scene(material(STIFFNESS, STIFFNESS, 0.3));
    for i in -6..=6 {
        for j in -6..=6 {
            setup.particles.push(particle(
                1.98 * RADIUS * f64::from(i),
                1.98 * RADIUS * f64::from(j),
                RADIUS,
            ));
        }
    }
    setup.boundary = Some(boundary);
    setup.strain_rate = [[1e-4, 0.0], [0.0, 1e-4]];
    setup.damping.contact = Dashpot::Fraction(0.1);
    // Rebuilds often.
    setup.tol = Some(1e-4);
    setup
}

/// Rows of discs that fall on others.
fn rain() -> Setup {
    let mut setup = scene(Material {
        density: 1.0 / std::f64::consts::PI,
        ..material(1e5, 1e5, 0.3)
    });
    setup.ledger = false;
    setup.damping.contact = Dashpot::Fraction(0.2);
    for k in 0..4200 {
        let (column, row) = (f64::from(k % 84), f64::from(k / 84));
        let mut disc = particle(1.1 * column, 0.5 + 1.02 * row, 0.45);
        disc.velocity[1] = if k < 1680 { 0.0 } else { -15.0 };
        setup.particles.push(disc);
    }
    setup.walls = vec![wall("floor", [-50.0, 0.0], [199.0, 0.0])];
    setup
}

const SIDE: i32 = 100;

/// A hexagonal lattice of spheres in which all six neighbours are listed: three pairs each.
fn lattice(law_name: &str) -> Setup {
    let mut setup = scene(material(STIFFNESS, STIFFNESS, 0.3));
    setup.law = law(law_name);
    setup.body = Body::Sphere;
    setup.time_step = TimeStepChoice::Rayleigh;
    setup.ledger = false;
    for j in 0..SIDE {
        for i in 0..SIDE {
            let x = 2.0 * RADIUS * (f64::from(i) + 0.5 * f64::from(j % 2));
            let y = 3f64.sqrt() * RADIUS * f64::from(j);
            // No two of a size: laws keep parameters for each contact.
            let radius = RADIUS * (1.0 - 1e-6 * f64::from(i + SIDE * j) / f64::from(SIDE * SIDE));
            setup.particles.push(particle(x, y, radius));
        }
    }
    setup
}

/// What `check` says of memory is what a world really takes.
fn the_bytes_that_check_prints_are_those_lent() {
    let cell = BoundarySetup::Cell {
        corner: [-0.5 * RADIUS, -0.5 * RADIUS],
        edges: [
            [2.0 * RADIUS * f64::from(SIDE), 0.0],
            [0.0, 3f64.sqrt() * RADIUS * f64::from(SIDE)],
        ],
    };
    let heavy = Setup {
        gravity: Some(Gravity::Uniform([0.0, -9.81])),
        ..lattice("hertz-mindlin")
    };
    let booked = Setup {
        ledger: true,
        ..lattice("mindlin-deresiewicz-exact")
    };
    let periodic = Setup {
        boundary: Some(cell),
        strain_rate: [[1e-6, 0.0], [0.0, -1e-6]],
        ..lattice("hertz-mindlin")
    };
    for setup in [lattice("hertz-mindlin"), heavy, booked, periodic] {
        let before = LENT.load(Ordering::Relaxed);
        let mut world = World::build(setup.clone(), 1).expect("the scene builds");
        // Every buffer has been used.
        run(&mut world, 2);
        let radius = world.particles().row[0].radius;
        world.set_radius(0, radius);
        let lent = LENT.load(Ordering::Relaxed) - before;
        let (bytes, n) = (world.bytes(), world.particles().len());
        let listed = world.contacts().len();
        assert!(listed > 29 * n / 10, "{listed}");
        let said = bytes.particle * n + bytes.contact * listed;
        // Room that is kept for more contacts, and for those at walls, is lent but never touched.
        let [pairs, at_walls] = room(n);
        let at_wall = 2 * size_of::<WallPair>() + size_of::<WallTouch>();
        let unused = (pairs + at_walls - listed) * bytes.contact + at_walls * at_wall;
        let share = lent as f64 / (said + unused) as f64;
        assert!(
            (0.93..1.07).contains(&share),
            "{share} {bytes:?} {lent} {said} {unused}"
        );
    }
}

/// Discs at random: their places cannot be compressed.
const CROWD: &str = r#"
[model]
law = "linear"
body = "disc"
gravity = [0.0, -9.81]
[material.sand]
density = 2650.0
normal_stiffness = 1e6
shear_stiffness = 6e5
friction = 0.4
[[generate]]
in = { rectangle = { min = [0.0, 0.0], max = [0.5, 0.5] } }
material = "sand"
grading = [{ radius = 0.5e-3, count = 100_000 }]
[history]
columns = ["kinetic"]
[[stage]]
name = "first"
max_cycles = 1
[[stage]]
name = "second"
max_cycles = 1
[[stage]]
name = "third"
max_cycles = 1
"#;

/// Most bytes that a run needs besides what it has, while two stages begin and a good state is kept at
/// each, and while it is saved; and bytes of its world.
fn needed(beside: Option<&Path>, saved: &Path) -> [usize; 2] {
    let scene = Scene::parse("crowd", CROWD, &[]).expect("it is accepted");
    let options = Options {
        threads: 1,
        ..Options::default()
    };
    let mut session = Session::open(scene, options).expect("it opens");
    if let Some(beside) = beside {
        session.write_dumps(beside);
    }
    let until = |cycle| Budget {
        until_cycle: Some(cycle),
        time: None,
    };
    session.advance(until(1), false).expect("it runs");
    let before = LENT.load(Ordering::Relaxed);
    PEAK.store(before, Ordering::Relaxed);
    session.advance(until(3), false).expect("it runs");
    assert_eq!(session.safe_cycle(), Some(2));
    session.save(saved).expect("it can be written");
    let world = session.world();
    let bytes = world.bytes();
    let has = bytes.particle * world.particles().len() + bytes.contact * world.contacts().len();
    [PEAK.load(Ordering::Relaxed) - before, has]
}

/// A good state to go back to is kept beside the run's files, not in memory, and a checkpoint goes to
/// its file as it is made; so a large world needs no second place.
fn a_large_state_is_kept_in_no_memory() {
    let folder = tempfile::tempdir().expect("a folder");
    let saved = folder.path().join("saved.ballast");
    let [on_disk, world] = needed(Some(&folder.path().join("run.csv")), &saved);
    assert!(world > 20 << 20, "{world}");
    // A mebibyte before it goes to its file, doubled as it grows, and some buffers.
    assert!(on_disk < 3 << 20, "{on_disk}");
    let compressed = std::fs::metadata(&saved).expect("it is there").len() as usize;
    assert!(compressed > 3 << 20 && on_disk < compressed, "{compressed}");
    // Where there is no place for a file, nothing is lost.
    let [in_memory, _] = needed(None, &saved);
    assert!(in_memory > compressed, "{in_memory} {compressed}");
    let session = Session::resume(&saved, 1).expect("it is a checkpoint");
    assert_eq!(session.world().cycle_number(), 3);
}

// One test only: the counter counts the whole process, but for the harness.
#[test]
fn no_cycle_asks_for_memory() {
    // With `--test-threads=1` the harness's thread is this one.
    OF_HARNESS.set(false);
    // Two threads on a busy machine wait for each other: fewer cycles.
    for (rows, threads, cycles) in [(14, 1, 3000), (40, 2, 600)] {
        for ledger in [false, true] {
            let setup = pile(rows, ledger);
            let mut world = World::build(setup, threads).expect("the scene builds");
            // Spread out, the pile has fewer contacts than while it collapses; lists and their
            // spare copies have to have met the largest number once.
            run(&mut world, cycles);
            let (asked, rebuilds) = requests(&mut world, cycles);
            assert!(rebuilds > 5, "{rebuilds}");
            assert_eq!(asked, 0, "{rows} rows, {threads} threads, ledger {ledger}");
            // Negative control: the counter counts.
            let before = REQUESTS.load(Ordering::Relaxed);
            drop(std::hint::black_box(vec![1u8; 100]));
            assert_eq!(REQUESTS.load(Ordering::Relaxed), before + 1);
            if threads > 1 {
                let parts = ballast::engine::threads::Threads::new(threads);
                assert!(parts.parts(world.particles().len()) > 1);
            }
        }
    }
    let side = 13.0 * 1.98 * RADIUS;
    for (boundary, loaded) in [
        (
            BoundarySetup::Cell {
                corner: [-0.5 * side; 2],
                edges: [[side, 0.0], [0.0, side]],
            },
            false,
        ),
        (ring(), false),
        (ring(), true),
    ] {
        let mut world = World::build(bounded(boundary), 1).expect("the scene builds");
        if loaded {
            assert!(world.load_boundary([[1e3, 0.0], [0.0, 1e3]], 0));
        }
        run(&mut world, 1000);
        let (asked, rebuilds) = requests(&mut world, 1000);
        assert!(rebuilds > 5, "{rebuilds}");
        assert_eq!(asked, 0, "{boundary:?} {loaded}");
    }
    // Halos that differ from place to place: no less room than where many lie that nobody falls on yet.
    let mut world = World::build(rain(), 1).expect("the scene builds");
    run(&mut world, 300);
    let (asked, rebuilds) = requests(&mut world, 300);
    assert!(rebuilds > 5, "{rebuilds}");
    assert_eq!(asked, 0, "rain");
    the_bytes_that_check_prints_are_those_lent();
    a_large_state_is_kept_in_no_memory();
}
