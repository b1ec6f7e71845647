// SPDX-License-Identifier: MIT
#include <fmt/format.h>

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

/// Whether a law goes from rest to rest over one stroke: only of such the limit holds.
bool is_rest_to_rest(const Law<double>& law) {
  constexpr double kSame = 1e-9;
  const auto begin = law(0.0), end = law(1.0);
  return std::abs(begin.v) < kSame && std::abs(end.v) < kSame &&
         std::abs(end.s - begin.s - 1) < kSame;
}

/// That all laws of the problem are such: at the start, and with each number that varies at its
/// bounds.
bool are_rest_to_rest(const ProblemStatement& statement) {
  const auto are = [](const ProblemStatement& design) {
    return std::all_of(design.laws.begin(), design.laws.end(),
                       [](const Member& law) { return is_rest_to_rest(law.law()); });
  };
  if (!are(statement)) return false;
  const bool vary = std::any_of(statement.laws.begin(), statement.laws.end(), [](const auto& law) {
    return law.family->ends == "by parameters";
  });
  return !vary ||
         std::all_of(statement.variables.begin(), statement.variables.end(), [&](const auto& v) {
           if (!v.of_law) return true;
           for (const double value : {v.lower, v.upper}) {
             ProblemStatement design = statement;
             try {
               set_value(design, fmt::format("{}={}", v.name, value));
             } catch (const std::invalid_argument&) {
               continue;  // no law
             }
             if (!are(design)) return false;
           }
           return true;
         });
}

/// Integral of B^2 / (B - 1) from 1 + `from` to 1 + `to`.
double integral(double from, double to) {
  const auto polynomial = [](double b) { return b * (b / 2 + 2); };
  return polynomial(to) - polynomial(from) + std::log(to / from);
}

}  // namespace

double FrontRuler::least_acceleration_value(double velocity_value) const {
  return acceleration_factor * least_acceleration(velocity_value / velocity_factor);
}

double FrontRuler::hypervolume(const optim::Costs& reference) const {
  const double B = reference[of_velocity] / velocity_factor;
  const double C = reference[of_acceleration] / acceleration_factor;
  if (!(C > 4)) return 0;  // no law has less
  // From where B^2 / (B - 1) = C, to 2, and beyond that with C = 4. B - 1 there, exactly enough:
  const double root = std::sqrt(1 - 4 / C);
  const double from = 4 / C / ((1 + root) * (1 + root));
  if (!(B - 1 > from)) return 0;
  const double to = std::min(B - 1, 1.0);
  double area = C * (to - from) - integral(from, to);
  if (B > 2) area += (C - 4) * (B - 2);
  return area * velocity_factor * acceleration_factor;
}

std::optional<FrontRuler> front_ruler(const ProblemStatement& statement) {
  const auto& objectives = statement.objectives;
  if (objectives.size() != 2 || statement.mechanism->moved_by != MovedBy::Law) return {};
  for (const ObjectiveStatement& o : objectives) {
    if (o.sense != optim::Sense::Minimize || !is_of_law_alone(statement, o)) return {};
  }
  if (!are_rest_to_rest(statement)) return {};
  for (std::size_t first = 0; first < 2; ++first) {
    const auto B = factor_of(statement, objectives[first], true);
    const auto C = factor_of(statement, objectives[1 - first], false);
    if (B && C) return FrontRuler{first, 1 - first, *B, *C};
  }
  return {};
}

}  // namespace camlaw::problems
