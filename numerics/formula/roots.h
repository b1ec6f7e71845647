// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "numerics/formula/operations.h"
#include "numerics/scalar/root.h"

namespace camlaw {

/// The roots of a list of steps (docs/theory.md, "Roots"). A root's equation and level are steps of
/// the list that lie inside it: they are run at the places that it tries, and nowhere else.
class FormulaRoots {
 public:
  FormulaRoots() = default;
  explicit FormulaRoots(const std::vector<Step>& steps);

  /// Whether a step lies inside some root.
  bool has_inside(std::size_t step) const { return step < inside_.size() && inside_[step]; }

  /// Calls f for each step outside the root whose result it needs.
  template <class F>
  void for_each_operand(std::uint32_t step, const F& f) const {
    for (const std::uint32_t i : root_at(step).operands) f(i);
  }

  /// The root from the results of its operands; those of the steps inside are overwritten. It is
  /// searched in plain numbers. Of an interval of machines over which it cannot be followed it is
  /// known to lie between its ends, of a series of intervals nothing is known.
  template <class T>
  T solve(std::uint32_t step, T* results) const;

 private:
  struct Inside {
    std::uint32_t at;
    Step step;
  };
  struct Root {
    std::uint32_t at, unknown, low, high, equation, level;
    std::vector<Inside> for_equation, for_level;
    std::vector<std::uint32_t> operands;
    /// The steps inside, numbered on their own: what equal roots of several formulas share.
    std::shared_ptr<const std::vector<Step>> text;
    std::size_t hash;
  };

  const Root& root_at(std::uint32_t step) const {
    return *std::find_if(roots_.begin(), roots_.end(), [&](const Root& r) { return r.at == step; });
  }
  /// Runs steps inside a root with its unknown at x and returns the result of one of them.
  template <class T>
  T run(const Root& root, const std::vector<Inside>& inside, std::uint32_t value, const T& x,
        T* results) const;
  /// The place of a root in plain numbers: remembered, as many rows ask for that of one design. The
  /// size of the scalar that they come from tells which: roundings differ.
  double place(const Root& root, double* plain, std::size_t scalar) const;

  std::vector<bool> inside_;
  std::vector<Root> roots_;
};

template <class T>
T FormulaRoots::run(const Root& root, const std::vector<Inside>& inside, std::uint32_t value,
                    const T& x, T* results) const {
  results[root.unknown] = x;
  for (const auto& [at, step] : inside) {
    results[at] = step.operation == Operation::Root ? solve(at, results)
                                                    : operate<T>(step.operation, results[step.a],
                                                                 results[step.b], results[step.c]);
  }
  return results[value];
}

template <class T>
T FormulaRoots::solve(std::uint32_t step, T* results) const {
  const Root& root = root_at(step);
  // The results of operands, in another scalar.
  const auto in = [&]<class S>(const S& other, const auto& converted) {
    std::vector<S> all(inside_.size(), other);
    for (const std::uint32_t i : root.operands) all[i] = converted(results[i]);
    return all;
  };
  const auto zero = [&]<class S>(const S& x, S* r) {
    return run<S>(root, root.for_equation, root.equation, x, r);
  };
  if constexpr (std::is_same_v<T, double>) {
    return place(root, results, sizeof(T));
  } else if constexpr (is_interval_series<T>) {
    return number<T>(std::numeric_limits<double>::quiet_NaN());  // it is not followed over boxes
  } else {
    auto plain = in(0.0, [](const T& x) { return value_of(x); });
    const double x0 = place(root, plain.data(), sizeof(T));
    const auto f = [&](const T& x) { return zero(x, results); };
    if constexpr (std::is_same_v<T, Interval>) {
      using Slopes = Series<Interval, 2>;
      auto along = in(Slopes(), [](const Interval& x) { return Slopes(x); });
      const Interval found = root_near<T>(x0, f, [&](const Interval& range) {
        return zero(Slopes::variable(range, Interval(1.0)), along.data()).c[1];
      });
      // Newton's step holds the root beside x0. Over a box of machines another root may have the
      // highest level in a part of it: then the ends alone are known.
      constexpr double kOneMachine = 1e-8;
      const bool is_one =
          std::all_of(root.operands.begin(), root.operands.end(), [&](std::uint32_t i) {
            const Interval& x = results[i];
            return boost::numeric::width(x) <= kOneMachine * std::max(1.0, magnitude(x));
          });
      const bool is_found = found.lower() <= found.upper();
      return is_found && is_one ? found
                                : boost::numeric::hull(results[root.low], results[root.high]);
    } else {
      auto along = in(Dual(0.0), [](const T& x) { return Dual(value_of(x)); });
      return root_near<T>(x0, f, [&](double at) {
        Dual x(at);
        x.v[0] = 1;
        return zero(x, along.data()).v[0];
      });
    }
  }
}

}  // namespace camlaw
