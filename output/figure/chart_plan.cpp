// SPDX-License-Identifier: MIT
#include "output/figure/chart_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace camlaw::cli {
namespace {

namespace size = chart_size;

void check_size(const char* what, double value) {
  if (!(value > 0 && value <= 1e5))
    throw std::invalid_argument(
        fmt::format("chart: {} is {}; it must be above 0 and at most 100000", what, value));
}

void check(const Panel& panel) {
  for (const Line& line : panel.lines) {
    check_size("line width", line.width);
    if (line.x.size() != line.y.size())
      throw std::invalid_argument(fmt::format("chart: line '{}' has {} x and {} y values",
                                              line.name, line.x.size(), line.y.size()));
  }
  for (const Markers& markers : panel.markers) check_size("marker size", markers.size);
}

void check(const Figure& figure) {
  if (figure.columns < 1)
    throw std::invalid_argument(
        fmt::format("chart: columns is {}; it must be 1 or more", figure.columns));
  check_size("panel_width", figure.panel_width);
  check_size("panel_height", figure.panel_height);
  for (const Panel& panel : figure.panels) check(panel);
}

/// Coordinates of the panel's points that can be drawn.
struct Data {
  std::vector<double> x, y;

  void add(double px, double py) {
    if (!is_drawable(px) || !is_drawable(py)) return;
    x.push_back(px);
    y.push_back(py);
  }
};

Data data_of(const Panel& panel) {
  Data data;
  for (const Line& line : panel.lines)
    for (std::size_t i = 0; i < line.x.size(); ++i) data.add(line.x[i], line.y[i]);
  for (const Markers& markers : panel.markers)
    for (const Marker& point : markers.points) data.add(point.x, point.y);
  return data;
}

PlannedAxis plan_axis(const Axis& axis, std::optional<Range> data, double length) {
  PlannedAxis planned;
  planned.range = axis_range(axis.label, data, axis.lower, axis.upper);
  const auto ticks = axis.unit == "deg" ? degree_ticks : nice_ticks;
  planned.ticks = ticks(planned.range.lower, planned.range.upper);
  planned.labels = tick_labels(planned.ticks);
  const std::string title = axis.unit.empty() ? axis.label : axis.label + ", " + axis.unit;
  planned.title = wrap_text(title, size::kTextFont, length);
  return planned;
}

/// Whether the panels stand in one column over the same x axis.
bool shares_x(const Figure& figure) {
  return figure.columns == 1 && figure.panels.size() > 1 &&
         std::ranges::all_of(figure.panels,
                             [&](const Panel& p) { return p.x == figure.panels.front().x; });
}

std::vector<PlannedPanel> plan_panels(const Figure& figure) {
  std::vector<Data> data;
  std::vector<double> all_x;
  for (const Panel& panel : figure.panels) {
    data.push_back(data_of(panel));
    all_x.insert(all_x.end(), data.back().x.begin(), data.back().x.end());
  }
  const bool shared = shares_x(figure);
  std::vector<PlannedPanel> planned;
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    const Panel& panel = figure.panels[i];
    planned.push_back(
        {.panel = &panel,
         .x = plan_axis(panel.x, extent(shared ? all_x : data[i].x), figure.panel_width),
         .y = plan_axis(panel.y, extent(data[i].y), figure.panel_height),
         .title = wrap_text(panel.title, size::kPanelFont, figure.panel_width),
         .has_data = !data[i].x.empty(),
         .shows_x = !shared || i + 1 == figure.panels.size()});
  }
  return planned;
}

/// The entry of that name, made if there is none; null for an empty name.
LegendEntry* entry_of(std::vector<LegendEntry>& legend, const std::string& name) {
  if (name.empty()) return nullptr;
  const auto found = std::ranges::find(legend, name, &LegendEntry::name);
  return found != legend.end() ? &*found : &legend.emplace_back(LegendEntry{.name = name});
}

std::vector<LegendEntry> collect_legend(const Figure& figure) {
  std::vector<LegendEntry> legend;
  for (const Panel& panel : figure.panels) {
    for (const Line& line : panel.lines)
      if (LegendEntry* entry = entry_of(legend, line.name)) {
        if (!entry->line) entry->line = &line;
        if (entry->colour.empty()) entry->colour = line.colour;
      }
    for (const Markers& markers : panel.markers)
      if (LegendEntry* entry = entry_of(legend, markers.name)) {
        if (!entry->markers) entry->markers = &markers;
        if (entry->colour.empty()) entry->colour = markers.colour;
      }
  }
  for (std::size_t i = 0; i < legend.size(); ++i)
    if (legend[i].colour.empty()) legend[i].colour = palette()[i % palette().size()];
  return legend;
}

