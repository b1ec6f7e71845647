// SPDX-License-Identifier: MIT
#include "optim/verdict/design_point.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "optim/cycle/maxima_at.h"
#include "optim/cycle/scales.h"
#include "optim/verdict/limits.h"

namespace camlaw::optim {
namespace {

using Numbers = std::vector<double>;

double length(const Numbers& u) {
  double squares = 0;
  for (const double value : u) squares += value * value;
  return std::sqrt(squares);
}

/// The room over normal numbers.
struct InNormal {
  const RoomSlopes& room;
  Design x;
  const std::vector<Variation>& variations;

  double operator()(const Numbers& u, Numbers& slopes) const {
    Numbers at(x.begin(), x.end());
    for (std::size_t i = 0; i < u.size(); ++i) at[i] += variations[i].at(u[i]);
    const double value = room(at, slopes);
    for (std::size_t i = 0; i < u.size(); ++i) slopes[i] *= variations[i].slope(u[i]);
    return value;
  }
};

/// What a step must make less: the distance, and what is left of the room with a factor that is
/// above distance over slope (Zhang and Der Kiureghian 1995).
double merit(double distance, double room, double factor) {
  return distance * distance / 2 + factor * std::abs(room);
}

}  // namespace

std::optional<DesignPoint> design_point(const RoomSlopes& room, Design x,
                                        const std::vector<Variation>& variations,
                                        const DesignPointSearch& search) {
  // A step of 1/2048 of the way is taken whether it is better or not.
  constexpr int kHalvings = 12;
  // Chance leads beyond nine deviations once in 1e19. The value in the middle is rounded by less
  // than kSmall of it.
  constexpr double kFarthest = 9, kSmall = 1e-9;
  const InNormal f{room, x, variations};
  const std::size_t n = x.size();
  Numbers u(n, 0.0), slopes(n, 0.0);
  double value = f(u, slopes);
  const double in_middle = value;
  if (!std::isfinite(value)) return {};
  if (!search.start.empty()) {
    u = search.start;
    value = f(u, slopes);
    if (!std::isfinite(value)) return {};
  }
  for (int step = 0; step < search.most_steps; ++step) {
    const double steep = length(slopes);
    if (!(steep > 0 && std::isfinite(steep))) return {};
    double along = 0;
    for (std::size_t i = 0; i < n; ++i) along += slopes[i] * u[i];
    Numbers target(n);
    for (std::size_t i = 0; i < n; ++i) {
      target[i] = std::clamp(slopes[i] * (along - value) / (steep * steep), -kFarthest, kFarthest);
    }
    double change = 0;
    for (std::size_t i = 0; i < n; ++i) change = std::max(change, std::abs(target[i] - u[i]));
    const bool is_there = std::abs(value) <= kSmall * std::max(std::abs(in_middle), steep);
    if (change <= 1e-7 && is_there) {
      return DesignPoint{u, std::copysign(length(u), in_middle)};
    }
    const double factor = 2 * length(u) / steep + 10 * std::max(1.0, length(target)) / steep;
    const double now = merit(length(u), value, factor);
    double share = 1;
    bool is_better = false;
    for (int halving = 0; halving < kHalvings && !is_better; ++halving, share /= 2) {
      Numbers next(n), own(n, 0.0);
      for (std::size_t i = 0; i < n; ++i) next[i] = u[i] + share * (target[i] - u[i]);
      const double there = f(next, own);
      if (!std::isfinite(there)) continue;
      is_better = merit(length(next), there, factor) < now || halving + 1 == kHalvings;
      if (!is_better) continue;
      u = std::move(next);
      slopes = std::move(own);
      value = there;
    }
    if (!is_better) return {};
  }
  return {};
}

RoomSlopes room_slopes(const Problem& problem, std::size_t limit, Design x) {
  auto alone = std::make_shared<Problem>(problem);
  alone->objectives = {no_objective()};
  alone->constraints = {problem.constraints[limit]};
  auto size = std::make_shared<Scales>(scales(*alone, x));
  return [alone, size](Design at, std::span<double> slopes) {
    std::fill(slopes.begin(), slopes.end(), 0.0);
    const LimitReport report = limit_reports(*alone, *size, at, false).front();
    const Response& response = alone->constraints.front().response;
    Function f;
    if (response.is_curve()) {
      if (!report.worst_angle) return report.margin;
      const Curve& curve = response.curve();
      f = curve.at(curve.tied({*report.worst_angle, report.from_left}, at));
    } else {
      f = response.function();
    }
    Numbers g(f.inputs().size());
    f.gradient(at, g);
    for (std::size_t k = 0; k < g.size(); ++k) {
      slopes[f.inputs()[k]] = report.is_upper ? -g[k] : g[k];
    }
    return report.margin + report.tolerance;
  };
}

}  // namespace camlaw::optim
