// SPDX-License-Identifier: MIT
#include "optim/cycle/window_curve.h"

#include <algorithm>
#include <cmath>

namespace camlaw::optim {
namespace {

/// A place of a window that counts on past the end of the turn, as the turn has it.
Place in_turn(Place place, const std::optional<double>& turn) {
  const bool beyond = turn && (place.angle > *turn || (place.angle == *turn && !place.from_left));
  if (beyond) place.angle -= *turn;
  return place;
}

class WindowTrace final : public Trace {
 public:
  WindowTrace(std::unique_ptr<Trace> whole, Window window, std::optional<double> turn)
      : whole_(std::move(whole)), turn_(turn), breaks_(breaks_within(all_breaks(), window)) {}

  std::vector<double> breaks() const override { return breaks_; }
  std::array<double, 3> at(Place place) const override { return whole_->at(in_turn(place, turn_)); }
  std::vector<std::array<double, 3>> even(double from, double to, int count) const override {
    const double beyond = turns_before(from);
    return whole_->even(from - beyond, to - beyond, count);
  }
  std::vector<double> values(std::span<const Place> places) const override {
    std::vector<Place> own(places.begin(), places.end());
    for (Place& place : own) place = in_turn(place, turn_);
    return whole_->values(own);
  }
  Bounds enclose(double from, double to) const override {
    const double beyond = turns_before(from);
    return whole_->enclose(from - beyond, to - beyond);
  }
  std::string why_unbounded() const override { return whole_->why_unbounded(); }

 private:
  /// What a stretch that begins there counts on from: the turn's end is a break.
  double turns_before(double from) const { return turn_ && from >= *turn_ ? *turn_ : 0; }
  /// Those of the whole, and of the next turn.
  std::vector<double> all_breaks() const {
    std::vector<double> all = whole_->breaks();
    if (!turn_) return all;
    const std::size_t own = all.size();
    for (std::size_t i = 1; i < own; ++i) all.push_back(all[i] + *turn_);
    return all;
  }
  /// The window's ends and the breaks between them. An end that rounding has left beside a break is
  /// that break, so that nothing of the curve beyond it is seen.
  static std::vector<double> breaks_within(const std::vector<double>& all, const Window& window) {
    constexpr double kRounding = 1e-9;  // of the cycle, as an angle of ten digits in a file has
    const double beside = kRounding * (all.back() - all.front());
    const auto at_break = [&](double end) {
      const auto near = std::find_if(all.begin(), all.end(),
                                     [&](double b) { return std::abs(b - end) <= beside; });
      return near == all.end() ? std::clamp(end, all.front(), all.back()) : *near;
    };
    const double from = at_break(window.first), to = at_break(window.second);
    std::vector<double> result{from};
    for (const double b : all) {
      if (b > from && b < to) result.push_back(b);
    }
    result.push_back(to);
    return result;
  }

  std::unique_ptr<Trace> whole_;
  std::optional<double> turn_;
  std::vector<double> breaks_;
};

}  // namespace

Function WindowCurve::at(Place place) const { return curve().at(in_turn(place, turn_)); }

std::vector<double> WindowCurve::slope_gradient(Place place, Design x) const {
  return curve().slope_gradient(in_turn(place, turn_), x);
}

bool WindowCurve::is_fixed_end(Place place, Design x) const {
  if (!is_fixed_) return false;
  const auto [from, to] = window_(x);
  constexpr double kBeside = 1e-9;  // of the cycle: where an end is a break of the curve
  const double near = kBeside * std::max(std::abs(from), std::abs(to));
  return std::abs(place.angle - from) <= near || std::abs(place.angle - to) <= near;
}

std::vector<double> WindowCurve::jump_motion(Place place, Design x) const {
  if (is_fixed_end(place, x)) return {};
  return optim::jump_motion(curve(), in_turn(place, turn_), x);
}

Place WindowCurve::tied(Place place, Design x) const {
  if (is_fixed_end(place, x)) return place;
  place.joint = curve().tied(in_turn(place, turn_), x).joint;
  return place;
}

std::vector<Rest> WindowCurve::rests(double bound, Design x) const {
  const auto [from, to] = window_(x);
  std::vector<Rest> result;
  for (Rest rest : curve().rests(bound, x)) {
    if (turn_ && (rest.angle < from || (rest.angle == from && rest.is_end))) rest.angle += *turn_;
    const double room = rest.is_end ? rest.angle - from : to - rest.angle;
    const bool within = rest.angle >= from && rest.angle <= to && room > 0;
    if (!within) continue;
    rest.length = std::min(rest.length, room);
    result.push_back(std::move(rest));
  }
  return result;
}

std::unique_ptr<Trace> WindowCurve::trace(Design x) const {
  return std::make_unique<WindowTrace>(curve().trace(x), window_(x), turn_);
}

}  // namespace camlaw::optim
