// SPDX-License-Identifier: MIT
#include "output/export/inspection.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "output/export/chords.h"

namespace camlaw::problems {

std::vector<InspectionPoint> inspection_points(const PlaneCurve& profile, double step) {
  constexpr double kCorner = 1e-6;  // rad
  const int count = count_steps(profile.end() - profile.begin(), step, "deg");
  const double side = outside_is_left(profile) ? 1 : -1;
  const auto normal_of = [&](optim::Place place) {
    const Eigen::Vector2d slope = profile.at(place).slope;
    return Eigen::Vector2d(side * Eigen::Vector2d(-slope.y(), slope.x()).normalized());
  };
  std::vector<InspectionPoint> points;
  for (int i = 0; i < count + (profile.is_closed() ? 0 : 1); ++i) {
    const bool last = i == count;
    const double angle = optim::even_place(profile.begin(), profile.end(), count, i).angle;
    const optim::Place right{angle, last};
    // Before the first place of a closed profile comes its last one.
    const optim::Place left =
        i > 0 ? optim::Place{angle, true}
              : (profile.is_closed() ? optim::Place{profile.end(), true} : right);
    const Eigen::Vector2d before = normal_of(left), normal = normal_of(right);
    if (!((normal - before).norm() <= kCorner)) continue;
    points.push_back({angle, profile.at(right).at, normal});
  }
  return points;
}

std::string inspection_text(const std::vector<InspectionPoint>& points, const std::string& unit,
                            double tolerance, int decimals,
                            const std::vector<std::string>& comments) {
  // A direction with nine decimals leaves 1e-7 mm over 100 mm; four digits tell a tolerance as it
  // is stated.
  constexpr int kDirection = 9, kSignificant = 4;
  // The tolerance is not rounded to the coordinates' decimals: it would be another one.
  const int fine =
      std::max(decimals, static_cast<int>(std::ceil(-std::log10(tolerance))) + kSignificant - 1);
  std::string text;
  for (const std::string& comment : comments) text += "# " + comment + "\n";
  text += fmt::format(
      "point,cam_angle [deg],x [{0}],y [{0}],z [{0}],i,j,k,lower [{0}],upper [{0}]\n", unit);
  int number = 0;
  for (const InspectionPoint& p : points) {
    const Eigen::Vector2d at = rounded(p.at, decimals), normal = rounded(p.normal, kDirection);
    text +=
        fmt::format("{0},{1:.6f},{2:.{8}f},{3:.{8}f},{4:.{8}f},{5:.{9}f},{6:.{9}f},0,{7:.{10}f},",
                    ++number, p.angle, at.x(), at.y(), 0.0, normal.x(), normal.y(), -tolerance,
                    decimals, kDirection, fine) +
        fmt::format("{:.{}f}\n", tolerance, fine);
  }
  return text;
}

}  // namespace camlaw::problems
