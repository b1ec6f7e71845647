// SPDX-License-Identifier: MIT
#include "output/export/bore.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "machines/model/known_names.h"
#include "problems/statement/parameters.h"

namespace camlaw::problems {

using Eigen::Vector2d;

std::optional<double> own_size(const ProblemStatement& design, std::string_view name) {
  if (!parameter_called(*design.mechanism, name)) return {};
  return constant_of(design, name);
}

std::optional<Bore> bore_of(const ProblemStatement& design, std::optional<double> asked_radius,
                            const std::optional<Keyway>& keyway) {
  std::optional<double> radius = asked_radius;
  if (!radius) radius = own_size(design, "bore_radius");
  if (radius && *radius > 0) return Bore{*radius, keyway};
  if (!keyway) return {};
  throw std::invalid_argument("--keyway: the cam has no bore; give one with --bore '25 mm'");
}

BoreOutline outline_of(const Bore& bore, const Vector2d& towards, double least,
                       const std::string& what) {
  constexpr double kPerRadian = 180 / std::numbers::pi;
  const double radius = bore.radius;
  if (radius >= least) {
    throw std::invalid_argument(fmt::format(
        "--bore: a bore of {:.6g} mm in radius reaches {}, which comes as near as {:.6g} mm to the "
        "centre",
        radius, what, least));
  }
  if (!bore.keyway) return {{{0, 0}, radius}};
  const double half = bore.keyway->width / 2, top = radius + bore.keyway->depth;
  if (!(half < radius) || std::hypot(half, top) >= least) {
    throw std::invalid_argument(fmt::format(
        "--keyway: {:.6g} x {:.6g} mm is too large for a bore of {:.6g} mm in radius and {}, which "
        "comes as near as {:.6g} mm to the centre",
        bore.keyway->width, bore.keyway->depth, radius, what, least));
  }
  const double edge = std::sqrt(radius * radius - half * half);
  const double angle = std::asin(half / radius) * kPerRadian;
  const Vector2d out = towards.normalized(), right(out.y(), -out.x());
  const auto place = [&](double across, double up) { return Vector2d(across * right + up * out); };
  double middle = std::atan2(out.y(), out.x()) * kPerRadian;
  if (middle < 0) middle += 360;
  return {{{0, 0}, radius, middle + angle, middle - angle + 360},
          {{place(-half, edge), place(-half, top)},
           {place(-half, top), place(half, top)},
           {place(half, top), place(half, edge)}}};
}

}  // namespace camlaw::problems
