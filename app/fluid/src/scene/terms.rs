//! Terms that a scene's values leave out, and the scene with one of them.

use serde::Deserialize;
use toml::Value;

use super::field::Field;
use super::fields::FIELDS;
use super::settings::value_of;
use super::{Scene, paths};

impl Field {
    /// Whether a value of the field leaves its term out.
    pub(super) fn is_off(&self, value: &Value) -> bool {
        self.term.is_some_and(|term| is_same(value, &value_of(term.off)))
    }

    /// Why a term is not there: `forces.xsph = 0`.
    pub fn reason(&self) -> String {
        match self.term {
            None => String::new(),
            Some(term) if term.meaning.is_empty() => format!("{} = {}", self.path, term.off),
            Some(term) => format!("{} ({} = {})", term.meaning, self.path, term.off),
        }
    }
}

impl Scene {
    /// Each field of its method whose value leaves a term out.
    pub fn terms_left_out(&self) -> Vec<&'static Field> {
        let values = self.values();
        let is = |path: &str, text: &str| values.get(path).is_some_and(|value| is_same(value, &value_of(text)));
        let left_out = |field: &&Field| {
            field.term.is_some_and(|term| {
                is(field.path, term.off)
                    && term.needs.is_none_or(|(path, texts)| texts.iter().any(|text| is(path, text)))
            })
        };
        FIELDS.iter().filter(|field| field.is_of(self.solver.method.name())).filter(left_out).collect()
    }

    /// The scene with the term of a field in it. It is not checked: it may be one that a file may not say.
    pub fn with_term(&self, field: &Field) -> Scene {
        let with = || {
            let mut table = self.to_table().ok()?;
            paths::put(&mut table, field.path, value_of(field.term?.on));
            let mut scene = Scene::deserialize(Value::Table(table)).ok()?;
            scene.name.clone_from(&self.name);
            // What a table does not hold.
            for (solid, own) in scene.solids.iter_mut().zip(&self.solids) {
                solid.form = own.form.clone();
            }
            Some(scene)
        };
        with().unwrap_or_else(|| self.clone())
    }
}

/// Whether two values are one; 0 and 0.0 are.
fn is_same(a: &Value, b: &Value) -> bool {
    match (paths::as_number(a), paths::as_number(b)) {
        (Some(a), Some(b)) => a == b,
        _ => a == b,
    }
}

#[cfg(test)]
mod tests {
    use super::super::field::{Kind, Values};
    use super::super::fields::field_of;
    use super::super::update::UpdateRule;
    use super::*;

    #[test]
    fn a_term_leaves_solids_their_triangles() {
        let wheel = "solid=[{ wheel = { radius_m = 0.2, width_m = 0.2 }, centre_m = [0.8, 0.3, 0.3] }]";
        let scene = Scene::load("dam-break", &[wheel.into()]).unwrap();
        let left_out = scene.terms_left_out();
        assert!(!left_out.is_empty());
        for field in left_out {
            assert!(scene.with_term(field).solids[0].triangles().is_some(), "{}", field.path);
        }
    }

    /// A scene whose method has the field.
    fn of_method(field: &Field) -> Scene {
        let own = Scene::load("dam-break", &[]).unwrap();
        match field.methods.first() {
            Some(method) if !field.is_of(own.solver.method.name()) => {
                Scene::load("dam-break", &[format!("solver.method={method}")]).unwrap()
            }
            _ => own,
        }
    }

    #[test]
    fn every_term_can_be_left_out_and_brought_in() {
        let scene = Scene::load("dam-break", &[]).unwrap();
        let mut count = 0;
        for field in FIELDS {
            let Some(term) = field.term else {
                assert!(!matches!(field.update_rule, UpdateRule::Term), "{} has no term", field.path);
                continue;
            };
            count += 1;
            let scene = of_method(field);
            let scene = match term.needs {
                Some((path, values)) => scene.with_setting(&format!("{path}={}", values[0])).unwrap(),
                None => scene,
            };
            let off = scene.with_setting(&format!("{}={}", field.path, term.off)).unwrap();
            assert!(off.terms_left_out().iter().any(|out| out.path == field.path), "{}", field.path);
            let on = off.with_term(field);
            assert_ne!(on, off, "{}", field.path);
            assert_eq!(on.name, off.name);
            assert!(on.terms_left_out().iter().all(|out| out.path != field.path), "{}", field.path);
            let start = if term.meaning.is_empty() { field.path } else { term.meaning };
            assert!(field.reason().starts_with(start), "{}", field.reason());
        }
        assert!(count > 10);
        let points =
            scene.with_setting("surface.method=points").unwrap().with_setting("surface.smoothing=none").unwrap();
        assert!(points.terms_left_out().iter().all(|out| out.path != "surface.smoothing"), "points are not smoothed");
    }

    #[test]
    fn sliders_and_knobs_stay_within_what_is_allowed() {
        let mut counts = [0; 2];
        for field in FIELDS {
            if let Some(slider) = field.slider {
                let (Kind::Number(limits) | Kind::Whole(limits)) = field.kind else {
                    panic!("{} is no number", field.path)
                };
                let ends = [slider.least, slider.most];
                assert!(slider.least < slider.most && ends.iter().all(|end| limits.hold(*end)), "{}", field.path);
                assert!(!slider.logarithmic || slider.least > 0.0, "{}", field.path);
                assert_eq!(field.slider_at(1.0), Some(slider));
                counts[0] += 1;
            }
            if let Some(knob) = field.knob {
                let (values, are_numbers) = match knob.values {
                    Values::Times(factors) => (factors.len(), true),
                    Values::To(texts) => {
                        let mut scene = of_method(field);
                        if let Some(with) = knob.with {
                            scene = scene.with_setting(with).unwrap();
                        }
                        for text in texts {
                            scene.with_setting(&format!("{}={text}", field.path)).unwrap();
                        }
                        (texts.len(), matches!(field.kind, Kind::Number(_) | Kind::Whole(_)))
                    }
                };
                assert!(!are_numbers || values >= 4, "{}", field.path);
                assert!(!knob.quick.is_empty() && knob.quick.iter().all(|&index| index < values), "{}", field.path);
                counts[1] += 1;
            }
        }
        assert!(counts[0] > 15 && counts[1] > 8, "{counts:?}");
        let of = |path: &str| field_of(path).unwrap();
        assert!(of("solver.neighbour_slots").slider_at(48.0).unwrap().most >= 256.0);
        // A length goes some times up and down, within what is allowed.
        let spacing = of("spacing_m").slider_at(0.02).unwrap();
        assert_eq!((spacing.least, spacing.most, spacing.logarithmic), (0.001953125, 0.125, true));
        assert_eq!(of("spacing_m").slider_at(0.021), Some(spacing), "the ends stay while it moves");
        assert_eq!(of("spacing_m").slider_at(900.0).unwrap().most, 1.0e3);
        assert_eq!(of("domain.walls").slider_at(1.0), None);
    }
}
