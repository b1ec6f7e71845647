// SPDX-License-Identifier: MIT
#include "machines/cams/arm_clearance.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

#include "machines/cams/arm_sight.h"
#include "machines/model/inner_numbers.h"
#include "machines/model/kernel_of.h"
#include "numerics/linear/dense.h"

namespace camlaw::problems {
namespace {

using arm::ArmGap, arm::BreakPlace, arm::held_place, arm::kNumbers, arm::Meeting, arm::PointTrace,
    arm::Sight, arm::whole_turn;
using optim::Bounds, optim::Curve, optim::Function, optim::Place;
using optim::packed, optim::packed_size;
using enum arm::Of;

/// Second derivatives by the two angles. A place moves in the directions in which the clearance
/// bends; where it is level, as while both rest, it may stay.
class Level {
 public:
  explicit Level(const Eigen::Matrix2d& bends) : eigen_(optim::symmetric_eigen(bends)) {}

  Eigen::Vector2d solved(const Eigen::Vector2d& right) const {
    Eigen::Vector2d result = Eigen::Vector2d::Zero();
    for (Eigen::Index k = 0; k < 2; ++k) {
      const double bend = eigen_.values[k];
      const auto way = eigen_.vectors.col(k);
      if (bend > 1e-9 * eigen_.values[1]) result += way * (way.dot(right) / bend);
    }
    return result;
  }

 private:
  optim::SymmetricEigen eigen_;
};

class ClearanceKernel final : public optim::Kernel {
 public:
  ClearanceKernel(const ArmAndProfile& of, const Binding& binding)
      : beside_(detail::kernel_of(ArmGap{of.turn, false})),
        through_(detail::kernel_of(ArmGap{of.turn, true})),
        turn_(of.turn) {
    const MechanismResponse* const seen[] = {&of.contact_x, &of.contact_y, &of.centre_x,
                                             &of.centre_y};
    for (std::size_t k = 0; k < curves_.size(); ++k) {
      curves_[k] = seen[k]->curve(binding, optim::Shape::General);
    }
    const auto& varying = binding.parameters;
    const auto at = std::find(varying.begin(), varying.end(), of.pivot_distance);
    pivot_ = binding.constants[of.pivot_distance];
    if (at != varying.end()) {
      pivot_variable_ = binding.variables[static_cast<std::size_t>(at - varying.begin())];
    }
  }

  double value(std::span<const double> u) const override { return sight(u).least().gap; }
  double gradient(std::span<const double> u, std::span<double> g) const override {
    std::vector<double> unused(packed_size(u.size()));
    return hessian(u, g, unused);
  }
  /// The places move with the design, as that of a peak does: f_uu - f_uq f_qq^-1 f_qu.
  double hessian(std::span<const double> u, std::span<double> g,
                 std::span<double> h) const override;
  bool is_searched() const override { return true; }
  Bounds enclose(std::span<const double> u) const override {
    constexpr double kShare = 2e-3, kLeast = 1e-3;  // of the clearance; mm
    const Sight here = sight(u);
    const double found = here.least().gap;
    if (std::isnan(found)) return {};
    const double enough = std::max(kLeast, kShare * found);
    if (found <= enough) return {-optim::kInfinity, found};  // how deep it is no part tells
    return {here.proved(found, enough), found * (1 + 1e-12)};
  }

 private:
  /// By the design, then by the angles of the arm and of the point touched.
  struct Derivatives {
    Eigen::VectorXd first;
    Eigen::MatrixXd second;
  };
  using Places = std::array<BreakPlace, 2>;  // of the arm and of the point touched
  Derivatives derived(std::span<const double> u, const Places& at, bool is_through) const;

  double pivot(std::span<const double> u) const {
    return pivot_variable_ ? u[*pivot_variable_] : pivot_;
  }
  Sight sight(std::span<const double> u) const {
    return {PointTrace(curves_[ContactX]->trace(u), curves_[ContactY]->trace(u)),
            PointTrace(curves_[CentreX]->trace(u), curves_[CentreY]->trace(u)), pivot(u), turn_};
  }

