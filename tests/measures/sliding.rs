//! Sliding ways of contacts against the energy that the same sliding cost, law by law.

use ballast::measure::changes::Changes;
use ballast::measure::columns::Column;
use ballast::measure::reference::Reference;
use ballast::scene::Scene;
use ballast::session::{Budget, Options, Session};

/// A sphere that is driven along a floor at a constant overlap: a constant normal force, so that
/// the way is what sliding cost over μN.
fn scene(law: &str) -> String {
    format!(
        r#"
        [model]
        law = "{law}"
        body = "sphere"
        time_step = 1e-8
        rotation = false
        [damping]
        contact = 0.0
        [material.glass]
        density = 2500.0
        young = 70e9
        poisson = 0.3
        friction = 0.3
        {stiffness}
        [[particle]]
        at = [0.0, 0.000999]
        radius = 0.001
        material = "glass"
        driven = true
        [[wall]]
        name = "floor"
        from = [-1.0, 0.0]
        to = [1.0, 0.0]
        material = "glass"
        [history]
        every = 1000
        columns = ["contact:1-floor:slid", "mean_slid", "max_slid"]
        "#,
        stiffness = if law == "linear" {
            "normal_stiffness = 2e6\nshear_stiffness = 1.6e6"
        } else {
            ""
        }
    )
}

struct Slider(Session);

impl Slider {
    fn new(law: &str) -> Self {
        let scene = Scene::parse("slider", &scene(law), &[]).expect("it is sound");
        Self(Session::open(scene, Options::default()).expect("it opens"))
    }

    fn tell(&mut self, line: &str) -> Vec<String> {
        let reply = self.0.type_line(line).expect(line);
        if reply.request.is_some() {
            let ran = self.0.advance(Budget::default(), false);
            ran.expect("nothing goes wrong");
        }
        reply.lines
    }

    fn value(&mut self, name: &str) -> f64 {
        let column = Column::parse(name).expect("it is in the list");
        self.0.sample().value(&column)
    }
}

/// To and fro by 2 µm, and to again: each turn takes the elastic way back first. A way counts steps
/// whole, so that it may exceed the one of the loss by the elastic part of the step in which each of
/// the three slides begins; where sliding stops it stops at a boundary.
#[test]
fn ways_are_what_sliding_cost() {
    for law in [
        "linear",
        "hertz-mindlin",
        "mindlin-deresiewicz",
        "mindlin-deresiewicz-exact",
    ] {
        let mut slider = Slider::new(law);
        let step = 0.1 * 1e-8;
        for velocity in [0.1, -0.1, 0.1] {
            slider.tell(&format!("particle 1 velocity {velocity} 0"));
            slider.tell("cycle 2000");
        }
        let slid = slider.value("contact:1-floor:slid");
        let lost = slider.value("contact:1-floor:friction_loss")
            - slider.value("contact:1-floor:slip_loss");
        let exact = lost / (0.3 * slider.value("contact:1-floor:n"));
        assert!(exact > 1e-6 && exact < 6e-6, "{law}: {exact}");
        let over = slid - exact;
        // Sums of 6000 steps of rounding; at most three steps of which a part was elastic.
        assert!(
            (-1e-9 * exact..=3.0 * step).contains(&over),
            "{law}: {slid} {exact} {}",
            over / step
        );
        assert_eq!(slider.value("mean_slid"), slid);
        assert_eq!(slider.value("max_slid"), slid);
        let lines = slider.tell("print changes").join("\n");
        assert!(lines.contains("longest sliding way"), "{lines}");
        assert!(slider.tell("print contacts")[0].contains("slid"));
        // A reference counts anew: from then on it slides in every step.
        slider.tell("reference");
        assert_eq!(slider.value("contact:1-floor:slid"), 0.0);
        slider.tell("cycle 100");
        let since = slider.value("contact:1-floor:slid");
        assert!(
            (since - 100.0 * step).abs() < 1e-12 * since,
            "{law}: {since}"
        );
    }
}

/// Where no column asks for it nothing is booked, and nothing is made up.
#[test]
fn unbooked_ways_are_undefined() {
    let text = scene("linear");
    let (bare, _) = text.split_once("[history]").unwrap();
    let text = format!("{bare}[history]\ncolumns = [\"contacts\"]");
    let scene = Scene::parse("slider", &text, &[]).unwrap();
    let mut session = Session::open(scene, Options::default()).unwrap();
    let world = session.world_mut();
    assert!(world.ledger().is_none());
    let changes = Changes::of(world, &[true], &Reference::of(world));
    assert!(changes.slid.is_nan() && changes.slid_max.is_nan());
    assert_eq!(changes.kept, 1.0);
}
