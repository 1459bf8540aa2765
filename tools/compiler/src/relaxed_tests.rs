use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use rspirv::binary::{Assemble, Disassemble};
use rspirv::dr::{self, Builder};
use rspirv::spirv::{AddressingModel, ExecutionModel, FunctionControl, MemoryModel, StorageClass};

use super::*;

/// Two bodies of a loop that square what they read; `decorate` the first, and what else is computed by `rest` of
/// (builder, type, the value that the second read).
fn two_bodies(same_buffer: bool, second: Op) -> (Module, Word) {
    let mut b = Builder::new();
    b.memory_model(AddressingModel::Logical, MemoryModel::GLSL450);
    let (void, float, int) = (b.type_void(), b.type_float(32, None), b.type_int(32, 0));
    let length = b.constant_bit32(int, 8);
    let array = b.type_array(float, length);
    let (to_array, to_float) =
        (b.type_pointer(None, StorageClass::Uniform, array), b.type_pointer(None, StorageClass::Uniform, float));
    let buffers = [0, 1].map(|_| b.variable(to_array, None, StorageClass::Uniform, None));
    let signature = b.type_function(void, vec![]);
    let main = b.begin_function(void, None, FunctionControl::NONE, signature).unwrap();
    b.begin_block(None).unwrap();
    let read = |b: &mut Builder, buffer: Word, index: u32| {
        let index = b.constant_bit32(int, index);
        let chain = b.access_chain(to_float, None, buffer, [index]).unwrap();
        b.load(float, None, chain, None, []).unwrap()
    };
    let one = read(&mut b, buffers[0], 1);
    let square = b.f_mul(float, None, one, one).unwrap();
    let two = read(&mut b, buffers[usize::from(!same_buffer)], 2);
    let other = match second {
        Op::FAdd => b.f_add(float, None, two, two).unwrap(),
        _ => b.f_mul(float, None, two, two).unwrap(),
    };
    b.ret().unwrap();
    b.end_function().unwrap();
    b.entry_point(ExecutionModel::GLCompute, main, "main", []);
    b.decorate(square, Decoration::RelaxedPrecision, []);
    (b.module(), other)
}

fn decorates_second(same_buffer: bool, second: Op) -> bool {
    let (mut module, other) = two_bodies(same_buffer, second);
    let new = decorate_copies(&mut module);
    assert_eq!(new, usize::from(relaxed(&module).contains(&other)), "{}", module.disassemble());
    rspirv::dr::load_words(module.assemble()).expect("a module that can be read");
    new > 0
}

#[test]
fn a_copy_is_decorated() {
    assert!(decorates_second(true, Op::FMul));
}

#[test]
fn what_only_looks_alike_is_not() {
    assert!(!decorates_second(true, Op::FAdd), "another operation");
    assert!(!decorates_second(false, Op::FMul), "another buffer");
}

#[test]
fn a_second_pass_finds_nothing() {
    let (mut module, _) = two_bodies(true, Op::FMul);
    assert_eq!(decorate_copies(&mut module), 1);
    assert_eq!(decorate_copies(&mut module), 0);
}

/// Arithmetic of a module by opcode, as far as `counts` says so of a result's type and id.
fn arithmetic(module: &Module, counts: impl Fn(Word, Word) -> bool) -> BTreeMap<Op, usize> {
    let is_arithmetic = |one: &&Instruction| {
        let opcode = one.class.opcode;
        matches!(opcode, Op::FAdd | Op::FSub | Op::FMul | Op::FDiv | Op::FNegate)
            || matches!(opcode, Op::Dot | Op::VectorTimesScalar | Op::ExtInst)
    };
    let mut found = BTreeMap::new();
    for one in module.all_inst_iter().filter(is_arithmetic) {
        if let (Some(of_type), Some(id)) = (one.result_type, one.result_id)
            && counts(of_type, id)
        {
            *found.entry(one.class.opcode).or_default() += 1;
        }
    }
    found
}

/// Floats of 16 bits, and vectors of them.
fn half_types(module: &Module) -> HashSet<Word> {
    let mut found = HashSet::new();
    for one in &module.types_global_values {
        let is_half = match one.class.opcode {
            Op::TypeFloat => one.operands.first() == Some(&Operand::LiteralBit32(16)),
            Op::TypeVector => one.operands[0].id_ref_any().is_some_and(|of| found.contains(&of)),
            _ => false,
        };
        found.extend(one.result_id.filter(|_| is_half));
    }
    found
}

/// Of what the source declares `real`, which the `half` variant computes in f16 indeed, the share that the `relaxed`
/// one decorates. Arithmetic of constants, which is folded in f32 alone, is no part of it. `None` without any.
fn decorated_share(relaxed_variant: &Module, half_variant: &Module) -> Option<f64> {
    let (types, decorated) = (half_types(half_variant), relaxed(relaxed_variant));
    let of_half = arithmetic(half_variant, |of_type, _| types.contains(&of_type));
    let marked = arithmetic(relaxed_variant, |_, id| decorated.contains(&id));
    let [all_half, all_relaxed] = [half_variant, relaxed_variant].map(|module| arithmetic(module, |_, _| true));
    let count = |of: &BTreeMap<Op, usize>, op: Op| of.get(&op).copied().unwrap_or(0);
    let (mut all, mut found) = (0, 0);
    for (&op, &number) in &of_half {
        let folded = count(&all_half, op).saturating_sub(count(&all_relaxed, op));
        let wanted = number.saturating_sub(folded);
        all += wanted;
        found += wanted.min(count(&marked, op));
    }
    (all > 0).then(|| found as f64 / all as f64)
}

#[test]
fn committed_pair_kernels_have_nine_tenths_of_their_arithmetic_decorated() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../app/kernels");
    let manifest = crate::freshness::read_manifest(&folder).unwrap();
    let read = |file: &str| dr::load_bytes(std::fs::read(folder.join(file)).unwrap()).unwrap();
    let mut kernels = BTreeSet::new();
    for module in &manifest.modules {
        let half = module.spirv.replace("relaxed_precision", "half_precision");
        if half == module.spirv || !manifest.modules.iter().any(|other| other.spirv == half) {
            continue;
        }
        let (mut lowered, half) = (read(&module.spirv), read(&half));
        let Some(share) = decorated_share(&lowered, &half) else { continue };
        assert!(share >= 0.9, "{}: {share:.2} of the pair arithmetic is decorated", module.name);
        kernels.insert(module.entry.clone());
        // As DXC leaves it: the first of four copies alone.
        let mut last: HashSet<Word> = relaxed(&lowered).into_iter().collect();
        let keep = last.iter().copied().min_by_key(|id| *id).unwrap() + 16;
        last.retain(|&id| id > keep);
        lowered.annotations.retain(|one| one.operands[0].id_ref_any().is_none_or(|id| !last.contains(&id)));
        let spoilt = decorated_share(&lowered, &half).unwrap();
        assert!(spoilt < 0.9, "{}: {spoilt:.2} is still decorated", module.name);
    }
    let expected = [
        "Accelerate",
        "ApplyPressure",
        "ComputeDensity",
        "ConfineVorticity",
        "ConstrainDensity",
        "CorrectPositions",
        "CorrectPressure",
        "Curl",
        "FactorPressure",
        "Xsph",
    ];
    assert!(kernels.iter().eq(expected), "{kernels:?}");
}
