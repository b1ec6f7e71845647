// SPDX-License-Identifier: MIT
#include "output/export/largest_tool.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "output/export/interference.h"

namespace camlaw::problems {
namespace {

/// The sharpest hollow that is met at steps of a twentieth of a degree, and where it is.
struct Hollow {
  double radius = std::numeric_limits<double>::infinity();  ///< mm
  double angle = 0;                                         ///< deg
};

/// With q' = p' (1 - d k) of the curve at the distance d (PlaneCurve::beside), k = (1 - q'.p' /
/// p'.p') / d.
Hollow sharpest_hollow(const PlaneCurve& profile) {
  constexpr double kStep = 0.05, kBeside = 1;  // deg, mm
  const PlaneCurve beside = path_of_tool(profile, kBeside);
  Hollow least;
  for (std::size_t k = 0; k + 1 < profile.breaks().size(); ++k) {
    const double from = profile.breaks()[k], to = profile.breaks()[k + 1];
    const int count = static_cast<int>(std::ceil((to - from) / kStep));
    for (int i = 0; i <= count; ++i) {
      const optim::Place place = optim::even_place(from, to, count, i);
      const Eigen::Vector2d along = profile.look(place).slope;
      const double curvature =
          (1 - beside.look(place).slope.dot(along) / along.squaredNorm()) / kBeside;
      if (curvature > 0 && 1 / curvature < least.radius) least = {1 / curvature, place.angle};
    }
  }
  return least;
}

/// Whether a tool fits, and if not what it cuts.
struct ToolFit {
  bool fits = false, proved = false;
  double cuts_at = 0;  ///< deg
};

ToolFit fit_of(const PlaneCurve& profile, const Chords& lines, double radius) {
  const PlaneCurve path = path_of_tool(profile, radius);
  const Turning turn = turning(path);
  if (turn.angle) return {.cuts_at = *turn.angle};
  const Interference cut = interference(followed(path), lines, radius);
  if (cut.depth > cut.certain) return {.cuts_at = cut.profile_angle};
  return {.fits = true, .proved = turn.proved && cut.proved};
}

}  // namespace

LargestTool largest_tool(const PlaneCurve& profile, double most) {
  constexpr double kBelow = 1e-4;  // of a hollow's radius: more than the steps miss
  constexpr double kShare = 1e-3;  // of the radius, to which it is found
  constexpr int kProofs = 3;       // a proof may need a little more room than the truth
  const Hollow hollow = sharpest_hollow(profile);
  const double beside_hollow = (1 - kBelow) * hollow.radius;
  LargestTool result;
  if (beside_hollow < most) result.cuts_at = hollow.angle;
  double low = 0, high = std::min(beside_hollow, most);
  ToolFit fit;
  const Chords lines = followed(profile);
  const auto look = [&](double radius) {
    const ToolFit found = fit_of(profile, lines, radius);
    if (found.fits) {
      low = radius, fit = found;
    } else {
      high = radius, result.cuts_at = found.cuts_at;
    }
  };
  look(high);
  while (low < (1 - kShare) * high && high > kShare * most) look(std::midpoint(low, high));
  for (int i = 0; i < kProofs && fit.fits && !fit.proved; ++i) {
    if (!result.cuts_at) result.cuts_at = hollow.angle;
    const ToolFit found = fit_of(profile, lines, (1 - kShare) * low);
    low *= 1 - kShare, fit.proved = found.fits && found.proved;
  }
  result.radius = low, result.proved = fit.proved;
  return result;
}

double least_hollow_arc(const ExportedCurve& written, bool outside_is_left) {
  double least = std::numeric_limits<double>::infinity();
  if (const auto* arcs = std::get_if<ArcPath>(&written.path)) {
    for (const ArcPiece& piece : arcs->pieces) {
      // The centre of an arc that turns left is on the left.
      const bool hollow = !piece.is_line() && (piece.sweep > 0) == outside_is_left;
      if (hollow) least = std::min(least, piece.radius());
    }
  }
  return least;
}

}  // namespace camlaw::problems
