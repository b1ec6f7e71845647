// SPDX-License-Identifier: MIT
#include "output/figure/chart.h"

#include <algorithm>
#include <cmath>
#include <utility>

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

/// Draws one panel.
class PanelPainter {
 public:
  PanelPainter(Svg& svg, const ChartPlan& plan, const PlannedPanel& panel)
      : svg_(svg), plan_(plan), planned_(panel), frame_(panel.frame) {}

  void draw() {
    draw_grid();
    draw_lines();
    draw_markers();
    draw_labels();
    svg_.frame(frame_, kFrameColour);
    draw_x_axis();
    draw_y_axis();
    if (!planned_.has_data)
      svg_.text("no-data", {(frame_.left + frame_.right) / 2, (frame_.top + frame_.bottom) / 2},
                "no data", {.size = size::kPanelFont, .anchor = Anchor::Middle});
    for (std::size_t i = 0; i < planned_.title.size(); ++i) {
      const auto lines_below = static_cast<double>(planned_.title.size() - 1 - i);
      svg_.text("panel-title", {frame_.left, frame_.top - 6 - lines_below * size::kPanelLine},
                planned_.title[i], {.size = size::kPanelFont, .bold = true});
    }
  }

 private:
  DrawnPoint from_unit(DrawnPoint p) const {
    return {frame_.left + p.x * (frame_.right - frame_.left),
            frame_.bottom - p.y * (frame_.bottom - frame_.top)};
  }
  double x_px(double x) const { return from_unit({unit_position(x, planned_.x.range), 0}).x; }
  double y_px(double y) const { return from_unit({0, unit_position(y, planned_.y.range)}).y; }

  LineSegment upright(double x) const { return {{x, frame_.top}, {x, frame_.bottom}}; }
  LineSegment level(double y) const { return {{frame_.left, y}, {frame_.right, y}}; }

  static bool crosses_zero(Range range) { return range.lower < 0 && range.upper > 0; }

  void draw_grid() {
    for (const double x : planned_.x.ticks) svg_.line("grid", upright(x_px(x)), {kGridColour});
    for (const double y : planned_.y.ticks) svg_.line("grid", level(y_px(y)), {kGridColour});
    if (crosses_zero(planned_.x.range)) svg_.line("zero", upright(x_px(0)), {kZeroColour});
    if (crosses_zero(planned_.y.range)) svg_.line("zero", level(y_px(0)), {kZeroColour});
  }

  std::string_view colour_of(const std::string& given, const std::string& name) const {
    if (!given.empty()) return given;
    const auto entry = std::ranges::find(plan_.legend, name, &LegendEntry::name);
    return entry != plan_.legend.end() ? std::string_view(entry->colour) : palette()[0];
  }

  void draw_lines() {
    // One px more, or else a curve along the frame loses half its width.
    svg_.begin_clip({frame_.left - 1, frame_.top - 1, frame_.right + 1, frame_.bottom + 1});
    for (const Line& line : planned_.panel->lines)
      for (auto& piece : clipped_curve(line.x, line.y, planned_.x.range, planned_.y.range)) {
        for (DrawnPoint& p : piece) p = from_unit(p);
        svg_.polyline(piece, {colour_of(line.colour, line.name), line.width, line.dashed});
        for (std::size_t i = 1; i < piece.size(); ++i)
          around_.lines.push_back({piece[i - 1], piece[i]});
      }
    svg_.end_clip();
  }

  bool is_visible(const Marker& point) const {
    const Range& x = planned_.x.range;
    const Range& y = planned_.y.range;
    return point.x >= x.lower && point.x <= x.upper && point.y >= y.lower && point.y <= y.upper;
  }

  /// Label and tooltip in one, without saying the label twice.
  static std::string tooltip_of(const Marker& point) {
    if (point.tooltip.empty()) return point.label;
    if (point.tooltip.find(point.label) != std::string::npos) return point.tooltip;
    return point.label + ": " + point.tooltip;
  }

