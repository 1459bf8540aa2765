//! Where each control is on the screen, by name: for tests that use the window as a person does, and
//! for whoever drives it from outside.

use std::collections::BTreeMap;

use egui::{Context, Id, Rect, Response};

/// Controls of the last frame, in points.
pub type Marks = BTreeMap<String, Rect>;

fn id() -> Id {
    Id::unique("brooklet marks")
}

/// Notes a control under a name.
pub fn mark(response: &Response, name: &str) {
    response.ctx.data_mut(|data| {
        data.get_temp_mut_or_default::<Marks>(id()).insert(name.to_owned(), response.rect);
    });
}

/// Those noted since the last call.
pub fn take(context: &Context) -> Marks {
    context.data_mut(|data| std::mem::take(data.get_temp_mut_or_default::<Marks>(id())))
}
