//! Every command reads back from its own line, and noise is refused in its place.

use ballast::engine::setup::Gravity;
use ballast::language::command::{
    Bond, ContactFile, Create, Damper, DumpOf, Export, FrictionOf, Generate, Goal, Grow,
    HistoryChange, Layers, Measure, ParticleChange, ParticleRange, PictureOf, Place, Printout,
    Property, Solve, WallChange, Where,
};
use ballast::language::{COMMANDS, Command, Expression, Known, Observable};
use ballast::measure::columns::{CONTACT, Column, PARTICLE, Partner, Read, Row, WALL, assembly};
use proptest::prelude::*;

fn finite() -> impl Strategy<Value = f64> {
    any::<f64>().prop_filter("finite", |v| v.is_finite())
}

fn positive() -> impl Strategy<Value = f64> {
    finite().prop_filter("positive", |v| *v > 0.0)
}

fn vector() -> impl Strategy<Value = [f64; 2]> {
    [finite(), finite()]
}

fn count() -> impl Strategy<Value = u64> {
    1..=1_u64 << 53
}

fn wall() -> impl Strategy<Value = String> {
    "[a-zA-Zéß][a-zA-Z0-9_ü]{0,6}"
}

/// Anything printable: what looks odd has to be quoted.
fn text() -> impl Strategy<Value = String> {
    "\\PC{1,8}"
}

fn range() -> impl Strategy<Value = ParticleRange> {
    (1..=u32::MAX, 1..=u32::MAX).prop_map(|(a, b)| ParticleRange {
        first: a.min(b),
        last: a.max(b),
    })
}

fn column() -> impl Strategy<Value = Column> {
    prop_oneof![
        prop::sample::select(Column::usual()),
        (wall(), one_of(WALL)).prop_map(|(name, row)| Column::Wall(name, row)),
        (1..9_u32, wall(), one_of(CONTACT)).prop_map(|(i, w, row)| Column::Contact(
            i,
            Partner::Wall(w),
            row
        )),
        (1..9_u32, 9..99_u32, one_of(CONTACT)).prop_map(|(i, j, row)| Column::Contact(
            i,
            Partner::Particle(j),
            row
        )),
        (1..=u32::MAX, one_of(PARTICLE)).prop_map(|(i, row)| Column::Particle(i, row)),
        (wall(), prop::sample::select(regional()))
            .prop_map(|(name, row)| Column::Region(name, row)),
    ]
}

fn one_of<R: std::fmt::Debug>(rows: &'static [Row<R>]) -> impl Strategy<Value = &'static Row<R>> {
    prop::sample::select(rows.iter().collect::<Vec<_>>())
}

/// The columns that a region can have.
fn regional() -> Vec<&'static Row<Read>> {
    assembly().filter(|row| row.is_regional()).collect()
}

fn condition() -> impl Strategy<Value = Expression> {
    (column(), finite(), count()).prop_map(|(column, value, cycle)| {
        let text = format!(
            "{} > {value:e} or (cycle >= {cycle} and max(1, time) < 3 or 1 == 1) and 2 < 3",
            column.name()
        );
        Expression::parse_condition(&text).expect("it is written by the rules")
    })
}

fn about_bodies() -> impl Strategy<Value = Command> {
    let create = (
        vector(),
        positive(),
        prop::option::of(text()),
        vector(),
        finite(),
    );
    let between = (vector(), vector(), prop::option::of(text()))
        .prop_filter("a length", |(from, to, _)| from != to);
    let wall_change = prop_oneof![
        vector().prop_map(WallChange::Velocity),
        finite().prop_map(WallChange::Spin),
        between.prop_map(|(from, to, material)| WallChange::Create { from, to, material }),
        Just(WallChange::Delete),
    ];
    let particle_change = prop_oneof![
        vector().prop_map(ParticleChange::Velocity),
        finite().prop_map(ParticleChange::Spin),
        vector().prop_map(ParticleChange::Force),
        any::<[bool; 3]>()
            .prop_filter("something", |fixed| fixed.contains(&true))
            .prop_map(ParticleChange::Fix),
        (1e-9..1e9f64).prop_map(ParticleChange::Radius),
        Just(ParticleChange::Free),
    ];
    prop_oneof![
        create.prop_map(
            |(at, radius, material, velocity, spin)| Command::Create(Create {
                at,
                radius,
                material,
                velocity,
                spin,
            })
        ),
        generate().prop_map(Command::Generate),
        range().prop_map(Command::Delete),
        (wall(), wall_change).prop_map(|(name, change)| Command::Wall(name, change)),
        (1..=u32::MAX, particle_change).prop_map(|(id, change)| Command::Particle(id, change)),
    ]
}