  void draw_markers() {
    for (const Markers& series : planned_.panel->markers) {
      const MarkerStyle style{series.shape, colour_of(series.colour, series.name), series.filled,
                              series.size};
      for (const Marker& point : series.points) {
        if (!is_visible(point)) continue;
        const DrawnPoint at{x_px(point.x), y_px(point.y)};
        svg_.marker(at, style, tooltip_of(point));
        const double r = series.size;
        around_.markers.push_back({at.x - r, at.y - r, at.x + r, at.y + r});
        if (point.label.empty()) continue;
        texts_.push_back(point.label);
        labels_.push_back({at, r, text_width(point.label, size::kSmallFont), size::kSmallFont + 1});
      }
    }
  }

  void draw_labels() {
    around_.frame = frame_;
    const auto places = place_labels(labels_, around_);
    for (const auto& place : places)
      if (place && place->leader) svg_.line("leader", *place->leader, {kLeaderColour, 0.8});
    for (std::size_t i = 0; i < places.size(); ++i)
      if (places[i]) draw_label(labels_[i], places[i]->box, texts_[i]);
  }

  /// The text is set against the box's side that faces the point, as the width is an estimate.
  void draw_label(const Label& label, const Rect& box, const std::string& text) {
    DrawnPoint at{(box.left + box.right) / 2, box.bottom - 2.5};
    Anchor anchor = Anchor::Middle;
    if (box.left >= label.anchor.x) {
      at.x = box.left;
      anchor = Anchor::Start;
    } else if (box.right <= label.anchor.x) {
      at.x = box.right;
      anchor = Anchor::End;
    }
    svg_.text("label", at, text, {.size = size::kSmallFont, .anchor = anchor, .halo = true});
  }

  /// Every n-th number is shown so that neighbours stay apart by 8 px.
  std::size_t label_step() const {
    if (planned_.x.ticks.size() < 2) return 1;
    double width = 0;
    for (const auto& text : planned_.x.labels)
      width = std::max(width, text_width(text, size::kSmallFont));
    const double spacing = x_px(planned_.x.ticks[1]) - x_px(planned_.x.ticks[0]);
    return static_cast<std::size_t>(std::max(1.0, std::ceil((width + 8) / std::max(spacing, 1.0))));
  }

  void draw_x_axis() {
    const double y = frame_.bottom;
    for (const double tick : planned_.x.ticks)
      svg_.line("tick", {{x_px(tick), y}, {x_px(tick), y + size::kTick}}, {kFrameColour});
    if (!planned_.shows_x) return;
    const std::size_t step = label_step();
    for (std::size_t i = 0; i < planned_.x.ticks.size(); i += step)
      svg_.text("number", {x_px(planned_.x.ticks[i]), y + size::kTick + 12}, planned_.x.labels[i],
                {.size = size::kSmallFont, .anchor = Anchor::Middle});
    for (std::size_t i = 0; i < planned_.x.title.size(); ++i)
      svg_.text("axis-title",
                {(frame_.left + frame_.right) / 2,
                 y + size::kTick + 14 + static_cast<double>(i + 1) * size::kTextLine},
                planned_.x.title[i], {.size = size::kTextFont, .anchor = Anchor::Middle});
  }

  void draw_y_axis() {
    for (std::size_t i = 0; i < planned_.y.ticks.size(); ++i) {
      const double y = y_px(planned_.y.ticks[i]);
      svg_.line("tick", {{frame_.left - size::kTick, y}, {frame_.left, y}}, {kFrameColour});
      svg_.text("number", {frame_.left - size::kTick - 3, y + 4}, planned_.y.labels[i],
                {.size = size::kSmallFont, .anchor = Anchor::End});
    }
    // The last line stands next to the widest number of all panels, the same in every panel.
    const double right = frame_.left - size::kTick - 10 - plan_.number_width;
    for (std::size_t i = 0; i < planned_.y.title.size(); ++i) {
      const auto lines_right = static_cast<double>(planned_.y.title.size() - 1 - i);
      svg_.text("axis-title",
                {right - lines_right * size::kTextLine, (frame_.top + frame_.bottom) / 2},
                planned_.y.title[i],
                {.size = size::kTextFont, .anchor = Anchor::Middle, .upwards = true});
    }
  }

  Svg& svg_;
  const ChartPlan& plan_;
  const PlannedPanel& planned_;
  const Rect& frame_;
  Surroundings around_;
  std::vector<Label> labels_;
  std::vector<std::string> texts_;
};

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
  for (const PlannedPanel& panel : plan.panels) PanelPainter(svg, plan, panel).draw();
  return std::move(svg).finish();
}

}  // namespace camlaw::cli
