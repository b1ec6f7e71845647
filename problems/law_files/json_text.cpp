// SPDX-License-Identifier: MIT
#include "problems/law_files/json_text.h"

#include <fmt/format.h>

#include <stdexcept>

namespace camlaw::problems {

Json parse_json(std::string_view text) {
  // What reads, copies and writes a value calls itself for each level.
  static constexpr int kDeepest = 64;
  const auto check_depth = [](int depth, Json::parse_event_t, const Json&) {
    if (depth <= kDeepest) return true;
    throw std::invalid_argument(fmt::format("its brackets are nested more than {} deep", kDeepest));
  };
  constexpr bool kThrows = false;
  Json result = Json::parse(text, check_depth, kThrows);
  if (result.is_discarded())
    throw std::invalid_argument("it is not valid JSON, or it is incomplete");
  return result;
}

}  // namespace camlaw::problems
