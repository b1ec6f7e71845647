// SPDX-License-Identifier: MIT
#include "fitting/cams/measured_lift.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "fitting/cams/measured_refusal.h"
#include "kinematics/laws/spline.h"
#include "numerics/tables/turn.h"

namespace camlaw::problems {
namespace {

using Complex = std::complex<double>;
constexpr double kPi = std::numbers::pi;
constexpr Complex kI{0, 1};

using measured::fault, measured::refuse;

/// The polar angle as people read it, 0 to 360 deg.
std::string place_of(double theta) {
  return fmt::format("at a polar angle of {:.4g} deg", in_turn(theta) / kDegree);
}

/// The follower while the profile's point at theta is the one that it touches.
struct Touch {
  double phi, coordinate, ds, dds;
  double rate;   ///< |dphi / dtheta|
  double share;  ///< of a small shift of the profile along its normal that the follower makes
};

/// A roller's centre by the follower's coordinate q: w, g = dw / dq and dg / dq.
struct Way {
  double coordinate;
  Complex w, g, bend;
};

Possible<Way> way_at(const TranslatingRoller& follower, double distance, double theta) {
  const double e = follower.offset;
  if (!(std::abs(e) < distance)) {
    return fault(
        fmt::format("the offset {:.6g} is not less than the distance {:.6g} of the roller's "
                    "centre {}",
                    e, distance, place_of(theta)));
  }
  const double y = std::sqrt((distance - e) * (distance + e));
  return Way{y, {e, y}, kI, 0};
}

Possible<Way> way_at(const OscillatingRoller& follower, double distance, double theta) {
  const double l = follower.arm_length, d = follower.pivot_distance;
  const double cosine = (l * l + d * d - distance * distance) / (2 * l * d);
  if (!(std::abs(cosine) < 1)) {
    return fault(
        fmt::format("an arm of {:.6g} with its pivot at {:.6g} does not reach the roller's "
                    "centre, {:.6g} from the cam's, {}",
                    l, d, distance, place_of(theta)));
  }
  const double psi = std::acos(cosine);
  const Complex arm = std::polar(l, -psi);
  return Way{psi, d - arm, kI * arm, arm};
}

double roller_radius(const MeasuredFollower& follower) {
  if (const auto* roller = std::get_if<TranslatingRoller>(&follower)) return roller->roller_radius;
  if (const auto* roller = std::get_if<OscillatingRoller>(&follower)) return roller->roller_radius;
  return 0;
}

bool is_roller(const MeasuredFollower& follower) {
  return std::holds_alternative<TranslatingRoller>(follower) ||
         std::holds_alternative<OscillatingRoller>(follower);
}

Possible<Way> way_of(const MeasuredFollower& follower, double distance, double theta) {
  const auto* arm = std::get_if<OscillatingRoller>(&follower);
  return arm ? way_at(*arm, distance, theta)
             : way_at(std::get<TranslatingRoller>(follower), distance, theta);
}

/// A face at the height H over the cam's centre: its coordinate, how fast its foot moves by it, and
/// what turns with it.
struct FaceWay {
  double coordinate, foot_rate, height_bend;
  bool swings;
};

Possible<FaceWay> face_way(const MeasuredFollower& follower, double height, double theta) {
  const auto* arm = std::get_if<OscillatingFace>(&follower);
  if (!arm) return FaceWay{height, 1, 0, false};
  const double sine = (height + arm->face_offset) / arm->pivot_distance;
  if (!(std::abs(sine) < 1)) {
    return fault(fmt::format("a face {:.6g} from its pivot at {:.6g} does not lie on the cam {}",
                             arm->face_offset, arm->pivot_distance, place_of(theta)));
  }
  const double psi = std::asin(sine);
  return FaceWay{psi, arm->pivot_distance * std::cos(psi), arm->pivot_distance * sine, true};
}

std::optional<Impossible> bad_follower(const MeasuredFollower& follower) {
  const double radius = roller_radius(follower);
  if (!(radius >= 0 && std::isfinite(radius))) {
    return fault(fmt::format("a roller radius of {:.6g} is below 0", radius));
  }
  const auto unless_positive = [](const char* name, double value) -> std::optional<Impossible> {
    if (value > 0 && std::isfinite(value)) return {};
    return fault(fmt::format("{} of {:.6g} is not above 0", name, value));
  };
  if (const auto* arm = std::get_if<OscillatingRoller>(&follower)) {
    if (auto bad = unless_positive("an arm length", arm->arm_length)) return bad;
    return unless_positive("a pivot distance", arm->pivot_distance);
  }
  if (const auto* arm = std::get_if<OscillatingFace>(&follower)) {
    return unless_positive("a pivot distance", arm->pivot_distance);
  }
  return {};
}

/// The coordinate where the profile is a circle of that radius.
Possible<double> coordinate_on(const MeasuredFollower& follower, double base_radius) {
  if (!(base_radius > 0 && std::isfinite(base_radius))) {
    return fault(fmt::format("a base radius of {:.6g} is not above 0", base_radius));
  }
  if (!is_roller(follower)) {
    const auto way = face_way(follower, base_radius, 0);
    if (!way) return way.reason();
    return way->coordinate;
  }
  const auto way = way_of(follower, base_radius + roller_radius(follower), 0);
  if (!way) return way.reason();
  return way->coordinate;
}

/// The inverse of coordinate_on.
double radius_at(const MeasuredFollower& follower, double coordinate) {
  if (const auto* face = std::get_if<OscillatingFace>(&follower)) {
    return face->pivot_distance * std::sin(coordinate) - face->face_offset;
  }
  if (const auto* arm = std::get_if<OscillatingRoller>(&follower)) {
    const double l = arm->arm_length, d = arm->pivot_distance;
    return std::sqrt(l * l + d * d - 2 * l * d * std::cos(coordinate)) - arm->roller_radius;
  }
  const auto* roller = std::get_if<TranslatingRoller>(&follower);
  return roller ? std::hypot(roller->offset, coordinate) - roller->roller_radius : coordinate;
}

/// The profile as seen in a mirror, where the cam turns counterclockwise.
ProfilePoint mirrored(const ProfilePoint& p) {
  return {std::conj(p.place), -std::conj(p.tangent), std::conj(p.normal), p.curvature, p.speed};
}

/// (I3) to (I5)
Possible<Touch> roller_touch(const ProfilePoint& p, const MeasuredFollower& follower,
                             Rotation rotation, double theta) {
  const double radius = roller_radius(follower), shorter = 1 + radius * p.curvature;
  if (!(shorter > 0)) {
    return fault(
        fmt::format("the roller of radius {:.6g} does not fit into the hollow of radius {:.6g} {}",
                    radius, -1 / p.curvature, place_of(theta)));
  }
  const Complex z = p.place + radius * p.normal;
  const auto found = way_of(follower, std::abs(z), theta);
  if (!found) return found.reason();
  Way way = *found;
  if (rotation == Rotation::Clockwise) {
    way = {way.coordinate, std::conj(way.w), std::conj(way.g), std::conj(way.bend)};
  }
  const Complex turn = way.w / z;  // exp(i phi)
  const Complex along = -p.tangent * turn, back = std::conj(way.g);
  const double length = -std::real(way.w * back) / std::imag(along * back);
  if (!(length > 0)) {
    return fault(fmt::format("the follower cannot follow {}: the pressure angle exceeds 90 deg",
                             place_of(theta)));
  }
  const double ds = (length * std::real(along * back) - std::imag(way.w * back)) / std::norm(way.g);
  const Complex w1 = length * along;
  const Complex rest = way.bend * ds * ds - 2.0 * kI * way.g * ds - way.w;  // w2 but for s''
  const double curvature = p.curvature / shorter;
  const double dds = (curvature * length * length * length - std::imag(std::conj(rest) * w1)) /
                     std::imag(back * w1);
  return Touch{std::arg(turn),
               way.coordinate,
               ds,
               dds,
               shorter * p.speed / length,
               1 / std::real(p.normal * turn * back)};
}

/// (I6), (I7)
Possible<Touch> face_touch(const ProfilePoint& p, const MeasuredFollower& follower,
                           Rotation rotation, double theta) {
  if (!(p.curvature > 0)) {
    return fault(
        fmt::format("it is hollow {}, where a flat face does not touch it", place_of(theta)));
  }
  const double sense = rotation == Rotation::Clockwise ? -1 : 1;
  const Complex seen = p.place * std::conj(p.normal);
  const double height = std::real(seen), aside = std::imag(seen), radius = 1 / p.curvature;
  const auto found = face_way(follower, height, theta);
  if (!found) return found.reason();
  const FaceWay& way = *found;
  const double lever = way.foot_rate + (way.swings ? sense * aside : 0);
  if (!(lever > 0)) {
    return fault(fmt::format("the face cannot follow {}: the contact lies behind its pivot",
                             place_of(theta)));
  }
  const double ds = -aside / lever;
  const double turning = way.swings ? 1 + sense * ds : 1;  // how fast the normal turns
  const double dds = ((radius - height) * turning * turning + way.height_bend * ds * ds) / lever;
  const double normal = sense * (kPi / 2 - (way.swings ? way.coordinate : 0));
  return Touch{normal - std::arg(p.normal),     way.coordinate, ds, dds,
               p.curvature * p.speed / turning, 1 / lever};
}

Possible<Touch> touch_at(const MeasuredProfile& profile, const MeasuredFollower& follower,
                         Rotation rotation, double theta) {
  const ProfilePoint point = profile.at(theta);
  const ProfilePoint seen = rotation == Rotation::Clockwise ? mirrored(point) : point;
  return is_roller(follower) ? roller_touch(seen, follower, rotation, theta)
                             : face_touch(seen, follower, rotation, theta);
}

}  // namespace

/// Goes round once. The cam angle is monotone in the polar angle of the contact where the follower
/// follows.
std::optional<Impossible> MeasuredLift::follow(std::optional<double> base_radius) {
  if (auto bad = bad_follower(follower_)) return bad;
  const auto touch = [&](double theta) { return touch_at(profile_, follower_, rotation_, theta); };
  // As many places that no wave of the spline hides between two.
  const std::size_t count = std::max<std::size_t>(8 * profile_.spline().basis().spans(), 720);
  std::vector<double> coordinates;
  for (std::size_t i = 0; i <= count; ++i) {
    const double theta = kTurn * static_cast<double>(i) / static_cast<double>(count);
    const auto here = touch(theta);
    if (!here) return here.reason();
    const double step = i == 0 ? 0 : std::remainder(here->phi - phis_.back(), kTurn);
    thetas_.push_back(theta);
    phis_.push_back(i == 0 ? here->phi : phis_.back() + step);
    coordinates.push_back(here->coordinate);
  }
  std::optional<Impossible> between;  // the places
  // The least of sign * coordinate near a place.
  const auto extreme = [&](auto at, double sign) {
    const double middle = thetas_[static_cast<std::size_t>(at - coordinates.begin())];
    const double step = thetas_[1] - thetas_[0];
    constexpr int kBits = 26;  // half of the digits: the coordinate is level there
    const auto [theta, least] = boost::math::tools::brent_find_minima(
        [&](double x) {
          const auto here = touch(x);
          if (here) return sign * here->coordinate;
          if (!between) between = here.reason();
          return std::numeric_limits<double>::infinity();
        },
        middle - step, middle + step, kBits);
    return sign * std::min(least, sign * *at);
  };
  const auto [low, high] = std::minmax_element(coordinates.begin(), coordinates.end());
  lowest_ = extreme(low, 1);
  highest_ = extreme(high, -1);
  zero_ = lowest_;
  if (between || !base_radius) return between;
  const auto zero = coordinate_on(follower_, *base_radius);
  if (!zero) return zero.reason();
  zero_ = *zero;
  return {};
}

MeasuredLift::MeasuredLift(MeasuredProfile profile, const MeasuredFollower& follower,
                           Rotation rotation, std::optional<double> base_radius)
    : MeasuredLift(possible(std::move(profile), follower, rotation, base_radius).value()) {}

Possible<MeasuredLift> MeasuredLift::possible(MeasuredProfile profile,
                                              const MeasuredFollower& follower, Rotation rotation,
                                              std::optional<double> base_radius) {
  MeasuredLift lift(Unfollowed{}, std::move(profile), follower, rotation);
  if (auto why = lift.follow(base_radius)) return std::move(*why);
  return lift;
}

MeasuredMotion MeasuredLift::at(double phi) const {
  const bool rising = phis_.back() > phis_.front();
  const double low = rising ? phis_.front() : phis_.back();
  const double wanted = low + in_turn(phi - low);
  const auto before = [&](double a, double b) { return rising ? a < b : a > b; };
  const auto next = std::upper_bound(phis_.begin() + 1, phis_.end() - 1, wanted, before);
  const auto i = static_cast<std::size_t>(next - phis_.begin());
  const auto touch = [&](double theta) {
    return touch_at(profile_, follower_, rotation_, theta).value();
  };
  const auto miss = [&](double theta) { return std::remainder(touch(theta).phi - wanted, kTurn); };
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
  const Touch here = touch(theta);
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

double MeasuredLift::base_radius(double s) const { return radius_at(follower_, zero_ + s); }

std::vector<LiftSample> MeasuredLift::samples() const { return possible_samples().value(); }

Possible<std::vector<LiftSample>> MeasuredLift::possible_samples() const {
  std::vector<LiftSample> result;
  const std::vector<double>& thetas = profile_.polar_angles();
  for (std::size_t k = 0; k < thetas.size(); ++k) {
    const auto touch = touch_at(profile_, follower_, rotation_, thetas[k]);
    if (!touch) return touch.reason();
    const Touch& here = *touch;
    const ProfilePoint point = profile_.at(thetas[k]);
    const optim::SmoothedSample& sample = profile_.spline().samples()[k];
    const double cosine = std::abs(point.place) / point.speed;  // (I8)
    const double along_normal = sample.residual * cosine;
    result.push_back({in_turn(here.phi), here.coordinate - zero_ + here.share * along_normal,
                      along_normal, sample.outlying, here.share * cosine, here.share,
                      point.normal});
  }
  return result;
}

Law<double> MeasuredLift::law(int angles) const {
  constexpr int kLeast = 12;  // the order of the spline, a few spans and some angles to tell it by
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
