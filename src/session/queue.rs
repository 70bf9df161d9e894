//! Orders on their way to the worker: whether somebody waits for one is known while it is busy, too.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, SendError, Sender};
use std::time::Duration;

/// Something that can be asked for.
pub(super) trait Urgent {
    /// Whether whoever asks for it waits for what comes of it.
    fn is_urgent(&self) -> bool;
}

/// The end that gives orders.
pub(super) struct Giver<T> {
    orders: Sender<T>,
    waiting: Waiting,
}

/// The end that takes them.
pub(super) struct Taker<T> {
    orders: Receiver<T>,
    waiting: Waiting,
}

/// How many urgent orders are given and not yet taken.
#[derive(Clone, Default)]
pub(super) struct Waiting(Arc<AtomicUsize>);

impl Waiting {
    /// Whether there are any.
    pub(super) fn any(&self) -> bool {
        self.0.load(Ordering::Relaxed) > 0
    }
}

/// Both ends.
pub(super) fn channel<T: Urgent>() -> (Giver<T>, Taker<T>) {
    let (to, from) = mpsc::channel();
    let waiting = Waiting::default();
    let giver = Giver {
        orders: to,
        waiting: waiting.clone(),
    };
    let taker = Taker {
        orders: from,
        waiting,
    };
    (giver, taker)
}

impl<T: Urgent> Giver<T> {
    /// Gives an order.
    pub(super) fn send(&self, order: T) -> Result<(), SendError<T>> {
        // Counted first: what is taken has been counted.
        let urgent = usize::from(order.is_urgent());
        self.waiting.0.fetch_add(urgent, Ordering::Relaxed);
        self.orders.send(order)
    }
}

impl<T: Urgent> Taker<T> {
    /// The next order within this time.
    pub(super) fn recv_timeout(&self, patience: Duration) -> Result<T, RecvTimeoutError> {
        let order = self.orders.recv_timeout(patience);
        order.inspect(|order| self.taken(order))
    }

    fn taken(&self, order: &T) {
        let urgent = usize::from(order.is_urgent());
        self.waiting.0.fetch_sub(urgent, Ordering::Relaxed);
    }

    /// Who knows how many wait.
    pub(super) fn waiting(&self) -> Waiting {
        self.waiting.clone()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    impl Urgent for bool {
        fn is_urgent(&self) -> bool {
            *self
        }
    }

    #[test]
    fn somebody_waits_until_the_last_urgent_order_is_taken() {
        let (giver, taker) = channel();
        let waiting = taker.waiting();
        giver.send(false).unwrap();
        assert!(!waiting.any());
        giver.send(true).unwrap();
        giver.send(true).unwrap();
        let taken = || {
            taker
                .recv_timeout(Duration::ZERO)
                .map(|order| (order, waiting.any()))
        };
        assert_eq!(taken(), Ok((false, true)));
        assert_eq!(taken(), Ok((true, true)));
        assert_eq!(taken(), Ok((true, false)));
        assert_eq!(taken(), Err(RecvTimeoutError::Timeout));
    }
}
