// SPDX-License-Identifier: MIT
#include "output/report/figure_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "output/report/html.h"

namespace camlaw::cli {
namespace {

Json bound(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json axis_json(const Axis& axis) {
  return {{"label", axis.label},
          {"unit", typeset(axis.unit)},
          {"lower", bound(axis.lower)},
          {"upper", bound(axis.upper)}};
}

}  // namespace

Json drawn_number(double value) {
  if (!std::isfinite(value)) return nullptr;
  return std::strtod(fmt::format("{:.6g}", value + 0.0).c_str(), nullptr);
}

Json drawn_numbers(const std::vector<double>& values) {
  constexpr double kRounding = 1e-12;  // of the largest: what rounding leaves of 0, drawn as 0
  double size = 0;
  for (const double value : values) {
    if (std::isfinite(value)) size = std::max(size, std::abs(value));
  }
  Json result = Json::array();
  for (const double value : values) {
    result.push_back(drawn_number(std::abs(value) < kRounding * size ? 0 : value));
  }
  return result;
}

Json panels_json(const Figure& figure, const std::vector<PanelWords>& words) {
  Json panels = Json::array();
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    const Panel& panel = figure.panels[i];
    Json limits = Json::array();
    for (std::size_t k = 1; k < panel.lines.size(); ++k) {
      limits.push_back(drawn_number(panel.lines[k].y.front()));
    }
    panels.push_back({{"id", panel.y.label},
                      {"name", words[i].name},
                      {"x", axis_json(panel.x)},
                      {"y", axis_json(panel.y)},
                      {"limits", std::move(limits)}});
  }
  return panels;
}

Json lines_json(const Figure& figure) {
  Json grids = Json::array(), lines = Json::array();
  std::vector<const std::vector<double>*> known;
  for (const Panel& panel : figure.panels) {
    const Line& line = panel.lines.front();
    std::size_t grid = 0;
    while (grid < known.size() && *known[grid] != line.x) ++grid;
    if (grid == known.size()) {
      known.push_back(&line.x);
      grids.push_back(drawn_numbers(line.x));
    }
    lines.push_back({{"grid", grid}, {"y", drawn_numbers(line.y)}});
  }
  return {{"grids", std::move(grids)}, {"lines", std::move(lines)}};
}

}  // namespace camlaw::cli
