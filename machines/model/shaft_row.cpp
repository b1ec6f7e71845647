// SPDX-License-Identifier: MIT
#include "machines/model/shaft_row.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numbers>

#include "machines/model/enclosed.h"
#include "machines/model/joint_angle.h"

namespace camlaw::problems {
namespace {

using optim::packed, optim::packed_size;

constexpr double kRadian = std::numbers::pi / 180;  // of a degree

/// Adds a (x) b + b (x) a to a packed symmetric matrix, times a factor.
void add_products(const std::vector<double>& a, const std::vector<double>& b, double factor,
                  std::vector<double>& h) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k <= i; ++k) {
      h[packed(i, k)] += factor * (a[i] * b[k] + a[k] * b[i]);
    }
  }
}

}  // namespace

/// None where the break stands on the shaft.
std::optional<ShaftRow::Tied> ShaftRow::tied_by(const ShaftParts& parts, optim::Place place) {
  if (place.joint < 0) return {};
  const std::size_t cam = parts.cam_of(place.joint);
  const int own = parts.own_of(place.joint);  // 0 is the end of the cycle
  const ShaftParts::Held& held = parts.held[cam];
  Tied tied{cam, -1, still_angle(0)};
  if (own > 0 && held.curve->breaks_move()) {
    tied.joint = own - 1;
    tied.angle = *held.curve->joint_angle(tied.joint);
  } else if (own > 0) {
    tied.angle = still_angle(held.breaks[static_cast<std::size_t>(own) - 1]);
  }
  if (!held.phase_variable && tied.angle.inputs().empty()) return {};
  return tied;
}

ShaftRow::ShaftRow(std::shared_ptr<const ShaftParts> parts, optim::Place place, bool by_angle)
    : parts_(std::move(parts)),
      place_(place),
      by_angle_(by_angle),
      tied_(by_angle ? std::nullopt : tied_by(*parts_, place)),
      moves_(by_angle || tied_ || parts_->phases_vary()) {
  inputs_ = parts_->arguments;
  for (const ShaftParts::Held& held : parts_->held) {
    if (moves_) {
      inputs_.insert(inputs_.end(), held.variables.begin(), held.variables.end());
      if (held.phase_variable) inputs_.push_back(*held.phase_variable);
      continue;
    }
    still_.push_back(
        held.curve->at(cam_place(place.angle, place.from_left, held.phase, held.breaks)));
    const auto& its = still_.back().inputs();
    inputs_.insert(inputs_.end(), its.begin(), its.end());
  }
  std::sort(inputs_.begin(), inputs_.end());
  inputs_.erase(std::unique(inputs_.begin(), inputs_.end()), inputs_.end());
}

std::size_t ShaftRow::input_of(std::size_t variable) const {
  return static_cast<std::size_t>(std::lower_bound(inputs_.begin(), inputs_.end(), variable) -
                                  inputs_.begin());
}

/// As long as the inputs need; what they do not name is not looked at.
std::vector<double> ShaftRow::design_at(std::span<const double> u) const {
  std::vector<double> x(inputs_.empty() ? 0 : inputs_.back() + 1);
  for (std::size_t i = 0; i < u.size(); ++i) x[inputs_[i]] = u[i];
  return x;
}

/// The break of a cam that the place is tied to, turned by the cam's phase.
ShaftRow::Turned ShaftRow::turned(optim::Design x, const ShaftParts::Traces& traces,
                                  int order) const {
  const std::size_t n = inputs_.size() + 1;
  Turned result{place_.angle, std::vector<double>(n),
                std::vector<double>(order == 2 ? packed_size(n) : 0)};
  if (by_angle_) result.slope.back() = 1;
  if (!tied_) return result;
  const optim::Function& f = tied_->angle;
  std::vector<double> g(f.inputs().size()), h(order == 2 ? packed_size(g.size()) : 0);
  const double own = order == 0 ? f.value(x) : order == 1 ? f.gradient(x, g) : f.hessian(x, g, h);
  spread(f, g, h, result.slope, result.bend);
  const ShaftParts::Held& held = parts_->held[tied_->cam];
  result.angle = own + held.phase_at(x);
  result.angle -= 360 * std::round((result.angle - place_.angle) / 360);
  if (held.phase_variable) result.slope[input_of(*held.phase_variable)] += 1;
  result.on_cam =
      cam_place(result.angle, place_.from_left, held.phase_at(x), traces.breaks[tied_->cam]);
  result.on_cam.joint = tied_->joint;
  return result;
}

