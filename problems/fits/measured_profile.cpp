// SPDX-License-Identifier: MIT
#include "problems/fits/measured_profile.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "kinematics/laws/spline.h"

namespace camlaw::problems {
namespace {

using Complex = std::complex<double>;
constexpr double kPi = std::numbers::pi;
constexpr double kTurn = 2 * kPi;
constexpr Complex kI{0, 1};

[[noreturn]] void refuse(const std::string& why) {
  throw std::invalid_argument("measured profile: " + why);
}

double degrees(double angle) { return angle * 180 / kPi; }

/// The polar angle as people read it, 0 to 360 deg.
std::string place_of(double theta) {
  return fmt::format("at a polar angle of {:.4g} deg",
                     degrees(theta - kTurn * std::floor(theta / kTurn)));
}

struct Polar {
  std::vector<double> theta, r;
};

void check_points(const Polar& points) {
  // The order of the penalty, a few spans and what cross-validation needs.
  constexpr std::size_t kLeast = 12;
  if (points.r.size() < kLeast) {
    refuse(fmt::format("{} points are too few, {} are needed", points.r.size(), kLeast));
  }
  for (std::size_t k = 0; k < points.r.size(); ++k) {
    if (!std::isfinite(points.theta[k]) || !std::isfinite(points.r[k])) {
      refuse(fmt::format("point {} is no number", k));
    }
    if (!(points.r[k] > 0)) {
      refuse(fmt::format("point {} has the radius {:.6g}, not above 0", k, points.r[k]));
    }
  }
}

/// Steps of the polar angle from point to point, the last one back to the first.
std::vector<double> steps_of(const std::vector<double>& theta) {
  std::vector<double> steps;
  for (std::size_t k = 0; k < theta.size(); ++k) {
    steps.push_back(std::remainder(theta[(k + 1) % theta.size()] - theta[k], kTurn));
  }
  return steps;
}

/// That the points go round the centre once, and every ray meets them once.
void check_round(const std::vector<double>& steps) {
  double sum = 0;
  for (const double step : steps) sum += step;
  if (std::abs(std::abs(sum) - kTurn) > 1) {
    refuse(fmt::format("it does not go round the centre once: its polar angle turns by {:.4g} deg",
                       degrees(sum)));
  }
  // Noise may turn the angle back by a little between points that are close.
  constexpr double kMostBack = kPi / 180;
  const double sense = sum > 0 ? 1 : -1;
  double reached = 0, now = 0;
  for (std::size_t k = 0; k + 1 < steps.size(); ++k) {
    now += sense * steps[k];
    reached = std::max(reached, now);
    if (reached - now > kMostBack) {
      refuse(fmt::format("it turns back at point {}: a ray from the centre meets it twice", k + 1));
    }
  }
}

void check_gaps(std::vector<double> theta) {
  constexpr double kMostGap = kPi / 4;
  std::sort(theta.begin(), theta.end());
  for (std::size_t k = 0; k < theta.size(); ++k) {
    const bool last = k + 1 == theta.size();
    const double next = last ? theta.front() + kTurn : theta[k + 1];
    if (next - theta[k] <= kMostGap) continue;
    refuse(fmt::format("it is not closed: there are no points from {:.4g} to {:.4g} deg",
                       degrees(theta[k]), degrees(last ? theta.front() : next)));
  }
}

optim::SmoothingSpline closed_spline(Polar points, optim::SmoothingOptions smoothing) {
  check_points(points);
  check_round(steps_of(points.theta));
  for (double& theta : points.theta) {
    theta = std::clamp(theta - kTurn * std::floor(theta / kTurn), 0.0, kTurn);
  }
  check_gaps(points.theta);
  smoothing.periodic = true;
  smoothing.range = {0, kTurn};
  smoothing.begin = smoothing.end = {};
  return optim::smoothing_spline(points.theta, points.r, smoothing);
}

void check_lengths(std::size_t a, std::size_t b, const char* what) {
  if (a != b) refuse(fmt::format("{} {} and {} do not belong together", a, what, b));
}

}  // namespace

MeasuredProfile MeasuredProfile::polar(std::span<const double> theta, std::span<const double> r,
                                       const optim::SmoothingOptions& smoothing) {
  check_lengths(theta.size(), r.size(), "polar angles and radii");
  return MeasuredProfile(
      closed_spline({{theta.begin(), theta.end()}, {r.begin(), r.end()}}, smoothing));
}

MeasuredProfile MeasuredProfile::points(std::span<const double> x, std::span<const double> y,
                                        const optim::SmoothingOptions& smoothing) {
  check_lengths(x.size(), y.size(), "values of x and y");
  Polar polar;
  for (std::size_t k = 0; k < x.size(); ++k) {
    polar.theta.push_back(std::atan2(y[k], x[k]));
    polar.r.push_back(std::hypot(x[k], y[k]));
  }
  return MeasuredProfile(closed_spline(std::move(polar), smoothing));
}

/// (I1), (I2)
ProfilePoint MeasuredProfile::at(double theta) const {
  const double r = spline_(theta), d = spline_(theta, 1), dd = spline_(theta, 2);
  const Complex ray = std::polar(1.0, theta);
  const double speed = std::hypot(r, d);
  const Complex tangent = Complex(d, r) / speed * ray;
  return {r * ray, tangent, -kI * tangent, (r * r + 2 * d * d - r * dd) / (speed * speed * speed),
          speed};
}

/// The follower while the profile's point at theta is the one that it touches.
struct MeasuredLift::State {
  double phi, coordinate, ds, dds;
  double rate;   ///< |dphi / dtheta|
  double share;  ///< of a small shift of the profile along its normal that the follower makes
};

namespace {

/// A roller's centre by the follower's coordinate q: w, g = dw / dq and dg / dq.
struct Way {
  double coordinate;
  Complex w, g, bend;
};

Way way_at(const TranslatingRoller& follower, double distance, double theta) {
  const double e = follower.offset;
  if (!(std::abs(e) < distance)) {
    refuse(
        fmt::format("the offset {:.6g} is not less than the distance {:.6g} of the roller's "
                    "centre {}",
                    e, distance, place_of(theta)));
  }
  const double y = std::sqrt((distance - e) * (distance + e));
  return {y, {e, y}, kI, 0};
}

Way way_at(const SwingingRoller& follower, double distance, double theta) {
  const double l = follower.arm_length, d = follower.pivot_distance;
  const double cosine = (l * l + d * d - distance * distance) / (2 * l * d);
  if (!(std::abs(cosine) < 1)) {
    refuse(
        fmt::format("an arm of {:.6g} with its pivot at {:.6g} does not reach the roller's "
                    "centre, {:.6g} from the cam's, {}",
                    l, d, distance, place_of(theta)));
  }
  const double psi = std::acos(cosine);
  const Complex arm = std::polar(l, -psi);
  return {psi, d - arm, kI * arm, arm};
}

double roller_radius(const MeasuredFollower& follower) {
  if (const auto* roller = std::get_if<TranslatingRoller>(&follower)) return roller->roller_radius;
  if (const auto* roller = std::get_if<SwingingRoller>(&follower)) return roller->roller_radius;
  return 0;
}

bool is_roller(const MeasuredFollower& follower) {
  return std::holds_alternative<TranslatingRoller>(follower) ||
         std::holds_alternative<SwingingRoller>(follower);
}

Way way_of(const MeasuredFollower& follower, double distance, double theta) {
  const auto* arm = std::get_if<SwingingRoller>(&follower);
  return arm ? way_at(*arm, distance, theta)
             : way_at(std::get<TranslatingRoller>(follower), distance, theta);
}

/// A face at the height H over the cam's centre: its coordinate, how fast its foot moves by it, and
/// what turns with it.
struct FaceWay {
  double coordinate, foot_rate, height_bend;
  bool swings;
};

FaceWay face_way(const MeasuredFollower& follower, double height, double theta) {
  const auto* arm = std::get_if<SwingingFace>(&follower);
  if (!arm) return {height, 1, 0, false};
  const double sine = (height + arm->face_offset) / arm->pivot_distance;
  if (!(std::abs(sine) < 1)) {
    refuse(fmt::format("a face {:.6g} from its pivot at {:.6g} does not lie on the cam {}",
                       arm->face_offset, arm->pivot_distance, place_of(theta)));
  }
  const double psi = std::asin(sine);
  return {psi, arm->pivot_distance * std::cos(psi), arm->pivot_distance * sine, true};
}

void check_follower(const MeasuredFollower& follower) {
  const double radius = roller_radius(follower);
  if (!(radius >= 0 && std::isfinite(radius))) {
    refuse(fmt::format("a roller radius of {:.6g} is below 0", radius));
  }
  const auto positive = [](const char* name, double value) {
    if (!(value > 0 && std::isfinite(value))) {
      refuse(fmt::format("{} of {:.6g} is not above 0", name, value));
    }
  };
  if (const auto* arm = std::get_if<SwingingRoller>(&follower)) {
    positive("an arm length", arm->arm_length);
    positive("a pivot distance", arm->pivot_distance);
  }
  if (const auto* arm = std::get_if<SwingingFace>(&follower)) {
    positive("a pivot distance", arm->pivot_distance);
  }
}

/// The coordinate where the profile is a circle of that radius.
double coordinate_on(const MeasuredFollower& follower, double base_radius) {
  if (!(base_radius > 0 && std::isfinite(base_radius))) {
    refuse(fmt::format("a base radius of {:.6g} is not above 0", base_radius));
  }
  if (!is_roller(follower)) return face_way(follower, base_radius, 0).coordinate;
  return way_of(follower, base_radius + roller_radius(follower), 0).coordinate;
}

/// The profile as seen in a mirror, where the cam turns counterclockwise.
ProfilePoint mirrored(const ProfilePoint& p) {
  return {std::conj(p.place), -std::conj(p.tangent), std::conj(p.normal), p.curvature, p.speed};
}

}  // namespace

MeasuredLift::State MeasuredLift::state(double theta) const {
  const ProfilePoint point = profile_.at(theta);
  const ProfilePoint seen = rotation_ == Rotation::Clockwise ? mirrored(point) : point;
  return is_roller(follower_) ? roller_state(seen, theta) : face_state(seen, theta);
}

/// (I3) to (I5)
MeasuredLift::State MeasuredLift::roller_state(const ProfilePoint& p, double theta) const {
  const double radius = roller_radius(follower_), shorter = 1 + radius * p.curvature;
  if (!(shorter > 0)) {
    refuse(
        fmt::format("the roller of radius {:.6g} does not fit into the hollow of radius {:.6g} {}",
                    radius, -1 / p.curvature, place_of(theta)));
  }
  const Complex z = p.place + radius * p.normal;
  Way way = way_of(follower_, std::abs(z), theta);
  if (rotation_ == Rotation::Clockwise) {
    way = {way.coordinate, std::conj(way.w), std::conj(way.g), std::conj(way.bend)};
  }
  const Complex turn = way.w / z;  // exp(i phi)
  const Complex along = -p.tangent * turn, back = std::conj(way.g);
  const double length = -std::real(way.w * back) / std::imag(along * back);
  if (!(length > 0)) {
    refuse(fmt::format("the follower cannot follow {}: the pressure angle passes 90 deg",
                       place_of(theta)));
  }
  const double ds = (length * std::real(along * back) - std::imag(way.w * back)) / std::norm(way.g);
  const Complex w1 = length * along;
  const Complex rest = way.bend * ds * ds - 2.0 * kI * way.g * ds - way.w;  // w2 but for s''
  const double curvature = p.curvature / shorter;
  const double dds = (curvature * length * length * length - std::imag(std::conj(rest) * w1)) /
                     std::imag(back * w1);
  return {std::arg(turn),
          way.coordinate,
          ds,
          dds,
          shorter * p.speed / length,
          1 / std::real(p.normal * turn * back)};
}

/// (I6), (I7)
MeasuredLift::State MeasuredLift::face_state(const ProfilePoint& p, double theta) const {
  if (!(p.curvature > 0)) {
    refuse(fmt::format("it is hollow {}: a flat face does not touch it there", place_of(theta)));
  }
  const double sense = rotation_ == Rotation::Clockwise ? -1 : 1;
  const Complex seen = p.place * std::conj(p.normal);
  const double height = std::real(seen), aside = std::imag(seen), radius = 1 / p.curvature;
  const FaceWay way = face_way(follower_, height, theta);
  const double lever = way.foot_rate + (way.swings ? sense * aside : 0);
  if (!(lever > 0)) {
    refuse(
        fmt::format("the face cannot follow {}: it is touched behind its pivot", place_of(theta)));
  }
  const double ds = -aside / lever;
  const double turning = way.swings ? 1 + sense * ds : 1;  // how fast the normal turns
  const double dds = ((radius - height) * turning * turning + way.height_bend * ds * ds) / lever;
  const double normal = sense * (kPi / 2 - (way.swings ? way.coordinate : 0));
  return {normal - std::arg(p.normal),     way.coordinate, ds, dds,
          p.curvature * p.speed / turning, 1 / lever};
}

MeasuredLift::MeasuredLift(MeasuredProfile profile, const MeasuredFollower& follower,
                           Rotation rotation, std::optional<double> base_radius)
    : profile_(std::move(profile)), follower_(follower), rotation_(rotation) {
  check_follower(follower_);
  follow();
  zero_ = base_radius ? coordinate_on(follower_, *base_radius) : lowest_;
}

/// Goes round once. The cam angle is monotone in the polar angle of the contact where the follower
/// follows.
void MeasuredLift::follow() {
  // As many places that no wave of the spline hides between two.
  const std::size_t count = std::max<std::size_t>(8 * profile_.spline().basis().spans(), 720);
  std::vector<double> coordinates;
  for (std::size_t i = 0; i <= count; ++i) {
    const double theta = kTurn * static_cast<double>(i) / static_cast<double>(count);
    const State here = state(theta);
    const double step = i == 0 ? 0 : std::remainder(here.phi - phis_.back(), kTurn);
    thetas_.push_back(theta);
    phis_.push_back(i == 0 ? here.phi : phis_.back() + step);
    coordinates.push_back(here.coordinate);
  }
  const auto [low, high] = std::minmax_element(coordinates.begin(), coordinates.end());
  lowest_ = extreme(static_cast<std::size_t>(low - coordinates.begin()), 1);
  highest_ = extreme(static_cast<std::size_t>(high - coordinates.begin()), -1);
}

/// The least of sign * coordinate near a place.
double MeasuredLift::extreme(std::size_t at, double sign) const {
  const double step = thetas_[1] - thetas_[0];
  constexpr int kBits = 26;  // half of the digits: the coordinate is level there
  const auto [theta, least] =
      boost::math::tools::brent_find_minima([&](double x) { return sign * state(x).coordinate; },
                                            thetas_[at] - step, thetas_[at] + step, kBits);
  return sign * std::min(least, sign * state(thetas_[at]).coordinate);
}

MeasuredMotion MeasuredLift::at(double phi) const {
  const bool rising = phis_.back() > phis_.front();
  const double low = rising ? phis_.front() : phis_.back();
  const double wanted = low + (phi - low) - kTurn * std::floor((phi - low) / kTurn);
  const auto before = [&](double a, double b) { return rising ? a < b : a > b; };
  const auto next = std::upper_bound(phis_.begin() + 1, phis_.end() - 1, wanted, before);
  const auto i = static_cast<std::size_t>(next - phis_.begin());
  const auto miss = [&](double theta) { return std::remainder(state(theta).phi - wanted, kTurn); };
  double theta = thetas_[i - 1];
  const double left = miss(thetas_[i - 1]), right = miss(thetas_[i]);
  if (left * right < 0) {
    std::uintmax_t steps = 60;
    const auto bracket =
        boost::math::tools::toms748_solve(miss, thetas_[i - 1], thetas_[i], left, right,
                                          boost::math::tools::eps_tolerance<double>(50), steps);
    theta = std::midpoint(bracket.first, bracket.second);
  } else if (std::abs(right) < std::abs(left)) {
    theta = thetas_[i];
  }
  const State here = state(theta);
  const ProfilePoint point = profile_.at(theta);
  const auto& r = profile_.spline();
  // (I8) A change of r shifts the profile along its normal by the cosine of the angle between.
  const double share = here.share * std::abs(point.place) / point.speed, rate = 1 / here.rate;
  return {phi,
          theta,
          here.coordinate - zero_,
          here.ds,
          here.dds,
          share * r.standard_error(theta),
          share * rate * r.standard_error(theta, 1),
          share * rate * rate * r.standard_error(theta, 2)};
}

Law<double> MeasuredLift::law(int angles) const {
  constexpr int kLeast = 12;
  if (angles < kLeast) {
    refuse(fmt::format("{} angles are too few for a law, {} are needed", angles, kLeast));
  }
  std::vector<double> x, s, v;
  for (int i = 0; i <= angles; ++i) {
    x.push_back(static_cast<double>(i) / angles);
    const MeasuredMotion here = at(i < angles ? kTurn * x.back() : 0);
    s.push_back((here.s - lowest()) / stroke());
    v.push_back(here.ds * kTurn / stroke());
  }
  return table<double>(x, s, v).with_ends({End::Motion, End::Motion});
}

}  // namespace camlaw::problems
