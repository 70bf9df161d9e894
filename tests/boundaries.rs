//! Boundaries that impose strain and stress: periodic cells, rings, walls, and the flow of a continuum.

mod common;

#[path = "boundaries/cells.rs"]
mod cells;
#[path = "boundaries/channel.rs"]
mod channel;
#[path = "boundaries/direct_stress.rs"]
mod direct_stress;
#[path = "boundaries/flows.rs"]
mod flows;
#[path = "boundaries/grains.rs"]
mod grains;
#[path = "boundaries/moduli.rs"]
mod moduli;
#[path = "boundaries/rings.rs"]
mod rings;
#[path = "boundaries/servos.rs"]
mod servos;
#[path = "boundaries/stress.rs"]
mod stress;
#[path = "boundaries/wall_servos.rs"]
mod wall_servos;
#[path = "boundaries/walls.rs"]
mod walls;
