// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <boost/property_tree/xml_parser.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "output/report/scene.h"
#include "problems/statement/statement.h"
#include "tests/paths.h"

/// Scenes of reports, moved as motion.js moves them.
namespace camlaw::cli::picture {

using boost::property_tree::ptree;

inline constexpr int kSamples = 360;
inline constexpr int kPlaces[] = {0, 17, 90, 123, 180, 251, 270, 333, 360};
inline constexpr double kDegree = std::numbers::pi / 180;

inline double distance(DrawnPoint p, DrawnPoint q) { return std::hypot(p.x - q.x, p.y - q.y); }

inline double distance_to_segment(DrawnPoint p, DrawnPoint from, DrawnPoint to) {
  const double x = to.x - from.x, y = to.y - from.y, square = x * x + y * y;
  if (square == 0) return distance(p, from);
  const double t = std::clamp(((p.x - from.x) * x + (p.y - from.y) * y) / square, 0.0, 1.0);
  return distance(p, {from.x + t * x, from.y + t * y});
}

inline double distance_to_path(DrawnPoint p, const std::vector<DrawnPoint>& path) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < path.size(); ++i) {
    least = std::min(least, distance_to_segment(p, path[i - 1], path[i]));
  }
  return least;
}

/// The words of a text between separators.
inline std::vector<std::string> parts(const std::string& text, const std::string& separator) {
  std::vector<std::string> result;
  std::size_t from = 0;
  for (std::size_t at = 0; (at = text.find(separator, from)) != std::string::npos;) {
    result.push_back(text.substr(from, at - from));
    from = at + separator.size();
  }
  result.push_back(text.substr(from));
  return result;
}

/// A shape of a scene: the points of a line or path, the middle of a circle.
struct Shape {
  std::string kind;  ///< its class
  std::vector<DrawnPoint> points;
  double radius = 0;
};

struct Body {
  std::string name, motion;
  std::vector<Shape> shapes;
};

inline Shape shape_of(const std::string& tag, const ptree& tree) {
  const auto number = [&](const char* key) {
    return tree.get<double>(std::string("<xmlattr>.") + key);
  };
  Shape shape{tree.get<std::string>("<xmlattr>.class"), {}};
  if (tag == "circle") {
    shape.points = {{number("cx"), number("cy")}};
    shape.radius = number("r");
  } else if (tag == "line") {
    shape.points = {{number("x1"), number("y1")}, {number("x2"), number("y2")}};
  } else {
    std::string text = tree.get<std::string>("<xmlattr>.d");
    const bool closed = text.back() == 'Z';
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == 'M' || c == 'L' || c == 'Z'; }, ' ');
    std::istringstream numbers(text);
    for (DrawnPoint p; numbers >> p.x >> p.y;) shape.points.push_back(p);
    if (closed) shape.points.push_back(shape.points.front());
  }
  return shape;
}

/// A scene as a page has it, to be looked at anywhere in its cycle.
class Picture {
 public:
  explicit Picture(const problems::ProblemStatement& design) : curves_(design, kSamples) {
    std::istringstream svg(scene_of(design, kSamples).value().svg());
    ptree tree;
    read_xml(svg, tree, boost::property_tree::xml_parser::trim_whitespace);
    for (const auto& [tag, child] : tree.get_child("svg.g")) {
      if (tag == "g") add_body(child);
    }
  }

  const SceneCurves& curves() const { return curves_; }
  /// What the curve has at a place.
  double value(const std::string& curve, int place) const {
    return curves_.values(curve)[static_cast<std::size_t>(place)];
  }
  const Body& body(const std::string& name) const {
    const auto at = std::find_if(bodies_.begin(), bodies_.end(),
                                 [&](const Body& b) { return b.name.starts_with(name); });
    if (at == bodies_.end()) throw std::runtime_error("no body " + name);
    return *at;
  }
  /// The shapes of a kind, moved to the place.
  std::vector<Shape> shapes(const std::string& body_name, const std::string& kind,
                            int place) const {
    const Body& of = body(body_name);
    std::vector<Shape> result;
    for (Shape shape : of.shapes) {
      if (shape.kind != kind) continue;
      for (DrawnPoint& p : shape.points) p = moved(of, p, place);
      result.push_back(std::move(shape));
    }
    if (result.empty()) throw std::runtime_error("no " + kind + " in " + body_name);
    return result;
  }
  Shape shape(const std::string& body_name, const std::string& kind, int place) const {
    return shapes(body_name, kind, place).front();
  }

 private:
  void add_body(const ptree& tree) {
    Body body{tree.get<std::string>("title"), tree.get("<xmlattr>.data-motion", ""), {}};
    for (const auto& [tag, child] : tree) {
      if (tag == "circle" || tag == "line" || tag == "path") {
        body.shapes.push_back(shape_of(tag, child));
      }
    }
    bodies_.push_back(std::move(body));
  }
  /// As stepAt of motion.js.
  DrawnPoint stepped(const std::string& step, DrawnPoint p, int place) const {
    std::istringstream words(step);
    std::string kind, curve;
    double drawn = 0, factor = 0, x = 0, y = 0, phase = 0;
    words >> kind >> curve >> drawn >> factor >> x >> y >> phase;
    if (!words) throw std::runtime_error("no step: " + step);
    const double now = curve == "cycle" ? 360.0 * place / kSamples : value(curve, place);
    const double by = factor * (now - drawn);
    if (kind == "slide") return {p.x + by * x, p.y + by * y};
    if (kind == "harmonic") {
      const double gained = std::sin((phase + by) * kDegree) - std::sin(phase * kDegree);
      return {p.x + gained * x, p.y + gained * y};
    }
    if (kind != "turn") throw std::runtime_error("no motion " + kind);
    const double c = std::cos(by * kDegree), s = std::sin(by * kDegree);
    return {x + c * (p.x - x) - s * (p.y - y), y + s * (p.x - x) + c * (p.y - y)};
  }
  DrawnPoint moved(const Body& body, DrawnPoint p, int place) const {
    if (body.motion.empty()) return p;
    const std::vector<std::string> steps = parts(body.motion, "; ");
    for (auto step = steps.rbegin(); step != steps.rend(); ++step) p = stepped(*step, p, place);
    return p;
  }

  SceneCurves curves_;
  std::vector<Body> bodies_;
};

inline problems::ProblemStatement shipped(const std::string& name) {
  return problems::read_problem_file(testing::source("problems/") + name + ".toml");
}

}  // namespace camlaw::cli::picture
