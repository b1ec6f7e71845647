// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <optional>

#include "fitting/records/recorded_curve.h"
#include "fitting/samples/outliers.h"
#include "numerics/linear/statistics.h"
#include "optim/fit/least_squares.h"
#include "problems/statement/statement.h"

/// Scales of a machine (friction, stiffness, mass, ...) from a curve of it that was recorded over
/// the cycle, such as its torque (docs/optimisation.md, "Fits to recorded curves").
namespace camlaw::problems {

struct RecordFitOptions {
  optim::Loss loss = optim::Loss::None;
  double confidence = 0.95;
  bool place_shift = false;  ///< the record's zero of the place is unknown: fitted along
  bool value_shift = false;  ///< and that of its value
  /// Seconds: the best values so far are the answer then, which is not to be trusted.
  std::optional<double> time_limit = {};
  double time_spent = 0;  ///< seconds of it that have passed before the fit, or that it is to leave
  /// Set where the fit is to end without an answer: it throws optim::Interrupted.
  const std::atomic<bool>* stop = nullptr;
};

struct RecordFit {
  optim::FitResult fit;
  ProblemStatement machine;     ///< with the fitted values
  std::vector<double> model;    ///< at the record's places, shifts included
  optim::ResidualPattern left;  ///< what the residuals look like, as the loss counts them
  Outliers outliers;
  std::string distrust;  ///< why the values should not be taken for the machine's; may be empty
};

/// The machine's continuous variables, of mechanism and law, by least squares of
///   f(x - x_0; p) + y_0 - y,
/// f the recorded response. A place beyond the cycle of 360 deg is one of another turn. Throws
/// std::invalid_argument: nothing varies, no more places than unknowns, variables that are to be
/// chosen from values, places outside a curve that is not a whole turn, and what optim::fit throws.
RecordFit fit_record(const ProblemStatement& machine, const RecordedCurve& record,
                     const RecordFitOptions& options = {});

}  // namespace camlaw::problems
