//! The state of a simulation.

use serde::{Deserialize, Serialize};

use super::auto_step::{Looks, StepChanges};
use super::boundary::seen::Seen;
use super::boundary::{Boundary, Straining};
use super::contact::pass::ContactPass;
use super::contact::quantities::BasisOwned;
use super::fault::Fault;
use super::lanes::Isa;
use super::ledger::Ledger;
use super::neighbours::list::ContactList;
use super::origin::far_origin;
use super::packing::PassPlace;
use super::pair::PairTable;
use super::particles::{Inertia, Mobility, Particles};
use super::phase::Clock;
use super::plan::Plan;
use super::restart::{Brought, number};
use super::setup::{Body, Gravity, Setup};
use super::threads::Threads;
use super::time_step;
use super::wall::Wall;

/// Particles, walls, contacts and what they are modelled with, at a cycle boundary.
#[derive(Serialize, Deserialize)]
pub struct World {
    /// What was set up; particles and walls have moved on to the columns below.
    pub(super) model: Setup,
    pub(super) pairs: PairTable,
    /// Added to inner coordinates gives those of the preset [m].
    pub(super) origin: [f64; 2],
    pub(super) cycle: u64,
    /// Time and cycle when the step was last changed: time is counted from there.
    pub(super) since: (f64, u64),
    pub(super) dt: f64,
    pub(super) base_step: f64,
    /// Given velocities are those of the start: the first kick is half a step.
    pub(super) first_kick: bool,
    pub(super) particles: Particles,
    pub(super) walls: Vec<Wall>,
    pub(super) boundary: Option<Boundary>,
    /// Flow that carries all particles along.
    pub(super) continuum: Option<Straining>,
    pub(super) contacts: ContactList,
    pub(super) ledger: Option<Ledger>,
    /// Potential of gravity at the start [J].
    pub(super) datum: f64,
    /// Whether `particles.force` holds the sums of this boundary.
    pub(super) settled: bool,
    pub(super) fracc: FraccMonitor,
    pub(super) step_changes: StepChanges,
    pub(super) looks: Looks,
    pub(super) tol: f64,
    /// Size of the scene at the start, for finding lost particles [m].
    pub(super) size: f64,
    pub(super) next_id: u32,
    /// Bonds made so far, but for those that were deleted with a particle.
    pub(super) bonds_made: u64,
    /// Whether some particle was given a spin: it turns even where no contact can turn it.
    pub(super) turning: bool,
    /// The fault that the last cycle broke off with.
    pub(super) broken: Option<Fault>,
    /// What a change from outside left that no cycle can begin with, until another mends it.
    pub(super) misplaced: Option<Fault>,
    /// The contact pass.
    pub(super) place: PassPlace,
    #[serde(skip)]
    pub(super) seen: Seen,
    /// Forces of a loaded ring on their way to its particles.
    #[serde(skip)]
    pub(super) loads: Vec<(usize, [f64; 2])>,
    #[serde(skip)]
    pub(super) threads: Threads,
    #[serde(skip)]
    pub(super) isa: Isa,
    #[serde(skip)]
    pub(super) clock: Option<Clock>,
}

/// What the FRACC monitor saw.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct FraccMonitor {
    /// Largest FRACC since the last row of the history.
    pub largest: Option<f64>,
    /// Cycles in which it was above 0.3.
    pub warnings: u64,
    /// The last such cycle: cycle, particle number, FRACC.
    pub last: Option<(u64, u32, f64)>,
    /// The worst such cycle: cycle, particle number, FRACC.
    pub worst: Option<(u64, u32, f64)>,
}

