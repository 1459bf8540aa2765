//! Every published case that the solvers can express, as it is: its metric, the tolerance that was fixed
//! beforehand, the figure reached. What falls short is shown as falling short.

use crate::Task;
use crate::case::{CASES, OF_SPH};
use crate::method::METHODS;

/// Part of a study.
pub const PART: &str = "validation";

/// Cases that a quick look takes.
const QUICK: [&str; 4] = ["free-fall", "hydrostatic", "elliptical-drop", "martin-moyce"];

/// Each case with each method.
pub fn tasks(quick: bool) -> Vec<Task> {
    let wanted = |name: &str| !quick || QUICK.contains(&name);
    // What a converged run is held against is a question of error, not of validation by others.
    let published = CASES.iter().filter(|case| case.name() != "column-collapse" && wanted(case.name()));
    let of_sph = OF_SPH.iter().filter(|case| wanted(case.name()));
    let of_sph = of_sph.map(|case| crate::error::task(PART, *case, vec!["solver.method=sph".into()], 1));
    let methods = || METHODS.iter().filter(|method| !quick || method.few.is_empty());
    published
        .flat_map(|case| methods().map(|method| crate::error::task(PART, *case, vec![method.setting()], 1)))
        .chain(of_sph)
        .collect()
}
