//! How a scene's bodies move, on the host: what lasts of them from step to step.

use brooklet_kernels::{BodyState, REACTION_WORDS};

use crate::scene::{Scene, first_body_states};

/// Of all bodies of a scene, in the order of its solids; empty where it has none.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BodyMotion {
    /// Where they are and how fast, relative to the domain's lowest corner.
    pub states: Vec<BodyState>,
    /// What the fluid gave each since the last substep: [`REACTION_WORDS`] words.
    pub reactions: Vec<u32>,
}

impl BodyMotion {
    /// As they begin.
    pub fn first(scene: &Scene) -> Self {
        Self::at_rest_with(first_body_states(scene))
    }

    /// With these states, and nothing of the fluid's yet.
    pub fn at_rest_with(states: Vec<BodyState>) -> Self {
        let words = states.len() * REACTION_WORDS as usize;
        Self { states, reactions: vec![0; words] }
    }
}

/// The sums of one reaction's [`REACTION_WORDS`] words: an impulse and its moment, in units (`boundary/bodies/layout.hlsli`).
pub fn reaction_sums(words: &[u32]) -> [i64; 6] {
    std::array::from_fn(|k| i64::from(words[2 * k]) | i64::from(words[2 * k + 1] as i32) << 32)
}
