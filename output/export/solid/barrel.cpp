// SPDX-License-Identifier: MIT
#include "output/export/solid/barrel.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "output/export/curve_fit.h"
#include "output/export/solid/barrel_flank.h"

namespace camlaw::problems {
namespace {

constexpr double kWholeTurn = 2 * std::numbers::pi;
constexpr double kPerRad = 180 / std::numbers::pi;

/// A cubic by its Bernstein coefficients at a share t, by de Casteljau.
double cubic_at(std::array<double, 4> c, double t) {
  for (std::size_t level = 3; level > 0; --level) {
    for (std::size_t i = 0; i < level; ++i) c[i] += t * (c[i + 1] - c[i]);
  }
  return c[0];
}
double cubic_slope_at(const std::array<double, 4>& c, double t) {
  const double a = c[1] - c[0], b = c[2] - c[1], d = c[3] - c[2];
  const double e = a + t * (b - a), f = b + t * (d - b);
  return 3 * (e + t * (f - e));
}

using Patch = FlankSurface::Patch;

std::array<double, 4> column_of(const Patch& patch, std::size_t k) {
  return {patch[0][k], patch[1][k], patch[2][k], patch[3][k]};
}

/// A patch at two shares, and its slopes by each.
struct PatchPlace {
  double value, by_first, by_second;
};
PatchPlace place_on(const Patch& patch, double first, double second) {
  std::array<double, 4> values, slopes;
  for (std::size_t k = 0; k < 4; ++k) {
    values[k] = cubic_at(column_of(patch, k), first);
    slopes[k] = cubic_slope_at(column_of(patch, k), first);
  }
  return {cubic_at(values, second), cubic_at(slopes, second), cubic_slope_at(values, second)};
}

/// The largest second derivatives of a patch by its shares: no greater than those of their
/// Bernstein coefficients.
struct PatchBend {
  double first = 0, second = 0, both = 0;
};
PatchBend bend_of(const Patch& p) {
  PatchBend bend;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      if (i < 2) {
        bend.first = std::max(bend.first, 6 * std::abs(p[i][j] - 2 * p[i + 1][j] + p[i + 2][j]));
      }
      if (j < 2) {
        bend.second = std::max(bend.second, 6 * std::abs(p[i][j] - 2 * p[i][j + 1] + p[i][j + 2]));
      }
      if (i < 3 && j < 3) {
        bend.both = std::max(bend.both,
                             9 * std::abs(p[i + 1][j + 1] - p[i + 1][j] - p[i][j + 1] + p[i][j]));
      }
    }
  }
  return bend;
}

/// Bounds of a patch's slopes over a rectangle of shares, by those in its middle.
struct PatchSlopes {
  Interval by_first, by_second;
};
PatchSlopes slopes_over(const Patch& patch, const Interval& first, const Interval& second) {
  const PatchPlace middle =
      place_on(patch, boost::numeric::median(first), boost::numeric::median(second));
  const PatchBend bend = bend_of(patch);
  const double half = boost::numeric::width(first) / 2, across = boost::numeric::width(second) / 2;
  const Interval unit(-1, 1);
  return {middle.by_first + (half * bend.first + across * bend.both) * unit,
          middle.by_second + (half * bend.both + across * bend.second) * unit};
}

/// One flank of the exact groove, by the roller's angle.
class ExactFlank {
 public:
  ExactFlank(const PlaneCurve& pitch, double roller_radius, double side)
      : pitch_(pitch), roller_radius_(roller_radius), side_(side) {}

  const PlaneCurve& pitch() const { return pitch_; }

  FlankContact<double> contact(double rise, double distance) const {
    return {roller_radius_, side_, rise, distance};
  }
  FlankContact<Interval> contact(const Interval& rise, const Interval& distance) const {
    return {roller_radius_, side_, rise, distance};
  }

