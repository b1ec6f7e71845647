// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/chart_scale.h"
#include "problems/statement/bind.h"

namespace camlaw::cli {

/// How a body moves while the cam turns: `factor` times the cam's angle or the displacement (or
/// another curve), from where it is drawn, which is the pose at angle 0.
struct BodyMotion {
  enum class Kind {
    Fixed,
    Turn,    ///< by `factor` degrees per degree of the cycle, counterclockwise about `pivot`
    Slide,   ///< by `factor` times the displacement, along `direction`
    Swing,   ///< by `factor` degrees per degree of displacement, counterclockwise about `pivot`
    Travel,  ///< by `factor` per degree of the cycle, along x
  };
  Kind kind = Kind::Fixed;
  double factor = 1;
  Point pivot = {0, 0};
  Point direction = {0, 1};
};

/// A mechanism drawn to scale at the beginning of its cycle, in mm, y upwards: an SVG whose bodies
/// motion.js moves. Shapes are what the model itself knows.
class Scene {
 public:
  explicit Scene(std::string title) : title_(std::move(title)) {}

  /// Shapes that follow belong to this body.
  void body(std::string_view name, const BodyMotion& motion = {});
  void polyline(std::string_view kind, const std::vector<Point>& points, bool closed);
  void circle(std::string_view kind, Point centre, double radius);
  void segment(std::string_view kind, Point from, Point to);
  /// The window shows this point.
  void include(Point point);
  /// The same with all within `radius`.
  void include(Point centre, double radius);

  /// What the drawn pose has of the curve that Slide and Swing follow: they count from it.
  void drawn_at(const std::string& curve, double value) {
    follows_ = curve;
    zero_ = value;
  }
  const std::string& follows() const { return follows_; }
  std::string svg() const;

 private:
  std::string title_, bodies_, follows_;
  double zero_ = 0;
  bool open_ = false;
  std::optional<std::pair<Point, Point>> window_;  ///< lower left, upper right
};

/// Values of a statement's curves at even angles of the cycle, looked up by name.
class SceneCurves {
 public:
  SceneCurves(const problems::ProblemStatement& design, int points);
  bool has(const std::string& name) const;
  /// At `points` + 1 even places; throws std::logic_error for an unknown name.
  std::vector<double> values(const std::string& name) const;
  /// Those of "NAME_x" and "NAME_y".
  std::vector<Point> points(const std::string& name) const;

 private:
  std::vector<optim::Response> curves_;
  int points_;
};

/// A parameter of the design's mechanism, in its listed unit.
double parameter_of(const problems::ProblemStatement& design, std::string_view name);
bool has_parameter(const problems::ProblemStatement& design, std::string_view name);

/// The scenes that there are, each of the mechanisms that it can draw; else none.
std::optional<Scene> disc_scene(const problems::ProblemStatement& design, int points);
std::optional<Scene> geneva_scene(const problems::ProblemStatement& design, int points);
std::optional<Scene> plate_scene(const problems::ProblemStatement& design, int points);
/// Of any machine with a displacement in mm whose shape is not known: a mark on its way.
std::optional<Scene> slider_scene(const problems::ProblemStatement& design, int points);

/// The first of them that draws the design, if any.
std::optional<Scene> scene_of(const problems::ProblemStatement& design, int points);
/// The same as SVG; empty where none draws it.
std::string scene_svg(const problems::ProblemStatement& design, int points);

}  // namespace camlaw::cli
