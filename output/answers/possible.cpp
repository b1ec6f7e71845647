// SPDX-License-Identifier: MIT
#include "output/answers/possible.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "problems/statement/impossible_values.h"
#include "problems/statement/parameters.h"

namespace camlaw::cli {

void check_possible(const std::string& file, const problems::ProblemStatement& statement,
                    const std::vector<problems::EvaluatedResponse>& responses) {
  const bool possible = std::any_of(responses.begin(), responses.end(), [](const auto& r) {
    return !std::isnan(r.is_curve ? r.highest : r.value);
  });
  if (possible) return;
  const std::string why = problems::why_impossible(statement);
  if (!why.empty()) throw std::invalid_argument(fmt::format("{}: {}", file, why));
  std::vector<std::string> values;
  const auto& parameters = statement.mechanism->parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    values.push_back(fmt::format("{} = {}", parameters[i].name,
                                 problems::with_unit(statement.constants[i], parameters[i].unit)));
  }
  const std::string with = fmt::format("{}", fmt::join(values, ", "));
  const std::string& machine = statement.mechanism->name;
  throw std::invalid_argument(
      statement.mechanism->cycle != nullptr
          ? fmt::format("{}: no formula of {} has a value everywhere with {}", file, machine, with)
          : fmt::format("{}: {} is not possible with these values: {}", file, machine, with));
}

}  // namespace camlaw::cli
