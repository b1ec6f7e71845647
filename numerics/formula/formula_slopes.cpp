// SPDX-License-Identifier: MIT
#include "numerics/formula/formula_slopes.h"

#include <algorithm>
#include <limits>
#include <memory>

#include "numerics/formula/operations.h"
#include "numerics/formula/steps.h"

namespace camlaw {
namespace {

/// The step with the sine of the angle whose cosine a step is, or the other way round; else itself.
std::uint32_t partner_of(const std::vector<Step>& steps, std::uint32_t i) {
  const bool is_sine = steps[i].operation == Operation::Sin;
  if (!is_sine && steps[i].operation != Operation::Cos) return i;
  const Operation wanted = is_sine ? Operation::Cos : Operation::Sin;
  const auto found = std::find_if(steps.begin(), steps.end(), [&](const Step& step) {
    return step.operation == wanted && step.a == steps[i].a;
  });
  return found == steps.end() ? i : static_cast<std::uint32_t>(found - steps.begin());
}

}  // namespace

BackStep back_step(const std::vector<Step>& steps, std::uint32_t i) {
  const Step& step = steps[i];
  return {step.operation, i, step.a, step.b, step.c, partner_of(steps, i)};
}

bool is_choice(Operation operation) {
  switch (operation) {
    case Operation::Greater:
    case Operation::Lesser:
    case Operation::BySide:
    case Operation::Along:
    case Operation::WherePositive:
    case Operation::UnlessZero:
      return true;
    default:
      return false;
  }
}

bool FormulaSlopes::knows(const Formula& formula) {
  return std::none_of(formula.steps().begin(), formula.steps().end(),
                      [](const Step& step) { return step.operation == Operation::Root; });
}

FormulaSlopes::FormulaSlopes(const Formula& formula) : uses_(formula.uses()) {
  const std::vector<Step>& steps = formula.steps();
  const std::vector<bool> varies = reached_from(0, steps);
  constants_.resize(steps.size());
  for (std::uint32_t i = 0; i < steps.size(); ++i) {
    const Step& step = steps[i];
    if (varies[i]) {
      varying_.push_back(back_step(steps, i));
    } else {
      constants_[i] = step.operation == Operation::Constant
                          ? step.value
                          : operate<double>(step.operation, constants_[step.a], constants_[step.b],
                                            constants_[step.c]);
    }
  }
}

template <class T>
void FormulaSlopes::go_through(std::span<const T> u, T* results) const {
  for (const BackStep& step : varying_) {
    results[step.result] =
        step.operation == Operation::Input
            ? u[step.a]
            : operate<T>(step.operation, results[step.a], results[step.b], results[step.c]);
  }
}

template <class T>
T FormulaSlopes::operator()(std::span<const T> u, std::span<T> slopes) const {
  thread_local std::vector<T> room;
  thread_local std::unique_ptr<bool[]> marks;
  thread_local std::size_t marked = 0;
  const std::size_t size = constants_.size();
  room.resize(std::max(room.size(), 2 * size));
  T *results = room.data(), *owed = results + size;
  std::transform(constants_.begin(), constants_.end(), results,
                 [](double x) { return number<T>(x); });
  go_through(u, results);
  std::fill_n(owed, size, number<T>(0));
  if (marked < size) {
    marks = std::make_unique<bool[]>(size);
    marked = size;
  }
  bool* const handed = marks.get();
  std::fill_n(handed, size, false);
  std::fill(slopes.begin(), slopes.end(), number<T>(0));
  const T value = results[size - 1];
  owed[size - 1] = number<T>(1);
  handed[size - 1] = true;
  for (auto step = varying_.rbegin(); step != varying_.rend(); ++step) {
    if (step->operation == Operation::Input) {
      slopes[step->a] = owed[step->result];
    } else if (handed[step->result]) {  // else it is in no chosen branch
      hand_back(*step, results, owed, handed);
    }
  }
  return value;
}

template double FormulaSlopes::operator()(std::span<const double>, std::span<double>) const;
template Dual FormulaSlopes::operator()(std::span<const Dual>, std::span<Dual>) const;

double FormulaSlopes::hessian(std::span<const double> u, std::span<double> g,
                              std::span<double> h) const {
  std::fill(h.begin(), h.end(), 0.0);
  if (uses_.empty()) {
    std::fill(g.begin(), g.end(), 0.0);
    return constants_.back();
  }
  std::vector<Dual> seeded(u.begin(), u.end()), slopes(u.size());
  double value = 0;
  for (std::size_t block = 0; block < uses_.size(); block += kDualWidth) {
    const std::size_t end = std::min(uses_.size(), block + kDualWidth);
    for (std::size_t k = block; k < end; ++k) seeded[uses_[k]].v[int(k - block)] = 1;
    value = (*this)(std::span<const Dual>(seeded), std::span<Dual>(slopes)).a;
    for (std::size_t k = block; k < end; ++k) {
      const std::size_t column = uses_[k];
      for (const std::size_t row : uses_) {
        if (row >= column) h[row * (row + 1) / 2 + column] = slopes[row].v[int(k - block)];
      }
      seeded[column] = Dual(u[column]);
    }
  }
  for (std::size_t i = 0; i < u.size(); ++i) g[i] = slopes[i].a;
  return value;
}

}  // namespace camlaw
