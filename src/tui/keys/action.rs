//! What keys do.

/// What a key does.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Action {
    /// Run or pause.
    Toggle,
    /// One cycle.
    Cycle,
    /// Cycles up to the next row.
    Row,
    /// Open the prompt.
    Prompt,
    /// Open the prompt with a text.
    PromptWith(&'static str),
    /// Help.
    Help,
    /// Browser of presets.
    Presets,
    /// End.
    Quit,
    /// Ctrl-C: pause, then ask to quit.
    Interrupt,
    /// Focus the next pane or the one before.
    Focus(isize),
    /// Focus a pane by number.
    Pane(usize),
    /// Enlarge the pane in focus, or back.
    Zoom,
    /// Close what is open.
    Back,
    /// Move the view.
    Pan(f64, f64),
    /// Magnify the view.
    Magnify(f64),
    /// Show the whole assembly.
    Fit,
    /// Another drawing, or column of a chart, in the pane in focus.
    Turn(isize),
    /// Another pane in the place in focus.
    Place(isize),
    /// Another disc selected.
    Select(isize),
    /// Another contact followed.
    Contact(isize),
    /// Force bars: none, force, tangential.
    Chains,
    /// Outlines of discs.
    Discs,
    /// Velocities.
    Velocities,
    /// Contacts, rotations, displacements, sliding against the reference, or forces.
    Compare,
    /// Braille, half blocks, ASCII.
    Points,
    /// Colour or mono.
    Theme,
    /// Frames per second.
    Fps(bool),
    /// Cycles per second: halve or double.
    Pace(bool),
    /// As fast as possible.
    Flat,
    /// Scroll by pages.
    Scroll(isize),
    /// Warnings have been seen.
    Acknowledge,
    /// Repaint everything.
    Repaint,
    /// Stop the program, as Ctrl-Z does.
    Suspend,
}
