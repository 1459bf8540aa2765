//! Every kernel against its f64 twin: the known answers of `brooklet-check` on the tests' device, and what needs the
//! benchmarks' kernels or the whole chain.

mod bench;
mod step;

use brooklet_check::{KNOWN_ANSWERS, Verdict};

/// Runs one known answer as a test.
fn passes(room: &str, name: &str) {
    let known = KNOWN_ANSWERS.iter().find(|known| known.room == room && known.name == name).expect("it is listed");
    let outcome = brooklet_tests::device().run(known);
    outcome.notes.iter().for_each(|note| println!("{note}"));
    match outcome.verdict {
        Verdict::Right => {
            let missed = |stage: &&&str| !outcome.modules.iter().any(|run| run.stage == **stage);
            let missed: Vec<_> = known.stages.iter().filter(missed).collect();
            assert!(missed.is_empty(), "{missed:?} did not run, of {:?}", known.stages);
        }
        Verdict::Skipped(reason) => println!("skipped: {reason}"),
        Verdict::Wrong(wrong) => panic!("{wrong}"),
    }
}

macro_rules! tests {
    ($($room:ident { $($name:ident: $stages:tt,)+ })+) => {
        $(mod $room {
            $(#[test]
            fn $name() {
                super::passes(stringify!($room), stringify!($name));
            })+
        })+
    };
}

brooklet_check::for_each_known_answer!(tests);
