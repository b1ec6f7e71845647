// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "kinematics/peaks.h"

/// What is physically possible: the rulers that laws are measured with. Proofs: docs/theory.md,
/// "Analytic limits".
namespace camlaw {

/// Least peak acceleration C of any rest-to-rest law whose peak velocity is at most B: B^2 / (B -
/// 1) up to B = 2, 4 beyond. Infinite for B <= 1, which no such law reaches.
double least_acceleration(double B);

/// Least time of any rest-to-rest motion over unit stroke with peaks no larger than B, C and D,
/// each of which may be infinite: 1/B + B/C + C/D where C/D <= B/C and B/C + C/D <= 1/B, and the
/// time of the S-curve that does without the phases it cannot reach elsewhere.
double least_time(double B, double C, double D);

/// Least peak jerk D of any rest-to-rest law whose peaks of velocity and acceleration are at most B
/// and C, each of which may be infinite: with b = min(B, 2) and c = min(C, 2 b^2 / (b - 1)) it is
/// b c^2 / (c (b - 1) - b^2), where least_time(B, C, D) = 1. Infinite where C <=
/// least_acceleration.
double least_jerk(double B, double C);

/// The limit index lambda = least_time(B, C, D) of a law's own peaks: 1 for a law than which none
/// is faster with these peaks, less for every other. Only rest-to-rest laws have it.
std::optional<double> limit_index(const Peaks<double>& peaks);

}  // namespace camlaw
