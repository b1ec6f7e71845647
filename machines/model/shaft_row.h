// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "machines/model/shaft_curve.h"

namespace camlaw::problems {

/// A shaft's curve at one place, in the design variables inputs(). Derivatives follow by the chain
/// rule (docs/theory.md, SH2): a cam whose phase grows falls behind, so its
/// curve changes by that phase as it does by the angle, with the other sign.
class ShaftRow final : public optim::Kernel {
 public:
  /// With `by_angle` slope_gradient() is known, and a place that is tied is not taken.
  ShaftRow(std::shared_ptr<const ShaftParts> parts, optim::Place place, bool by_angle = false);

  const std::vector<std::size_t>& inputs() const { return inputs_; }

  double value(std::span<const double> u) const override;
  double gradient(std::span<const double> u, std::span<double> g) const override;
  double hessian(std::span<const double> u, std::span<double> g,
                 std::span<double> h) const override;
  /// Where no phase varies; there the place stays, and each cam's.
  optim::BoxRange range(std::span<const optim::Bounds> box) const override;
  /// The derivatives by the inputs of the derivative by the shaft's angle, deg.
  std::vector<double> slope_gradient(std::span<const double> u) const;

 private:
  /// What the formula takes, and its derivatives by the inputs and, last, by the shaft's angle.
  struct Point {
    std::vector<double> value;
    std::vector<std::vector<double>> gradient, hessian;
  };
  /// How a place moves with the inputs.
  struct Moves {
    std::vector<double> slope, bend;
  };
  /// A break that moves on the shaft: the cam's own joint, where it moves on the cam, and its angle
  /// on the cam.
  struct Tied {
    std::size_t cam;
    int joint;
    optim::Function angle;
  };
  static std::optional<Tied> tied_by(const ShaftParts& parts, optim::Place place);
  /// The shaft's angle, how it moves, and the place on the cam whose break it is tied to.
  struct Turned {
    double angle;
    std::vector<double> slope, bend;
    optim::Place on_cam = {};
  };
  Turned turned(optim::Design x, const ShaftParts::Traces& traces, int order) const;
  void spread(const optim::Function& f, const std::vector<double>& g, const std::vector<double>& h,
              std::vector<double>& first, std::vector<double>& second) const;
  Point point(std::span<const double> u, int order) const;
  void add_curve(std::size_t k, optim::Design x, optim::Place place, const Moves& moves,
                 const ShaftParts::Traces* traces, int order, Point& point) const;
  double chained(const Point& point, std::span<double> g, std::span<double> h) const;
  std::vector<double> design_at(std::span<const double> u) const;
  std::size_t input_of(std::size_t variable) const;

  std::shared_ptr<const ShaftParts> parts_;
  optim::Place place_;
  bool by_angle_;
  std::optional<Tied> tied_;
  bool moves_;  ///< whether a cam's place may move, with the design or the angle
  std::vector<optim::Function> still_;  ///< the cams' curves, where none does
  std::vector<std::size_t> inputs_;
};

}  // namespace camlaw::problems
