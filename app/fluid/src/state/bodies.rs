//! How bodies move, in a saved state.

use brooklet_kernels::{BodyState, REACTION_WORDS};

use super::{BODY_BYTES, BODY_FLOATS, number};
use crate::body_motion::BodyMotion;

/// Appends each body; one whose numbers are not finite as it would be anew, at rest.
pub(super) fn append(bytes: &mut Vec<u8>, motion: &BodyMotion) {
    let reactions = motion.reactions.chunks_exact(REACTION_WORDS as usize);
    for (state, reaction) in motion.states.iter().zip(reactions) {
        let numbers = floats(state);
        let is_finite = numbers.iter().all(|x| x.is_finite());
        let numbers = if is_finite {
            numbers
        } else {
            floats(&BodyState { rotation: [0.0, 0.0, 0.0, 1.0], ..BodyState::default() })
        };
        bytes.extend(numbers.iter().flat_map(|x| x.to_le_bytes()));
        bytes.extend(reaction.iter().flat_map(|word| word.to_le_bytes()));
    }
}

/// Reads what was appended: whole bodies.
pub(super) fn read(content: &[u8]) -> Result<BodyMotion, String> {
    let mut motion = BodyMotion::default();
    for (index, bytes) in content.chunks_exact(BODY_BYTES).enumerate() {
        let mut words = bytes.chunks_exact(4).map(|word| number(word).unwrap_or_default());
        let numbers: [f32; BODY_FLOATS] = std::array::from_fn(|_| f32::from_bits(words.next().unwrap_or_default()));
        let state = state(&numbers);
        let length = state.rotation.iter().map(|x| x * x).sum::<f32>();
        if !numbers.iter().all(|x| x.is_finite()) || (length - 1.0).abs() > 0.01 {
            return Err(format!(
                "the state of body {index} is {numbers:?}; it must be finite, and its rotation of length 1"
            ));
        }
        motion.states.push(state);
        motion.reactions.extend(words);
    }
    Ok(motion)
}

fn floats(state: &BodyState) -> Vec<f32> {
    let parts: [&[f32]; 6] = [
        &state.position_m,
        &state.rotation,
        &state.velocity_m_s,
        &state.spin_rad_s,
        &state.owed_kg_m_s,
        &state.owed_kg_m2_s,
    ];
    parts.concat()
}

fn state(numbers: &[f32; BODY_FLOATS]) -> BodyState {
    let three = |at: usize| [numbers[at], numbers[at + 1], numbers[at + 2]];
    BodyState {
        position_m: three(0),
        rotation: [numbers[3], numbers[4], numbers[5], numbers[6]],
        velocity_m_s: three(7),
        spin_rad_s: three(10),
        owed_kg_m_s: three(13),
        owed_kg_m2_s: three(16),
        ..BodyState::default()
    }
}
