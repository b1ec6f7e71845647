// SPDX-License-Identifier: MIT
#include "output/figure/chart.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "output/figure/chart_labels.h"
#include "output/figure/chart_plan.h"
#include "output/figure/chart_scale.h"
#include "output/figure/chart_svg.h"

namespace camlaw::cli {
namespace {

namespace size = chart_size;

constexpr std::string_view kGridColour = "#E4E4E4";
constexpr std::string_view kZeroColour = "#9A9A9A";
constexpr std::string_view kFrameColour = "#444444";
constexpr std::string_view kLeaderColour = "#777777";

/// Places of a panel in px.
DrawnPoint from_unit(const Rect& frame, DrawnPoint p) {
  return {frame.left + p.x * (frame.right - frame.left),
          frame.bottom - p.y * (frame.bottom - frame.top)};
}
double x_px(const PlannedPanel& panel, double x) {
  return from_unit(panel.frame, {unit_position(x, panel.x.range), 0}).x;
}
double y_px(const PlannedPanel& panel, double y) {
  return from_unit(panel.frame, {0, unit_position(y, panel.y.range)}).y;
}

void draw_grid(Svg& svg, const PlannedPanel& panel) {
  const auto upright = [&](double x, std::string_view kind, std::string_view colour) {
    const double at = x_px(panel, x);
    svg.line(kind, {{at, panel.frame.top}, {at, panel.frame.bottom}}, {colour});
  };
  const auto level = [&](double y, std::string_view kind, std::string_view colour) {
    const double at = y_px(panel, y);
    svg.line(kind, {{panel.frame.left, at}, {panel.frame.right, at}}, {colour});
  };
  const auto crosses_zero = [](Range range) { return range.lower < 0 && range.upper > 0; };
  for (const double x : panel.x.ticks) upright(x, "grid", kGridColour);
  for (const double y : panel.y.ticks) level(y, "grid", kGridColour);
  if (crosses_zero(panel.x.range)) upright(0, "zero", kZeroColour);
  if (crosses_zero(panel.y.range)) level(0, "zero", kZeroColour);
}

std::string_view colour_of(const ChartPlan& plan, const std::string& given,
                           const std::string& name) {
  if (!given.empty()) return given;
  const auto entry = std::ranges::find(plan.legend, name, &LegendEntry::name);
  return entry != plan.legend.end() ? std::string_view(entry->colour) : palette()[0];
}

/// Returns what was drawn.
std::vector<LineSegment> draw_lines(Svg& svg, const ChartPlan& plan, const PlannedPanel& panel) {
  const Rect& frame = panel.frame;
  std::vector<LineSegment> drawn;
  // One px more, or else a curve along the frame loses half its width.
  svg.begin_clip({frame.left - 1, frame.top - 1, frame.right + 1, frame.bottom + 1});
  for (const Line& line : panel.panel->lines)
    for (auto& piece : clipped_curve(line.x, line.y, panel.x.range, panel.y.range)) {
      for (DrawnPoint& p : piece) p = from_unit(frame, p);
      svg.polyline(piece, {colour_of(plan, line.colour, line.name), line.width, line.dashed});
      for (std::size_t i = 1; i < piece.size(); ++i) drawn.push_back({piece[i - 1], piece[i]});
    }
  svg.end_clip();
  return drawn;
}

bool is_visible(const PlannedPanel& panel, const Marker& point) {
  const Range &x = panel.x.range, &y = panel.y.range;
  return point.x >= x.lower && point.x <= x.upper && point.y >= y.lower && point.y <= y.upper;
}

/// Label and tooltip in one, without saying the label twice.
std::string tooltip_of(const Marker& point) {
  if (point.tooltip.empty()) return point.label;
  if (point.tooltip.find(point.label) != std::string::npos) return point.tooltip;
  return point.label + ": " + point.tooltip;
}

/// The markers of a panel, and the labels that belong to them.
struct DrawnMarkers {
  std::vector<Rect> boxes;
  std::vector<Label> labels;
  std::vector<std::string> texts;  ///< of the labels
};

DrawnMarkers draw_markers(Svg& svg, const ChartPlan& plan, const PlannedPanel& panel) {
  DrawnMarkers drawn;
  for (const Markers& series : panel.panel->markers) {
    const MarkerStyle style{series.shape, colour_of(plan, series.colour, series.name),
                            series.filled, series.size};
    for (const Marker& point : series.points) {
      if (!is_visible(panel, point)) continue;
      const DrawnPoint at{x_px(panel, point.x), y_px(panel, point.y)};
      svg.marker(at, style, tooltip_of(point));
      const double r = series.size;
      drawn.boxes.push_back({at.x - r, at.y - r, at.x + r, at.y + r});
      if (point.label.empty()) continue;
      drawn.texts.push_back(point.label);
      drawn.labels.push_back(
          {at, r, text_width(point.label, size::kSmallFont), size::kSmallFont + 1});
    }
  }
  return drawn;
}

/// The text is set against the box's side that faces the point, as the width is an estimate.
void draw_label(Svg& svg, const Label& label, const Rect& box, const std::string& text) {
  DrawnPoint at{(box.left + box.right) / 2, box.bottom - 2.5};
  Anchor anchor = Anchor::Middle;
  if (box.left >= label.anchor.x) {
    at.x = box.left;
    anchor = Anchor::Start;
  } else if (box.right <= label.anchor.x) {
    at.x = box.right;
    anchor = Anchor::End;
  }
  svg.text("label", at, text, {.size = size::kSmallFont, .anchor = anchor, .halo = true});
}

/// Where neither lines nor markers are.
void draw_labels(Svg& svg, const Rect& frame, std::vector<LineSegment> lines,
                 const DrawnMarkers& markers) {
  const auto places = place_labels(markers.labels, {frame, markers.boxes, std::move(lines)});
  for (const auto& place : places)
    if (place && place->leader) svg.line("leader", *place->leader, {kLeaderColour, 0.8});
  for (std::size_t i = 0; i < places.size(); ++i)
    if (places[i]) draw_label(svg, markers.labels[i], places[i]->box, markers.texts[i]);
}

/// Every n-th number is shown so that neighbours stay apart by 8 px.
std::size_t label_step(const PlannedPanel& panel) {
  if (panel.x.ticks.size() < 2) return 1;
  double width = 0;
  for (const auto& text : panel.x.labels)
    width = std::max(width, text_width(text, size::kSmallFont));
  const double spacing = x_px(panel, panel.x.ticks[1]) - x_px(panel, panel.x.ticks[0]);
  return static_cast<std::size_t>(std::max(1.0, std::ceil((width + 8) / std::max(spacing, 1.0))));
}

/// A number with its sign as it is printed; the hyphen of an exponent stays.
std::string with_minus(const std::string& label) {
  return label.starts_with('-') ? "\u2212" + label.substr(1) : label;
}

void draw_x_axis(Svg& svg, const PlannedPanel& panel) {
  const PlannedAxis& axis = panel.x;
  const double y = panel.frame.bottom;
  for (const double tick : axis.ticks)
    svg.line("tick", {{x_px(panel, tick), y}, {x_px(panel, tick), y + size::kTick}},
             {kFrameColour});
  if (!panel.shows_x) return;
  const std::size_t step = label_step(panel);
  for (std::size_t i = 0; i < axis.ticks.size(); i += step)
    svg.text("number", {x_px(panel, axis.ticks[i]), y + size::kTick + 12},
             with_minus(axis.labels[i]), {.size = size::kSmallFont, .anchor = Anchor::Middle});
  for (std::size_t i = 0; i < axis.title.size(); ++i)
    svg.text("axis-title",
             {(panel.frame.left + panel.frame.right) / 2,
              y + size::kTick + 14 + static_cast<double>(i + 1) * size::kTextLine},
             axis.title[i], {.size = size::kTextFont, .anchor = Anchor::Middle});
}

/// `number_width`: of the widest number of all panels, beside which the title stands in each.
void draw_y_axis(Svg& svg, const PlannedPanel& panel, double number_width) {
  const PlannedAxis& axis = panel.y;
  const Rect& frame = panel.frame;
  for (std::size_t i = 0; i < axis.ticks.size(); ++i) {
    const double y = y_px(panel, axis.ticks[i]);
    svg.line("tick", {{frame.left - size::kTick, y}, {frame.left, y}}, {kFrameColour});
    svg.text("number", {frame.left - size::kTick - 3, y + 4}, with_minus(axis.labels[i]),
             {.size = size::kSmallFont, .anchor = Anchor::End});
  }
  const double right = frame.left - size::kTick - 10 - number_width;
  for (std::size_t i = 0; i < axis.title.size(); ++i) {
    const auto lines_right = static_cast<double>(axis.title.size() - 1 - i);
    svg.text("axis-title", {right - lines_right * size::kTextLine, (frame.top + frame.bottom) / 2},
             axis.title[i], {.size = size::kTextFont, .anchor = Anchor::Middle, .upwards = true});
  }
}

void draw_panel(Svg& svg, const ChartPlan& plan, const PlannedPanel& panel) {
  const Rect& frame = panel.frame;
  draw_grid(svg, panel);
  std::vector<LineSegment> lines = draw_lines(svg, plan, panel);
  draw_labels(svg, frame, std::move(lines), draw_markers(svg, plan, panel));
  svg.frame(frame, kFrameColour);
  draw_x_axis(svg, panel);
  draw_y_axis(svg, panel, plan.number_width);
  if (!panel.has_data)
    svg.text("no-data", {(frame.left + frame.right) / 2, (frame.top + frame.bottom) / 2}, "no data",
             {.size = size::kPanelFont, .anchor = Anchor::Middle});
  for (std::size_t i = 0; i < panel.title.size(); ++i) {
    const auto lines_below = static_cast<double>(panel.title.size() - 1 - i);
    svg.text("panel-title", {frame.left, frame.top - 6 - lines_below * size::kPanelLine},
             panel.title[i], {.size = size::kPanelFont, .bold = true});
  }
}

void draw_legend(Svg& svg, const ChartPlan& plan) {
  for (const LegendEntry& entry : plan.legend) {
    const DrawnPoint at = entry.position;
    const double end = at.x + size::kLegendSample;
    if (entry.line)
      svg.line("legend", {at, {end, at.y}}, {entry.colour, entry.line->width, entry.line->dashed});
    if (entry.markers)
      svg.marker({(at.x + end) / 2, at.y},
                 {entry.markers->shape, entry.colour, entry.markers->filled, entry.markers->size},
                 "");
    svg.text("legend", {end + size::kLegendGap, at.y + 4}, entry.name, {.size = size::kTextFont});
  }
}

void draw_head(Svg& svg, const ChartPlan& plan) {
  double y = size::kMargin;
  for (const std::string& line : plan.title) {
    y += size::kTitleLine;
    svg.text("title", {plan.left, y - 5}, line, {.size = size::kTitleFont, .bold = true});
  }
  for (const std::string& line : plan.subtitle) {
    y += size::kTextLine;
    svg.text("subtitle", {plan.left, y - 4}, line, {.size = size::kTextFont});
  }
}

}  // namespace

std::span<const std::string_view> palette() {
  static constexpr std::string_view kColours[] = {"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                                  "#E69F00", "#56B4E9", "#000000", "#8C8C8C"};
  return kColours;
}

std::string to_svg(const Figure& figure) {
  const ChartPlan plan = make_plan(figure);
  Svg svg(plan.width, plan.height, figure.title);
  draw_head(svg, plan);
  draw_legend(svg, plan);
  for (const PlannedPanel& panel : plan.panels) draw_panel(svg, plan, panel);
  return std::move(svg).finish();
}

}  // namespace camlaw::cli
