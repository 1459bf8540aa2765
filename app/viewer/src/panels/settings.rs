//! The scene's settings: every field of its file that means something in a window.

use brooklet_fluid::scene::{EmitterSettings, Kind, Limits, Setting, Slider as Ends, Update};
use brooklet_fluid::{Scene, SceneError};
use egui::{CollapsingHeader, ComboBox, DragValue, Grid, Response, RichText, Slider, SliderClamping, Ui};
use toml::Value;

use crate::action::Action;
use crate::marks::mark;
use crate::style;

/// The settings as they are being edited.
pub struct Draft {
    /// The scene with them.
    pub scene: Scene,
    settings: Vec<Setting>,
    refused: Option<String>,
}

/// Room for a setting's name, points.
const NAME_WIDTH: f32 = 118.0;

/// A section's title, its name for marks, and which fields it holds.
type Section = (&'static str, &'static str, fn(&str) -> bool);

const SECTIONS: [Section; 5] = [
    ("Scene", "scene", |path| path == "spacing_m" || path.starts_with("domain") || path.starts_with("fluid")),
    ("Gravity", "gravity", |path| path == "gravity_m_s2"),
    ("Solver", "solver", |path| {
        path.starts_with("solver.") || path.starts_with("forces.") || path == "outputs.measure_every_steps"
    }),
    ("Surface", "surface", |path| path.starts_with("surface.")),
    ("Spray and foam", "diffuse", |path| path.starts_with("diffuse.")),
];

impl Draft {
    /// A scene's settings as they are.
    pub fn new(scene: Scene) -> Self {
        Self { settings: scene.settings(), scene, refused: None }
    }

    pub(super) fn show(&mut self, ui: &mut Ui, actions: &mut Vec<Action>) {
        let mut wished = None;
        for (title, name, holds) in SECTIONS {
            let header = CollapsingHeader::new(title).default_open(name == "solver").show(ui, |ui| {
                if name == "gravity" {
                    directions(ui, &self.scene, &mut wished);
                }
                for setting in self.settings.iter().filter(|setting| holds(&setting.path)) {
                    row(ui, setting, &mut wished);
                }
            });
            mark(&header.header_response, &format!("section {name}"));
        }
        if let Some(refused) = &self.refused {
            ui.label(RichText::new(refused).small().color(style::ERROR));
        }
        if let Some(wish) = wished {
            self.take(&wish, actions);
        }
    }

    /// Takes other emitters.
    pub(super) fn take_emitters(&mut self, emitters: Vec<EmitterSettings>, is_final: bool, actions: &mut Vec<Action>) {
        // The slots stay: the particles in them do.
        let taken = self.scene.with_emitters(emitters, self.scene.slot_capacity());
        self.take_scene(taken, is_final, actions);
    }

    fn take(&mut self, wish: &Wish, actions: &mut Vec<Action>) {
        self.take_scene(self.scene.with_setting(&wish.setting), wish.is_final, actions);
    }

    fn take_scene(&mut self, taken: Result<Scene, SceneError>, is_final: bool, actions: &mut Vec<Action>) {
        match taken {
            Ok(scene) => {
                *self = Self::new(scene);
                if is_final {
                    actions.push(Action::Apply(Box::new(self.scene.clone())));
                }
            }
            Err(error) => self.refused = Some(error.to_string()),
        }
    }
}

/// A value that was chosen.
struct Wish {
    /// `path=value`.
    setting: String,
    /// Whether it is applied now; a slider that is still being dragged waits where a new plan is needed.
    is_final: bool,
}

fn row(ui: &mut Ui, setting: &Setting, wished: &mut Option<Wish>) {
    ui.horizontal(|ui| {
        // A fluid's block and the domain have fields of one name.
        let name = match setting.path.split_once('.') {
            Some(("solver" | "forces" | "surface", below)) => below.rsplit('.').next().unwrap_or(below),
            _ => &setting.path,
        };
        let when = match (setting.update, setting.at_zero) {
            (Update::Reset, _) => "from the next reset on",
            (Update::Rebuild, _) => "at once, with another plan",
            (Update::Live, Update::Live) => "at once",
            (Update::Live, _) => "at once; from and to 0 with another plan",
        };
        let sign = if setting.update == Update::Reset { " ⟲" } else { "" };
        let (place, label) = ui.allocate_exact_size(egui::vec2(NAME_WIDTH, 18.0), egui::Sense::hover());
        let font = egui::TextStyle::Small.resolve(ui.style());
        let text = ui.painter().with_clip_rect(place);
        text.text(
            place.left_center(),
            egui::Align2::LEFT_CENTER,
            format!("{name}{sign}"),
            font,
            ui.visuals().text_color(),
        );
        label.on_hover_text(format!("{}: {}\nTaken {when}.", setting.path, setting.doc));
        let Some((response, value)) = edit(ui, setting) else { return };
        let Some(value) = value else { return };
        let is_final = setting.update == Update::Live || !response.dragged();
        *wished = Some(Wish { setting: format!("{}={value}", setting.path), is_final });
    });
}

