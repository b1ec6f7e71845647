// SPDX-License-Identifier: MIT
#include "numerics/formula/blocks/block_slopes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "numerics/formula/blocks/join.h"
#include "numerics/formula/operations.h"
#include "numerics/formula/steps.h"

namespace camlaw {
namespace {

/// Points of a block: so many that a step's loop takes longer than to begin it, so few that the
/// rows of a formula stay in the processor's nearer memory.
constexpr std::size_t kPoints = 32;

using Row = std::array<double, kPoints>;

/// The points of a block at which a step is owed something: else it is in no chosen branch there.
enum class Owes : char { Nowhere, Somewhere, Everywhere };

}  // namespace

/// One evaluation of a BlockSlopes: the rows of its steps, of one block after the other.
class BlockPass {
 public:
  BlockPass(const BlockSlopes& all, std::span<const double> first)
      : all_(all), steps_(all.constants_.size()), still_(all.constants_) {
    results_.resize(steps_), owed_.resize(steps_), marks_.resize(steps_);
    owes_.assign(steps_, Owes::Nowhere);
    for (const BackStep& step : all.still_) {
      still_[step.result] =
          step.operation == Operation::Input
              ? first[step.a]
              : operate<double>(step.operation, still_[step.a], still_[step.b], still_[step.c]);
    }
    for (const std::uint32_t step : all.operands_) {
      results_[step].fill(still_[step]);
      owed_[step].fill(0);
    }
  }

  /// Of the points from `begin` on, so many.
  void run(const BlockSlopes::Points& points, const BlockSlopes::Slopes& slopes, std::size_t begin,
           std::size_t count) {
    begin_ = begin, count_ = count;
    go_through(points);
    for (const BackStep& step : all_.moving_) {
      owed_[step.result].fill(0);
      owes_[step.result] = Owes::Nowhere;
    }
    for (const auto& row : slopes.by_others) std::fill_n(&row[begin], count, 0.0);
    take_values(points, slopes);
    for (auto step = all_.moving_.rbegin(); step != all_.moving_.rend(); ++step) {
      if (owes_[step->result] == Owes::Nowhere) continue;
      if (step->operation == Operation::Input) {
        const auto& row = slopes.by_others[step->a - all_.first_];
        std::copy_n(owed_[step->result].begin(), count, &row[begin]);
      } else {
        hand_back(*step);
      }
    }
  }

  /// Through the steps that stay, once all blocks are done.
  void finish(std::span<double> by_first) {
    std::vector<double> owed(steps_);
    const auto handed = std::make_unique<bool[]>(steps_);
    for (const std::uint32_t step : all_.operands_) {
      for (const double part : owed_[step]) owed[step] += part;
      handed[step] = owes_[step] != Owes::Nowhere;
    }
    for (auto step = all_.still_.rbegin(); step != all_.still_.rend(); ++step) {
      if (!handed[step->result]) continue;
      if (step->operation == Operation::Input) {
        by_first[step->a] += owed[step->result];
      } else {
        camlaw::hand_back(*step, still_.data(), owed.data(), handed.get());
      }
    }
  }

 private:
  void go_through(const BlockSlopes::Points& points) {
    for (const BackStep& step : all_.moving_) {
      double* to = results_[step.result].data();
      if (step.operation == Operation::Input) {
        std::copy_n(&points.others[step.a - all_.first_][begin_], count_, to);
        continue;
      }
      const double *a = results_[step.a].data(), *b = results_[step.b].data(),
                   *c = results_[step.c].data();
      const auto at_each = [&](const auto& f) {
        for (std::size_t i = 0; i < count_; ++i) to[i] = f(i);
      };
      switch (step.operation) {
        case Operation::Add:
          at_each([=](std::size_t i) { return a[i] + b[i]; });
          break;
        case Operation::Subtract:
          at_each([=](std::size_t i) { return a[i] - b[i]; });
          break;
        case Operation::Multiply:
          at_each([=](std::size_t i) { return a[i] * b[i]; });
          break;
        case Operation::Divide:
          at_each([=](std::size_t i) { return a[i] / b[i]; });
          break;
        default:
          at_each([&](std::size_t i) { return operate<double>(step.operation, a[i], b[i], c[i]); });
      }
    }
  }

