//! The extreme cases by solvers beside PBF: those that take a moment. All of them: `--example rows`.

use brooklet_gpu::{Gpu, Tier};
use brooklet_study::backend::Cache;
use brooklet_study::{Event, Runner, Session, State, stability};
use brooklet_tests::gpu;

const CHEAP: [&str; 7] = ["two-particles", "one-point", "capacity", "far-origin", "scale", "wrap", "thin-domain"];

#[test]
fn other_solvers_keep_what_extreme_cases_ask_for_or_say_so() {
    let open = |_: Tier, _: bool| -> Result<Gpu, String> { Ok(gpu()) };
    let (stop, notify) = (|| false, |_: Event<'_>| {});
    let runner = Runner::new(Session::new(&open, Cache::default(), &stop, &notify));
    let of_others = |task: &&brooklet_study::Task| task.settings.len() == 1 && CHEAP.contains(&task.case.as_str());
    let tasks = stability::row_tasks(false);
    let tasks: Vec<_> = tasks.iter().filter(of_others).collect();
    assert!(tasks.len() >= CHEAP.len());
    for task in tasks {
        let outcome = runner.outcome(task).unwrap().unwrap();
        println!("{} {:?}: {:?}, {}", task.case, task.settings, outcome.state, outcome.reason);
        // Sixty-four particles at one point are more than a list holds or fly apart faster than any substep's limit: clamped,
        // and said.
        let expected = match task.case.as_str() {
            "capacity" => State::Refused,
            "one-point" => State::Clamped,
            _ => State::Stable,
        };
        assert_eq!(outcome.state, expected, "{} {:?}: {:?}", task.case, task.settings, outcome.figures);
    }
}
