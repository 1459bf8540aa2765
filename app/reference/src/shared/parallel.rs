//! The same function for every particle, on all processors.

use std::num::NonZero;
use std::thread;

/// Fewer items are done here and now: a thread takes longer to begin.
const LEAST_A_THREAD: usize = 256;

/// `of(0)` to `of(count - 1)`, in that order, whatever ran when.
pub fn map<T: Send>(count: usize, of: impl Fn(usize) -> T + Sync) -> Vec<T> {
    let threads = thread::available_parallelism().map_or(1, NonZero::get).min(count / LEAST_A_THREAD).max(1);
    if threads == 1 {
        return (0..count).map(of).collect();
    }
    let each = count.div_ceil(threads);
    let of = &of;
    thread::scope(|scope| {
        let parts: Vec<_> = (0..threads)
            .map(|part| scope.spawn(move || (part * each..count.min((part + 1) * each)).map(of).collect::<Vec<T>>()))
            .collect();
        // A panic of a part is one of the whole.
        parts
            .into_iter()
            .flat_map(|part| part.join().unwrap_or_else(|fault| std::panic::resume_unwind(fault)))
            .collect()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn is_in_order_whatever_the_count() {
        for count in [0, 1, 255, 256, 511, 512, 1000, 4099] {
            assert_eq!(map(count, |i| 3 * i), (0..count).map(|i| 3 * i).collect::<Vec<_>>());
        }
    }
}
