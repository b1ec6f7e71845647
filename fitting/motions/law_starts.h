// SPDX-License-Identifier: MIT
#pragma once

#include "fitting/motions/fit_parameters.h"
#include "fitting/motions/law_fit.h"

namespace camlaw::problems {

/// Where fits of all samples should begin, as values of the parameters that LawResiduals fits, the
/// best first; by rough fits to a few means of neighbours. `parameters` are those of
/// parameters_of(). Laws of several coefficients have valleys in which longer motions with other
/// coefficients nearly do as well: such fits begin at shorter and longer motions too.
Possible<std::vector<std::vector<double>>> law_starts(const MotionSamples& samples,
                                                      const Member& law,
                                                      const FitParameters& parameters,
                                                      const LawFitOptions& options);

/// Of very many samples: where the best of the fits from these starts ends, by as few means of
/// neighbours as tell that, which is where a fit of all samples then begins. The starts themselves
/// where there are no more samples than that, and under a loss, of which the means know nothing.
Possible<std::vector<std::vector<double>>> ends_of_means(const MotionSamples& samples,
                                                         const Member& law,
                                                         const FitParameters& parameters,
                                                         const LawFitOptions& options,
                                                         std::vector<std::vector<double>> starts);

}  // namespace camlaw::problems
