//! One thing that is wrong with a preset, and the list they are collected in.

use std::cell::{Cell, RefCell};

use super::place::{Place, Source};

/// One error: what, where, what would be right, what to do.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Problem {
    /// What is wrong.
    pub(crate) message: String,
    /// Where; `None` if there is no text to point into.
    pub(crate) place: Option<Place>,
    /// What was expected there, written under the caret.
    pub(crate) expected: String,
    /// A second place that matters and what it is.
    pub(crate) also: Option<Box<(Place, String)>>,
    /// What to do about it.
    pub(crate) remedy: String,
}

impl Problem {
    /// A problem at a place.
    pub(crate) fn new(message: impl Into<String>, place: Place) -> Self {
        Self {
            place: Some(place),
            ..Self::nowhere(message)
        }
    }

    /// A problem with the file itself.
    pub(crate) fn nowhere(message: impl Into<String>) -> Self {
        Self {
            message: message.into(),
            place: None,
            expected: String::new(),
            also: None,
            remedy: String::new(),
        }
    }

    /// Says what was expected.
    pub(crate) fn expected(mut self, expected: impl Into<String>) -> Self {
        self.expected = expected.into();
        self
    }

    /// Says what to do.
    pub(crate) fn remedy(mut self, remedy: impl Into<String>) -> Self {
        self.remedy = remedy.into();
        self
    }

    /// Points at a second place.
    pub(crate) fn also(mut self, place: Place, what: impl Into<String>) -> Self {
        self.also = Some(Box::new((place, what.into())));
        self
    }
}

/// The texts of a scene and what has been found wrong with them so far. Reading goes on after a
/// problem, so that one report shows them all.
#[derive(Debug)]
pub(crate) struct Report {
    /// The preset, then the overrides.
    pub(crate) sources: Vec<Source>,
    found: RefCell<Vec<Problem>>,
    count: Cell<usize>,
}

impl Report {
    /// Problems kept: a preset with a hundred thousand wrong particles needs no more.
    const KEPT: usize = 1000;

    /// Nothing wrong yet.
    pub(crate) fn new(sources: Vec<Source>) -> Self {
        Self {
            sources,
            found: RefCell::default(),
            count: Cell::new(0),
        }
    }

    /// Adds a problem.
    pub(crate) fn add(&self, problem: Problem) {
        self.count.set(self.count.get() + 1);
        let mut found = self.found.borrow_mut();
        if found.len() < Self::KEPT {
            found.push(problem);
        }
    }

    /// How many problems there are.
    pub(crate) fn count(&self) -> usize {
        self.count.get()
    }

    /// Whether no more problems are kept.
    pub(crate) fn is_full(&self) -> bool {
        self.count() >= Self::KEPT
    }

    /// The texts, the problems kept and the number of all.
    pub(crate) fn into_parts(self) -> (Vec<Source>, Vec<Problem>, usize) {
        (self.sources, self.found.into_inner(), self.count.get())
    }
}
