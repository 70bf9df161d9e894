//! Contact laws, motion and the list of neighbours by themselves: `cargo bench`, or
//! `cargo bench -- hertz-mindlin/600` for some of them.
//!
//! Each runs whole cycles of a standard scene and adds up the time of one part of them; throughput is in
//! touching contacts, or particles where those are what is worked on. Samples are prepared once and kept.

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

use ballast::engine::World;
use ballast::engine::neighbours::Status;
use ballast::engine::phase::Phase;
use ballast::scene::Scene;
use ballast::session::{Options, Place, Session};
use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};

/// Particles, and how often the sample of 600 is repeated.
const SIZES: [(usize, &str); 2] = [(600, "[1, 1]"), (21_600, "[6, 6]")];

const LAWS: [&str; 5] = [
    "linear",
    "hertz",
    "hertz-mindlin",
    "mindlin-deresiewicz",
    "mindlin-deresiewicz-exact",
];

/// The sheared sample some hundred cycles into its shear.
fn session(law: &str, repeat: &str, more: &[&str]) -> Session {
    let mut set = vec![
        format!("model.law=\"{law}\""),
        format!("start.repeat={repeat}"),
    ];
    set.extend(more.iter().map(|set| (*set).to_owned()));
    let scene = Scene::load("periodic-shear", &set).expect("the preset is accepted");
    // One thread, so that sizes compare.
    let options = Options {
        threads: 1,
        expendable: true,
        ..Options::default()
    };
    let mut session = Session::open(scene, options).expect("its sample can be prepared");
    let place = Place {
        stage: "shear".into(),
        cycles: 300,
    };
    session.reach(Some(&place), &mut |_| ()).expect("it runs");
    session
}

/// Time that one part of so many cycles takes.
fn time_of(world: &mut World, wanted: Phase, cycles: u64) -> Duration {
    let sum = Arc::new(AtomicU64::new(0));
    let shared = Arc::clone(&sum);
    let mut last = Instant::now();
    world.set_clock(Some(Box::new(move |phase| {
        let now = Instant::now();
        if phase == wanted {
            shared.fetch_add((now - last).as_nanos() as u64, Ordering::Relaxed);
        }
        last = now;
    })));
    for _ in 0..cycles {
        world.cycle().expect("it runs");
    }
    world.set_clock(None);
    Duration::from_nanos(sum.load(Ordering::Relaxed))
}

fn contacts(c: &mut Criterion) {
    for (size, repeat) in SIZES {
        let mut group = c.benchmark_group("contacts");
        for law in LAWS {
            let mut session = session(law, repeat, &[]);
            let world = session.world_mut();
            let status = &world.contacts().status;
            let touching = status
                .iter()
                .filter(|status| **status != Status::Apart)
                .count();
            group.throughput(Throughput::Elements(touching as u64));
            group.bench_function(BenchmarkId::new(law, size), |b| {
                b.iter_custom(|cycles| time_of(world, Phase::Contacts, cycles));
            });
        }
        group.finish();
    }
}

fn motion(c: &mut Criterion) {
    let mut group = c.benchmark_group("motion");
    for (size, repeat) in SIZES {
        let mut session = session("hertz-mindlin", repeat, &[]);
        group.throughput(Throughput::Elements(size as u64));
        group.bench_function(BenchmarkId::from_parameter(size), |b| {
            b.iter_custom(|cycles| time_of(session.world_mut(), Phase::Motion, cycles));
        });
    }
    group.finish();
}

/// The list is made anew in every cycle, since its halo is next to nothing.
fn neighbours(c: &mut Criterion) {
    let mut group = c.benchmark_group("neighbours");
    for (size, repeat) in SIZES {
        let mut session = session("hertz-mindlin", repeat, &["model.tol=1e-12"]);
        group.throughput(Throughput::Elements(size as u64));
        group.bench_function(BenchmarkId::from_parameter(size), |b| {
            b.iter_custom(|cycles| time_of(session.world_mut(), Phase::Neighbours, cycles));
        });
    }
    group.finish();
}

/// Short enough to be run between two changes: about a minute for all of it.
fn short() -> Criterion {
    Criterion::default()
        .sample_size(20)
        .warm_up_time(Duration::from_millis(500))
        .measurement_time(Duration::from_secs(2))
}

criterion_group! {
    name = kernels;
    config = short();
    targets = contacts, motion, neighbours
}
criterion_main!(kernels);
