//! Work on a thread of its own, part by part: it stands while the app is not in front, and whoever lets it stand or drops it
//! waits for the part that is under way. Drivers crash where a program ends while they build.

use std::sync::mpsc::{Receiver, Sender, TryRecvError, channel};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

/// How far work is, and what came of it.
enum News<T> {
    Progress([usize; 2]),
    Done(T),
}

/// Work under way.
pub struct Worker<T> {
    /// Parts that are done, and all.
    pub progress: [usize; 2],
    name: String,
    news: Receiver<News<T>>,
    pace: Arc<Pace>,
    thread: Option<JoinHandle<()>>,
}

/// What the thread asks before each part.
pub struct Gate<T> {
    news: Sender<News<T>>,
    pace: Arc<Pace>,
    begun: Instant,
    stood: Duration,
}

#[derive(Default)]
struct Pace {
    /// What is wanted, and whether no part is under way.
    state: Mutex<(State, bool)>,
    changed: Condvar,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum State {
    #[default]
    Goes,
    Stands,
    Ends,
}

impl Pace {
    fn lock(&self) -> MutexGuard<'_, (State, bool)> {
        // A state is whole whoever panicked.
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn set(&self, state: State) {
        self.lock().0 = state;
        self.changed.notify_all();
    }

    fn rest(&self, rests: bool) {
        self.lock().1 = rests;
        self.changed.notify_all();
    }
}

struct Rests(Arc<Pace>);

impl Drop for Rests {
    fn drop(&mut self) {
        self.0.rest(true);
    }
}

impl<T> Gate<T> {
    /// Tells how many parts are done of how many, and waits while the app is not in front; false if nobody wants the rest.
    pub fn pass(&mut self, progress: [usize; 2]) -> bool {
        // Nobody listens any more only where it ends.
        let _ = self.news.send(News::Progress(progress));
        let asked = Instant::now();
        self.pace.rest(true);
        let stands = |(state, _): &mut (State, bool)| *state == State::Stands;
        let waited = self.pace.changed.wait_while(self.pace.lock(), stands);
        let mut state = waited.unwrap_or_else(PoisonError::into_inner);
        let goes = state.0 == State::Goes;
        state.1 = !goes;
        drop(state);
        self.stood += asked.elapsed();
        goes
    }

    /// For how long it has worked, without what it stood.
    pub fn worked(&self) -> Duration {
        self.begun.elapsed().saturating_sub(self.stood)
    }
}

impl<T: Send + 'static> Worker<T> {
    /// Begins `work` in a thread called `name`.
    ///
    /// # Errors
    /// If the system has no thread left.
    pub fn begin(name: &str, work: impl FnOnce(&mut Gate<T>) -> T + Send + 'static) -> Result<Self, String> {
        let (sender, news) = channel();
        let pace = Arc::<Pace>::default();
        let mut gate = Gate { news: sender, pace: Arc::clone(&pace), begun: Instant::now(), stood: Duration::ZERO };
        let run = move || {
            // However it ends, also by a panic, nothing is under way then.
            let _rests = Rests(Arc::clone(&gate.pace));
            let done = work(&mut gate);
            let _ = gate.news.send(News::Done(done));
        };
        let thread = std::thread::Builder::new().name(name.into()).spawn(run);
        let thread = thread.map_err(|error| format!("the {name} cannot begin: {error}"))?;
        Ok(Self { progress: [0, 0], name: name.into(), news, pace, thread: Some(thread) })
    }
}

impl<T> Worker<T> {
    /// What came of it, once it is done, or that it ended early.
    pub fn poll(&mut self) -> Option<Result<T, String>> {
        loop {
            match self.news.try_recv() {
                Ok(News::Progress(progress)) => self.progress = progress,
                Ok(News::Done(done)) => return Some(Ok(done)),
                Err(TryRecvError::Empty) => return None,
                Err(TryRecvError::Disconnected) => return Some(Err(format!("the {} ended early", self.name))),
            }
        }
    }

    /// Lets it stand, and waits for the part that is under way, but no longer than `limit`; whether nothing is under way then.
    /// What takes longer stands after it all the same.
    pub fn stand(&self, limit: Duration) -> bool {
        self.pace.set(State::Stands);
        let is_under_way = |(_, rests): &mut (State, bool)| !*rests;
        let waited = self.pace.changed.wait_timeout_while(self.pace.lock(), limit, is_under_way);
        waited.unwrap_or_else(PoisonError::into_inner).0.1
    }

