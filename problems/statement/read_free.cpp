// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "kinematics/laws/free.h"
#include "problems/statement/auto_knots.h"
#include "problems/statement/law_names.h"
#include "problems/statement/parameters.h"
#include "problems/statement/program_units.h"
#include "problems/statement/reading.h"
#include "problems/statement/toml_reader.h"

namespace camlaw::problems {
namespace {

using Kind = Entry::Kind;

/// As high a degree as b-spline takes. A search took 0.2 s with 64 knots, and 0.11 s with 1000 in a
/// linear problem.
constexpr int kDefaultKnots = 32, kMostKnots = 1000, kMostDegree = 25;
/// The velocity of a free law is continuous: where it jumps the acceleration has a pulse, which no
/// limit on the pieces sees.
constexpr int kLeastDegree = 2, kLeastContinuity = 1;
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

/// A degree or a continuity, with which the velocity does not jump from `low` on.
int smooth_or(const Entry& table, const char* key, int low, int high, int default_value) {
  const Entry* entry = find(table, key);
  if (entry == nullptr) return default_value;
  if (entry->kind == Kind::Integer && entry->integer >= 0 && entry->integer < low) {
    refuse(*entry, fmt::format("with {} the velocity jumps at the knots, where the acceleration is "
                               "infinite; use {} .. {}",
                               entry->integer, low, high));
  }
  return static_cast<int>(whole_of(*entry, low, high));
}

/// Whether the knots are to be found: knots = "auto".
bool is_auto(const Entry& entry) { return entry.kind == Kind::Text && entry.text == "auto"; }

std::vector<double> read_knots(const Entry& table) {
  const Entry* entry = find(table, "knots");
  if (entry == nullptr) return even_knots(kDefaultKnots);
  if (is_auto(*entry)) return even_knots(kDefaultKnots);  // until they are found
  if (entry->kind == Kind::Integer)
    return even_knots(static_cast<int>(whole_of(*entry, 0, kMostKnots)));
  expect(*entry, Kind::List,
         "how many even knots, such as 64, a list of places, such as [0.2, 0.5], or \"auto\"");
  if (entry->items.empty()) return {};
  if (entry->items.size() > static_cast<std::size_t>(kMostKnots)) {
    refuse(*entry,
           fmt::format("{} knots; at most {} are accepted", entry->items.size(), kMostKnots));
  }
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
  refuse(*entry, fmt::format("'{}' is not an end; use R (rest), U (reversal: s' = 0), G (s'' = 0), "
                             "B (any), or how many derivatives are 0",
                             text));
}

Law<double> read_start(const Entry& table, HeldFiles& files) {
  const Entry* entry = find(table, "start");
  return entry == nullptr ? find_law("poly-3-4-5").law() : read_law_name(*entry, files).law.law();
}

/// Between which the coefficients lie.
struct Range {
  double lower = -1, upper = 2;
};

Range read_range(const Entry& table, const NamedParameter& coefficients) {
  Range range;
  const auto read = [&](const char* key, double& bound) {
    const Entry* entry = find(table, key);
    if (entry == nullptr) return;
    bound = quantity_of(*entry, "1");
    check_accepted(*entry, coefficients, bound);
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
                  Range range, std::optional<double> scale) {
  if (find_variable(problem, parameter, i)) return;  // the file states it
  VariableStatement variable;
  variable.name = parameter.element_name(i);
  variable.unit = parameter.unit;
  variable.of_law = true;
  variable.law_parameter = parameter.law_parameter;
  variable.element = i;
  variable.lower = range.lower;
  variable.upper = range.upper;
  variable.scale = scale;
  variable.start = std::clamp(values_of(problem, parameter).at(i), range.lower, range.upper);
  put_value(problem, parameter, i, variable.start);
  problem.variables.push_back(std::move(variable));
}

/// What stands before the parameters of each free law, which is told by what it alone has (a law
/// file may be called free too): nothing, or of a program's segments "rise_".
std::vector<std::string> free_prefixes(const Entry& file, const ProblemStatement& problem) {
  if (problem.mechanism->moved_by != MovedBy::Program) {
    const bool any = std::any_of(problem.laws.begin(), problem.laws.end(),
                                 [](const Member& law) { return bool(law.family->listed); });
    return any ? std::vector<std::string>{""} : std::vector<std::string>{};
  }
  std::vector<std::string> prefixes;
  const auto& segments = segment_tables(*find(file, "program"));
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (is_free(segments[i])) prefixes.push_back(segment_name(segments[i], i) + "_");
  }
  return prefixes;
}

/// A law's parameter, unless the file fixes it.
std::optional<NamedParameter> unfixed(const ProblemStatement& problem, const std::string& name,
                                      const FixedNames& fixed) {
  const NamedParameter parameter = find_parameter(problem, name, Owner::Law);
  return fixed.contains(parameter.name) ? std::nullopt : std::optional(parameter);
}

}  // namespace

bool is_free_name(std::string_view name) { return name == kFree; }

bool is_free(const Entry& segment) {
  const Entry* law = find(segment, "law");
  if (law == nullptr) return false;
  if (law->kind == Kind::Text) return is_free_name(law->text);
  return std::any_of(law->items.begin(), law->items.end(),
                     [](const Entry& item) { return is_free_name(item.text); });
}

namespace {

Member free_law_of(const Entry& table, HeldFiles& files) {
  FreeLaw shape;
  shape.degree = smooth_or(table, "degree", kLeastDegree, kMostDegree, shape.degree);
  shape.knots = read_knots(table);
  shape.continuity =
      smooth_or(table, "continuity", kLeastContinuity, shape.degree - 1, shape.degree - 1);
  shape.begin = read_end(table, "begin", shape.continuity);
  shape.end = read_end(table, "end", shape.continuity);
  shape.symmetric = truth_of(table, "symmetric");
  shape.moving_knots = truth_of(table, "moving_knots");
  const Law<double> start = read_start(table, files);
  return located(table, [&] { return free_law(shape, start); });
}

}  // namespace

Member read_free_law(const Entry& file, HeldFiles& files) {
  return free_law_of(free_table(file), files);
}

Member read_free_law(const Entry& file, const Entry& segment, HeldFiles& files) {
  Entry table = free_table(file);
  for (const char* key : {"begin", "end"}) {
    const Entry* own = find(segment, key);
    if (own == nullptr) continue;
    std::erase_if(table.items, [&](const Entry& item) { return item.key == key; });
    table.items.push_back(*own);
  }
  return free_law_of(table, files);
}

void read_free_variables(const Entry& file, ProblemStatement& problem, const FixedNames& fixed) {
  const std::vector<std::string> prefixes = free_prefixes(file, problem);
  if (prefixes.empty()) {
    const Entry* table = find(file, kFree);
    if (table == nullptr) return;
    refuse(*table, problem.mechanism->moved_by == MovedBy::Program
                       ? "no segment's law is free; write law = \"free\" in a segment"
                       : "no law of the problem is free; write [law] name = \"free\"");
  }
  const Entry table = free_table(file);
  const bool symmetric = truth_of(table, "symmetric");
  const bool moving = truth_of(table, "moving_knots");
  const Entry* knots = find(table, "knots");
  problem.finds_knots = knots != nullptr && is_auto(*knots);
  problem.free_is_symmetric = symmetric;
  if (problem.finds_knots && moving) {
    refuse(*knots, "knots that move are not found by adding more; state how many");
  }
  // Of n pieces 1 / n moves the displacement by as much as a piece does, and 1 / n^2 the
  // acceleration by order one: between the two objectives have the size of their values. Knots that
  // move have typical changes of their own, beside which larger ones do better.
  const double typical =
      std::pow(static_cast<double>(read_knots(table).size() + 1), moving ? -0.5 : -1.5);
  for (const std::string& prefix : prefixes) {
    if (const auto coefficients = unfixed(problem, prefix + "coefficients", fixed)) {
      const Range range = read_range(table, *coefficients);
      for (std::size_t i = 0; i < values_of(problem, *coefficients).size(); ++i) {
        add_variable(problem, *coefficients, i, range, typical);
      }
    }
    if (!moving) continue;
    if (const auto own = unfixed(problem, prefix + "knots", fixed)) {
      const std::vector<double> places = values_of(problem, *own);
      for (std::size_t i = 0; i < places.size(); ++i) {
        add_variable(problem, *own, i, range_of_knot(places, i, symmetric), {});
      }
    }
  }
}

void refuse_auto_knots(const ProblemStatement& statement, const std::string& what) {
  if (!statement.finds_knots) return;
  throw std::invalid_argument(
      fmt::format("{}: knots = \"auto\" finds the knots of one optimum, not of {}; state how many "
                  "knots, or the "
                  "list that camlaw optimize prints",
                  statement.source, what));
}

}  // namespace camlaw::problems
