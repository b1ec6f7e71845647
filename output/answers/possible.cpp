// SPDX-License-Identifier: MIT
#include "output/answers/possible.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <stdexcept>

#include "problems/statement/parameters.h"

namespace camlaw::cli {
namespace {

/// Whether a text has a name as a word.
bool has_name(const std::string& text, const std::string& name) {
  const auto is_part = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
  };
  for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
    const std::size_t end = at + name.size();
    const bool begins = at == 0 || !is_part(text[at - 1]);
    if (begins && (end == text.size() || !is_part(text[end]))) return true;
  }
  return false;
}

}  // namespace

void check_possible(const std::string& file, const problems::ProblemStatement& statement,
                    const std::vector<problems::EvaluatedResponse>& responses) {
  const bool possible = std::any_of(responses.begin(), responses.end(), [](const auto& r) {
    return !std::isnan(r.is_curve ? r.highest : r.value);
  });
  if (possible) return;
  const auto& condition = statement.mechanism->why_impossible;
  const std::string why = condition ? condition(statement.constants) : "";
  std::vector<std::string> values;
  const auto& parameters = statement.mechanism->parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (!why.empty() && !has_name(why, parameters[i].name)) continue;
    values.push_back(fmt::format("{} = {}", parameters[i].name,
                                 problems::with_unit(statement.constants[i], parameters[i].unit)));
  }
  const std::string with = fmt::format("{}", fmt::join(values, ", "));
  const std::string& machine = statement.mechanism->name;
  if (!why.empty()) {
    throw std::invalid_argument(
        fmt::format("{}: {} is not possible with these values: {}; {}", file, machine, with, why));
  }
  throw std::invalid_argument(
      statement.mechanism->cycle != nullptr
          ? fmt::format("{}: no formula of {} has a value everywhere with {}", file, machine, with)
          : fmt::format("{}: {} is not possible with these values: {}", file, machine, with));
}

}  // namespace camlaw::cli
