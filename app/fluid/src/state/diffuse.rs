//! Spray, foam and bubbles, in a saved state.

use brooklet_kernels::DiffuseParticle;

use super::{floats, number};
use crate::diffuse::DiffuseSet;

const NEXT_SLOT_BYTES: usize = 4;
const BYTES: usize = 32;

/// Appends each; one whose numbers are not finite as an empty slot.
pub(super) fn append(bytes: &mut Vec<u8>, set: &DiffuseSet) {
    bytes.extend(set.next_slot.to_le_bytes());
    for particle in &set.particles {
        let numbers = numbers(particle);
        let is_finite = numbers.iter().all(|x| x.is_finite());
        bytes.extend(numbers.iter().flat_map(|x| if is_finite { *x } else { 0.0 }.to_le_bytes()));
    }
}

/// Reads what was appended.
pub(super) fn read(content: &[u8]) -> Result<DiffuseSet, String> {
    let next_slot = number(content).filter(|_| (content.len() - NEXT_SLOT_BYTES).is_multiple_of(BYTES));
    let next_slot = next_slot.ok_or_else(|| {
        format!("its section FOAM has {} bytes; it must have {NEXT_SLOT_BYTES} and {BYTES} a slot", content.len())
    })?;
    let particles: Vec<DiffuseParticle> = content[NEXT_SLOT_BYTES..].chunks_exact(BYTES).map(particle).collect();
    if let Some(index) = particles.iter().position(|particle| !numbers(particle).iter().all(|x| x.is_finite())) {
        return Err(format!("diffuse particle {index} is {:?}; it must be finite", numbers(&particles[index])));
    }
    if next_slot as usize > particles.len() {
        return Err(format!(
            "its next diffuse particle's slot is {next_slot}; at most {} are allowed",
            particles.len()
        ));
    }
    Ok(DiffuseSet { particles, next_slot })
}

fn numbers(particle: &DiffuseParticle) -> [f32; 8] {
    let ([x, y, z], [u, v, w]) = (particle.position_m, particle.velocity_m_s);
    [x, y, z, particle.lifetime_s, u, v, w, particle.crowd]
}

fn particle(bytes: &[u8]) -> DiffuseParticle {
    let float = |at: usize| f32::from_bits(number(&bytes[at..]).unwrap_or_default());
    DiffuseParticle {
        position_m: floats(bytes),
        lifetime_s: float(12),
        velocity_m_s: floats(&bytes[16..]),
        crowd: float(28),
    }
}