impl World {
    /// The same with what a sample brings besides its particles and walls.
    /// `threads` 0: as many as suit its size.
    pub fn build_from(mut setup: Setup, brought: &Brought, threads: usize) -> Result<Self, Fault> {
        let ids = brought.numbers.as_slice();
        let origin = far_origin(&setup.particles);
        let mut particles = Particles::default();
        particles.reserve(setup.particles.len());
        for (p, particle) in setup.particles.iter().enumerate() {
            let density = setup.materials[particle.material].density;
            let mass = Inertia::of(setup.body, particle.radius, density);
            particles.push(number(ids, p), particle, origin, mass);
        }
        // A large scene has no room for them twice.
        setup.particles = Vec::new();
        let walls = setup.walls.iter().map(|w| Wall::new(w, origin)).collect();
        let count = particles.len();
        let pairs = PairTable::new(&setup);
        let rate = setup.strain_rate;
        let own = setup
            .boundary
            .map(|boundary| Boundary::new(boundary, origin, rate));
        let kept = brought.boundary.as_ref();
        let boundary = kept.map(|kept| kept.moved(origin.map(|x| -x))).or(own);
        let mut world = Self {
            pairs,
            origin,
            cycle: 0,
            since: (0.0, 0),
            dt: f64::NAN,
            base_step: f64::NAN,
            first_kick: true,
            next_id: number(ids, count),
            bonds_made: 0,
            turning: false,
            broken: None,
            misplaced: None,
            particles,
            walls,
            boundary,
            continuum: None,
            contacts: ContactList::default(),
            ledger: setup.ledger.then(Ledger::default),
            datum: 0.0,
            settled: false,
            fracc: FraccMonitor::default(),
            step_changes: StepChanges::default(),
            looks: Looks::default(),
            tol: 1.0,
            size: 0.0,
            place: PassPlace::default(),
            seen: Seen::default(),
            loads: Vec::new(),
            threads: Threads::team(threads, count),
            isa: Isa::default(),
            clock: None,
            model: setup.without_bodies(),
        };
        world.size_up();
        world.found_ring();
        world.replan();
        world.retime();
        let sound = world.dt > 0.0 && world.dt.is_finite();
        if !sound && !world.particles.is_empty() {
            let (cycle, dt) = (world.cycle, world.dt);
            return Err(Fault::NoStep { cycle, dt });
        }
        world.touch(0.0)?;
        world.begin_step();
        world.open_ledger();
        Ok(world)
    }

    /// Uses other vector instructions; what is worked out stays the same.
    ///
    /// # Panics
    /// If this processor lacks them.
    pub fn use_instructions(&mut self, isa: Isa) {
        assert!(isa.is_here(), "this processor has no {isa}");
        self.isa = isa;
    }

    /// The contact pass.
    ///
    /// # Panics
    /// Never after `build` or `unpack`.
    pub fn pass(&self) -> &dyn ContactPass {
        self.place
            .pass
            .as_deref()
            .expect("build and unpack make a pass")
    }

    pub(super) fn take_pass(&mut self) -> Box<dyn ContactPass> {
        self.place
            .pass
            .take()
            .expect("build and unpack make a pass")
    }

    pub(super) fn put_pass(&mut self, pass: Box<dyn ContactPass>) {
        self.place.pass = Some(pass);
    }

    /// What the scene needs modelled as its materials are now.
    pub fn plan(&self) -> Plan {
        let mut used: Vec<usize> = self
            .particles
            .material
            .iter()
            .map(|&m| m as usize)
            .collect();
        used.sort_unstable();
        used.dedup();
        Plan::new(
            &self.model,
            &self.pairs,
            &used,
            &self.wall_materials(),
            self.ledger.is_some(),
        )
    }

    pub(super) fn wall_materials(&self) -> Vec<usize> {
        self.walls.iter().map(|wall| wall.material).collect()
    }

    /// Chooses the pass anew and prepares every contact; memory carries over in reduced form.
    pub(super) fn replan(&mut self) {
        let mut pass = self.plan().pass();
        let old = vec![u32::MAX; self.contacts.len()];
        pass.relist(&old, self.contacts.pairs.len(), self.room(), &|k| {
            self.basis(k)
        });
        if let Some(before) = self.place.pass.take() {
            pass.take_over(before.as_ref(), &|k| self.geometry(k).overlap);
        }
        self.contacts.rolls = pass.rolling();
        self.place.pass = Some(pass);
        self.weigh();
        self.note_spins();
    }

    /// Whether anything turns. Where rotation is off nothing does, whatever was given.
    pub(super) fn note_spins(&mut self) {
        let rows = &mut self.particles.row;
        if !self.model.rotation {
            for row in rows.iter_mut() {
                row.set_spin(0.0);
            }
        }
        self.turning = rows.iter().any(|row| row.spin != 0.0);
    }

    /// Contacts that memory is kept ready for.
    pub(super) fn room(&self) -> usize {
        super::neighbours::room(self.particles.len()).iter().sum()
    }

    /// What contact k is prepared from.
    pub(super) fn basis(&self, k: usize) -> BasisOwned {
        let p = &self.particles;
        let inverse = |q: usize| if p.is_held(q) { 0.0 } else { 1.0 / p.mass[q] };
        if let Some(&[i, j]) = self.contacts.pairs.get(k) {
            let (i, j) = (i as usize, j as usize);
            let pair = *self
                .pairs
                .get(p.material[i] as usize, p.material[j] as usize, false);
            let sum = inverse(i) + inverse(j);
            // Two that are held: any finite mass will do, nothing answers their force.
            let [a, b] = [p.row[i].radius, p.row[j].radius];
            return BasisOwned {
                pair,
                m_eff: if sum > 0.0 { 1.0 / sum } else { p.mass[i] },
                r_eff: a * b / (a + b),
                critical_above: self.critical_above(a.min(b)),
                nodes: usize::from(self.model.nodes),
            };
        }
        let wall = &self.contacts.walls[k - self.contacts.pairs.len()];
        let i = wall.particle as usize;
        let material = self.walls[wall.wall as usize].material;
        let pair = *self.pairs.get(p.material[i] as usize, material, true);
        BasisOwned {
            pair,
            m_eff: p.mass[i],
            r_eff: p.row[i].radius,
            critical_above: self.critical_above(p.row[i].radius),
            nodes: usize::from(self.model.nodes),
        }
    }

