use super::tree::{Arithmetic, Comparison, Condition, Function, Number};
use super::*;
use proptest::prelude::*;

fn some_term() -> impl Strategy<Value = Term> {
    let column = prop::sample::select(vec![
        "kinetic",
        "wall:Left:f1",
        "contact:1-2:n",
        "contact:3-floor_2:t",
        "particle:7:vx",
        "particle:2-7:speed",
    ]);
    prop_oneof![
        Just(Term::Cycle),
        Just(Term::Time),
        Just(Term::StageCycle),
        column.prop_map(|name| Term::Column(Column::parse(name).unwrap())),
    ]
}

fn some_number() -> impl Strategy<Value = Number<Term>> {
    let constant = any::<f64>().prop_filter("finite", |v| v.is_finite());
    let leaf = prop_oneof![
        constant.prop_map(|v| Number::Constant(v.abs())),
        some_term().prop_map(Number::Leaf),
    ];
    let how = prop::sample::select(vec![
        Arithmetic::Plus,
        Arithmetic::Minus,
        Arithmetic::Times,
        Arithmetic::Over,
        Arithmetic::Smaller,
        Arithmetic::Larger,
    ]);
    let function = prop::sample::select(Function::ALL.map(|(_, function)| function).to_vec());
    leaf.prop_recursive(5, 32, 2, move |inner| {
        prop_oneof![
            inner.clone().prop_map(|n| Number::Negative(Box::new(n))),
            (function.clone(), inner.clone())
                .prop_map(|(function, n)| Number::Applied(function, Box::new(n))),
            (how.clone(), inner.clone(), inner).prop_map(|(how, a, b)| Number::Joined(
                how,
                Box::new(a),
                Box::new(b)
            )),
        ]
    })
}

fn some_condition() -> impl Strategy<Value = Condition<Term>> {
    let how = prop::sample::select(vec![
        Comparison::AtLeast,
        Comparison::More,
        Comparison::AtMost,
        Comparison::Less,
        Comparison::Equal,
    ]);
    let leaf =
        (how, some_number(), some_number()).prop_map(|(how, a, b)| Condition::Compared(how, a, b));
    leaf.prop_recursive(4, 8, 2, |inner| {
        (any::<bool>(), inner.clone(), inner).prop_map(|(both, a, b)| {
            let (a, b) = (Box::new(a), Box::new(b));
            if both {
                Condition::Both(a, b)
            } else {
                Condition::Either(a, b)
            }
        })
    })
}

fn some_expression() -> impl Strategy<Value = Expression> {
    let places = Places::new();
    prop_oneof![
        some_number().prop_map(Meaning::Number),
        some_condition().prop_map(Meaning::Condition),
    ]
    .prop_map(move |meaning| Expression {
        meaning,
        places: places.clone(),
    })
}

proptest! {
    #[test]
    fn what_is_written_reads_back(expression in some_expression()) {
        let text = expression.to_string();
        let back = Expression::parse(&text);
        prop_assert_eq!(back.map_err(|m| m.to_string()), Ok(expression));
    }

    #[test]
    fn quantities_read_back(a in some_number(), b in some_number(), when in some_condition()) {
        let text = format!("max({a}) - (last({b}) + at({when}, {a})) * min(mean({b}), 1)");
        let quantity = Quantity::parse(&text);
        prop_assert!(quantity.is_ok(), "{text}");
        let quantity = quantity.unwrap();
        prop_assert_eq!(Quantity::parse(&quantity.to_string()), Ok(quantity));
    }

    #[test]
    fn noise_is_refused_with_a_place_inside_it(text in "\\PC{0,40}") {
        for mistake in [Expression::parse(&text).err(), Quantity::parse(&text).err()] {
            prop_assert!(mistake.is_none_or(|m| text.get(m.span).is_some()));
        }
    }

    #[test]
    fn scrambled_expressions_never_panic(
        text in "(kinetic|cycle|max|at|last|contact:1-|wall:|[-+*/()<>=,.0-9_e: ]|and |or ){0,30}"
    ) {
        for mistake in [Expression::parse(&text).err(), Quantity::parse(&text).err()] {
            prop_assert!(mistake.is_none_or(|m| text.get(m.span).is_some()));
        }
    }
}
