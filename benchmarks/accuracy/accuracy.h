// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

/// How near the answers come to known ones: tables of README.md, printed to standard output.
namespace camlaw::benchmarks {

/// The Hock-Schittkowski problems on every back end.
void print_hock_schittkowski_table();
/// Fronts that are known, by sweep and by NSGA-II, with this many points.
void print_known_fronts(std::size_t points);
/// The cam shape by its number of radii.
void print_cam_shape_accuracy();

}  // namespace camlaw::benchmarks
