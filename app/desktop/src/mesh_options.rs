//! `brooklet mesh` on the command line.

use std::path::PathBuf;

use clap::Args;

use crate::shared_options::DeviceOptions;

/// `brooklet mesh`.
#[derive(Clone, Debug, Args)]
pub struct MeshOptions {
    /// PLY file of particles, ASCII or binary: x, y and z are read
    #[arg(value_name = "PARTICLES")]
    pub particles: PathBuf,
    /// The mesh's file, PLY or OBJ by what its name ends in; replaced if it exists
    #[arg(long, value_name = "FILE")]
    pub out: PathBuf,
    /// Distance of neighbouring particles, m; estimated if not given
    #[arg(long, value_name = "M", value_parser = metres, allow_negative_numbers = true)]
    pub spacing: Option<f64>,
    /// Side of a cell: in m, or, with an x behind it, in spacings
    #[arg(long, value_name = "M|RATIOx", default_value = "0.5x", allow_negative_numbers = true)]
    pub cell: CellSide,
    /// Corners of a box whose walls the fluid ends at, m; no walls if not given
    #[arg(long, num_args = 6, value_names = ["X0", "Y0", "Z0", "X1", "Y1", "Z1"], allow_negative_numbers = true)]
    pub walls: Option<Vec<f64>>,
    /// The device.
    #[command(flatten)]
    pub device: DeviceOptions,
    /// Print what was done as JSON, and nothing else, on standard output
    #[arg(long)]
    pub json: bool,
}

/// Side of a cell of the mesh's grid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CellSide {
    /// m.
    Metres(f64),
    /// Over the spacing.
    Ratio(f64),
}

impl std::str::FromStr for CellSide {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let wrong = |_| "must be a positive number of metres, or of spacings as in 0.5x".into();
        match text.strip_suffix('x') {
            Some(ratio) => metres(ratio).map(Self::Ratio).map_err(wrong),
            None => metres(text).map(Self::Metres).map_err(wrong),
        }
    }
}

/// A length that positions of 1e12 m have something of.
fn metres(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(metres) if (1.0e-12..=1.0e12).contains(&metres) => Ok(metres),
        _ => Err("must be a number of metres from 1e-12 to 1e12".into()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cell_is_a_length_or_a_ratio() {
        assert_eq!("0.01".parse(), Ok(CellSide::Metres(0.01)));
        assert_eq!("1.5x".parse(), Ok(CellSide::Ratio(1.5)));
        for wrong in ["", "x", "0", "-1x", "nan", "inf", "1e300", "1 m"] {
            assert!(wrong.parse::<CellSide>().is_err(), "{wrong}");
        }
    }
}
