//! `brooklet bench` for people: the table over the number of particles.

use brooklet_bench::{
    figures::{Pass, Row, Scaling},
    workload::LOADS,
};

use crate::table::table;

/// Prints everything.
pub fn print(scaling: &Scaling) {
    say!("a block of water at rest in a box, h = 2d, on {} as {}", scaling.device, scaling.tier);
    if scaling.device_type == "cpu" {
        say!("(this driver runs on the processor: its times are the processor's)");
    }
    let rates = &scaling.rates;
    say!(
        "a copy moves {:.1} GB/s, read and written; {:.2} G elements of 8 bytes gathered a second; {:.1} G\n\
         multiplications with an addition; {:.1} us a dispatch behind another\n",
        rates.copy_bytes_per_s * 1e-9,
        rates.gathers_per_s * 1e-9,
        rates.multiply_adds_per_s * 1e-9,
        rates.launch_s * 1e6
    );
    print_sizes(&scaling.rows);
    for load in LOADS {
        let rows: Vec<&Row> = scaling.rows.iter().filter(|row| row.is_of(load)).collect();
        if let Some(first) = rows.first() {
            say!("\n{}, {} iterations a step: median ms (95 of 100)\n", first.terms, first.iterations);
            print_passes(&rows, |pass| {
                let (Some(median), Some(p95)) = (pass.times.median_ms, pass.times.p95_ms) else { return "-".into() };
                format!("{median:.2} ({p95:.2})")
            });
            say!("\n... GB/s of compulsory bytes / with gathers; the nearest bound, and how near\n");
            print_passes(&rows, |pass| {
                let share = 100.0 * pass.share_of_bound;
                let (bytes, gathers_too) = (pass.gb_per_s, pass.gb_per_s_gathers_too);
                format!("{bytes:.1} / {gathers_too:.1} ({} {share:.0} %)", pass.nearest.word())
            });
        }
    }
    say!(
        "\nA pass's compulsory bytes are its buffers, each once a dispatch; its gathers are an element of each\n\
         neighbour in the list. Of four bounds (the copy's time for its bytes, gathers, arithmetic of pairs, empty\n\
         dispatches) the nearest is named: 100 % is as fast as the device can; above, it finds in caches what\n\
         counts as memory's.\n"
    );
    let mut list = table(&["target", "", "measured", ""], &[1, 2]);
    for verdict in &scaling.targets {
        let number = |value: f64| if value >= 1e5 { format!("{:.2} M", value * 1e-6) } else { format!("{value:.2}") };
        let bound = if verdict.at_least { "at least" } else { "at most" };
        list.add_row([
            verdict.name.clone(),
            format!("{bound} {}", number(verdict.target)),
            number(verdict.measured),
            if verdict.met { "met" } else { "missed" }.to_string(),
        ]);
    }
    say!("{}", list.trim_fmt());
    let flagged: u64 = scaling.rows.iter().map(|row| row.flagged_spans).sum();
    if flagged > 0 {
        say!("{flagged} of the GPU's times are in doubt (zero, negative, overlapping, or behind a gap)");
    }
    for left_out in &scaling.left_out {
        say!("left out: {} particles: {}", left_out.particles, left_out.reason);
    }
}

fn print_sizes(rows: &[Row]) {
    let header = [
        "particles",
        "terms",
        "iterations",
        "steps",
        "step ms",
        "p95 ms",
        "M/s",
        "ns",
        "grid",
        "neighbours",
        "B/particle",
        "furthest from its bound",
    ];
    let mut list = table(&header, &[0, 2, 3, 4, 5, 6, 7, 8, 9, 10]);
    for row in rows {
        list.add_row([
            row.particles.to_string(),
            row.terms.to_string(),
            row.iterations.to_string(),
            row.steps.to_string(),
            format!("{:.2}", row.step_ms.median),
            format!("{:.2}", row.step_ms.p95),
            format!("{:.2}", row.particle_iterations_per_s * 1e-6),
            format!("{:.0}", row.ns_per_particle_iteration),
            format!("{:.1} %", 100.0 * row.grid_share),
            format!("{:.1}", row.neighbours_mean),
            format!("{:.0}", row.bytes_per_particle),
            row.furthest_from_bound.unwrap_or("-").to_string(),
        ]);
    }
    say!("{}", list.trim_fmt());
    say!("(M/s: million particle iterations a second; ns: for one; measuring is in both where it is on)");
}

fn print_passes(rows: &[&Row], cell: impl Fn(&Pass) -> String) {
    let header: Vec<String> =
        std::iter::once("pass".to_string()).chain(rows.iter().map(|row| row.particles.to_string())).collect();
    let numbers: Vec<usize> = (1..header.len()).collect();
    let mut list = table(&header.iter().map(String::as_str).collect::<Vec<_>>(), &numbers);
    let mut stages: Vec<&str> = Vec::new();
    for (stage, _) in rows.iter().flat_map(|row| &row.passes.0) {
        if !stages.contains(stage) {
            stages.push(stage);
        }
    }
    for stage in stages {
        let cells = rows.iter().map(|row| {
            let pass = row.passes.0.iter().find(|(name, _)| *name == stage);
            pass.map_or_else(|| "-".into(), |(_, pass)| cell(pass))
        });
        list.add_row(std::iter::once(stage.to_string()).chain(cells));
    }
    say!("{}", list.trim_fmt());
}
