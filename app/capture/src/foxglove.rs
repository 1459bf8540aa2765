//! Foxglove's well-known messages for pictures and points, in protobuf, and the descriptors that a reader
//! decodes them by. Their fields and numbers are those of the published schemas `foxglove.CompressedImage`
//! and `foxglove.PointCloud`; a test compares them with the Foxglove SDK's own.

use prost::Message;
use prost_types::{
    DescriptorProto, EnumDescriptorProto, EnumValueDescriptorProto, FieldDescriptorProto, FileDescriptorProto,
    FileDescriptorSet, Timestamp,
    field_descriptor_proto::{Label, Type},
};

/// Where particles and pictures are, for a viewer in three dimensions.
const WORLD: &str = "world";
/// `PackedElementField.NumericType.FLOAT32`.
const FLOAT32: i32 = 7;

/// A point: x, y, z in m and a speed in m/s.
pub type Point = [f32; 4];

#[derive(Clone, PartialEq, Message)]
pub(crate) struct CompressedImage {
    #[prost(message, optional, tag = "1")]
    timestamp: Option<Timestamp>,
    #[prost(bytes = "vec", tag = "2")]
    pub data: Vec<u8>,
    #[prost(string, tag = "3")]
    pub format: String,
    #[prost(string, tag = "4")]
    frame_id: String,
}

#[derive(Clone, PartialEq, Message)]
pub(crate) struct PointCloud {
    #[prost(message, optional, tag = "1")]
    timestamp: Option<Timestamp>,
    #[prost(string, tag = "2")]
    frame_id: String,
    #[prost(message, optional, tag = "3")]
    pose: Option<Pose>,
    #[prost(fixed32, tag = "4")]
    pub point_stride: u32,
    #[prost(message, repeated, tag = "5")]
    fields: Vec<PackedElementField>,
    #[prost(bytes = "vec", tag = "6")]
    pub data: Vec<u8>,
}

#[derive(Clone, PartialEq, Message)]
struct PackedElementField {
    #[prost(string, tag = "1")]
    name: String,
    #[prost(fixed32, tag = "2")]
    offset: u32,
    #[prost(int32, tag = "3")]
    numeric_type: i32,
}

#[derive(Clone, PartialEq, Message)]
struct Pose {
    #[prost(message, optional, tag = "1")]
    position: Option<Vector3>,
    #[prost(message, optional, tag = "2")]
    orientation: Option<Quaternion>,
}

#[derive(Clone, PartialEq, Message)]
struct Vector3 {
    #[prost(double, tag = "1")]
    x: f64,
    #[prost(double, tag = "2")]
    y: f64,
    #[prost(double, tag = "3")]
    z: f64,
}

#[derive(Clone, PartialEq, Message)]
struct Quaternion {
    #[prost(double, tag = "1")]
    x: f64,
    #[prost(double, tag = "2")]
    y: f64,
    #[prost(double, tag = "3")]
    z: f64,
    #[prost(double, tag = "4")]
    w: f64,
}

fn timestamp(unix_ns: u64) -> Timestamp {
    Timestamp { seconds: (unix_ns / 1_000_000_000) as i64, nanos: (unix_ns % 1_000_000_000) as i32 }
}

/// Appends a `foxglove.CompressedImage`; `format` is `png` or `jpeg`.
pub(crate) fn image(to: &mut Vec<u8>, unix_ns: u64, format: &str, data: &[u8]) {
    let message = CompressedImage {
        timestamp: Some(timestamp(unix_ns)),
        data: data.into(),
        format: format.into(),
        frame_id: WORLD.into(),
    };
    to.extend(message.encode_to_vec());
}

/// Appends a `foxglove.PointCloud` with the fields x, y, z and `speed`.
pub(crate) fn points(to: &mut Vec<u8>, unix_ns: u64, points: &[Point]) {
    let field = |(index, name): (usize, &str)| PackedElementField {
        name: name.into(),
        offset: 4 * index as u32,
        numeric_type: FLOAT32,
    };
    // Worlds here have y up, Foxglove's z: a quarter turn about x takes one to the other.
    let quarter = std::f64::consts::FRAC_1_SQRT_2;
    let message = PointCloud {
        timestamp: Some(timestamp(unix_ns)),
        frame_id: WORLD.into(),
        pose: Some(Pose {
            position: Some(Vector3 { x: 0.0, y: 0.0, z: 0.0 }),
            orientation: Some(Quaternion { x: quarter, y: 0.0, z: 0.0, w: quarter }),
        }),
        point_stride: 16,
        fields: ["x", "y", "z", "speed"].into_iter().enumerate().map(field).collect(),
        data: points.iter().flatten().flat_map(|value| value.to_le_bytes()).collect(),
    };
    to.extend(message.encode_to_vec());
}

