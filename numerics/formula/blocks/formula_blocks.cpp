// SPDX-License-Identifier: MIT
#include "numerics/formula/blocks/formula_blocks.h"

#include <algorithm>
#include <stdexcept>

#include "numerics/formula/blocks/join.h"
#include "numerics/formula/operations.h"
#include "numerics/formula/steps.h"

namespace camlaw {
namespace {

/// Points of a block: so many that a step's loop takes longer than to begin it, so few that the
/// registers stay in the processor's nearest memory.
constexpr std::size_t kBlock = 128;

/// A step that only depends on its operands, with these in one order where none matters.
Step in_order(Step step) {
  const bool has_order = step.operation != Operation::Add && step.operation != Operation::Multiply;
  if (!has_order && step.a > step.b) std::swap(step.a, step.b);
  return step;
}

/// Room for numbers, kept for the next call on this thread.
std::span<double> room(std::size_t size) {
  constexpr std::size_t kLine = 64;  // bytes of a cache line, which is a vector of the widest set
  thread_local std::vector<double> numbers;
  numbers.resize(std::max(numbers.size(), size + kLine / sizeof(double)));
  void* begin = numbers.data();
  std::size_t space = numbers.size() * sizeof(double);
  return {static_cast<double*>(std::align(kLine, size * sizeof(double), begin, space)), size};
}

/// The rows of one call, at one block after the other.
class Rows {
 public:
  Rows(const BlockProgram& program, const std::vector<double>& still,
       std::span<const std::span<const double>> others, std::span<const std::span<double>> values)
      : program_(program), others_(others), values_(values) {
    const std::size_t single = program.values + program.inputs;
    const std::span<double> numbers =
        room(program.registers * kBlock + single * BlockKernels::kTogether);
    to_.resize(program.values);
    for (std::size_t k = 0; k < program.registers; ++k) to_.push_back(&numbers[k * kBlock]);
    rest_ = numbers.data() + program.registers * kBlock;
    from_.assign(to_.begin(), to_.end());
    from_.resize(program.written() + program.inputs);
    for (const std::uint32_t step : program.still) from_.push_back(&still[step]);
  }

  /// Whole groups of points, from the i-th on: where they are.
  BlockRows at(std::size_t i) {
    for (std::size_t k = 0; k < program_.values; ++k) from_[k] = to_[k] = values_[k].data() + i;
    for (std::size_t k = 0; k < program_.inputs; ++k) {
      from_[program_.written() + k] = others_[k].empty() ? nullptr : others_[k].data() + i;
    }
    return {from_.data(), to_.data()};
  }

  /// Fewer points than a group: in a group of their own, the first of them in the places left.
  BlockRows some(std::size_t i, std::size_t count) {
    double* row = rest_;
    for (std::size_t k = 0; k < program_.values; ++k, row += BlockKernels::kTogether) {
      from_[k] = to_[k] = row;
    }
    for (std::size_t k = 0; k < program_.inputs; ++k, row += BlockKernels::kTogether) {
      from_[program_.written() + k] = row;
      if (others_[k].empty()) continue;
      std::fill_n(row, BlockKernels::kTogether, others_[k][i]);
      std::copy_n(&others_[k][i], count, row);
    }
    return {from_.data(), to_.data()};
  }
  void take(std::size_t i, std::size_t count) const {
    for (std::size_t k = 0; k < program_.values; ++k) std::copy_n(to_[k], count, &values_[k][i]);
  }

