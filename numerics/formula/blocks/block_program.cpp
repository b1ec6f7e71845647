// SPDX-License-Identifier: MIT
#include "numerics/formula/blocks/block_program.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "numerics/formula/operations.h"
#include "numerics/formula/steps.h"

namespace camlaw {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// The loop that an operation has of its own, where it has one.
BlockCode code_of(Operation operation) {
  switch (operation) {
    case Operation::Add:
      return BlockCode::Add;
    case Operation::Subtract:
      return BlockCode::Subtract;
    case Operation::Multiply:
      return BlockCode::Multiply;
    case Operation::Divide:
      return BlockCode::Divide;
    case Operation::Negate:
      return BlockCode::Negate;
    case Operation::Sqrt:
      return BlockCode::Sqrt;
    case Operation::Sin:
      return BlockCode::Sin;
    case Operation::Cos:
      return BlockCode::Cos;
    case Operation::Tan:
      return BlockCode::Tan;
    case Operation::Asin:
      return BlockCode::Asin;
    case Operation::Atan:
      return BlockCode::Atan;
    case Operation::Log:
      return BlockCode::Log;
    case Operation::Absolute:
      return BlockCode::Absolute;
    case Operation::BySide:
      return BlockCode::BySide;
    case Operation::Along:
      return BlockCode::Along;
    case Operation::WherePositive:
      return BlockCode::WherePositive;
    case Operation::UnlessZero:
      return BlockCode::UnlessZero;
    default:
      return BlockCode::Each;
  }
}

/// Arithmetic whose second operand stays.
BlockCode with_still(Operation operation) {
  switch (operation) {
    case Operation::Add:
      return BlockCode::AddStill;
    case Operation::Subtract:
      return BlockCode::SubtractStill;
    case Operation::Multiply:
      return BlockCode::MultiplyStill;
    default:
      return BlockCode::DivideStill;
  }
}

class Writer {
 public:
  Writer(const std::vector<Step>& steps, const std::vector<std::uint32_t>& values,
         std::size_t first, std::size_t inputs)
      : steps_(steps),
        first_(first),
        moves_(reached_from(first, steps)),
        row_(steps.size(), kNone),
        uses_(steps.size()),
        value_(steps.size(), kNone) {
    program_.values = values.size();
    program_.inputs = inputs;
    for (auto k = static_cast<std::uint32_t>(values.size()); k-- > 0;) value_[values[k]] = k;
    for (const Step& step : steps) {
      for (std::size_t k = 0; k < operands(step.operation); ++k) ++uses_[from(step)[k]];
    }
    // Inputs and what stays are numbered behind the registers, once it is known how many there are.
    for (std::uint32_t i = 0; i < steps.size(); ++i) {
      if (moves_[i]) write(i);
    }
    for (std::uint32_t k = 0; k < values.size(); ++k) write_value(k, values[k]);
    for (BlockStep& step : program_.steps) {
      for (std::uint32_t* row : {&step.a, &step.b, &step.c}) *row = numbered(*row);
    }
  }

  BlockProgram program() const { return program_; }

 private:
  /// Of rows that are read only, until they are numbered.
  static constexpr std::uint32_t kInput = 1U << 30, kStill = 1U << 31;

  static std::array<std::uint32_t, 3> from(const Step& step) { return {step.a, step.b, step.c}; }

  std::uint32_t numbered(std::uint32_t row) const {
    if (row >= kStill) {
      return static_cast<std::uint32_t>(program_.written() + program_.inputs) + (row - kStill);
    }
    return row >= kInput ? static_cast<std::uint32_t>(program_.written()) + (row - kInput) : row;
  }

  std::uint32_t still_row(std::uint32_t step) {
    if (row_[step] == kNone) {
      row_[step] = kStill + static_cast<std::uint32_t>(program_.still.size());
      program_.still.push_back(step);
    }
    return row_[step];
  }

  std::uint32_t new_register() {
    if (free_.empty()) {
      return static_cast<std::uint32_t>(program_.values + program_.registers++);
    }
    const std::uint32_t row = free_.back();
    free_.pop_back();
    return row;
  }

  /// Values keep their rows.
  void release(std::uint32_t row) {
    if (row >= program_.values && row < kInput) free_.push_back(row);
  }

  std::uint32_t result_row(std::uint32_t step) {
    return row_[step] = value_[step] == kNone ? new_register() : value_[step];
  }

