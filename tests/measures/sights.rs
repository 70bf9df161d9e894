//! Of a scene with more particles than a screen has dots, a picture holds what can be seen, and no more.

use std::collections::{BTreeMap, BTreeSet};
use std::time::Duration;

use ballast::measure::frame::{Picture, Touch};
use ballast::measure::sight::Sight;
use ballast::scene::Scene;
use ballast::session::{Budget, Options, Session};

const SPACING: f64 = 1.9994e-3;

/// Discs in a square, side by side, each touching four others.
fn square(side: u32) -> Session {
    let width = f64::from(side) * SPACING;
    let text = format!(
        r#"
[model]
law = "linear"
body = "disc"
[material.sand]
density = 2650.0
normal_stiffness = 1e6
shear_stiffness = 6e5
friction = 0.4
[[generate]]
in = {{ rectangle = {{ min = [0, 0], max = [{width}, {width}] }} }}
material = "sand"
lattice = "square"
radius = 1e-3
spacing = {SPACING}
[[stage]]
name = "still"
max_cycles = 1000
"#
    );
    let scene = Scene::parse("square", &text, &[]).expect("it is accepted");
    let options = Options {
        threads: 1,
        ..Options::default()
    };
    let session = Session::open(scene, options).expect("it opens");
    assert_eq!(session.world().particles().len(), (side * side) as usize);
    session
}

/// Dot that a point lies in, of those that a sight and its margin have.
fn dot(sight: &Sight, at: [f64; 2]) -> Option<[u32; 2]> {
    let Sight {
        window: [low, high],
        dots,
        ..
    } = sight.wider();
    let place = [0, 1].map(|k| (at[k] - low[k]) / (high[k] - low[k]) * f64::from(dots[k]));
    let inside = (0..2).all(|k| place[k] >= 0.0 && place[k] < f64::from(dots[k]));
    inside.then(|| place.map(|x| x as u32))
}

#[test]
fn every_dot_that_something_falls_in_is_drawn_and_few_things_twice() {
    let mut session = square(150);
    // Its rims spring back: contacts there carry less than others.
    let some = Budget {
        until_cycle: Some(40),
        ..Budget::default()
    };
    session.advance(some, false).expect("it runs");
    let world = session.sample();
    let whole = Picture::of(world.world());
    let sight = Sight {
        window: whole.bounds,
        dots: [40, 30],
    };
    let seen = Picture::seen(world.world(), Some(&sight), None);
    let dots = |picture: &Picture| {
        let discs = picture.discs.iter().map(|disc| dot(&sight, disc.at));
        let touches = picture
            .touches
            .iter()
            .map(|touch| dot(&sight, touch.bar().0));
        [discs.collect::<BTreeSet<_>>(), touches.collect()]
    };
    let [discs, touches] = dots(&whole);
    assert_eq!(dots(&seen), [discs.clone(), touches.clone()]);
    assert_eq!(seen.discs.len(), discs.len());
    let bars = seen.touches.len();
    assert!(bars > touches.len() && bars <= 2 * touches.len(), "{bars}");
    assert!(15 * bars < whole.touches.len() && 15 * discs.len() < whole.discs.len());
    // What they are fitted to is the box of all of them, to rounding.
    let [low, high] = seen.whole.expect("some are left out");
    for k in 0..2 {
        assert!((low[k] - whole.bounds[0][k]).abs() < 1e-15);
        assert!((high[k] - whole.bounds[1][k]).abs() < 1e-15);
    }
    assert_eq!((seen.bounds, &seen.walls), (whole.bounds, &whole.walls));
    // Of bars it is the strongest that are there.
    let largest = |picture: &Picture| {
        let mut largest = BTreeMap::new();
        for touch in &picture.touches {
            let at_dot: &mut f64 = largest.entry(dot(&sight, touch.bar().0)).or_default();
            *at_dot = at_dot.max(touch.force());
        }
        largest
    };
    assert_eq!(largest(&seen), largest(&whole));
    // The width of a bar goes by all of them, whatever is seen.
    let part = Sight::whole([[0.0, 0.0], [0.03, 0.02]]);
    let close = Picture::seen(world.world(), Some(&part), None);
    assert!(whole.means.force > 0.0 && whole.means.radius > 0.0);
    assert_eq!([seen.means, close.means], [whole.means; 2]);
}

#[test]
fn whoever_looks_closely_sees_everything_there_and_what_is_selected() {
    let mut session = square(150);
    let world = session.sample();
    let whole = Picture::of(world.world());
    // The last disc, in a corner, touches two others.
    let corner = whole.discs.last().expect("there are some");
    let sight = Sight {
        window: [[0.1, 0.1], [0.12, 0.11]],
        dots: [100, 50],
    };
    let seen = Picture::seen(world.world(), Some(&sight), Some(corner.id));
    let is_selected = |id: u32| id == corner.id;
    let near = |at: [f64; 2]| {
        let [low, high] = sight.wider().window;
        (0..2).all(|k| at[k] + 1e-3 >= low[k] && at[k] - 1e-3 <= high[k])
    };
    let mut expected = whole.clone();
    expected
        .discs
        .retain(|disc| near(disc.at) || is_selected(disc.id));
    expected.touches.retain(|touch| {
        near(touch.bar().0) || is_selected(touch.first) || touch.second.is_some_and(is_selected)
    });
    // From whichever end: some that are near begin outside.
    let begins_outside = |touch: &&Touch| near(touch.bar().0) && !near(touch.ends[0]);
    assert!(expected.touches.iter().any(|touch| begins_outside(&touch)));
    assert_eq!(seen.discs, expected.discs);
    assert_eq!(seen.touches, expected.touches);
    let far = seen.touches.iter().filter(|touch| !near(touch.bar().0));
    assert_eq!(far.count(), 2);
    assert!(seen.discs.len() > 100 && seen.discs.len() < 300);
    // Also where nobody looks at the assembly.
    for corner in [&whole.discs[0], corner] {
        let unseen = Picture::seen(world.world(), None, Some(corner.id));
        let of = |touch: &&Touch| touch.first == corner.id || touch.second == Some(corner.id);
        let [found, all] = [&unseen, &whole].map(|picture| picture.touches.iter().filter(of));
        assert!(found.eq(all) && unseen.discs.contains(corner));
    }
}

#[test]
fn a_scene_that_is_no_crowd_is_drawn_whole() {
    let mut session = square(20);
    let world = session.sample();
    let far = Sight::whole([[7.0, 7.0], [8.0, 8.0]]);
    let seen = Picture::seen(world.world(), Some(&far), None);
    assert!(seen.whole.is_none() && seen == Picture::of(world.world()));
}

#[test]
fn a_batch_ends_after_the_cycle_in_which_its_time_is_over() {
    let mut session = square(20);
    let no_time = Budget {
        time: Some(Duration::ZERO),
        ..Budget::default()
    };
    for cycle in 1..=3 {
        session.advance(no_time, false).expect("it runs");
        assert_eq!(session.world().cycle_number(), cycle);
    }
}
