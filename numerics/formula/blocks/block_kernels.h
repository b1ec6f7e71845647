// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

/// The loops that evaluate steps of formulas at many points, once for each instruction set. This
/// header and those that the loops are compiled with name no other part of camlaw and no container
/// (kinematics/spans/span_kernels.h says why).
namespace camlaw {

enum class Operation : std::uint8_t;

/// What a step of a block does. `Still`: that operand is one number, the same at every point.
enum class BlockCode : std::uint8_t {
  Copy,
  Fill,  ///< with the still number a
  Add,
  AddStill,
  Subtract,
  SubtractStill,
  StillSubtract,  ///< a still number less b
  Multiply,
  MultiplyStill,
  Divide,
  DivideStill,
  StillDivide,
  Negate,
  Sqrt,
  Sin,
  Cos,
  SinCos,  ///< the sine; the cosine goes where b says
  Tan,
  Asin,
  Atan,
  Log,
  Absolute,
  BySide,
  Along,
  WherePositive,
  UnlessZero,
  Each,  ///< any other operation, point by point
};

/// Operands and results are numbers of rows.
struct BlockStep {
  BlockCode code;
  Operation operation;  ///< of Each
  std::uint32_t result;
  std::uint32_t a, b, c;
};

struct BlockSteps {
  const BlockStep* steps;
  std::size_t count;
  /// What Each calls.
  double (*operate)(Operation operation, const double& a, const double& b, const double& c);
};

/// Where each row has its numbers, or its one. What is written has its rows first.
struct BlockRows {
  const double* const* from;
  double* const* to;
};

struct BlockKernels {
  /// Points that are computed together: what a block's number of points is a multiple of.
  static constexpr std::size_t kTogether = 8;

  const char* instruction_set;
  std::size_t width;  ///< points at a time

  void (*run)(const BlockSteps& steps, BlockRows rows, std::size_t points);
};

/// Those that this processor can run, the quickest first; the last one runs everywhere.
std::span<const BlockKernels* const> block_kernels();

}  // namespace camlaw