/// The control of a setting, and the value it was given, as TOML.
fn edit(ui: &mut Ui, setting: &Setting) -> Option<(Response, Option<String>)> {
    let path = setting.path.as_str();
    match (setting.kind, setting.slider) {
        (Kind::Number(limits), Some(ends)) => Some(number(ui, setting, limits, ends)),
        (Kind::Whole(limits), Some(ends)) => Some(whole(ui, setting, limits, ends)),
        (Kind::Choice(names), _) => Some(choice(ui, path, setting.value.as_ref().and_then(Value::as_str), names)),
        (Kind::Switch, _) => {
            let mut on = setting.value.as_ref().and_then(Value::as_bool).unwrap_or(false);
            let response = ui.checkbox(&mut on, "");
            mark(&response, path);
            let changed = response.changed().then(|| on.to_string());
            Some((response, changed))
        }
        (Kind::Vector(limits), _) => Some(vector(ui, setting, limits)),
        (Kind::Switches, _) => Some(switches(ui, setting)),
        // Every number has a slider.
        (Kind::Number(_) | Kind::Whole(_) | Kind::Vectors(_) | Kind::Text | Kind::Table | Kind::Tables, _) => None,
    }
}

fn number(ui: &mut Ui, setting: &Setting, limits: Limits, ends: Ends) -> (Response, Option<String>) {
    let path = setting.path.as_str();
    let is_set = setting.value.is_some();
    let mut value = setting.value.as_ref().and_then(as_number).unwrap_or(0.0);
    let slider = Slider::new(&mut value, ends.least..=ends.most)
        .logarithmic(ends.logarithmic)
        .clamping(SliderClamping::Never)
        .max_decimals(6)
        .custom_formatter(move |value, _| if is_set { short(value) } else { "auto".into() })
        .suffix(suffix(limits.unit));
    let response = ui.add(slider);
    mark(&response, path);
    let wish = (response.changed() || response.drag_stopped())
        .then(|| format!("{:?}", value.clamp(limits.least, limits.most)));
    (response, wish)
}

fn whole(ui: &mut Ui, setting: &Setting, limits: Limits, ends: Ends) -> (Response, Option<String>) {
    let path = setting.path.as_str();
    let is_set = setting.value.is_some();
    let mut value = setting.value.as_ref().and_then(Value::as_integer).unwrap_or(limits.least as i64);
    let slider = Slider::new(&mut value, ends.least as i64..=ends.most as i64)
        .clamping(SliderClamping::Never)
        .custom_formatter(move |value, _| if is_set { format!("{value:.0}") } else { "auto".into() })
        .suffix(suffix(limits.unit));
    let response = ui.add(slider);
    mark(&response, path);
    let value = value.clamp(limits.least as i64, limits.most as i64);
    let wish = (response.changed() || response.drag_stopped()).then(|| value.to_string());
    (response, wish)
}

fn choice(ui: &mut Ui, path: &str, current: Option<&str>, names: &[&str]) -> (Response, Option<String>) {
    let mut chosen = None;
    let list = ComboBox::from_id_salt(path).selected_text(current.unwrap_or("auto")).width(128.0).show_ui(ui, |ui| {
        for name in names {
            let response = ui.selectable_label(Some(*name) == current, *name);
            mark(&response, &format!("{path} {name}"));
            if response.clicked() && Some(*name) != current {
                chosen = Some(format!("{name:?}"));
            }
        }
    });
    mark(&list.response, path);
    (list.response, chosen)
}

fn vector(ui: &mut Ui, setting: &Setting, limits: Limits) -> (Response, Option<String>) {
    let read = |axis: usize| setting.value.as_ref()?.as_array()?.get(axis).and_then(as_number);
    let is_set = setting.value.is_some();
    let mut values: [f64; 3] = std::array::from_fn(|axis| read(axis).unwrap_or(0.0));
    let size = values.iter().fold(0.0f64, |most, value| most.max(value.abs()));
    let mut all: Option<Response> = None;
    let shown = Grid::new(&setting.path).num_columns(3).spacing([3.0, 0.0]).show(ui, |ui| {
        for (axis, value) in ["x", "y", "z"].iter().zip(&mut values) {
            let drag = DragValue::new(value)
                .speed(0.005 * size.max(0.2))
                .range(limits.least..=limits.most)
                .max_decimals(3)
                .custom_formatter(move |value, _| if is_set { short(value) } else { "·".into() });
            let response = ui.add_sized([46.0, 18.0], drag).on_hover_text(format!("{axis} {}", limits.unit));
            mark(&response, &format!("{}.{axis}", setting.path));
            all = Some(match all.take() {
                Some(others) => others | response,
                None => response,
            });
        }
    });
    let response = all.unwrap_or(shown.response);
    let wish = (response.changed() || response.drag_stopped()).then(|| format!("{values:?}"));
    (response, wish)
}

