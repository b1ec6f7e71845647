// SPDX-License-Identifier: MIT
#pragma once

#include <nlopt.h>

#include <optional>
#include <string>
#include <vector>

#include "optim/solvers/native_options.h"
#include "optim/solvers/program.h"

/// NLopt's methods as camlaw offers them: what each can take, and why not. For nlopt.cpp alone.
namespace camlaw::optim {

/// The rows that an algorithm takes by itself.
enum class Takes { NoRows, Inequalities, AllRows };

struct NloptMethod {
  const char* name;
  nlopt_algorithm algorithm;
  bool is_global;
  bool uses_gradients;
  Takes takes;
  /// Whether rows may be put around it as an augmented Lagrangian (NLOPT_AUGLAG).
  bool augmented = false;
};

const std::vector<NloptMethod>& nlopt_methods();

/// Whether the program's rows are put around the method as an augmented Lagrangian.
bool is_wrapped(const NloptMethod& method, const Program& program);

/// A bound of a row as NLopt wants it: sign * (row - bound) <= 0, or == 0 for an equation.
struct Side {
  std::size_t row;
  double sign;
  double bound;
};
std::vector<Side> inequality_sides(const Program& program);
std::vector<Side> equation_sides(const Program& program);

/// Why the method cannot take the program, in words; empty where it can.
std::optional<std::string> why_refused(const NloptMethod& method, const Program& program);

}  // namespace camlaw::optim
