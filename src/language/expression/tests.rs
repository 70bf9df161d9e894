use super::*;

fn values(term: &Term) -> f64 {
    match term {
        Term::Cycle => 100.0,
        Term::Time => 0.5,
        Term::StageCycle => 10.0,
        Term::Column(column) if column.name() == "energy_error" => f64::NAN,
        Term::Column(_) => 3.0,
    }
}

fn number(text: &str) -> f64 {
    Expression::parse(text).unwrap().number(&mut values)
}

fn holds(text: &str) -> bool {
    Expression::parse_condition(text)
        .unwrap()
        .holds(&mut values)
}

#[test]
fn arithmetic_follows_the_usual_order() {
    for (text, value) in [
        ("1 + 2 * 3", 7.0),
        ("(1 + 2) * 3", 9.0),
        ("10 - 4 - 3", 3.0),
        ("12 / 3 / 2", 2.0),
        ("-2 * -3", 6.0),
        ("2 - -1", 3.0),
        ("abs(-3) + MIN(4, 2) + max(1, time)", 6.0),
        ("sqrt(9) * exp(0) + ln(exp(2)) - SIN(0) * cos(3)", 5.0),
        ("4 * atan(1)", std::f64::consts::PI),
        ("1_000 * 1e-3", 1.0),
        ("contact:1-2:n - 1", 2.0),
        ("wall:left:f1-1", 2.0),
    ] {
        assert_eq!(number(text), value, "{text}");
    }
}

#[test]
fn and_binds_before_or() {
    // Read the other way round, (true or false) and false would be false.
    assert!(holds("cycle > 1 or cycle < 1 and cycle < 1"));
    assert!(!holds("(cycle > 1 or cycle < 1) and cycle < 1"));
    assert!(holds("kinetic == 3 AND Kinetic >= 3 and kinetic <= 3"));
}

#[test]
fn nothing_compares_with_nan() {
    for sign in [">=", ">", "<=", "<", "=="] {
        assert!(!holds(&format!("energy_error {sign} 0")));
        assert!(!holds(&format!("0 {sign} energy_error")));
    }
    assert!(number("min(energy_error, 1)").is_nan());
    assert!(number("max(1, energy_error)").is_nan());
}

#[test]
fn only_columns_need_a_sample() {
    let free = Expression::parse("cycle > 5 and time < 1 or stage_cycle == 3").unwrap();
    assert!(!free.needs_sample());
    let bound = Expression::parse("kinetic > 5 and wall:left:f1 > kinetic").unwrap();
    assert!(bound.needs_sample());
    let names: Vec<String> = bound.columns().iter().map(Column::name).collect();
    assert_eq!(names, ["kinetic", "wall:left:f1"]);
}

#[test]
fn mistakes_say_where_and_what() {
    for (text, at, message) in [
        (
            "sliding_fraction and 3",
            0..16,
            "`sliding_fraction` is a number where `and` needs a condition; \
             compare it with something, for instance `> 0`",
        ),
        (
            "1 < cycle < 5",
            0..9,
            "`1 < cycle` is a condition where a number is needed; \
             comparisons do not chain or add up: join them with `and` or `or`",
        ),
        (
            "cycle > kinetc",
            8..14,
            "`kinetc` is no column; did you mean `kinetic`?",
        ),
        (
            "cycles > 5",
            0..6,
            "`cycles` is no column; did you mean `cycle`?",
        ),
        (
            "cycle >",
            7..7,
            "the text ends where a value is expected; write a column, a number or a parenthesis",
        ),
        (
            "(cycle > 5",
            0..1,
            "this parenthesis is never closed; add `)`",
        ),
        (
            "cycle > 5)",
            9..10,
            "`)` closes nothing; remove it or open a parenthesis before",
        ),
        (
            "cycle 5",
            6..7,
            "`5` follows a complete expression; join expressions with an operator, `and` or `or`",
        ),
        (
            "max(kinetic) > 1",
            0..12,
            "`max` takes two values, not 1; separate values by commas",
        ),
        (
            "last(kinetic) > 1",
            0..13,
            "`last` looks at all rows, and here there is only one; \
             it belongs to the `what` of an [[expect]]",
        ),
        (
            "tan(2) > 1",
            0..3,
            "`tan` is no function; did you mean `atan`?",
        ),
        (
            "bessel(2) > 1",
            0..6,
            "`bessel` is no function; there is abs, sqrt, exp, ln, sin, cos, atan, min, max",
        ),
        (
            "sqrt(2, 3) > 1",
            0..10,
            "`sqrt` takes one value, not 2; separate values by commas",
        ),
        (
            "abs > 1",
            0..3,
            "`abs` is a function; write what it applies to: abs(...)",
        ),
        (
            "kinetic + 1",
            0..11,
            "`kinetic + 1` is a number where a condition is needed; \
             compare it with something, for instance `> 0`",
        ),
    ] {
        let mistake = Expression::parse_condition(text).unwrap_err();
        assert_eq!(mistake.to_string(), message);
        assert_eq!(mistake.span, at, "{text}");
    }
}

