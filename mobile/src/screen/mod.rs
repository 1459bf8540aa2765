//! The phone's screen: the picture over all of it, and over that what fingers reach.

mod bar;
mod look;
mod menu;
mod overlay;

use brooklet_viewer::panels::{PanelInput, PanelOutput, picture};
use brooklet_viewer::{Message, Strokes};
use egui::{Id, Order, Rect, Sense, Ui};

pub use look::apply;

/// What is open over the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sheet {
    /// Scenes to choose from.
    Scenes,
    /// Quality, self-check, facts.
    Menu,
}

/// Of a screen that is narrower, points, only the picture is shown.
const LEAST_SIDE: f32 = 200.0;

/// What a button asks the app for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ask {
    /// The attitude the phone has is level.
    Level,
    /// Known answers, once more.
    Check,
    /// A file for the owner to send.
    Report,
}

/// What of the screen is open.
#[derive(Default)]
pub struct Screen {
    /// The sheet that is up.
    pub sheet: Option<Sheet>,
    /// Whether times are shown.
    pub times: bool,
    strokes: Strokes,
}

/// What says which way is down.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Down {
    /// The accelerometer.
    Sensor,
    /// The scene: there is no sensor.
    Scene,
    /// Nothing: the scene is in free space.
    Nowhere,
}

/// What the app knows beside the viewer.
pub struct Facts<'a> {
    /// What says which way is down.
    pub down: Down,
    /// Cases of a self-check that are done, and all, while one runs.
    pub checking: Option<[usize; 2]>,
    /// How far a report is, while one is made.
    pub reporting: Option<[usize; 2]>,
    /// What the last one came to.
    pub checked: Option<String>,
    /// Whether something is wrong with the device.
    pub is_wrong: bool,
    /// Where captures are written.
    pub files: &'a str,
}

impl Screen {
    /// The back key; false if nothing is open.
    pub fn back(&mut self) -> bool {
        self.sheet.take().is_some()
    }

    /// One frame.
    pub fn show(
        &mut self,
        ui: &mut Ui,
        shown: &PanelInput<'_>,
        facts: &Facts<'_>,
        output: &mut PanelOutput,
    ) -> Vec<Ask> {
        let mut asks = Vec::new();
        picture::show(ui, shown, &mut self.strokes, output);
        let context = ui.ctx().clone();
        let screen = context.content_rect();
        // No finger finds anything there, and no button has room.
        if screen.width().min(screen.height()) < LEAST_SIDE {
            return asks;
        }
        overlay::head(&context, shown, &mut self.times);
        if self.times {
            overlay::times(&context, screen, shown);
        }
        bar::show(&context, shown, facts, &mut self.sheet, &mut output.actions, &mut asks);
        if let Some(checking) = facts.checking.filter(|_| shown.current.is_none()) {
            overlay::checking(&context, checking);
        }
        if let Some(reporting) = facts.reporting {
            overlay::reporting(&context, reporting);
        }
        if self.sheet.is_some() {
            self.open_sheet(&context, screen, shown, facts, output, &mut asks);
        }
        let said: &[Message] = shown.messages.latest();
        overlay::messages(&context, screen, said);
        asks
    }

    fn open_sheet(
        &mut self,
        context: &egui::Context,
        screen: Rect,
        shown: &PanelInput<'_>,
        facts: &Facts<'_>,
        output: &mut PanelOutput,
        asks: &mut Vec<Ask>,
    ) {
        // What lies beside the sheet closes it, and is not touched by that.
        let beside = egui::Area::new(Id::unique("beside")).fade_in(false).order(Order::Middle).fixed_pos(screen.min);
        let beside = beside.show(context, |ui| {
            ui.painter().rect_filled(screen, 0.0, egui::Color32::from_black_alpha(110));
            ui.allocate_rect(screen, Sense::click())
        });
        brooklet_viewer::marks::mark(&beside.inner, "beside");
        let closes = match self.sheet {
            Some(Sheet::Scenes) => menu::scenes(context, screen, shown, &mut output.actions),
            Some(Sheet::Menu) => menu::menu(context, screen, shown, facts, &mut output.actions, asks),
            None => false,
        };
        if closes || beside.inner.clicked() {
            self.sheet = None;
        }
    }
}