    /// Overlap above which a contact is damped critically whose smaller body has this radius [m].
    fn critical_above(&self, smaller: f64) -> f64 {
        let share = self.model.damping.overlap_critical;
        share.map_or(f64::INFINITY, |share| share * 2.0 * smaller)
    }

    /// Sets the time step and the answer to force that goes with it.
    pub(super) fn retime(&mut self) {
        let time = if self.dt.is_finite() {
            self.time()
        } else {
            0.0
        };
        let walls = self.wall_materials();
        let base = time_step::base(&self.model, &self.pairs, &self.particles, &walls);
        // When nothing is left that limits the step, the last one goes on: clocks need a number.
        if base.is_finite() || !self.base_step.is_finite() {
            self.base_step = base;
        }
        self.since = (time, self.cycle);
        self.dt = self.step_now();
        self.mobilise();
    }

    /// Works out the answer to force of every particle.
    pub(super) fn mobilise(&mut self) {
        let (dt, p) = (self.dt, &mut self.particles);
        for k in 0..p.len() {
            let free = |axis: usize, gain: f64| if p.fixed[k][axis] { 0.0 } else { gain };
            let kick = dt / p.mass[k];
            let turn = dt * p.row[k].radius / p.inertia[k];
            let turn = if self.model.rotation {
                free(2, turn)
            } else {
                0.0
            };
            p.mobility[k] = Mobility::new([free(0, kick), free(1, kick)], turn);
        }
    }

    /// Works out weight and applied force of every particle, if there are any.
    pub(super) fn weigh(&mut self) {
        let p = &mut self.particles;
        p.body.clear();
        if self.model.gravity.is_none() && !p.are_pushed() {
            return;
        }
        for k in 0..p.len() {
            let (x, m) = (p.row[k].x, p.mass[k]);
            let g = match self.model.gravity {
                None => [0.0; 2],
                Some(Gravity::Uniform(g)) => g,
                Some(Gravity::Centripetal { towards, g }) => {
                    let d = [
                        towards[0] - self.origin[0] - x[0],
                        towards[1] - self.origin[1] - x[1],
                    ];
                    let distance = (d[0] * d[0] + d[1] * d[1]).sqrt();
                    if distance > 0.0 {
                        d.map(|d| g * d / distance)
                    } else {
                        [0.0; 2]
                    }
                }
            };
            let applied = p.applied(k);
            p.body.push([m * g[0] + applied[0], m * g[1] + applied[1]]);
        }
    }

    /// Takes note of how large the scene is, once there are particles. The first of them say how wide
    /// the first list is, unless the setup does, and how near ends of walls are one point.
    pub(super) fn size_up(&mut self) {
        if self.particles.is_empty() {
            return;
        }
        let smallest = self.particles.smallest_radius();
        let [low, high] = self.particles.extent();
        let size = (high[0] - low[0]).max(high[1] - low[1]).max(0.0) + 2.0 * smallest;
        let first = self.size == 0.0;
        self.size = self.size.max(size);
        if first {
            self.tol = self.model.tol.unwrap_or(0.1 * smallest);
            self.join_walls();
        }
    }

    pub(super) fn join_walls(&mut self) {
        let reach = self.joint_reach();
        Wall::join(&mut self.walls, reach);
    }

    /// Ends nearer than this count as one point [m].
    pub(super) fn joint_reach(&self) -> f64 {
        self.joint(self.particles.smallest_radius())
    }

    /// The same where the smallest radius is known [m].
    pub(super) fn joint(&self, smallest: f64) -> f64 {
        1e-6 * smallest.min(self.size)
    }

    /// Thickness of the assembly [m]: 1 for discs, the mean diameter for spheres.
    pub fn thickness(&self) -> f64 {
        match self.model.body {
            Body::Disc => 1.0,
            Body::Sphere => {
                let sum: f64 = self.particles.row.iter().map(|row| row.radius).sum();
                2.0 * sum / self.particles.len() as f64
            }
        }
    }
}
