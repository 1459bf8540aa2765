//! Captures that were cut, flipped or mixed up: every whole chunk is read and recovered, and what is wrong is
//! counted.

use std::{collections::BTreeSet, fs, io::Cursor, path::PathBuf};

use brooklet_capture::{Capture, Item, check, chrome_trace, read, recover, summarize};
use brooklet_tests::captures::{CHUNK, events::everything, framing};
use rand::{Rng, RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// A message as it was written: topic, time and content.
type Seen = (String, u64, Vec<u8>);

/// Every message that is given, and how the file ended.
fn seen(bytes: &[u8]) -> (Vec<Seen>, brooklet_capture::Ending) {
    let mut messages = Vec::new();
    let ending = read(Cursor::new(bytes), bytes.len() as u64, "case.mcap", &mut |item| {
        if let Item::Message(message) = item {
            messages.push((message.channel.topic.clone(), message.log_time, message.data.to_vec()));
        }
        Ok(())
    });
    (messages, ending.unwrap_or_else(|error| panic!("{error}: {bytes:02x?}")))
}

/// Begin and end of each chunk, by the format's description.
fn chunks(bytes: &[u8]) -> Vec<(usize, usize)> {
    let mut found = Vec::new();
    let mut at = mcap::MAGIC.len();
    while let Some((opcode, end)) = framing(bytes, at) {
        if opcode == CHUNK {
            found.push((at, end));
        }
        at = end;
    }
    found
}

/// Messages of the chunk at a place of the whole file, by the library's own reader.
fn messages_of(bytes: &[u8], chunk: (usize, usize)) -> usize {
    brooklet_tests::captures::records(bytes)
        .iter()
        .find(|record| record.end == chunk.1)
        .map_or(0, |record| record.messages)
}

struct Case {
    bytes: Vec<u8>,
    /// Messages of the chunks that no damage touched.
    intact: usize,
    /// Whether the summary at the end is there, which says again which topics there are.
    is_named: bool,
}

/// A capture with some bytes flipped, some pieces overwritten, and maybe its end cut off.
fn damage(rng: &mut ChaCha8Rng, whole: &[u8]) -> Case {
    let mut bytes = whole.to_vec();
    let mut touched: Vec<(usize, usize)> = Vec::new();
    for _ in 0..rng.random_range(0..4) {
        let at = rng.random_range(mcap::MAGIC.len()..bytes.len());
        if rng.random_bool(0.6) {
            bytes[at] ^= 1 << rng.random_range(0..8);
            touched.push((at, at + 1));
        } else {
            let end = (at + rng.random_range(1..400)).min(bytes.len());
            rng.fill_bytes(&mut bytes[at..end]);
            touched.push((at, end));
        }
    }
    if rng.random_bool(0.4) {
        let cut = rng.random_range(mcap::MAGIC.len()..bytes.len());
        bytes.truncate(cut);
        touched.push((cut, whole.len()));
    }
    let is_hit = |(begin, end): (usize, usize)| touched.iter().any(|(from, to)| *from < end && begin < *to);
    let chunks = chunks(whole);
    let intact = chunks.iter().filter(|chunk| !is_hit(**chunk)).map(|chunk| messages_of(whole, *chunk)).sum();
    let summary = chunks.last().map_or(0, |last| last.1);
    Case { bytes, intact, is_named: !is_hit((summary, whole.len())) }
}

#[test]
fn every_whole_chunk_of_a_damaged_capture_is_given() {
    let whole = everything();
    let (all, ending) = seen(&whole);
    assert!(ending.complete && ending.damaged_bytes == 0, "{ending:?}");
    assert!(chunks(&whole).len() > 10);
    let mut rng = ChaCha8Rng::seed_from_u64(20_261_122);
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("case.mcap");
    let (mut harmed, mut given) = (0, 0);
    let cases = 1500;
    for number in 0..cases {
        let case = damage(&mut rng, &whole);
        let (messages, ending) = seen(&case.bytes);
        // Nothing that was not written, in the order of the file.
        let mut rest = all.iter();
        assert!(messages.iter().all(|message| rest.any(|known| known == message)), "case {number}");
        if case.is_named {
            assert!(messages.len() >= case.intact, "case {number}: {} of {}", messages.len(), case.intact);
        } else {
            let unnamed = ending.unnamed_messages as usize;
            assert!(messages.len() + unnamed >= case.intact, "case {number}: lost without a word");
        }
        assert!(messages.len() == all.len() || !ending.complete, "case {number}: a loss that nobody is told of");
        harmed += usize::from(messages.len() < all.len());
        given += messages.len();

        if number % 5 > 0 {
            continue;
        }
        fs::write(&path, &case.bytes).unwrap();
        let mut mended = Vec::new();
        recover(&path, &mut mended, "mended.mcap").unwrap();
        if messages.is_empty() {
            continue;
        }
        let (again, ending) = seen(&mended);
        assert!(ending.complete, "case {number}: {ending:?}");
        assert_eq!(again, messages, "case {number}");
        summarize(&path).unwrap();
        check(&path).unwrap();
        chrome_trace(&path, std::io::sink(), "trace.json").unwrap();
    }
    println!("{harmed} of {cases} cases lost something; {given} messages were given");
    assert!(harmed * 2 > cases && given > 10 * cases, "the damage is worth the name, and so is what is left");
}

#[test]
fn a_recovered_capture_is_what_the_library_reads() {
    let whole = everything();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("cut.mcap");
    fs::write(&path, &whole[..whole.len() * 2 / 3]).unwrap();
    let mut mended = Vec::new();
    let ending = recover(&path, &mut mended, "mended.mcap").unwrap();
    assert!(!ending.complete && ending.messages > 0);
    let topics: BTreeSet<String> =
        mcap::MessageStream::new(&mended).unwrap().map(|message| message.unwrap().channel.topic.clone()).collect();
    assert!(topics.contains("/gpu/frame"), "{topics:?}");
    let capture = Capture::read(Cursor::new(&mended), mended.len() as u64, "mended.mcap").unwrap();
    assert!(capture.complete && capture.metadata["recovered"]["messages"] == ending.messages.to_string());
    assert_eq!(capture.attachments[0].data, b"spacing_m = 0.02\n");
    assert_eq!(capture.metadata["build"]["version"], "0.1.0");
}

/// A capture with `from` replaced by `to` of the same length wherever it stands, and checksums that fit.
fn edited(from: &str, to: &str) -> PathBuf {
    assert_eq!(from.len(), to.len());
    let mut bytes = everything();
    let places: Vec<usize> =
        bytes.windows(from.len()).enumerate().filter(|(_, part)| *part == from.as_bytes()).map(|(at, _)| at).collect();
    assert!(!places.is_empty(), "{from} is in the capture");
    for at in places {
        bytes[at..at + to.len()].copy_from_slice(to.as_bytes());
    }
    // Without checksums, so that what was edited is read.
    for (begin, _) in chunks(&bytes) {
        bytes[begin + 9 + 24..begin + 9 + 28].fill(0);
    }
    let data_end =
        (0..bytes.len() - 13).rev().find(|at| bytes[*at] == 0x0f && bytes[at + 1..at + 9] == 4_u64.to_le_bytes());
    let at = data_end.unwrap() + 9;
    bytes[at..at + 4].fill(0);
    let folder = tempfile::tempdir().unwrap().keep();
    let path = folder.join("edited.mcap");
    fs::write(&path, bytes).unwrap();
    path
}

#[test]
fn check_finds_what_is_wrong() {
    let good = edited("begun", "begun");
    let report = check(&good).unwrap();
    assert!(report.is_good(), "{:?}", report.problems);
    assert_eq!(report.trust.zero_spans, 1);
    assert!(report.notes.iter().any(|note| note.contains("took no time")), "{:?}", report.notes);
    for (from, to, wanted) in [
        ("\"timing\":\"inside_passes\"", "\"timing\":\"inside_worlds\"", "is none of"),
        ("\"paused\":true", "\"paused\":8888", "no boolean"),
        ("\"frame\":3,\"wall_s\"", "\"frume\":3,\"wall_s\"", "`frame` is missing"),
        ("\"flagged_spans\":1", "\"flagged_spans\":0", "0 spans are flagged, 1 by kind"),
        ("\"flags\":[\"ok\",\"ok\",\"zero\"]", "\"flags\":[\"ok\",\"ok\",\"okay\"]", "is none of"),
        ("zero_spans\u{1}\0\0\x001", "zero_spans\u{1}\0\0\x007", "states zero_spans = 7, and there are 1"),
    ] {
        let path = edited(from, to);
        let report = check(&path).unwrap();
        assert!(!report.is_good(), "{from} to {to} is not found");
        assert!(report.problems.iter().any(|problem| problem.contains(wanted)), "{wanted}: {:?}", report.problems);
    }
    let other = edited("format_version\u{1}\0\0\x002", "format_version\u{1}\0\0\x009");
    for error in [check(&other).unwrap_err(), summarize(&other).unwrap_err(), Capture::open(&other).unwrap_err()] {
        assert!(error.to_string().contains("format version 9, and this program reads version 2"), "{error}");
    }
}

#[test]
fn times_that_go_back_are_found() {
    let mut bytes = Vec::new();
    {
        let mut writer = mcap::Writer::new(Cursor::new(&mut bytes)).unwrap();
        let schema = writer.add_schema("brooklet.Log", "jsonschema", br#"{"type":"object"}"#).unwrap();
        let version = [("format_version".to_string(), "2".to_string())].into();
        let channel = writer.add_channel(schema, "/log", "json", &version).unwrap();
        for (sequence, log_time) in [(0, 10), (1, 9), (2, 11)] {
            let header =
                mcap::records::MessageHeader { channel_id: channel, sequence, log_time, publish_time: log_time };
            writer.write_to_known_channel(&header, b"{}").unwrap();
        }
        writer.finish().unwrap();
    }
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("back.mcap");
    fs::write(&path, bytes).unwrap();
    let report = check(&path).unwrap();
    assert_eq!(report.problem_count, 1, "{:?}", report.problems);
    assert!(report.problems[0].contains("log_time goes back by 1 ns"), "{:?}", report.problems);
}
