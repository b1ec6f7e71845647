// SPDX-License-Identifier: MIT
#include "cli/report/front_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/report/figure_json.h"
#include "cli/report/html.h"
#include "cli/report/scene.h"
#include "cli/text_table.h"

namespace camlaw::cli {
namespace {

using optim::FrontPoint;

/// Designs that a report carries at most: each with its curves.
constexpr std::size_t kMostDesigns = 200;
/// Curves of all of them together, beyond which only those are kept that a front is read with.
constexpr std::size_t kMostCurves = 1200;
/// Samples of a curve, at least.
constexpr int kFewSamples = 48;

/// One row of the comparison: what it is, as text and as a number.
Json row(const std::string& what, const std::string& text, double number) {
  return Json::array({what, text, drawn_number(number)});
}

/// The greatest margin of each limit along the front, beside which rounding shows as such: where
/// the limit is active all along it, a thousandth of its unit.
std::vector<double> margin_sizes(const FrontAnswer& answer) {
  std::vector<double> sizes;
  for (const FrontPoint& point : answer.front.points) {
    sizes.resize(std::max(sizes.size(), point.limits.size()), 1e-3);
    for (std::size_t i = 0; i < point.limits.size(); ++i) {
      sizes[i] = std::max(sizes[i], std::abs(point.limits[i].margin));
    }
  }
  return sizes;
}

bool is_sought(const FrontAnswer& answer, const std::string& name) {
  const auto& objectives = answer.front.objectives;
  return std::any_of(objectives.begin(), objectives.end(),
                     [&](const optim::ObjectiveName& o) { return o.name == name; });
}

/// What is said of a design where two are compared.
Json rows_json(const FrontAnswer& answer, const FrontPoint& point,
               const std::vector<double>& margins) {
  constexpr std::size_t kMostValues = 24, kLongLaw = 120;
  Json rows = Json::array();
  for (std::size_t i = 0; i < point.objectives.size(); ++i) {
    const auto& o = answer.front.objectives[i];
    rows.push_back(
        row(named_with_unit(o.name, o.unit), in_digits(point.objectives[i]), point.objectives[i]));
  }
  rows.push_back(row("verdict", verdict_words(point), NAN));
  const std::string law = answer.law(point);
  if (!law.empty()) {
    rows.push_back(row("law", law.size() > kLongLaw ? answer.family(point) : law, NAN));
  }
  const auto values = answer.values(point);
  for (const auto& value : values) {
    if (value.name == "law" || values.size() > kMostValues || is_sought(answer, value.name))
      continue;
    rows.push_back(row(named_with_unit(value.name, value.unit), value.text, value.number));
  }
  for (std::size_t i = 0; i < point.limits.size(); ++i) {
    const optim::Standing& limit = point.limits[i];
    const std::string margin = significant(limit.margin, margins[i], 4);
    rows.push_back(row("margin of " + named_with_unit(limit.name, limit.unit), margin,
                       margin == "0" ? 0 : limit.margin));
  }
  if (answer.ruler) {
    const double lambda = answer.ruler->limit_index(point.objectives);
    rows.push_back(row("lambda, 1 where no law is better", shown(lambda, 4), lambda));
  }
  return rows;
}

/// Samples of each curve that leave the file small.
int samples_for(std::size_t designs, std::size_t panels) {
  constexpr double kBytes = 1.4e6, kOfNumber = 8;
  const double numbers = kBytes / kOfNumber / static_cast<double>(designs * std::max(panels, 1UL));
  return std::clamp(static_cast<int>(numbers), kFewSamples, 240);
}

/// Of a machine with very many curves those that a front is read with: motions, and what is sought,
/// limited or a load.
void keep_essential(Figure& figure, std::vector<PanelWords>& words, const FrontAnswer& answer) {
  std::vector<Panel> panels;
  std::vector<PanelWords> kept;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& name = figure.panels[i].y.label;
    bool keep = !words[i].limits.empty() || words[i].group == "Motion" ||
                name == "pressure_angle" || name == "follower_force" || name == "drive_torque" ||
                name == "contact_stress";
    for (const auto& o : answer.study.bound().statement().objectives) {
      keep = keep || (o.response.response != nullptr && o.response.response->name == name);
    }
    if (!keep) continue;
    panels.push_back(figure.panels[i]);
    kept.push_back(words[i]);
  }
  figure.panels = std::move(panels);
  words = std::move(kept);
}

/// The curves of a design, in the panels of the first one.
Figure like(const Figure& first, const problems::ProblemStatement& design, int points) {
  Figure all = design_figure(design, points), result = all;
  result.panels.clear();
  for (const Panel& wanted : first.panels) {
    const auto at = std::find_if(all.panels.begin(), all.panels.end(),
                                 [&](const Panel& p) { return p.y.label == wanted.y.label; });
    result.panels.push_back(at == all.panels.end() ? wanted : *at);
  }
  return result;
}

/// Which objectives a still chart shows, and the line that no law passes.
Json pair_json(const FrontAnswer& answer, const Panel& panel) {
  const auto& objectives = answer.front.objectives;
  const auto index_of = [&](const std::string& name) {
    const auto at = std::find_if(objectives.begin(), objectives.end(),
                                 [&](const optim::ObjectiveName& o) { return o.name == name; });
    return at - objectives.begin();
  };
  Json bound = nullptr;
  if (!panel.lines.empty()) {
    const Line& line = panel.lines.front();
    bound = {{"name", line.name}, {"x", drawn_numbers(line.x)}, {"y", drawn_numbers(line.y)}};
  }
  return {{"across", index_of(panel.x.label)}, {"up", index_of(panel.y.label)}, {"bound", bound}};
}

Json design_json(const FrontAnswer& answer, std::size_t k, const Figure& first, int points,
                 const std::vector<double>& margins) {
  const FrontPoint& point = answer.front.points[k];
  const problems::ProblemStatement design = design_of(answer, point);
  Json json = lines_json(like(first, design, points));
  json["label"] = fmt::format("point {}", k + 1);
  const std::string family = answer.family(point);
  json["group"] = family.empty() ? "the front" : family;
  json["objectives"] = drawn_numbers(point.objectives);
  json["rows"] = rows_json(answer, point, margins);
  json["scene"] = scene_svg(design, std::min(points, 180));
  return json;
}

}  // namespace

