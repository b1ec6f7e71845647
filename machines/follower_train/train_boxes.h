// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>

#include "machines/follower_train/train_curve.h"
#include "machines/follower_train/turn_harmonics.h"
#include "machines/model/recorded_kernel.h"

/// Bounds of what an elastic train does in its steady state over boxes of its machine's parameters
/// (docs/theory.md, "Over a box of parameters").
namespace camlaw::problems {

/// A quantity over a stretch: f and f' in its middle, f'' all over it, by x.
struct TrainExpansion {
  Interval value, slope, second;
  double radius;

  Interval range() const;
};

/// A trace that knows such of one train.
class ExpandsTrain {
 public:
  virtual ~ExpandsTrain() = default;
  /// None where there is no motion.
  virtual std::optional<TrainExpansion> expansion(double from, double to) const = 0;
};

/// What kTrainParts, or the first of them, are along a range of their machine, as series over a box
/// of the ranges. Ranges are the variables of a binding from `first` on.
class PartsOverBox {
 public:
  PartsOverBox(const std::vector<Recorded>& parts, const Binding& binding, std::size_t first,
               optim::Design x)
      : parts_(parts), binding_(binding), first_(first), x_(x.begin(), x.end()) {}

  std::vector<Series<Interval, 3>> along(const Box& box, std::size_t range) const;
  /// The first two at all places of the box: tau and zeta.
  FollowerTrain<Interval> train(const Box& box) const;

 private:
  const std::vector<Recorded>& parts_;
  const Binding& binding_;
  std::size_t first_;
  std::vector<double> x_;
};

/// Sides of a box that are looked at, at most: it has twice as many corners for each.
inline constexpr std::size_t kMostSides = 5;

/// (U17) How far a function may lie above the highest of its values at the corners of a box, or
/// below the lowest, from bounds of its second derivatives along the sides.
double off_corners(const Box& box, const std::vector<double>& bends);

/// Of a curve of the train over a turn of its cam.
std::unique_ptr<OverBoxes> train_over_boxes(TrainQuantity which, PartsOverBox parts, double factor,
                                            std::shared_ptr<const TurnHarmonics> harmonics,
                                            BoundedOverBoxes::TraceAt at);

}  // namespace camlaw::problems