 private:
  const BlockProgram& program_;
  std::span<const std::span<const double>> others_;
  std::span<const std::span<double>> values_;
  double* rest_;  ///< for the points that fill no group
  std::vector<double*> to_;
  std::vector<const double*> from_;
};

}  // namespace

std::uint32_t join(const Formula& formula, Recorder& all) {
  std::vector<std::uint32_t> number;
  for (Step step : formula.steps()) {
    std::uint32_t* from[] = {&step.a, &step.b, &step.c};
    for (std::size_t k = 0; k < operands(step.operation); ++k) *from[k] = number[*from[k]];
    number.push_back(all.write(in_order(step)));
  }
  return number.back();
}

FormulaBlocks::FormulaBlocks(std::span<const Formula> formulas, std::size_t first) : first_(first) {
  Recorder all;
  std::vector<std::uint32_t> values;
  std::size_t inputs = first;
  for (const Formula& formula : formulas) {
    values.push_back(join(formula, all));
    inputs = std::max(inputs, formula.inputs());
  }
  steps_ = all.steps();
  roots_ = FormulaRoots(steps_);
  used_.resize(inputs - first);
  const std::vector<bool> varies = reached_from(0, steps_), moves = reached_from(first, steps_);
  constants_.resize(steps_.size());
  for (std::uint32_t i = 0; i < steps_.size(); ++i) {
    const Step& step = steps_[i];
    if (moves[i]) {
      if (step.operation == Operation::Input) used_[step.a - first] = true;
      if (step.operation == Operation::Root) each_.assign(formulas.begin(), formulas.end());
    } else if (roots_.has_inside(i)) {
      continue;
    } else if (varies[i] || step.operation == Operation::Root) {
      design_.push_back(i);
    } else {
      constants_[i] = step.operation == Operation::Constant
                          ? step.value
                          : operate<double>(step.operation, constants_[step.a], constants_[step.b],
                                            constants_[step.c]);
    }
  }
  program_.values = values.size();
  program_.inputs = inputs - first;
  if (each_.empty()) program_ = block_program(steps_, values, first, inputs - first);
}

std::vector<double> FormulaBlocks::still_at(std::span<const double> first) const {
  std::vector<double> r = constants_;
  for (const std::uint32_t i : design_) {
    const Step& step = steps_[i];
    if (step.operation == Operation::Input) {
      r[i] = first[step.a];
    } else if (step.operation == Operation::Root) {
      r[i] = roots_.solve(i, r.data());
    } else {
      r[i] = operate<double>(step.operation, r[step.a], r[step.b], r[step.c]);
    }
  }
  return r;
}

void FormulaBlocks::run_each(std::span<const double> first,
                             std::span<const std::span<const double>> others,
                             std::span<const std::span<double>> values) const {
  std::vector<double> point(others.size());
  for (std::size_t k = 0; k < each_.size(); ++k) {
    const FormulaAlong<double> formula(each_[k], first);
    for (std::size_t i = 0; i < values[k].size(); ++i) {
      for (std::size_t n = 0; n < point.size(); ++n) {
        point[n] = others[n].empty() ? 0 : others[n][i];
      }
      values[k][i] = formula(std::span<const double>(point));
    }
  }
}

void FormulaBlocks::check(std::size_t first, std::span<const std::span<const double>> others,
                          std::span<const std::span<double>> values) const {
  if (first != first_ || others.size() != program_.inputs || values.size() != program_.values) {
    throw std::invalid_argument("formulas over points: another number of inputs or of values");
  }
  for (const auto& row : values) {
    if (row.size() == values.front().size()) continue;
    throw std::invalid_argument("formulas over points: rows of values differ in length");
  }
  for (std::size_t k = 0; k < others.size(); ++k) {
    if (others[k].size() == values.front().size() || (others[k].empty() && !used_[k])) continue;
    throw std::invalid_argument(
        "formulas over points: a row of inputs is not as long as the values");
  }
}

void FormulaBlocks::run(const BlockKernels& kernels, std::span<const double> first,
                        std::span<const std::span<const double>> others,
                        std::span<const std::span<double>> values) const {
  if (values.empty()) return;
  check(first.size(), others, values);
  if (!each_.empty()) return run_each(first, others, values);
  const std::vector<double> still = still_at(first);
  const BlockSteps steps{program_.steps.data(), program_.steps.size(), &operate<double>};
  Rows rows(program_, still, others, values);
  const std::size_t points = values.front().size();
  const std::size_t whole = points - points % BlockKernels::kTogether;
  for (std::size_t i = 0; i < whole; i += kBlock) {
    kernels.run(steps, rows.at(i), std::min(whole - i, kBlock));
  }
  if (whole < points) {
    kernels.run(steps, rows.some(whole, points - whole), BlockKernels::kTogether);
    rows.take(whole, points - whole);
  }
}

void FormulaBlocks::operator()(std::span<const double> first,
                               std::span<const std::span<const double>> others,
                               std::span<const std::span<double>> values) const {
  run(*block_kernels().front(), first, others, values);
}

}  // namespace camlaw
