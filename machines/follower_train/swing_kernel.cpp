// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "machines/follower_train/train_boxes.h"
#include "machines/model/law_formula.h"
#include "machines/model/recent.h"

namespace camlaw::problems {
namespace {

using optim::Bounds;

/// The amplitude in a dwell, and its bounds over boxes of the machine (U18).
class SwingKernel final : public optim::Kernel {
 public:
  SwingKernel(std::shared_ptr<const optim::Kernel> plain, const Binding& binding,
              std::vector<Recorded> parts, const UnitFactor& factor)
      : plain_(std::move(plain)),
        law_(binding.law),
        parts_(std::move(parts)),
        factor_(factor.as<double>()) {
    for (std::size_t k = 0; k < binding.parameters.size(); ++k) machine_.variables.push_back(k);
  }

  double value(std::span<const double> u) const override { return plain_->value(u); }
  double gradient(std::span<const double> u, std::span<double> g) const override {
    return plain_->gradient(u, g);
  }
  double hessian(std::span<const double> u, std::span<double> g,
                 std::span<double> h) const override {
    return plain_->hessian(u, g, h);
  }
  Bounds enclose(std::span<const double> u) const override { return plain_->enclose(u); }
  bool is_enclosed() const override { return plain_->is_enclosed(); }

  optim::BoxRange range(std::span<const Bounds> box) const override {
    optim::BoxRange result{{}, std::vector<Bounds>(box.size())};
    const std::size_t count = machine_.variables.size();
    const Box machine(box.begin(), box.begin() + static_cast<std::ptrdiff_t>(count));
    std::vector<double> u;
    for (const Bounds& b : box) u.push_back(b.lower);
    std::vector<std::size_t> sides;
    for (std::size_t i = 0; i < box.size(); ++i) {
      if (box[i].lower == box[i].upper) continue;
      if (i >= count || sides.size() == kMostSides) return result;
      sides.push_back(i);
    }
    Bounds ends{optim::kInfinity, -optim::kInfinity};
    for (std::size_t mask = 0; mask < std::size_t{1} << sides.size(); ++mask) {
      for (std::size_t k = 0; k < sides.size(); ++k) {
        u[sides[k]] = mask >> k & 1 ? box[sides[k]].upper : box[sides[k]].lower;
      }
      const Bounds here = plain_->enclose(u);
      if (!(here.lower <= here.upper)) return result;
      ends = {std::min(ends.lower, here.lower), std::max(ends.upper, here.upper)};
    }
    if (sides.empty()) {
      result.value = ends;
      return result;
    }
    const double off = off_over(machine, std::span(u).subspan(count));
    result.value = {0, step_up(ends.upper + off)};
    return result;
  }

 private:
  /// How far the amplitude may lie above that at the corners.
  double off_over(const Box& machine, std::span<const double> of_law) const {
    const auto harmonics = recent_.get(of_law, [&]() -> std::unique_ptr<const TurnHarmonics> {
      const std::vector<Interval> exact(of_law.begin(), of_law.end());
      const auto law = law_->possible_law_of<Interval>(exact);
      if (!law) return nullptr;
      return std::make_unique<const TurnHarmonics>(*law);
    });
    if (!*harmonics) return optim::kInfinity;
    const PartsOverBox parts(parts_, machine_, 0, {});
    const FollowerTrain<Interval> train = parts.train(machine);
    const Interval turns = Interval(1.0) / train.period_ratio;
    const auto z = (*harmonics)->reach(Steady::Deviation, turns, train.damping_ratio);
    const auto rate = (*harmonics)->reach(Steady::Rate, turns, train.damping_ratio);
    std::vector<double> bends;
    for (std::size_t i = 0; i < machine.size(); ++i) {
      const auto part = parts.along(machine, i);
      const Series<Interval, 3> one(Interval(1.0)), two_pi(Interval(2.0) * pi<Interval>());
      const auto root = sqrt(one - part[1] * part[1]);
      const SteadyTerm real[] = {{part[2], z}};
      const SteadyTerm imaginary[] = {{part[2] / (two_pi * part[0] * root), rate},
                                      {part[2] * part[1] / root, z}};
      bends.push_back(
          step_up(std::abs(factor_) * std::hypot(bend_along(real, part[0], part[1]),
                                                 bend_along(imaginary, part[0], part[1]))));
    }
    return off_corners(machine, bends);
  }

  std::shared_ptr<const optim::Kernel> plain_;
  std::shared_ptr<const LawBinding> law_;
  std::vector<Recorded> parts_;
  double factor_;
  Binding machine_;  ///< whose variables are the machine's arguments
  mutable Recent<std::unique_ptr<const TurnHarmonics>> recent_;
};

}  // namespace

LawKernel swing_at_rest() {
  const auto formula = []<class T>(std::span<const T> part, const Law<T>& law) -> Possible<T> {
    const auto motion = TrainMotion<T>::periodic({part[0], part[1]}, law);
    if (!motion) return motion.reason();
    const auto swing = motion->swing_at_rest();
    if (!swing) return swing.reason();
    return T(part[2] * *swing);
  };
  return [plain = law_kernel(formula)](const Binding& binding, std::vector<Recorded> parts,
                                       const UnitFactor& factor,
                                       optim::Shape shape) -> std::shared_ptr<const optim::Kernel> {
    return std::make_shared<SwingKernel>(plain(binding, parts, factor, shape), binding, parts,
                                         factor);
  };
}

}  // namespace camlaw::problems
