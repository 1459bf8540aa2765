//! f64 CPU twin of every stage, and error norms; knows no GPU
