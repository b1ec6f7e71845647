// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "output/answers/export_formats.h"
#include "output/answers/export_output.h"
#include "output/document/formatting.h"

namespace camlaw::cli {
namespace {

/// A row for each point, after warning_head: curve, cam angle, x, y, r, theta, how far the curve
/// departs from the straight line to the next point.
std::string csv_text(const Exported& e) {
  const auto in_unit = [&](const char* name) {
    return fmt::format("{} [{}]", name, e.accuracy.unit.name);
  };
  std::vector<std::vector<std::string>> rows{{"curve", "cam_angle [deg]", in_unit("x"),
                                              in_unit("y"), in_unit("r"), "theta [deg]",
                                              in_unit("deviation to the next point")}};
  const int decimals = e.accuracy.decimals;
  const auto fixed = [&](double value) {
    return fmt::format("{:.{}f}", problems::rounded(value, decimals), decimals);
  };
  for (const problems::ExportedCurve& curve : e.curves) {
    for (const auto& point : std::get<problems::Chords>(curve.path).points) {
      const double theta = std::atan2(point.at.y(), point.at.x()) * 180 / std::numbers::pi;
      rows.push_back({curve.name, exact(point.angle), fixed(point.at.x()), fixed(point.at.y()),
                      fixed(point.at.norm()), fixed(theta),
                      fmt::format("{:.3e}", point.deviation)});
    }
  }
  return warning_head(e) + to_csv(rows);
}

}  // namespace

FormatRow csv_format() {
  return {
      .name = "csv", .endings = {".csv"}, .forms = {problems::CurveForm::Lines}, .text = csv_text};
}

}  // namespace camlaw::cli
