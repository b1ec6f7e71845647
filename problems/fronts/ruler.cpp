// SPDX-License-Identifier: MIT
#include "problems/fronts/ruler.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>

#include "kinematics/peaks.h"
#include "machines/model/fixed_binding.h"
#include "optim/cycle/scales.h"
#include "problems/statement/bind.h"
#include "problems/statement/parameters.h"

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

std::array<double, 3> constants_of(const Law<double>& law) {
  const Peaks<double> found = peaks(law);
  return {found.max_velocity(), found.max_acceleration(), found.max_jerk()};
}

/// The factor, where the objective is the same multiple of a constant with every law that has it.
/// Where the acceleration jumps there is no peak jerk: front_ruler sees to it that no law does.
std::optional<double> factor_of(const ProblemStatement& statement,
                                const ObjectiveStatement& objective, std::size_t constant) {
  // Peaks of the laws are known to far more digits; what is no constant multiple differs in the
  // first.
  constexpr double kSame = 1e-9;
  std::optional<double> factor;
  for (const Member& law : some_laws()) {
    const double its = constants_of(law.law())[constant];
    if (!std::isfinite(its)) continue;
    const Binding binding = fixed_binding(statement.constants, law);
    const optim::Objective measured{
        make_response(*statement.mechanism, objective.response, binding), objective.sense,
        objective.response.part};
    const double share = optim::objective_value(measured, {}) / its;
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
  return std::none_of(statement.variables.begin(), statement.variables.end(),
                      [&](const auto& v) { return !v.of_law && uses.holds(v.parameter); });
}

/// Whether a law goes from rest to rest over one stroke without a jump of the velocity: only of
/// such the limit holds.
bool is_rest_to_rest(const Law<double>& law) {
  constexpr double kSame = 1e-9;  // of the stroke, as a law's file is taken (law_file)
  const auto begin = law(0.0), end = law(1.0, Side::Left);
  return std::abs(begin.v) < kSame && std::abs(end.v) < kSame &&
         std::abs(end.s - begin.s - 1) < kSame && !jumps(law).velocity;
}

/// Whether its peak jerk is that of its pieces: no jump of the acceleration, at rest neither.
bool is_without_shock(const Law<double>& law) {
  return !jumps(law.with_ends({End::Rest, End::Rest})).acceleration;
}

/// That all laws of the problem are such: at the start, and with each number that varies at its
/// bounds.
template <class Such>
bool are_all(const ProblemStatement& statement, const Such& such) {
  const auto are = [&](const ProblemStatement& design) {
    return std::all_of(design.laws.begin(), design.laws.end(),
                       [&](const Member& law) { return such(law.law()); });
  };
  return are(statement) &&
         std::all_of(statement.variables.begin(), statement.variables.end(), [&](const auto& v) {
           if (!v.of_law) return true;
           for (const double value : {v.lower, v.upper}) {
             ProblemStatement design = statement;
             const NamedParameter parameter = find_parameter(design, v.name);
             put_value(design, parameter, parameter.element.value_or(0), value);
             if (are_possible(design.laws) && !are(design)) return false;
           }
           return true;
         });
}

/// The measures of what the limits leave below a reference are integrals of `reference - least(x)`
/// (theory, (D5) and (D6)). Here of velocities up to B and accelerations up to C:
double below_acceleration(double B, double C) {
  if (!(C > 4)) return 0;  // no law has less
  // From where b^2 / (b - 1) = C, to 2, and beyond that with 4. b - 1 there, exactly enough:
  const double root = std::sqrt(1 - 4 / C);
  const double from = 4 / C / ((1 + root) * (1 + root));
  if (!(B - 1 > from)) return 0;
  const double to = std::min(B - 1, 1.0);
  const auto antiderivative = [](double x) { return x * (x / 2 + 2) + std::log(x); };
  const double area = C * (to - from) - (antiderivative(to) - antiderivative(from));
  return area + std::max(0.0, B - 2) * (C - 4);
}

/// Of accelerations up to C and jerks up to D with peak velocity at most b <= 2.
double below_jerk(double b, double C, double D) {
  const double k = b * b / (b - 1);  // the least acceleration
  const double least = 4 * b * k / (b - 1);
  if (!(D > least) || !(C > k)) return 0;
  // From where the least jerk is D, to c = 2 k, from where on it does not change. c - k there:
  const double from = k * (2 / (1 + std::sqrt(1 - least / D)) - 1);
  if (!(C - k > from)) return 0;
  const double to = std::min(C - k, k);
  const auto antiderivative = [&](double y) {
    return b / (b - 1) * (y * (y / 2 + 2 * k) + k * k * std::log(y));
  };
  const double area = D * (to - from) - (antiderivative(to) - antiderivative(from));
  return area + std::max(0.0, C - 2 * k) * (D - least);
}

/// Integral of a function of b that is smooth but where the least jerk for it has its least at C.
template <typename F>
double over_velocity(F f, double from, double to, double C) {
  const double bend = 2 / (1 + std::sqrt(std::max(0.0, 1 - 8 / C)));  // 2 b^2 / (b - 1) = C
  boost::math::quadrature::tanh_sinh<double> quadrature;
  const double middle = std::clamp(bend, from, to);
  double sum = 0;
  if (middle > from) sum += quadrature.integrate(f, from, middle);
  if (to > middle) sum += quadrature.integrate(f, middle, to);
  return sum;
}

/// Of velocities up to B, accelerations up to C, which may be infinite, and jerks up to D.
double below_limit(double B, double C, double D) {
  const auto at = [&](double b) {
    return std::isinf(C) ? D - least_jerk(b, C) : below_jerk(b, C, D);
  };
  const auto reaches = [&](double b) { return least_jerk(b, C) < D; };
  const double most = std::min(B, 2.0);
  if (!reaches(most)) return 0;
  double low = 1, high = most;  // the least velocity with which anything is left
  for (int i = 0; i < 60; ++i) {
    const double middle = low + (high - low) / 2;
    (reaches(middle) ? high : low) = middle;
  }
  return over_velocity(at, high, most, C) + std::max(0.0, B - 2) * at(2);
}

}  // namespace

