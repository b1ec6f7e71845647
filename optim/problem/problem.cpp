// SPDX-License-Identifier: MIT
#include "optim/problem/problem.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace camlaw::optim {
namespace {

[[noreturn]] void refuse(const std::string& what, const std::string& why) {
  throw std::invalid_argument(fmt::format("{}: {}", what, why));
}

void check_variable(const Variable& v) {
  const std::string what = fmt::format("variable '{}'", v.name);
  if (std::isnan(v.lower) || std::isnan(v.upper)) refuse(what, "a bound is not a number");
  if (v.lower > v.upper) {
    refuse(what, fmt::format("lower {:.6g} exceeds upper {:.6g}", v.lower, v.upper));
  }
  if (v.lower == kInfinity || v.upper == -kInfinity)
    refuse(what, "no number lies within its bounds");
  if (!std::isfinite(v.start)) refuse(what, "its start is not a finite number");
  if (v.scale && !(*v.scale > 0 && std::isfinite(*v.scale))) {
    refuse(what, fmt::format("scale {:.6g} is not a positive number", *v.scale));
  }
  if (v.integer && (std::isinf(v.lower) || std::isinf(v.upper))) {
    refuse(what, "an integer variable needs a lower and an upper bound");
  }
  if (v.integer && std::ceil(v.lower) > std::floor(v.upper)) {
    refuse(what, fmt::format("no integer lies between {:.6g} and {:.6g}", v.lower, v.upper));
  }
}

void check_inputs(const Response& response, std::size_t variables) {
  const auto check = [&](const Function& function) {
    if (!function.inputs().empty() && function.inputs().back() >= variables) {
      refuse(fmt::format("response '{}'", response.name),
             fmt::format("it uses variable {}; there are {}", function.inputs().back(), variables));
    }
  };
  check(response.is_curve() ? response.curve().at({}) : response.function());
}

void check_tolerance(const std::string& what, const std::optional<double>& tolerance) {
  if (tolerance && !(*tolerance > 0 && std::isfinite(*tolerance))) {
    refuse(what, fmt::format("tolerance {:.6g} is not a positive number", *tolerance));
  }
}

void check_constraint(const Constraint& c) {
  const std::string what = fmt::format("constraint on '{}'", c.response.name);
  if (!c.lower && !c.upper) refuse(what, "it needs a lower or an upper bound");
  for (const auto& bound : {c.lower, c.upper}) {
    if (bound && !std::isfinite(*bound)) refuse(what, "a bound is not a finite number");
  }
  if (c.lower && c.upper && *c.lower > *c.upper) {
    refuse(what, fmt::format("lower {:.6g} exceeds upper {:.6g}", *c.lower, *c.upper));
  }
  if (c.response.is_curve() && c.is_equation()) {
    refuse(what, "a curve cannot be held at one value over the whole cycle");
  }
  check_tolerance(what, c.tolerance);
  if (c.scale && !(*c.scale > 0 && std::isfinite(*c.scale))) {
    refuse(what, fmt::format("scale {:.6g} is not a positive number", *c.scale));
  }
}

void check_objective(const Objective& objective) {
  const std::string what = fmt::format("objective '{}'", objective.response.name);
  check_tolerance(what, objective.tolerance);
  if (objective.response.is_curve() == (objective.part == Part::Value)) {
    refuse(what, objective.response.is_curve()
                     ? "a curve needs a part: highest, lowest or magnitude"
                     : "a number has no highest or lowest part");
  }
  const bool upward = objective.part == Part::Highest || objective.part == Part::Magnitude;
  if (upward && objective.sense == Sense::Maximize) {
    refuse(what, "a highest value can be minimised, not maximised");
  }
  if (objective.part == Part::Lowest && objective.sense == Sense::Minimize) {
    refuse(what, "a lowest value can be maximised, not minimised");
  }
}

/// The objective's shape, turned so that it is minimised.
Shape objective_shape(const Objective& objective) {
  const Shape shape = peak_shape(objective.response.shape(), objective.part);
  return objective.sense == Sense::Maximize ? negated(shape) : shape;
}

}  // namespace

Shape peak_shape(Shape curve, Part part) {
  if (part == Part::Value) return curve;
  if (part == Part::Lowest) return negated(peak_shape(negated(curve), Part::Highest));
  const bool both_ways = part == Part::Magnitude;
  if (!convex_below(curve) || (both_ways && !convex_above(curve))) return Shape::General;
  const bool is_sharp = both_ways ? curve == Shape::Linear : is_convex(curve);
  return is_sharp ? Shape::Convex : Shape::Quasiconvex;
}

Objective no_objective() { return {.response = {"", "1", Function()}}; }

