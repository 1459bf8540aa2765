//! `brooklet bench papers` for people.

use brooklet_bench::papers::{Papers, Published, Row};

use crate::table::table;

/// Prints the table, a row more for each further paper.
pub fn print(papers: &Papers) {
    say!("a block of water at rest in a box, h = 2d, on {} ({}) as {}", papers.device, papers.driver, papers.tier);
    if papers.device_type == "cpu" {
        say!("(this driver runs on the processor: its times are the processor's)");
    }
    let header =
        ["particles", "solver", "steps", "step ms", "p95 ms", "s a s", "B/particle", "paper's ms", "paper", "what"];
    let mut list = table(&header, &[0, 2, 3, 4, 5, 6, 7]);
    for row in &papers.rows {
        let published = row.published.iter().map(Some);
        let published = if row.published.is_empty() { vec![None] } else { published.collect() };
        for (nth, published) in published.into_iter().enumerate() {
            list.add_row(cells(row, published, nth == 0));
        }
    }
    say!("\n{}", list.trim_fmt());
    say!(
        "(s a s: seconds a simulated second; sph in one substep a step of the length that its sound allows, pbf with 6\n\
         iterations and a step by the column law. The papers' own steps, supports and neighbours are others'.)"
    );
    for left_out in &papers.left_out {
        say!("left out: {} particles: {}", left_out.particles, left_out.reason);
    }
}

fn cells(row: &Row, published: Option<&Published>, is_first: bool) -> [String; 10] {
    let once = |text: String| if is_first { text } else { String::new() };
    let of = |text: fn(&Published) -> String| published.map_or_else(|| "-".into(), text);
    [
        once(row.particles.to_string()),
        once(row.method.to_string()),
        once(row.steps.to_string()),
        once(format!("{:.2}", row.step_ms.median)),
        once(format!("{:.2}", row.step_ms.p95)),
        once(format!("{:.2}", row.s_per_s)),
        once(format!("{:.0}", row.bytes_per_particle)),
        of(|published| published.step_ms.map_or_else(|| "-".into(), |ms| format!("{ms:.1}"))),
        of(|published| format!("{}, {}", published.paper, published.card)),
        of(|published| published.what.to_string()),
    ]
}
