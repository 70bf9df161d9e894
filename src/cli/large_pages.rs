//! Memory in large pages, where the system has them.
//!
//! A pass goes through some twenty columns side by side, and asks for a new page of each every few
//! hundred particles: with pages of 4 kB a million of them take a fifth longer than with pages of
//! 2 MB. Linux gives those to whoever asks, if they are there; nothing but speed depends on it.
#![allow(
    unsafe_code,
    reason = "an allocator is that; each use says what it relies on"
)]

use std::alloc::{GlobalAlloc, Layout, System};

/// Size of a large page, and where one may begin [B].
const PAGE: usize = 2 << 20;

/// Blocks, and what is left of them after whole pages, get large ones from this size on [B]: no block
/// takes more than that in vain.
const LARGE: usize = PAGE / 2;

/// The system's allocator; it asks for large pages for large blocks.
#[derive(Debug)]
pub struct LargePages;

/// As the system's allocator is asked for it: a last page that is half full is made a whole one.
fn placed(layout: Layout) -> Layout {
    let size = layout.size();
    if cfg!(target_os = "linux") && size >= LARGE {
        let whole = size.max(pages(size) * PAGE);
        Layout::from_size_align(whole, PAGE.max(layout.align())).unwrap_or(layout)
    } else {
        layout
    }
}

/// Large pages in so many bytes.
fn pages(size: usize) -> usize {
    (size + LARGE) / PAGE
}

/// Asks for large pages for a block.
#[cfg(target_os = "linux")]
fn advise(block: *mut u8, layout: Layout) {
    use rustix::mm::{Advice, madvise};
    if !block.is_null() && layout.align() >= PAGE {
        let length = pages(layout.size()) * PAGE;
        // SAFETY: advice changes no contents, and the block is not shorter. Systems without large pages
        // refuse, which is as good.
        let _ = unsafe { madvise(block.cast(), length, Advice::LinuxHugepage) };
    }
}

#[cfg(not(target_os = "linux"))]
fn advise(_: *mut u8, _: Layout) {}

// SAFETY: blocks come from the system's allocator, with at least the alignment asked for, and go back
// with the layout they came with, which depends on the one asked for only.
unsafe impl GlobalAlloc for LargePages {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        let placed = placed(layout);
        // SAFETY: the caller's: a layout that is not empty.
        let block = unsafe { System.alloc(placed) };
        advise(block, placed);
        block
    }

    unsafe fn dealloc(&self, block: *mut u8, layout: Layout) {
        // SAFETY: the caller's: a block of this layout.
        unsafe { System.dealloc(block, placed(layout)) }
    }

    unsafe fn realloc(&self, block: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        // SAFETY: the caller's: a block of this layout, and a size that its alignment allows.
        unsafe {
            let new = Layout::from_size_align_unchecked(size, layout.align());
            if placed(layout) == layout && placed(new) == new {
                return System.realloc(block, layout, size);
            }
            let moved = self.alloc(new);
            if !moved.is_null() {
                moved.copy_from_nonoverlapping(block, layout.size().min(size));
                self.dealloc(block, layout);
            }
            moved
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Blocks around the sizes where they change their kind keep what is in them, and large ones begin
    /// with a page.
    #[test]
    fn blocks_keep_what_is_in_them_when_they_grow_and_shrink() {
        let sizes = [1, LARGE - 1, LARGE, PAGE + 1, 3 * PAGE, LARGE, 100];
        let layout = |size: usize| Layout::from_size_align(size, 8).expect("a size");
        // SAFETY: sizes are not nought, and each block is used within its size.
        unsafe {
            let mut block = LargePages.alloc(layout(sizes[0]));
            *block = 7;
            for sizes in sizes.windows(2) {
                block = LargePages.realloc(block, layout(sizes[0]), sizes[1]);
                assert!(!block.is_null() && *block == 7);
                if cfg!(target_os = "linux") && sizes[1] >= LARGE {
                    assert_eq!(block.addr() % PAGE, 0);
                }
                *block.add(sizes[1] - 1) = 7;
                *block = 7;
            }
            LargePages.dealloc(block, layout(sizes[sizes.len() - 1]));
            let zeroed = LargePages.alloc_zeroed(layout(2 * PAGE));
            assert!((0..2 * PAGE).all(|at| *zeroed.add(at) == 0));
            LargePages.dealloc(zeroed, layout(2 * PAGE));
        }
    }
}
