//! What a compiled module says of itself: entry point, group size, memory, bindings, layouts.

use std::collections::{BTreeMap, BTreeSet};

use rspirv::dr::{self, Instruction, Operand};
use rspirv::spirv::{self, Decoration, ExecutionMode, Op, StorageClass};

use crate::layout::{Field, Struct, Type};

/// A module, reflected.
#[derive(Clone, Debug, PartialEq)]
pub struct Reflection {
    /// Threads of a group; ones for graphics stages.
    pub group_size: [u32; 3],
    /// Bytes of groupshared memory.
    pub shared_bytes: u32,
    /// SPIR-V capabilities it declares.
    pub capabilities: Vec<String>,
    /// Its bindings, by slot.
    pub bindings: Vec<Binding>,
}

/// A binding of a module.
#[derive(Clone, Debug, PartialEq)]
pub struct Binding {
    /// Its name in HLSL.
    pub name: String,
    /// Its slot.
    pub slot: u32,
    /// What stands there.
    pub kind: Kind,
}

/// What stands at a binding.
#[derive(Clone, Debug, PartialEq)]
pub enum Kind {
    /// A uniform buffer.
    Uniform {
        /// Its contents.
        block: Struct,
        /// Bytes from its start to its last.
        bytes: u32,
    },
    /// A storage buffer.
    Storage {
        /// Whether it is never written.
        read_only: bool,
        /// The element.
        element: Type,
        /// Distance of two elements.
        stride: u32,
    },
    /// A sampled 2-D texture.
    Texture {
        /// Whether a filtering sampler reads it.
        filterable: bool,
    },
    /// A 2-D storage image.
    StorageImage {
        /// SPIR-V's name of its format.
        format: String,
    },
    /// A sampler.
    Sampler,
    /// What is not supported, in words, and the way out.
    Unsupported {
        /// What it is.
        what: String,
        /// What to do instead.
        way_out: &'static str,
    },
}

/// Gives the bindings of `module` the slots that `slot_of` says, all in set 0.
pub fn renumber(module: &mut dr::Module, slot_of: &BTreeMap<String, u32>) {
    let names = Tables::new(module).names;
    for instruction in &mut module.annotations {
        let name = id(instruction, 0).and_then(|target| names.get(&target));
        let slot = name.and_then(|name| slot_of.get(name));
        match (instruction.operands.get(1), slot) {
            (Some(Operand::Decoration(Decoration::Binding)), Some(&slot)) => {
                instruction.operands[2] = Operand::LiteralBit32(slot);
            }
            (Some(Operand::Decoration(Decoration::DescriptorSet)), Some(_)) => {
                instruction.operands[2] = Operand::LiteralBit32(0);
            }
            _ => {}
        }
    }
}

/// Reads a module.
pub fn reflect(module: &dr::Module) -> Reflection {
    let tables = Tables::new(module);
    let mut group_size = [1; 3];
    for mode in &module.execution_modes {
        if matches!(mode.operands.get(1), Some(Operand::ExecutionMode(ExecutionMode::LocalSize))) {
            for (axis, size) in group_size.iter_mut().enumerate() {
                *size = literal(mode, axis + 2).unwrap_or(1);
            }
        }
    }
    let mut shared_bytes = 0;
    let mut bindings = Vec::new();
    let filtered = filtered_textures(module, &tables);
    for variable in &module.types_global_values {
        if variable.class.opcode != Op::Variable {
            continue;
        }
        let (Some(variable_id), Some(pointee)) = (variable.result_id, tables.pointee(variable)) else {
            continue;
        };
        match variable.operands.first() {
            Some(Operand::StorageClass(StorageClass::Workgroup)) => {
                let (bytes, alignment) = tables.shared_size(pointee);
                shared_bytes = u32::next_multiple_of(shared_bytes, alignment) + bytes;
            }
            Some(Operand::StorageClass(
                StorageClass::Uniform | StorageClass::UniformConstant | StorageClass::StorageBuffer,
            )) => {
                if let Some(slot) = tables.decoration(variable_id, Decoration::Binding) {
                    bindings.push(Binding {
                        name: tables.names.get(&variable_id).cloned().unwrap_or_default(),
                        slot,
                        kind: tables.kind(pointee, filtered.contains(&variable_id)),
                    });
                }
            }
            _ => {}
        }
    }
    bindings.sort_by_key(|binding| binding.slot);
    let capabilities = module
        .capabilities
        .iter()
        .filter_map(|instruction| match instruction.operands.first() {
            Some(Operand::Capability(capability)) => Some(format!("{capability:?}")),
            _ => None,
        })
        .collect();
    Reflection { group_size, shared_bytes, capabilities, bindings }
}

