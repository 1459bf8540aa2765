//! `brooklet scenes`: a line for each shipped scene.

use brooklet_fluid::shipped_scenes;
use serde_json::json;

use crate::{cli::ListOptions, failure::Failure, table::table};

/// Prints the list.
pub fn scenes(options: &ListOptions) -> Result<(), Failure> {
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