  std::array<std::shared_ptr<const Curve>, 4> curves_;
  std::shared_ptr<const optim::Kernel> beside_, through_;
  double turn_;
  double pivot_ = 0;
  std::optional<std::size_t> pivot_variable_;
};

ClearanceKernel::Derivatives ClearanceKernel::derived(std::span<const double> u, const Places& at,
                                                      bool is_through) const {
  const auto n = static_cast<Eigen::Index>(u.size());
  Eigen::MatrixXd slopes = Eigen::MatrixXd::Zero(kNumbers, n + 2);
  std::array<Eigen::MatrixXd, 4> bends;
  std::array<double, kNumbers> z{0, 0, 0, 0, pivot(u), at[0].place.angle, at[1].place.angle};
  for (std::size_t k = 0; k < curves_.size(); ++k) {
    const bool touched = k < CentreX;
    const Eigen::Index own = n + (touched ? 1 : 0), row = static_cast<Eigen::Index>(k);
    const Place place = at[touched ? 1 : 0].place;
    const std::array<double, 3> along = curves_[k]->trace(u)->at(place);
    const Function f = curves_[k]->at(curves_[k]->tied(place, u));
    const std::vector<std::size_t>& inputs = f.inputs();
    std::vector<double> slope(inputs.size()), second(packed_size(inputs.size()));
    f.hessian(u, slope, second);
    const std::vector<double> moved = curves_[k]->slope_gradient(place, u);
    Eigen::MatrixXd& bend = bends[k] = Eigen::MatrixXd::Zero(n + 2, n + 2);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      const auto a = static_cast<Eigen::Index>(inputs[i]);
      slopes(row, a) = slope[i];
      for (std::size_t j = 0; j <= i; ++j) {
        const auto b = static_cast<Eigen::Index>(inputs[j]);
        bend(a, b) = bend(b, a) = second[packed(i, j)];
      }
    }
    for (Eigen::Index i = 0; i < n; ++i) {
      bend(i, own) = bend(own, i) =
          moved.empty() ? std::nan("") : moved[static_cast<std::size_t>(i)];
    }
    slopes(row, own) = along[1];
    bend(own, own) = along[2];
    z[k] = along[0];
  }
  if (pivot_variable_) slopes(Pivot, static_cast<Eigen::Index>(*pivot_variable_)) = 1;
  slopes(ArmAt, n) = 1;
  slopes(TouchedAt, n + 1) = 1;
  std::vector<double> own(kNumbers), second(packed_size(kNumbers));
  (is_through ? through_ : beside_)->hessian(z, own, second);
  Eigen::MatrixXd outer(kNumbers, kNumbers);
  for (std::size_t i = 0; i < kNumbers; ++i) {
    for (std::size_t k = 0; k < kNumbers; ++k) {
      outer(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) =
          second[packed(std::max(i, k), std::min(i, k))];
    }
  }
  Derivatives result;
  result.second = slopes.transpose() * outer * slopes;
  for (std::size_t k = 0; k < curves_.size(); ++k) result.second += own[k] * bends[k];
  result.first = slopes.transpose() * Eigen::Map<const Eigen::VectorXd>(own.data(), kNumbers);
  return result;
}

double ClearanceKernel::hessian(std::span<const double> u, std::span<double> g,
                                std::span<double> h) const {
  constexpr int kSteps = 3;       // from the 1e-8 deg of the search one step reaches rounding
  constexpr double kNear = 1e-2;  // deg: farther no step of Newton's is meant to lead
  const auto n = static_cast<Eigen::Index>(u.size());
  const Meeting found = sight(u).least();
  if (std::isnan(found.gap)) {
    std::fill(g.begin(), g.end(), found.gap);
    std::fill(h.begin(), h.end(), found.gap);
    return found.gap;
  }
  Places at{held_place(found.arm_at, curves_[CentreX]->trace(u)->breaks()),
            held_place(found.touched_at, curves_[ContactX]->trace(u)->breaks())};
  const auto level = [&](const Derivatives& d) {
    Eigen::Matrix2d bends = d.second.bottomRightCorner<2, 2>();
    for (Eigen::Index k = 0; k < 2; ++k) {
      if (!at[static_cast<std::size_t>(k)].is_held) continue;
      bends.row(k).setZero();
      bends.col(k).setZero();
    }
    return Level(bends);
  };
  Derivatives d = derived(u, at, found.is_through);
  for (int step = 0; step < kSteps; ++step) {
    const Eigen::Vector2d by = level(d).solved(d.first.tail<2>());
    if (!(by.norm() < kNear)) break;
    for (std::size_t k = 0; k < 2; ++k) {
      Place& place = at[k].place;
      if (!at[k].is_held) place.angle = whole_turn(place.angle - by[static_cast<Eigen::Index>(k)]);
    }
    d = derived(u, at, found.is_through);
  }
  const Level places = level(d);
  Eigen::MatrixXd reduced = d.second.topLeftCorner(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Vector2d moved = places.solved(d.second.row(i).tail<2>().transpose());
    reduced.row(i) -= (d.second.topRightCorner(n, 2) * moved).transpose();
  }
  for (std::size_t i = 0; i < u.size(); ++i) {
    const auto a = static_cast<Eigen::Index>(i);
    g[i] = d.first[a];
    for (std::size_t k = 0; k <= i; ++k) {
      h[packed(i, k)] = reduced(a, static_cast<Eigen::Index>(k));
    }
  }
  return found.gap;
}

}  // namespace

MechanismResponse arm_clearance(MechanismResponse response, ArmAndProfile of) {
  response.sees_law = true;
  response.uses = united({{of.pivot_distance},
                          of.contact_x.uses,
                          of.contact_y.uses,
                          of.centre_x.uses,
                          of.centre_y.uses});
  response.number = [of](const Binding& binding, optim::Shape shape) {
    std::vector<std::size_t> all(design_size(binding));
    std::iota(all.begin(), all.end(), std::size_t{0});
    return Function(std::move(all), std::make_shared<ClearanceKernel>(of, binding), shape);
  };
  return response;
}

}  // namespace camlaw::problems