/// Textures that are read through a sampler, unless its name says that it only takes points
/// (Unity's inline samplers): those need a format that can be filtered.
fn filtered_textures(module: &dr::Module, tables: &Tables) -> BTreeSet<u32> {
    let mut loaded = BTreeMap::new();
    let mut filtered = BTreeSet::new();
    for instruction in module.functions.iter().flat_map(dr::Function::all_inst_iter) {
        match instruction.class.opcode {
            Op::Load => {
                if let (Some(result), Some(from)) = (instruction.result_id, id(instruction, 0)) {
                    loaded.insert(result, from);
                }
            }
            Op::SampledImage => {
                let variable = |operand| loaded.get(&id(instruction, operand)?).copied();
                let sampler = variable(1).and_then(|sampler| tables.names.get(&sampler));
                let points = sampler.is_some_and(|name| name.to_ascii_lowercase().contains("point"));
                if let (Some(image), false) = (variable(0), points) {
                    filtered.insert(image);
                }
            }
            _ => {}
        }
    }
    filtered
}

/// Decorations of one target, each with its first literal.
type Decorations = Vec<(Decoration, Option<u32>)>;

struct Tables<'m> {
    names: BTreeMap<u32, String>,
    member_names: BTreeMap<(u32, u32), String>,
    decorations: BTreeMap<u32, Decorations>,
    member_decorations: BTreeMap<(u32, u32), Decorations>,
    values: BTreeMap<u32, &'m Instruction>,
}

impl<'m> Tables<'m> {
    fn new(module: &'m dr::Module) -> Self {
        let mut tables = Self {
            names: BTreeMap::new(),
            member_names: BTreeMap::new(),
            decorations: BTreeMap::new(),
            member_decorations: BTreeMap::new(),
            values: BTreeMap::new(),
        };
        for instruction in &module.debug_names {
            match (instruction.class.opcode, instruction.operands.as_slice()) {
                (Op::Name, [Operand::IdRef(target), Operand::LiteralString(name)]) => {
                    tables.names.insert(*target, name.clone());
                }
                (
                    Op::MemberName,
                    [Operand::IdRef(target), Operand::LiteralBit32(member), Operand::LiteralString(name)],
                ) => {
                    tables.member_names.insert((*target, *member), name.clone());
                }
                _ => {}
            }
        }
        for instruction in &module.annotations {
            match (instruction.class.opcode, instruction.operands.as_slice()) {
                (Op::Decorate, [Operand::IdRef(target), Operand::Decoration(decoration), ..]) => {
                    let entry = tables.decorations.entry(*target).or_default();
                    entry.push((*decoration, literal(instruction, 2)));
                }
                (
                    Op::MemberDecorate,
                    [Operand::IdRef(target), Operand::LiteralBit32(member), Operand::Decoration(decoration), ..],
                ) => {
                    let entry = tables.member_decorations.entry((*target, *member)).or_default();
                    entry.push((*decoration, literal(instruction, 3)));
                }
                _ => {}
            }
        }
        for instruction in &module.types_global_values {
            if let Some(result) = instruction.result_id {
                tables.values.insert(result, instruction);
            }
        }
        tables
    }

    fn decoration(&self, target: u32, wanted: Decoration) -> Option<u32> {
        find(self.decorations.get(&target), wanted).flatten()
    }
    fn has(&self, target: u32, wanted: Decoration) -> bool {
        find(self.decorations.get(&target), wanted).is_some()
    }
    fn member(&self, target: u32, member: u32, wanted: Decoration) -> Option<Option<u32>> {
        find(self.member_decorations.get(&(target, member)), wanted)
    }
    fn pointee(&self, variable: &Instruction) -> Option<u32> {
        id(self.values.get(&variable.result_type?)?, 1)
    }
    fn constant(&self, target: u32) -> u32 {
        self.values.get(&target).and_then(|constant| literal(constant, 0)).unwrap_or(0)
    }

