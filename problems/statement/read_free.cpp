// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "kinematics/laws/free.h"
#include "problems/statement/law_names.h"
#include "problems/statement/parameters.h"
#include "problems/statement/reading.h"
#include "problems/statement/toml_reader.h"

namespace camlaw::problems {
namespace {

using Kind = Entry::Kind;

constexpr int kStandardKnots = 32, kMostKnots = 1000, kMostDegree = 25;
constexpr const char* kFree = "free";

/// The table [free]; without one, an empty table.
Entry free_table(const Entry& file) {
  if (const Entry* table = find(file, kFree)) {
    expect(*table, Kind::Table, "a table, [free] with degree and knots");
    check_keys(*table, {"degree", "knots", "continuity", "begin", "end", "symmetric",
                        "moving_knots", "lower", "upper", "start"});
    return *table;
  }
  Entry none = file;
  none.items.clear();
  return none;
}

int whole_or(const Entry& table, const char* key, int low, int high, int standard) {
  const Entry* entry = find(table, key);
  return entry == nullptr ? standard : static_cast<int>(whole_of(*entry, low, high));
}

bool truth_of(const Entry& table, const char* key) {
  const Entry* entry = find(table, key);
  if (entry == nullptr) return false;
  expect(*entry, Kind::Truth, "true or false");
  return entry->integer != 0;
}

std::vector<double> read_knots(const Entry& table) {
  const Entry* entry = find(table, "knots");
  if (entry == nullptr) return even_knots(kStandardKnots);
  if (entry->kind == Kind::Integer)
    return even_knots(static_cast<int>(whole_of(*entry, 0, kMostKnots)));
  expect(*entry, Kind::List,
         "how many even knots, such as 64, or a list of places, such as [0.2, 0.5]");
  return quantities_of(*entry, "1");
}

/// VDI 2143 letters, or how many derivatives vanish. Rest asks for s'' = 0 too where s'' is
/// continuous inside.
FreeEnd read_end(const Entry& table, const char* key, int continuity) {
  const FreeEnd rest{std::clamp(continuity, 1, 2), false};
  const Entry* entry = find(table, key);
  if (entry == nullptr) return rest;
  if (entry->is_number()) return {static_cast<int>(whole_of(*entry, 0, kMostDegree)), false};
  const std::string& text = text_of(*entry);
  if (text == "R") return rest;
  if (text == "U") return {1, false};
  if (text == "G") return {0, true};
  if (text == "B") return {0, false};
  refuse(*entry, fmt::format("'{}' is no end; accepted are R (rest), U (reversal: s' = 0), G "
                             "(s'' = 0), B (any), or how many derivatives are 0",
                             text));
}

Law<double> read_start(const Entry& table) {
  const Entry* entry = find(table, "start");
  return entry == nullptr ? find_law("poly-3-4-5").law() : read_law_name(*entry).law.law();
}

/// Between which the coefficients lie.
struct Range {
  double lower = -1, upper = 2;
};

Range read_range(const Entry& table, const Parameter& coefficients) {
  Range range;
  const auto read = [&](const char* key, double& bound) {
    const Entry* entry = find(table, key);
    if (entry == nullptr) return;
    bound = quantity_of(*entry, "1");
    check_accepted(*entry, named(coefficients), bound);
  };
  read("lower", range.lower);
  read("upper", range.upper);
  if (range.lower >= range.upper) {
    refuse(table, fmt::format("lower {:.6g} is not below upper {:.6g}", range.lower, range.upper));
  }
  return range;
}

/// Where a knot may go: so near to its neighbours that it never meets one that comes as near.
Range range_of_knot(const std::vector<double>& knots, std::size_t i, bool symmetric) {
  constexpr double kShare = 0.45;  // of the way
  const double before = i == 0 ? 0 : knots[i - 1];
  const double after = i + 1 < knots.size() ? knots[i + 1] : symmetric ? 0.5 : 1;
  return {knots[i] - kShare * (knots[i] - before), knots[i] + kShare * (after - knots[i])};
}

void add_variable(ProblemStatement& problem, const NamedParameter& parameter, std::size_t i,
                  Range range) {
  if (find_variable(problem, parameter, i)) return;  // the file states it
  VariableStatement variable;
  variable.name = parameter.element_name(i);
  variable.unit = parameter.unit;
  variable.of_law = true;
  variable.law_parameter = parameter.law_parameter;
  variable.element = i;
  variable.lower = range.lower;
  variable.upper = range.upper;
  variable.start = std::clamp(values_of(problem, parameter).at(i), range.lower, range.upper);
  put_value(problem, parameter, i, variable.start);
  problem.variables.push_back(std::move(variable));
}

}  // namespace

bool is_free_name(std::string_view name) { return name == kFree; }

Member read_free_law(const Entry& file) {
  const Entry table = free_table(file);
  FreeLaw shape;
  shape.degree = whole_or(table, "degree", 1, kMostDegree, shape.degree);
  shape.knots = read_knots(table);
  shape.continuity = whole_or(table, "continuity", 0, shape.degree - 1, shape.degree - 1);
  shape.begin = read_end(table, "begin", shape.continuity);
  shape.end = read_end(table, "end", shape.continuity);
  shape.symmetric = truth_of(table, "symmetric");
  shape.moving_knots = truth_of(table, "moving_knots");
  const Law<double> start = read_start(table);
  return located(table, [&] { return free_law(shape, start); });
}

void refuse_unused_free(const Entry& file, const ProblemStatement& problem) {
  const Entry* table = find(file, kFree);
  if (table == nullptr) return;
  for (const Member& law : problem.laws) {
    if (is_free_name(law.family->name)) return;
  }
  refuse(*table, "no law of the problem is free; write [law] name = \"free\"");
}

void read_free_variables(const Entry& file, ProblemStatement& problem, const FixedNames& fixed) {
  const auto law = std::find_if(problem.laws.begin(), problem.laws.end(),
                                [](const Member& m) { return is_free_name(m.family->name); });
  if (law == problem.laws.end()) return;
  const Entry table = free_table(file);
  const auto family = law->family;  // kept while values are put into the laws
  const Range range = read_range(table, family->parameters[0]);
  for (const Parameter& p : family->parameters) {
    const NamedParameter parameter = named(p);
    if (fixed.contains(parameter.name)) continue;
    const bool is_knots = &p != &family->parameters.front();
    for (std::size_t i = 0; i < p.standard.size(); ++i) {
      add_variable(problem, parameter, i,
                   is_knots ? range_of_knot(p.standard, i, family->symmetric) : range);
    }
  }
}

}  // namespace camlaw::problems