  /// Height of the roller's centre, its derivative and its second by the angle, rad, of any turn.
  std::array<double, 3> centre(double angle) const {
    double turn = std::fmod(angle, kWholeTurn);
    if (turn < 0) turn += kWholeTurn;
    const double at = std::min(pitch_.begin() + kPerRad * turn, pitch_.end());
    const auto h = pitch_.height({at, at == pitch_.end()});
    return {h[0], kPerRad * h[1], kPerRad * kPerRad * h[2]};
  }

  /// The roller's angle when it touches the flank at an angle and a distance.
  double roller_angle(double angle, double distance) const {
    const double most = std::asin(roller_radius_ / distance) + 1e-9;
    const auto miss = [&](double at) {
      return at + contact(centre(at)[1], distance).turned() - angle;
    };
    const double low = angle - most, high = angle + most;
    boost::uintmax_t count = 100;
    const auto found = boost::math::tools::toms748_solve(
        miss, low, high, boost::math::tools::eps_tolerance<double>(50), count);
    return (found.first + found.second) / 2;
  }

  FlankSurface::Corner corner(double angle, double distance) const {
    const double at = roller_angle(angle, distance);
    const auto [height, rise, bend] = centre(at);
    const auto c = contact(rise, distance);
    // The slope m of the flank is that of the roller's way; at the same angle it changes with q as
    // the roller's angle does.
    const double by_distance = -c.turned_by_distance() / (1 + c.turned_by_angle(bend));
    return {height + c.raised(), c.slope(), c.outward_slope(), bend * by_distance};
  }

 private:
  const PlaneCurve& pitch_;
  double roller_radius_, side_;
};

FlankSurface surface_of(const ExactFlank& exact, const BarrelSize& size, std::size_t angles,
                        std::size_t distances) {
  std::vector<std::vector<FlankSurface::Corner>> corners(distances + 1);
  for (std::size_t j = 0; j <= distances; ++j) {
    const double share = static_cast<double>(j) / static_cast<double>(distances);
    const double distance = size.floor + share * (size.outside - size.floor);
    for (std::size_t i = 0; i < angles; ++i) {
      const double angle = kWholeTurn * static_cast<double>(i) / static_cast<double>(angles);
      corners[j].push_back(exact.corner(angle, distance));
    }
    corners[j].push_back(corners[j].front());
  }
  return {size.floor, size.outside, std::move(corners)};
}

