// SPDX-License-Identifier: MIT
#include "machines/model/joint_angle.h"

#include <algorithm>
#include <cmath>

#include "machines/model/arguments.h"

namespace camlaw::problems {
namespace {

/// Where a piece of a law ends, counted along the cycle, by the law's variables.
class JointAngle final : public optim::Kernel {
 public:
  JointAngle(std::shared_ptr<const LawBinding> law, std::size_t piece, const Stretch& stretch)
      : law_(std::move(law)), piece_(piece), stretch_(stretch) {}

  double value(std::span<const double> u) const override { return at(end(u, 0).value[0]); }
  double gradient(std::span<const double> u, std::span<double> g) const override {
    const MotionDerivatives x = end(u, 1);
    fill(x.gradient, g);
    return at(x.value[0]);
  }
  double hessian(std::span<const double> u, std::span<double> g,
                 std::span<double> h) const override {
    const MotionDerivatives x = end(u, 2);
    fill(x.gradient, g);
    fill(x.hessian, h);
    return at(x.value[0]);
  }

 private:
  MotionDerivatives end(std::span<const double> u, int order) const {
    return law_->end_place({piece_, true}, u, order);
  }
  double at(double x) const { return stretch_.begin + stretch_.length() * x; }
  void fill(const std::vector<std::array<double, 4>>& of_law, std::span<double> all) const {
    std::fill(all.begin(), all.end(), 0.0);
    for (std::size_t i = 0; i < of_law.size(); ++i) all[i] = stretch_.length() * of_law[i][0];
  }

  std::shared_ptr<const LawBinding> law_;
  std::size_t piece_;
  Stretch stretch_;
};

/// A number that no variable moves.
class StillAngle final : public optim::Kernel {
 public:
  explicit StillAngle(double angle) : angle_(angle) {}
  double value(std::span<const double>) const override { return angle_; }
  double gradient(std::span<const double>, std::span<double>) const override { return angle_; }
  double hessian(std::span<const double>, std::span<double>, std::span<double>) const override {
    return angle_;
  }

 private:
  double angle_;
};

}  // namespace

std::optional<std::size_t> joint_at(const Law<double>& law, double x) {
  // Angles turned into x differ in the last places of the law's length (at_break).
  constexpr double kBeside = 1e-14;
  std::optional<std::size_t> joint;
  for (std::size_t i = 0; i + 1 < law.pieces().size(); ++i) {
    if (std::abs(x - law.pieces()[i].end) <= kBeside) joint = i;
  }
  return joint;
}

optim::Function joint_angle_of(std::shared_ptr<const LawBinding> law, std::size_t piece,
                               const Stretch& stretch) {
  std::vector<std::size_t> variables;
  for (const LawVariable& v : law->variables()) variables.push_back(v.variable);
  return function_of(variables, std::make_shared<JointAngle>(std::move(law), piece, stretch),
                     optim::Shape::General);
}

optim::Function still_angle(double angle) { return {{}, std::make_shared<StillAngle>(angle)}; }

}  // namespace camlaw::problems