std::vector<std::size_t> shown_points(const FrontAnswer& answer) {
  const std::size_t all = answer.front.points.size();
  const std::size_t count = std::min(all, kMostDesigns);
  std::vector<std::size_t> shown;
  for (std::size_t i = 0; i < count; ++i) {
    shown.push_back(count < 2 ? 0 : i * (all - 1) / (count - 1));
  }
  if (const auto knee = optim::knee(answer.costs())) {
    const auto at = std::lower_bound(shown.begin(), shown.end(), knee->point);
    if (at != shown.end()) *at = knee->point;
  }
  return shown;
}

std::string verdict_words(const FrontPoint& point) {
  return fmt::format("{}{}", to_string(point.verdict), point.is_global ? ", global" : "");
}

problems::ProblemStatement design_of(const FrontAnswer& answer, const FrontPoint& point) {
  return answer.study.bound().at(answer.study.space().options(point.part), point.x);
}

std::string named_with_unit(const std::string& name, const std::string& unit) {
  return shown_unit(unit).empty() ? plain_name(name)
                                  : fmt::format("{}, {}", plain_name(name), unit);
}

FrontPanels front_panels(const FrontAnswer& answer, const std::vector<std::size_t>& shown) {
  const problems::ProblemStatement first = design_of(answer, answer.front.points[shown.front()]);
  FrontPanels panels{design_figure(first, kFewSamples), {}};
  panels.words = panel_words(panels.figure, first, {});
  if (shown.size() * panels.figure.panels.size() > kMostCurves) {
    keep_essential(panels.figure, panels.words, answer);
  }
  return panels;
}

Json objectives_json(const FrontAnswer& answer, const std::vector<std::size_t>& shown,
                     const Figure& still) {
  Json objectives = Json::array(), pairs = Json::array(), marked = nullptr;
  for (const auto& o : answer.front.objectives) {
    objectives.push_back({{"name", plain_name(o.name)}, {"unit", shown_unit(o.unit)}});
  }
  for (const Panel& panel : still.panels) pairs.push_back(pair_json(answer, panel));
  const auto knee = optim::knee(answer.costs());
  for (std::size_t i = 0; i < shown.size(); ++i) {
    if (knee && shown[i] == knee->point) marked = i;
  }
  return {{"objectives", std::move(objectives)}, {"pairs", std::move(pairs)}, {"knee", marked}};
}

Json designs_json(const FrontAnswer& answer, const std::vector<std::size_t>& shown,
                  const Figure& first) {
  const int points = samples_for(shown.size(), first.panels.size());
  const std::vector<double> margins = margin_sizes(answer);
  Json designs = Json::array();
  for (const std::size_t k : shown) {
    designs.push_back(design_json(answer, k, first, points, margins));
  }
  return designs;
}

}  // namespace camlaw::cli
