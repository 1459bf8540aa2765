//! `brooklet scenes`: a line for each shipped scene, and the schema of scene files.

use brooklet_fluid::{scene::schema, shipped_scenes};
use serde_json::json;

use crate::{cli::ScenesOptions, failure::Failure, table::table};

/// Prints the list, or the schema.
pub fn scenes(options: &ScenesOptions) -> Result<(), Failure> {
    if options.schema {
        say!("{}", schema());
        return Ok(());
    }
    if options.json {
        let list: Vec<_> =
            shipped_scenes().map(|(name, summary)| json!({ "name": name, "summary": summary })).collect();
        say!("{}", serde_json::to_string_pretty(&list).map_err(Failure::stopped)?);
        return Ok(());
    }
    let mut list = table(&["scene", "what happens"], &[]);
    for (name, summary) in shipped_scenes() {
        list.add_row([name, summary]);
    }
    say!("{}", list.trim_fmt());
    Ok(())
}
