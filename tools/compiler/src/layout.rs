//! Types of host-visible data as the compiled module places them.

/// A type of host-visible data.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Type {
    /// 32-bit unsigned; HLSL's `bool` is stored as one.
    Uint,
    /// 32-bit signed.
    Int,
    /// 32-bit float (`min16float` too: it is only computed with less precision).
    Float,
    /// Two to four scalars without gaps.
    Vector(Box<Type>, u32),
    /// Elements `stride` bytes apart. A matrix is an array of its columns.
    Array {
        /// The element.
        of: Box<Type>,
        /// Number of elements.
        len: u32,
        /// Distance of two elements in bytes.
        stride: u32,
    },
    /// A struct.
    Struct(Struct),
    /// What no host type is made for, in words.
    Other(String),
}

/// A struct as the module places it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Struct {
    /// Its name in HLSL.
    pub name: String,
    /// Its fields in order.
    pub fields: Vec<Field>,
}

/// A field of a struct.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Field {
    /// Its name in HLSL.
    pub name: String,
    /// Its type.
    pub ty: Type,
    /// Bytes from the struct's start.
    pub offset: u32,
}

impl Type {
    /// Bytes from its first to its last, with the gaps inside but none behind.
    pub fn bytes(&self) -> u32 {
        match self {
            Self::Uint | Self::Int | Self::Float => 4,
            Self::Vector(of, len) => of.bytes() * len,
            Self::Array { of, len, stride } => stride * len.saturating_sub(1) + of.bytes().max(*stride),
            Self::Struct(fields) => fields.bytes(),
            Self::Other(_) => 0,
        }
    }
    /// Bytes without any gap: the stride of Unity's structured buffers.
    pub fn packed_bytes(&self) -> u32 {
        match self {
            Self::Array { of, len, .. } => of.packed_bytes() * len,
            Self::Struct(fields) => fields.fields.iter().map(|field| field.ty.packed_bytes()).sum(),
            other => other.bytes(),
        }
    }
    /// Its name in HLSL, for messages.
    pub fn hlsl(&self) -> String {
        match self {
            Self::Uint => "uint".to_owned(),
            Self::Int => "int".to_owned(),
            Self::Float => "float".to_owned(),
            Self::Vector(of, len) => format!("{}{len}", of.hlsl()),
            Self::Array { of, len, .. } => format!("{}[{len}]", of.hlsl()),
            Self::Struct(of) => of.name.clone(),
            Self::Other(what) => what.clone(),
        }
    }
    /// Its type in Rust; `Err` says what has none.
    pub fn rust(&self) -> Result<String, String> {
        Ok(match self {
            Self::Uint => "u32".to_owned(),
            Self::Int => "i32".to_owned(),
            Self::Float => "f32".to_owned(),
            Self::Vector(of, len) => format!("[{}; {len}]", of.rust()?),
            Self::Array { of, len, stride } => {
                let gap = stride.saturating_sub(of.bytes());
                match (gap, of.as_ref()) {
                    (0, of) => format!("[{}; {len}]", of.rust()?),
                    // Uniform buffers place every element on 16 bytes: the last components are unused.
                    (_, Self::Uint | Self::Int | Self::Float) => {
                        format!("[[{}; {}]; {len}]", of.rust()?, stride / 4)
                    }
                    (_, Self::Vector(scalar, _)) => {
                        format!("[[{}; {}]; {len}]", scalar.rust()?, stride / 4)
                    }
                    (gap, of) => {
                        return Err(format!("{} has a gap of {gap} bytes behind each element", of.hlsl()));
                    }
                }
            }
            Self::Struct(of) => crate::naming::pascal(&of.name),
            Self::Other(what) => return Err(format!("{what} has no host type")),
        })
    }
    /// Every struct in it, innermost first.
    pub fn structs(&self) -> Vec<&Struct> {
        match self {
            Self::Array { of, .. } | Self::Vector(of, _) => of.structs(),
            Self::Struct(of) => {
                let mut structs: Vec<&Struct> = of.fields.iter().flat_map(|field| field.ty.structs()).collect();
                structs.push(of);
                structs
            }
            _ => Vec::new(),
        }
    }
}

impl Struct {
    /// Bytes from its start to the end of its last field.
    pub fn bytes(&self) -> u32 {
        self.fields.iter().map(|field| field.offset + field.ty.bytes()).max().unwrap_or(0)
    }
}
