//! Every width against one lane, to the bit.

use proptest::prelude::*;

use super::{InLanes, Isa, Lanes};
use crate::engine::particles::Row;

/// Everything the trait can do, on the numbers of two columns.
#[inline(always)]
fn everything<V: Lanes>(a: &[f64; 8], b: &[f64; 8]) -> Vec<u64> {
    let mut out = Vec::new();
    for from in (0..8).step_by(V::COUNT) {
        // SAFETY: `from` + COUNT is at most 8.
        let (x, y) = unsafe { (V::read(a.as_ptr().add(from)), V::read(b.as_ptr().add(from))) };
        let results = [
            x + y,
            x - y,
            x * y,
            x / y,
            -x,
            x.abs(),
            x.sqrt(),
            x.copysign(y),
            x.positive(),
            x.larger(y),
            x.smaller(y),
            V::pick(x.above(y), x, y),
            V::pick(!x.above(y) & !x.equals(y), x, V::all(2.0)),
            V::pick(x.equals(y) | y.above(x), V::all(-1.0), y),
        ];
        for result in results {
            let mut lanes = [0.0; 8];
            // SAFETY: COUNT is at most 8.
            unsafe { result.write(lanes.as_mut_ptr()) };
            out.extend(lanes[..V::COUNT].iter().map(|x| x.to_bits()));
        }
        out.push(u64::from(V::bits(x.above(y))));
    }
    out
}

/// Lane by lane, whatever the width: the bits of a column are those of its numbers.
fn by_number(out: &[u64], count: usize) -> Vec<Vec<u64>> {
    let block = 14 * count + 1;
    let mut numbers = vec![Vec::new(); 8];
    for (k, part) in out.chunks(block).enumerate() {
        for lane in 0..count {
            let number = &mut numbers[k * count + lane];
            number.extend((0..14).map(|result| part[result * count + lane]));
            number.push(part[block - 1] >> lane & 1);
        }
    }
    numbers
}

/// What pairs see of each other, and rows written back.
#[inline(always)]
fn meetings<V: Lanes>(rows: &[Row; 9], pairs: &[[u32; 2]; 8]) -> Vec<[u64; 4]> {
    let mut out = [[0.0; 4]; 16];
    for from in (0..8).step_by(V::COUNT) {
        // SAFETY: eight pairs of nine rows; `from` + COUNT is at most 8.
        unsafe {
            let m = V::meet(rows.as_ptr(), pairs.as_ptr().add(from));
            V::write_rows([m.d[0], m.d[1], m.v[0], m.v[1]], out.as_mut_ptr().add(from));
            V::write_rows(
                [m.spin, m.rim, m.reach, m.rim],
                out.as_mut_ptr().add(8 + from),
            );
        }
    }
    out.iter().map(|row| row.map(f64::to_bits)).collect()
}

/// Whole numbers that masks choose, one after another.
#[inline(always)]
fn packed<V: Lanes>(b: &[f64; 8]) -> Vec<u32> {
    let mut out = Vec::new();
    for from in (0..8).step_by(V::COUNT) {
        let whole: [f64; 8] = std::array::from_fn(|k| 1e9 + k as f64);
        let mut to = [0; 8];
        // SAFETY: `from` + COUNT is at most 8.
        let [b, whole] = [b, &whole].map(|x| unsafe { V::read(x.as_ptr().add(from)) });
        let count = whole.pack(b.above(V::all(0.0)), &mut to);
        out.extend(&to[..count]);
    }
    out
}

type Results = (Vec<Vec<u64>>, Vec<[u64; 4]>, Vec<u32>);

#[inline(always)]
fn results<V: Lanes>(
    a: &[f64; 8],
    b: &[f64; 8],
    rows: &[Row; 9],
    pairs: &[[u32; 2]; 8],
) -> Results {
    (
        by_number(&everything::<V>(a, b), V::COUNT),
        meetings::<V>(rows, pairs),
        packed::<V>(b),
    )
}

/// Results in the lanes of some instructions.
struct Asked<'a> {
    a: &'a [f64; 8],
    b: &'a [f64; 8],
    rows: &'a [Row; 9],
    pairs: &'a [[u32; 2]; 8],
    answer: &'a mut Option<(usize, Results)>,
}

impl InLanes for Asked<'_> {
    #[inline(always)]
    fn run<V: Lanes>(self) {
        let results = results::<V>(self.a, self.b, self.rows, self.pairs);
        *self.answer = Some((V::COUNT, results));
    }
}

fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        -3.0..3.0f64,
        1e-12..1e-6f64,
        Just(0.0),
        Just(-0.0),
        Just(1.0),
        Just(f64::INFINITY),
        Just(f64::NAN),
    ]
}

proptest! {
    /// What the contact loop relies on: whoever is not nearer than the sum of radii by squares is not by
    /// roots either.
    #[test]
    fn the_root_of_a_rounded_square_is_the_number_itself(x in 1e-9..1e9f64, ulps in 0..4u64) {
        prop_assert_eq!((x * x).sqrt(), x);
        let further = f64::from_bits((x * x).to_bits() + ulps);
        prop_assert!(x - further.sqrt() <= 0.0);
    }
}

proptest! {
    #[test]
    fn all_widths_give_the_same_bits(
        a in prop::array::uniform8(number()),
        b in prop::array::uniform8(number()),
        state in prop::collection::vec(prop::array::uniform7(-2.0..2.0f64), 9),
        pairs in prop::array::uniform8((0..9u32, 0..9u32)),
    ) {
        let mut rows = [Row::default(); 9];
        for (row, s) in rows.iter_mut().zip(&state) {
            *row = Row { v: [s[0], s[1]], radius: s[2], x: [s[3], s[4]], angle: s[5], ..*row };
            row.set_spin(s[6]);
        }
        let pairs = pairs.map(|(i, j)| [i, j]);
        let one = results::<f64>(&a, &b, &rows, &pairs);
        // What is not a number may differ in its sign bit.
        let same = |other: &Results| {
            let nan = |bits: u64| f64::from_bits(bits).is_nan();
            let pairs = one.0.iter().flatten().zip(other.0.iter().flatten());
            let numbers = pairs.into_iter().all(|(&p, &q)| p == q || nan(p) && nan(q));
            numbers && one.1 == other.1 && one.2 == other.2
        };
        for isa in Isa::ALL.into_iter().filter(|isa| isa.is_here()) {
            let mut answer = None;
            let (a, b, rows, pairs) = (&a, &b, &rows, &pairs);
            isa.run(Asked { a, b, rows, pairs, answer: &mut answer });
            let (lanes, results) = answer.expect("it was run");
            // What has no instructions of its own takes four numbers at a time.
            prop_assert_eq!(lanes, isa.lanes().max(4));
            prop_assert!(same(&results), "{}", isa);
        }
    }
}
