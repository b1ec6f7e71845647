// SPDX-License-Identifier: MIT
#include "output/export/drawn_follower.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "output/export/follower_places.h"
#include "output/export/plane_curve.h"
#include "problems/statement/bind.h"
#include "problems/statement/parameters.h"

namespace camlaw::problems {
namespace {

using Eigen::Vector2d;

constexpr const char* kLayer = "FOLLOWER";

/// What a curve of the machine has at the beginning of the cycle, and its range.
struct CurveRange {
  double first, low, high;
};

CurveRange range_of(const ProblemStatement& design, const char* name) {
  constexpr int kPlaces = 1440;  // a quarter of a degree: the range is drawn, not printed
  for (const optim::Response& response : curves_of(design)) {
    if (response.name != name) continue;
    const auto trace = response.curve().trace({});
    const auto breaks = trace->breaks();
    const auto values = trace->values(optim::even_places(breaks.front(), breaks.back(), kPlaces));
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    return {values.front(), *low, *high};
  }
  throw std::logic_error(std::string("no curve ") + name);
}

double first_of(const ProblemStatement& design, const char* name) {
  return range_of(design, name).first;
}

void draw_roller(const Vector2d& centre, double radius, double mark, Drawing& drawing) {
  drawing.arc(kLayer, centre, radius);
  drawing.cross(kLayer, centre, mark);
}

void draw_pivot(const Vector2d& at, double mark, Drawing& drawing) {
  drawing.arc(kLayer, at, 2 * mark);
  drawing.cross(kLayer, at, 3 * mark);
}

void draw_conjugate(const ProblemStatement& design, double mark, Drawing& drawing) {
  const RollerPair pair = conjugate_rollers(design, first_of(design, "displacement"));
  const double radius = constant_of(design, "roller_radius");
  for (const Vector2d& centre : {pair.main, pair.second}) {
    draw_roller(centre, radius, mark, drawing);
  }
  drawing.line(kLayer, pair.main, pair.second);
}

/// As long as the contact needs it, and a mark longer at both ends.
void draw_face(const FaceLine& face, const CurveRange& touching, double mark, Drawing& drawing) {
  const auto at = [&](double t) { return Vector2d(face.foot + t * face.along); };
  drawing.line(kLayer, at(touching.low - mark), at(touching.high + mark));
  drawing.cross(kLayer, at(touching.first), mark);
}

void draw_sliding_face(const ProblemStatement& design, double mark, Drawing& drawing) {
  const FaceLine face = sliding_face(design, first_of(design, "displacement"));
  draw_face(face, range_of(design, "contact_offset"), mark, drawing);
  drawing.line(kLayer, face.foot, face.foot + Vector2d(0, 10 * mark));
}

void draw_swinging_face(const ProblemStatement& design, double mark, Drawing& drawing) {
  const FaceLine face = swinging_face(design, first_of(design, "displacement"));
  const CurveRange touching = range_of(design, "contact_lever");
  const Vector2d pivot(constant_of(design, "pivot_distance"), 0);
  draw_face(face, touching, mark, drawing);
  draw_pivot(pivot, mark, drawing);
  if (face.foot != pivot) drawing.line(kLayer, pivot, face.foot);
  drawing.line(kLayer, face.foot, face.foot + (touching.low - mark) * face.along);
}

/// A wedge above the point that follows the cam.
void draw_knife_edge(const Vector2d& tip, double mark, Drawing& drawing) {
  const Vector2d left = tip + mark * Vector2d(-2, 4), right = tip + mark * Vector2d(2, 4);
  drawing.line(kLayer, tip, left);
  drawing.line(kLayer, left, right);
  drawing.line(kLayer, right, tip);
}

/// Where the arm of a roller turns, if it is on one.
std::optional<Vector2d> pivot_of(const ProblemStatement& design) {
  if (design.mechanism->form == Form::EndArm) return Vector2d(0, 0);
  const auto distance = own_size(design, "pivot_distance");
  return distance ? std::optional(Vector2d(*distance, 0)) : std::nullopt;
}

/// The roller about the pitch curve's place, and its arm.
void draw_pitch_roller(const ProblemStatement& design, const std::optional<Vector2d>& centre,
                       double mark, Drawing& drawing) {
  const auto radius = own_size(design, "roller_radius");
  if (centre && radius) draw_roller(*centre, *radius, mark, drawing);
  const auto pivot = pivot_of(design);
  if (!pivot) return;
  draw_pivot(*pivot, mark, drawing);
  if (centre) drawing.line(kLayer, *pivot, *centre);
}

}  // namespace

void draw_follower(const ProblemStatement& design, double mark, Drawing& drawing) {
  const auto pitch = cam_curves(design, "pitch");
  std::optional<Vector2d> place;
  if (!pitch.empty()) place = pitch.front().at({pitch.front().begin()}).at;
  switch (design.mechanism->form) {
    case Form::DiscConjugate:
      return draw_conjugate(design, mark, drawing);
    case Form::DiscFlat:
      return draw_sliding_face(design, mark, drawing);
    case Form::DiscFlatArm:
      return draw_swinging_face(design, mark, drawing);
    case Form::DiscKnifeEdge:
      return draw_knife_edge(place.value(), mark, drawing);
    case Form::BalancingCam:
      return draw_roller(balancing_roller(design, first_of(design, "roller_displacement")),
                         constant_of(design, "roller_radius"), mark, drawing);
    default:
      return draw_pitch_roller(design, place, mark, drawing);
  }
}

}  // namespace camlaw::problems
