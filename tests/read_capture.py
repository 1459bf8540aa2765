"""Reads a capture with the Python package `mcap` and prints what it holds as JSON.

Nothing here is Brooklet's own code, so what this prints is what any other program sees.

    python read_capture.py capture.mcap
"""

import json
import sys

from mcap.reader import make_reader


def main(path: str) -> None:
    with open(path, "rb") as file:
        reader = make_reader(file, validate_crcs=True)
        summary = reader.get_summary()
        assert summary is not None, "no summary section"
        topics: dict = {}
        for schema, channel, message in reader.iter_messages():
            assert channel.message_encoding == "json", channel.message_encoding
            assert schema is not None and schema.encoding == "jsonschema", channel.topic
            declared = json.loads(schema.data)
            row = json.loads(message.data)
            check(channel.topic, declared, row)
            topic = topics.setdefault(
                channel.topic,
                {"fields": list(declared["properties"]), "log_times": [], "rows": []},
            )
            topic["log_times"].append(message.log_time)
            topic["rows"].append(row)
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


def check(topic: str, schema: dict, row: dict) -> None:
    """The part of JSON Schema that the captures use."""
    types = {"integer": int, "number": (int, float), "string": str}
    for key in schema["required"]:
        assert key in row, f"{topic}: {key} is missing"
    for key, value in row.items():
        about = schema["properties"].get(key)
        assert about is not None, f"{topic}: {key} is not in the schema"
        assert isinstance(value, types[about["type"]]), f"{topic}: {key} is {value!r}"
        assert value in about.get("enum", [value]), f"{topic}: {key} is {value!r}"


if __name__ == "__main__":
    main(sys.argv[1])
