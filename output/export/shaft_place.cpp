// SPDX-License-Identifier: MIT
#include "output/export/shaft_place.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "machines/model/cam_on_shaft.h"
#include "numerics/tables/turn.h"

namespace camlaw::problems {
namespace {

/// A curve of a cam over the shaft's angle. Where its cycle before goes on, its values are less by
/// what it advances in a cycle.
class TurnedTrace final : public optim::Trace {
 public:
  TurnedTrace(std::shared_ptr<const optim::Trace> own, double phase, double advance)
      : own_(std::move(own)),
        own_breaks_(own_->breaks()),
        phase_(in_turn(phase, kTurnDegrees)),
        advance_(advance) {
    const PlacedBreaks alone = placed();
    breaks_ = breaks_on_shaft({&alone, 1});
  }

  std::vector<double> breaks() const override { return breaks_; }
  std::array<double, 3> at(optim::Place place) const override {
    auto result = own_->at(own_place(place));
    result[0] -= before(place);
    return result;
  }
  std::vector<double> values(std::span<const optim::Place> places) const override {
    std::vector<optim::Place> own;
    for (const optim::Place& place : places) own.push_back(own_place(place));
    std::vector<double> result = own_->values(own);
    for (std::size_t i = 0; i < places.size(); ++i) result[i] -= before(places[i]);
    return result;
  }
  optim::Bounds enclose(double from, double to) const override { return expand(from, to)[0]; }
  std::array<optim::Bounds, 3> expand(double from, double to) const override {
    const double middle = std::midpoint(from, to);
    auto result = expand_on_shaft(*own_, placed(), from, to, middle);
    const double less = before({middle});
    if (less != 0) {
      const Interval value = Interval(result[0].lower, result[0].upper) - Interval(less);
      result[0] = {value.lower(), value.upper()};
    }
    return result;
  }
  std::string why_unbounded() const override { return own_->why_unbounded(); }

 private:
  PlacedBreaks placed() const { return {own_breaks_, phase_}; }
  optim::Place own_place(optim::Place place) const {
    return cam_place(place.angle, place.from_left, phase_, own_breaks_);
  }
  /// What the cycle that began in the turn before is behind.
  double before(optim::Place place) const {
    constexpr double kBeside = 1e-12;  // deg: what rounding leaves of the phase
    const bool is_before = place.angle < phase_ - kBeside ||
                           (place.from_left && place.angle <= phase_ + kBeside && phase_ > kBeside);
    return is_before ? advance_ : 0;
  }

  std::shared_ptr<const optim::Trace> own_;
  std::vector<double> own_breaks_, breaks_;
  double phase_, advance_;
};

}  // namespace

double shaft_zero_direction(const PlaneCurve& profile, double phase) {
  constexpr double kUpwards = 90;  // deg: y
  return in_turn(kUpwards + (winds_left(profile) ? -phase : phase), kTurnDegrees);
}

Eigen::Vector2d shaft_zero_axis(const PlaneCurve& profile, double phase) {
  const double angle = shaft_zero_direction(profile, phase) * std::numbers::pi / 180;
  return {std::cos(angle), std::sin(angle)};
}

double shaft_zero_along(const PlaneCurve& profile, double phase) {
  const double cycle =
      profile.look({profile.end(), true}).at.x() - profile.look({profile.begin()}).at.x();
  return in_turn(-phase, kTurnDegrees) / kTurnDegrees * cycle;
}

std::string phase_words(const ShaftPlace& place) {
  return fmt::format("the cam's zero lies at shaft angle {:.7g} deg", place.phase);
}

bool turns_with_shaft(const ExportedMotion& motion) {
  return motion.place_unit == "deg" && motion.begin() == 0 && motion.end() == kTurnDegrees;
}

ExportedMotion by_shaft(const ExportedMotion& motion, double phase, bool advances) {
  ExportedMotion result = motion;
  if (!turns_with_shaft(motion)) return result;
  result.master = "shaft_angle [deg]";
  const double way =
      motion.trace->at({motion.end(), true})[0] - motion.trace->at({motion.begin()})[0];
  result.trace = std::make_shared<TurnedTrace>(motion.trace, phase, advances ? way : 0);
  if (motion.velocity) result.velocity = std::make_shared<TurnedTrace>(motion.velocity, phase, 0);
  return result;
}

}  // namespace camlaw::problems