double FrontRuler::limit_index(const std::vector<double>& values) const {
  std::array<double, 3> constants;
  for (std::size_t i = 0; i < 3; ++i) {
    constants[i] = of[i] ? values[of[i]->objective] / of[i]->factor : optim::kInfinity;
  }
  return least_time(constants[0], constants[1], constants[2]);
}

std::pair<FrontRuler::Measure, FrontRuler::Measure> FrontRuler::pair() const {
  return {of[0] ? *of[0] : *of[1], of[2] ? *of[2] : *of[1]};
}

double FrontRuler::least(double lower_value) const {
  const auto [lower, higher] = pair();
  const double value = lower_value / lower.factor;
  if (!of[2]) return higher.factor * least_acceleration(value);
  return higher.factor *
         (of[0] ? least_jerk(value, optim::kInfinity) : least_jerk(optim::kInfinity, value));
}

double FrontRuler::hypervolume(const optim::Costs& reference) const {
  std::array<double, 3> most;
  double unit = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    most[i] = of[i] ? reference[of[i]->objective] / of[i]->factor : optim::kInfinity;
    if (of[i]) unit *= of[i]->factor;
  }
  if (!of[2]) return unit * below_acceleration(most[0], most[1]);
  if (!of[0]) return unit * below_jerk(2, most[1], most[2]);
  return unit * below_limit(most[0], most[1], most[2]);
}

std::optional<FrontRuler> front_ruler(const ProblemStatement& statement) {
  const auto& objectives = statement.objectives;
  if (objectives.size() < 2 || objectives.size() > 3) return {};
  if (statement.mechanism->moved_by != MovedBy::Law) return {};
  for (const ObjectiveStatement& o : objectives) {
    if (o.sense != optim::Sense::Minimize || !is_of_law_alone(statement, o)) return {};
  }
  if (!are_all(statement, is_rest_to_rest)) return {};
  FrontRuler ruler;
  for (std::size_t i = 0; i < objectives.size(); ++i) {
    bool found = false;
    for (std::size_t constant = 0; constant < 3 && !found; ++constant) {
      const auto factor = factor_of(statement, objectives[i], constant);
      found = factor.has_value();
      if (!found) continue;
      if (ruler.of[constant]) return {};  // the same twice
      ruler.of[constant] = FrontRuler::Measure{i, *factor};
    }
    if (!found) return {};
  }
  if (ruler.of[2] && !are_all(statement, is_without_shock)) return {};
  return ruler;
}

}  // namespace camlaw::problems
