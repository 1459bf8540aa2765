//! The spacing that particles have, where it is not the one asked for.

use brooklet_fluid::Scene;

/// What is said where the particles' spacing is not the one asked for.
pub fn other_spacing(scene: &Scene) -> Option<String> {
    let (asked_m, fitted_m) = (scene.spacing_m, scene.fitted_spacing_m());
    (asked_m != fitted_m).then(|| {
        format!("spacing {fitted_m:.5} m: the nearest to {asked_m} m of which a whole number fit from wall to wall")
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_spacing_that_was_not_asked_for_is_said() {
        let pool = |spacing: &str| Scene::load("calm-pool", &[format!("spacing_m={spacing}")]).unwrap();
        assert_eq!(other_spacing(&pool("0.05")), None);
        let said = other_spacing(&pool("0.0577")).unwrap();
        assert!(said.contains("0.05556 m") && said.contains("0.0577 m"), "{said}");
    }
}
