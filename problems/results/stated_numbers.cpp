// SPDX-License-Identifier: MIT
#include "problems/results/stated_numbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "problems/law_files/json_text.h"
#include "problems/results/seal.h"

namespace camlaw::problems {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// A number as results write it: without bound as a text.
double number_of(const Json& value) {
  if (value.is_number()) return value.get<double>();
  if (value == "inf") return std::numeric_limits<double>::infinity();
  if (value == "-inf") return -std::numeric_limits<double>::infinity();
  return kNone;
}

double number_at(const Json& object, const char* key) {
  const auto at = object.find(key);
  return at == object.end() ? kNone : number_of(*at);
}

bool is_true(const Json& object, const char* key) {
  const auto at = object.find(key);
  return at != object.end() && *at == true;
}

std::map<std::string, double> numbers_at(const Json& result, const char* key) {
  std::map<std::string, double> numbers;
  const auto at = result.find(key);
  if (at == result.end() || !at->is_object()) return numbers;
  for (const auto& [name, value] : at->items()) {
    if (value.is_number()) numbers[name] = value.get<double>();
  }
  return numbers;
}

StatedLimit limit_of(const Json& object) {
  StatedLimit limit{"", kNone, kNone, kNone};
  if (!object.is_object()) return limit;
  if (const auto name = object.find("name"); name != object.end() && name->is_string()) {
    limit.name = name->get<std::string>();
  }
  limit.value = number_at(object, "value");
  limit.bound = number_at(object, "bound");
  limit.margin = number_at(object, "margin");
  limit.is_upper = object.value("side", Json("upper")) != "lower";
  limit.met = is_true(object, "met");
  return limit;
}

/// The keys of what is neither compared with the design nor says how the result came about.
std::vector<std::string> others_of(const Json& result) {
  constexpr std::array kCompared{"verdict",   "reason",         "objective",      "objectives",
                                 "variables", "constraints",    "limits",         "design",
                                 "blamed",    "objective_name", "objective_unit", "best_possible"};
  // Of the file, and of how the search went.
  constexpr std::array kAbout{"format",     "program", "title",       "checksum",
                              "status",     "starts",  "agreed",      "evaluations",
                              "iterations", "solves",  "solver",      "solver_asked",
                              "why_solver", "seed",    "combinations"};
  const auto is_one_of = [](const auto& all, const std::string& key) {
    return std::count(all.begin(), all.end(), key) > 0;
  };
  std::vector<std::string> others;
  for (const auto& [key, value] : result.items()) {
    if (value.is_null() || (value.is_array() && value.empty())) continue;
    if (!is_one_of(kCompared, key) && !is_one_of(kAbout, key)) others.push_back(key);
  }
  const auto has_limits = [&](const char* key) {
    const auto at = result.find(key);
    return at != result.end() && at->is_array() && !at->empty();
  };
  if (has_limits("constraints") || has_limits("limits")) {
    others.emplace_back("units, places, other sides, proofs and multipliers of the limits");
  }
  return others;
}

}  // namespace

StatedNumbers stated_numbers(const Json& result) {
  StatedNumbers stated;
  stated.seal = seal_of(result);
  stated.objectives = numbers_at(result, "objectives");
  stated.variables = numbers_at(result, "variables");
  for (const char* key : {"constraints", "limits"}) {  // of a search, of a point of a front
    const auto at = result.find(key);
    if (at == result.end() || !at->is_array()) continue;
    stated.limits.emplace();
    for (const Json& limit : *at) stated.limits->push_back(limit_of(limit));
  }
  if (const double bound = number_at(result, "best_possible"); std::isfinite(bound)) {
    stated.best_possible = bound;
  }
  if (const auto at = result.find("program"); at != result.end() && at->is_string()) {
    stated.program = at->get<std::string>();
  }
  stated.others = others_of(result);
  return stated;
}

}  // namespace camlaw::problems
