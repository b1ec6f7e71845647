// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "machines/model/over_ranges.h"
#include "problems/statement/parts.h"
#include "problems/statement/reading.h"
#include "problems/statement/toml_reader.h"

namespace camlaw::problems {
namespace {

/// A proof divides angle and ranges: the boxes grow with each as a power.
constexpr std::size_t kMostRanges = 3;

double read_range_end(const Entry& table, const char* key, const NamedParameter& parameter) {
  const Entry* entry = find(table, key);
  if (entry == nullptr) refuse(table, fmt::format("{} is missing; give lower and upper", key));
  const double value =
      onto_range(quantity_of(*entry, parameter.unit), parameter.low, parameter.high);
  check_accepted(*entry, parameter, value);
  return value;
}

ParameterRange read_one_range(const Entry& table, const ProblemStatement& problem) {
  expect(table, Entry::Kind::Table, "a table with lower and upper");
  check_keys(table, {"lower", "upper"});
  const NamedParameter parameter =
      located(table, [&] { return find_parameter(problem, table.key, Owner::Machine); });
  if (find_variable(problem, parameter, 0)) {
    refuse(table, fmt::format("{} varies, so that the search chooses it; a range is of what may "
                              "have any value",
                              parameter.name));
  }
  if (const PartStatement* part = part_of(problem, parameter.parameter)) {
    refuse(table, fmt::format("{} comes with {}, [parts.{}]; drop one of the two", parameter.name,
                              part->name, part->name));
  }
  if (parameter.integer) {
    refuse(table, fmt::format("{} is an integer; state its values as load cases, [[cases]]",
                              parameter.name));
  }
  if (problem.told_by_motion.contains(parameter.parameter)) {
    refuse(table, fmt::format("the motion is stated in {}, so {} has one value", parameter.unit,
                              parameter.name));
  }
  const auto sets = [&](const LoadCase& load) {
    return std::any_of(load.parameters.begin(), load.parameters.end(),
                       [&](const auto& set) { return set.first == parameter.parameter; });
  };
  if (std::any_of(problem.cases.begin(), problem.cases.end(), sets)) {
    refuse(table, fmt::format("the load cases set {}; drop one of the two", parameter.name));
  }
  const ParameterRange range{parameter.parameter, read_range_end(table, "lower", parameter),
                             read_range_end(table, "upper", parameter)};
  if (!(range.lower < range.upper)) {
    refuse(table,
           fmt::format("lower {} is not below upper {}", with_unit(range.lower, parameter.unit),
                       with_unit(range.upper, parameter.unit)));
  }
  return range;
}

}  // namespace

void read_ranges(const Entry& file, ProblemStatement& problem) {
  const Entry* ranges = find(file, "ranges");
  if (ranges == nullptr) return;
  expect(*ranges, Entry::Kind::Table, "tables, such as [ranges.speed] with lower and upper");
  if (ranges->items.size() > kMostRanges) {
    refuse(*ranges,
           fmt::format("{} ranges; at most {} are accepted", ranges->items.size(), kMostRanges));
  }
  for (const Entry& table : ranges->items) {
    const ParameterRange range = read_one_range(table, problem);
    for (const ParameterRange& other : problem.ranges) {
      if (other.parameter == range.parameter) refuse(table, "this range is stated twice");
    }
    located(table, [&] { check_laws_over(problem, range); });
    problem.ranges.push_back(range);
    problem.stated.insert(range.parameter);
  }
}

}  // namespace camlaw::problems
