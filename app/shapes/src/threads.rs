//! Work in equal parts on all cores.

/// Calls `work` with the number of each item and the item, on as many threads as there are cores.
pub fn for_each<T: Send>(items: Vec<T>, work: impl Fn(T) + Sync) {
    let threads = std::thread::available_parallelism().map_or(1, usize::from).min(items.len().max(1));
    let queue = std::sync::Mutex::new(items.into_iter());
    let take = || queue.lock().unwrap_or_else(std::sync::PoisonError::into_inner).next();
    std::thread::scope(|scope| {
        let run = || {
            while let Some(item) = take() {
                work(item);
            }
        };
        for _ in 1..threads {
            scope.spawn(run);
        }
        run();
    });
}