/// Derivatives by the inputs of f as those by the row's own.
void ShaftRow::spread(const optim::Function& f, const std::vector<double>& g,
                      const std::vector<double>& h, std::vector<double>& first,
                      std::vector<double>& second) const {
  std::vector<std::size_t> at;
  for (const std::size_t variable : f.inputs()) at.push_back(input_of(variable));
  for (std::size_t i = 0; i < at.size(); ++i) {
    first[at[i]] += g[i];
    for (std::size_t j = 0; j <= i && !second.empty(); ++j) {
      second[packed(at[i], at[j])] += h[packed(i, j)];
    }
  }
}

/// With c the cam's curve, p its place and z the inputs:
///   dc/dz = c_z + c_p p_z,
///   d2c/dz2 = c_zz + c_pz (x) p_z + p_z (x) c_pz + c_pp p_z (x) p_z + c_p p_zz.
void ShaftRow::add_curve(std::size_t k, optim::Design x, optim::Place place, const Moves& moves,
                         const ShaftParts::Traces* traces, int order, Point& point) const {
  const optim::Curve& curve = *parts_->held[k].curve;
  const optim::Function own = moves_ ? curve.at(place) : still_[k];
  const std::size_t n = inputs_.size() + 1, m = own.inputs().size();
  if (order == 0) {
    point.value.push_back(own.value(x));
    return;
  }
  std::vector<double> g(m), h(order == 2 ? packed_size(m) : 0);
  point.value.push_back(order == 2 ? own.hessian(x, g, h) : own.gradient(x, g));
  std::vector<double> first(n), second(order == 2 ? packed_size(n) : 0);
  spread(own, g, h, first, second);
  const bool is_moved =
      std::any_of(moves.slope.begin(), moves.slope.end(), [](double d) { return d != 0; });
  if (is_moved && traces != nullptr) {
    const auto along = [&] {
      const std::lock_guard lock(*traces->guard);
      return traces->of[k]->at(place);
    }();
    for (std::size_t i = 0; i < n; ++i) first[i] += along[1] * moves.slope[i];
    if (order == 2) {
      std::vector<double> mixed(n);
      const std::vector<double> whole = curve.slope_gradient(place, x);
      for (std::size_t i = 0; i < inputs_.size() && !whole.empty(); ++i) {
        mixed[i] = whole[inputs_[i]];
      }
      add_products(mixed, moves.slope, 1, second);
      add_products(moves.slope, moves.slope, along[2] / 2, second);
      for (std::size_t i = 0; i < second.size(); ++i) second[i] += along[1] * moves.bend[i];
    }
  }
  point.gradient.push_back(std::move(first));
  point.hessian.push_back(std::move(second));
}

ShaftRow::Point ShaftRow::point(std::span<const double> u, int order) const {
  const std::vector<double> x = design_at(u);
  const std::size_t n = inputs_.size() + 1;
  std::shared_ptr<const ShaftParts::Traces> traces;
  if (moves_) traces = parts_->traces_at(x);
  Point point;
  Turned shaft{place_.angle, std::vector<double>(n), {}};
  if (moves_) shaft = turned(x, *traces, order);
  const auto add_plain = [&](double value, std::vector<double> gradient,
                             std::vector<double> hessian) {
    point.value.push_back(value);
    point.gradient.push_back(std::move(gradient));
    hessian.resize(order == 2 ? packed_size(n) : 0);
    point.hessian.push_back(std::move(hessian));
  };
  for (const std::size_t variable : parts_->arguments) {
    std::vector<double> gradient(n);
    gradient[input_of(variable)] = 1;
    add_plain(x[variable], std::move(gradient), {});
  }
  const auto in_radians = [](std::vector<double> degrees) {
    for (double& d : degrees) d *= kRadian;
    return degrees;
  };
  add_plain(shaft.angle * kRadian, in_radians(shaft.slope), in_radians(shaft.bend));
  for (std::size_t k = 0; k < parts_->held.size(); ++k) {
    const ShaftParts::Held& held = parts_->held[k];
    if (tied_ && tied_->cam == k) {  // its curve knows how its break moves
      const Moves none{std::vector<double>(n), {}};
      add_curve(k, x, shaft.on_cam, none, traces.get(), order, point);
      continue;
    }
    Moves moves{shaft.slope, shaft.bend};
    if (held.phase_variable) moves.slope[input_of(*held.phase_variable)] -= 1;
    const auto& breaks = traces ? traces->breaks[k] : held.breaks;
    add_curve(k, x, cam_place(shaft.angle, place_.from_left, held.phase_at(x), breaks), moves,
              traces.get(), order, point);
  }
  return point;
}