/// Schema name and descriptors (a `FileDescriptorSet`) of [`image`].
pub(crate) fn image_schema() -> (&'static str, Vec<u8>) {
    let file = file(
        "CompressedImage",
        &["google/protobuf/timestamp"],
        vec![message(
            "CompressedImage",
            vec![
                of_type("timestamp", 1, ".google.protobuf.Timestamp"),
                scalar("frame_id", 4, Type::String),
                scalar("data", 2, Type::Bytes),
                scalar("format", 3, Type::String),
            ],
        )],
    );
    ("foxglove.CompressedImage", set(vec![timestamp_file(), file]))
}

/// Schema name and descriptors (a `FileDescriptorSet`) of [`points`].
pub(crate) fn points_schema() -> (&'static str, Vec<u8>) {
    let xyz = || [("x", 1), ("y", 2), ("z", 3)].map(|(name, number)| scalar(name, number, Type::Double)).to_vec();
    let mut xyzw = xyz();
    xyzw.push(scalar("w", 4, Type::Double));
    let kinds = ["UNKNOWN", "UINT8", "INT8", "UINT16", "INT16", "UINT32", "INT32", "FLOAT32", "FLOAT64"];
    let mut element = message(
        "PackedElementField",
        vec![
            scalar("name", 1, Type::String),
            scalar("offset", 2, Type::Fixed32),
            FieldDescriptorProto {
                r#type: Some(Type::Enum.into()),
                ..of_type("type", 3, ".foxglove.PackedElementField.NumericType")
            },
        ],
    );
    element.enum_type.push(EnumDescriptorProto {
        name: Some("NumericType".into()),
        value: kinds
            .iter()
            .zip(0..)
            .map(|(name, number)| EnumValueDescriptorProto {
                name: Some((*name).into()),
                number: Some(number),
                ..Default::default()
            })
            .collect(),
        ..Default::default()
    });
    let pose = message(
        "Pose",
        vec![of_type("position", 1, ".foxglove.Vector3"), of_type("orientation", 2, ".foxglove.Quaternion")],
    );
    let cloud = message(
        "PointCloud",
        vec![
            of_type("timestamp", 1, ".google.protobuf.Timestamp"),
            scalar("frame_id", 2, Type::String),
            of_type("pose", 3, ".foxglove.Pose"),
            scalar("point_stride", 4, Type::Fixed32),
            FieldDescriptorProto {
                label: Some(Label::Repeated.into()),
                ..of_type("fields", 5, ".foxglove.PackedElementField")
            },
            scalar("data", 6, Type::Bytes),
        ],
    );
    let needs = ["foxglove/PackedElementField", "foxglove/Pose", "google/protobuf/timestamp"];
    let files = vec![
        timestamp_file(),
        file("PackedElementField", &[], vec![element]),
        file("Vector3", &[], vec![message("Vector3", xyz())]),
        file("Quaternion", &[], vec![message("Quaternion", xyzw)]),
        file("Pose", &["foxglove/Quaternion", "foxglove/Vector3"], vec![pose]),
        file("PointCloud", &needs, vec![cloud]),
    ];
    ("foxglove.PointCloud", set(files))
}

fn set(file: Vec<FileDescriptorProto>) -> Vec<u8> {
    FileDescriptorSet { file }.encode_to_vec()
}

fn file(name: &str, needs: &[&str], messages: Vec<DescriptorProto>) -> FileDescriptorProto {
    FileDescriptorProto {
        name: Some(format!("foxglove/{name}.proto")),
        package: Some("foxglove".into()),
        dependency: needs.iter().map(|name| format!("{name}.proto")).collect(),
        message_type: messages,
        syntax: Some("proto3".into()),
        ..Default::default()
    }
}

fn timestamp_file() -> FileDescriptorProto {
    FileDescriptorProto {
        name: Some("google/protobuf/timestamp.proto".into()),
        package: Some("google.protobuf".into()),
        message_type: vec![message(
            "Timestamp",
            vec![scalar("seconds", 1, Type::Int64), scalar("nanos", 2, Type::Int32)],
        )],
        syntax: Some("proto3".into()),
        ..Default::default()
    }
}

fn message(name: &str, field: Vec<FieldDescriptorProto>) -> DescriptorProto {
    DescriptorProto { name: Some(name.into()), field, ..Default::default() }
}

fn scalar(name: &str, number: i32, kind: Type) -> FieldDescriptorProto {
    FieldDescriptorProto {
        name: Some(name.into()),
        number: Some(number),
        label: Some(Label::Optional.into()),
        r#type: Some(kind.into()),
        ..Default::default()
    }
}

/// A field that is another message.
fn of_type(name: &str, number: i32, kind: &str) -> FieldDescriptorProto {
    FieldDescriptorProto { type_name: Some(kind.into()), ..scalar(name, number, Type::Message) }
}
