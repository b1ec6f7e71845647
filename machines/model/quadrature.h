// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "numerics/scalar/scalar.h"
#include "optim/problem/automatic.h"
#include "optim/problem/deadline.h"

/// Gauss-Legendre quadrature over steps that are halved until their error is small (docs/theory.md,
/// (R3)).
namespace camlaw::problems {

inline constexpr std::size_t kMeanPoints = 10;  ///< of a step

/// The places from -1 to 1 of a step, and their weights.
struct MeanRule {
  std::array<double, kMeanPoints> places, weights;
};
const MeanRule& mean_rule();

/// A step in the scalar in use, of one of the sections of what is integrated.
template <class T>
struct MeanStep {
  T middle, half;
  std::size_t section;

  /// The place at t, from -1 to 1.
  T at(double t) const { return middle + t * half; }
};

/// So many even steps between two places of a section, added to others.
template <class T>
void add_even_steps(const T& begin, const T& end, int count, std::size_t section,
                    std::vector<MeanStep<T>>& steps) {
  const T half = (end - begin) / number<T>(2.0 * count);
  for (int i = 0; i < count; ++i) {
    steps.push_back({begin + number<T>(2 * i + 1) * half, half, section});
  }
}

/// Calls take(value) with integrand(section, place) at each place of each step.
template <class T, class F, class Take>
void at_each_place(std::span<const MeanStep<T>> steps, const F& integrand, const Take& take) {
  const MeanRule& rule = mean_rule();
  for (const MeanStep<T>& step : steps) {
    for (const double t : rule.places) take(integrand(step.section, step.at(t)));
  }
}

/// (R3) An estimate of the rule's error over (-1, 1), from the values at its places: by how fast
/// the integrand's Legendre coefficients decrease.
double gauss_error(std::span<const double, kMeanPoints> values);

/// Whether an integral of an integrand times the distance from a step's middle is wanted too.
enum class Lever { None, AboutMiddle };

/// The integral of an integrand over steps that are short enough: a step is halved while its error
/// is more than 1e-11 of the integral of the integrand's size, until 4000 steps are added or a step
/// is shorter than 1e-13; noise of the integrand beyond that stays. Plain numbers alone decide
/// which steps are halved; an integral has the exact derivatives of the quadrature over these
/// steps.
template <class T, Lever kLever = Lever::None>
class Quadrature {
 public:
  struct Step {
    MeanStep<T> step;
    T integral;
    T levered;           ///< the integral of integrand * (place - middle), where it is wanted
    double error, size;  ///< of the integral, and the integral of the integrand's size
  };

  /// evaluate(std::span<const MeanStep<T>>, take) calls take(value) as at_each_place does. `size`
  /// is the integral of the integrand's size over all of what this is a part of.
  template <class Evaluate>
  Quadrature(const std::vector<MeanStep<T>>& steps, const Evaluate& evaluate, double size = 0)
      : steps_(evaluated(steps, evaluate)) {
    for (std::size_t added = 0; added < kMostAdded;) {
      optim::check_deadline();
      const double allowed = kError * std::max(size, this->size());
      std::vector<MeanStep<T>> halves;
      for (const Step& one : steps_) {
        if (!is_long(one, allowed)) continue;
        const T half = 0.5 * one.step.half;
        for (const double t : {-0.5, 0.5}) {
          halves.push_back({one.step.at(t), half, one.step.section});
        }
      }
      if (halves.empty()) break;
      added += halves.size();
      replace_long(allowed, evaluated(halves, evaluate));
    }
  }

  /// From the left to the right.
  const std::vector<Step>& steps() const { return steps_; }
  T sum() const {
    T sum = number<T>(0);
    for (const Step& one : steps_) sum = sum + one.integral;
    return sum;
  }
  /// The integral of the integrand's size.
  double size() const {
    double size = 0;
    for (const Step& one : steps_) size += one.size;
    return size;
  }

 private:
  /// Sums round by 1e-14 of the integral of the integrand's size, and no answer shows eleven
  /// digits.
  static constexpr double kError = 1e-11;
  static constexpr std::size_t kMostAdded = 4000;  ///< steps: what is noise stays noise in any
  static constexpr double kShortest = 1e-13;       ///< what is left of a jump

  static bool is_long(const Step& one, double allowed) {
    return one.error > allowed && std::abs(value_of(one.step.half)) > kShortest;
  }
  template <class Evaluate>
  static std::vector<Step> evaluated(const std::vector<MeanStep<T>>& steps,
                                     const Evaluate& evaluate) {
    const MeanRule& rule = mean_rule();
    std::vector<Step> all;
    all.reserve(steps.size());
    std::array<double, kMeanPoints> plain;
    std::size_t k = 0;
    evaluate(std::span<const MeanStep<T>>(steps), [&](const T& value) {
      if (k == 0) all.push_back({steps[all.size()], number<T>(0), number<T>(0), 0, 0});
      Step& one = all.back();
      const T weighted = rule.weights[k] * value;
      one.integral = one.integral + weighted;
      if constexpr (kLever == Lever::AboutMiddle) {
        one.levered = one.levered + rule.places[k] * weighted;
      }
      plain[k] = value_of(value);
      one.size += rule.weights[k] * std::abs(plain[k]);
      if (++k < kMeanPoints) return;
      k = 0;
      const T& half = one.step.half;
      one.integral = half * one.integral;
      one.levered = half * half * one.levered;
      one.error = std::abs(value_of(half)) * gauss_error(plain);
      one.size *= std::abs(value_of(half));
    });
    return all;
  }
  /// By their halves, which follow one another.
  void replace_long(double allowed, std::vector<Step> halves) {
    std::vector<Step> all;
    auto next = halves.begin();
    for (Step& one : steps_) {
      if (is_long(one, allowed)) {
        for (int side = 0; side < 2; ++side) all.push_back(std::move(*next++));
      } else {
        all.push_back(std::move(one));
      }
    }
    steps_ = std::move(all);
  }

  std::vector<Step> steps_;
};

}  // namespace camlaw::problems