    fn kind(&self, ty: u32, filterable: bool) -> Kind {
        let Some(instruction) = self.values.get(&ty) else {
            return unsupported("a resource of unknown type", "");
        };
        match instruction.class.opcode {
            Op::TypeStruct => self.buffer(ty, instruction),
            Op::TypeSampler => Kind::Sampler,
            Op::TypeImage => self.image(instruction, filterable),
            Op::TypeArray | Op::TypeRuntimeArray => {
                unsupported("an array of resources", "give each resource a name of its own")
            }
            other => unsupported(&format!("a resource of type {other:?}"), "use a structured buffer"),
        }
    }

    fn buffer(&self, ty: u32, instruction: &Instruction) -> Kind {
        if !self.has(ty, Decoration::BufferBlock) {
            let block = self.structure(ty, instruction);
            let bytes = block.bytes();
            return Kind::Uniform { block, bytes };
        }
        let array = id(instruction, 0).unwrap_or(0);
        let element = self.values.get(&array).and_then(|array| id(array, 0));
        let (Some(element), Some(stride)) = (element, self.decoration(array, Decoration::ArrayStride)) else {
            return unsupported(
                "a buffer with a hidden counter (Append, Consume or IncrementCounter)",
                "count with InterlockedAdd in a RWStructuredBuffer<uint> of your own",
            );
        };
        Kind::Storage {
            read_only: self.member(ty, 0, Decoration::NonWritable).is_some(),
            element: self.ty(element),
            stride,
        }
    }

    fn image(&self, instruction: &Instruction, filterable: bool) -> Kind {
        let dim = match instruction.operands.get(1) {
            Some(Operand::Dim(dim)) => *dim,
            _ => return unsupported("an image of unknown shape", ""),
        };
        let plain = literal(instruction, 3) == Some(0) && literal(instruction, 4) == Some(0);
        if dim == spirv::Dim::DimBuffer {
            return unsupported(
                "a typed buffer (Buffer<T> or RWBuffer<T>)",
                "use StructuredBuffer<T> or RWStructuredBuffer<T>",
            );
        }
        if dim != spirv::Dim::Dim2D || !plain {
            return unsupported(
                "a texture that is not a plain Texture2D",
                "keep its texels in a structured buffer, or its slices side by side in a Texture2D",
            );
        }
        let sampled_float = id(instruction, 0)
            .and_then(|sampled| self.values.get(&sampled))
            .is_some_and(|sampled| sampled.class.opcode == Op::TypeFloat);
        match (literal(instruction, 5), instruction.operands.get(6)) {
            (Some(1), _) if !sampled_float => unsupported("a texture of integers", "use a StructuredBuffer of them"),
            (Some(1), _) => Kind::Texture { filterable },
            (_, Some(Operand::ImageFormat(format))) => Kind::StorageImage { format: format!("{format:?}") },
            _ => unsupported("an image without a format", "give it [[vk::image_format(\"...\")]]"),
        }
    }

    fn structure(&self, ty: u32, instruction: &Instruction) -> Struct {
        let full = self.names.get(&ty).cloned().unwrap_or_default();
        // `type.ConstantBuffer.GridParams`, `type.Block`, or the plain name of a nested struct.
        let name = full
            .strip_prefix("type.ConstantBuffer.")
            .or_else(|| full.strip_prefix("type."))
            .unwrap_or(&full)
            .to_owned();
        let members = instruction.operands.len() as u32;
        let fields = (0..members)
            .filter_map(|member| {
                let member_ty = id(instruction, member as usize)?;
                Some(Field {
                    name: self.member_names.get(&(ty, member)).cloned().unwrap_or_default(),
                    ty: self.member_ty(ty, member, member_ty),
                    offset: self.member(ty, member, Decoration::Offset).flatten().unwrap_or(0),
                })
            })
            .collect();
        Struct { name, fields }
    }

    /// A member's type; for a matrix its stride stands at the member.
    fn member_ty(&self, owner: u32, member: u32, ty: u32) -> Type {
        let is_matrix = self.values.get(&ty).is_some_and(|instruction| instruction.class.opcode == Op::TypeMatrix);
        if !is_matrix {
            return self.ty(ty);
        }
        let stride = self.member(owner, member, Decoration::MatrixStride).flatten().unwrap_or(16);
        let by_rows = self.member(owner, member, Decoration::RowMajor).is_some();
        self.matrix(ty, stride, by_rows)
    }

