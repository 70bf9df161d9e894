//! Bonds as presets and commands make them, and what is refused with a reason.

use ballast::scene::Scene;
use ballast::session::{Budget, Options, Session};

/// Two discs that touch, the second pulled by a force, as a preset.
const PULLED: &str = r#"
[model]
body = "disc"
law = "bonded"
[material.a]
density = 1000.0
normal_stiffness = 1e6
shear_stiffness = 1e6
bond_tension = 100.0
bond_shear = 50.0
[material.b]
density = 1000.0
normal_stiffness = 1e6
shear_stiffness = 1e6
bond_tension = 80.0
bond_shear = 60.0
[[pair]]
materials = ["b", "b"]
bond_tension = 30.0
[[particle]]
at = [0.0, 0.0]
radius = 1.0
material = "a"
driven = true
[[particle]]
at = [2.0, 0.0]
radius = 1.0
material = "b"
[damping]
global = 200.0
[history]
columns = ["bonds", "bonds_broken", "contacts", "bond_loss", "contact:1-2:n", "contact:1-2:bonded"]
[[stage]]
name = "pull"
do = ["bond", "particle 2 force 60 0"]
max_cycles = 20000
"#;

#[test]
fn presets_and_commands_bond() {
    let scene = Scene::parse("pulled", PULLED, &[]).expect("it is accepted");
    let mut session = Session::open(scene, Options::default()).expect("it opens");
    session
        .advance(Budget::default(), false)
        .expect("it runs to its end");
    let value = |session: &Session, column: &str| {
        let recording = session.recording();
        let place = recording.names().iter().position(|name| name == column);
        let last = recording.rows().len() - 1;
        recording.value(last, place.expect("it is recorded"))
    };
    assert_eq!(value(&session, "bonds"), 1.0);
    assert_eq!(value(&session, "contacts"), 1.0);
    assert_eq!(value(&session, "contact:1-2:bonded"), 1.0);
    assert!((value(&session, "contact:1-2:n") + 60.0).abs() < 1e-3);
    // The smaller of the two, and what a pair overrides.
    let table = session.world().pair_table();
    let strengths = |a, b| {
        let pair = table.get(a, b, false);
        (pair.bond_tension, pair.bond_shear)
    };
    assert_eq!(strengths(0, 1), (80.0, 50.0));
    assert_eq!(strengths(1, 1), (30.0, 60.0));
    let mut say = |line: &str| match session.type_line(line) {
        Ok(reply) => reply.lines.join("\n"),
        Err(refusal) => format!("{}; {}", refusal.message, refusal.remedy),
    };
    assert!(say("print contacts").contains("bonded"));
    assert!(say("inspect contact 1-2").contains("bonded, until pulled with more than 80 N"));
    assert!(say("property a bond_tension 2e7").contains("may be the smallest radius"));
    assert!(say("bond").contains("0 bonds made, 1 hold"));
    // The load has been there all the time.
    say("property a bond_tension 50");
    assert_eq!(
        (session.world().bonds(), session.world().bonds_broken()),
        (0, 1)
    );
}

/// Places are those of regions: who has strayed from a cell counts where it would be in it.
#[test]
fn in_a_cell_places_are_those_of_the_cell() {
    let body = PULLED.split_once("[[particle]]").expect("it has some").0;
    let disc = |x| format!("[[particle]]\nat = [{x}, 1]\nradius = 1\nmaterial = \"a\"\n");
    // The second has strayed by one edge: at home it touches the first.
    let preset = format!("{body}{}{}[cell]\nsize = [10, 10]\n", disc(4), disc(12));
    for (place, made) in [("3 0 13 2", "0 bonds made"), ("1 0 5 2", "1 bonds made")] {
        let scene = Scene::parse("cell", &preset, &[]).expect("it is accepted");
        let mut session = Session::open(scene, Options::default()).expect("it opens");
        let reply = session.type_line(&format!("bond in rectangle {place}"));
        let said = reply.expect("it is accepted").lines.join("");
        assert!(said.starts_with(made), "{place}: {said}");
    }
}

#[test]
fn presets_that_cannot_bond_are_refused_with_the_reason() {
    let refused = |from: &str, to: &str, reason: &str| {
        assert!(PULLED.contains(from), "{from}");
        let text = PULLED.replace(from, to);
        let said = Scene::parse("pulled", &text, &[]).map(|_| "accepted".to_owned());
        let said = said.unwrap_or_else(|rejection| rejection.to_string());
        assert!(said.contains(reason), "{reason} in {said}");
    };
    let linear = "law = \"linear\"";
    refused(
        "law = \"bonded\"",
        linear,
        "[material.a] has bond_tension, which the law linear",
    );
    refused(
        "law = \"bonded\"",
        linear,
        "[material.b] has bond_shear, which the law linear",
    );
    refused(
        "law = \"bonded\"",
        linear,
        "a [[pair]] has bond_tension, which the law linear",
    );
    refused(
        "law = \"bonded\"",
        linear,
        "stage `pull` makes bonds, which the law linear",
    );
    let summed = "law = \"bonded\"\nnormal = \"incremental\"";
    refused("law = \"bonded\"", summed, "contradicts the law with bonds");
    refused("= 30.0", "= 3e6", "would stretch by 3 m before it breaks");
    refused("\nshear_stiffness = 1e6", "", "bonds needs");
}
