//! Work on a thread of its own, part by part: it stands while the app is not in front, and whoever lets it stand or drops it
//! waits for the part that is under way. Drivers crash where a program ends while they build. Who lets several stand waits for
//! all of them until one deadline.

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

/// What is wanted of work, and whether it rests: the same of all work, whatever comes of it.
#[derive(Default)]
pub struct Pace {
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

    /// Waits for the part that is under way until `deadline`; whether none is then.
    fn rests_by(&self, deadline: Instant) -> bool {
        let is_under_way = |(_, rests): &mut (State, bool)| !*rests;
        let limit = deadline.saturating_duration_since(Instant::now());
        let waited = self.changed.wait_timeout_while(self.lock(), limit, is_under_way);
        waited.unwrap_or_else(PoisonError::into_inner).0.1
    }
}

/// Lets all work of these `paces` stand, and waits for the parts that are under way, for all of them together no longer than
/// `limit`; whether nothing is under way then. What takes longer stands after it all the same.
pub fn stand_together(paces: &[&Pace], limit: Duration) -> bool {
    // Before the first is waited for: the others would begin further parts meanwhile.
    paces.iter().for_each(|pace| pace.set(State::Stands));
    let deadline = Instant::now() + limit;
    // After one that was not done by the deadline there is nothing to wait for.
    paces.iter().all(|pace| pace.rests_by(deadline))
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

    /// By which it is let stand, with others: [`stand_together`].
    pub fn pace(&self) -> &Pace {
        &self.pace
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

    fn stand<T>(worker: &Worker<T>, limit: Duration) -> bool {
        stand_together(&[worker.pace()], limit)
    }

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
        assert!(stand(&worker, LONG));
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
        assert!(!stand(&worker, Duration::from_millis(50)), "its part is under way");
        ends.send(()).unwrap();
        assert!(stand(&worker, LONG) && begun.try_recv().is_err(), "it stands, and begins no other");
        worker.go_on();
        begun.recv().unwrap();
        // One that ends meanwhile, or panics, has nothing under way.
        drop(ends);
        assert!(stand(&worker, LONG));
        worker.go_on();
        assert_eq!(finished(&mut worker), Ok(2));
        let broken = Worker::<()>::begin("broken", |_| panic!("on purpose")).unwrap();
        assert!(stand(&broken, LONG));
    }

    /// Work whose parts last until somebody ends them; what tells that one began, and what ends it.
    fn waiting() -> (Worker<usize>, Receiver<()>, Sender<()>) {
        let ((begins, begun), (ends, end)) = (channel(), channel::<()>());
        let work = move |gate: &mut Gate<usize>| {
            let mut parts = 0;
            while gate.pass([parts, 9]) {
                // Nobody counts the last ones.
                let _ = begins.send(());
                let _ = end.recv();
                parts += 1;
            }
            parts
        };
        (Worker::begin("waiting", work).unwrap(), begun, ends)
    }

    #[test]
    fn two_that_stand_together_have_one_limit_and_neither_begins_a_part_meanwhile() {
        let limit = Duration::from_millis(1500);
        let ((one, one_begun, one_ends), (other, other_begun, other_ends)) = (waiting(), waiting());
        one_begun.recv().unwrap();
        other_begun.recv().unwrap();
        let both = [one.pace(), other.pace()];
        let asked = Instant::now();
        assert!(!stand_together(&both, limit), "both are under way");
        let waited = asked.elapsed();
        assert!(waited >= limit && waited < limit.mul_f64(1.8), "{waited:?} for both");
        both.iter().for_each(|pace| pace.set(State::Goes));
        // The first rests only after the second is done with its part: that has begun no other by then.
        let asked = Arc::clone(&one.pace);
        let ending = std::thread::spawn(move || {
            let soon = || std::thread::sleep(Duration::from_millis(200));
            while asked.lock().0 != State::Stands {
                soon();
            }
            soon();
            other_ends.send(()).unwrap();
            soon();
            one_ends.send(()).unwrap();
            (one_ends, other_ends)
        });
        assert!(stand_together(&both, LONG) && one_begun.try_recv().is_err() && other_begun.try_recv().is_err());
        drop(ending.join().unwrap());
        // One that rests does not hide that another does not.
        other.go_on();
        other_begun.recv().unwrap();
    }

    #[test]
    fn who_drops_it_waits_for_a_part_and_no_more() {
        for stands in [false, true] {
            let counted = Arc::<AtomicUsize>::default();
            let worker = counting(1_000_000, &counted);
            assert!(!stands || stand(&worker, LONG));
            std::thread::sleep(Duration::from_millis(20));
            drop(worker);
            let at_end = counted.load(Ordering::SeqCst);
            std::thread::sleep(Duration::from_millis(20));
            assert_eq!((counted.load(Ordering::SeqCst), Arc::strong_count(&counted)), (at_end, 1), "no thread has it");
        }
    }
}
