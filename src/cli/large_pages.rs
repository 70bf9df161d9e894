//! Memory in large pages, where the system has them.
//!
//! A pass goes through some twenty columns side by side, and asks for a new page of each every few
//! hundred particles: with pages of 4 kB a million of them take a seventh longer than with pages
//! of 2 MB. Linux gives those to whoever asks, if they are there; nothing but speed depends on it.
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

/// Bytes that a large block of this size is given: a last page that is half full is made a whole one.
#[cfg(target_os = "linux")]
fn length(size: usize) -> usize {
    // Small pages have 64 kB at most.
    size.max((size + LARGE) / PAGE * PAGE)
        .next_multiple_of(1 << 16)
}

/// A large block, at the beginning of a page; null if there is no memory.
#[cfg(target_os = "linux")]
fn map(size: usize) -> *mut u8 {
    use rustix::mm::{Advice, MapFlags, ProtFlags, madvise, mmap_anonymous, munmap};
    let length = length(size);
    let (rights, flags) = (ProtFlags::READ | ProtFlags::WRITE, MapFlags::PRIVATE);
    // SAFETY: new memory, of which what lies before and behind the block goes back. Advice changes no
    // contents; systems without large pages refuse, which is as good.
    unsafe {
        let null = std::ptr::null_mut();
        let Ok(start) = mmap_anonymous(null, length + PAGE, rights, flags) else {
            return null.cast();
        };
        let before = start.addr().next_multiple_of(PAGE) - start.addr();
        let block = start.byte_add(before);
        if before > 0 {
            let _ = munmap(start, before);
        }
        let _ = munmap(block.byte_add(length), PAGE - before);
        let _ = madvise(block, length, Advice::LinuxHugepage);
        block.cast()
    }
}

/// Moves a large block to where there is room for another size, without a copy; null if that cannot be,
/// and then it stays.
///
/// # Safety
/// It must come from [`map`] for so many bytes, and nobody may use it meanwhile.
#[cfg(target_os = "linux")]
unsafe fn remap(block: *mut u8, size: usize, new: usize) -> *mut u8 {
    use rustix::mm::{MremapFlags, mremap_fixed};
    let place = map(new);
    if place.is_null() {
        return place;
    }
    let (before, after) = (length(size), length(new));
    // SAFETY: both are whole blocks of their own, of these lengths; the new one holds nothing yet.
    unsafe {
        let flags = MremapFlags::MAYMOVE;
        match mremap_fixed(block.cast(), before, after, flags, place.cast()) {
            Ok(moved) => moved.cast(),
            Err(_) => {
                unmap(place, new);
                std::ptr::null_mut()
            }
        }
    }
}

/// Gives a large block back.
///
/// # Safety
/// It must come from [`map`] for so many bytes.
#[cfg(target_os = "linux")]
unsafe fn unmap(block: *mut u8, size: usize) {
    // SAFETY: the caller's.
    let _ = unsafe { rustix::mm::munmap(block.cast(), length(size)) };
}

/// Whether a block is asked for in large pages.
fn is_large(layout: Layout) -> bool {
    cfg!(target_os = "linux") && layout.size() >= LARGE && layout.align() <= PAGE
}

// SAFETY: small blocks are those of the system's allocator. Large ones are mapped for themselves, at
// the beginning of a page, with at least the bytes asked for; which of both follows from the layout.
unsafe impl GlobalAlloc for LargePages {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        #[cfg(target_os = "linux")]
        if is_large(layout) {
            return map(layout.size());
        }
        // SAFETY: the caller's: a layout that is not empty.
        unsafe { System.alloc(layout) }
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        #[cfg(target_os = "linux")]
        if is_large(layout) {
            // New memory is.
            return map(layout.size());
        }
        // SAFETY: as above.
        unsafe { System.alloc_zeroed(layout) }
    }

    unsafe fn dealloc(&self, block: *mut u8, layout: Layout) {
        // SAFETY: the caller's: a block of this layout.
        unsafe {
            #[cfg(target_os = "linux")]
            if is_large(layout) {
                return unmap(block, layout.size());
            }
            System.dealloc(block, layout);
        }
    }

    unsafe fn realloc(&self, block: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        // SAFETY: the caller's: a block of this layout, and a size that its alignment allows.
        unsafe {
            let new = Layout::from_size_align_unchecked(size, layout.align());
            match (is_large(layout), is_large(new)) {
                (false, false) => return System.realloc(block, layout, size),
                #[cfg(target_os = "linux")]
                (true, true) => {
                    if length(layout.size()) == length(size) {
                        return block;
                    }
                    let moved = remap(block, layout.size(), size);
                    if !moved.is_null() {
                        return moved;
                    }
                }
                _ => {}
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
        let sizes = [
            1,
            LARGE - 1,
            LARGE,
            PAGE + 1,
            3 * PAGE - 8,
            3 * PAGE,
            LARGE,
            100,
        ];
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
            // Memory that was used and given back comes as noughts, too.
            for byte in [0xff, 0] {
                let zeroed = LargePages.alloc_zeroed(layout(2 * PAGE));
                assert!((0..2 * PAGE).all(|at| *zeroed.add(at) == 0));
                zeroed.write_bytes(byte, 2 * PAGE);
                LargePages.dealloc(zeroed, layout(2 * PAGE));
            }
        }
    }

    #[test]
    fn what_cannot_be_had_is_refused_and_wide_alignments_are_kept() {
        // SAFETY: as above; the largest layout there may be is never given.
        unsafe {
            let most = Layout::from_size_align(isize::MAX as usize - 7, 8).expect("a layout");
            assert!(LargePages.alloc(most).is_null());
            let layout = Layout::from_size_align(PAGE, 8).expect("a layout");
            let block = LargePages.alloc(layout);
            block.write_bytes(7, PAGE);
            assert!(LargePages.realloc(block, layout, most.size()).is_null());
            assert!(*block == 7 && *block.add(PAGE - 1) == 7);
            LargePages.dealloc(block, layout);
            let wide = Layout::from_size_align(PAGE, 2 * PAGE).expect("a layout");
            let block = LargePages.alloc(wide);
            assert_eq!(block.addr() % (2 * PAGE), 0);
            *block = 7;
            let grown = LargePages.realloc(block, wide, 4 * PAGE);
            assert!(grown.addr().is_multiple_of(2 * PAGE) && *grown == 7);
            let wide = Layout::from_size_align(4 * PAGE, 2 * PAGE).expect("a layout");
            LargePages.dealloc(grown, wide);
        }
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn a_last_page_is_large_if_it_is_half_full() {
        let lengths = [LARGE, PAGE - 1, PAGE + 1, PAGE + LARGE - 1, PAGE + LARGE].map(length);
        let step = 1 << 16;
        assert_eq!(lengths, [PAGE, PAGE, PAGE + step, PAGE + LARGE, 2 * PAGE]);
    }
}
