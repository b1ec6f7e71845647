// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "optim/verdict/tolerance.h"
#include "output/answers/front_output.h"
#include "problems/law_files/json_text.h"

/// What becomes of a design of a front that is not made as it was meant.
namespace camlaw::cli {

/// What is usual where nobody says more: 0.02 mm of a length, 0.1 deg of an angle, of anything else
/// a hundredth of its value, and of a zero one of its range.
std::vector<double> usual_tolerances(const std::vector<optim::Variable>& variables,
                                     optim::Design x);

/// Tolerances of a point's variables from "name=value" with units; of those that are not named,
/// none; without any assignment usual_tolerances. Throws
/// std::invalid_argument for names and values that are not accepted.
std::vector<double> tolerances_of(const FrontAnswer& answer, const optim::FrontPoint& point,
                                  const std::vector<std::string>& assignments);

/// What a design's objectives and margins become: for people a table and how it was made, with the
/// share of the samples that meet every limit where the caller has no yield of its own.
Document spreads_document(const optim::ToleranceReport& report, bool with_yield = true);

/// What becomes of a point where its variables are off by up to `tolerances`, in the variables'
/// units.
Document tolerance_document(const FrontAnswer& answer, const optim::FrontPoint& point,
                            const std::vector<double>& tolerances);

}  // namespace camlaw::cli
