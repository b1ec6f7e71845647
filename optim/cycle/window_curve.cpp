// SPDX-License-Identifier: MIT
#include "optim/cycle/window_curve.h"

#include <algorithm>
#include <cmath>

namespace camlaw::optim {
namespace {

class WindowTrace final : public Trace {
 public:
  WindowTrace(std::unique_ptr<Trace> whole, Window window)
      : whole_(std::move(whole)), breaks_(breaks_within(whole_->breaks(), window)) {}

  std::vector<double> breaks() const override { return breaks_; }
  std::array<double, 3> at(Place place) const override { return whole_->at(place); }
  std::vector<std::array<double, 3>> even(double from, double to, int count) const override {
    return whole_->even(from, to, count);
  }
  std::vector<double> values(std::span<const Place> places) const override {
    return whole_->values(places);
  }
  Bounds enclose(double from, double to) const override { return whole_->enclose(from, to); }
  std::string why_unbounded() const override { return whole_->why_unbounded(); }

 private:
  /// The window's ends and the breaks between them. An end that rounding has left beside a break is
  /// that break, so that nothing of the curve beyond it is seen.
  static std::vector<double> breaks_within(const std::vector<double>& all, const Window& window) {
    const double beside = 1e-9 * (all.back() - all.front());
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
  std::vector<double> breaks_;
};

}  // namespace

Place WindowCurve::tied(Place place, Design x) const {
  if (is_fixed_) {
    const auto [from, to] = window_(x);
    constexpr double kBeside = 1e-9;  // of the cycle: where an end is a break of the curve
    const double near = kBeside * std::max(std::abs(from), std::abs(to));
    if (std::abs(place.angle - from) <= near || std::abs(place.angle - to) <= near) return place;
  }
  return curve().tied(place, x);
}

std::vector<Rest> WindowCurve::rests(double bound, Design x) const {
  const auto [from, to] = window_(x);
  std::vector<Rest> result;
  for (Rest rest : curve().rests(bound, x)) {
    const double room = rest.is_end ? rest.angle - from : to - rest.angle;
    const bool within = rest.angle >= from && rest.angle <= to && room > 0;
    if (!within) continue;
    rest.length = std::min(rest.length, room);
    result.push_back(std::move(rest));
  }
  return result;
}

std::unique_ptr<Trace> WindowCurve::trace(Design x) const {
  return std::make_unique<WindowTrace>(curve().trace(x), window_(x));
}

}  // namespace camlaw::optim
