// SPDX-License-Identifier: MIT
#include "optim/solvers/nlopt_methods.h"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

namespace camlaw::optim {
namespace {

// NLopt's AGS has arrays of fixed size (solverMaxDim, solverMaxConstraints in its data_types.hpp).
constexpr std::size_t kAgsVariables = 10;
constexpr std::size_t kAgsSides = 10;

/// NLopt built for C alone lacks some methods (Debian's libnlopt0 lacks AGS; libnlopt-cxx0 has it).
bool is_compiled(nlopt_algorithm algorithm) {
  const std::string_view name = nlopt_algorithm_name(algorithm);
  return name.find("NOT COMPILED") == std::string_view::npos;
}

bool has_box(const Program& program) {
  for (std::size_t i = 0; i < program.variables(); ++i) {
    if (!std::isfinite(program.upper()[i] - program.lower()[i])) return false;
  }
  return true;
}

std::optional<std::string> row_refusal(const NloptMethod& method, const Program& program) {
  const std::size_t sides = inequality_sides(program).size();
  const std::size_t equations = equation_sides(program).size();
  if (sides + equations == 0) return {};
  if (equations > program.variables()) {
    return fmt::format("{} needs at least as many variables as equations; there are {} and {}",
                       method.name, program.variables(), equations);
  }
  if (method.augmented || method.takes == Takes::AllRows) return {};
  if (method.takes == Takes::NoRows) {
    return fmt::format("{} takes no constraints besides bounds on the variables", method.name);
  }
  if (equations > 0) return fmt::format("{} takes no equations", method.name);
  if (method.algorithm == NLOPT_GN_AGS && sides > kAgsSides) {
    return fmt::format("{} takes at most {} bounds on rows; there are {}", method.name, kAgsSides,
                       sides);
  }
  return {};
}

}  // namespace

const std::vector<NloptMethod>& nlopt_methods() {
  static const std::vector<NloptMethod> methods{
      {"slsqp", NLOPT_LD_SLSQP, false, true, Takes::AllRows},
      {"mma", NLOPT_LD_MMA, false, true, Takes::Inequalities},
      {"ccsaq", NLOPT_LD_CCSAQ, false, true, Takes::Inequalities},
      {"lbfgs", NLOPT_LD_LBFGS, false, true, Takes::NoRows},
      {"auglag-lbfgs", NLOPT_LD_LBFGS, false, true, Takes::NoRows, true},
      {"cobyla", NLOPT_LN_COBYLA, false, false, Takes::AllRows},
      {"bobyqa", NLOPT_LN_BOBYQA, false, false, Takes::NoRows},
      {"auglag-bobyqa", NLOPT_LN_BOBYQA, false, false, Takes::NoRows, true},
      {"direct-l", NLOPT_GN_DIRECT_L, true, false, Takes::NoRows, true},
      {"crs2", NLOPT_GN_CRS2_LM, true, false, Takes::NoRows, true},
      {"isres", NLOPT_GN_ISRES, true, false, Takes::AllRows},
      {"esch", NLOPT_GN_ESCH, true, false, Takes::NoRows, true},
      {"mlsl", NLOPT_G_MLSL_LDS, true, true, Takes::NoRows, true},
      {"ags", NLOPT_GN_AGS, true, false, Takes::Inequalities},
  };
  return methods;
}

bool is_wrapped(const NloptMethod& method, const Program& program) {
  return method.augmented &&
         !(inequality_sides(program).empty() && equation_sides(program).empty());
}

std::vector<Side> inequality_sides(const Program& program) {
  std::vector<Side> sides;
  for (std::size_t r = 0; r < program.rows(); ++r) {
    if (program.row_is_equation(r)) continue;
    if (std::isfinite(program.row_upper()[r])) sides.push_back({r, 1, program.row_upper()[r]});
    if (std::isfinite(program.row_lower()[r])) sides.push_back({r, -1, program.row_lower()[r]});
  }
  return sides;
}

std::vector<Side> equation_sides(const Program& program) {
  std::vector<Side> sides;
  for (std::size_t r = 0; r < program.rows(); ++r) {
    if (program.row_is_equation(r)) sides.push_back({r, 1, program.row_upper()[r]});
  }
  return sides;
}

std::optional<std::string> why_refused(const NloptMethod& method, const Program& program) {
  const std::size_t variables = program.variables();
  if (!is_compiled(method.algorithm)) {
    return fmt::format("{} is not compiled into this build of NLopt", method.name);
  }
  if (variables == 0) return {};
  if (method.is_global && !has_box(program)) {
    return fmt::format("{} searches the whole box: each variable needs a lower and an upper bound",
                       method.name);
  }
  if (method.algorithm == NLOPT_GN_AGS && variables > kAgsVariables) {
    return fmt::format("{} takes at most {} variables; there are {}", method.name, kAgsVariables,
                       variables);
  }
  return row_refusal(method, program);
}

std::string nlopt_version() {
  int major = 0, minor = 0, bugfix = 0;
  ::nlopt_version(&major, &minor, &bugfix);
  return fmt::format("nlopt {}.{}.{}", major, minor, bugfix);
}

}  // namespace camlaw::optim
