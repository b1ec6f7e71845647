// SPDX-License-Identifier: MIT
#pragma once

#include "kinematics/spans/row_loops.h"

/// The loops of SpanKernels for vectors V. Included by the files that are compiled for one
/// instruction set each, and by nothing else.
namespace camlaw::span_loops {

template <int Width>
constexpr SpanKernels kernels(const char* instruction_set) {
  using V = typename lanes::Vector<Width>::Type;
  return {instruction_set, Width, motion<V>, motion_by_rows<V>};
}

}  // namespace camlaw::span_loops