fn place() -> impl Strategy<Value = Place> {
    let circle =
        (vector(), positive()).prop_map(|(centre, radius)| Place::Circle { centre, radius });
    let corners = (vector(), positive(), positive());
    let rectangle = corners
        .prop_map(|(min, width, height)| Place::Rectangle {
            min,
            max: [min[0] + width, min[1] + height],
        })
        .prop_filter("an area", |place| match place {
            Place::Rectangle { min, max } => (0..2).all(|k| min[k] < max[k] && max[k].is_finite()),
            Place::Circle { .. } => true,
        });
    prop_oneof![circle, rectangle]
}

fn somewhere() -> impl Strategy<Value = Where> {
    prop_oneof![
        Just(Where::Default),
        wall().prop_map(Where::Region),
        place().prop_map(Where::Here),
    ]
}

fn generate() -> impl Strategy<Value = Generate> {
    let count = prop::option::of(1..=10_000_000u64);
    (place(), positive(), count, prop::option::of(text())).prop_map(
        |(place, radius, count, material)| Generate {
            place,
            radius,
            count,
            material,
        },
    )
}

fn about_physics() -> impl Strategy<Value = Command> {
    let property = prop::sample::select(vec![
        Property::Density,
        Property::Friction,
        Property::Cohesion,
        Property::BondTension,
        Property::BondShear,
        Property::NormalStiffness,
        Property::ShearStiffness,
        Property::Young,
    ]);
    let of = prop_oneof![
        Just(FrictionOf::Everything),
        text().prop_map(FrictionOf::Material),
        wall().prop_map(FrictionOf::Wall),
        (text(), text()).prop_map(|(a, b)| FrictionOf::Pair(a, b)),
    ];
    let damper = prop::sample::select(vec![
        Damper::Contact,
        Damper::Wall,
        Damper::Tangential,
        Damper::Beta,
        Damper::Global,
    ]);
    let gravity = prop_oneof![
        vector().prop_map(Gravity::Uniform),
        (vector(), finite()).prop_map(|(towards, g)| Gravity::Centripetal { towards, g }),
    ];
    prop_oneof![
        (text(), property, positive()).prop_map(|(m, key, v)| Command::Property(m, key, v)),
        (text(), -0.99..0.5).prop_map(|(m, v)| Command::Property(m, Property::Poisson, v)),
        (positive(), of).prop_map(|(v, of)| Command::Friction(v, of)),
        (prop::option::of(positive()), prop::option::of(place()))
            .prop_map(|(gap, place)| Command::Bond(Bond { gap, place })),
        positive().prop_map(Command::Frac),
        (damper, positive()).prop_map(|(kind, v)| Command::Damp(kind, v)),
        (0.0..=1.0).prop_map(|v| Command::Damp(Damper::Local, v)),
        (0.0..=1.0).prop_map(Command::Con1),
        prop::option::of((positive(), count()))
            .prop_map(|grow| { Command::Grow(grow.map(|(factor, over)| Grow { factor, over })) }),
        prop::option::of(gravity).prop_map(Command::Gravity),
        any::<bool>().prop_map(Command::Rotation),
        Just(Command::Zero),
        Just(Command::Reference),
    ]
}

fn about_running() -> impl Strategy<Value = Command> {
    let goal = prop_oneof![
        positive().prop_map(Goal::Ratio),
        condition().prop_map(Goal::Until),
    ];
    let solve = (prop::option::of(goal), prop::option::of(count()));
    prop_oneof![
        count().prop_map(Command::Cycle),
        count().prop_map(Command::Step),
        solve.prop_map(|(goal, max)| Command::Solve(Solve { goal, max })),
        Just(Command::Go),
        Just(Command::Pause),
    ]
}

