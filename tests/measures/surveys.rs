//! What panes are given is what columns and tables say.

use ballast::measure::columns::Column;
use ballast::measure::sample::Sample;
use ballast::measure::survey::{Displaced, Part, Parts, Survey};
use ballast::scene::Scene;
use ballast::session::frames::{Shown, Wants};
use ballast::session::{Budget, Options, Session};

#[test]
fn a_survey_agrees_with_the_columns() {
    let scene = Scene::load("disc-pile", &[]).unwrap();
    let mut session = Session::open(scene, Options::default()).unwrap();
    let until = |cycle| Budget {
        until_cycle: Some(cycle),
        time: None,
    };
    session.advance(until(7000), false).unwrap();
    session.type_line("reference").unwrap();
    session.advance(until(8300), false).unwrap();
    let frame =
        |session: &mut Session, wants| session.frame(wants, 0.0, false, &mut Shown::default());
    let bare = frame(&mut session, Wants::default());
    assert!(bare.survey == Survey::default() && bare.polygon.is_none());
    let wants = Wants {
        survey: Parts::ALL,
        polygon: Some(17),
        ..Wants::default()
    };
    let full = frame(&mut session, wants);
    let (survey, polygon) = (full.survey, full.polygon.unwrap());
    assert_eq!(polygon.particle, 17);
    let none = Wants {
        polygon: Some(9999),
        ..wants
    };
    assert!(frame(&mut session, none).polygon.is_none());
    let one = Wants {
        survey: Parts::default().with(Part::Profile),
        ..Wants::default()
    };
    let only = Survey {
        profile: survey.profile.clone(),
        ..Survey::default()
    };
    assert_eq!(frame(&mut session, one).survey, only);
    let contacts = full.assembly.contacts;
    // Each contact is in each picture of the contacts once.
    let (rose, fabric) = survey.directions.unwrap();
    assert_eq!(rose.contacts.iter().sum::<f64>(), contacts);
    let contact_stress = survey.contact_stress.unwrap();
    assert_eq!(contact_stress.count(), contacts);
    assert_eq!(survey.normal_force.unwrap().count(), contacts);
    let against = survey.against.unwrap();
    let changes = against.changes;
    assert_eq!(changes.kept + changes.made, contacts);
    assert!(against.lattice.len() as f64 <= contacts + changes.broken);
    let tensors = survey.tensors.unwrap();
    assert!(tensors.strain.unwrap().particles == 105);
    assert_eq!(against.displaced.len(), 105);
    assert_eq!(against.since, 7000);
    // Nothing turns in this pile, but it collapses.
    let moved = |of: &Displaced| of.u[0].abs() + of.u[1].abs();
    assert!(against.displaced.iter().map(moved).fold(0.0, f64::max) > 0.01);
    assert!(against.displaced.iter().all(|of| of.rotation == 0.0) && changes.rotation_max == 0.0);
    assert!(changes.broken > 10.0, "{changes:?}");
    let sample = Sample::of(session.world_mut());
    let value = |name: &str| sample.value(&Column::parse(name).unwrap());
    for (name, found) in [
        ("stress_22", tensors.stress.total[(1, 1)]),
        ("stress_shear_12", tensors.stress.shear[(0, 1)]),
        ("anisotropy", fabric.anisotropy()),
        ("mean_obliquity", survey.obliquity.unwrap().mean()),
        ("mean_contact_stress", contact_stress.mean),
    ] {
        // The mean of a histogram and that of the column are summed alike.
        assert!(
            (value(name) - found).abs() <= 1e-15 * found.abs(),
            "{name}: {found}"
        );
    }
}
