//! No cycle asks for memory once buffers have grown to what the scene needs; and what `check` says of
//! that is true.
#![expect(
    unsafe_code,
    reason = "a counting allocator can only be written over the system's"
)]

mod common;

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering};

use ballast::engine::World;
use ballast::engine::neighbours::list::ContactList;
use ballast::engine::setup::{
    Body, BoundarySetup, Damping, Dashpot, Gravity, Setup, TimeStepChoice,
};
use ballast::engine::wall_contact::{WallPair, WallTouch};
use common::*;

/// The system's allocator, counting.
struct Counting;

static REQUESTS: AtomicU64 = AtomicU64::new(0);

/// Bytes that are lent.
static LENT: AtomicUsize = AtomicUsize::new(0);

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
}

// SAFETY: every call goes to the system's allocator unchanged.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        Self::count();
        LENT.fetch_add(layout.size(), Ordering::Relaxed);
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
        LENT.fetch_add(size, Ordering::Relaxed);
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
        let [pairs, at_walls] = ContactList::room(n);
        let at_wall = 2 * size_of::<WallPair>() + size_of::<WallTouch>();
        let unused = (pairs + at_walls - listed) * bytes.contact + at_walls * at_wall;
        let share = lent as f64 / (said + unused) as f64;
        assert!(
            (0.93..1.07).contains(&share),
            "{share} {bytes:?} {lent} {said} {unused}"
        );
    }
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
    the_bytes_that_check_prints_are_those_lent();
}
