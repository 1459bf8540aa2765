//! Every comparator of the kernel tests is fed a wrong input once, and must fail: a comparison that
//! cannot fail says nothing. (Those of the reference room have such tests beside them.)

use brooklet_reference::compression::compression;
use brooklet_reference::dam_break;
use brooklet_reference::grid::count_cells::check_ranks;
use brooklet_reference::grid::list_neighbours::check_list;
use brooklet_reference::norms::{cloud_distance, norms};
use brooklet_reference::params::Grid;
use brooklet_reference::shared::lattice;
use brooklet_tests::compare::{Worst, check_cell, check_exact, report_exact};
use glam::DVec3;

#[test]
fn floats_out_of_tolerance_fail() {
    let mut worst = Worst::new("test", 1e-6);
    assert!(worst.check(1.0, 1.0 + 0.9e-6, 1.0).is_ok());
    assert!(worst.check(1.0, 1.0 + 1.1e-6, 1.0).is_err());
    assert!(worst.check(1.0, 1.0 + 1.1e-6, 2.0).is_ok());
    assert!(worst.check(-1.0, 1.0, 1.0).is_err());
    assert!(worst.check3([1.0, 2.0, 3.0], DVec3::new(1.0, 2.0, 3.0), 1.0).is_ok());
    assert!(worst.check3([1.0, 2.0, 3.0], DVec3::new(1.0, 3.0, 2.0), 1.0).is_err());
}

#[test]
fn nan_and_infinity_fail() {
    let mut worst = Worst::new("test", f64::MAX);
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        assert!(worst.check(bad, 1.0, 1.0).is_err(), "{bad}");
        assert!(worst.check3([0.0, bad, 0.0], DVec3::ZERO, 1.0).is_err(), "{bad}");
    }
    assert!(worst.check(1.0, f64::NAN, 1.0).is_err());
    assert!(worst.check(1.0, 1.0, f64::NAN).is_err());
    assert!(worst.check(1.0, 2.0, 0.0).is_err());
}

#[test]
#[should_panic(expected = "nothing was compared")]
fn comparing_nothing_fails() {
    Worst::new("test", 1.0).report(&brooklet_tests::device());
}

#[test]
#[should_panic(expected = "nothing was compared")]
fn comparing_no_integers_fails() {
    report_exact(&brooklet_tests::device(), "test", 0);
}

#[test]
fn unequal_integers_fail() {
    assert!(check_exact(&[1, 2, 3], &[1, 2, 3]).is_ok());
    assert!(check_exact(&[1, 2, 3], &[1, 3, 3]).is_err());
    assert!(check_exact(&[1, 2, 3], &[1, 2]).is_err());
    assert!(check_exact(&[], &[1]).is_err());
}

#[test]
fn wrong_cells_fail() {
    let grid = Grid { cells: [4, 3, 2], domain_cells: [4, 3, 2], cell_size_m: 1.0, support_m: 2.0 };
    assert!(check_cell(5, DVec3::new(1.5, 1.5, 0.5), &grid, 1e-6).is_ok());
    assert!(check_cell(6, DVec3::new(1.5, 1.5, 0.5), &grid, 1e-6).is_err());
    assert!(check_cell(24, DVec3::new(-0.5, 1.5, 0.5), &grid, 1e-6).is_ok());
    assert!(check_cell(0, DVec3::new(-0.5, 0.5, 0.5), &grid, 1e-6).is_err());
    assert!(check_cell(24, DVec3::new(f64::NAN, 0.5, 0.5), &grid, 1e-6).is_ok(), "NaN is outside");
    // Only at a face may both sides be right.
    assert!(check_cell(1, DVec3::new(0.999_999_9, 0.5, 0.5), &grid, 1e-6).is_ok());
    assert!(check_cell(1, DVec3::new(0.999_9, 0.5, 0.5), &grid, 1e-6).is_err());
}

#[test]
fn wrong_ranks_and_lists_fail() {
    assert!(check_ranks(&[0, 0, 1], &[1, 0, 0], 2).is_ok());
    assert!(check_ranks(&[0, 0, 1], &[1, 1, 0], 2).is_err());
    let points = lattice::points([3, 1, 1], 1.0);
    assert!(check_list(1, &[0, 2], &[0, 2], &points, 1.5, DVec3::ZERO, 1e-6).is_ok());
    assert!(check_list(1, &[0], &[0, 2], &points, 1.5, DVec3::ZERO, 1e-6).is_err());
    assert!(check_list(1, &[0, 2, 2], &[0, 2], &points, 1.5, DVec3::ZERO, 1e-6).is_err());
    assert!(check_list(0, &[1, 2], &[1], &points, 1.5, DVec3::ZERO, 1e-6).is_err());
}

#[test]
fn wrong_fields_and_clouds_are_told_apart() {
    let points = lattice::points([5, 5, 5], 0.1);
    let moved: Vec<DVec3> = points.iter().map(|p| *p + DVec3::X * 0.05).collect();
    assert!(cloud_distance(&points, &moved, 0.1).unwrap().chamfer > 0.4);
    assert!(norms(&[1.0, 2.0], &[1.0, 2.5]).unwrap().l_inf == 0.5);
    let squeezed: Vec<DVec3> = points.iter().map(|p| *p * 0.9).collect();
    assert!(compression(&squeezed, DVec3::ZERO, DVec3::splat(0.5), 0.1).unwrap().all.max > 0.1);
}

#[test]
fn a_wrong_front_is_told_apart() {
    let experiment: Vec<(f64, f64)> = (5..90).map(|i| (0.1 * f64::from(i), 1.0 + 0.165 * f64::from(i))).collect();
    let slow: Vec<(f64, f64)> = (0..100).map(|i| (0.1 * f64::from(i), 1.0 + 0.12 * f64::from(i))).collect();
    let comparison = dam_break::compare(&slow, &experiment).unwrap();
    assert!(comparison.shifted_rmse > 1.0 && comparison.expected_slope - comparison.slope > 0.4);
}
