// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "kinematics/limits.h"
#include "kinematics/peaks.h"
#include "optim/problem/sizes.h"
#include "problems/fronts/front_study.h"

namespace camlaw::problems {
namespace {

/// Laws without jumps of velocity, unlike one another and not symmetric.
std::vector<Member> some_laws() {
  std::vector<Member> laws;
  for (const char* name : {"cubic crossover=0.4", "poly-3-4-5 crossover=0.55", "cycloidal",
                           "modified-sine crossover=0.45", "polynomial-5 alpha=-3"}) {
    laws.push_back(find_law(name));
  }
  return laws;
}

double constant_of(const Peaks<double>& peaks, bool velocity) {
  return velocity ? peaks.B() : peaks.C();
}

/// The factor, where the objective is the same multiple of the constant with every law.
std::optional<double> factor_of(const ProblemStatement& statement,
                                const ObjectiveStatement& objective, bool velocity) {
  constexpr double kSame = 1e-9;
  std::optional<double> factor;
  for (const Member& law : some_laws()) {
    Binding binding;
    binding.constants = statement.constants;
    binding.law = std::make_shared<LawBinding>(law, std::vector<LawVariable>{});
    const optim::Objective measured{
        make_response(*statement.mechanism, objective.response, binding), objective.sense,
        objective.response.part};
    const double share =
        optim::objective_value(measured, {}) / constant_of(peaks(law.law()), velocity);
    if (!(share > 0) || (factor && std::abs(share / *factor - 1) > kSame)) return {};
    factor = share;
  }
  return factor;
}

/// Whether nothing that varies but the law moves the objective.
bool is_of_law_alone(const ProblemStatement& statement, const ObjectiveStatement& objective) {
  if (objective.response.response == nullptr || !objective.response.response->sees_law)
    return false;
  const auto& uses = objective.response.response->uses;
  return std::none_of(statement.variables.begin(), statement.variables.end(), [&](const auto& v) {
    return !v.of_law && std::find(uses.begin(), uses.end(), v.parameter) != uses.end();
  });
}

/// Integral of B^2 / (B - 1).
double integral(double B) { return B * B / 2 + B + std::log(B - 1); }

}  // namespace

double FrontRuler::least_acceleration_value(double velocity_value) const {
  return acceleration_factor * least_acceleration(velocity_value / velocity_factor);
}

double FrontRuler::hypervolume(const optim::Costs& reference) const {
  const double B = reference[of_velocity] / velocity_factor;
  const double C = reference[of_acceleration] / acceleration_factor;
  if (!(C > 4)) return 0;  // no law has less
  // From where B^2 / (B - 1) = C, to 2, and beyond that with C = 4.
  const double from = (C - std::sqrt(C * C - 4 * C)) / 2;
  if (!(B > from)) return 0;
  const double to = std::min(B, 2.0);
  double area = C * (to - from) - (integral(to) - integral(from));
  if (B > 2) area += (C - 4) * (B - 2);
  return area * velocity_factor * acceleration_factor;
}

std::optional<FrontRuler> front_ruler(const ProblemStatement& statement) {
  const auto& objectives = statement.objectives;
  if (objectives.size() != 2 || statement.mechanism->moved_by != MovedBy::Law) return {};
  for (const ObjectiveStatement& o : objectives) {
    if (o.sense != optim::Sense::Minimize || !is_of_law_alone(statement, o)) return {};
  }
  for (std::size_t first = 0; first < 2; ++first) {
    const auto B = factor_of(statement, objectives[first], true);
    const auto C = factor_of(statement, objectives[1 - first], false);
    if (B && C) return FrontRuler{first, 1 - first, *B, *C};
  }
  return {};
}

}  // namespace camlaw::problems
