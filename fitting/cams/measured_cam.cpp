// SPDX-License-Identifier: MIT
#include "fitting/cams/measured_cam.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "fitting/samples/condensed.h"
#include "fitting/samples/lift_samples.h"
#include "fitting/samples/lone_samples.h"
#include "machines/model/known_names.h"
#include "machines/registry.h"
#include "numerics/linear/statistics.h"
#include "numerics/tables/columns.h"
#include "numerics/tables/turn.h"
#include "problems/statement/parameters.h"

namespace camlaw::problems {
namespace {

/// The sizes of a machine by name, in mm.
using Sizes = std::function<double(const char*)>;

struct KnownFollower {
  Form form;
  std::function<MeasuredFollower(const Sizes&)> make;
  Rotation rotation = Rotation::Counterclockwise;
};

OscillatingRoller arm_of(const Sizes& size) {
  return {size("roller_radius"), size("arm_length"), size("pivot_distance")};
}

const std::vector<KnownFollower>& known_followers() {
  static const std::vector<KnownFollower> known{
      {Form::DiscRoller,
       [](const Sizes& size) {
         return TranslatingRoller{size("roller_radius"), size("offset")};
       }},
      {Form::DiscKnifeEdge,
       [](const Sizes& size) {
         return TranslatingRoller{0, size("offset")};
       }},
      {Form::DiscFlat, [](const Sizes&) { return TranslatingFace{}; }},
      {Form::DiscTrailingRoller, arm_of},
      {Form::DiscLeadingRoller, arm_of, Rotation::Clockwise},
      {Form::DiscFlatArm, [](const Sizes& size) {
         return OscillatingFace{size("pivot_distance"), size("face_offset")};
       }}};
  return known;
}

/// Null for machines other than these.
const KnownFollower* follower_of(const Mechanism& mechanism) {
  for (const KnownFollower& known : known_followers()) {
    if (mechanism.form == known.form) return &known;
  }
  return nullptr;
}

const KnownFollower& follower_of(const ProblemStatement& machine) {
  if (const KnownFollower* known = follower_of(*machine.mechanism)) return *known;
  throw std::invalid_argument(
      fmt::format("a measured profile cannot be read for the follower of {}, but for those of {}",
                  machine.mechanism->name, fmt::join(measured_cams(), ", ")));
}

const SampleColumn* radius_of(const SampleTable& table) {
  return find_column(table, ColumnKind::Radius);
}

const SampleColumn* polar_angle_of(const SampleTable& table) {
  return find_column(table, ColumnKind::Angle);
}

struct Polar {
  std::vector<double> theta, r;  ///< rad, mm
  double resolution;             ///< what r is rounded to, mm
};

struct Coordinates {
  const SampleColumn *x, *y;  ///< null where there is none
};

Coordinates coordinates_of(const SampleTable& table) {
  return {find_column(table, ColumnKind::ProfileX), find_column(table, ColumnKind::ProfileY)};
}

/// An angle and a radius, or else x and y.
SampleTable profile_columns(const SampleTable& table) {
  const SampleColumn* radius = radius_of(table);
  if (radius == nullptr) {
    const auto [x, y] = coordinates_of(table);
    if (x != nullptr && y != nullptr) return numbers_of(table, {x, y});
    throw std::invalid_argument("a profile needs columns of an angle and a radius, or x and y");
  }
  const SampleColumn* angle = polar_angle_of(table);
  if (angle != nullptr) return numbers_of(table, {angle, radius});
  throw std::invalid_argument(fmt::format(
      "column '{}' needs a column of the angle beside it, such as \"angle [deg]\"", radius->name));
}

Polar points_of(const SampleTable& own) {
  const SampleColumn &first = own.columns[0], &second = own.columns[1];
  Polar points;
  if (radius_of(own) != nullptr) {
    UnitValues radius = in_unit(own, second, {"mm"});
    points = {in_unit(own, first, {"deg"}).values, std::move(radius.values),
              std::abs(radius.factor) * resolution_of(second)};
    for (double& theta : points.theta) theta *= kDegree;
    return points;
  }
  UnitValues across = in_unit(own, first, {"mm"}), up = in_unit(own, second, {"mm"});
  const double resolution = std::max(std::abs(across.factor) * resolution_of(first),
                                     std::abs(up.factor) * resolution_of(second));
  points = {std::move(across.values), std::move(up.values), resolution};
  for (std::size_t i = 0; i < points.r.size(); ++i) {
    const double x = points.theta[i], y = points.r[i];
    points.theta[i] = std::atan2(y, x);
    points.r[i] = std::hypot(x, y);
  }
  return points;
}

/// std::polar wants radii that are not below 0.
void check_radii(const SampleTable& own, const Polar& points) {
  for (std::size_t i = 0; i < points.r.size(); ++i) {
    if (points.r[i] > 0) continue;
    throw std::invalid_argument(fmt::format("{}:{}: the radius is {:.6g}, not above 0", own.source,
                                            own.lines[i], points.r[i]));
  }
}

/// Rows of an angle and a radius may be in any order. A point that is there twice counts once: it
/// would seem to have been measured without noise.
void put_in_order(Polar& points, bool is_polar) {
  std::vector<std::pair<double, double>> pairs;
  for (std::size_t i = 0; i < points.r.size(); ++i) {
    pairs.emplace_back(is_polar ? in_turn(points.theta[i]) : points.theta[i], points.r[i]);
  }
  if (is_polar) std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  points.theta.resize(pairs.size());
  points.r.resize(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    std::tie(points.theta[i], points.r[i]) = pairs[i];
  }
}

/// Many points as means of neighbours.
Condensed in_order(Polar points, bool is_polar) {
  if (points.r.size() <= kMostSamples) {
    put_in_order(points, is_polar);
    return {std::move(points.theta), std::move(points.r)};
  }
  for (double& theta : points.theta) theta = in_turn(theta);
  return condensed(std::move(points.theta), std::move(points.r), points.resolution);
}

/// Radii of points that were rounded to `resolution`. Where they have no noise, a spline misses
/// them where the curvature jumps: that is not a fault of theirs.
MeasuredProfile profile_of(const Condensed& points, double resolution) {
  const auto [low, high] = std::minmax_element(points.value.begin(), points.value.end());
  optim::SmoothingOptions smoothing;
  smoothing.reweighting = optim::Reweighting::Bisquare;
  smoothing.least_noise = std::max(resolution / std::sqrt(12.0), kLeastDeparture * (*high - *low));
  return MeasuredProfile::polar(points.place, points.value, smoothing);
}

/// Polar coordinates about another centre.
void move_centre(Polar& points, std::complex<double> centre) {
  if (centre == 0.0) return;
  for (std::size_t i = 0; i < points.r.size(); ++i) {
    const std::complex<double> p = std::polar(points.r[i], points.theta[i]) - centre;
    points.theta[i] = std::arg(p);
    points.r[i] = std::abs(p);
  }
}

/// Which points lie off the profile by themselves; others that the spline misses follow their
/// neighbours, or so few points do not show the curve.
std::vector<bool> lying_off(const MeasuredProfile& profile, double rounded) {
  const std::vector<double>& thetas = profile.polar_angles();
  const std::vector<std::size_t> order = optim::order_of(thetas);
  std::vector<double> theta, r, residuals;
  std::vector<std::size_t> suspects;
  for (const std::size_t k : order) {
    const optim::SmoothedSample& sample = profile.spline().samples()[k];
    if (sample.outlying) suspects.push_back(theta.size());
    theta.push_back(thetas[k]);
    r.push_back(profile.spline()(thetas[k]) + sample.residual);
    residuals.push_back(sample.residual);
  }
  const auto shown = possible_noise(theta, r);
  const double noise = std::max(shown ? *shown : 0, rounded / std::sqrt(12.0));
  const std::vector<bool> is_lone = lone_samples(theta, r, residuals, suspects, noise);
  std::vector<bool> result(thetas.size());
  for (std::size_t i = 0; i < order.size(); ++i) result[order[i]] = is_lone[i];
  return result;
}

/// The cam with the samples and the outlying points of its lift.
Possible<MeasuredCam> with_samples(MeasuredCam cam) {
  const double unit = cam.unit();
  std::vector<double> shares;
  const auto samples = cam.lift.possible_samples();
  if (!samples) return samples.reason();
  const std::vector<bool> is_off = lying_off(cam.lift.profile(), cam.rounded);
  for (std::size_t k = 0; k < samples->size(); ++k) {
    const LiftSample& sample = (*samples)[k];
    shares.push_back(sample.share);
    if (is_off[k]) {
      cam.outlying.push_back({sample.phi / kDegree, sample.distance});
      continue;
    }
    cam.samples.place.push_back(sample.phi / kDegree);
    cam.samples.value.push_back(sample.s / unit);
  }
  cam.samples.resolution = cam.rounded * optim::median(std::move(shares)) / unit;
  return cam;
}

MeasuredCam read_cam(const SampleTable& table, const ProblemStatement& machine,
                     std::complex<double> centre) {
  const KnownFollower& known = follower_of(machine);
  const Sizes sizes = [&](const char* name) { return constant_of(machine, name); };
  const SampleTable own = profile_columns(table);
  Polar read = points_of(own);
  const double rounded = read.resolution;
  check_radii(own, read);
  move_centre(read, centre);
  const Condensed points = in_order(std::move(read), radius_of(own) != nullptr);
  MeasuredCam cam{
      MeasuredLift(profile_of(points, rounded), known.make(sizes), known.rotation), {}, {}};
  cam.each = points.each;
  cam.left_out = points.left_out;
  cam.lacking = own.left_out;
  cam.rounded = rounded;
  const bool swings = find_response(*machine.mechanism, known::kDisplacement).unit == "deg";
  cam.samples.place_unit = "deg";
  cam.samples.unit = cam.samples.length_unit = swings ? "deg" : "mm";
  return with_samples(std::move(cam)).value();
}

}  // namespace

std::vector<std::string> measured_cams() {
  std::vector<std::string> result;
  for (const Mechanism& mechanism : mechanisms()) {
    if (follower_of(mechanism) != nullptr) result.push_back(mechanism.name);
  }
  return result;
}

Possible<MeasuredCam> with_follower(const MeasuredCam& cam, const MeasuredFollower& follower) {
  auto lift = MeasuredLift::possible(cam.lift.profile(), follower, cam.lift.rotation());
  if (!lift) return lift.reason();
  return with_samples(
      {std::move(*lift), cam.samples.none(), {}, cam.each, cam.left_out, cam.lacking, cam.rounded});
}

bool shows_profile(const SampleTable& table) {
  if (radius_of(table) != nullptr) return true;
  const auto [x, y] = coordinates_of(table);
  return x != nullptr && y != nullptr && has_kind(*x, "mm") && has_kind(*y, "mm");
}

MeasuredCam measured_cam(const SampleTable& table, const ProblemStatement& machine,
                         std::complex<double> centre) {
  try {
    return read_cam(table, machine, centre);
  } catch (const std::invalid_argument& error) {
    const std::string what = error.what();
    if (what.starts_with(table.source)) throw;
    throw std::invalid_argument(fmt::format("{}: {}", table.source, what));
  }
}

}  // namespace camlaw::problems
