//! Android's motion events as touches.

use brooklet_mobile::{TouchEvent, TouchPhase};

/// What a motion event says, `AMOTION_EVENT_ACTION_*`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Motion {
    /// `DOWN` and `POINTER_DOWN`: the pointer of this index came.
    Down(usize),
    /// `MOVE`: any of them moved.
    Move,
    /// `UP` and `POINTER_UP`: the pointer of this index went.
    Up(usize),
    /// `CANCEL`: the system took the gesture, all of them are gone.
    Cancel,
}

/// A pointer of a motion event.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pointer {
    /// Android's number of it, the same from down to up.
    pub id: i32,
    /// Where it is in the window, pixels.
    pub at_px: [f32; 2],
}

/// The touches of a motion event. An index that no pointer has gives none, and neither does a position that is no
/// number: a driver of a touch screen is believed no more than a file.
pub fn touches(motion: Motion, pointers: &[Pointer]) -> Vec<TouchEvent> {
    let (phase, of) = match motion {
        Motion::Down(index) => (TouchPhase::Start, pointers.get(index..=index)),
        Motion::Up(index) => (TouchPhase::End, pointers.get(index..=index)),
        Motion::Move => (TouchPhase::Move, Some(pointers)),
        Motion::Cancel => (TouchPhase::Cancel, Some(pointers)),
    };
    of.unwrap_or_default()
        .iter()
        .filter(|pointer| pointer.at_px.iter().all(|px| px.is_finite()))
        .map(|pointer| TouchEvent {
            id: u64::from(pointer.id.cast_unsigned()),
            phase,
            x_px: pointer.at_px[0],
            y_px: pointer.at_px[1],
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const TWO: [Pointer; 2] = [Pointer { id: 4, at_px: [1.0, 2.0] }, Pointer { id: 0, at_px: [3.0, 5.0] }];

    fn phases(motion: Motion) -> Vec<(u64, TouchPhase)> {
        touches(motion, &TWO).iter().map(|touch| (touch.id, touch.phase)).collect()
    }

    #[test]
    fn the_pointer_that_came_or_went_is_the_one_of_the_index() {
        assert_eq!(phases(Motion::Down(1)), [(0, TouchPhase::Start)]);
        assert_eq!(phases(Motion::Up(0)), [(4, TouchPhase::End)]);
        let down = &touches(Motion::Down(1), &TWO)[0];
        assert_eq!([down.x_px, down.y_px], [3.0, 5.0]);
    }

    #[test]
    fn all_move_and_all_are_cancelled() {
        assert_eq!(phases(Motion::Move), [(4, TouchPhase::Move), (0, TouchPhase::Move)]);
        assert_eq!(phases(Motion::Cancel), [(4, TouchPhase::Cancel), (0, TouchPhase::Cancel)]);
    }

    #[test]
    fn what_no_pointer_has_and_what_is_no_number_touches_nothing() {
        assert_eq!(phases(Motion::Down(2)), []);
        assert_eq!(phases(Motion::Up(usize::MAX - 1)), []);
        let nowhere = [Pointer { id: 1, at_px: [f32::NAN, 0.0] }, TWO[0]];
        assert_eq!(touches(Motion::Move, &nowhere).len(), 1);
        assert!(touches(Motion::Move, &[]).is_empty());
    }
}
