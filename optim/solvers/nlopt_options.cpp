// SPDX-License-Identifier: MIT
#include "optim/solvers/nlopt_options.h"

#include <algorithm>

namespace camlaw::optim {
namespace {

using Kind = NativeRule::Kind;
constexpr double kMostInt = 2147483647;  // NLopt counts in int

NativeRule count(const char* name, double most) {
  return {.name = name, .kind = Kind::Integer, .lower = 1, .upper = most};
}

NativeRule above_zero(const char* name) { return {.name = name, .lower = 0, .above_lower = true}; }

bool has_population(nlopt_algorithm algorithm) {
  return algorithm == NLOPT_GN_CRS2_LM || algorithm == NLOPT_GN_ISRES ||
         algorithm == NLOPT_GN_ESCH || algorithm == NLOPT_G_MLSL_LDS;
}

bool has_vector_storage(nlopt_algorithm algorithm) {
  return algorithm == NLOPT_LD_LBFGS || algorithm == NLOPT_G_MLSL_LDS;
}

bool has_initial_step(nlopt_algorithm algorithm) {
  return algorithm == NLOPT_LN_COBYLA || algorithm == NLOPT_LN_BOBYQA;
}

bool has_dual_problems(nlopt_algorithm algorithm) {
  return algorithm == NLOPT_LD_MMA || algorithm == NLOPT_LD_CCSAQ;
}

void add_dual_problems(std::vector<NativeRule>& rules) {
  rules.push_back(count("inner_maxeval", kMostInt));
  rules.push_back(count("dual_maxeval", kMostInt));
  for (const char* name : {"dual_ftol_rel", "dual_ftol_abs", "dual_xtol_rel", "dual_xtol_abs"}) {
    rules.push_back(above_zero(name));
  }
  rules.push_back(reserved_option("dual_algorithm", "camlaw has measured which is best"));
  rules.push_back(reserved_option("verbosity", "standard output is reserved for the answer"));
}

/// Local methods may end earlier than their tolerances make them; global ones use up their
/// evaluations, and under a Lagrangian an early end would be the beginning of another round.
void add_ends(const NloptMethod& method, std::vector<NativeRule>& rules) {
  const char* own = "it follows from the tolerances of the problem's limits and objective";
  const char* global = "a global method searches until its evaluations are used up";
  for (const char* name : {"ftol_rel", "xtol_rel"}) {
    rules.push_back(reserved_option(name, method.is_global ? global : own));
  }
  for (const char* name : {"ftol_abs", "xtol_abs"}) {
    rules.push_back(method.is_global ? reserved_option(name, global) : above_zero(name));
  }
  rules.push_back(reserved_option("maxeval",
                                  "the limits of iterations and evaluations are common to all "
                                  "solvers"));
  rules.push_back(
      reserved_option("maxtime", "the time limit is common to all solvers (time_limit)"));
  rules.push_back(reserved_option("stopval", "no objective is known beforehand to be good enough"));
}

/// No more than a quarter of a variable's range: NLopt refuses a step that leaves the box.
void set_initial_step(const Program& program, double step, nlopt_opt opt) {
  constexpr double kMost = 0.25;  // of the range: to either side of a start anywhere in it
  std::vector<double> steps(program.variables());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    steps[i] = std::min(step, kMost * (program.upper()[i] - program.lower()[i]));
  }
  nlopt_set_initial_step(opt, steps.data());
}

/// CRS needs more points than there are variables.
unsigned population(const NloptMethod& method, const Program& program, double wanted) {
  const auto stated = static_cast<unsigned>(wanted);
  if (method.algorithm != NLOPT_GN_CRS2_LM) return stated;
  return std::max(stated, static_cast<unsigned>(program.variables() + 1));
}

}  // namespace

std::vector<NativeRule> nlopt_rules(const NloptMethod& method) {
  constexpr double kMostPoints = 1e6, kMostPairs = 1e4;  // what memory there is for them
  std::vector<NativeRule> rules;
  if (has_population(method.algorithm)) rules.push_back(count("population", kMostPoints));
  if (has_vector_storage(method.algorithm)) rules.push_back(count("vector_storage", kMostPairs));
  if (has_initial_step(method.algorithm)) rules.push_back(above_zero("initial_step"));
  if (has_dual_problems(method.algorithm)) add_dual_problems(rules);
  add_ends(method, rules);
  return rules;
}

void set_nlopt_options(const NloptMethod& method, const Program& program,
                       const NativeOptions& options, nlopt_opt opt, nlopt_opt helper) {
  for (const auto& [name, value] : options) {
    const double number = number_of(value);
    if (name == "population") {
      nlopt_set_population(opt, population(method, program, number));
    } else if (name == "vector_storage") {
      const bool is_helpers = method.algorithm == NLOPT_G_MLSL_LDS;
      nlopt_set_vector_storage(is_helpers ? helper : opt, static_cast<unsigned>(number));
    } else if (name == "initial_step") {
      set_initial_step(program, number, opt);
    } else if (name == "ftol_abs") {
      nlopt_set_ftol_abs(opt, number);
    } else if (name == "xtol_abs") {
      nlopt_set_xtol_abs1(opt, number);
    } else {
      nlopt_set_param(opt, name.c_str(), number);
    }
  }
}

}  // namespace camlaw::optim
