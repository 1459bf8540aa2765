//! Times of stages out of `/gpu/passes`, message by message, without keeping any text.

use std::{collections::HashMap, fmt};

use serde::de::{DeserializeSeed, Deserializer, IgnoredAny, MapAccess, Visitor};

/// The stages met so far, each with its number.
#[derive(Debug, Default)]
pub(crate) struct StageNumbers {
    /// By number.
    pub names: Vec<String>,
    numbers: HashMap<String, usize>,
    /// The keys of the message before, which most messages repeat.
    order: Vec<(String, usize)>,
}

impl StageNumbers {
    /// The number of a stage, new or not.
    pub fn number(&mut self, stage: &str) -> usize {
        if let Some(number) = self.numbers.get(stage) {
            return *number;
        }
        self.numbers.insert(stage.into(), self.names.len());
        self.names.push(stage.into());
        self.names.len() - 1
    }

    fn number_of_key(&mut self, place: usize, key: &str) -> Option<usize> {
        if let Some((known, number)) = self.order.get(place)
            && known == key
        {
            return Some(*number);
        }
        let number = self.number(key.strip_suffix("_ms")?);
        self.order.truncate(place);
        if self.order.len() == place {
            self.order.push((key.into(), number));
        }
        Some(number)
    }

    /// Reads a message: each stage's number and time goes to `each`. Returns `wall_s`.
    pub fn read(&mut self, message: &[u8], each: &mut dyn FnMut(usize, f64)) -> Result<f64, serde_json::Error> {
        let mut json = serde_json::Deserializer::from_slice(message);
        let wall_s = PassesSeed { stages: self, each }.deserialize(&mut json)?;
        json.end()?;
        Ok(wall_s)
    }
}

struct PassesSeed<'a> {
    stages: &'a mut StageNumbers,
    each: &'a mut dyn FnMut(usize, f64),
}

impl<'de> DeserializeSeed<'de> for PassesSeed<'_> {
    type Value = f64;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<f64, D::Error> {
        deserializer.deserialize_map(self)
    }
}

impl<'de> Visitor<'de> for PassesSeed<'_> {
    type Value = f64;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the times of a frame's stages")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<f64, A::Error> {
        let mut wall_s = 0.0;
        let mut place = 0;
        while let Some(key) = map.next_key::<std::borrow::Cow<'de, str>>()? {
            match &*key {
                "frame" => drop(map.next_value::<IgnoredAny>()?),
                "wall_s" => wall_s = map.next_value()?,
                key => {
                    let number = self.stages.number_of_key(place, key);
                    let ms = map.next_value()?;
                    if let Some(number) = number {
                        (self.each)(number, ms);
                    }
                    place += 1;
                }
            }
        }
        Ok(wall_s)
    }
}

/// Values of one kind with bounded memory: sums and extremes of all, quantiles of a sample that is drawn
/// without favour (Vitter 1985, algorithm R) and is all of them up to [`Sample::ROOM`].
#[derive(Clone, Debug)]
pub(crate) struct Sample {
    pub count: u64,
    pub sum: f64,
    pub largest: f64,
    kept: Vec<f32>,
    random: u64,
}

impl Default for Sample {
    fn default() -> Self {
        Self { count: 0, sum: 0.0, largest: f64::MIN, kept: Vec::new(), random: 0x9e37_79b9_7f4a_7c15 }
    }
}

impl Sample {
    /// Values kept: 18 minutes of 60 a second; beyond, quantiles are off by less than half a percent of rank.
    pub const ROOM: usize = 1 << 16;

    pub fn add(&mut self, value: f64) {
        self.count += 1;
        self.sum += value;
        self.largest = self.largest.max(value);
        if self.kept.len() < Self::ROOM {
            self.kept.push(value as f32);
            return;
        }
        // xorshift64 (Marsaglia 2003): which value gives way needs no better.
        self.random ^= self.random << 13;
        self.random ^= self.random >> 7;
        self.random ^= self.random << 17;
        let place = ((u128::from(self.random) * u128::from(self.count)) >> 64) as usize;
        if let Some(kept) = self.kept.get_mut(place) {
            *kept = value as f32;
        }
    }

    /// What is said of it; none of nothing.
    pub fn quantiles(&self) -> Option<Quantiles> {
        let mut sorted = self.kept.clone();
        sorted.sort_unstable_by(f32::total_cmp);
        let last = sorted.len().checked_sub(1)?;
        let middle = sorted.len() / 2;
        let median = if sorted.len() % 2 == 1 {
            f64::from(sorted[middle])
        } else {
            0.5 * (f64::from(sorted[middle - 1]) + f64::from(sorted[middle]))
        };
        // Nearest rank: a time that was really measured.
        let rank = (0.95 * sorted.len() as f64).ceil() as usize;
        Some(Quantiles {
            count: self.count,
            median,
            p95: f64::from(sorted[rank.saturating_sub(1).min(last)]),
            mean: self.sum / self.count as f64,
            max: self.largest,
        })
    }
}

/// Quantiles and extremes of values of one kind.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Quantiles {
    /// Number of values.
    pub count: u64,
    /// Half of them are no larger.
    pub median: f64,
    /// 95 of 100 are no larger.
    pub p95: f64,
    /// Their mean.
    pub mean: f64,
    /// The largest.
    pub max: f64,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stages_keep_their_number_whatever_their_order() {
        let mut stages = StageNumbers::default();
        let mut read = |text: &str| {
            let mut got = Vec::new();
            let wall_s = stages.read(text.as_bytes(), &mut |stage, ms| got.push((stage, ms)));
            wall_s.map(|wall_s| (wall_s, got)).map_err(|_| ())
        };
        assert_eq!(read(r#"{"frame":0,"wall_s":0.5,"a_ms":1,"b_ms":2.5}"#), Ok((0.5, vec![(0, 1.0), (1, 2.5)])));
        assert_eq!(read(r#"{"frame":1,"wall_s":1,"b_ms":3}"#), Ok((1.0, vec![(1, 3.0)])));
        assert_eq!(read(r#"{"c_ms":4,"frame":1,"a_ms":5,"b_ms":6}"#), Ok((0.0, vec![(2, 4.0), (0, 5.0), (1, 6.0)])));
        assert_eq!(read(r#"{"a_ms":"x"}"#), Err(()));
        assert_eq!(read(r#"{"a_ms":1} "#), Ok((0.0, vec![(0, 1.0)])));
        assert_eq!(read(r#"{"a_ms":1}}"#), Err(()));
        assert_eq!(stages.names, ["a", "b", "c"]);
    }

    #[test]
    fn a_sample_is_exact_while_it_fits_and_near_beyond() {
        let mut few = Sample::default();
        (1..=100).rev().for_each(|value| few.add(f64::from(value)));
        let quantiles = few.quantiles().unwrap();
        assert_eq!((quantiles.median, quantiles.p95, quantiles.mean, quantiles.max), (50.5, 95.0, 50.5, 100.0));
        let mut many = Sample::default();
        (0..1_000_000).for_each(|value| many.add(f64::from(value) * 1e-6));
        let quantiles = many.quantiles().unwrap();
        // Three standard errors of a quantile of 65,536 values.
        assert!((quantiles.median - 0.5).abs() < 3.0 * 0.5 / 256.0, "{quantiles:?}");
        assert!((quantiles.p95 - 0.95).abs() < 3.0 * 0.218 / 256.0, "{quantiles:?}");
        assert_eq!((quantiles.count, many.kept.len()), (1_000_000, Sample::ROOM));
        assert_eq!(Sample::default().quantiles(), None);
    }
}