#[test]
fn walls_and_particles_have_to_exist() {
    let names = Names {
        walls: vec!["left".into()],
        particles: vec![1, 2],
        regions: vec![],
        materials: vec![],
        open: false,
    };
    let expression = Expression::parse("contact:1-2:n > 0 and wall:lfet:f1 > 0").unwrap();
    let mistake = expression.check(&names).unwrap_err();
    assert_eq!(
        mistake.to_string(),
        "there is no wall `lfet`; did you mean `left`?"
    );
    assert_eq!(mistake.span, 22..34);
    let quantity = Quantity::parse("last(particle:3:x)").unwrap();
    assert_eq!(quantity.check(&names).unwrap_err().span, 5..17);
}

#[test]
fn depth_and_length_are_bounded() {
    for text in [
        "(".repeat(100_000),
        "-".repeat(100_000),
        "abs(".repeat(100_000),
        "1+".repeat(100_000),
        "1 or ".repeat(100_000),
    ] {
        assert!(Expression::parse(&text).is_err());
    }
    let nested = format!("{}1{}", "(".repeat(60), ")".repeat(60));
    assert_eq!(number(&nested), 1.0);
    assert_eq!(number(&format!("1{}", "+1".repeat(400))), 401.0);
}

fn cell(row: usize, term: &Term) -> f64 {
    match term {
        Term::Cycle => 10.0 * row as f64,
        // Rows: nan, 1, 4, 9.
        _ if row == 0 => f64::NAN,
        _ => (row * row) as f64,
    }
}

fn measured(text: &str) -> Result<f64, String> {
    Quantity::parse(text).unwrap().value(4, &mut cell)
}

#[test]
fn quantities_run_over_rows() {
    for (text, value) in [
        ("last(kinetic)", 9.0),
        ("max(kinetic)", 9.0),
        ("min(kinetic)", 1.0),
        ("mean(cycle)", 15.0),
        ("at(kinetic > 3, cycle)", 20.0),
        ("max(kinetic) / last(cycle) - 1", -0.7),
        ("max(last(kinetic), min(cycle))", 9.0),
        ("max(min(kinetic, 2))", 2.0),
        ("abs(-last(cycle))", 30.0),
    ] {
        assert_eq!(measured(text), Ok(value), "{text}");
    }
    // The row without a value is left out: (1 + 4 + 9) / 3.
    assert_eq!(measured("mean(kinetic)"), Ok(14.0 / 3.0));
    assert_eq!(
        measured("at(kinetic > 10, cycle) + 1"),
        Err("`kinetic > 10` holds in no recorded row".into())
    );
    assert_eq!(
        Quantity::parse("last(kinetic)")
            .unwrap()
            .value(0, &mut cell),
        Err("last(kinetic) has no value: no rows were recorded".into())
    );
}

#[test]
fn wrong_quantities_are_explained() {
    for (text, message) in [
        (
            "kinetic",
            "`kinetic` has a value in every row; \
             say which is meant: last(kinetic), max(...), min(...) or mean(...)",
        ),
        (
            "max(kinetic, 2)",
            "`kinetic` has a value in every row; \
             say which is meant: last(kinetic), max(...), min(...) or mean(...)",
        ),
        ("kinetc", "`kinetc` is no column; did you mean `kinetic`?"),
        (
            "max(last(kinetic))",
            "`last` cannot stand inside `max`; both run over all rows: compute with their results",
        ),
        (
            "last(kinetic) > 3",
            "`last(kinetic) > 3` is a condition, and an expectation measures a number; \
             give the number here, and the bounds as `value` and `within`",
        ),
        (
            "at(kinetic, cycle)",
            "`kinetic` is a number where `at` needs a condition; \
             compare it with something, for instance `> 0`",
        ),
        (
            "at(kinetic > 1)",
            "`at` takes a condition and a value, not 1; separate values by commas",
        ),
        (
            "average(kinetic)",
            "`average` is no function; there is last, max, min, mean, at, abs, sqrt, exp, ln, sin, cos, \
             atan",
        ),
        (
            "1 + 2",
            "`1 + 2` measures nothing; measure a column, for instance last(kinetic)",
        ),
    ] {
        assert_eq!(Quantity::parse(text).unwrap_err().to_string(), message);
    }
}

#[test]
fn cycles_can_be_counted_in_another_step() {
    let written = Expression::parse("stage_cycle >= 40 and kinetic < 1 or -cycle > time").unwrap();
    let counted = written.counting(5.0, 2.0);
    assert_eq!(
        counted.to_string(),
        "stage_cycle * 2 / 5 >= 40 and kinetic < 1 or -(cycle * 2 / 5) > time"
    );
    let read_back = Expression::parse(&counted.to_string()).unwrap();
    assert_eq!(read_back, counted);
    let holds = |cycles: f64| {
        read_back.holds(&mut |term| match term {
            Term::StageCycle => cycles,
            _ => 0.0,
        })
    };
    assert!(!holds(99.0) && holds(100.0));
}
