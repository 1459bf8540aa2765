//! From TOML to a checked [`Scene`].

use std::fs::File;
use std::io::{ErrorKind, Read};
use std::path::Path;

use toml::{Table, Value};

use super::fields::FIELDS;
use super::paths::value_at;
use super::sph::SUPPORT_RATIO;
use super::{Method, Scene, SceneError, auto_step, explain, methods, moved, settings, shipped};

/// The longest text that is read as a scene. A device that never ends, or a video, is none.
const MOST_BYTES: u64 = 1 << 20;

impl Scene {
    /// Reads a shipped scene by its name, or a file by its path; `settings` (`path=value`, as
    /// `solver.substeps=2` or `fluid.0.velocity_m_s=[1,0,0]`) replace values before the scene is
    /// checked.
    ///
    /// # Errors
    /// Every [`SceneError`].
    pub fn load(name_or_path: &str, settings: &[String]) -> Result<Scene, SceneError> {
        if let Some(text) = shipped::text_of(name_or_path) {
            return Self::from_toml(text, name_or_path, settings);
        }
        let unreadable = |reason: String| SceneError::Unreadable { source_name: name_or_path.into(), reason };
        let file = match File::open(name_or_path) {
            Ok(file) => file,
            Err(error) if error.kind() == ErrorKind::NotFound => return Err(shipped::unknown(name_or_path)),
            Err(error) => return Err(unreadable(error.to_string())),
        };
        let mut bytes = Vec::new();
        file.take(MOST_BYTES + 1).read_to_end(&mut bytes).map_err(|error| unreadable(error.to_string()))?;
        // Asked before UTF-8: the cut may be in the middle of a character.
        if bytes.len() as u64 > MOST_BYTES {
            return Err(unreadable(too_long()));
        }
        let text = String::from_utf8(bytes).map_err(|error| {
            let at = error.utf8_error().valid_up_to();
            unreadable(format!("its byte {at} is no UTF-8, which scene files are written in"))
        })?;
        Self::from_toml(&text, name_or_path, settings)
    }

    /// Reads a scene from its text; `source_name` is what errors call it.
    ///
    /// # Errors
    /// Every [`SceneError`] but `Unknown`.
    pub fn from_toml(text: &str, source_name: &str, settings: &[String]) -> Result<Scene, SceneError> {
        if text.len() as u64 > MOST_BYTES {
            return Err(SceneError::Unreadable { source_name: source_name.into(), reason: too_long() });
        }
        let mut table: Table = toml::from_str(text).map_err(|error| explain::syntax(&error, text, source_name))?;
        let own = table.clone();
        for setting in settings {
            settings::set(&mut table, setting)?;
        }
        if methods::chosen(&own) != methods::chosen(&table) {
            // The same scene by another method: what only its own has goes, what is asked for besides stays.
            methods::refuse_foreign(&own, text, source_name, FIELDS)?;
            let method = methods::chosen(&table).to_owned();
            table = own;
            methods::prune(&mut table, &method, FIELDS);
            for setting in settings {
                settings::set(&mut table, setting)?;
            }
        }
        let mut scene = Self::from_table(&table, text, source_name, settings.is_empty())?;
        scene.name =
            Path::new(source_name).file_stem().map_or_else(|| source_name.into(), |stem| stem.to_string_lossy().into());
        Ok(scene)
    }

    /// The checked scene of a table, without a name. `text` is what the table was read from, and `from_text` says
    /// that it is unchanged; errors find lines in it.
    pub(super) fn from_table(
        table: &Table,
        text: &str,
        source_name: &str,
        from_text: bool,
    ) -> Result<Scene, SceneError> {
        let mut table = table.clone();
        moved::refuse(&table, text, source_name)?;
        let from_text = !moved::settle_packing(&mut table, text, source_name)? && from_text;
        let from_text = !auto_step::settle(&mut table, text, source_name)? && from_text;
        methods::refuse_foreign(&table, text, source_name, FIELDS)?;
        let mut scene: Scene = serde_path_to_error::deserialize(Value::Table(table.clone()))
            .map_err(|error| explain::mismatch(&error, &table, text, source_name, from_text))?;
        if value_at(&table, SUPPORT_RATIO).is_none() {
            scene.solver.support_ratio = scene.default_support_ratio();
        }
        scene.form_solids(source_name)?;
        scene.check(source_name)?;
        if scene.solver.method == Method::Dfsph {
            // Once: gravity and dt may change while a plan's substeps stay.
            scene.solver.substeps = scene.dfsph_substeps();
            scene.check(source_name)?;
        }
        Ok(scene)
    }

    /// The scene as TOML, defaults written out: what its method has.
    pub fn to_toml(&self) -> String {
        let text = self.to_table().and_then(|table| toml::to_string(&table));
        text.unwrap_or_else(|error| format!("# not representable: {error}\n"))
    }

    /// Every field that has a value and that the scene's method has, those of defaults too.
    pub(super) fn to_table(&self) -> Result<Table, toml::ser::Error> {
        let mut table = Table::try_from(self)?;
        methods::prune(&mut table, self.solver.method.name(), FIELDS);
        Ok(table)
    }
}

fn too_long() -> String {
    format!("it has more than the {MOST_BYTES} bytes that a scene may have")
}
