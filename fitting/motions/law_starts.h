// SPDX-License-Identifier: MIT
#pragma once

#include "fitting/motions/fit_parameters.h"
#include "fitting/motions/law_fit.h"

namespace camlaw::problems {

/// Where fits of all samples should begin, as values of the parameters that LawResiduals fits, the
/// best first; by rough fits to means of neighbours. `parameters` are those of parameters_of().
/// Laws of several coefficients have valleys in which longer motions with other coefficients nearly
/// do as well: such fits begin at shorter and longer motions too.
Possible<std::vector<std::vector<double>>> law_starts(const MotionSamples& means, const Member& law,
                                                      const FitParameters& parameters,
                                                      const LawFitOptions& options);

/// The fit of least merit of those from each of the starts; impossible where one of them is.
Possible<optim::FitResult> best_fit(const FitParameters& own, const optim::Residuals& residuals,
                                    const optim::FitOptions& options,
                                    const std::vector<std::vector<double>>& starts);

}  // namespace camlaw::problems
