//! An exact solver, as short as it gets: the contact as a list of what it would carry if it were
//! shrunk (Ciavarella and Jaeger). Unbounded memory, no care for speed.

use crate::spheres::{Spheres, histories};

/// What the contact carries up to an overlap [m]: displacement [m] and force [N].
#[derive(Debug, Clone, Copy, Default)]
struct Node {
    overlap: f64,
    displacement: f64,
    force: f64,
}

/// Memory of one contact.
#[derive(Debug, Clone)]
pub(crate) struct Diagram {
    spheres: Spheres,
    nodes: Vec<Node>,
    displacement: f64,
}

impl Diagram {
    pub(crate) fn new(spheres: Spheres) -> Self {
        Self {
            spheres,
            nodes: vec![Node::default()],
            displacement: 0.0,
        }
    }

    fn between(&self, a: Node, b: Node, overlap: f64) -> Node {
        let load = |overlap| self.spheres.load(overlap);
        let part = (overlap - a.overlap) / (b.overlap - a.overlap);
        let load_part = (load(overlap) - load(a.overlap)) / (load(b.overlap) - load(a.overlap));
        Node {
            overlap,
            displacement: a.displacement + part * (b.displacement - a.displacement),
            force: a.force + load_part * (b.force - a.force),
        }
    }

    fn top(&self) -> Node {
        self.nodes[self.nodes.len() - 1]
    }

    /// One step; the force [N].
    pub(crate) fn advance(&mut self, overlap: f64, d: f64) -> f64 {
        self.displacement += d;
        let steepest = self.spheres.friction * self.spheres.kappa();
        let target = self.displacement;
        let top = self.top();
        let load = self.spheres.load(overlap);
        let wide = overlap - top.overlap;
        if wide > 0.0 && (target - top.displacement).abs() <= steepest * wide {
            let slope = (target - top.displacement) / (self.spheres.kappa() * wide);
            let force = top.force + slope * (load - self.spheres.load(top.overlap));
            return self.push(overlap, force);
        }
        if wide < 0.0 {
            let mut cut = top;
            while self.top().overlap > overlap {
                cut = self.nodes.pop().expect("the first node is at zero");
            }
            let node = self.between(self.top(), cut, overlap);
            self.nodes.push(node);
        }
        // Slip comes in from the outside until it meets what the contact already carries.
        let sense = 1.0_f64.copysign(target - self.top().displacement);
        let line = |node: Node| target - sense * steepest * (overlap - node.overlap);
        let ahead = |node: Node| sense * (line(node) - node.displacement);
        while ahead(self.top()) > 0.0 {
            if self.nodes.len() == 1 {
                self.displacement = sense * steepest * overlap;
                break;
            }
            let outer = self.nodes.pop().expect("more than one node");
            let inner = self.top();
            let (g, h) = (ahead(inner), ahead(outer));
            if g <= 0.0 {
                let front = inner.overlap + (outer.overlap - inner.overlap) * g / (g - h);
                if front > inner.overlap {
                    let node = self.between(inner, outer, front);
                    self.nodes.push(node);
                }
                break;
            }
        }
        let front = self.top();
        let slip = load - self.spheres.load(front.overlap);
        self.push(overlap, front.force + sense * self.spheres.friction * slip)
    }

    fn push(&mut self, overlap: f64, force: f64) -> f64 {
        if overlap > self.top().overlap {
            self.nodes.push(Node {
                overlap,
                displacement: self.displacement,
                force,
            });
        }
        force
    }
}

#[test]
fn solver_agrees_with_the_reference() {
    let pair = crate::spheres::pair();
    let mut reader = csv::Reader::from_path("data/reference/md_varying_normal.csv").expect("data");
    let mut diagram = Diagram::new(pair);
    let (mut history, mut last, mut rows) = (String::new(), 0.0, 0);
    let mut worst = 0.0_f64;
    for row in reader.records() {
        let row = row.expect("a row");
        let number = |i: usize| row[i].parse::<f64>().expect("a number");
        if row[0] != history {
            (history, last) = (row[0].to_owned(), 0.0);
            diagram = Diagram::new(pair);
            continue;
        }
        let force = diagram.advance(number(2), number(3) - last);
        last = number(3);
        worst = worst.max((force - number(5)).abs() / (pair.friction * number(4)));
        rows += 1;
    }
    assert_eq!(rows, 2900);
    // The data have 12 digits.
    assert!(worst < 1e-10, "{worst:e}");
    assert_eq!(histories().len(), 14);
}
