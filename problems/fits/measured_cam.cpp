// SPDX-License-Identifier: MIT
#include "problems/fits/measured_cam.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "problems/fits/columns.h"
#include "problems/fits/condensed.h"
#include "problems/fits/turn.h"
#include "problems/statement/parameters.h"

namespace camlaw::problems {
namespace {

/// The sizes of a machine by name, in mm.
using Sizes = std::function<double(const char*)>;

struct KnownFollower {
  const char* mechanism;
  std::function<MeasuredFollower(const Sizes&)> make;
  Rotation rotation = Rotation::Counterclockwise;
};

SwingingRoller arm_of(const Sizes& size) {
  return {size("roller_radius"), size("arm_length"), size("pivot_distance")};
}

const std::vector<KnownFollower>& known_followers() {
  static const std::vector<KnownFollower> known{
      {"disc-cam-roller",
       [](const Sizes& size) {
         return TranslatingRoller{size("roller_radius"), size("offset")};
       }},
      {"disc-cam-knife",
       [](const Sizes& size) {
         return TranslatingRoller{0, size("offset")};
       }},
      {"disc-cam-flat", [](const Sizes&) { return TranslatingFace{}; }},
      {"disc-cam-swinging-roller", arm_of},
      {"disc-cam-leading-roller", arm_of, Rotation::Clockwise},
      {"disc-cam-swinging-flat", [](const Sizes& size) {
         return SwingingFace{size("pivot_distance"), size("face_offset")};
       }}};
  return known;
}

const KnownFollower& follower_of(const ProblemStatement& machine) {
  for (const KnownFollower& known : known_followers()) {
    if (machine.mechanism->name == known.mechanism) return known;
  }
  throw std::invalid_argument(
      fmt::format("{} has no follower that a measured profile can be read for; there are {}",
                  machine.mechanism->name, fmt::join(measured_cams(), ", ")));
}

const SampleColumn* radius_of(const SampleTable& table) {
  return find_column(table, {"radius", "r", "rho"});
}

const SampleColumn* polar_angle_of(const SampleTable& table) {
  return find_column(table, {"angle", "polar_angle", "theta", "phi", "cam_angle"});
}

struct Polar {
  std::vector<double> theta, r;  ///< rad, mm
};

struct Coordinates {
  const SampleColumn *x, *y;  ///< null where there is none
};

Coordinates coordinates_of(const SampleTable& table) {
  return {find_column(table, {"x", "profile_x"}), find_column(table, {"y", "profile_y"})};
}

/// An angle and a radius, or else x and y.
SampleTable profile_columns(const SampleTable& table) {
  const SampleColumn* radius = radius_of(table);
  if (radius == nullptr) {
    const auto [x, y] = coordinates_of(table);
    if (x != nullptr && y != nullptr) return numbers_of(table, {x, y});
    throw std::invalid_argument(
        "a profile is wanted: columns of an angle and a radius, or x and y");
  }
  const SampleColumn* angle = polar_angle_of(table);
  if (angle != nullptr) return numbers_of(table, {angle, radius});
  throw std::invalid_argument(fmt::format(
      "column '{}' wants one for the angle beside it, such as \"angle [deg]\"", radius->name));
}

Polar points_of(const SampleTable& own) {
  const SampleColumn &first = own.columns[0], &second = own.columns[1];
  Polar points;
  if (radius_of(own) != nullptr) {
    points = {in_unit(own, first, {"deg"}).values, in_unit(own, second, {"mm"}).values};
    for (double& theta : points.theta) theta *= kDegree;
    return points;
  }
  points = {in_unit(own, first, {"mm"}).values, in_unit(own, second, {"mm"}).values};
  for (std::size_t i = 0; i < points.r.size(); ++i) {
    const double x = points.theta[i], y = points.r[i];
    points.theta[i] = std::atan2(y, x);
    points.r[i] = std::hypot(x, y);
  }
  return points;
}

/// Rows of an angle and a radius may be in any order.
void sort_by_angle(Polar& points) {
  std::vector<std::pair<double, double>> pairs;
  for (std::size_t i = 0; i < points.r.size(); ++i) {
    pairs.emplace_back(in_turn(points.theta[i]), points.r[i]);
  }
  std::sort(pairs.begin(), pairs.end());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    std::tie(points.theta[i], points.r[i]) = pairs[i];
  }
}

/// Many points as means of neighbours.
Condensed in_order(const SampleTable& own) {
  Polar points = points_of(own);
  if (points.r.size() <= kMostSamples) {
    if (radius_of(own) != nullptr) sort_by_angle(points);
    return {std::move(points.theta), std::move(points.r)};
  }
  for (double& theta : points.theta) theta = in_turn(theta);
  return condensed(std::move(points.theta), std::move(points.r));
}

MeasuredProfile profile_of(const Condensed& points) {
  optim::SmoothingOptions smoothing;
  smoothing.reweighting = optim::Reweighting::Bisquare;
  return MeasuredProfile::polar(points.place, points.value, smoothing);
}

MeasuredCam read_cam(const SampleTable& table, const ProblemStatement& machine) {
  const KnownFollower& known = follower_of(machine);
  const Sizes sizes = [&](const char* name) { return constant_of(machine, name); };
  const SampleTable own = profile_columns(table);
  const Condensed points = in_order(own);
  MeasuredCam cam{MeasuredLift(profile_of(points), known.make(sizes), known.rotation), {}, {}};
  cam.each = points.each;
  cam.left_out = points.left_out;
  cam.lacking = own.left_out;
  const bool swings = find_response(*machine.mechanism, "displacement").unit == "deg";
  cam.samples.place_unit = "deg";
  cam.samples.unit = cam.samples.length_unit = swings ? "deg" : "mm";
  for (const LiftSample& sample : cam.lift.samples()) {
    if (sample.outlying) {
      cam.outlying.push_back({sample.phi / kDegree, sample.distance});
      continue;
    }
    cam.samples.place.push_back(sample.phi / kDegree);
    cam.samples.value.push_back(swings ? sample.s / kDegree : sample.s);
  }
  return cam;
}

}  // namespace

std::vector<std::string> measured_cams() {
  std::vector<std::string> result;
  for (const KnownFollower& known : known_followers()) result.push_back(known.mechanism);
  return result;
}

bool shows_profile(const SampleTable& table) {
  if (radius_of(table) != nullptr) return true;
  const auto [x, y] = coordinates_of(table);
  return x != nullptr && y != nullptr && has_kind(*x, "mm") && has_kind(*y, "mm");
}

MeasuredCam measured_cam(const SampleTable& table, const ProblemStatement& machine) {
  try {
    return read_cam(table, machine);
  } catch (const std::invalid_argument& error) {
    const std::string what = error.what();
    if (what.starts_with(table.source)) throw;
    throw std::invalid_argument(fmt::format("{}: {}", table.source, what));
  }
}

}  // namespace camlaw::problems
