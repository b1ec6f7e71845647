// SPDX-License-Identifier: MIT
#include "output/export/shop_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "problems/statement/parameters.h"

namespace camlaw::problems {
namespace {

using Eigen::Vector2d;

constexpr double kRadian = 180 / std::numbers::pi;

/// Distances of a closed curve from the cam's centre, and its box.
struct Reach {
  double least = 1e300, most = 0;
  Vector2d low{1e300, 1e300}, high{-1e300, -1e300};
};

Reach reach_of(const std::vector<PlaneCurve>& curves) {
  constexpr int kPlaces = 1440;
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

class Drawing {
 public:
  explicit Drawing(double per_mm) : per_mm_(per_mm) {}

  void line(const char* layer, const Vector2d& from, const Vector2d& to) {
    shapes_.push_back({layer, DrawnLine{per_mm_ * from, per_mm_ * to}});
  }
  void arc(const char* layer, const Vector2d& centre, double radius, double from = 0,
           double to = 360) {
    shapes_.push_back({layer, DrawnArc{per_mm_ * centre, per_mm_ * radius, from, to}});
  }
  void text(const char* layer, const Vector2d& at, double height, const std::string& words) {
    shapes_.push_back({layer, DrawnText{per_mm_ * at, per_mm_ * height, words}});
  }
  void cross(const char* layer, const Vector2d& at, double half) {
    line(layer, at - Vector2d(half, 0), at + Vector2d(half, 0));
    line(layer, at - Vector2d(0, half), at + Vector2d(0, half));
  }
  void add(const DrawnArc& a) { arc("SHAFT", a.centre, a.radius, a.from, a.to); }
  void add(const DrawnLine& l) { line("SHAFT", l.from, l.to); }
  std::vector<DrawnShape> take() { return std::move(shapes_); }

 private:
  double per_mm_;
  std::vector<DrawnShape> shapes_;
};

/// Roller and pivot as they stand at cam angle 0.
void draw_follower(const ProblemStatement& design, double mark, Drawing& drawing) {
  const auto pitch = cam_curves(design, "pitch");
  const auto roller = own_size(design, "roller_radius"), pivot = own_size(design, "pivot_distance");
  std::optional<Vector2d> centre;
  if (!pitch.empty()) centre = pitch.front().at({pitch.front().begin()}).at;
  if (centre && roller) {
    drawing.arc("FOLLOWER", *centre, *roller);
    drawing.cross("FOLLOWER", *centre, mark);
  }
  if (!pivot) return;
  drawing.arc("FOLLOWER", {*pivot, 0}, 2 * mark);
  drawing.cross("FOLLOWER", {*pivot, 0}, 3 * mark);
  if (centre) drawing.line("FOLLOWER", {*pivot, 0}, *centre);
}

/// In the cam's own axes the follower goes round the cam against the cam's own turn.
bool turns_left(const PlaneCurve& profile) { return !winds_left(profile); }

void draw_rotation(const PlaneCurve& profile, double radius, Drawing& drawing) {
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

std::vector<std::string> dimension_lines(const ProblemStatement& design, const ShopSettings& s,
                                         const std::optional<Bore>& bore, const Reach& reach,
                                         const PlaneCurve& profile) {
  const auto length = [&](double mm) {
    return fmt::format("{:.4f} {}", mm / s.unit.mm, s.unit.name);
  };
  std::vector<std::string> lines;
  if (profile.is_closed()) {
    lines.push_back(
        fmt::format("radius of the profile {} to {}", length(reach.least), length(reach.most)));
    lines.push_back(
        fmt::format("turns {} as drawn", turns_left(profile) ? "counterclockwise" : "clockwise"));
  }
  if (bore) lines.push_back(fmt::format("bore {} in diameter", length(2 * bore->radius)));
  if (s.keyway) {
    lines.push_back(fmt::format("keyway {} wide, {} deep, at the zero mark",
                                length(s.keyway->width), length(s.keyway->depth)));
  }
  for (std::size_t i = 0; i < design.mechanism->parameters.size(); ++i) {
    const auto& parameter = design.mechanism->parameters[i];
    if (parameter.unit != "mm") continue;
    lines.push_back(
        fmt::format("{} {}", parameter.name, length(constant_of(design, parameter.name))));
  }
  lines.push_back(fmt::format("lengths in {}", s.unit.name));
  return lines;
}

/// A frame to the right of the drawing with the lines from top to bottom.
void draw_title(const std::vector<std::string>& lines, const Reach& reach, Drawing& drawing) {
  constexpr double kHeight = 3.5, kLine = 6, kRoom = 4, kLetter = 0.85;
  std::size_t longest = 0;
  for (const std::string& line : lines) longest = std::max(longest, line.size());
  const Vector2d corner(reach.high.x() + 20, reach.high.y());
  const double width = 2 * kRoom + kLetter * kHeight * static_cast<double>(longest);
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
  if ((s.keyway || s.bore_radius) && !profile.is_closed()) {
    throw std::invalid_argument("--bore and --keyway are for disc cams");
  }
  const Vector2d zero = profile.at({profile.begin()}).at;
  if (profile.is_closed()) {
    if (bore) {
      const BoreOutline outline = outline_of(*bore, zero, reach.least, "the profile");
      drawing.add(outline.arc);
      for (const DrawnLine& line : outline.keyway) drawing.add(line);
    }
    drawing.cross("CENTRE", {0, 0}, 2 * mark);
    draw_rotation(profile, bore ? std::midpoint(bore->radius, reach.least) : 0.7 * reach.least,
                  drawing);
  }
  const Vector2d inwards =
      profile.is_closed() ? Vector2d(0.85 * zero) : Vector2d(zero - Vector2d(0, 4 * mark));
  drawing.line("ZERO_MARK", inwards, zero);
  drawing.text("ZERO_MARK", inwards + Vector2d(mark / 2, 0), 1.2 * mark, "0 deg");
  draw_follower(design, mark, drawing);
  std::vector<std::string> lines = s.title;
  for (std::string& line : dimension_lines(design, s, bore, reach, profile)) {
    lines.push_back(std::move(line));
  }
  draw_title(lines, reach, drawing);
  return drawing.take();
}

}  // namespace camlaw::problems
