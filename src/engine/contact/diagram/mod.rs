//! Exact tangential law of Hertzian contacts with friction, by a memory diagram.
//!
//! Mindlin & Deresiewicz 1953 solved single reversals; Jäger 1993 and Ciavarella 1998 gave the general
//! answer used here. Let η run from 0 to the overlap α and N(η) = (4/3) E* √R* η^1.5. The tangential
//! traction of any history is a sum of those of rigid punches with the radii a(η) = √(R*η),
//!
//! ```text
//! q(r) = ∫ D(η) dp(r; η),  |D| <= μ,  T = ∫ D dN,  δ = k ∫ D dη,  k = E*/(4 G*)
//! ```
//!
//! and D(η) is all a contact remembers. Its integrals are a polyline from (0, 0, 0) to the state of
//! now, which tells what the contact would carry if it were shrunk to η without slip; [`Diagram`]
//! keeps its nodes. A step is a straight line in (α, δ):
//!
//! 1. Growth with |d| <= μ k Δα sticks: the new annulus gets D = d/(k Δα).
//! 2. Otherwise the outer annuli slip in the direction s: a line of slope s μ is drawn from the new
//!    end inwards, and where it meets the polyline is the slip front. If it meets nothing the whole
//!    contact slides.
//!
//! Energy. With the reciprocal theorem a punch η does the work k D dη T(η) on all those inside it, so
//! the contact stores U = ∫ T dδ along the polyline. Sticking growth and shrinking along the polyline
//! add and return just that; they lose nothing.
//!
//! Slip. A point at r has slipped by k ∫ D (1 - w) dη, where w(r; η) is 1 inside the punch η and its
//! surface displacement outside. At fixed η, D changes only where the front passes. The traction of
//! slip is s μ p(r; α), and by the reciprocal theorem again its work on the slip is, for a front that
//! sweeps over c,
//!
//! ```text
//! dW = s μ k (s μ - D(c)) g(c; α) dc,  g = N(α) - N(c) - N'(c) (α - c) >= 0
//! ```
//!
//! The measure (s μ - D) dc grows in proportion to the step done so far and so does α, hence α is
//! linear in c on each segment and the integral has a closed form: the loss is that of the straight
//! line, not a difference of work and energy. Surplus of the path over the polyline is slip of the
//! whole contact under μ N.
//!
//! Memory is bounded by dropping nodes: see [`Diagram`]. This folder knows no particles and no steps
//! in time; a step is done with + - * / and √, so its bits are the same everywhere.

mod energy;
mod friction;
mod lanes;
#[cfg(test)]
mod lanes_tests;
mod partial;
mod polyline;
mod slip;
mod storage;
mod sweep;
#[cfg(test)]
mod tests;
mod view;

pub use lanes::PartialLanes;
pub use partial::Partial;
pub use polyline::Diagram;
