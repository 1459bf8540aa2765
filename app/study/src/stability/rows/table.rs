//! The table.

use super::{Also, Row, setups};

const fn runs(
    number: u32,
    name: &'static str,
    expected: &'static str,
    setup: fn(&[String]) -> crate::SetupResult,
    also: Also,
) -> Row {
    Row { number, name, expected, setup, also, injected: 0, needs: "" }
}

/// Every extreme case, in order.
pub const ROWS: &[Row] = &[
    runs(1, "two-particles", "free fall exact to rounding", setups::two_particles, Also::EqualsTwin(2.0e-4)),
    runs(
        2,
        "one-point",
        "64 particles at one point part, no NaN, speed within the limit",
        setups::one_point,
        Also::Rests,
    ),
    runs(3, "one-cell", "1,000 particles in one cell: counted, no loss; at rest later", setups::one_cell, Also::Rests),
    runs(
        4,
        "list-overflow",
        "more neighbours than slots are counted",
        setups::list_overflow,
        Also::Figures(setups::overflow_counted),
    ),
    runs(5, "capacity", "more particles than ids: refused with a reason", setups::capacity, Also::Refused),
    runs(
        6,
        "far-origin",
        "10 km from the origin: as at the origin",
        setups::far_origin,
        Also::Equals(setups::at_origin, 1.0, 1.0e-3),
    ),
    runs(
        7,
        "scale",
        "a thousand times as large: as at its own size",
        setups::large,
        Also::Equals(setups::at_origin, 1024.0, 2.0e-3),
    ),
    runs(
        8,
        "dt-times-10",
        "100 times the compression, by the column law, at most; as before where an equation of state has it",
        setups::long_steps,
        Also::Figures(setups::within_the_law),
    ),
    Row {
        number: 9,
        name: "stiffness-times-1000",
        expected: "stable with a step by √1000 shorter",
        setup: setups::stiff,
        also: Also::Rests,
        injected: 0,
        needs: "stiffness_m2_s2",
    },
    runs(
        10,
        "viscosity-times-1000",
        "XSPH c = 1 is bounded, and rests; a viscosity takes as short steps as it needs",
        setups::viscous,
        Also::Rests,
    ),
    runs(
        11,
        "density-ratio",
        "bodies a tenth and ten times as dense as water: one floats, one lies on the floor",
        setups::density_ratio,
        Also::Rests,
    ),
    runs(
        12,
        "tall-column",
        "200 layers in 2-D: the column law within 20 %, at most where a tolerance ends iterations, or the equation of state",
        setups::tall_column,
        Also::Figures(setups::law_holds),
    ),
    runs(13, "sheet", "one layer falls on the floor: no clumping", setups::sheet, Also::Figures(setups::no_clumps)),
    runs(
        14,
        "jet",
        "a jet at 100 m/s passes nothing; clamps counted where the limit is below",
        setups::jet,
        Also::Figures(setups::nothing_passes),
    ),
    runs(
        15,
        "wrap",
        "two drops a wrapped grid apart: each as if alone",
        setups::two_drops,
        Also::Figures(setups::drops_alike),
    ),
    runs(
        16,
        "thin-domain",
        "fewer than three cells along an axis: as the f64 twin",
        setups::thin,
        Also::EqualsTwin(0.02),
    ),
    Row {
        number: 17,
        name: "not-finite",
        expected: "three particles that are not finite are quarantined and spread nothing",
        setup: setups::not_finite,
        also: Also::Rests,
        injected: 3,
        needs: "",
    },
    runs(
        18,
        "f16-range",
        "300 m/s, whose square f16 does not hold: no overflow",
        setups::fast,
        Also::Figures(setups::momentum_kept),
    ),
    runs(
        19,
        "moving-wall",
        "a wall that moves a spacing in a step, the most that is allowed: nobody leaves faster than twice the wall",
        setups::moving_wall,
        Also::Figures(setups::bounded_ejection),
    ),
    runs(
        20,
        "lattice-at-rest",
        "1,000 particles, 10,000 steps: energy decays, no drift",
        setups::at_rest,
        Also::Figures(setups::stays),
    ),
    runs(21, "corner", "a block thrown into a corner: no pile-up, no late ejection", setups::corner, Also::Rests),
];
