// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <catch2/catch.hpp>
#include <limits>
#include <string>
#include <vector>

#include "optim/pareto/pareto.h"

/// Outcomes to the last bit, and small problems for the tests of studies.
namespace camlaw::optim::study_tests {

inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Everything in an outcome, numbers by their bits.
inline std::string bits(double value) {
  return std::to_string(std::bit_cast<std::uint64_t>(value)) + " ";
}

inline std::string bits(const std::vector<double>& values) {
  std::string text = std::to_string(values.size()) + ": ";
  for (const double v : values) text += bits(v);
  return text;
}

inline std::string bits(const FrontPoint& p) {
  std::string text = "\npoint of " + std::to_string(p.part) + " x " + bits(p.x) + " objectives " +
                     bits(p.objectives) + " costs " + bits(p.costs) + " weights " +
                     bits(p.weights) + std::string(to_string(p.verdict)) + "; " + p.reason + "; " +
                     (p.is_global ? "global; " : "") + p.solver;
  for (const Standing& limit : p.limits) {
    text += "\n  " + limit.name + " [" + limit.unit + "] " + bits(limit.margin) +
            (limit.angle ? bits(*limit.angle) : "nowhere ") + (limit.met ? "met " : "") +
            (limit.proved ? "proved " : "") + bits(limit.price);
  }
  return text;
}

inline std::string bits(const Outcome& o) {
  std::string text = std::to_string(o.evaluations) + (o.infeasible ? " infeasible " : " ") +
                     (o.is_global ? "global " : "") + (o.died ? "died " : "") + o.failure;
  for (const FrontPoint& p : o.points) text += bits(p);
  return text;
}

inline std::string bits(const std::optional<Outcome>& o) { return o ? bits(*o) : "none"; }

inline std::string bits(const Outcomes& outcomes) {
  std::string text;
  for (const auto& o : outcomes) text += bits(o) + "\n";
  return text;
}

inline std::string bits(const Front& f) {
  std::string text = bits(f.ideal) + bits(f.nadir) + bits(f.reference) + bits(f.hypervolume) +
                     (f.hypervolume_at_most ? bits(*f.hypervolume_at_most) : "none") +
                     std::to_string(f.parts) + " " + std::to_string(f.empty_parts) + " " +
                     std::to_string(f.tasks) + " " + std::to_string(f.evaluations) +
                     (f.complete ? " complete" : "");
  for (const FailedTask& task : f.failures) {
    text += "\n" + std::to_string(task.number) + " " + std::to_string(task.part) + " " + task.why;
  }
  for (const FrontPoint& p : f.points) text += bits(p);
  return text;
}

/// A point with every kind of number.
inline FrontPoint odd_point() {
  FrontPoint p;
  p.part = 3;
  p.x = {1.0 / 3, kInfinity, -kInfinity, kNan, 5e-324};
  p.objectives = {-1e300, kNan};
  p.costs = {1e300, kInfinity};
  p.weights = {1, 0};
  p.verdict = Verdict::Certified;
  p.reason = "größer; 'quoted' \"twice\"\nand a line";
  p.is_global = true;
  p.solver = "slsqp";
  p.limits = {{"angle", "deg", 0.1, 123.456, true, true, -0.25},
              {"", "", kNan, {}, false, false, kInfinity},
              {"third", "mm", -kInfinity, 0.0, true, false, kNan}};
  return p;
}

inline Outcome odd_outcome() {
  FrontPoint plain;
  plain.part = 3;
  plain.x = {1, 2, 3, 4, 5};
  plain.objectives = plain.costs = {7, 8};
  return {{odd_point(), plain}, false, 1'234'567'890'123, ""};
}

}  // namespace camlaw::optim::study_tests
