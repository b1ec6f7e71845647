// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "machines/model/highest_kernel.h"

/// The highest value of a curve over ranges of parameters, at each place: a curve again.
namespace camlaw::problems {

struct RangeParts;

class RangeCurve final : public optim::Curve {
 public:
  explicit RangeCurve(RangeParts parts);

  optim::Function at(optim::Place place) const override;
  /// As long as the worst place in the ranges stays.
  std::vector<double> slope_gradient(optim::Place place, optim::Design x) const override;
  bool breaks_move() const override;
  optim::Place tied(optim::Place place, optim::Design x) const override;
  std::unique_ptr<optim::Trace> trace(optim::Design x) const override;
  optim::Shape shape() const override { return optim::Shape::General; }
  double memory() const override;

  /// Where in the ranges it is, as told() says it.
  Point worst(optim::Place place, optim::Design x) const;
  /// The part of the ranges that its bounds over a stretch leave open (Highest::left).
  Box left(double from, double to, optim::Design x) const;

 private:
  std::shared_ptr<const RangeParts> parts_;
};

/// The curve over the ranges for a binding in which they do not vary; `sign` is below 0 for the
/// lowest value. Nothing is proved of a curve that bounded_over_boxes knows nothing of, nor where
/// some machine of the ranges may be impossible.
std::shared_ptr<const RangeCurve> range_curve(const MechanismResponse& response,
                                              const std::vector<TakenRange>& ranges, double sign,
                                              const Binding& binding);

}  // namespace camlaw::problems
