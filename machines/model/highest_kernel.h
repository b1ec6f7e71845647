// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "machines/model/highest_in_box.h"
#include "machines/model/recent.h"
#include "machines/model/widened.h"

/// The highest value that a function of a design has over ranges of parameters, as a function of
/// the design (docs/theory.md, "Ranges of parameters").
namespace camlaw::problems {

/// The bounds of sign * f, from those of f.
optim::Bounds times(double sign, const optim::Bounds& bounds);

/// The highest value of sign * f over the ranges, times the sign; f is a function over a widened
/// design. At the place where it is highest its derivatives by the design are those of f; where
/// that place lies within a range, the second ones change as it moves (theory: RG2).
class HighestKernel final : public optim::Kernel {
 public:
  HighestKernel(optim::Function f, std::shared_ptr<const Widened> wide, double sign);

  /// The design's own inputs of f, and the variables that ranges of f move with.
  const std::vector<std::size_t>& own_inputs() const { return own_.variables; }

  double value(std::span<const double> u) const override;
  double gradient(std::span<const double> u, std::span<double> g) const override;
  double hessian(std::span<const double> u, std::span<double> g,
                 std::span<double> h) const override;
  optim::Bounds enclose(std::span<const double> u) const override;
  optim::BoxRange range(std::span<const optim::Bounds> box) const override;
  bool is_enclosed() const override { return f_.is_enclosed(); }
  bool is_searched() const override { return true; }
  /// With the place that the proof comes upon besides: a search from a grid may miss it.
  std::shared_ptr<const optim::Kernel> proved() const override;
  HighestKernel asking_proof() const;
  /// That looks closely along each range by itself as well, for what may have tops narrower than
  /// the grid of places_of, such as resonances.
  HighestKernel looking_along_ranges() const;
  /// For the one design at which this is known of the machines of its ranges.
  HighestKernel knowing(std::shared_ptr<const MachinesOfBox> machines) const;
  std::string why_undefined(std::span<const double> u) const override;

  /// The place in the ranges; where a value is not a number, or a machine impossible, such a place.
  Point worst(std::span<const double> u) const;
  /// The part of the ranges that its bounds leave open (Highest::left).
  Box left(std::span<const double> u) const;
  /// From some of these places to the highest value nearby; `value` is that at a place, to be made
  /// highest.
  Point climbed_highest(const std::vector<Point>& places,
                        const std::function<double(const Point&)>& value,
                        std::span<const double> u) const;
  /// The value at the worst place, not a number beside a pole.
  double settled(std::span<const double> u, const Point& p, double value) const;

 private:
  /// What the search from a grid comes to.
  Point searched(std::span<const double> u) const;
  /// From a place in the ranges to the highest value nearby.
  Point climb(const Point& from, std::span<const double> u) const;
  Highest highest_over(std::span<const optim::Bounds> box) const;
  std::vector<double> design(std::span<const double> u, const Point& p) const;
  /// A place in the ranges that makes no machine, if one was met; else empty.
  Point impossible_place(std::span<const double> u) const;
  /// Without the ranges.
  std::vector<double> own_design(std::span<const double> u) const;
  /// The value at a place, turned so that the highest is sought, and its slopes by the ranges.
  double uphill(const Point& p, std::span<const double> u, Point& slopes) const;
  Box box_at(std::span<const double> u) const;
  /// That of all designs of a box.
  Box box_over(std::span<const optim::Bounds> u) const;
  /// Whether the box is a design at which some machine of the ranges may be impossible: then the
  /// bounds of the others bound nothing.
  bool may_be_impossible(std::span<const optim::Bounds> u) const;
  /// Whether the ranges move within a box of designs.
  bool moves(std::span<const optim::Bounds> u) const;
  double largest_lower(std::span<const optim::Bounds> u) const;
  std::vector<optim::Bounds> widened_box(std::span<const optim::Bounds> u, const Box& ranges) const;
  /// Whether the function has no bound close to a place in the ranges: then what was found there is
  /// no highest value, however large, but the flank of a pole.
  bool is_beside_pole(std::span<const double> u, const Point& p) const;

  optim::Function f_;
  std::shared_ptr<const Widened> wide_;
  double sign_;
  OwnInputs own_;
  bool asks_proof_ = false;
  bool looks_along_ = false;
  std::shared_ptr<const MachinesOfBox> machines_;
  /// What was searched: value, slopes and bends are asked for at one design after the other.
  std::shared_ptr<Recent<Point>> recent_ = std::make_shared<Recent<Point>>();
};

/// That of a function over a widened design, as a function of the design.
optim::Function highest_of(const optim::Function& f, std::shared_ptr<const Widened> wide,
                           double sign);

/// A kernel as a function of the design.
optim::Function function_of_highest(HighestKernel kernel);

}  // namespace camlaw::problems