fn about_records() -> impl Strategy<Value = Command> {
    let columns = prop::collection::vec(column(), 1..5).prop_filter("each once", |columns| {
        (1..columns.len()).all(|k| !columns[..k].contains(&columns[k]))
    });
    let history = prop_oneof![
        Just(HistoryChange::Show),
        count().prop_map(HistoryChange::Every),
        columns.prop_map(|columns| {
            HistoryChange::Columns(columns.into_iter().map(Observable::Column).collect())
        }),
    ];
    let printout = prop_oneof![
        prop::option::of(range()).prop_map(Printout::Balls),
        prop::option::of(range()).prop_map(Printout::Contacts),
        prop::sample::select(vec![
            Printout::Walls,
            Printout::Types,
            Printout::Boundary,
            Printout::Energy,
            Printout::Step,
            Printout::Averages,
            Printout::All,
        ]),
        (
            prop::sample::select(Measure::all().collect::<Vec<_>>()),
            somewhere()
        )
            .prop_map(|(measure, place)| Printout::Measure(measure, place)),
        (somewhere(), prop::option::of(1..10_000_u64))
            .prop_map(|(place, rings)| Printout::Profile(place, rings)),
        (1..=u32::MAX).prop_map(Printout::Polygon),
    ];
    let verbs: Vec<&'static str> = COMMANDS.iter().map(|card| card.name).collect();
    prop_oneof![
        printout.prop_map(Command::Print),
        (1..9_u32, wall()).prop_map(|(i, w)| Command::InspectContact(i, Partner::Wall(w))),
        (1..9_u32, 9..99_u32).prop_map(|(i, j)| Command::InspectContact(i, Partner::Particle(j))),
        history.prop_map(Command::History),
        text().prop_map(Command::Save),
        text().prop_map(Command::Restore),
        (export(), text()).prop_map(|(what, file)| Command::Export(what, file)),
        Just(Command::InspectOff),
        text().prop_map(Command::Journal),
        text().prop_map(Command::Source),
        prop::option::of(prop::sample::select(verbs)).prop_map(Command::Help),
        any::<bool>().prop_map(|anyway| Command::Quit { anyway }),
    ]
}

fn export() -> impl Strategy<Value = Export> {
    let profile = (somewhere(), prop::option::of(1..10_000_u64));
    let of_contact = [
        ContactFile::Path,
        ContactFile::Traction,
        ContactFile::Picture,
    ];
    prop_oneof![
        Just(Export::History),
        Just(Export::All(DumpOf::Particles)),
        Just(Export::All(DumpOf::Contacts)),
        profile.prop_map(|(place, rings)| Export::Profile(place, rings)),
        prop::sample::select(of_contact.to_vec()).prop_map(Export::Contact),
        Just(Export::Vtk(DumpOf::Particles)),
        Just(Export::Vtk(DumpOf::Contacts)),
        prop::sample::select(PictureOf::ALL.to_vec()).prop_map(Export::Picture),
        (any::<bool>(), any::<bool>()).prop_map(|(numbers, velocities)| {
            let layers = Layers {
                numbers,
                velocities,
            };
            Export::Picture(PictureOf::Assembly(layers))
        }),
        (1..=u32::MAX).prop_map(|id| Export::Picture(PictureOf::Polygon(id))),
        any::<bool>().prop_map(Export::Lammps),
    ]
}

fn command() -> impl Strategy<Value = Command> {
    prop_oneof![
        about_bodies(),
        about_physics(),
        about_running(),
        about_records()
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn every_command_reads_back_from_its_line(command in command()) {
        let line = command.to_string();
        let back = Command::parse(&line);
        prop_assert_eq!(back.as_ref(), Ok(&command), "{}", line);
        // A comment and loud typing of the verb change nothing.
        let (verb, rest) = line.split_at(line.find(' ').unwrap_or(line.len()));
        let loud = format!("  {}{rest}  # as it was", verb.to_uppercase());
        prop_assert_eq!(Command::parse(&loud), Ok(command), "{}", loud);
    }

    #[test]
    fn every_beginning_of_a_line_is_read_or_refused_in_its_place(command in command()) {
        let line = command.to_string();
        for (end, _) in line.char_indices() {
            let half = &line[..end];
            if let Err(mistake) = Command::parse(half) {
                prop_assert!(half.get(mistake.span).is_some(), "{}", half);
            }
            let completion = ballast::language::complete::complete(half, &Known::default());
            prop_assert!(half.is_char_boundary(completion.start));
        }
    }

    #[test]
    fn any_text_is_read_or_refused_in_its_place(text in any::<String>()) {
        if let Err(mistake) = Command::parse(&text) {
            prop_assert!(text.get(mistake.span).is_some());
        }
    }

    #[test]
    fn scrambled_words_are_read_or_refused_in_their_place(
        text in "(create|at|wall|until|history|columns|pair|from|to|[\"#\\\\]|[-0-9.e,:()é]| ){0,20}"
    ) {
        if let Err(mistake) = Command::parse(&text) {
            prop_assert!(text.get(mistake.span).is_some());
        }
    }
}
