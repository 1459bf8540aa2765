//! Keys that only some methods have: which of a scene belong to another method than its own.

use toml::{Table, Value};

use super::SceneError;
use super::explain::{place_of, shortened, written};
use super::field::{Field, Kind};
use super::paths::{matching, take, value_at};
use super::solver::Method;

/// The method that a table chooses.
pub(super) fn chosen(table: &Table) -> &str {
    value_at(table, "solver.method").and_then(Value::as_str).unwrap_or(Method::default().name())
}

/// Refuses keys of other methods than the table's own. A method that is not there is for the reader to refuse.
pub(super) fn refuse_foreign(table: &Table, text: &str, source_name: &str, fields: &[Field]) -> Result<(), SceneError> {
    let method = chosen(table);
    let known = |field: &Field| matches!(field.kind, Kind::Choice(names) if names.contains(&method));
    if !fields.iter().any(|field| field.path == "solver.method" && known(field)) {
        return Ok(());
    }
    let foreign: Vec<(String, &Field)> = fields
        .iter()
        .filter(|field| !field.is_of(method))
        .flat_map(|field| matching(table, field.path).into_iter().map(move |path| (path, field)))
        .collect();
    // A table's keys say more than the table.
    let is_key = |(_, field): &&(String, &Field)| !matches!(field.kind, Kind::Table | Kind::Tables);
    let Some((path, field)) = foreign.iter().find(is_key).or(foreign.first()) else { return Ok(()) };
    let value = value_at(table, path).map_or_else(String::new, |value| shortened(&written(value)));
    Err(SceneError::NotAllowed {
        source_name: source_name.into(),
        place: place_of(text, path),
        field: path.clone(),
        value,
        allowed: format!("not with solver.method = {method:?}; methods that have it: {}", field.methods.join(", ")),
    })
}

/// Takes what other methods have out of a table, and tables that nothing is left in.
pub(super) fn prune(table: &mut Table, method: &str, fields: &[Field]) {
    for field in fields.iter().filter(|field| !field.is_of(method)) {
        for path in matching(table, field.path) {
            take(table, &path);
            let above = path.rsplit_once('.').map(|(above, _)| above);
            if let Some(above) = above
                && matches!(value_at(table, above), Some(Value::Table(left)) if left.is_empty())
            {
                take(table, above);
            }
        }
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::scene::Update;
    use crate::scene::fields::FIELDS;
    use crate::scene::update::UpdateRule;

    const LIVE: UpdateRule = UpdateRule::Always(Update::Live);
    /// A table of settings with two methods more than there are.
    pub(in super::super) const MORE: &[Field] = &[
        Field::new("solver", Kind::Table, LIVE),
        Field::new("solver.method", Kind::Choice(&["pbf", "none", "sph"]), LIVE),
        Field::new("solver.dt_s", Kind::Switch, LIVE),
        Field::new("solver.pbf", Kind::Table, LIVE).of(&["pbf"]),
        Field::new("solver.pbf.iterations", Kind::Switch, LIVE).of(&["pbf"]),
        Field::new("forces", Kind::Table, LIVE),
        Field::new("forces.xsph", Kind::Switch, LIVE).of(&["pbf", "sph"]),
        Field::new("forces.drag", Kind::Switch, LIVE).of(&["none"]),
        Field::new("fluid.*.lifetime_s", Kind::Switch, LIVE).of(&["none"]),
    ];

    fn refused(text: &str, fields: &[Field]) -> Option<String> {
        let table = toml::from_str(text).unwrap();
        refuse_foreign(&table, text, "sparks.toml", fields).err().map(|error| error.to_string())
    }

    #[test]
    fn a_key_of_another_method_is_named_with_the_methods_that_have_it() {
        let method = |name: &str, rest: &str| format!("[solver]\nmethod = \"{name}\"\ndt_s = 1\n{rest}");
        let xsph = "[forces]\nxsph = 0.5\n";
        for (text, words) in [
            (
                method("none", xsph),
                "sparks.toml:5:1: forces.xsph = 0.5: not with solver.method = \"none\"; methods that have it: pbf, sph",
            ),
            (
                method("none", "pbf = {}"),
                "sparks.toml:4:1: solver.pbf = {}: not with solver.method = \"none\"; methods that have it: pbf",
            ),
            (
                method("sph", "[solver.pbf]\nother = 1\niterations = 4"),
                "sparks.toml:6:1: solver.pbf.iterations = 4: not with",
            ),
            (
                "forces.drag = 1".to_owned(),
                "sparks.toml:1:8: forces.drag = 1: not with solver.method = \"pbf\"; methods that have it: none",
            ),
            ("fluid = [{}, { lifetime_s = 2 }]".to_owned(), "sparks.toml: fluid.1.lifetime_s = 2: not with"),
        ] {
            let message = refused(&text, MORE).unwrap_or_else(|| panic!("{text:?} is not refused"));
            assert!(message.starts_with(&format!("scene {words}")), "{message}");
        }
        for text in [
            method("pbf", "[solver.pbf]\niterations = 4\n[forces]\nxsph = 0"),
            method("sph", xsph),
            // For the reader to refuse.
            method("no-such", "[solver.pbf]\niterations = 4"),
        ] {
            assert_eq!(refused(&text, MORE), None, "{text}");
        }
    }

    #[test]
    fn what_another_method_has_is_left_out_and_no_empty_table_stays() {
        let text = "[solver]\nmethod = \"none\"\ndt_s = 1\n[solver.pbf]\niterations = 4\n[forces]\nxsph = 1\n[[fluid]]\nlifetime_s = 2\n";
        let all: Table = toml::from_str(text).unwrap();
        let left = |method: &str| {
            let mut table = all.clone();
            prune(&mut table, method, MORE);
            let paths = ["solver.dt_s", "solver.pbf", "forces", "forces.xsph", "fluid.0.lifetime_s"];
            paths.into_iter().filter(|path| value_at(&table, path).is_some()).collect::<Vec<_>>()
        };
        assert_eq!(left("none"), ["solver.dt_s", "fluid.0.lifetime_s"]);
        assert_eq!(left("sph"), ["solver.dt_s", "forces", "forces.xsph"]);
        assert_eq!(left("pbf"), ["solver.dt_s", "solver.pbf", "forces", "forces.xsph"]);
    }

    #[test]
    fn methods_that_interact_are_those_with_neighbours() {
        let all = [Method::Pbf, Method::Sph, Method::Dfsph, Method::None];
        assert_eq!(all.map(Method::name), Method::NAMES);
        let slots = FIELDS.iter().find(|field| field.path == "solver.neighbour_slots").unwrap();
        for method in all {
            assert_eq!(slots.is_of(method.name()), method.interacts(), "{}", method.name());
        }
    }

    #[test]
    fn fields_name_methods_that_there_are() {
        for field in FIELDS {
            assert!(field.methods.iter().all(|name| Method::NAMES.contains(name)), "{}", field.path);
        }
    }
}
