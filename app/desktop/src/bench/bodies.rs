//! `brooklet bench bodies` for people.

use brooklet_bench::bodies::BodiesCost;

use crate::table::table;

/// Prints everything.
pub fn print(cost: &BodiesCost) {
    say!("on {} as {}", cost.device, cost.tier);
    say!(
        "{} rounds of 4 steps each, in turns; a particle's time over the first row's in the same round\n",
        cost.rounds
    );
    let header =
        ["in the pool", "solids", "bodies", "triangles", "particles", "ms a step", "ratio", "solids", "bodies"];
    let mut list = table(&header, &[1, 2, 3, 4, 5, 6, 7, 8]);
    for row in &cost.rows {
        list.add_row([
            row.what.to_string(),
            row.solids.to_string(),
            row.bodies.to_string(),
            row.triangles.to_string(),
            row.particles.to_string(),
            format!("{:.2}", row.step_ms),
            format!("{:.3}", row.ratio),
            format!("{:.1} %", 100.0 * row.solids_share),
            format!("{:.1} %", 100.0 * row.bodies_share),
        ]);
    }
    say!("{}", list.trim_fmt());
    say!("\nthe last two columns: what stages of solids and of bodies take of a step");
}