  /// What the formulas come to, and what is owed to them.
  void take_values(const BlockSlopes::Points& points, const BlockSlopes::Slopes& slopes) {
    for (std::size_t k = 0; k < all_.values_.size(); ++k) {
      const auto& weights = points.weights[k];
      if (weights.empty()) continue;
      const std::uint32_t value = all_.values_[k];
      const bool moves = std::any_of(all_.moving_.begin(), all_.moving_.end(),
                                     [&](const BackStep& s) { return s.result == value; });
      for (std::size_t i = 0; i < count_; ++i) {
        slopes.values[k][begin_ + i] = moves ? results_[value][i] : still_[value];
        owed_[value][i] += weights[begin_ + i];
      }
      owes_[value] = Owes::Everywhere;
    }
  }

  bool is_owed(std::uint32_t step, std::size_t i) const {
    return owes_[step] == Owes::Everywhere || (owes_[step] == Owes::Somewhere && marks_[step][i]);
  }
  /// Adds part(i) to what is owed to an operand.
  template <class F>
  void hand(std::uint32_t from, std::uint32_t to, const F& part) {
    if (!all_.varies_[to]) return;
    double* owed = owed_[to].data();
    if (owes_[from] == Owes::Everywhere) {
      for (std::size_t i = 0; i < count_; ++i) owed[i] += part(i);
      owes_[to] = Owes::Everywhere;
      return;
    }
    hand_where([&](std::size_t i) { return is_owed(from, i); }, to, part);
  }
  /// The same at some of the points.
  template <class Where, class F>
  void hand_where(const Where& where, std::uint32_t to, const F& part) {
    auto& marks = marks_[to];
    if (owes_[to] == Owes::Nowhere) marks.fill(false), owes_[to] = Owes::Somewhere;
    for (std::size_t i = 0; i < count_; ++i) {
      if (!where(i)) continue;
      owed_[to][i] += part(i);
      marks[i] = true;
    }
  }
  void hand_back(const BackStep& step);
  void choose(const BackStep& step);

