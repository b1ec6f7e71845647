// SPDX-License-Identifier: MIT
#include "optim/verdict/kinks.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "optim/cycle/joined_curve.h"
#include "optim/problem/starts.h"

namespace camlaw::optim {
namespace {

constexpr double kNearBound = 1e-4;   // of a size: as far as limits are taken for active
constexpr double kBesideKink = 1e-5;  // of typical changes: where slopes are looked at

/// A smooth piece of a function, continued from beside a kink by a Taylor polynomial of second
/// order about u + shift; its input k is the design's variable inputs[k].
class PieceKernel final : public Kernel {
 public:
  PieceKernel(Function f, std::vector<double> shift) : f_(std::move(f)), shift_(std::move(shift)) {}

  double value(std::span<const double> u) const override {
    std::vector<double> g(u.size());
    return gradient(u, g);
  }
  double gradient(std::span<const double> u, std::span<double> g) const override {
    std::vector<double> h(packed_size(u.size()));
    return hessian(u, g, h);
  }
  double hessian(std::span<const double> u, std::span<double> g,
                 std::span<double> h) const override {
    double value = f_.hessian(beside(u), g, h);
    for (std::size_t i = 0; i < g.size(); ++i) {
      double bend = 0;
      for (std::size_t k = 0; k < g.size(); ++k) {
        bend += h[packed(std::max(i, k), std::min(i, k))] * shift_[k];
      }
      value -= (g[i] - 0.5 * bend) * shift_[i];
      g[i] -= bend;
    }
    return value;
  }

 private:
  std::vector<double> beside(std::span<const double> u) const {
    const auto& inputs = f_.inputs();
    std::vector<double> x(inputs.empty() ? 0 : inputs.back() + 1);
    for (std::size_t k = 0; k < inputs.size(); ++k) x[inputs[k]] = u[k] + shift_[k];
    return x;
  }

  Function f_;
  std::vector<double> shift_;
};

/// Designs close about one, within the bounds, that differ in a function's inputs.
std::vector<std::vector<double>> designs_beside(const Problem& problem, const Function& f,
                                                const Scales& scales, Design x) {
  // The design and 63 others at random miss a tenth of the box once in 760 times.
  constexpr int kDrawn = 64;
  Problem box;
  for (const std::size_t input : f.inputs()) {
    const Variable& v = problem.variables[input];
    const double reach = kBesideKink * scales.variables[input];
    box.variables.push_back({.name = v.name,
                             .lower = std::max(v.lower, x[input] - reach),
                             .upper = std::min(v.upper, x[input] + reach),
                             .start = x[input]});
  }
  std::vector<std::vector<double>> result;
  for (const std::vector<double>& drawn : starts(box, kDrawn, 1)) {
    std::vector<double> y(x.begin(), x.end());
    for (std::size_t k = 0; k < drawn.size(); ++k) y[f.inputs()[k]] = drawn[k];
    result.push_back(std::move(y));
  }
  result.erase(result.begin());  // the design itself
  return result;
}

/// Slopes of a function at designs beside one, by typical changes.
class Beside {
 public:
  Beside(const Problem& problem, const Function& f, const Scales& scales, Design x)
      : f_(f), scales_(scales), x_(x.begin(), x.end()) {
    // Of a smooth number, which may take long to work out, a few tell.
    constexpr std::size_t kFew = 12;
    std::size_t count = 0;
    for (std::vector<double>& y : designs_beside(problem, f, scales, x)) {
      if (count++ == kFew && pieces_.size() < 2) return;
      look_at(std::move(y));
    }
  }

  /// Of slopes that are others at most of the designs, as beside a pole, nothing is a piece.
  bool has_kink() const { return pieces_.size() > 1 && pieces_.size() <= kMost; }

  /// The pieces; empty where sign * f is not the highest of them at each of the designs.
  std::vector<Function> pieces(double sign) const {
    constexpr double kSame = 1e-3;  // of what a kink changes over the way to the designs
    if (!has_kink()) return {};
    const Shape shape = f_.shape();
    std::vector<Function> result;
    for (const std::size_t i : pieces_) {
      result.emplace_back(f_.inputs(), std::make_shared<PieceKernel>(f_, way_to(i)),
                          is_convex(shape) || is_concave(shape) ? shape : Shape::General);
    }
    for (const Look& look : looks_) {
      double highest = -kInfinity;
      for (const Function& piece : result) {
        highest = std::max(highest, sign * piece.value(look.y));
      }
      const double room = kSame * kJump * steepest_ * kBesideKink;
      if (!(std::abs(highest - sign * look.value) <= room)) return {};
    }
    return result;
  }

