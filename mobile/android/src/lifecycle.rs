//! When there is a window to show something in.
//!
//! Android takes and gives the window and pauses and resumes the activity, in any order. Something is shown while both
//! are there; what was shown is dropped before the window goes.

/// What Android said.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Said {
    /// There is a window.
    Window,
    /// The window is about to go.
    NoWindow,
    /// The window has another size, or the display another rotation or density.
    Changed,
    /// The activity is in front.
    Resume,
    /// It no longer is.
    Pause,
}

/// What follows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Step {
    /// Make a surface.
    Show,
    /// Drop the surface; write what is to be kept.
    Hide,
    /// Drop the surface and make another.
    Rebuild,
}

/// Whether there is a window and the activity is in front.
#[derive(Clone, Copy, Debug, Default)]
pub struct Lifecycle {
    window: bool,
    in_front: bool,
}

impl Lifecycle {
    /// Whether something is shown.
    pub fn is_shown(self) -> bool {
        self.window && self.in_front
    }

    /// Takes what Android said, and returns what follows.
    pub fn on(&mut self, said: Said) -> Option<Step> {
        let (had_window, was) = (self.window, self.is_shown());
        match said {
            Said::Window => self.window = true,
            Said::NoWindow => self.window = false,
            Said::Resume => self.in_front = true,
            Said::Pause => self.in_front = false,
            Said::Changed => {}
        }
        match (was, self.is_shown()) {
            (false, true) => Some(Step::Show),
            (true, false) => Some(Step::Hide),
            // A window in place of another, without a word that the first went.
            (true, true) if said == Said::Changed || (said == Said::Window && had_window) => Some(Step::Rebuild),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_surface_is_made_when_both_are_there_and_dropped_when_one_goes() {
        let mut life = Lifecycle::default();
        let steps = [
            Said::Resume,
            Said::Window,
            Said::Changed,
            Said::Window,
            Said::Pause,
            Said::NoWindow,
            Said::Changed,
            Said::Window,
            Said::Resume,
            Said::NoWindow,
        ]
        .map(|said| life.on(said));
        let (show, hide, rebuild) = (Some(Step::Show), Some(Step::Hide), Some(Step::Rebuild));
        assert_eq!(steps, [None, show, rebuild, rebuild, hide, None, None, None, show, hide]);
    }

    /// Every sequence of seven: what is shown follows the steps, and nothing is shown without a window.
    #[test]
    fn no_sequence_shows_twice_or_hides_what_is_not_shown() {
        let all = [Said::Window, Said::NoWindow, Said::Changed, Said::Resume, Said::Pause];
        for sequence in 0..5_usize.pow(7) {
            let (mut life, mut surface, mut window) = (Lifecycle::default(), false, false);
            for place in 0..7 {
                let said = all[sequence / 5_usize.pow(place) % 5];
                window = said == Said::Window || (window && said != Said::NoWindow);
                match life.on(said) {
                    Some(Step::Show) => assert!(!std::mem::replace(&mut surface, true), "shown twice"),
                    Some(Step::Hide) => assert!(std::mem::replace(&mut surface, false), "hidden twice"),
                    Some(Step::Rebuild) => assert!(surface, "nothing to rebuild"),
                    None => {}
                }
                assert_eq!(surface, life.is_shown());
                assert!(window || !surface, "a surface without a window");
            }
        }
    }
}
