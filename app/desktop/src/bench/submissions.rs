//! `brooklet bench submissions` for people.

use brooklet_bench::submissions::Submissions;

use crate::table::table;

/// Prints everything.
pub fn print(found: &Submissions) {
    say!("{}: {} particles, on {} as {}", found.scene, found.particles, found.device, found.tier);
    say!("by the host's clock, {} rounds; the ratio to the first way of the same round\n", found.rounds);
    let header = ["steps a submission", "timestamps", "ms a step", "ratio", "10 to 90 of 100 rounds"];
    let mut list = table(&header, &[0, 2, 3]);
    for way in &found.ways {
        list.add_row([
            way.steps_a_submission.to_string(),
            if way.timestamps { "yes" } else { "no" }.to_string(),
            format!("{:.2}", way.wall_ms),
            format!("{:.3}", way.ratio[0]),
            format!("{:.3} to {:.3}", way.ratio[1], way.ratio[2]),
        ]);
    }
    say!("{}", list.trim_fmt());
}
