// SPDX-License-Identifier: MIT
#include "output/report/design_figure.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "machines/model/known_names.h"
#include "output/answers/cycle_figure.h"
#include "output/answers/limit_text.h"
#include "output/document/formatting.h"
#include "output/figure/chart_svg.h"
#include "output/figure/law_figure.h"
#include "output/report/html.h"

namespace camlaw::cli {
namespace {

using problems::EvaluatedResponse;
using problems::ProblemStatement;

constexpr const char *kMotionGroup = "Motion", *kGeometryGroup = "Geometry",
                     *kLoadGroup = "Forces, torques and power", *kContactGroup = "Contact",
                     *kLawGroup = "Motion law, normalised";

/// The groups in the order in which they are read.
constexpr std::array kGroups{kMotionGroup, kGeometryGroup, kLoadGroup, kContactGroup, kLawGroup};

/// Whether a panel is a coordinate of a curve of the cam, which is drawn as that curve. Coordinates
/// that a file states are curves like others: its path follows them.
bool is_of_profile(const Panel& panel, const ProblemStatement& design) {
  const auto& all = design.mechanism->responses;
  const auto own =
      std::ranges::find_if(all, [&](const auto& r) { return r.name == panel.y.label; });
  return own != all.end() && own->is_coordinate;
}

/// Whether the problem limits or seeks a curve.
bool is_asked_for(const std::string& curve, const ProblemStatement& design) {
  const auto asks = [&](const auto& stated) {
    return stated.response.response != nullptr && stated.response.response->name == curve;
  };
  return std::any_of(design.constraints.begin(), design.constraints.end(), asks) ||
         std::any_of(design.objectives.begin(), design.objectives.end(), asks);
}

/// Whether a panel is one of the law's own, which are drawn over the law's x.
bool is_of_law(const Panel& panel) { return panel.x.label == "x = t / T"; }

/// Whether a panel is shown without being asked for.
bool is_main(const Panel& panel, const ProblemStatement& design) {
  using problems::known::kDisplacement;
  const std::string& name = panel.y.label;
  if (is_of_law(panel) || is_asked_for(name, design)) return true;
  for (const std::string_view motion :
       {kDisplacement, std::string_view("velocity"), std::string_view("acceleration")}) {
    if (name == motion || name.ends_with("." + std::string(motion))) return true;
  }
  const problems::Mechanism& mechanism = *design.mechanism;
  const bool is_stated = problems::response_called(mechanism, name) == nullptr ||
                         problems::response_called(mechanism, name)->domain;
  return is_stated || std::ranges::any_of(mechanism.peaks, [&](const problems::NamedPeak& peak) {
           return peak.curve == name;
         });
}

std::string group_of(const Panel& panel) {
  if (is_of_law(panel)) return kLawGroup;
  switch (problems::subject_of(panel.y.label, panel.y.unit)) {
    case problems::Subject::Motion:
      return kMotionGroup;
    case problems::Subject::Loads:
      return kLoadGroup;
    case problems::Subject::Contact:
      return kContactGroup;
    case problems::Subject::Geometry:
      break;
  }
  return kGeometryGroup;
}

std::string law_meaning(const std::string& label) {
  static const std::array<std::pair<const char*, const char*>, 4> meanings{
      {{"s", "displacement over the stroke"},
       {"v = s'", "velocity"},
       {"a = s''", "acceleration"},
       {"j = s'''", "jerk"}}};
  for (const auto& [name, meaning] : meanings) {
    if (label == name) return meaning;
  }
  return "";
}

/// A curve that has no values in places has no extremes over its cycle: those of its samples.
EvaluatedResponse with_extremes(EvaluatedResponse r, const Line& samples) {
  if (std::isfinite(r.lowest) && std::isfinite(r.highest)) return r;
  r.proved = false;
  r.lowest = std::numeric_limits<double>::infinity(), r.highest = -r.lowest;
  for (std::size_t i = 0; i < samples.x.size(); ++i) {
    const double value = samples.y[i];
    if (!std::isfinite(value)) continue;
    if (value < r.lowest) r.lowest = value, r.lowest_at = samples.x[i];
    if (value > r.highest) r.highest = value, r.highest_at = samples.x[i];
  }
  return r;
}

std::string extremes_text(const EvaluatedResponse& r) {
  const double size = std::max(std::abs(r.lowest), std::abs(r.highest));
  const auto text = [&](double value, double at) {
    return fmt::format("{} at {}", with_unit(significant(value, size, 4), r.unit),
                       place_text(at, r.along));
  };
  if (!(r.lowest < r.highest)) return with_unit(significant(r.highest, size, 4), r.unit);
  return fmt::format("lowest value {}, highest {}{}", text(r.lowest, r.lowest_at),
                     text(r.highest, r.highest_at), r.proved ? "" : " (sampled)");
}

std::vector<std::string> limits_on(const std::string& curve, const ProblemStatement& design) {
  std::vector<std::string> texts;
  for (const problems::ConstraintStatement& c : design.constraints) {
    if (c.response.response == nullptr || c.response.response->name != curve) continue;
    const bool both_ways = c.response.part == optim::Part::Magnitude;
    const auto text = [&](const char* words, double bound) {
      texts.push_back(fmt::format("{}{} {}", both_ways ? "in either direction " : "", words,
                                  with_unit(fmt::format("{:.6g}", bound), c.response.unit)));
    };
    if (c.lower) text("at least", *c.lower);
    if (c.upper) text("at most", *c.upper);
  }
  return texts;
}

std::string alt_text(const Panel& panel, const PanelWords& words) {
  return fmt::format(
      "{} over the {}{}{}", words.name,
      is_of_law(panel)                           ? "law's time"
      : panel.x.label == problems::known::kSpeed ? "speed"
                                                 : "cycle",
      words.extremes.empty() ? "" : ", " + words.extremes,
      words.limits.empty() ? "" : fmt::format("; limits: {}", fmt::join(words.limits, ", ")));
}

std::string plot_html(const Panel& panel, std::size_t index, const PanelWords& words) {
  std::string caption =
      fmt::format("<b>{}</b>{} <output></output>", xml_escape(words.name),
                  panel.y.unit.empty() ? "" : ", " + xml_escape(typeset(panel.y.unit)));
  std::string notes = words.meaning;
  if (!words.extremes.empty()) notes += (notes.empty() ? "" : "; ") + words.extremes;
  for (const std::string& limit : words.limits) {
    notes += (notes.empty() ? "limit " : "; limit ") + limit;
  }
  if (!panel.title.empty()) notes += (notes.empty() ? "" : "; ") + panel.title;
  return fmt::format(
      "<figure class=\"plot\" data-panel=\"{}\">\n<figcaption>{}</figcaption>\n"
      "<div class=\"canvas\"><canvas role=\"img\" aria-label=\"{}\"></canvas></div>\n"
      "<p class=\"notes\">{}</p>\n</figure>\n",
      index, caption, xml_escape(typeset(alt_text(panel, words))), xml_escape(typeset(notes)));
}

}  // namespace

Figure design_figure(const ProblemStatement& design, int points,
                     const std::vector<EvaluatedResponse>& evaluated) {
  Figure figure = curves_figure(design, points, evaluated);
  std::erase_if(figure.panels, [&](const Panel& panel) {
    return is_of_profile(panel, design) && !is_asked_for(panel.y.label, design);
  });
  draw_limits(design, figure);
  const bool shows_motion =
      std::any_of(figure.panels.begin(), figure.panels.end(),
                  [](const Panel& panel) { return panel.y.label == problems::known::kJerk; });
  if (design.mechanism->moved_by != problems::MovedBy::Law || shows_motion) return figure;
  const Figure law = motion_figure("", {{.name = "", .law = design.laws.front().law()}},
                                   std::min(points, kMotionPoints));
  figure.panels.insert(figure.panels.end(), law.panels.begin(), law.panels.end());
  return figure;
}

bool has_values(const Panel& panel) {
  const std::vector<double>& y = panel.lines.front().y;
  return std::any_of(y.begin(), y.end(), [](double value) { return std::isfinite(value); });
}

std::vector<PanelWords> panel_words(const Figure& figure, const ProblemStatement& design,
                                    const std::vector<EvaluatedResponse>& evaluated) {
  std::vector<PanelWords> all;
  for (const Panel& panel : figure.panels) {
    const std::string& name = panel.y.label;
    PanelWords words{plain_name(name), law_meaning(name), group_of(panel)};
    for (const auto& declared : design.mechanism->responses) {
      if (!is_of_law(panel) && declared.name == name) words.meaning = declared.meaning;
    }
    for (const EvaluatedResponse& r : evaluated) {
      if (is_of_law(panel) || !r.is_curve || r.name != name || !has_values(panel)) continue;
      words.extremes = extremes_text(with_extremes(r, panel.lines.front()));
    }
    if (!is_of_law(panel)) words.limits = limits_on(name, design);
    words.is_main = is_main(panel, design);
    all.push_back(std::move(words));
  }
  return all;
}

namespace {

/// The plots that are main or those that are not, under their groups.
std::string grouped_plots(const Figure& figure, const std::vector<PanelWords>& words, bool main) {
  std::string html;
  for (const char* group : kGroups) {
    std::string plots;
    for (std::size_t i = 0; i < words.size(); ++i) {
      if (words[i].group == group && words[i].is_main == main)
        plots += plot_html(figure.panels[i], i, words[i]);
    }
    if (plots.empty()) continue;
    html += fmt::format("<h3>{}</h3>\n<div class=\"plots\">\n{}</div>\n", group, plots);
  }
  return html;
}

/// A picture of the same for readers without scripts.
std::string still_plots(const Figure& figure, const std::vector<PanelWords>& words, bool main) {
  Figure part = figure;
  part.panels.clear();
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i].is_main == main) part.panels.push_back(figure.panels[i]);
  }
  return "<noscript>" + to_svg(part) + "</noscript>\n";
}

}  // namespace

std::string plots_html(const Figure& figure, const std::vector<PanelWords>& words) {
  const auto more = static_cast<std::size_t>(
      std::ranges::count_if(words, [](const PanelWords& one) { return !one.is_main; }));
  std::string html;
  if (more < words.size()) {
    html += grouped_plots(figure, words, true) + still_plots(figure, words, true);
  }
  if (more == 0) return html;
  const std::string others =
      grouped_plots(figure, words, false) + still_plots(figure, words, false);
  if (more == words.size()) return others;  // nothing is asked for
  return html + fmt::format(
                    "<details class=\"more\"><summary>More curves ({})</summary>\n{}"
                    "</details>\n",
                    more, others);
}

}  // namespace camlaw::cli
