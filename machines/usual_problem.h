// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "machines/model/mechanism.h"

/// What is usually asked of each mechanism first: a problem to begin with, as data.
namespace camlaw::problems {

/// Numbers are in the listed units of the parameters and responses.
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

  const char* mechanism;
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

/// The usual problem of a listed mechanism. Throws std::logic_error where there is none, which a
/// test looks for.
const UsualProblem& usual_problem(const Mechanism& mechanism);

/// A number for an input of checks, which has no default: something of the right size to be
/// changed. Throws std::logic_error for an unknown input.
double usual_input(std::string_view name);

}  // namespace camlaw::problems
