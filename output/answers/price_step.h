// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "optim/verdict/assessment.h"

/// Prices are told of a step over which they mean something (docs/optimisation.md, "Prices").
namespace camlaw::cli {

/// By how much a bound is eased where its price is told, and what the objective gains by that to
/// first order; both in the units of the limit and of the objective.
struct PricedStep {
  double step, gain;
};

/// The largest power of ten that is at most a tenth of the bound's size `scale`, and gains at most
/// a tenth of the objective. A bound without a size (0) is eased by 1 at most, and so it is where
/// both are 0. None where the price is not a number, or too small to count: 1e-9 of the objective.
std::optional<PricedStep> priced_step(double scale, double price, double objective);

/// Of a limit: its size is that of its bound. An equation has no side that eases, and none.
std::optional<PricedStep> priced_step(const optim::LimitReport& limit, double objective);

/// Of the bound at which a variable stands: its size is that of the bound or of the range between
/// the bounds, whichever is less and not 0.
std::optional<PricedStep> priced_step(const optim::VariableReport& variable, double objective);

/// What the words of an assessment tell of a limit or of a variable's bound; not numbers where they
/// tell nothing: prices are told of a certified optimum.
PricedStep told_step(const optim::LimitReport& limit, const optim::Assessment& assessment);
PricedStep told_step(const optim::VariableReport& variable, const optim::Assessment& assessment);

}  // namespace camlaw::cli
