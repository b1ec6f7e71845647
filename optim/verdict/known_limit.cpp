// SPDX-License-Identifier: MIT
#include "optim/verdict/known_limit.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace camlaw::optim {
namespace {

/// How far the objective is from what no design passes, as a share of that; none: none is known.
std::optional<double> gap_to_limit(const Problem& problem, const Assessment& a) {
  const std::optional<KnownLimit>& limit = problem.objective().limit;
  if (!limit) return {};
  return std::abs(a.objective.value - limit->value) / std::abs(limit->value);
}

}  // namespace

bool is_near_limit(const Problem& problem, const Assessment& a) {
  constexpr double kNear = 1e-4;  // the answer tells what is left in per cent, with digits to 0.01
  const std::optional<double> gap = gap_to_limit(problem, a);
  return gap && *gap <= kNear;
}

std::string near_limit_words(const Problem& problem, const Assessment& a) {
  const KnownLimit& limit = *problem.objective().limit;
  const Response& response = problem.objective().response;
  return fmt::format("to within {:.2g} %: no design below {:.7g}{}, as {}",
                     100 * gap_to_limit(problem, a).value_or(0), limit.value,
                     response.unit == "1" ? "" : " " + response.unit, limit.why);
}

}  // namespace camlaw::optim
