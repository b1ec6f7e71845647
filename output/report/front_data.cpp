// SPDX-License-Identifier: MIT
#include "output/report/front_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "output/answers/front_words.h"
#include "output/document/formatting.h"
#include "output/report/figure_json.h"
#include "output/report/html.h"
#include "output/report/scene.h"

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
    if (values.size() > kMostValues || is_sought(answer, value.name)) continue;
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

/// Whether a front is read with a curve: motions, and what is sought, limited, a load or followed
/// by a body of the scene.
bool is_essential(const std::string& name, const PanelWords& words, const FrontAnswer& answer,
                  const std::set<std::string>& followed) {
  static const std::set<std::string> loads{"pressure_angle", "follower_force", "drive_torque",
                                           "contact_stress"};
  if (!words.limits.empty() || words.group == "Motion") return true;
  if (loads.contains(name) || followed.contains(name)) return true;
  const auto& objectives = answer.study.bound().statement().objectives;
  return std::any_of(objectives.begin(), objectives.end(), [&](const auto& o) {
    return o.response.response != nullptr && o.response.response->name == name;
  });
}

/// Of a machine with very many curves the essential ones, and of the others as many as there is
/// room for.
void keep_essential(FrontPanels& all, std::size_t room, const FrontAnswer& answer,
                    const std::set<std::string>& followed) {
  std::vector<bool> keep;
  for (std::size_t i = 0; i < all.words.size(); ++i) {
    keep.push_back(is_essential(all.figure.panels[i].y.label, all.words[i], answer, followed));
  }
  auto count = static_cast<std::size_t>(std::count(keep.begin(), keep.end(), true));
  FrontPanels kept;
  for (std::size_t i = 0; i < keep.size(); ++i) {
    if (!keep[i] && count >= room) continue;
    if (!keep[i]) ++count;
    kept.figure.panels.push_back(all.figure.panels[i]);
    kept.words.push_back(all.words[i]);
  }
  all.figure.panels = std::move(kept.figure.panels);
  all.words = std::move(kept.words);
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

/// Leaves out the panels of the first design in which neither it nor the last has values.
void drop_empty(Figure& first, const problems::ProblemStatement& last) {
  const Figure other = like(first, last, kFewSamples);
  std::vector<Panel> kept;
  for (std::size_t i = 0; i < first.panels.size(); ++i) {
    if (has_values(first.panels[i]) || has_values(other.panels[i])) kept.push_back(first.panels[i]);
  }
  first.panels = std::move(kept);
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

/// The most bytes that one of some designs, from the first to the last, takes in the page.
double bytes_of_one(const FrontAnswer& answer, const std::vector<std::size_t>& shown,
                    const Figure& first, int points, const std::vector<double>& margins) {
  double most = 0;
  for (const std::size_t k : {shown.front(), shown[shown.size() / 2], shown.back()}) {
    const std::string text = design_json(answer, k, first, points, margins).dump();
    // Each '<' of a picture is written as six characters.
    most = std::max(most, static_cast<double>(text.size()) +
                              5.0 * static_cast<double>(std::count(text.begin(), text.end(), '<')));
  }
  return most;
}

}  // namespace

int samples_within(double bytes, std::size_t designs, double few_bytes, double many_bytes,
                   const SampleRange& range) {
  const double room = bytes / static_cast<double>(designs);
  const double each = (many_bytes - few_bytes) / (range.many - range.few);
  if (many_bytes <= room || !(each > 0)) return range.many;
  return range.few + static_cast<int>(std::max(0.0, (room - few_bytes) / each));
}

std::vector<std::size_t> shown_points(const FrontAnswer& answer) {
  const std::size_t all = answer.front.points.size();
  const std::size_t count = std::min(all, kMostDesigns);
  std::vector<std::size_t> shown;
  for (std::size_t i = 0; i < count; ++i) {
    shown.push_back(count < 2 ? 0 : i * (all - 1) / (count - 1));
  }
  if (const auto knee = optim::knee(answer.costs(), answer.front.tolerances, answer.front.sizes)) {
    const auto at = std::lower_bound(shown.begin(), shown.end(), knee->point);
    if (at != shown.end()) *at = knee->point;
  }
  return shown;
}

problems::ProblemStatement design_of(const FrontAnswer& answer, const FrontPoint& point) {
  return answer.study.design(point);
}

std::string named_with_unit(const std::string& name, const std::string& unit) {
  return shown_unit(unit).empty() ? plain_name(name)
                                  : fmt::format("{}, {}", plain_name(name), unit);
}

FrontPanels front_panels(const FrontAnswer& answer, const std::vector<std::size_t>& shown) {
  const problems::ProblemStatement first = design_of(answer, answer.front.points[shown.front()]);
  FrontPanels panels{design_figure(first, kFewSamples), {}};
  drop_empty(panels.figure, design_of(answer, answer.front.points[shown.back()]));
  panels.words = panel_words(panels.figure, first, {});
  if (shown.size() * panels.figure.panels.size() > kMostCurves) {
    const std::optional<Scene> scene = scene_of(first, kFewSamples);
    keep_essential(panels, kMostCurves / shown.size(), answer,
                   scene ? scene->follows() : std::set<std::string>{});
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
  const auto knee = optim::knee(answer.costs(), answer.front.tolerances, answer.front.sizes);
  for (std::size_t i = 0; i < shown.size(); ++i) {
    if (knee && shown[i] == knee->point) marked = i;
  }
  return {{"objectives", std::move(objectives)}, {"pairs", std::move(pairs)}, {"knee", marked}};
}

Json designs_json(const FrontAnswer& answer, const std::vector<std::size_t>& shown,
                  const Figure& first) {
  // Of the 3 MB the scripts and sections take 0.7 MB; the rest is left for designs that are
  // larger than those measured.
  constexpr double kBytes = 1.8e6;
  constexpr SampleRange kRange;
  const std::vector<double> margins = margin_sizes(answer);
  const int points =
      samples_within(kBytes, shown.size(), bytes_of_one(answer, shown, first, kRange.few, margins),
                     bytes_of_one(answer, shown, first, kRange.many, margins));
  Json designs = Json::array();
  for (const std::size_t k : shown) {
    designs.push_back(design_json(answer, k, first, points, margins));
  }
  return designs;
}

}  // namespace camlaw::cli
