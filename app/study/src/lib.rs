//! How much error does a millisecond buy, and where does it break?
//!
//! A study is a list of [`Task`]s: each runs one case with one setting and gives plain data, an
//! [`Outcome`]. The [`Store`] keeps them as they come, so that a study that was killed goes on where it
//! was, and parts that ran elsewhere can be joined. Reports are functions of tasks and outcomes alone.
//!
//! | part | question |
//! |---|---|
//! | [`error`] | work-precision: one knob a curve, error against GPU time per simulated second |
//! | [`validation`] | published cases, each with a tolerance that was fixed beforehand |
//! | [`precision`] | what lower precision and smaller tiers cost each shipped scene |
//! | [`stability`] | the extreme cases over precisions and tiers, and maps of where a solver holds |
//! | [`tune`] | the cheapest setting for an error, the most exact one for a time |

pub mod backend;
pub mod case;
pub mod energy;
pub mod error;
mod figure;
pub mod knob;
pub mod method;
pub mod precision;
pub mod report;
mod runner;
mod sample;
mod session;
mod setup;
pub mod stability;
mod store;
mod study;
mod task;
pub mod tune;
pub mod validation;

pub use figure::{Figure, Verdict};
pub use runner::Runner;
pub use sample::{Force, Sample};
pub use session::{Event, Fault, Session, StudyError};
pub use setup::{Setup, SetupResult};
pub use store::{RESULTS, Store, StoreError};
pub use study::{Study, shard};
pub use task::{Cost, Outcome, Series, State, Task};
