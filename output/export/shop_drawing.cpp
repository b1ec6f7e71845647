// SPDX-License-Identifier: MIT
#include "output/export/shop_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "machines/cams/cam_shape.h"
#include "output/export/drawn_follower.h"
#include "problems/statement/parameters.h"

namespace camlaw::problems {
namespace {

using Eigen::Vector2d;

constexpr double kRadian = 180 / std::numbers::pi;

constexpr double kDrawnTurn = 360;  // deg

/// Distances of a curve from the cam's centre, and its box.
struct Reach {
  double least = 1e300, most = 0;
  Vector2d low{1e300, 1e300}, high{-1e300, -1e300};
};

Reach reach_of(const std::vector<PlaneCurve>& curves) {
  constexpr int kPlaces = 1440;  // a quarter of a degree: the frame's size is drawn, not printed
  Reach reach;
  for (const PlaneCurve& curve : curves) {
    for (int i = 0; i <= kPlaces; ++i) {
      const Vector2d p = curve.at(optim::even_place(curve.begin(), curve.end(), kPlaces, i)).at;
      if (curve.name().ends_with("profile")) {
        reach.least = std::min(reach.least, p.norm()), reach.most = std::max(reach.most, p.norm());
      }
      reach.low = reach.low.cwiseMin(p), reach.high = reach.high.cwiseMax(p);
    }
  }
  return reach;
}

/// In the cam's own axes the follower goes round the cam against the cam's own turn.
bool turns_left(const PlaneCurve& profile) { return !winds_left(profile); }

void draw_rotation(const PlaneCurve& profile, double radius, Drawing& drawing) {
  // An arc of 120 deg below the cam ends in an arrow's head that is an eighth of its radius long.
  constexpr double kFrom = 210, kTo = 330, kHead = 0.12, kOpening = 25 / kRadian;
  drawing.arc("ROTATION", {0, 0}, radius, kFrom, kTo);
  const bool left = turns_left(profile);
  const double at = (left ? kTo : kFrom) / kRadian, sense = left ? 1 : -1;
  const Vector2d tip = radius * Vector2d(std::cos(at), std::sin(at));
  const double back = at + sense * std::numbers::pi / 2 + std::numbers::pi;
  for (const double side : {-kOpening, kOpening}) {
    const Vector2d away(std::cos(back + side), std::sin(back + side));
    drawing.line("ROTATION", tip, tip + kHead * radius * away);
  }
}

/// Whether the cam runs along x under its follower: on a drum that is developed, or as a plate.
bool runs_along(const ProblemStatement& design) {
  const auto shape = cam_shape(*design.mechanism);
  return shape == CamShape::Drum || shape == CamShape::Plate;
}

/// On a developed cam the follower goes along x against the cam's own way.
bool moves_left(const PlaneCurve& profile) {
  return profile.at({profile.end(), true}).at.x() > profile.at({profile.begin()}).at.x();
}

/// An arrow along x below the middle of the cam.
void draw_way(const PlaneCurve& profile, const Reach& reach, double mark, Drawing& drawing) {
  constexpr double kBelow = 4, kHalf = 6, kHead = 2, kWide = 0.8;  // marks
  const double sense = moves_left(profile) ? -1 : 1;
  const Vector2d middle(std::midpoint(reach.low.x(), reach.high.x()),
                        reach.low.y() - kBelow * mark);
  const Vector2d along(sense * mark, 0), tip = middle + kHalf * along;
  drawing.line("ROTATION", middle - kHalf * along, tip);
  for (const double side : {-kWide, kWide}) {
    drawing.line("ROTATION", tip, tip - kHead * along + Vector2d(0, side * mark));
  }
}

/// The place that is under the frame's y axis when the shaft is at its zero: within the cam, clear
/// of the mark of its own zero; of a developed cam below it.
void draw_shaft_zero(const PlaneCurve& profile, const ShaftPlace& place, const Reach& reach,
                     double mark, Drawing& drawing) {
  constexpr double kFrom = 0.6, kTo = 0.8;  // of the least radius; a zero mark begins at 0.85
  constexpr double kBelow = 3;              // marks
  const bool round = profile.is_about_centre();
  const Vector2d way = round ? shaft_zero_axis(profile, place.phase) : Vector2d(0, 1);
  const Vector2d foot =
      round ? Vector2d(kFrom * reach.least * way)
            : Vector2d(shaft_zero_along(profile, place.phase), reach.low.y() - kBelow * mark);
  const double length = round ? (kTo - kFrom) * reach.least : (kBelow - 1) * mark;
  drawing.line("SHAFT_ZERO", foot, foot + length * way);
  drawing.text("SHAFT_ZERO", foot + Vector2d(mark / 2, 0), 1.2 * mark, "shaft 0 deg");
}

/// "turns clockwise as drawn", "moves to the left as drawn"; empty where neither is known.
std::string sense_line(const ProblemStatement& design, const PlaneCurve& profile) {
  if (profile.is_about_centre()) {
    return fmt::format("turns {} as drawn", turns_left(profile) ? "counterclockwise" : "clockwise");
  }
  if (!runs_along(design)) return "";
  return fmt::format("moves to the {} as drawn", moves_left(profile) ? "left" : "right");
}

/// Whether a length stands in the title block: not one of the guide, the contact or the crown that
/// nobody stated, which the cam's shape does not depend on.
bool is_listed(const ProblemStatement& design, std::size_t parameter) {
  constexpr std::string_view kNotOfShape[] = {"guide_length", "overhang", "crown_radius",
                                              "face_width"};
  const MechanismParameter& p = design.mechanism->parameters[parameter];
  const bool is_of_shape =
      std::find(std::begin(kNotOfShape), std::end(kNotOfShape), p.name) == std::end(kNotOfShape);
  return p.unit == "mm" && (is_of_shape || design.stated.contains(parameter));
}

std::vector<std::string> dimension_lines(const ProblemStatement& design, const ShopSettings& s,
                                         const std::optional<Bore>& bore, const Reach& reach,
                                         const PlaneCurve& profile) {
  const auto length = [&](double mm) {
    return fmt::format("{:.4f} {}", mm / s.unit.mm, s.unit.name);
  };
  std::vector<std::string> lines;
  if (profile.is_about_centre()) {
    lines.push_back(
        fmt::format("radius of the profile {} to {}", length(reach.least), length(reach.most)));
  }
  if (std::string sense = sense_line(design, profile); !sense.empty()) {
    lines.push_back(std::move(sense));
  }
  if (bore) lines.push_back(fmt::format("bore {} in diameter", length(2 * bore->radius)));
  if (s.keyway) {
    const char* where = !s.on_shaft              ? "the zero mark"
                        : s.on_shaft->from_shaft ? "the mark of the shaft's zero"
                                                 : "the mark of the cam's zero";
    lines.push_back(fmt::format("keyway {} wide, {} deep, at {}", length(s.keyway->width),
                                length(s.keyway->depth), where));
  }
  for (std::size_t i = 0; i < design.mechanism->parameters.size(); ++i) {
    if (!is_listed(design, i)) continue;
    const std::string& name = design.mechanism->parameters[i].name;
    lines.push_back(fmt::format("{} {}", name, length(constant_of(design, name))));
  }
  lines.push_back(fmt::format("lengths in {}", s.unit.mm == 1 ? "mm" : "inches"));
  return lines;
}

/// A frame to the right of all that is drawn with the lines from top to bottom.
void draw_title(const std::vector<std::string>& lines, const Reach& reach, Drawing& drawing) {
  // Letters have the size 3.5 mm of ISO 3098, and lines stand 6 mm apart.
  constexpr double kHeight = 3.5, kLine = 6, kRoom = 4;
  std::size_t longest = 0;
  for (const std::string& line : lines) longest = std::max(longest, line.size());
  const Vector2d corner(std::max(reach.high.x(), drawing.right()) + 20, reach.high.y());
  const double width = 2 * kRoom + Drawing::kLetter * kHeight * static_cast<double>(longest);
  const double height = 2 * kRoom + kLine * static_cast<double>(lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const double down = kRoom + kLine * static_cast<double>(i + 1);
    drawing.text("TITLE", corner + Vector2d(kRoom, -down), kHeight, lines[i]);
  }
  const Vector2d right(width, 0), below(0, -height);
  drawing.line("TITLE", corner, corner + right);
  drawing.line("TITLE", corner + right, corner + right + below);
  drawing.line("TITLE", corner + right + below, corner + below);
  drawing.line("TITLE", corner + below, corner);
}

}  // namespace

std::vector<DrawnShape> shop_shapes(const ProblemStatement& design, const ShopSettings& s) {
  const std::vector<PlaneCurve> curves = cam_curves(design, "all");
  const auto profiles = cam_curves(design, "profile");
  if (profiles.empty()) return {};
  const PlaneCurve& profile = profiles.front();
  const Reach reach = reach_of(curves);
  const double mark = 0.02 * (reach.high - reach.low).maxCoeff();
  Drawing drawing(1 / s.unit.mm);
  const std::optional<Bore> bore = bore_of(design, s.bore_radius, s.keyway);
  if ((s.keyway || s.bore_radius) && !profile.is_about_centre()) {
    throw std::invalid_argument("--bore and --keyway are for disc cams");
  }
  // A flank that begins in the cycle before goes on over its end, where the angle is 0.
  const double begin = profile.begin() > 0 ? kDrawnTurn : profile.begin();
  const Vector2d zero = profile.at({begin}).at;
  if (profile.is_about_centre()) {
    if (bore) {
      const bool at_shaft = s.on_shaft && s.on_shaft->from_shaft;
      const Vector2d towards = at_shaft ? shaft_zero_axis(profile, s.on_shaft->phase) : zero;
      const BoreOutline outline = outline_of(*bore, towards, reach.least, "the profile");
      drawing.add("SHAFT", outline.arc);
      for (const DrawnLine& line : outline.keyway) drawing.add("SHAFT", line);
    }
    drawing.cross("CENTRE", {0, 0}, 2 * mark);
    draw_rotation(profile, bore ? std::midpoint(bore->radius, reach.least) : 0.7 * reach.least,
                  drawing);
  }
  if (runs_along(design)) draw_way(profile, reach, mark, drawing);
  const Vector2d inwards =
      profile.is_about_centre() ? Vector2d(0.85 * zero) : Vector2d(zero - Vector2d(0, 4 * mark));
  drawing.line("ZERO_MARK", inwards, zero);
  drawing.text("ZERO_MARK", inwards + Vector2d(mark / 2, 0), 1.2 * mark, "0 deg");
  if (s.on_shaft) draw_shaft_zero(profile, *s.on_shaft, reach, mark, drawing);
  draw_follower(design, mark, drawing);
  std::vector<std::string> lines = s.title;
  for (std::string& line : dimension_lines(design, s, bore, reach, profile)) {
    lines.push_back(std::move(line));
  }
  draw_title(lines, reach, drawing);
  return drawing.take();
}

}  // namespace camlaw::problems
