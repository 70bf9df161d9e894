//! Memory diagrams in checkpoints: the nodes in use, and no others.

use serde::{Deserialize, Deserializer, Serialize, Serializer, de::Error};

use super::polyline::{Diagram, Node};

#[derive(Serialize)]
struct Written<'a> {
    friction: f64,
    nodes: &'a [Node],
}

#[derive(Deserialize)]
struct Read {
    friction: f64,
    nodes: Vec<Node>,
}

impl<const M: usize> Serialize for Diagram<M> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let (friction, nodes) = (self.friction, self.nodes());
        Written { friction, nodes }.serialize(serializer)
    }
}

impl<'de, const M: usize> Deserialize<'de> for Diagram<M> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let read = Read::deserialize(deserializer)?;
        if read.nodes.len() > M {
            let len = read.nodes.len();
            return Err(D::Error::custom(format!(
                "a memory diagram of {len} nodes, this program keeps {M}"
            )));
        }
        let mut diagram = Self::default();
        diagram.friction = read.friction;
        for node in read.nodes {
            diagram.append(node);
        }
        Ok(diagram)
    }
}
