// SPDX-License-Identifier: MIT
#include "machines/model/running_work.h"

#include <algorithm>
#include <cmath>

#include "numerics/polynomial/gauss_legendre.h"

namespace camlaw::problems {
namespace {

constexpr int kMostHalvings = 6;  // what is noise stays noise in any step

/// Legendre's polynomials P_0 to P_10 at t.
std::array<double, 11> legendre(double t) {
  std::array<double, 11> p{1, t};
  for (std::size_t n = 1; n + 1 < p.size(); ++n) {
    const auto k = static_cast<double>(n);
    p[n + 1] = ((2 * k + 1) * t * p[n] - k * p[n - 1]) / (k + 1);
  }
  return p;
}

}  // namespace

RunningWork::RunningWork(const TurnSections<double>& turn) : whole_(detail::turned(turn)) {
  for (const auto& section : turn.sections()) {
    const double length = section.end - section.begin;
    const int steps = turn_steps(section.rate, length, detail::kMeanSteps);
    const auto edge = [&](int i) { return section.begin + length * i / steps; };
    for (int i = 0; i < steps && length > 0; ++i) {
      add_steps(turn, section, edge(i), edge(i + 1), kMostHalvings);
    }
  }
}

/// The terms are c_n = (2 n + 1) / 2 sum_i w_i f(t_i) P_n(t_i) by the quadrature's own places.
void RunningWork::add_steps(const TurnSections<double>& turn,
                            const TurnSections<double>::Section& section, double begin, double end,
                            int halvings) {
  // What ten terms leave of the torque is then the rounding of their sums.
  constexpr double kRounding = 1e-13;
  Step step{std::midpoint(begin, end), (end - begin) / 2, 0, {}};
  const auto& [places, weights] = gauss_legendre(kTerms);
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (const double side : {-1.0, 1.0}) {
      const double t = side * places[i];
      const double torque = turn.at(section, step.middle + t * step.half);
      const auto p = legendre(t);
      largest_ = std::max(largest_, std::abs(torque));
      for (std::size_t n = 0; n < kTerms; ++n) {
        step.terms[n] += (static_cast<double>(n) + 0.5) * weights[i] * torque * p[n];
      }
    }
  }
  const double rest = std::abs(step.terms[kTerms - 1]) + std::abs(step.terms[kTerms - 2]);
  if (rest > kRounding * largest_ && halvings > 0) {
    add_steps(turn, section, begin, step.middle, halvings - 1);
    add_steps(turn, section, step.middle, end, halvings - 1);
    return;
  }
  if (!steps_.empty()) step.before = steps_.back().before + steps_.back().integral(1);
  steps_.push_back(step);
}

/// The integral of P_n from -1 to t is (P_(n+1) - P_(n-1)) / (2 n + 1), of P_0 it is t + 1.
double RunningWork::Step::integral(double t) const {
  const auto p = legendre(t);
  double sum = terms[0] * (t + 1);
  for (std::size_t n = 1; n < kTerms; ++n) {
    sum += terms[n] * (p[n + 1] - p[n - 1]) / (2 * static_cast<double>(n) + 1);
  }
  return half * sum;
}

double RunningWork::at(double share) const {
  const auto after = std::partition_point(
      steps_.begin() + 1, steps_.end(), [&](const Step& s) { return s.middle - s.half <= share; });
  const Step& step = *(after - 1);
  const double t = (share - step.middle) / step.half;
  return detail::work_at(whole_, share, step.before + step.integral(t));
}

EnclosedWork::EnclosedWork(TurnSections<Interval> turn)
    : turn_(std::move(turn)), whole_(detail::turned(turn_, steps_)) {
  Interval sum(0.0);
  for (const Steps& steps : steps_) {
    before_.emplace_back();
    for (const detail::EnclosedStep& step : steps) {
      before_.back().push_back(sum);
      sum = sum + step.integral;
    }
  }
}

Interval EnclosedWork::at(const Interval& share, double inside) const {
  const std::size_t section = detail::section_at(turn_, inside, false);
  const auto& own = turn_.sections()[section];
  const double low = std::max(share.lower(), own.begin.lower());
  const double high = std::min(share.upper(), own.end.upper());
  // Beside its end by rounding alone.
  const Interval place = low <= high             ? Interval(low, high)
                         : low > own.end.upper() ? own.end
                                                 : own.begin;
  // A place that rounding has set on two steps may be in either.
  const auto& steps = steps_[section];
  auto step = std::partition_point(
      steps.begin(), steps.end() - 1,
      [&](const detail::EnclosedStep& s) { return s.end.upper() < place.lower(); });
  Interval result = Interval::empty();
  for (; step != steps.end() && step->begin.lower() <= place.upper(); ++step) {
    const Interval inner(std::max(place.lower(), step->begin.lower()),
                         std::min(place.upper(), step->end.upper()));
    const auto number = static_cast<std::size_t>(step - steps.begin());
    const Interval by_all = step->by_terms(detail::kTaylorTerms, inner);
    const Interval before =
        before_[section][number] + (detail::is_bounded(by_all) ? by_all : step->to(inner));
    result = boost::numeric::hull(result, detail::work_at(whole_, inner, before));
  }
  return result;
}

}  // namespace camlaw::problems
