// SPDX-License-Identifier: MIT
#pragma once

/// How near the answers come to known ones: tables of README.md, printed to standard output.
namespace camlaw::benchmarks {

/// The Hock-Schittkowski problems on every back end.
void print_hock_schittkowski_table();
/// Fronts that are known, by sweep and by NSGA-II.
void print_known_fronts();
/// The cam shape by its number of radii.
void print_cam_shape_accuracy();

}  // namespace camlaw::benchmarks
