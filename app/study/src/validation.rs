//! Every published case that the solvers can express, as it is: its metric, the tolerance that was fixed
//! beforehand, the figure reached. What falls short is shown as falling short.

use crate::Task;
use crate::case::{CASES, OF_SPH};
use crate::method::{METHODS, Method, method};

/// Part of a study.
pub const PART: &str = "validation";

/// Cases that a quick look takes.
const QUICK: [&str; 4] = ["free-fall", "hydrostatic", "elliptical-drop", "martin-moyce"];

/// Each case with each method that has it, and which that is.
pub fn tasks(quick: bool) -> Vec<(&'static Method, Task)> {
    let wanted = |name: &str| !quick || QUICK.contains(&name);
    // What a converged run is held against is a question of error, not of validation by others.
    let published = CASES.iter().filter(|case| case.name() != "column-collapse" && wanted(case.name()));
    let methods = || METHODS.iter().filter(|method| !quick || method.few.is_empty());
    let of_all = published.flat_map(|case| methods().map(move |method| (method, *case)));
    let of_sph = OF_SPH.iter().filter(|case| wanted(case.name())).filter_map(|case| Some((method("sph")?, *case)));
    of_all
        .chain(of_sph)
        .map(|(method, case)| (method, crate::error::task(PART, case, vec![method.setting()], 1)))
        .collect()
}
