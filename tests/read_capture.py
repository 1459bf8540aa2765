"""Reads a capture with the Python package `mcap` and prints what it holds as JSON.

Every message is held against its own schema: JSON by `jsonschema`, protobuf by the descriptors in the
file, which must say the same of each field as those of the Foxglove SDK. Nothing here is
Brooklet's own code, so what this prints is what any other program sees.

    python read_capture.py capture.mcap
"""

import base64
import json
import struct
import sys

import foxglove.messages
from google.protobuf import descriptor_pb2
from google.protobuf.json_format import MessageToDict
from jsonschema import Draft202012Validator
from mcap.reader import make_reader
from mcap.records import Schema
from mcap_protobuf.decoder import DecoderFactory


def main(path: str) -> None:
    validators: dict = {}
    times: list = []
    topics: dict = {}
    factory = DecoderFactory()
    with open(path, "rb") as file:
        reader = make_reader(file, validate_crcs=True)
        summary = reader.get_summary()
        assert summary is not None, "no summary section"
        for schema, channel, message in reader.iter_messages(log_time_order=False):
            assert schema is not None, channel.topic
            times.append(message.log_time)
            if channel.message_encoding == "json":
                assert schema.encoding == "jsonschema", channel.topic
                if schema.id not in validators:
                    declared = json.loads(schema.data)
                    Draft202012Validator.check_schema(declared)
                    # A field that no schema names is a mistake of the writer's.
                    declared["additionalProperties"] = False
                    validators[schema.id] = Draft202012Validator(declared), list(declared["properties"])
                validator, fields = validators[schema.id]
                row = json.loads(message.data)
                validator.validate(row)
                if schema.name.startswith("foxglove."):
                    assert sorted(row) == sorted(sdk_fields(schema.name)), schema.name
            else:
                assert channel.message_encoding == schema.encoding == "protobuf", channel.topic
                decoded = factory.decoder_for("protobuf", schema)(message.data)
                row, fields = check_foxglove(schema, decoded, message.data)
            topic = topics.setdefault(
                channel.topic, {"schema": schema.name, "fields": fields, "log_times": [], "publish_times": [], "rows": []}
            )
            topic["fields"] = fields
            topic["log_times"].append(message.log_time)
            topic["publish_times"].append(message.publish_time)
            topic["rows"].append(row)
        assert times == sorted(times), "log_time goes back"
        metadata = {record.name: record.metadata for record in reader.iter_metadata()}
        attachments = {a.name: a.data.decode() for a in reader.iter_attachments()}
        json.dump(
            {
                "chunks": len(summary.chunk_indexes),
                "topics": topics,
                "metadata": metadata,
                "attachments": attachments,
            },
            sys.stdout,
        )


def described(files) -> dict:
    """Fields of every message of some files: name, number, type and label."""
    found: dict = {}
    for file in files:
        for message in file.message_type:
            found[f"{file.package}.{message.name}"] = sorted(
                (f.name, f.number, f.type, f.label, f.type_name) for f in message.field
            )
            for enum in message.enum_type:
                found[f"{file.package}.{message.name}.{enum.name}"] = sorted((v.name, v.number) for v in enum.value)
    return found


def sdk_schema(name):
    """The schema of a well-known message, of the Foxglove SDK."""
    return getattr(foxglove.messages, name.removeprefix("foxglove.")).get_schema()


def sdk_fields(name) -> list:
    files = descriptor_pb2.FileDescriptorSet.FromString(sdk_schema(name).data).file
    found = [message for file in files for message in file.message_type if f"{file.package}.{message.name}" == name]
    return [field.name for field in found[0].field]


def check_foxglove(schema, decoded, data):
    """A message of Foxglove's, by the SDK's own schema; what it says, and its fields."""
    sdk = sdk_schema(schema.name)
    in_file = descriptor_pb2.FileDescriptorSet.FromString(schema.data)
    in_sdk = descriptor_pb2.FileDescriptorSet.FromString(sdk.data)
    assert described(in_file.file) == described(in_sdk.file), f"{schema.name} is not the SDK's"
    same = Schema(id=schema.id, name=sdk.name, encoding=sdk.encoding, data=sdk.data)
    again = DecoderFactory().decoder_for("protobuf", same)(data)
    assert MessageToDict(again) == MessageToDict(decoded), schema.name
    fields = sdk_fields(schema.name)
    if schema.name == "foxglove.PointCloud":
        floats = struct.unpack(f"<{len(again.data) // 4}f", again.data)
        names = [field.name for field in again.fields]
        assert again.point_stride == 4 * len(names) and len(again.data) % again.point_stride == 0
        assert all(field.type == field.FLOAT32 and field.offset == 4 * i for i, field in enumerate(again.fields))
        points = [floats[i : i + len(names)] for i in range(0, len(floats), len(names))]
        return {"unix_ns": again.timestamp.ToNanoseconds(), "names": names, "points": points}, fields
    return {
        "unix_ns": again.timestamp.ToNanoseconds(),
        "format": again.format,
        "data": base64.b64encode(again.data).decode(),
    }, fields


if __name__ == "__main__":
    main(sys.argv[1])
