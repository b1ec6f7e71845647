// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "output/figure/chart_scale.h"

/// The text of a chart: estimated widths, line wrapping, and places for the labels of points. All
/// lengths in px, y downwards.
namespace camlaw::cli {

struct Rect {
  double left = 0;
  double top = 0;
  double right = 0;
  double bottom = 0;
};

struct LineSegment {
  DrawnPoint a;
  DrawnPoint b;
};

bool overlap(const Rect& a, const Rect& b);
bool overlap(const Rect& rect, const LineSegment& segment);

/// Estimated width of UTF-8 text in a sans-serif font. The widths are those of DejaVu Sans, the
/// widest of the usual ones, so that text set in another font is narrower than estimated.
double text_width(std::string_view text, double font_size);

/// The text in lines of at most the width, broken at spaces; a longer word has its own line.
std::vector<std::string> wrap_text(std::string_view text, double font_size, double width);

/// A label of the given width and height for a point that is drawn within +-reach of the anchor.
struct Label {
  DrawnPoint anchor;
  double reach = 0;
  double width = 0;
  double height = 0;
};

/// Where a label goes, and the thin line from its point to it if it is not close by.
struct Placement {
  Rect box;
  std::optional<LineSegment> leader;
};

/// What labels keep clear of: all within frame, never over markers, over lines only if there is no
/// other place.
struct Surroundings {
  Rect frame;
  std::vector<Rect> markers;
  std::vector<LineSegment> lines;
};

/// Greedy placement in the order given: the first free one of 12 directions, close to the point,
/// then farther and farther away with a leader. No two labels overlap, no leader crosses a label,
/// another leader or another point's marker. A label without a free place gets none.
std::vector<std::optional<Placement>> place_labels(std::span<const Label> labels,
                                                   const Surroundings& surroundings);

}  // namespace camlaw::cli
