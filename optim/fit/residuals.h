// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "optim/problem/automatic.h"

/// What a fit makes small: residuals as functions of the parameters.
namespace camlaw::optim {

/// n residuals r_i(p), all in one unit: model minus measurement as a rule, divided by the
/// measurement's standard deviation where those differ. Pure: equal p, equal bits.
class Residuals {
 public:
  virtual ~Residuals() = default;
  virtual std::size_t count() const = 0;
  /// Of how many measurements they tell: of more than count() where few stand for many. Then there
  /// is no loss.
  virtual std::size_t measurements() const { return count(); }
  /// What the sum of squares of all measurements has beside that of the residuals, whatever p.
  virtual double rest() const { return 0; }
  /// Fills r[i] and, where `jacobian` is not empty, jacobian[i * p.size() + j] = dr_i/dp_j, exact
  /// up to rounding. Returns false where the model is undefined at p; a number that is not finite
  /// says the same.
  virtual bool evaluate(std::span<const double> p, std::span<double> r,
                        std::span<double> jacobian) const = 0;
};

/// Residuals made of others, of as many and of the same measurements. Keeps a reference to them.
class ResidualsOf : public Residuals {
 public:
  explicit ResidualsOf(const Residuals& residuals) : residuals_(residuals) {}

  std::size_t count() const override { return residuals_.count(); }
  std::size_t measurements() const override { return residuals_.measurements(); }
  double rest() const override { return residuals_.rest(); }

 protected:
  const Residuals& residuals_;
};

/// Residuals from a generic callable, written once for double and dual numbers:
///   template <class T> bool f(std::span<const T> p, std::span<T> r)
/// fills r and returns whether the model is defined at p. For example
///   AutomaticResiduals line(x.size(), [&](const auto& p, const auto& r) {
///     for (std::size_t i = 0; i < r.size(); ++i) r[i] = p[0] + p[1] * x[i] - y[i];
///     return true;
///   });
/// Any number of parameters; four derivatives a pass (docs/optimisation.md, (DV1)).
template <class F>
class AutomaticResiduals final : public Residuals {
 public:
  AutomaticResiduals(std::size_t count, F f) : count_(count), f_(std::move(f)) {}

  std::size_t count() const override { return count_; }

  bool evaluate(std::span<const double> p, std::span<double> r,
                std::span<double> jacobian) const override {
    if (jacobian.empty()) return f_(p, r);
    std::vector<PassDual> seeded(p.begin(), p.end()), duals(count_);
    for (std::size_t block = 0; block < p.size(); block += kPassWidth) {
      const std::size_t end = std::min(p.size(), block + kPassWidth);
      for (std::size_t j = block; j < end; ++j) seeded[j].v[static_cast<int>(j - block)] = 1;
      if (!f_(std::span<const PassDual>(seeded), std::span<PassDual>(duals))) return false;
      for (std::size_t i = 0; i < count_; ++i) {
        r[i] = duals[i].a;
        for (std::size_t j = block; j < end; ++j) {
          jacobian[i * p.size() + j] = duals[i].v[static_cast<int>(j - block)];
        }
      }
      for (std::size_t j = block; j < end; ++j) seeded[j] = PassDual(p[j]);
    }
    return true;
  }

 private:
  std::size_t count_;
  F f_;
};

}  // namespace camlaw::optim
