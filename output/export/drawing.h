// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "output/export/bore.h"

namespace camlaw::problems {

struct DrawnText {
  Eigen::Vector2d at;  ///< its lower left corner
  double height;
  std::string text;
};
struct DrawnShape {
  std::string layer;
  std::variant<DrawnLine, DrawnArc, DrawnText> shape;
};

/// Shapes that are told in mm and kept in the unit of a drawing.
class Drawing {
 public:
  static constexpr double kLetter = 0.85;  ///< the width of a letter over its height

  explicit Drawing(double per_mm) : per_mm_(per_mm) {}

  void line(const char* layer, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    right_ = std::max({right_, from.x(), to.x()});
    shapes_.push_back({layer, DrawnLine{per_mm_ * from, per_mm_ * to}});
  }
  void arc(const char* layer, const Eigen::Vector2d& centre, double radius, double from = 0,
           double to = 360) {
    right_ = std::max(right_, centre.x() + radius);
    shapes_.push_back({layer, DrawnArc{per_mm_ * centre, per_mm_ * radius, from, to}});
  }
  void text(const char* layer, const Eigen::Vector2d& at, double height, const std::string& words) {
    right_ = std::max(right_, at.x() + kLetter * height * static_cast<double>(words.size()));
    shapes_.push_back({layer, DrawnText{per_mm_ * at, per_mm_ * height, words}});
  }
  void cross(const char* layer, const Eigen::Vector2d& at, double half) {
    line(layer, at - Eigen::Vector2d(half, 0), at + Eigen::Vector2d(half, 0));
    line(layer, at - Eigen::Vector2d(0, half), at + Eigen::Vector2d(0, half));
  }
  void add(const char* layer, const DrawnArc& a) { arc(layer, a.centre, a.radius, a.from, a.to); }
  void add(const char* layer, const DrawnLine& l) { line(layer, l.from, l.to); }
  /// To the right of this place, mm, nothing is drawn.
  double right() const { return right_; }
  std::vector<DrawnShape> take() { return std::move(shapes_); }

 private:
  double per_mm_, right_ = -std::numeric_limits<double>::infinity();
  std::vector<DrawnShape> shapes_;
};

}  // namespace camlaw::problems
