//! No cycle asks for memory once buffers have grown to what the scene needs.
#![expect(
    unsafe_code,
    reason = "a counting allocator can only be written over the system's"
)]

mod common;

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

use ballast::engine::World;
use ballast::engine::setup::{BoundarySetup, Damping, Dashpot, Gravity, Setup};
use common::*;

/// The system's allocator, counting.
struct Counting;

static REQUESTS: AtomicU64 = AtomicU64::new(0);

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
        // SAFETY: the caller keeps the contract of `alloc`.
        unsafe { System.alloc(layout) }
    }

    // SAFETY: as above, unchanged.
    unsafe fn dealloc(&self, at: *mut u8, layout: Layout) {
        // SAFETY: `at` came from `alloc` above, that is from the system.
        unsafe { System.dealloc(at, layout) }
    }

    // SAFETY: as above, unchanged.
    unsafe fn realloc(&self, at: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        Self::count();
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
}
