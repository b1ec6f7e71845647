// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "kinematics/law.h"
#include "machines/model/cycle.h"
#include "machines/model/mechanism.h"
#include "numerics/formula/formula.h"

/// How somebody who made a table has found the peaks of its curves.
namespace camlaw::problems {

struct Readout {
  enum class Kind : char {
    Exact,
    Grid,        ///< the largest of even places
    InnerGrid,   ///< the same, without the ends of each stretch
    Differences  ///< the same, v, a and j by central differences of s between these places
  };
  Kind kind = Kind::Exact;
  int steps = 0;  ///< of each stretch of the cycle, of a program of each segment
};

/// Reads "exact", "grid of 20 steps", "grid of 20 steps without its ends", "differences on 20
/// steps". Throws std::invalid_argument.
Readout read_readout(std::string_view text);

/// A curve of the follower's motion as its formula has it: of all parameters, in listed units, then
/// s, v, a, j and x.
struct SampledCurve {
  Formula formula;
  Cycle cycle;
};

/// Its part as it is read off, in steps between `ends`: of the law's x, where its parts end, from 0
/// to 1. Beyond the ends of a stretch the differences take the motion as it goes on: mirrored where
/// the follower returns, turn after turn where the cycle is one, at rest otherwise. NaN where the
/// curve has no value at one of the places.
double read_off(const SampledCurve& curve, std::span<const double> constants,
                const Law<double>& law, std::span<const double> ends, optim::Part part,
                Readout readout);

}  // namespace camlaw::problems