fn switches(ui: &mut Ui, setting: &Setting) -> (Response, Option<String>) {
    let read = |axis: usize| setting.value.as_ref()?.as_array()?.get(axis)?.as_bool();
    let mut values: [bool; 3] = std::array::from_fn(|axis| read(axis).unwrap_or(false));
    let mut changed = false;
    let shown = ui.horizontal(|ui| {
        for (axis, value) in ["x", "y", "z"].iter().zip(&mut values) {
            let response = ui.checkbox(value, *axis);
            mark(&response, &format!("{}.{axis}", setting.path));
            changed |= response.changed();
        }
    });
    (shown.response, changed.then(|| format!("{values:?}")))
}

/// Gravity by one click.
fn directions(ui: &mut Ui, scene: &Scene, wished: &mut Option<Wish>) {
    let [x, y, z] = scene.gravity_m_s2;
    let size = (x * x + y * y + z * z).sqrt();
    let size = if size > 0.0 { size } else { 9.81 };
    let ways = [
        ("⬇", [0.0, -size, 0.0]),
        ("⬅", [-size, 0.0, 0.0]),
        ("➡", [size, 0.0, 0.0]),
        ("⬆", [0.0, size, 0.0]),
        ("none", [0.0; 3]),
    ];
    ui.horizontal(|ui| {
        for (sign, gravity) in ways {
            let response = ui.button(sign);
            mark(&response, &format!("gravity {sign}"));
            if response.clicked() {
                *wished = Some(Wish { setting: format!("gravity_m_s2={gravity:?}"), is_final: true });
            }
        }
    });
}

fn as_number(value: &Value) -> Option<f64> {
    value.as_float().or_else(|| value.as_integer().map(|whole| whole as f64))
}

fn suffix(unit: &str) -> String {
    if unit.is_empty() { String::new() } else { format!(" {unit}") }
}

/// Three digits that say something.
fn short(value: f64) -> String {
    let size = value.abs();
    if size != 0.0 && !(1e-3..1e4).contains(&size) {
        return format!("{value:.2e}");
    }
    let decimals = if size >= 100.0 {
        0
    } else if size >= 10.0 {
        1
    } else if size >= 0.1 || size == 0.0 {
        2
    } else {
        4
    };
    format!("{value:.decimals$}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_setting_has_a_place_or_a_reason() {
        // A window has its own size and camera, no end, and activates no particles; names are for people.
        let elsewhere =
            ["summary", "capacity", "camera.", "outputs.seconds", "outputs.images", "outputs.width", "outputs.height"];
        for scene in ["dam-break", "falling-balls"] {
            for setting in Scene::load(scene, &[]).unwrap().settings() {
                let sections = SECTIONS.iter().filter(|(.., holds)| holds(&setting.path)).count();
                let is_elsewhere = elsewhere.iter().any(|start| setting.path.starts_with(start));
                assert_eq!(sections, usize::from(!is_elsewhere), "{}", setting.path);
            }
        }
    }

    #[test]
    fn a_wish_that_is_not_allowed_is_said_and_nothing_is_asked_for() {
        let mut draft = Draft::new(Scene::load("dam-break", &[]).unwrap());
        let before = draft.scene.clone();
        let mut actions = Vec::new();
        draft.take(&Wish { setting: "solver.pbf.relaxation=7".into(), is_final: true }, &mut actions);
        assert!(actions.is_empty() && draft.scene == before);
        assert!(draft.refused.as_ref().unwrap().contains("solver.pbf.relaxation"));
        draft.take(&Wish { setting: "solver.pbf.relaxation=0.7".into(), is_final: true }, &mut actions);
        assert!(draft.refused.is_none() && draft.scene.solver.pbf.relaxation == Some(0.7));
        assert_eq!(actions, [Action::Apply(Box::new(draft.scene.clone()))]);
    }

    #[test]
    fn an_emitter_that_goes_leaves_the_slots_and_a_bad_one_is_said() {
        let mut draft = Draft::new(Scene::load("faucet", &[]).unwrap());
        let (before, mut actions) = (draft.scene.clone(), Vec::new());
        let up = EmitterSettings { direction: [0.0; 3], ..before.emitters[0].clone() };
        draft.take_emitters(vec![up], true, &mut actions);
        assert!(actions.is_empty() && draft.refused.as_ref().unwrap().contains("emitter.0.direction"));
        draft.take_emitters(Vec::new(), true, &mut actions);
        assert!(draft.scene.emitters.is_empty() && draft.refused.is_none());
        assert_eq!(draft.scene.slot_capacity(), before.slot_capacity());
        assert_eq!(actions, [Action::Apply(Box::new(draft.scene.clone()))]);
    }

    #[test]
    fn numbers_are_short() {
        let texts = [0.0, 0.5, 0.0041667, 9.81, 12.345, 1000.0, 1e-6, 2.5e7].map(short);
        assert_eq!(texts, ["0.00", "0.50", "0.0042", "9.81", "12.3", "1000", "1.00e-6", "2.50e7"]);
    }
}
