//! `[damping]`: what takes energy out besides friction.

use super::draft::Draft;
use super::key::{Absent, Bounds, Form, Key};
use super::reader::Reader;
use super::section::{Section, Shape};
use crate::engine::setup::{Damping, Dashpot};

/// The declaration.
pub(crate) const SECTION: Section = Section {
    name: "damping",
    shape: Shape::Single,
    required: false,
    summary: "what takes energy out besides friction",
    keys: KEYS,
    read,
};

const KEYS: &[Key] = &[
    number(
        "contact",
        Absent::Number(0.0),
        "normal dashpot at each contact as a fraction of critical",
    ),
    Key {
        unit: "s",
        ..number(
            "beta",
            Absent::Said("not used"),
            "ratio c/k of the normal dashpot, instead of `contact` (1979)",
        )
    },
    Key {
        form: Form::Number(RESTITUTION),
        ..number(
            "restitution",
            Absent::Said("not used"),
            "coefficient of restitution of a normal impact, instead of `contact`",
        )
    },
    number(
        "wall",
        Absent::Said("as between particles"),
        "normal dashpot between particle and wall as a fraction of critical",
    ),
    number(
        "tangential",
        Absent::Said("the law's own: as `contact` for the linear law"),
        "tangential dashpot as a fraction of critical",
    ),
    Key {
        form: Form::Flag,
        ..number(
            "pull",
            Absent::Flag(false),
            "whether a normal dashpot may pull",
        )
    },
    Key {
        unit: "1/s",
        ..number(
            "global",
            Absent::Number(0.0),
            "mass-proportional damping of every particle",
        )
    },
    Key {
        form: Form::Number(Bounds::SHARE),
        ..number(
            "con1",
            Absent::Number(1.0),
            "factor on all velocities in each cycle",
        )
    },
    Key {
        form: Form::Number(Bounds::SHARE),
        ..number(
            "local",
            Absent::Number(0.0),
            "share of the out-of-balance force that opposes the velocity",
        )
    },
    Key {
        form: Form::Number(Bounds::POSITIVE),
        ..number(
            "overlap_critical",
            Absent::Said("never"),
            "overlap over the smaller diameter above which a contact is damped critically; 0.07 in 1989",
        )
    },
    Key {
        form: Form::Flag,
        ..number(
            "centred",
            Absent::Flag(false),
            "whether normal dashpots act on the velocity at the boundary, not half a step before",
        )
    },
];

/// An impact that stops dead needs an infinite dashpot.
pub(crate) const RESTITUTION: Bounds = Bounds::above(0.0, 1.0);

const fn number(name: &'static str, absent: Absent, summary: &'static str) -> Key {
    Key {
        name,
        form: Form::Number(Bounds::NOT_NEGATIVE),
        unit: "-",
        absent,
        summary,
    }
}

fn read<'a>(reader: &Reader<'a>, draft: &mut Draft<'a>) {
    let number = |name| reader.number(name).unwrap_or_default();
    // Each is read, so that each is checked, whichever counts.
    let (fraction, beta, restitution) = (
        reader.number("contact"),
        reader.number("beta"),
        reader.number("restitution"),
    );
    let contact = match reader.one_of(&["contact", "beta", "restitution"]) {
        Some("beta") => beta.map(Dashpot::Beta),
        Some("restitution") => restitution.map(Dashpot::Restitution),
        _ => fraction.map(fraction_of_critical),
    };
    draft.setup.damping = Damping {
        contact: contact.unwrap_or(Dashpot::None),
        wall: reader.number("wall").map(fraction_of_critical),
        tangential: reader.number("tangential"),
        pull: reader.flag("pull").unwrap_or_default(),
        global: number("global"),
        con1: number("con1"),
        local: number("local"),
        centred: reader.flag("centred").unwrap_or_default(),
        overlap_critical: reader.number("overlap_critical"),
    };
}

/// A dashpot of no strength is none: the scene then pays for none.
fn fraction_of_critical(fraction: f64) -> Dashpot {
    if fraction == 0.0 {
        Dashpot::None
    } else {
        Dashpot::Fraction(fraction)
    }
}
