//! The particle-fluid simulation: scene, particles, neighbour grid, solvers, measures
