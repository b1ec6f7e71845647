// SPDX-License-Identifier: MIT
#include "output/export/plane_curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <numeric>
#include <set>
#include <stdexcept>

#include "machines/cams/cam_shape.h"
#include "output/export/plate_flanks.h"
#include "problems/statement/bind.h"
#include "problems/statement/parameters.h"

namespace camlaw::problems {
namespace {

constexpr int kLooks = 720;  ///< places for what is asked of a curve as a whole

const optim::Response* find_curve(const std::vector<optim::Response>& curves,
                                  const std::string& name) {
  const auto found = std::find_if(curves.begin(), curves.end(),
                                  [&](const auto& curve) { return curve.name == name; });
  return found == curves.end() ? nullptr : &*found;
}

Eigen::Vector2d left_of(const Eigen::Vector2d& v) { return {-v.y(), v.x()}; }

/// What the way from the cam's centre to the curve turns by over the cycle, rad.
double angle_about_centre(const PlaneCurve& curve) {
  double angle = 0;
  Eigen::Vector2d before = curve.look({curve.begin()}).at;
  for (int i = 1; i <= kLooks; ++i) {
    const Eigen::Vector2d here =
        curve.look(optim::even_place(curve.begin(), curve.end(), kLooks, i)).at;
    angle += std::atan2(cross(before, here), before.dot(here));
    before = here;
  }
  return angle;
}

}  // namespace

PlaneCurve::PlaneCurve(std::string name, const optim::Response& x, const optim::Response& y,
                       CurveEnd end, const Eigen::Vector2d& advance)
    : name_(std::move(name)),
      x_(x.curve().trace({})),
      y_(y.curve().trace({})),
      end_(end),
      advance_(advance) {
  std::set<double> all;
  for (const auto* trace : {x_.get(), y_.get()}) {
    for (const double place : trace->breaks()) all.insert(place);
  }
  breaks_.assign(all.begin(), all.end());
  cycle_ = breaks_.back() - breaks_.front();
  cycle_end_ = breaks_.back();
}

optim::Place PlaneCurve::in_cycle(optim::Place place) const {
  const bool is_after = place.angle > cycle_end_ ||
                        (place.angle == cycle_end_ && !place.from_left && end() != cycle_end_);
  if (is_after) place.angle -= cycle_;
  return place;
}

PlaneCurve PlaneCurve::part(std::string name, double from, double to) const {
  PlaneCurve result = *this;
  result.name_ = std::move(name);
  result.end_ = CurveEnd::Part;
  result.breaks_ = {from};
  for (const double after : {0.0, cycle_}) {
    for (const double place : breaks_) {
      const double at = place + after;
      if (at > result.breaks_.back() && at < to) result.breaks_.push_back(at);
    }
  }
  result.breaks_.push_back(to);
  return result;
}

CurvePoint PlaneCurve::look(optim::Place place) const {
  const optim::Place own = in_cycle(place);
  const auto x = x_->at(own), y = y_->at(own);
  CurvePoint point{{x[0], y[0]}, {x[1], y[1]}};
  if (left_ != 0) {
    const Eigen::Vector2d bend(x[2], y[2]);
    const double speed = point.slope.norm();
    const double curvature = cross(point.slope, bend) / (speed * speed * speed);
    point.at += left_ * left_of(point.slope) / speed;
    point.slope *= 1 - left_ * curvature;
  }
  return {scale_ * point.at, scale_ * point.slope};
}

void PlaneCurve::require_point(const Eigen::Vector2d& point, double angle) const {
  if (point.allFinite()) return;
  throw std::invalid_argument(fmt::format(
      "the {} has no point at {:.6g} deg: the motion jumps there, or the cam is impossible", name_,
      angle));
}

CurvePoint PlaneCurve::at(optim::Place place) const {
  const CurvePoint point = look(place);
  require_point(point.at, place.angle);
  return point;
}

std::vector<Eigen::Vector2d> PlaneCurve::points(std::span<const optim::Place> places) const {
  std::vector<Eigen::Vector2d> result;
  if (left_ != 0) {  // which needs slopes
    for (const optim::Place& place : places) result.push_back(at(place).at);
    return result;
  }
  std::vector<optim::Place> own;
  for (const optim::Place& place : places) own.push_back(in_cycle(place));
  const std::vector<double> x = x_->values(own), y = y_->values(own);
  for (std::size_t i = 0; i < places.size(); ++i) {
    result.emplace_back(scale_ * x[i], scale_ * y[i]);
    require_point(result.back(), places[i].angle);
  }
  return result;
}

std::array<double, 3> PlaneCurve::height(optim::Place place) const {
  const auto y = y_->at(in_cycle(place));
  return {scale_ * y[0], scale_ * y[1], scale_ * y[2]};
}

PlaneCurve PlaneCurve::in(const LengthUnit& unit) const {
  PlaneCurve result = *this;
  result.scale_ *= unit_.mm / unit.mm;
  result.unit_ = unit;
  return result;
}

Eigen::Vector2d PlaneCurve::way_over(std::size_t number) const {
  const Eigen::Vector2d before = at({breaks_[number], true}).at;
  if (number + 1 < breaks_.size()) return at({breaks_[number]}).at - before;
  return at({begin()}).at + scale_ * advance_ - before;
}

std::vector<std::pair<double, double>> PlaneCurve::jumps() const {
  std::vector<std::pair<double, double>> result;
  const std::size_t count = breaks_.size() - (goes_on() ? 0 : 1);
  for (std::size_t k = 1; k < count; ++k) {
    const double way = way_over(k).norm();
    if (way > least_jump()) result.emplace_back(breaks_[k], way);
  }
  return result;
}

PlaneCurve PlaneCurve::broken_at(const std::vector<double>& angles) const {
  PlaneCurve result = *this;
  result.breaks_.clear();
  std::set_union(breaks_.begin(), breaks_.end(), angles.begin(), angles.end(),
                 std::back_inserter(result.breaks_));
  return result;
}

PlaneCurve PlaneCurve::beside(std::string name, double distance) const {
  PlaneCurve result = *this;
  result.name_ = std::move(name);
  result.left_ += distance;
  return result;
}

const std::vector<CurveKind>& curve_kinds() {
  static const std::vector<CurveKind> kinds{{"profile", "profile", "profile"},
                                            {"second-profile", "second_profile", "second profile"},
                                            {"pitch", "pitch", "pitch curve"},
                                            {"cutter", "cutter", "cutter path"}};
  return kinds;
}

namespace {

/// Of a machine that does not say how its cam is built: a curve is closed that ends where it began.
CurveEnd end_by_points(const optim::Response& x, const optim::Response& y) {
  const PlaneCurve closed("", x, y, CurveEnd::Returns);
  const Eigen::Vector2d way =
      closed.look({closed.end(), true}).at - closed.look({closed.begin()}).at;
  return way.norm() <= PlaneCurve::kJump ? CurveEnd::Returns : CurveEnd::Ends;
}

PlaneCurve curve_of_cam(const ProblemStatement& statement, const char* name,
                        const optim::Response& x, const optim::Response& y) {
  const auto shape = cam_shape(*statement.mechanism);
  if (!shape) return {name, x, y, end_by_points(x, y)};
  if (*shape == CamShape::Disc) return {name, x, y, CurveEnd::Returns};
  if (*shape == CamShape::Plate) return {name, x, y, CurveEnd::Ends};
  const double circumference = 2 * std::numbers::pi * constant_of(statement, "radius");
  return {name, x, y, CurveEnd::Advances, {circumference, 0}};
}

}  // namespace

std::vector<PlaneCurve> cam_curves(const ProblemStatement& statement, std::string_view option) {
  std::vector<PlaneCurve> result;
  bool known = option == "all";
  std::string options = "all";
  const auto curves = curves_of(statement);
  const bool has_flanks = statement.mechanism->form == Form::ParallelIndex;
  if (has_flanks) result = plate_flanks(statement, curves, option);
  for (const CurveKind& kind : curve_kinds()) {
    options += fmt::format(", {}", kind.option);
    known |= option == kind.option;
    if (has_flanks || (option != "all" && option != kind.option)) continue;
    const auto* x = find_curve(curves, fmt::format("{}_x", kind.response));
    const auto* y = find_curve(curves, fmt::format("{}_y", kind.response));
    if (x != nullptr && y != nullptr) result.push_back(curve_of_cam(statement, kind.name, *x, *y));
  }
  if (!known) {
    throw std::invalid_argument(fmt::format("there is no curve '{}'; use {}", option, options));
  }
  return result;
}

namespace {

constexpr double kTurningStep = 0.1;  // deg, at which turns are looked for

}  // namespace

std::optional<double> turns_back(const PlaneCurve& curve) {
  Eigen::Vector2d before(0, 0);  // the last slope that there was
  const auto turns = [&](optim::Place place) {
    const Eigen::Vector2d slope = curve.at(place).slope;
    const bool back = slope.dot(before) < 0;
    if (slope.norm() > 0) before = slope;
    return back;
  };
  const auto jumps_back = [&](std::size_t number) {
    const Eigen::Vector2d way = curve.way_over(number);
    return way.norm() > curve.least_jump() && way.dot(before) < 0;
  };
  for (std::size_t k = 0; k + 1 < curve.breaks().size(); ++k) {
    const double from = curve.breaks()[k], to = curve.breaks()[k + 1];
    if (k > 0 && jumps_back(k)) return from;
    const int count = static_cast<int>(std::ceil((to - from) / kTurningStep));
    for (int i = 0; i <= count; ++i) {
      const optim::Place place = optim::even_place(from, to, count, i);
      if (turns(place)) return place.angle;
    }
  }
  const bool over_end =
      curve.goes_on() && (jumps_back(curve.breaks().size() - 1) || turns({curve.begin()}));
  if (over_end) return curve.end();
  return {};
}

namespace {

/// Where the slope along a direction changes its sign between two places, by halving: at a cusp the
/// slope is 0.
double cusp_between(const PlaneCurve& curve, double from, double to,
                    const Eigen::Vector2d& direction) {
  while (true) {
    const double middle = std::midpoint(from, to);
    if (!(from < middle && middle < to)) return to;
    (curve.at({middle}).slope.dot(direction) > 0 ? from : to) = middle;
  }
}

}  // namespace

std::vector<double> cusps(const PlaneCurve& curve) {
  std::vector<double> found;
  Eigen::Vector2d before(0, 0);
  for (std::size_t k = 0; k + 1 < curve.breaks().size(); ++k) {
    const double from = curve.breaks()[k], to = curve.breaks()[k + 1];
    if (k > 0 && curve.way_over(k).norm() > curve.least_jump()) before.setZero();
    const int count = static_cast<int>(std::ceil((to - from) / kTurningStep));
    double last = from;
    for (int i = 0; i <= count; ++i) {
      const optim::Place place = optim::even_place(from, to, count, i);
      const Eigen::Vector2d slope = curve.at(place).slope;
      if (slope.dot(before) < 0) {
        found.push_back(i == 0 ? from : cusp_between(curve, last, place.angle, before));
      }
      if (slope.norm() > 0) before = slope;
      last = place.angle;
    }
  }
  return found;
}

Turning turning(const PlaneCurve& curve) {
  constexpr double kFirst = 1.0 / 360, kLeast = 1e-7;  // of the cycle
  Turning result{turns_back(curve)};
  if (result.angle) return result;
  const double cycle = curve.end() - curve.begin();
  const auto keeps_on = [&](auto& self, double from, double to) -> bool {
    if (to - from <= kFirst * cycle && curve.keeps_on(from, to)) return true;
    if (to - from < kLeast * cycle) return false;
    const double middle = std::midpoint(from, to);
    return self(self, from, middle) && self(self, middle, to);
  };
  result.proved = true;
  for (std::size_t k = 0; k + 1 < curve.breaks().size() && result.proved; ++k) {
    result.proved = keeps_on(keeps_on, curve.breaks()[k], curve.breaks()[k + 1]);
  }
  return result;
}

bool winds_left(const PlaneCurve& curve) { return angle_about_centre(curve) > 0; }

bool outside_is_left(const PlaneCurve& profile) {
  // To the right of a path that runs counterclockwise is outside; a plate's runs to greater x, and
  // above it is to the left.
  if (profile.is_about_centre()) return !winds_left(profile);
  return profile.at({profile.end(), true}).at.x() >= profile.at({profile.begin()}).at.x();
}

PlaneCurve path_of_tool(const PlaneCurve& profile, double tool_radius) {
  // "cam 1 driving profile" is one of several, "second profile" is the only one on its cam.
  constexpr std::string_view kProfile = "profile";
  const std::string before = profile.name().substr(0, profile.name().size() - kProfile.size());
  const std::string name = (before.starts_with("cam ") ? before : "") + "cutter path";
  return profile.beside(name, outside_is_left(profile) ? tool_radius : -tool_radius);
}

}  // namespace camlaw::problems
