// SPDX-License-Identifier: MIT
#include "output/export/solid/flank_gap.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace camlaw::problems {
namespace {

/// A box of places of the roller and distances.
struct PlacesAndDistances {
  double from, to;  ///< deg, as the pitch curve has them
  double near, far;
};

/// What is known of the gap along z between the exact flank and the surface at the same angle and
/// distance over a box: none where nothing is, as where the flank may turn back.
///
/// With g = z - Z(theta, q), by the roller's angle g_phi = (m - Z_theta) theta_phi and by the
/// distance g_q = (z_q - Z_q) + (m - Z_theta) theta_q, z_q at the same angle theta. By the mean
/// value theorem |g| is at most that in the middle plus these over the box.
struct Gap {
  double bound, middle;          ///< its size in the middle of the box
  double by_angle, by_distance;  ///< what the box's two sides add
};

/// The whole numbers of cells that an interval touches.
std::pair<long, long> cells(const Interval& place, double step) {
  return {static_cast<long>(std::floor(place.lower() / step)),
          static_cast<long>(std::floor(place.upper() / step))};
}

std::optional<Gap> gap_over(const ExactFlank& exact, const FlankSurface& surface,
                            const PlacesAndDistances& box) {
  const auto bounds = exact.pitch().heights(box.from, box.to);
  for (const optim::Bounds& b : bounds) {
    if (!std::isfinite(b.lower) || !std::isfinite(b.upper)) return {};
  }
  const Interval rise = ExactFlank::kPerRad * Interval(bounds[1].lower, bounds[1].upper);
  const Interval bend =
      ExactFlank::kPerRad * ExactFlank::kPerRad * Interval(bounds[2].lower, bounds[2].upper);
  const Interval q(box.near, box.far);
  const FlankContact<Interval> contact = exact.contact(rise, q);
  const Interval by_angle = 1.0 + contact.turned_by_angle(bend);
  if (!(by_angle.lower() > 0)) return {};
  const Interval begin = Interval(box.from - exact.pitch().begin()) / ExactFlank::kPerRad,
                 end = Interval(box.to - exact.pitch().begin()) / ExactFlank::kPerRad;
  const Interval angle = boost::numeric::hull(begin, end) + contact.turned();
  // Over every patch that the box touches.
  const double step = surface.angle_step(), across = surface.distance_step();
  const auto [first, last] = cells(angle, step);
  const auto count = static_cast<long>(surface.angles());
  double slope_apart = 0, outward_apart = 0;
  const Interval from_floor = q - surface.floor();
  const auto [inner, outer] = cells(from_floor, across);
  const Interval unit(0, 1);
  for (long i = first; i <= last; ++i) {
    const Interval t = angle / step - static_cast<double>(i);
    const auto column = static_cast<std::size_t>(((i % count) + count) % count);
    for (long j = inner; j <= outer; ++j) {
      const auto row =
          static_cast<std::size_t>(std::clamp(j, 0L, static_cast<long>(surface.distances()) - 1));
      const Interval v = from_floor / across - static_cast<double>(row);
      // A box on the joint of two patches is of both; what is outside of one is in the other.
      const Interval first_share = boost::numeric::intersect(t, unit),
                     second_share = boost::numeric::intersect(v, unit);
      if (boost::numeric::empty(first_share) || boost::numeric::empty(second_share)) continue;
      const auto at = slopes_over(surface.patch(column, row), first_share, second_share);
      slope_apart = std::max(slope_apart, magnitude(contact.slope() - at.by_first / step));
      outward_apart =
          std::max(outward_apart, magnitude(contact.outward_slope() - at.by_second / across));
    }
  }
  const double half_angle = (box.to - box.from) / 2 / ExactFlank::kPerRad,
               half = (box.far - box.near) / 2;
  const double middle = std::midpoint(box.from, box.to),
               distance = std::midpoint(box.near, box.far);
  const double turn = (middle - exact.pitch().begin()) / ExactFlank::kPerRad;
  const auto [height, slope, unused] = exact.centre(turn);
  const auto here = exact.contact(slope, distance);
  const double g = height + here.raised() - surface.height(turn + here.turned(), distance);
  constexpr double kRounding = 1e-10;  // mm: what rounding of heights up to a metre leaves
  Gap gap{0, std::abs(g), half_angle * magnitude(Interval(slope_apart) * by_angle),
          half * magnitude(Interval(outward_apart) +
                           Interval(slope_apart) * contact.turned_by_distance())};
  gap.bound = (gap.middle + gap.by_angle + gap.by_distance) * (1 + 1e-12) + kRounding;
  return std::isfinite(gap.bound) ? std::optional(gap) : std::nullopt;
}

}  // namespace

double radial_gap(const FlankSurface& surface) {
  return surface.outside() * std::pow(surface.angle_step(), 4) / 384 * std::numbers::sqrt2;
}

double met_gap(const ExactFlank& exact, const FlankSurface& surface) {
  // Eight places of each patch and three of each angle meet its highest waves.
  constexpr int kAcross = 8;
  const int along = static_cast<int>(3 * surface.angles()),
            across = kAcross * static_cast<int>(surface.distances());
  double worst = 0;
  for (int i = 0; i < along; ++i) {
    const double angle = kWholeTurn * (i + 0.5) / along;
    const auto [height, slope, unused] = exact.centre(angle);
    for (int j = 0; j <= across; ++j) {
      const double q =
          surface.floor() + (surface.outside() - surface.floor()) * j / static_cast<double>(across);
      const auto here = exact.contact(slope, q);
      const double z = surface.height(angle + here.turned(), q);
      worst = std::max(worst, std::abs(height + here.raised() - z));
    }
  }
  return worst;
}

CurveDeviation proved_gap(const ExactFlank& exact, const FlankSurface& surface, double met,
                          double limit) {
  constexpr int kMostBoxes = 2'000'000;  // a gap that takes more boxes is not proved
  constexpr double kFirst = 0.5;         // deg
  std::vector<PlacesAndDistances> open;
  const auto& breaks = exact.pitch().breaks();
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    const double length = breaks[k + 1] - breaks[k];
    const int count = std::max(static_cast<int>(std::ceil(length / kFirst)), 1);
    for (int i = 0; i < count; ++i) {
      for (std::size_t j = 0; j < surface.distances(); ++j) {
        const double step = surface.distance_step(), near = surface.floor() + step * double(j);
        const bool last = j + 1 == surface.distances();
        open.push_back({optim::even_place(breaks[k], breaks[k + 1], count, i).angle,
                        optim::even_place(breaks[k], breaks[k + 1], count, i + 1).angle, near,
                        last ? surface.outside() : near + step});
      }
    }
  }
  double most = met;
  for (int boxes = 0; !open.empty(); ++boxes) {
    const PlacesAndDistances box = open.back();
    open.pop_back();
    const auto gap = gap_over(exact, surface, box);
    if (gap && gap->bound <= limit) {
      most = std::max(most, gap->bound);
      continue;
    }
    if (gap && gap->middle > limit) return {gap->middle, false};
    const double middle = std::midpoint(box.from, box.to);
    if (boxes > kMostBoxes || !(box.from < middle && middle < box.to)) return {met, false};
    if (!gap || gap->by_angle >= gap->by_distance) {
      open.push_back({middle, box.to, box.near, box.far});
      open.push_back({box.from, middle, box.near, box.far});
    } else {
      const double between = std::midpoint(box.near, box.far);
      open.push_back({box.from, box.to, between, box.far});
      open.push_back({box.from, box.to, box.near, between});
    }
  }
  return {most, true};
}

}  // namespace camlaw::problems