    /// Lets it go on.
    pub fn go_on(&self) {
        self.pace.set(State::Goes);
    }
}

impl<T> Drop for Worker<T> {
    fn drop(&mut self) {
        self.pace.set(State::Ends);
        // One that panicked has said so by its silence.
        let _ = self.thread.take().map(JoinHandle::join);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::atomic::{AtomicUsize, Ordering};

    const LONG: Duration = Duration::from_secs(60);

    /// Counts to `most`, a millisecond a part; how far it came, and how long it worked.
    fn counting(most: usize, counted: &Arc<AtomicUsize>) -> Worker<(usize, Duration)> {
        let counted = Arc::clone(counted);
        let work = move |gate: &mut Gate<_>| {
            let mut done = 0;
            while done < most && gate.pass([done, most]) {
                std::thread::sleep(Duration::from_millis(1));
                done += 1;
                counted.store(done, Ordering::SeqCst);
            }
            (done, gate.worked())
        };
        Worker::begin("counting", work).unwrap()
    }

    fn finished<T>(worker: &mut Worker<T>) -> Result<T, String> {
        loop {
            if let Some(done) = worker.poll() {
                return done;
            }
            std::thread::sleep(Duration::from_millis(1));
        }
    }

    #[test]
    fn it_tells_how_far_it_is_and_what_came_of_it() {
        let mut worker = counting(20, &Arc::default());
        assert_eq!(finished(&mut worker).unwrap().0, 20);
        assert_eq!(worker.progress, [19, 20], "before the last part");
        let mut broken = Worker::<()>::begin("broken", |_| panic!("on purpose")).unwrap();
        assert_eq!(finished(&mut broken), Err("the broken ended early".into()));
    }

    #[test]
    fn it_stands_while_it_is_told_to_and_counts_no_time_then() {
        let counted = Arc::default();
        let mut worker = counting(200, &counted);
        assert!(worker.stand(LONG));
        // Nothing is under way any more.
        let before = counted.load(Ordering::SeqCst);
        std::thread::sleep(Duration::from_millis(900));
        assert_eq!(counted.load(Ordering::SeqCst), before);
        assert!(before < 200 && worker.poll().is_none());
        worker.go_on();
        let begun = Instant::now();
        let (done, worked) = finished(&mut worker).unwrap();
        assert!(done == 200 && worked < begun.elapsed() + Duration::from_millis(500), "{worked:?}");
    }

    #[test]
    fn who_lets_it_stand_waits_for_a_part_and_no_longer_than_the_limit() {
        let (begins, begun) = channel();
        let (ends, end) = channel::<()>();
        let mut worker = Worker::begin("slow", move |gate: &mut Gate<usize>| {
            let mut parts = 0;
            while gate.pass([parts, 2]) && parts < 2 {
                begins.send(()).unwrap();
                let _ = end.recv();
                parts += 1;
            }
            parts
        })
        .unwrap();
        begun.recv().unwrap();
        assert!(!worker.stand(Duration::from_millis(50)), "its part is under way");
        ends.send(()).unwrap();
        assert!(worker.stand(LONG) && begun.try_recv().is_err(), "it stands, and begins no other");
        worker.go_on();
        begun.recv().unwrap();
        // One that ends meanwhile, or panics, has nothing under way.
        drop(ends);
        assert!(worker.stand(LONG));
        worker.go_on();
        assert_eq!(finished(&mut worker), Ok(2));
        let broken = Worker::<()>::begin("broken", |_| panic!("on purpose")).unwrap();
        assert!(broken.stand(LONG));
    }

    #[test]
    fn who_drops_it_waits_for_a_part_and_no_more() {
        for stands in [false, true] {
            let counted = Arc::<AtomicUsize>::default();
            let worker = counting(1_000_000, &counted);
            assert!(!stands || worker.stand(LONG));
            std::thread::sleep(Duration::from_millis(20));
            drop(worker);
            let at_end = counted.load(Ordering::SeqCst);
            std::thread::sleep(Duration::from_millis(20));
            assert_eq!((counted.load(Ordering::SeqCst), Arc::strong_count(&counted)), (at_end, 1), "no thread has it");
        }
    }
}