    /// As it lies in memory: SPIR-V's `RowMajor` puts the vectors of one row index together.
    fn matrix(&self, ty: u32, stride: u32, by_rows: bool) -> Type {
        let matrix = self.values[&ty];
        let columns = literal(matrix, 1).unwrap_or(4);
        let Some(Type::Vector(scalar, rows)) = id(matrix, 0).map(|vector| self.ty(vector)) else {
            return Type::Other("a matrix".to_owned());
        };
        let (len, width) = if by_rows { (rows, columns) } else { (columns, rows) };
        Type::Array { of: Box::new(Type::Vector(scalar, width)), len, stride }
    }

    fn ty(&self, ty: u32) -> Type {
        let Some(instruction) = self.values.get(&ty) else {
            return Type::Other("an unknown type".to_owned());
        };
        let width = literal(instruction, 0).unwrap_or(0);
        match instruction.class.opcode {
            Op::TypeInt if width == 32 && literal(instruction, 1) == Some(0) => Type::Uint,
            Op::TypeInt if width == 32 => Type::Int,
            Op::TypeFloat if width == 32 => Type::Float,
            Op::TypeInt => Type::Other(format!("a {width}-bit integer")),
            Op::TypeFloat => Type::Other(format!("a {width}-bit float")),
            Op::TypeVector => {
                let scalar = id(instruction, 0).map(|scalar| self.ty(scalar));
                match (scalar, literal(instruction, 1)) {
                    (Some(scalar @ (Type::Uint | Type::Int | Type::Float)), Some(len)) => {
                        Type::Vector(Box::new(scalar), len)
                    }
                    (Some(Type::Other(what)), _) => Type::Other(format!("a vector of {what}")),
                    _ => Type::Other("a vector".to_owned()),
                }
            }
            Op::TypeMatrix => self.matrix(ty, 16, true),
            Op::TypeArray => Type::Array {
                of: Box::new(id(instruction, 0).map_or(Type::Uint, |element| self.ty(element))),
                len: id(instruction, 1).map_or(0, |len| self.constant(len)),
                stride: self.decoration(ty, Decoration::ArrayStride).unwrap_or(0),
            },
            Op::TypeStruct => Type::Struct(self.structure(ty, instruction)),
            other => Type::Other(format!("{other:?}")),
        }
    }

    /// Bytes and alignment of groupshared data, laid out as drivers do (std430).
    fn shared_size(&self, ty: u32) -> (u32, u32) {
        let Some(instruction) = self.values.get(&ty) else {
            return (0, 4);
        };
        let element = || id(instruction, 0).map_or((0, 4), |element| self.shared_size(element));
        match instruction.class.opcode {
            Op::TypeInt | Op::TypeFloat => {
                let bytes = literal(instruction, 0).unwrap_or(32) / 8;
                (bytes, bytes)
            }
            Op::TypeBool => (4, 4),
            Op::TypeVector => {
                let (bytes, _) = element();
                let len = literal(instruction, 1).unwrap_or(1);
                (bytes * len, bytes * len.next_power_of_two())
            }
            Op::TypeMatrix => {
                let (bytes, alignment) = element();
                let len = literal(instruction, 1).unwrap_or(1);
                (bytes.next_multiple_of(alignment) * len, alignment)
            }
            Op::TypeArray => {
                let (bytes, alignment) = element();
                let len = id(instruction, 1).map_or(0, |len| self.constant(len));
                (bytes.next_multiple_of(alignment) * len, alignment)
            }
            Op::TypeStruct => {
                let (mut end, mut most) = (0u32, 4u32);
                for member in 0..instruction.operands.len() {
                    let member = id(instruction, member).unwrap_or(0);
                    let (bytes, alignment) = self.shared_size(member);
                    end = end.next_multiple_of(alignment) + bytes;
                    most = most.max(alignment);
                }
                (end.next_multiple_of(most), most)
            }
            _ => (0, 4),
        }
    }
}

fn unsupported(what: &str, way_out: &'static str) -> Kind {
    Kind::Unsupported { what: what.to_owned(), way_out }
}

fn find(decorations: Option<&Decorations>, wanted: Decoration) -> Option<Option<u32>> {
    decorations?.iter().find(|(decoration, _)| *decoration == wanted).map(|(_, value)| *value)
}

fn id(instruction: &Instruction, operand: usize) -> Option<u32> {
    match instruction.operands.get(operand) {
        Some(Operand::IdRef(id)) => Some(*id),
        _ => None,
    }
}

fn literal(instruction: &Instruction, operand: usize) -> Option<u32> {
    match instruction.operands.get(operand) {
        Some(Operand::LiteralBit32(value)) => Some(*value),
        _ => None,
    }
}
