// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "output/export/plane_curve.h"

/// A profile as a coordinate measuring machine checks it: nominal points, normals, tolerance.
namespace camlaw::problems {

struct InspectionPoint {
  double angle;                ///< of the cam, deg
  Eigen::Vector2d at, normal;  ///< the normal has length 1 and points away from the cam
};

/// Points at even steps of the cam angle, deg; a closed profile's last is not its first again.
/// Where the profile has a corner there is no normal, and no point. The profile must not turn back.
std::vector<InspectionPoint> inspection_points(const PlaneCurve& profile, double step);

/// A row for each point: number, cam angle, x, y, z = 0, the normal i, j, k = 0, and how far the
/// profile may be below and above the nominal one along it; all lengths in the curve's unit. Points
/// are rounded to the decimals, normals to 9; the tolerance, above 0, has at least 4 digits.
/// `comments` begin with '#'.
std::string inspection_text(const std::vector<InspectionPoint>& points, const std::string& unit,
                            double tolerance, int decimals,
                            const std::vector<std::string>& comments);

}  // namespace camlaw::problems