 private:
  static constexpr std::size_t kMost = 32;  // half of the designs that are looked at
  static constexpr double kJump = 1e-2;     // of the steepest slope: smooth ones change by less

  struct Look {
    std::vector<double> y;
    double value;
    std::vector<double> slopes;
  };

  void look_at(std::vector<double> y) {
    std::vector<double> slopes(f_.inputs().size());
    const double value = f_.gradient(y, slopes);
    for (std::size_t k = 0; k < slopes.size(); ++k) {
      slopes[k] *= scales_.variables[f_.inputs()[k]];
      steepest_ = std::max(steepest_, std::abs(slopes[k]));
    }
    if (!std::isfinite(value)) return;
    looks_.push_back({std::move(y), value, std::move(slopes)});
    const bool is_known = std::any_of(pieces_.begin(), pieces_.end(), [&](std::size_t other) {
      return are_alike(looks_.back().slopes, looks_[other].slopes);
    });
    if (!is_known) pieces_.push_back(looks_.size() - 1);
  }

  bool are_alike(const std::vector<double>& a, const std::vector<double>& b) const {
    return std::equal(a.begin(), a.end(), b.begin(), [&](double one, double other) {
      return std::abs(one - other) <= kJump * steepest_;
    });
  }

  std::vector<double> way_to(std::size_t i) const {
    std::vector<double> way;
    for (const std::size_t input : f_.inputs()) way.push_back(looks_[i].y[input] - x_[input]);
    return way;
  }

  const Function& f_;
  const Scales& scales_;
  std::vector<double> x_;
  std::vector<Look> looks_;
  std::vector<std::size_t> pieces_;  ///< a look at each
  double steepest_ = 0;
};

/// Below 0 where the lower bound is the nearer one, or the one passed by more; 0 where neither is
/// near.
double near_side(const Constraint& c, const ConstraintScale& own, double value) {
  const double reach = std::max(kNearBound * own.scale, 2 * own.tolerance);
  const double above = c.upper ? *c.upper - value : kInfinity;
  const double below = c.lower ? value - *c.lower : kInfinity;
  if (!(std::min(above, below) <= reach)) return 0;
  return above <= below ? 1 : -1;
}

/// The pieces of a number behind one another as a curve; none where there are not several.
std::shared_ptr<const Curve> pieces_apart(const Problem& problem, const Response& response,
                                          const Scales& scales, Design x, double sign) {
  std::vector<Response> parts;
  for (Function& piece : Beside(problem, response.function(), scales, x).pieces(sign)) {
    parts.push_back({response.name, response.unit, std::move(piece)});
  }
  if (parts.empty()) return nullptr;
  return joined_curve(std::move(parts), 2, x.size());
}

}  // namespace

std::optional<Problem> with_pieces_apart(const Problem& problem, const Scales& scales, Design x) {
  constexpr std::size_t kMany = 30;  // variables
  if (problem.variables.size() > kMany) return {};
  Problem apart = problem;
  bool has_kink = false;
  Objective& objective = apart.objectives.front();
  if (!objective.response.is_curve()) {
    const bool least = objective.sense == Sense::Minimize;
    if (auto curve = pieces_apart(problem, objective.response, scales, x, least ? 1 : -1)) {
      objective.response.measure = std::move(curve);
      objective.part = least ? Part::Highest : Part::Lowest;
      has_kink = true;
    }
  }
  for (std::size_t i = 0; i < apart.constraints.size(); ++i) {
    Constraint& c = apart.constraints[i];
    if (c.response.is_curve() || c.is_equation()) continue;
    const double value = c.response.function().value(x);
    const double side = near_side(c, scales.constraints[i], value);
    if (side == 0) continue;
    auto curve = pieces_apart(problem, c.response, scales, x, side);
    if (!curve) continue;
    c.response.measure = std::move(curve);
    (side > 0 ? c.lower : c.upper).reset();
    has_kink = true;
  }
  return has_kink ? std::optional(std::move(apart)) : std::nullopt;
}

std::string kinked_name(const Problem& problem, const Scales& scales, Design x) {
  const auto is_kinked = [&](const Response& response) {
    if (response.is_curve()) return false;
    const Beside beside(problem, response.function(), scales, x);
    return !beside.pieces(1).empty() || !beside.pieces(-1).empty();
  };
  if (is_kinked(problem.objective().response)) return problem.objective().response.name;
  for (std::size_t i = 0; i < problem.constraints.size(); ++i) {
    const Constraint& c = problem.constraints[i];
    if (c.response.is_curve()) continue;
    const double value = c.response.function().value(x);
    if (near_side(c, scales.constraints[i], value) != 0 && is_kinked(c.response)) {
      return c.response.name;
    }
  }
  return {};
}

}  // namespace camlaw::optim
