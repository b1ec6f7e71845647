// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "fitting/motions/coefficients.h"
#include "fitting/samples/motion_samples.h"
#include "fitting/samples/stand_ins.h"
#include "optim/fit/residuals.h"

namespace camlaw::problems {

/// Where the parameters of a motion's fit stand: begin, end, stroke, of displacements the zero
/// shift, then the law's coefficients.
struct MotionLayout {
  bool with_zero;

  static constexpr std::size_t kBegin = 0, kEnd = 1, kStroke = 2, kZero = 3;
  std::size_t first() const { return with_zero ? 4 : 3; }  ///< of the coefficients
};

/// Where pieces of a law meet that moves from `begin` to `end`, and these: derivatives may jump
/// there.
std::vector<double> breaks_of(const Law<double>& law, double begin, double end);

/// (FS1) of docs/optimisation.md: y = zero + h s(u), u = (x - begin) / (end - begin) within 0 and
/// 1, or its first or second derivative by x, less the samples.
class MotionResiduals final : public optim::Residuals {
 public:
  /// `samples` gives places and values, order and layout() the rest; the coefficients are those of
  /// coefficients_of().
  MotionResiduals(MotionSamples samples, const Member& law, Skew skew = Skew::Held);
  /// Of samples that stand for many, each times its root.
  MotionResiduals(StandIns few, const Member& law, Skew skew = Skew::Held);

  MotionLayout layout() const { return {samples_.order == 0}; }
  std::size_t count() const override { return samples_.place.size(); }
  std::size_t measurements() const override { return measurements_; }
  double rest() const override { return rest_; }
  bool evaluate(std::span<const double> p, std::span<double> r,
                std::span<double> jacobian) const override;

  /// breaks_of() the law at p; none where p makes none.
  std::vector<double> breaks(std::span<const double> p) const;

 private:
  struct LawAt;

  template <std::size_t K>
  bool evaluated(std::span<const double> p, std::span<double> r, std::span<double> jacobian) const;
  /// None where p makes no law.
  std::optional<LawAt> law_at(std::span<const double> p, bool with_gradient) const;

  MotionSamples samples_;
  std::vector<double> roots_ = {};  ///< none: 1 each
  std::size_t measurements_;
  double rest_ = 0;
  LawBinding binding_;
  std::vector<double> own_;               ///< the member's coefficients
  std::optional<Law<double>> at_own_;     ///< of a law linear in all of them: at these
  std::vector<Law<double>> derivatives_;  ///< of such a law, by each of them, the same for every p
};

}  // namespace camlaw::problems
