//! The loop around the cases, and damage that knows nothing of a format.

pub mod captures;
pub mod scenes;

use std::{
    panic::{AssertUnwindSafe, catch_unwind},
    path::{Path, PathBuf},
    sync::{Mutex, PoisonError},
    time::{Duration, Instant},
};

use brooklet_tests::rng;
use peak_alloc::PeakAlloc;
use rand::{Rng, RngExt};
use rand_chacha::ChaCha8Rng;

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

/// A case that takes longer hangs: most take milliseconds, on a busy machine too.
const HANGS: Duration = Duration::from_secs(30);

/// How long to go on.
#[derive(Clone, Copy)]
pub enum Budget {
    /// So many cases.
    Cases(u64),
    /// For a time.
    Minutes(f64),
}

impl Budget {
    /// `cases`, or as `BROOKLET_FUZZ_MINUTES` says.
    pub fn of(cases: u64) -> Self {
        match std::env::var("BROOKLET_FUZZ_MINUTES") {
            Ok(minutes) => Self::Minutes(minutes.parse().expect("BROOKLET_FUZZ_MINUTES is a number")),
            Err(_) => Self::Cases(cases),
        }
    }
}

/// What came of it.
#[derive(Clone, Copy, Debug, Default)]
pub struct Report {
    /// Cases in all.
    pub cases: u64,
    /// Those that were read.
    pub accepted: u64,
    /// Those that were refused in words.
    pub refused: u64,
}

/// A fuzzer.
pub struct Fuzz<C> {
    /// What it is called in what it prints.
    pub name: &'static str,
    /// How long.
    pub budget: Budget,
    /// Memory that a case may take.
    pub bytes: fn(&C) -> usize,
}

impl<C> Fuzz<C> {
    /// Makes and checks cases; fails with the first faults and where their inputs are kept.
    /// `check` says whether a case was read, or what is wrong with how it was.
    pub fn run(
        &self,
        make: impl Fn(&mut ChaCha8Rng) -> C,
        check: impl Fn(&C) -> Result<bool, String>,
        bytes_of: impl Fn(&C) -> Vec<u8>,
    ) -> Report {
        // One at a time: the memory is the whole process's.
        static ALONE: Mutex<()> = Mutex::new(());
        let _alone = ALONE.lock().unwrap_or_else(PoisonError::into_inner);
        let seed = std::env::var("BROOKLET_FUZZ_SEED").map_or(1, |seed| seed.parse().expect("BROOKLET_FUZZ_SEED"));
        let mut rng = rng(seed);
        let begun = Instant::now();
        let mut report = Report::default();
        let mut faults: Vec<String> = Vec::new();
        let goes_on = |report: &Report| match self.budget {
            Budget::Cases(cases) => report.cases < cases,
            Budget::Minutes(minutes) => begun.elapsed().as_secs_f64() < 60.0 * minutes,
        };
        while goes_on(&report) && faults.len() < 5 {
            let case = make(&mut rng);
            let before = MEMORY.current_usage();
            MEMORY.reset_peak_usage();
            let started = Instant::now();
            let outcome = catch_unwind(AssertUnwindSafe(|| check(&case)))
                .unwrap_or_else(|panic| Err(format!("it panics: {}", panic_text(&*panic))));
            let taken = MEMORY.peak_usage().saturating_sub(before);
            let outcome = outcome.and_then(|read| {
                let allowed = (self.bytes)(&case);
                match started.elapsed() {
                    _ if taken > allowed => Err(format!("it takes {taken} bytes; {allowed} are allowed")),
                    time if time > HANGS => Err(format!("it takes {time:?}")),
                    _ => Ok(read),
                }
            });
            report.cases += 1;
            match outcome {
                Ok(true) => report.accepted += 1,
                Ok(false) => report.refused += 1,
                Err(fault) => {
                    let path = self.keep(report.cases, &bytes_of(&case));
                    faults.push(format!("case {} of seed {seed}, in {}: {fault}", report.cases, path.display()));
                }
            }
        }
        println!("{}: {report:?} of seed {seed} in {:.1} s", self.name, begun.elapsed().as_secs_f64());
        assert!(faults.is_empty(), "{}:\n{}", self.name, faults.join("\n"));
        report
    }

    fn keep(&self, number: u64, bytes: &[u8]) -> PathBuf {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
        let path = folder.join(format!("fuzz-{}-{number}", self.name));
        std::fs::write(&path, bytes).expect("the case is kept");
        path
    }
}

fn panic_text(panic: &(dyn std::any::Any + Send)) -> String {
    let text = panic.downcast_ref::<&str>().map(|text| text.to_string());
    text.or_else(|| panic.downcast_ref::<String>().cloned()).unwrap_or_else(|| "?".into())
}

/// `bytes` with one fault: bits flipped, a piece gone, twice, or of `other`, or the end cut off.
pub fn damage(rng: &mut ChaCha8Rng, bytes: &[u8], other: &[u8]) -> Vec<u8> {
    let mut out = bytes.to_vec();
    if out.is_empty() {
        return other.to_vec();
    }
    let at = rng.random_range(0..out.len());
    let end = (at + rng.random_range(1..64)).min(out.len());
    match rng.random_range(0..7) {
        0 => out[at] ^= 1 << rng.random_range(0..8),
        1 => out[at] = rng.next_u32() as u8,
        2 => out.truncate(at),
        3 => drop(out.drain(at..end)),
        4 => {
            let piece = out[at..end].to_vec();
            drop(out.splice(at..at, piece));
        }
        5 => {
            let from = rng.random_range(0..other.len());
            let to = (from + rng.random_range(1..256)).min(other.len());
            drop(out.splice(at..end, other[from..to].iter().copied()));
        }
        _ => out[at..end].iter_mut().for_each(|byte| *byte = rng.next_u32() as u8),
    }
    out
}