  void add(BlockCode code, Operation operation, std::uint32_t result,
           const std::array<std::uint32_t, 3>& rows) {
    program_.steps.push_back({code, operation, result, rows[0], rows[1], rows[2]});
  }

  void write(std::uint32_t i) {
    const Step& step = steps_[i];
    if (step.operation == Operation::Input) {
      row_[i] = kInput + step.a - static_cast<std::uint32_t>(first_);
    } else if (row_[i] == kNone) {  // else it was written with its partner
      is_arithmetic(step.operation) ? write_arithmetic(i) : write_other(i);
    }
  }

  /// Its operands' registers may have the result.
  void write_arithmetic(std::uint32_t i) {
    const Step& step = steps_[i];
    std::uint32_t a = row_of(step.a), b = row_of(step.b);
    BlockCode code = code_of(step.operation);
    if (!moves_[step.b]) {
      code = with_still(step.operation);
    } else if (!moves_[step.a]) {
      if (step.operation == Operation::Subtract) code = BlockCode::StillSubtract;
      if (step.operation == Operation::Divide) code = BlockCode::StillDivide;
      if (step.operation == Operation::Add || step.operation == Operation::Multiply) {
        code = with_still(step.operation);
        std::swap(a, b);
      }
    }
    use(step);
    add(code, step.operation, result_row(i), {a, b, 0});
  }

  void write_other(std::uint32_t i) {
    const Step& step = steps_[i];
    std::array<std::uint32_t, 3> rows{};
    std::vector<std::uint32_t> filled;
    for (std::size_t k = 0; k < operands(step.operation); ++k) {
      const std::uint32_t operand = from(step)[k];
      rows[k] = row_of(operand);
      if (moves_[operand]) continue;
      filled.push_back(new_register());
      add(BlockCode::Fill, step.operation, filled.back(), {rows[k], 0, 0});
      rows[k] = filled.back();
    }
    const auto partner = sine_or_cosine_too(i);
    use(step);
    if (partner) {
      use(steps_[*partner]);
      const bool is_sine = step.operation == Operation::Sin;
      const std::uint32_t own = result_row(i), other = result_row(*partner);
      add(BlockCode::SinCos, step.operation, is_sine ? own : other,
          {rows[0], is_sine ? other : own, 0});
    } else {
      add(code_of(step.operation), step.operation, result_row(i), rows);
    }
    for (const std::uint32_t row : filled) release(row);
  }

  /// A later step that takes the cosine where this one takes the sine, or the other way round.
  std::optional<std::uint32_t> sine_or_cosine_too(std::uint32_t i) const {
    const Operation operation = steps_[i].operation;
    if (operation != Operation::Sin && operation != Operation::Cos) return {};
    const Operation wanted = operation == Operation::Sin ? Operation::Cos : Operation::Sin;
    for (std::uint32_t k = i + 1; k < steps_.size(); ++k) {
      if (steps_[k].operation == wanted && steps_[k].a == steps_[i].a) return k;
    }
    return {};
  }

  std::uint32_t row_of(std::uint32_t step) { return moves_[step] ? row_[step] : still_row(step); }

  void use(const Step& step) {
    for (std::size_t k = 0; k < operands(step.operation); ++k) {
      const std::uint32_t operand = from(step)[k];
      if (moves_[operand] && --uses_[operand] == 0) release(row_[operand]);
    }
  }

  /// Where the value has not been written to its place: it stays, is an input, or another one's.
  void write_value(std::uint32_t k, std::uint32_t step) {
    const std::uint32_t row = row_of(step);
    if (row == k) return;
    add(moves_[step] ? BlockCode::Copy : BlockCode::Fill, steps_[step].operation, k, {row, 0, 0});
  }

  const std::vector<Step>& steps_;
  std::size_t first_;
  std::vector<bool> moves_;
  std::vector<std::uint32_t> row_;    ///< of each step's result, once it has one
  std::vector<std::size_t> uses_;     ///< by steps that are yet to be written
  std::vector<std::uint32_t> value_;  ///< which value a step is, if any
  std::vector<std::uint32_t> free_;   ///< registers that nothing needs any more
  BlockProgram program_;
};

}  // namespace

BlockProgram block_program(const std::vector<Step>& steps, const std::vector<std::uint32_t>& values,
                           std::size_t first, std::size_t inputs) {
  return Writer(steps, values, first, inputs).program();
}

}  // namespace camlaw
