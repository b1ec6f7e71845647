// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "optim/problem/problem.h"

namespace camlaw::problems {

/// What is usually asked of a machine first: a problem to begin with, as data. Numbers are in the
/// listed units of the parameters and responses.
struct UsualProblem {
  /// A constant whose default does not suit the problem.
  struct Constant {
    const char* parameter;
    double value;
  };
  struct Variable {
    const char* parameter;
    double lower, upper, start;
  };
  struct Limit {
    const char* response;
    std::optional<double> lower, upper;
  };
  /// Of a motion program; a segment without a law is a dwell. The last takes what is left of a
  /// turn.
  struct Segment {
    const char* name;
    double angle;  ///< deg
    const char* law;
  };

  const char* objective;
  optim::Sense sense = optim::Sense::Minimize;
  std::vector<Variable> variables = {};
  std::vector<Limit> limits = {};
  /// Responses that are often asked for beside these; none: all of them.
  std::vector<const char*> others = {};
  std::vector<Constant> constants = {};
  const char* law = nullptr;           ///< where a law moves the mechanism
  std::vector<Segment> segments = {};  ///< where a program does
};

inline std::shared_ptr<const UsualProblem> usual_problem(UsualProblem problem) {
  return std::make_shared<const UsualProblem>(std::move(problem));
}

inline constexpr std::nullopt_t kNone = std::nullopt;  ///< no limit on this side

/// Up, a dwell, back, a dwell.
inline std::vector<UsualProblem::Segment> rise_and_return() {
  return {{"rise", 110, "modified-sine"},
          {"high", 50, nullptr},
          {"return", 120, "cycloidal"},
          {"low", 80, nullptr}};
}

/// A dwell on both sides of the motion to the next station.
inline std::vector<UsualProblem::Segment> index_once(double dwell, double index) {
  return {{"dwell", dwell, nullptr},
          {"index", index, "modified-sine"},
          {"rest", 360 - dwell - index, nullptr}};
}

}  // namespace camlaw::problems
