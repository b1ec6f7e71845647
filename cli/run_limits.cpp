// SPDX-License-Identifier: MIT
#include "cli/run_limits.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>

#include "optim/search/free_memory.h"
#include "problems/statement/solver_settings.h"

namespace camlaw::cli {
Option time_limit_option(RunLimits& limits, const std::string& answer) {
  return {"--time-limit", &limits.time_limit, "TIME",
          "such as 30, \"30 s\" or \"1 min\": " + answer + " by then is the answer"};
}

Option memory_option(RunLimits& limits) {
  return {"--memory", &limits.memory, "SIZE",
          "memory that the search may use, such as \"4 GB\" (the machine's free memory). A problem "
          "that needs more is refused"};
}

std::optional<double> time_limit_of(const RunLimits& limits) {
  if (!limits.time_limit) return {};
  return problems::parse_time_limit(*limits.time_limit, "--time-limit");
}

double memory_of(const RunLimits& limits) {
  return limits.memory ? parse_memory(*limits.memory, "--memory") : optim::free_memory();
}

double parse_memory(const std::string& text, const std::string& what) {
  constexpr std::pair<const char*, double> kUnits[] = {
      {"kB", 1e3},     {"MB", 1e6},     {"GB", 1e9},     {"TB", 1e12},
      {"KiB", 0x1p10}, {"MiB", 0x1p20}, {"GiB", 0x1p30}, {"TiB", 0x1p40}};
  double number = 0;
  const char* const end = text.data() + text.size();
  auto [rest, error] = std::from_chars(text.data(), end, number);
  while (rest != end && *rest == ' ') ++rest;
  for (const auto& [unit, bytes] : kUnits) {
    const bool known = std::string_view(rest, static_cast<std::size_t>(end - rest)) == unit;
    if (known && error == std::errc() && number > 0 && std::isfinite(number * bytes)) {
      return number * bytes;
    }
  }
  throw std::invalid_argument(fmt::format(
      "{}: '{}' is not a size above zero with a unit from kB to TB or KiB to TiB, such as \"4 GB\"",
      what, text));
}

}  // namespace camlaw::cli
