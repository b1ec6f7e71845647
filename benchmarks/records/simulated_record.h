// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "kinematics/laws/catalogue.h"

/// Measured motions whose law is known, to see how far a fit's answers can be trusted.
namespace camlaw::benchmarks {

/// What is done to a record beside noise and rounding.
enum class Disturbance { None, Drift, Outliers, OncePerTurn };

/// One motion as a measuring machine would write it down. Places in deg; values in mm, mm/deg or
/// mm/deg2 by `order`.
struct SimulatedRecord {
  Member law;                 ///< with its coefficients, drawn at random
  bool skewed = false;        ///< whether the crossover is not where the law has it
  int order = 0;              ///< 0 displacement, 1 velocity, 2 acceleration
  double begin = 0, end = 1;  ///< of the motion, deg
  double stroke = 1, zero = 0;
  std::size_t count = 0;   ///< of samples
  double noise = 0;        ///< standard deviation, normal and independent
  double step = 0;         ///< what values are rounded to; 0: to nine digits
  std::string table = {};  ///< the text of the file

  /// The motion without noise.
  double value(double place) const;
  /// Of noise and rounding together.
  double deviation() const;
};

/// The record of a number: a law of those that fits try, each as likely as the next, one in five
/// skewed where it can be; 60 to 1000 samples; strokes of 4 to 100 mm, up or down; noise from 0.1
/// um to 1 % of the stroke, even in its logarithm; three in five rounded to 0.1, 1 or 10 um (or as
/// coarsely as that is against the stroke, of velocities and accelerations). The same number, the
/// same record.
SimulatedRecord simulated_record(std::uint64_t number, Disturbance disturbance = Disturbance::None);

}  // namespace camlaw::benchmarks
