// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "numerics/text/names.h"
#include "numerics/text/units.h"
#include "optim/solvers/solver.h"
#include "problems/statement/reading.h"
#include "problems/statement/solver_settings.h"
#include "problems/statement/toml_reader.h"

namespace camlaw::problems {

std::string find_solver_name(std::string_view typed) {
  std::vector<std::string> known = optim::solver_names();
  known.insert(known.begin(), "auto");
  const std::string wanted = folded(typed);
  if (std::find(known.begin(), known.end(), wanted) != known.end()) return wanted;
  const auto near = near_names(wanted, known);
  throw std::invalid_argument(fmt::format("'{}' is not a solver; {} one of {}", typed,
                                          near.empty() ? "use" : did_you_mean(near) + " Use",
                                          fmt::join(known, ", ")));
}

std::int64_t parse_integer(std::string_view text, std::int64_t low, std::int64_t high,
                           const std::string& what) {
  std::int64_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  const bool whole = rest == end && error != std::errc::invalid_argument;
  if (!whole || error != std::errc{} || value < low || value > high) {
    throw std::invalid_argument(fmt::format("{}: {}; it must be an integer from {} to {}", what,
                                            whole ? fmt::format("{} is out of range", text)
                                                  : fmt::format("'{}' is not an integer", text),
                                            low, high));
  }
  return value;
}

double parse_time_limit(std::string_view text, const std::string& what) {
  const double value = parse_quantity(text, "s", "s", what);
  if (!(value > 0 && std::isfinite(value))) {
    throw std::invalid_argument(fmt::format(
        "{}: {} s is not a time above zero, such as \"30 s\" or \"1 min\"", what, value));
  }
  return value;
}

namespace {

optim::NativeValue native_value(const Entry& entry) {
  switch (entry.kind) {
    case Entry::Kind::Text:
      return entry.text;
    case Entry::Kind::Integer:
      return entry.integer;
    case Entry::Kind::Float:
      return entry.number;
    default:
      refuse(entry, fmt::format("{} is given; write a text, an integer or a number",
                                to_string(entry.kind)));
  }
}

/// What [solver.NAME] says, checked whether or not that solver is the one which is asked for.
optim::NativeOptions read_native(const Entry& table) {
  expect(table, Entry::Kind::Table, fmt::format("a table, [solver.{}]", table.key));
  const auto rules = optim::find_solver(table.key).native_rules();
  optim::NativeOptions options;
  for (const Entry& entry : table.items) {
    const optim::NativeValue value = native_value(entry);
    located(entry, [&] { optim::check_native_option(table.key, rules, entry.key, value); });
    options.emplace(entry.key, value);
  }
  return options;
}

}  // namespace

void read_solver(const Entry& file, ProblemStatement& problem) {
  const Entry* solver = find(file, "solver");
  if (solver == nullptr) return;
  expect(*solver, Entry::Kind::Table, "a table, [solver]");
  const std::vector<std::string> solvers = optim::solver_names();
  std::vector<std::string> keys{"name", "starts", "seed", "time_limit"};
  keys.insert(keys.end(), solvers.begin(), solvers.end());
  check_keys(*solver, keys);
  if (const Entry* name = find(*solver, "name")) {
    const std::string& text = text_of(*name);
    problem.solver.name = located(*name, [&] { return find_solver_name(text); });
  }
  if (const Entry* starts = find(*solver, "starts")) {
    problem.solver.starts = static_cast<int>(whole_of(*starts, 1, kMostStarts));
  }
  if (const Entry* seed = find(*solver, "seed")) {
    problem.solver.seed = static_cast<std::uint64_t>(whole_of(*seed, 0, kMostSeed));
  }
  problem.solver.time_limit = find_positive(*solver, "time_limit", "s");
  for (const std::string& name : solvers) {
    const Entry* table = find(*solver, name);
    if (table != nullptr) problem.solver.native.emplace(name, read_native(*table));
  }
}

}  // namespace camlaw::problems