/// By the chain rule, of the formula f of the numbers q: f_q q' and q'^T f_qq q' + f_q q''.
double ShaftRow::chained(const Point& point, std::span<double> g, std::span<double> h) const {
  const std::size_t size = point.value.size(), n = inputs_.size() + 1;
  std::vector<double> own(size), second(h.empty() ? 0 : packed_size(size));
  const double result = h.empty() ? parts_->kernel->gradient(point.value, own)
                                  : parts_->kernel->hessian(point.value, own, second);
  std::fill(g.begin(), g.end(), 0.0);
  std::fill(h.begin(), h.end(), 0.0);
  for (std::size_t a = 0; a < size; ++a) {
    const std::vector<double>& slope = point.gradient[a];
    for (std::size_t i = 0; i < n; ++i) {
      if (slope[i] != 0) g[i] += own[a] * slope[i];
    }
    if (h.empty()) continue;
    std::vector<double> bent(n);  // f_aq q'
    for (std::size_t b = 0; b < size; ++b) {
      const double mixed = second[packed(std::max(a, b), std::min(a, b))];
      for (std::size_t i = 0; mixed != 0 && i < n; ++i) bent[i] += mixed * point.gradient[b][i];
    }
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = 0; k <= i; ++k) {
        if (slope[i] != 0) h[packed(i, k)] += slope[i] * bent[k];
        const double curved = point.hessian[a][packed(i, k)];
        if (curved != 0) h[packed(i, k)] += own[a] * curved;
      }
    }
  }
  return result;
}

double ShaftRow::value(std::span<const double> u) const {
  return parts_->kernel->value(point(u, 0).value);
}

double ShaftRow::gradient(std::span<const double> u, std::span<double> g) const {
  std::vector<double> whole(inputs_.size() + 1);
  const double result = chained(point(u, 1), whole, {});
  std::copy_n(whole.begin(), g.size(), g.begin());
  return result;
}

double ShaftRow::hessian(std::span<const double> u, std::span<double> g,
                         std::span<double> h) const {
  std::vector<double> whole(inputs_.size() + 1), second(packed_size(whole.size()));
  const double result = chained(point(u, 2), whole, second);
  std::copy_n(whole.begin(), g.size(), g.begin());
  std::copy_n(second.begin(), h.size(), h.begin());  // by the angle comes last
  return result;
}

std::vector<double> ShaftRow::slope_gradient(std::span<const double> u) const {
  std::vector<double> whole(inputs_.size() + 1), second(packed_size(whole.size()));
  chained(point(u, 2), whole, second);
  const std::size_t angle = inputs_.size();
  std::vector<double> result;
  for (std::size_t i = 0; i < angle; ++i) result.push_back(second[packed(angle, i)]);
  return result;
}

optim::BoxRange ShaftRow::range(std::span<const optim::Bounds> box) const {
  if (moves_) return Kernel::range(box);
  std::vector<optim::Bounds> design(inputs_.empty() ? 0 : inputs_.back() + 1);
  for (std::size_t i = 0; i < box.size(); ++i) design[inputs_[i]] = box[i];
  std::vector<optim::Bounds> values;
  for (const std::size_t variable : parts_->arguments) values.push_back(design[variable]);
  const Interval angle = Interval(place_.angle) * pi<Interval>() / Interval(180.0);
  values.push_back({angle.lower(), angle.upper()});
  std::vector<optim::BoxRange> curves;
  for (const optim::Function& own : still_) {
    curves.push_back(own.range(design));
    const optim::Bounds& value = curves.back().value;
    if (!std::isfinite(value.lower) || !std::isfinite(value.upper)) return Kernel::range(box);
    values.push_back(value);
  }
  const optim::BoxRange outer = parts_->kernel->range(values);
  std::vector<Interval> slopes(box.size(), Interval(0.0));
  for (std::size_t k = 0; k < parts_->arguments.size(); ++k) {
    slopes[input_of(parts_->arguments[k])] += interval_of(outer.slopes[k]);
  }
  for (std::size_t k = 0; k < curves.size(); ++k) {
    const Interval slope = interval_of(outer.slopes[parts_->arguments.size() + 1 + k]);
    for (std::size_t i = 0; i < curves[k].slopes.size(); ++i) {
      slopes[input_of(still_[k].inputs()[i])] += slope * interval_of(curves[k].slopes[i]);
    }
  }
  optim::BoxRange result{outer.value, {}};
  for (const Interval& slope : slopes) result.slopes.push_back({slope.lower(), slope.upper()});
  return result;
}

}  // namespace camlaw::problems
