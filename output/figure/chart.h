// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// A small deterministic SVG chart writer for the program's figures: curves and scatter plots in
/// a grid of panels with one legend. It knows no cams, only numbers; text is UTF-8.
namespace camlaw::cli {

/// One axis of a panel; its title is drawn as "label, unit" (the unit may be empty). A bound that
/// is not given comes from the data with 4 % padding.
struct Axis {
  std::string label = {};
  std::string unit = {};
  std::optional<double> lower = {};
  std::optional<double> upper = {};

  bool operator==(const Axis&) const = default;
};

/// A curve through the samples (x[i], y[i]), cut at the panel's frame. A sample that is not finite
/// breaks the curve. An empty name has no legend entry.
struct Line {
  std::string name = {};
  std::vector<double> x = {};
  std::vector<double> y = {};
  std::string colour =
      {};  ///< Any SVG colour; empty takes the palette's by legend position (8, repeated).
  bool dashed = false;
  double width = 1.8;  ///< px
};

enum class MarkerShape { Circle, Diamond, Square, Cross };

/// One point of a scatter plot. The label is drawn beside it where there is room; label and tooltip
/// are shown together on hovering.
struct Marker {
  double x = 0;
  double y = 0;
  std::string label = {};
  std::string tooltip = {};
};

/// Points that share a look. Points which are not finite or lie outside given bounds are not drawn.
/// Labels are placed in the order of the points; the first ones get the best places.
struct Markers {
  std::string name = {};
  std::vector<Marker> points = {};
  std::string colour = {};  ///< As Line::colour.
  MarkerShape shape = MarkerShape::Circle;
  bool filled = true;
  double size = 4;  ///< Half the marker's width, px.
};

/// One set of axes. Lines are drawn first, then markers, each in the order given. A panel without
/// any finite point shows "no data".
struct Panel {
  std::string title = {};
  Axis x = {};
  Axis y = {};
  std::vector<Line> lines = {};
  std::vector<Markers> markers = {};
};

/// Panels row by row under a title, a subtitle and the legend. Several panels in one column with
/// equal x axes share the x range, and only the lowest one shows its numbers and title. A line and
/// markers of the same name, in whatever panels, have one legend entry; the first ones are shown.
struct Figure {
  std::string title = {};
  std::string subtitle = {};
  std::vector<Panel> panels = {};
  int columns = 1;
  double panel_width = 640;   ///< Width of a panel's plot area without titles and numbers, px.
  double panel_height = 300;  ///< Height of the same, px.
};

/// Colours that stay apart under colour blindness, on white (Okabe and Ito 2008, without the
/// yellow, which is too faint for lines, and with a grey).
std::span<const std::string_view> palette();

/// The figure as a complete SVG document, the same bytes for the same figure. Throws
/// std::invalid_argument on a line with unequal numbers of x and y, bounds that are not finite or
/// not in order, sizes that are not positive, and columns < 1.
std::string to_svg(const Figure& figure);

}  // namespace camlaw::cli