/// A box of places of the roller and distances.
struct Box {
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

std::optional<Gap> gap_over(const ExactFlank& exact, const FlankSurface& surface, const Box& box) {
  const auto bounds = exact.pitch().heights(box.from, box.to);
  for (const optim::Bounds& b : bounds) {
    if (!std::isfinite(b.lower) || !std::isfinite(b.upper)) return {};
  }
  const Interval rise = kPerRad * Interval(bounds[1].lower, bounds[1].upper);
  const Interval bend = kPerRad * kPerRad * Interval(bounds[2].lower, bounds[2].upper);
  const Interval q(box.near, box.far);
  const FlankContact<Interval> contact = exact.contact(rise, q);
  const Interval by_angle = 1.0 + contact.turned_by_angle(bend);
  if (!(by_angle.lower() > 0)) return {};
  const Interval begin = Interval(box.from - exact.pitch().begin()) / kPerRad,
                 end = Interval(box.to - exact.pitch().begin()) / kPerRad;
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
  const double half_angle = (box.to - box.from) / 2 / kPerRad, half = (box.far - box.near) / 2;
  const double middle = std::midpoint(box.from, box.to),
               distance = std::midpoint(box.near, box.far);
  const double turn = (middle - exact.pitch().begin()) / kPerRad;
  const auto [height, slope, unused] = exact.centre(turn);
  const auto here = exact.contact(slope, distance);
  const double g = height + here.raised() - surface.height(turn + here.turned(), distance);
  constexpr double kRounding = 1e-10;
  Gap gap{0, std::abs(g), half_angle * magnitude(Interval(slope_apart) * by_angle),
          half * magnitude(Interval(outward_apart) +
                           Interval(slope_apart) * contact.turned_by_distance())};
  gap.bound = (gap.middle + gap.by_angle + gap.by_distance) * (1 + 1e-12) + kRounding;
  return std::isfinite(gap.bound) ? std::optional(gap) : std::nullopt;
}

/// The circle's own cubics: of Hermite's cubic for r (cos, sin) over a step d the radius is at most
/// r d^4 / 384 from r (its fourth derivative's largest value is r).
double radial_gap(const FlankSurface& surface) {
  return surface.outside() * std::pow(surface.angle_step(), 4) / 384 * std::numbers::sqrt2;
}

/// The largest gap that is met, at places between the patches' corners.
double met_gap(const ExactFlank& exact, const FlankSurface& surface) {
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

/// Proves that no gap is larger than a limit, by dividing boxes; gives the largest bound that was
/// left. Where a gap is met that is larger, that is given, not proved.
CurveDeviation proved_gap(const ExactFlank& exact, const FlankSurface& surface, double met,
                          double limit) {
  constexpr int kMostBoxes = 2'000'000;
  constexpr double kFirst = 0.5;  // deg
  std::vector<Box> open;
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
    const Box box = open.back();
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

/// Throws where a flank turns back: where the roller's angle does not rise with the flank's.
void refuse_turning_flank(const ExactFlank& exact, const BarrelSize& size, const char* name) {
  constexpr int kAngles = 3600, kAcross = 8;
  for (int i = 0; i < kAngles; ++i) {
    const double angle = kWholeTurn * i / kAngles;
    const auto [height, rise, bend] = exact.centre(angle);
    for (int j = 0; j <= kAcross; ++j) {
      const double q = size.floor + (size.outside - size.floor) * j / kAcross;
      if (1 + exact.contact(rise, q).turned_by_angle(bend) > 0) continue;
      throw std::invalid_argument(
          fmt::format("a solid cannot be built: the {} of the groove turns back near {:.4g} deg, "
                      "{:.6g} mm from "
                      "the axis: it is undercut there",
                      name, kPerRad * angle, q));
    }
  }
}

ExportedFlank flank_within(const ExactFlank& exact, const BarrelSize& size, const char* name,
                           double tolerance) {
  // Angles and distances: a deep groove is divided in distance, a quick rise in angle.
  constexpr std::array<std::pair<std::size_t, std::size_t>, 12> kMeshes{{{360, 1},
                                                                         {360, 2},
                                                                         {720, 1},
                                                                         {720, 2},
                                                                         {360, 4},
                                                                         {720, 4},
                                                                         {360, 8},
                                                                         {1440, 2},
                                                                         {720, 8},
                                                                         {1440, 4},
                                                                         {2880, 4},
                                                                         {1440, 8}}};
  constexpr int kTries = 5;
  refuse_turning_flank(exact, size, name);
  for (const auto& [angles, distances] : kMeshes) {
    FlankSurface surface = surface_of(exact, size, angles, distances);
    const double round = radial_gap(surface);
    double met = met_gap(exact, surface);
    if (1.01 * met + round > tolerance) continue;
    CurveDeviation gap{met, false};
    for (int i = 0; i < kTries && !gap.proved; ++i) {
      met = gap.most;
      gap = proved_gap(exact, surface, met, std::max(1.01 * met, met + 2e-3 * tolerance));
      if (gap.most == met) break;  // nothing larger was met
    }
    if (gap.most + round > tolerance) continue;
    return {name, std::move(surface), gap.most + round, gap.proved};
  }
  throw std::invalid_argument(fmt::format(
      "the {} of the groove cannot be followed within {:.6g} mm; use a larger tolerance or a "
      "shallower groove",
      name, tolerance));
}

}  // namespace

FlankSurface::FlankSurface(double floor, double outside, std::vector<std::vector<Corner>> corners)
    : floor_(floor), outside_(outside), corners_(std::move(corners)) {}

double FlankSurface::angle_step() const { return kWholeTurn / static_cast<double>(angles()); }

double FlankSurface::distance_step() const {
  return (outside_ - floor_) / static_cast<double>(distances());
}

FlankSurface::Patch FlankSurface::patch(std::size_t i, std::size_t j) const {
  const double a = angle_step() / 3, b = distance_step() / 3;
  Patch patch;
  const auto fill = [&](const Corner& c, std::size_t p, std::size_t q) {
    const double along = p == 0 ? a : -a, across = q == 0 ? b : -b;
    const std::size_t p1 = p == 0 ? 1 : 2, q1 = q == 0 ? 1 : 2;
    patch[p][q] = c.height;
    patch[p1][q] = c.height + along * c.by_angle;
    patch[p][q1] = c.height + across * c.by_distance;
    patch[p1][q1] =
        c.height + along * c.by_angle + across * c.by_distance + along * across * c.by_both;
  };
  fill(corners_[j][i], 0, 0);
  fill(corners_[j][i + 1], 3, 0);
  fill(corners_[j + 1][i], 0, 3);
  fill(corners_[j + 1][i + 1], 3, 3);
  return patch;
}

double FlankSurface::height(double angle, double distance) const {
  double turn = std::fmod(angle, kWholeTurn);
  if (turn < 0) turn += kWholeTurn;
  const double t = turn / angle_step(), v = (distance - floor_) / distance_step();
  const auto i = std::min(static_cast<std::size_t>(t), angles() - 1);
  const auto j = std::min(static_cast<std::size_t>(std::max(v, 0.0)), distances() - 1);
  return place_on(patch(i, j), t - static_cast<double>(i), v - static_cast<double>(j)).value;
}

std::array<ExportedFlank, 2> barrel_flanks(const PlaneCurve& pitch, const BarrelSize& size,
                                           double tolerance) {
  if (size.floor <= size.roller_radius) {
    throw std::invalid_argument(fmt::format(
        "--groove: its floor would be {:.6g} mm from the axis, nearer than the roller's radius of "
        "{:.6g} mm",
        size.floor, size.roller_radius));
  }
  for (const auto& [place, length] : pitch.jumps()) {
    throw std::invalid_argument(
        fmt::format("a solid cannot be built: the {} jumps by {:.4g} mm at {:.6g} deg",
                    pitch.name(), length, place));
  }
  const auto begin = pitch.height({pitch.begin()}), end = pitch.height({pitch.end(), true});
  if (std::abs(begin[0] - end[0]) > PlaneCurve::kJump ||
      std::abs(begin[1] - end[1]) > PlaneCurve::kJump) {
    throw std::invalid_argument(
        "a solid cannot be built: the groove does not end as it begins after a turn");
  }
  const ExactFlank lower(pitch, size.roller_radius, -1), upper(pitch, size.roller_radius, 1);
  return {flank_within(lower, size, "lower flank", tolerance),
          flank_within(upper, size, "upper flank", tolerance)};
}

double groove_volume(const FlankSurface& lower, const FlankSurface& upper) {
  // Bernstein polynomials of degree 3 have the mean 1/4; times the distance q from the axis, which
  // is linear, the mean of the k-th is (q at the share (k + 1) / 5) / 4.
  const auto moment = [](const FlankSurface& s) {
    double sum = 0;
    for (std::size_t j = 0; j < s.distances(); ++j) {
      const double near = s.floor() + s.distance_step() * static_cast<double>(j);
      for (std::size_t i = 0; i < s.angles(); ++i) {
        const auto patch = s.patch(i, j);
        for (std::size_t k = 0; k < 4; ++k) {
          const double q = near + s.distance_step() * static_cast<double>(k + 1) / 5;
          for (std::size_t p = 0; p < 4; ++p) sum += q * patch[p][k] / 16;
        }
      }
    }
    return sum * s.angle_step() * s.distance_step();
  };
  return moment(upper) - moment(lower);
}

}  // namespace camlaw::problems