const Objective& Problem::objective() const {
  if (objectives.size() == 1) return objectives.front();
  throw std::logic_error(
      fmt::format("one objective is needed; the problem '{}' has {}", name, objectives.size()));
}

Problem Problem::alone(std::size_t objective) const {
  return {.name = name,
          .variables = variables,
          .objectives = {objectives.at(objective)},
          .constraints = constraints,
          .domain = domain};
}

void Problem::check() const {
  if (objectives.empty()) throw std::invalid_argument("a problem needs an objective");
  for (const Variable& variable : variables) check_variable(variable);
  for (const Objective& objective : objectives) {
    check_inputs(objective.response, variables.size());
    check_objective(objective);
  }
  for (const Constraint& constraint : constraints) {
    check_inputs(constraint.response, variables.size());
    check_constraint(constraint);
  }
}

std::optional<Problem> with_strict_edges(const Problem& problem) {
  Problem strict = problem;
  bool any = false;
  for (Constraint& c : strict.constraints) {
    c.is_strict = c.is_edge;
    any = any || c.is_edge;
  }
  return any ? std::optional(std::move(strict)) : std::nullopt;
}

std::vector<double> Problem::start() const {
  std::vector<double> x;
  for (const Variable& v : variables) {
    const double inside = std::clamp(v.start, v.lower, v.upper);
    x.push_back(v.integer ? std::clamp(std::round(inside), std::ceil(v.lower), std::floor(v.upper))
                          : inside);
  }
  return x;
}

ProblemSpace ProblemSpace::of(Problem problem) {
  return {{}, [problem = std::move(problem)](const auto&) { return problem; }};
}

std::size_t ProblemSpace::parts() const {
  std::size_t product = 1;
  for (const Choice& choice : choices) {
    if (choice.options.empty()) {
      throw std::invalid_argument(fmt::format("choice '{}': it has no options", choice.name));
    }
    product *= choice.options.size();
    if (product > kMostCombinations) {
      throw std::invalid_argument(
          fmt::format("choice '{}': more than {} combinations", choice.name, kMostCombinations));
    }
  }
  return product;
}

std::vector<std::size_t> ProblemSpace::options(std::size_t part) const {
  std::vector<std::size_t> result(choices.size());
  for (std::size_t i = choices.size(); i-- > 0;) {
    result[i] = part % choices[i].options.size();
    part /= choices[i].options.size();
  }
  return result;
}

ProblemSpace joined(const std::string& choice, const std::vector<std::string>& names,
                    const std::vector<ProblemSpace>& spaces) {
  Choice all;
  all.name = choice;
  std::vector<std::pair<std::size_t, std::size_t>> behind;  // of each option: space and its part
  for (std::size_t s = 0; s < spaces.size(); ++s) {
    const std::size_t parts = spaces[s].parts();
    for (std::size_t part = 0; part < parts; ++part) {
      all.options.push_back(parts == 1 ? names[s] : fmt::format("{} {}", names[s], part + 1));
      behind.emplace_back(s, part);
    }
  }
  return {{all}, [spaces, behind](const std::vector<std::size_t>& options) {
            const auto& [space, part] = behind[options.front()];
            return spaces[space].problem(spaces[space].options(part));
          }};
}

bool convex_set(const Problem& problem) {
  return std::all_of(problem.constraints.begin(), problem.constraints.end(), is_convex_limit);
}

bool is_convex_limit(const Constraint& limit) {
  const Shape shape = limit.response.shape();
  if (limit.is_equation()) return shape == Shape::Linear || shape == Shape::Quasilinear;
  return (!limit.upper || convex_below(shape)) && (!limit.lower || convex_above(shape));
}

std::optional<std::string> why_convex(const Problem& problem) {
  const Shape shape = objective_shape(problem.objective());
  if (!convex_below(shape) || !convex_set(problem)) return {};
  const bool least = problem.objective().sense == Sense::Minimize;
  const char* bends = least ? "convex" : "concave";
  return fmt::format(
      "{} is {} in the variables{}", problem.objective().response.name,
      is_convex(shape) ? bends : fmt::format("quasi{} without stationary points", bends),
      problem.constraints.empty() ? "" : ", and the feasible set is convex");
}

bool needs_slope(const Problem& problem) {
  return !is_convex(objective_shape(problem.objective()));
}

std::vector<double> variable_scales(const Problem& problem) {
  std::vector<double> scales;
  for (const Variable& v : problem.variables) {
    const double range = v.upper - v.lower;
    const double start = std::isfinite(v.start) ? std::abs(v.start) : 0;
    scales.push_back(v.scale                             ? *v.scale
                     : std::isfinite(range) && range > 0 ? range
                                                         : std::max(1.0, start));
  }
  return scales;
}

}  // namespace camlaw::optim