  const BlockSlopes& all_;
  std::size_t steps_, begin_ = 0, count_ = 0;
  std::vector<double> still_;  ///< results of the steps that stay
  std::vector<Row> results_, owed_;
  std::vector<Owes> owes_;
  std::vector<std::array<bool, kPoints>> marks_;  ///< where, of those that are owed somewhere
};

void BlockPass::choose(const BackStep& step) {
  const Row &due = owed_[step.result], &a = results_[step.a], &b = results_[step.b];
  std::array<std::uint32_t, 3> operands{step.a, step.b, step.c};
  std::ranges::sort(operands);
  const auto end = std::unique(operands.begin(), operands.end());
  for (auto operand = operands.begin(); operand != end; ++operand) {
    const std::uint32_t to = *operand;
    if (!all_.varies_[to]) continue;
    std::array<double, kPoints> sign;
    bool any = false;
    for (std::size_t i = 0; i < count_; ++i) {
      const HandedTo choice = chosen(step, a[i], b[i]);
      sign[i] = choice.step == to && is_owed(step.result, i) ? choice.sign : 0;
      any = any || sign[i] != 0;
    }
    if (any) {
      hand_where([&](std::size_t i) { return sign[i] != 0; }, to,
                 [&](std::size_t i) { return sign[i] * due[i]; });
    }
  }
}

void BlockPass::hand_back(const BackStep& step) {
  if (is_choice(step.operation)) return choose(step);
  const double *due = owed_[step.result].data(), *own = results_[step.result].data(),
               *a = results_[step.a].data(), *b = results_[step.b].data(),
               *partner = results_[step.partner].data();
  const auto to_a = [&](const auto& part) { hand(step.result, step.a, part); };
  const auto to_b = [&](const auto& part) { hand(step.result, step.b, part); };
  const bool has_partner = step.partner != step.result;
  switch (step.operation) {
    case Operation::Add:
      to_a([=](std::size_t i) { return due[i]; });
      return to_b([=](std::size_t i) { return due[i]; });
    case Operation::Subtract:
      to_a([=](std::size_t i) { return due[i]; });
      return to_b([=](std::size_t i) { return -due[i]; });
    case Operation::Multiply:
      to_a([=](std::size_t i) { return due[i] * b[i]; });
      return to_b([=](std::size_t i) { return due[i] * a[i]; });
    case Operation::Divide:
      to_a([=](std::size_t i) { return due[i] / b[i]; });
      return to_b([=](std::size_t i) { return -(due[i] / b[i] * own[i]); });
    case Operation::Negate:
      return to_a([=](std::size_t i) { return -due[i]; });
    case Operation::Sqrt:
      return to_a([=](std::size_t i) { return due[i] / (own[i] + own[i]); });
    case Operation::Sin:
      return has_partner ? to_a([=](std::size_t i) { return due[i] * partner[i]; })
                         : to_a([=](std::size_t i) { return due[i] * std::cos(a[i]); });
    case Operation::Cos:
      return has_partner ? to_a([=](std::size_t i) { return -due[i] * partner[i]; })
                         : to_a([=](std::size_t i) { return -due[i] * std::sin(a[i]); });
    case Operation::Tan:
      return to_a([=](std::size_t i) { return due[i] * (1 + own[i] * own[i]); });
    case Operation::Asin:
      return to_a([=](std::size_t i) { return due[i] / std::sqrt((1 - a[i]) * (1 + a[i])); });
    case Operation::Atan:
      return to_a([=](std::size_t i) { return due[i] / (1 + a[i] * a[i]); });
    case Operation::Log:
      return to_a([=](std::size_t i) { return due[i] / a[i]; });
    case Operation::Exp:
      return to_a([=](std::size_t i) { return due[i] * own[i]; });
    case Operation::Power:
      return to_a([=](std::size_t i) { return due[i] * power_slope(a[i], b[i]); });
    case Operation::Absolute:
      return to_a([=](std::size_t i) { return a[i] < 0 ? -due[i] : due[i]; });
    default:  // what has no operands
      return;
  }
}

BlockSlopes::BlockSlopes(std::span<const Formula> formulas, std::size_t first) : first_(first) {
  Recorder all;
  inputs_ = first;
  for (const Formula& formula : formulas) {
    values_.push_back(join(formula, all));
    inputs_ = std::max(inputs_, formula.inputs());
  }
  const std::vector<Step>& steps = all.steps();
  varies_ = reached_from(0, steps);
  const std::vector<bool> moves = reached_from(first, steps);
  constants_.resize(steps.size());
  std::vector<bool> is_operand(steps.size());
  for (std::uint32_t i = 0; i < steps.size(); ++i) {
    const Step& step = steps[i];
    if (!varies_[i]) {
      constants_[i] = step.operation == Operation::Constant
                          ? step.value
                          : operate<double>(step.operation, constants_[step.a], constants_[step.b],
                                            constants_[step.c]);
      continue;
    }
    (moves[i] ? moving_ : still_).push_back(back_step(steps, i));
    if (!moves[i]) continue;
    const std::uint32_t from[] = {step.a, step.b, step.c};
    for (std::size_t k = 0; k < camlaw::operands(step.operation); ++k) {
      is_operand[from[k]] = !moves[from[k]];
    }
  }
  for (const std::uint32_t value : values_) {
    if (!moves[value]) is_operand[value] = true;
  }
  for (std::uint32_t i = 0; i < steps.size(); ++i) {
    if (is_operand[i]) operands_.push_back(i);
  }
}

void BlockSlopes::operator()(std::span<const double> first, const Points& points,
                             const Slopes& slopes) const {
  BlockPass pass(*this, first);
  std::size_t count = 0;
  for (const auto& row : points.weights) count = std::max(count, row.size());
  for (std::size_t begin = 0; begin < count; begin += kPoints) {
    pass.run(points, slopes, begin, std::min(kPoints, count - begin));
  }
  pass.finish(slopes.by_first);
}

}  // namespace camlaw
