//! Damage that knows TOML and what a scene is made of.

use rand::RngExt;
use rand_chacha::ChaCha8Rng;

const KEYS: &[&str] = &[
    "summary",
    "spacing_m",
    "gravity_m_s2",
    "domain",
    "min_m",
    "max_m",
    "walls",
    "periodic",
    "dimensions",
    "fluid",
    "block",
    "sphere",
    "centre_m",
    "radius_m",
    "velocity_m_s",
    "rest_density_kg_m3",
    "solver",
    "method",
    "dt_s",
    "substeps",
    "support_ratio",
    "max_speed_m_s",
    "neighbour_slots",
    "pbf",
    "iterations",
    "relaxation",
    "cfm",
    "s_corr_k",
    "s_corr_distance_ratio",
    "forces",
    "xsph",
    "vorticity_m_s",
    "camera",
    "eye_m",
    "target_m",
    "fov_deg",
    "outputs",
    "seconds",
    "images",
    "width_px",
    "height_px",
    "measure_every_steps",
    "no_such_key",
    "\"\"",
    "'a b'",
    "ключ",
];

const VALUES: &[&str] = &[
    "0",
    "1",
    "-1",
    "2",
    "3",
    "7",
    "0.5",
    "-0.0",
    "0.1",
    "1e-6",
    "1e-7",
    "1e6",
    "1e7",
    "1e30",
    "1e-30",
    "1e308",
    "1e-320",
    "1e400",
    "nan",
    "-nan",
    "inf",
    "-inf",
    "255",
    "1000",
    "1001",
    "1024",
    "8192",
    "10000",
    "65536",
    "65537",
    "16777216",
    "16777217",
    "2147483648",
    "4294967295",
    "4294967296",
    "9223372036854775807",
    "-9223372036854775808",
    "9223372036854775808",
    "0x7fffffff",
    "0b1",
    "1_000",
    "true",
    "false",
    "\"text\"",
    "\"\"",
    "'pbf'",
    "\"pbf\"",
    "\"\\u0000\"",
    "\"\"\"a\nb\"\"\"",
    "1979-05-27T07:32:00Z",
    "07:32:00",
    "[]",
    "{}",
    "[0, 0, 0]",
    "[1, 1, 1]",
    "[nan, 0, 0]",
    "[0, 0]",
    "[0, 0, 0, 0]",
    "[[0]]",
    "[1e6, 1e6, 1e6]",
    "[-1e6, -1e6, -1e6]",
    "{ min_m = [0, 0, 0] }",
    "{ min_m = [0, 0, 0], max_m = [0.3, 0.3, 0.3] }",
    "{ centre_m = [0.4, 0.4, 0.4], radius_m = 0.3 }",
];

const MARKS: &[&str] =
    &["=", "[", "]", "[[", "]]", "{", "}", ",", ".", "#", "\"", "'", "\n", "\r\n", " ", "\"\"\"", "\u{feff}", "\0"];

fn any<'a>(rng: &mut ChaCha8Rng, of: &[&'a str]) -> &'a str {
    of[rng.random_range(0..of.len())]
}

/// Words, marks and gaps of a text; together they are the text.
fn tokens(text: &str) -> Vec<&str> {
    let is_word = |c: char| c.is_alphanumeric() || "_.+-\"".contains(c);
    let mut tokens = Vec::new();
    let mut start = 0;
    let mut previous: Option<bool> = None;
    for (at, c) in text.char_indices() {
        let word = is_word(c);
        if previous.is_some_and(|before| !before || !word) {
            tokens.push(&text[start..at]);
            start = at;
        }
        previous = Some(word);
    }
    tokens.push(&text[start..]);
    tokens
}

/// `text` with a word or a mark replaced, doubled, gone or moved.
pub fn replace_token(rng: &mut ChaCha8Rng, text: &str) -> String {
    let mut tokens: Vec<String> = tokens(text).into_iter().map(String::from).collect();
    let at = rng.random_range(0..tokens.len());
    let words: Vec<usize> = (0..tokens.len()).filter(|i| tokens[*i].chars().any(char::is_alphanumeric)).collect();
    let word = if words.is_empty() { at } else { words[rng.random_range(0..words.len())] };
    let is_number = tokens[word].starts_with(|c: char| c.is_ascii_digit() || c == '-');
    match rng.random_range(0..10) {
        // Mostly what stays TOML: values for values, keys for keys.
        0..=4 if is_number => tokens[word] = any(rng, VALUES).into(),
        5 if is_number => tokens[word] = near(rng, &tokens[word]),
        0..=4 => tokens[word] = any(rng, KEYS).into(),
        6 => tokens[at] = any(rng, MARKS).into(),
        7 => tokens[at].clear(),
        8 => tokens[at] = tokens[at].repeat(rng.random_range(2..40)),
        _ => {
            let other = rng.random_range(0..tokens.len());
            tokens.swap(word, other);
        }
    }
    tokens.concat()
}

/// A number of another size: scenes of all scales, few of which are refused.
fn near(rng: &mut ChaCha8Rng, number: &str) -> String {
    let value: f64 = number.parse().unwrap_or(1.0);
    let scaled = value * 2f64.powi(rng.random_range(-12..13));
    if rng.random_bool(0.5) { format!("{scaled}") } else { format!("{}", scaled.round() as i64) }
}

/// A `--set` of something that is there, or nearly.
pub fn setting(rng: &mut ChaCha8Rng) -> String {
    let path: Vec<&str> = match rng.random_range(0..6) {
        0 => vec!["solver", any(rng, KEYS)],
        1 => vec!["solver", "pbf", any(rng, KEYS)],
        2 => vec!["forces", any(rng, KEYS)],
        3 => vec!["outputs", any(rng, KEYS)],
        4 => vec!["fluid", any(rng, &["0", "1", "99", "-1", "x"]), any(rng, KEYS), any(rng, KEYS)],
        _ => (0..rng.random_range(1..4)).map(|_| any(rng, KEYS)).collect(),
    };
    let sign = any(rng, &["=", "=", "=", " = ", "", "=="]);
    format!("{}{sign}{}", path.join("."), any(rng, VALUES))
}
