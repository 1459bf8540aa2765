//! Gives RelaxedPrecision to the copies of an unrolled loop. DXC decorates what `min16float` computes, then unrolls, and
//! of the four copies of a body the first alone keeps its decorations: a driver that lowers them to f16 then lowers a
//! quarter of the pair arithmetic.
//!
//! A copy is an instruction with the opcode, type and operands of a decorated one, where an operand may be the copy of
//! that one's operand, or the same expression out of the same buffers at another place. Nothing else is decorated:
//! what is computed alike in f32 reads something else, or a value that has no decoration.

use std::collections::{HashMap, HashSet};

use rspirv::dr::{Instruction, Module, Operand};
use rspirv::spirv::{Decoration, Op, Word};

/// Decorates the copies of what is decorated; gives how many.
pub fn decorate_copies(module: &mut Module) -> usize {
    let decorated = relaxed(module);
    let mut new: Vec<Word> = Vec::new();
    for function in &module.functions {
        let instructions: HashMap<Word, &Instruction> = function
            .blocks
            .iter()
            .flat_map(|block| &block.instructions)
            .filter_map(|instruction| Some((instruction.result_id?, instruction)))
            .collect();
        let mut copies = Copies { instructions: &instructions, decorated: &decorated, known: HashMap::new() };
        // In their own order, so that the same module comes out each time.
        let results: Vec<Word> =
            function.blocks.iter().flat_map(|block| &block.instructions).filter_map(|one| one.result_id).collect();
        let originals: Vec<Word> = results.iter().copied().filter(|id| decorated.contains(id)).collect();
        for &result in results.iter().filter(|id| !decorated.contains(id)) {
            if originals.iter().any(|&original| copies.is_copy(original, result)) {
                new.push(result);
            }
        }
    }
    module.annotations.extend(new.iter().map(|&id| {
        let operands = vec![Operand::IdRef(id), Operand::Decoration(Decoration::RelaxedPrecision)];
        Instruction::new(Op::Decorate, None, None, operands)
    }));
    new.len()
}

/// The ids that are decorated.
pub fn relaxed(module: &Module) -> HashSet<Word> {
    let is_relaxed = |one: &&Instruction| {
        one.class.opcode == Op::Decorate
            && one.operands.get(1) == Some(&Operand::Decoration(Decoration::RelaxedPrecision))
    };
    let targets = module.annotations.iter().filter(is_relaxed);
    targets.filter_map(|one| one.operands.first().and_then(Operand::id_ref_any)).collect()
}

struct Copies<'a> {
    instructions: &'a HashMap<Word, &'a Instruction>,
    decorated: &'a HashSet<Word>,
    known: HashMap<(Word, Word), bool>,
}

impl Copies<'_> {
    /// Whether `other` computes what `original` computes, of another copy's values.
    fn is_copy(&mut self, original: Word, other: Word) -> bool {
        if original == other {
            return true;
        }
        if let Some(&known) = self.known.get(&(original, other)) {
            return known;
        }
        // Where values run in a circle, through a phi, the circle alone makes them no copy.
        self.known.insert((original, other), false);
        let is = self.is_alike(original, other);
        self.known.insert((original, other), is);
        is
    }

    fn is_alike(&mut self, original: Word, other: Word) -> bool {
        let (Some(&one), Some(&two)) = (self.instructions.get(&original), self.instructions.get(&other)) else {
            return false; // a constant, or a buffer: the same, or another
        };
        if one.class.opcode != two.class.opcode || one.result_type != two.result_type {
            return false;
        }
        // Values of another precision are other values.
        if self.decorated.contains(&other) && !self.decorated.contains(&original) {
            return false;
        }
        if matches!(one.class.opcode, Op::Variable | Op::Phi) {
            return false; // state, not an expression
        }
        if one.class.opcode == Op::AccessChain {
            // Elements of one buffer: which one differs from copy to copy.
            return one.operands.first() == two.operands.first() && one.operands.len() == two.operands.len();
        }
        one.operands.len() == two.operands.len()
            && one.operands.iter().zip(&two.operands).all(|(a, b)| match (a.id_ref_any(), b.id_ref_any()) {
                (Some(a), Some(b)) => self.is_copy(a, b),
                _ => a == b,
            })
    }
}

#[cfg(test)]
#[path = "relaxed_tests.rs"]
mod tests;
