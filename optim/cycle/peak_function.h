// SPDX-License-Identifier: MIT
#pragma once

#include "optim/cycle/scales.h"

namespace camlaw::optim {

/// The highest value of a curve over the cycle (Lowest: the lowest, Magnitude: the highest |value|)
/// as a function of the design. It is not smooth where one peak overtakes another: there the
/// derivatives are those of the highest place found. It is looked for among samples, of which a
/// narrow one may escape; Function::proved() looks so that intervals prove it. Its shape is that of
/// the peak. Inputs are all of the design's `variables`.
Function peak_function(const Response& response, Part part, std::size_t variables);

struct SizedProblem {
  Problem problem;
  Scales scales;
};

/// The problem with each peak and each side of a limit on a curve as a number of the design, and
/// the scales of what it has then.
SizedProblem with_peaks_as_numbers(const Problem& problem, const Scales& scales);

}  // namespace camlaw::optim
