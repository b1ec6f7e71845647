// SPDX-License-Identifier: MIT
#pragma once

#include <string>

/// How near the answers come to known ones: tables of README.md, printed to standard output.
namespace camlaw::benchmarks {

/// The Hock-Schittkowski problems on every back end.
void print_hock_schittkowski_table();
/// Fronts that are known, by sweep and by NSGA-II.
void print_known_fronts();
/// Fronts of three objectives and more: how even they are, and against NSGA-II.
void print_even_fronts();
/// The cam shape by its number of radii.
void print_cam_shape_accuracy();
/// Fits of NIST's nonlinear regression sets, whose files lie in a folder.
void print_nist_table(const std::string& folder);

}  // namespace camlaw::benchmarks
