// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "output/figure/chart_scale.h"
#include "problems/statement/bind.h"
#include "problems/statement/parameters.h"

namespace camlaw::cli {

/// One step of how a body moves from where it is drawn, which is its pose at the beginning of the
/// cycle: by `factor` times what its curve has gained since then, or the cycle's angle.
struct BodyMotion {
  enum class Kind {
    Turn,      ///< counterclockwise in degrees, about the point `about`
    Slide,     ///< along the vector `about`
    Harmonic,  ///< along the vector `about`, as a point at its end that turns, seen from the edge
  };
  Kind kind = Kind::Turn;
  double factor = 1;
  DrawnPoint about = {0, 0};
  std::string curve = {};  ///< empty: the angle of the cycle
  double phase = 0;        ///< of Harmonic: degrees of the sine where it is drawn
};

/// A point of a body that turns about the picture's y axis with the cycle's angle, in the body's
/// own coordinates, which are the picture's at the beginning of the cycle.
struct SpunPoint {
  double right, up, near;  ///< near: towards the reader
};

/// A mechanism drawn to scale at the beginning of its cycle, in mm, y upwards: an SVG whose bodies
/// motion.js moves. Shapes are what the model itself knows.
class Scene {
 public:
  explicit Scene(std::string title) : title_(std::move(title)) {}

  /// Shapes that follow belong to this body. It takes the last step first; the steps before carry
  /// it along with what it has done, as an arm carries what slides on it.
  void body(std::string_view name, const std::vector<BodyMotion>& steps = {});
  void polyline(std::string_view kind, const std::vector<DrawnPoint>& points, bool closed);
  void circle(std::string_view kind, DrawnPoint centre, double radius);
  void segment(std::string_view kind, DrawnPoint from, DrawnPoint to);
  /// A curve on the outside of a body that turns about the y axis, of which what is on its near
  /// side is shown.
  void spun(std::string_view kind, const std::vector<SpunPoint>& curve);
  /// The same of the two edges of a groove, point by point across it, and what is between them.
  void spun_groove(const std::vector<SpunPoint>& one, const std::vector<SpunPoint>& other);
  /// Words about a point, in letters of this height.
  void text(DrawnPoint middle, double height, std::string_view words);
  /// A roller with the mark of its pin.
  void roller(DrawnPoint centre, double radius);
  /// An arrow about a centre, counterclockwise where `turning` is above 0, from `angle`, deg.
  void turn_arrow(DrawnPoint centre, double radius, double turning, double angle);
  /// A straight arrow.
  void straight_arrow(DrawnPoint from, DrawnPoint to);
  /// The window shows this point.
  void include(DrawnPoint point);
  /// The same with all within `radius`.
  void include(DrawnPoint centre, double radius);

  /// What the drawn pose has of a curve that bodies follow: they count from it.
  void drawn_at(const std::string& curve, double value) { drawn_at_[curve] = value; }
  /// The curves that bodies follow.
  std::set<std::string> follows() const;
  std::string svg() const;

 private:
  void arrow_head(DrawnPoint tip, DrawnPoint direction, double length);

  std::string title_, bodies_;
  std::map<std::string, double> drawn_at_;
  bool open_ = false;
  std::optional<std::pair<DrawnPoint, DrawnPoint>> window_;  ///< lower left, upper right
};

/// Values of a statement's curves at even angles of the cycle, looked up by name, each worked out
/// once.
class SceneCurves {
 public:
  SceneCurves(const problems::ProblemStatement& design, int points);
  bool has(const std::string& name) const;
  /// At `points` + 1 even places; throws std::logic_error for an unknown name.
  const std::vector<double>& values(const std::string& name) const;
  /// Its derivative by the place, there.
  std::vector<double> slopes(const std::string& name) const;
  /// Those of "NAME_x" and "NAME_y".
  std::vector<DrawnPoint> points(const std::string& name) const;

 private:
  std::unique_ptr<optim::Trace> trace(const std::string& name) const;

  std::vector<optim::Response> curves_;
  int points_;
  mutable std::map<std::string, std::vector<double>> known_;
};

/// Whether the design's mechanism has such a parameter.
bool has_parameter(const problems::ProblemStatement& design, std::string_view name);

/// A roller that the curve pushes along y, on a stem upwards.
void draw_pushed_roller(Scene& scene, DrawnPoint centre, double radius, const std::string& curve);
/// A roller at the end of an arm that swings clockwise by the displacement, and the arm's pivot.
void draw_roller_arm(Scene& scene, DrawnPoint pivot, DrawnPoint centre, double radius);

/// The scenes that there are, each of the mechanisms that it can draw; else none.
std::optional<Scene> balancing_scene(const problems::ProblemStatement& design, int points);
std::optional<Scene> disc_scene(const problems::ProblemStatement& design, int points);
std::optional<Scene> feeder_scene(const problems::ProblemStatement& design, int points);
std::optional<Scene> geneva_scene(const problems::ProblemStatement& design, int points);
std::optional<Scene> index_scene(const problems::ProblemStatement& design, int points);
std::optional<Scene> plate_scene(const problems::ProblemStatement& design, int points);
std::optional<Scene> spherical_geneva_scene(const problems::ProblemStatement& design, int points);
/// The working point of a servo motor in the plane of its speed and torque.
std::optional<Scene> servo_scene(const problems::ProblemStatement& design, int points);
/// Of a file that states path_x and path_y: the path, and the point that runs along it.
std::optional<Scene> path_scene(const problems::ProblemStatement& design, int points);
/// Of any machine with a displacement in mm whose shape is not known: a mark on its way.
std::optional<Scene> slider_scene(const problems::ProblemStatement& design, int points);

/// The first of them that draws the design, if any.
std::optional<Scene> scene_of(const problems::ProblemStatement& design, int points);
/// The same as SVG; empty where none draws it.
std::string scene_svg(const problems::ProblemStatement& design, int points);

}  // namespace camlaw::cli
