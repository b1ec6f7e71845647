// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "machines/model/cycle.h"
#include "machines/model/highest_kernel.h"
#include "machines/model/recorded_kernel.h"

/// Bounds of a mechanism's curve over a stretch of its cycle and a box of parameters at once.
namespace camlaw::problems {

/// Bounds of a curve over stretches of its cycle and boxes of the ranges, for one design.
class OverBoxes {
 public:
  virtual ~OverBoxes() = default;
  /// Of sign * curve; from and to as of Trace::enclose.
  virtual OverBox over(const Box& box, double from, double to, double sign) = 0;
};

/// What bounds a curve so.
class BoundedOverBoxes {
 public:
  virtual ~BoundedOverBoxes() = default;
  /// The curve's trace at a place in the ranges.
  using TraceAt = std::function<const optim::Trace&(const Point&)>;
  /// None where nothing is known. `wide` and `at` outlive what is returned.
  virtual std::unique_ptr<OverBoxes> over_boxes(const Widened& wide, optim::Design x,
                                                TraceAt at) const = 0;
};

/// That of a curve that is a formula of the machine and its motion, or that knows its own bounds;
/// null for others. `curve` is the response for the widened binding.
std::shared_ptr<const BoundedOverBoxes> bounded_over_boxes(
    const MechanismResponse& response, const std::shared_ptr<const optim::Curve>& curve,
    const Widened& wide);

/// What a curve's formula needs to be bounded over a box of its arguments.
struct CurveRecord {
  Recorded record;
  std::optional<Formula> domain;
  Cycle cycle;
  std::array<bool, 4> uses;                     ///< which of s, v, a, j
  std::shared_ptr<const optim::Kernel> kernel;  ///< of the record
};

/// None where the curve is not a formula that a law or a program drives.
std::optional<CurveRecord> curve_record(const MechanismResponse& response, const Binding& binding);

/// A curve's value and slopes over a box of the ranges, for one design.
class BoxTraces {
 public:
  BoxTraces(const CurveRecord& curve, const Widened& wide, optim::Design x, const Box& box);

  OverBox over(double from, double to, double sign) const;
  /// The value; it is asked for bounds alone.
  const optim::Trace& value() const { return *value_; }

 private:
  std::unique_ptr<optim::Trace> value_;
  std::vector<std::unique_ptr<optim::Trace>> slopes_;
};

}  // namespace camlaw::problems
