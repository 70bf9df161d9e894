//! What the laws of partial slip answer for one contact.

/// One step.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Slipped {
    /// Tangential force at the end of the step [N].
    pub force: f64,
    /// Energy lost by slip of the whole contact [J].
    pub gross: f64,
    /// Energy lost by slip of outer annuli while the inside sticks, and by what the law forgets [J]; of
    /// either sign.
    pub micro: f64,
    /// Whether the whole contact slid.
    pub sliding: bool,
}
