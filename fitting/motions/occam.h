// SPDX-License-Identifier: MIT
#pragma once

#include "optim/fit/least_squares.h"
#include "optim/fit/residuals.h"

namespace camlaw::problems {

/// What a law's own coefficients cost it where laws are compared: how much more closely the samples
/// tell them than they were known before.
struct Occam {
  std::size_t count = 0;  ///< of coefficients that are determined and at no bound
  double logarithm = 0;   ///< ln det(1 + P C^-1) of these
};

/// Of a fit whose coefficients are the parameters from `first` on, to samples that scatter by
/// `deviation` at least. Before the samples a coefficient
/// may be anywhere in its range, as far as it changes them by no more than a tenth of `size` (root
/// of the mean square): an even distribution's variance, P.
Occam occam_of(const optim::Residuals& residuals,
               const std::vector<optim::FitParameter>& parameters, std::size_t first, double size,
               double deviation, const optim::FitResult& fit);

}  // namespace camlaw::problems