double legend_width(const LegendEntry& entry) {
  return size::kLegendSample + size::kLegendGap + text_width(entry.name, size::kTextFont);
}

double widest(const std::vector<std::string>& lines, double font_size) {
  double width = 0;
  for (const std::string& line : lines) width = std::max(width, text_width(line, font_size));
  return width;
}

/// Margins between a panel's frame and its cell of the grid, the same for all panels so that their
/// frames are in line.
struct Margins {
  double left = 0, right = 0, top = 0, bottom = 0, closed_bottom = 0;
  double number_width = 0;  ///< Part of left.
};

Margins margins_of(const std::vector<PlannedPanel>& panels) {
  double y_label = 0, x_label = 0;
  std::size_t y_lines = 0, x_lines = 0, titles = 0;
  for (const PlannedPanel& p : panels) {
    y_label = std::max(y_label, widest(p.y.labels, size::kSmallFont));
    x_label = std::max(x_label, widest(p.x.labels, size::kSmallFont));
    y_lines = std::max(y_lines, p.y.title.size());
    x_lines = std::max(x_lines, p.x.title.size());
    titles = std::max(titles, p.title.size());
  }
  const auto lines = [](std::size_t n, double height) { return static_cast<double>(n) * height; };
  return {.left = size::kMargin + lines(y_lines, size::kTextLine) + y_label + size::kTick + 8,
          .right = std::max(size::kMargin, x_label / 2 + 4),
          .top = lines(titles, size::kPanelLine),
          .bottom = size::kTick + 16 + lines(x_lines, size::kTextLine) + size::kMargin,
          .closed_bottom = size::kMargin,
          .number_width = y_label};
}

/// Places the legend's entries in rows from the height y on; the height after the last row.
double place_legend(ChartPlan& plan, double y) {
  double x = plan.left;
  for (LegendEntry& entry : plan.legend) {
    const double width = legend_width(entry);
    if (x > plan.left && x + width > plan.width - size::kMargin) {
      x = plan.left;
      y += size::kLegendRow;
    }
    entry.position = {x, y + size::kLegendRow / 2};
    x += width + 1.5 * size::kMargin;
  }
  return plan.legend.empty() ? y : y + size::kLegendRow;
}

/// Places the frames row by row from the height y on; the height after the last row.
double place_panels(ChartPlan& plan, const Figure& figure, const Margins& margins, double y) {
  const auto columns = static_cast<std::size_t>(figure.columns);
  const double cell = margins.left + figure.panel_width + margins.right;
  for (std::size_t i = 0; i < plan.panels.size(); ++i) {
    PlannedPanel& p = plan.panels[i];
    const double left = margins.left + static_cast<double>(i % columns) * cell;
    const double top = y + margins.top;
    p.frame = {left, top, left + figure.panel_width, top + figure.panel_height};
    if (i % columns + 1 == columns || i + 1 == plan.panels.size())
      y = p.frame.bottom + (p.shows_x ? margins.bottom : margins.closed_bottom);
  }
  return y;
}

/// The width that the panels need, or the longest legend entry if that is more.
double figure_width(const ChartPlan& plan, const Figure& figure, const Margins& margins) {
  const double cell = margins.left + figure.panel_width + margins.right;
  double width = cell * std::min(figure.columns, std::max(1, static_cast<int>(plan.panels.size())));
  for (const LegendEntry& entry : plan.legend)
    width = std::max(width, plan.left + legend_width(entry) + size::kMargin);
  return std::ceil(width);
}

}  // namespace

ChartPlan make_plan(const Figure& figure) {
  check(figure);
  ChartPlan plan;
  plan.panels = plan_panels(figure);
  plan.legend = collect_legend(figure);
  const Margins margins = margins_of(plan.panels);
  plan.left = margins.left;
  plan.number_width = margins.number_width;
  plan.width = figure_width(plan, figure, margins);
  const double room = plan.width - plan.left - size::kMargin;
  plan.title = wrap_text(figure.title, 1.12 * size::kTitleFont, room);  // Bold is wider.
  plan.subtitle = wrap_text(figure.subtitle, size::kTextFont, room);
  double y = size::kMargin + static_cast<double>(plan.title.size()) * size::kTitleLine +
             static_cast<double>(plan.subtitle.size()) * size::kTextLine;
  y = place_legend(plan, y + 4) + size::kMargin / 2;
  plan.height = std::ceil(place_panels(plan, figure, margins, y));
  return plan;
}

}  // namespace camlaw::cli
