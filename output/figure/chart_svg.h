// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "output/export/xml_text.h"
#include "output/figure/chart.h"
#include "output/figure/chart_labels.h"

/// SVG elements as text, with numbers of two decimals and escaped strings.
namespace camlaw::cli {

/// The number with two decimals, never -0.00.
std::string svg_number(double value);

using problems::xml_escape;

struct Stroke {
  std::string_view colour;
  double width = 1;
  bool dashed = false;
};

enum class Anchor { Start, Middle, End };

struct TextStyle {
  double size = 12;
  Anchor anchor = Anchor::Start;
  bool bold = false;
  bool upwards = false;  ///< Turned by 90 degrees, read from below.
  bool halo = false;     ///< With a white outline, to be readable over lines.
};

struct MarkerStyle {
  MarkerShape shape = MarkerShape::Circle;
  std::string_view colour;
  bool filled = true;
  double size = 4;
};

/// A document under construction. `kind` arguments become class attributes.
class Svg {
 public:
  /// A white page; the description is for screen readers.
  Svg(double width, double height, std::string_view description);

  void line(std::string_view kind, const LineSegment& segment, const Stroke& stroke);
  void polyline(std::span<const DrawnPoint> points, const Stroke& stroke);
  void frame(const Rect& rect, std::string_view colour);
  void text(std::string_view kind, DrawnPoint position, std::string_view text,
            const TextStyle& style);
  /// A marker with an optional tooltip.
  void marker(DrawnPoint centre, const MarkerStyle& style, std::string_view tooltip);
  /// What follows until end_clip is drawn within the rectangle only.
  void begin_clip(const Rect& rect);
  void end_clip();
  std::string finish() &&;

 private:
  void rect(std::string_view attributes, const Rect& rect);

  std::string out_;
};

}  // namespace camlaw::cli
