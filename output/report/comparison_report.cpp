// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "output/answers/comparison_table.h"
#include "output/answers/possible.h"
#include "output/answers/warnings.h"
#include "output/document/formatting.h"
#include "output/document/short_version.h"
#include "output/figure/chart_svg.h"
#include "output/figure/thinning.h"
#include "output/report/design_figure.h"
#include "output/report/figure_json.h"
#include "output/report/html.h"
#include "output/report/overlaid_profiles.h"
#include "output/report/provenance.h"
#include "output/report/report.h"

namespace camlaw::cli {
namespace {

constexpr int kComparedPoints = 2000;  // before they are thinned

/// The curves of one design.
struct CurvesOf {
  Figure figure;
  std::vector<PanelWords> words;

  explicit CurvesOf(const ComparedDesign& design)
      : figure(design_figure(design.read.statement, kComparedPoints)) {
    std::erase_if(figure.panels, [](const Panel& panel) { return !has_values(panel); });
    words = panel_words(figure, design.read.statement, design.review.evaluated);
    figure = thinned(std::move(figure));
  }
  /// The panel of the same curve over the same axis.
  const Panel* like(const Panel& panel) const {
    for (const Panel& its : figure.panels) {
      if (its.y.label == panel.y.label && its.y.unit == panel.y.unit &&
          its.x.label == panel.x.label && its.x.unit == panel.x.unit)
        return &its;
    }
    return nullptr;
  }
};

/// Panels that at least two have, each with the limits of all; one figure for each design, empty
/// where it has not the curve.
struct SharedCurves {
  std::vector<Figure> figures;
  std::vector<PanelWords> words;
  std::vector<OwnNames> own;  ///< every curve, by whose it is
};

/// The axis over which all run.
Axis joined(const Axis& a, const Axis& b) {
  Axis axis = a;
  if (a.lower && b.lower) axis.lower = std::min(*a.lower, *b.lower);
  if (a.upper && b.upper) axis.upper = std::max(*a.upper, *b.upper);
  return axis;
}

void take_limits(const Panel& from, Panel& into) {
  for (std::size_t k = 1; k < from.lines.size(); ++k) {
    const double limit = from.lines[k].y.front();
    const bool is_known = std::any_of(into.lines.begin() + 1, into.lines.end(),
                                      [&](const Line& l) { return l.y.front() == limit; });
    if (!is_known) into.lines.push_back(from.lines[k]);
  }
}

Line without_values(const Axis& x) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  return {.x = {x.lower.value_or(0), x.upper.value_or(1)}, .y = {kNone, kNone}};
}

/// What is said under a chart: the meaning, and the extremes of each design.
PanelWords joined_words(const std::vector<CurvesOf>& curves, const Panel& panel,
                        const std::vector<ComparedDesign>& designs) {
  PanelWords words;
  std::vector<std::string> extremes;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const Panel* its = curves[i].like(panel);
    if (its == nullptr) continue;
    const PanelWords& own =
        curves[i].words[static_cast<std::size_t>(its - curves[i].figure.panels.data())];
    if (words.name.empty()) words = own;
    for (const std::string& limit : own.limits) {
      auto& all = words.limits;
      if (std::find(all.begin(), all.end(), limit) == all.end()) all.push_back(limit);
    }
    if (!own.extremes.empty()) extremes.push_back(designs[i].letter + " " + own.extremes);
  }
  words.extremes = fmt::format("{}", fmt::join(extremes, "; "));
  return words;
}

SharedCurves shared_curves(const std::vector<ComparedDesign>& designs) {
  std::vector<CurvesOf> curves;
  SharedCurves shared{.figures = std::vector<Figure>(designs.size()), .words = {}, .own = {}};
  for (const ComparedDesign& design : designs) {
    curves.emplace_back(design);
    std::vector<std::string> names;
    for (const Panel& panel : curves.back().figure.panels) names.push_back(panel.y.label);
    shared.own.push_back({design.letter, std::move(names)});
  }
  std::vector<const Panel*> done;
  for (const CurvesOf& first : curves) {
    for (const Panel& panel : first.figure.panels) {
      const bool is_done = std::any_of(curves.begin(), curves.end(), [&](const CurvesOf& other) {
        return std::find(done.begin(), done.end(), other.like(panel)) != done.end();
      });
      const auto owners = std::count_if(curves.begin(), curves.end(), [&](const CurvesOf& other) {
        return other.like(panel) != nullptr;
      });
      if (is_done || owners < 2) continue;
      done.push_back(&panel);
      Panel whole = panel;
      for (const CurvesOf& other : curves) {
        const Panel* its = other.like(panel);
        if (its == nullptr) continue;
        whole.x = joined(whole.x, its->x);
        take_limits(*its, whole);
      }
      shared.words.push_back(joined_words(curves, panel, designs));
      for (std::size_t i = 0; i < curves.size(); ++i) {
        const Panel* its = curves[i].like(panel);
        Panel own = whole;
        own.lines.front() = its != nullptr ? its->lines.front() : without_values(whole.x);
        shared.figures[i].panels.push_back(std::move(own));
      }
    }
  }
  return shared;
}

std::string label_of(const ComparedDesign& design) {
  return fmt::format("{}: {}", design.letter, design.file);
}

/// Which colour is whose.
std::string legend(const std::vector<ComparedDesign>& designs) {
  std::string items;
  for (std::size_t i = 0; i < designs.size(); ++i) {
    items += fmt::format(
        "<li><svg viewBox=\"0 0 28 4\" width=\"28\" height=\"4\" aria-hidden=\"true\"><line "
        "class=\"c{}\" x1=\"0\" y1=\"2\" x2=\"28\" y2=\"2\"/></svg>{}</li>\n",
        i, escaped(label_of(designs[i])));
  }
  return "<ul class=\"legend\">\n" + items + "</ul>\n";
}

/// Each design's verdict with what stands beside it.
std::string comparison_lead(const std::vector<ComparedDesign>& designs) {
  std::string html;
  for (const ComparedDesign& design : designs) {
    const VerdictBadge shown = verdict_badge(design.read, design.claim, design.review);
    html += fmt::format("<p>{} {}</p>\n", escaped(label_of(design)), badge(shown.kind, shown.text));
    for (const std::string& words : design.claim.words()) {
      html +=
          fmt::format("<p>{} {}: {}</p>\n", badge("bad", "record"), design.letter, escaped(words));
    }
    std::vector<std::string> warnings = warnings_of(design.read.statement);
    for (std::string& words : warnings) words.insert(0, design.letter + ": ");
    html += warnings_html(warnings);
  }
  return html;
}

ReportSection curves_section(const std::vector<ComparedDesign>& designs,
                             const SharedCurves& shared) {
  std::string html = legend(designs);
  // Readers without scripts have the curves one design after the other.
  std::string plots = plots_html(shared.figures.front(), shared.words);
  const std::size_t still = plots.find("<noscript>");
  plots.resize(still);
  for (std::size_t i = 0; i < designs.size(); ++i) {
    plots += "<noscript>" + paragraph(label_of(designs[i])) + to_svg(shared.figures[i]) +
             "</noscript>\n";
  }
  return {"curves", "Over the cycle", html + plots};
}

ReportSection compared_provenance(const std::vector<ComparedDesign>& designs,
                                  const std::vector<std::string>& checksums) {
  Facts facts;
  for (std::size_t i = 0; i < designs.size(); ++i) {
    facts.emplace_back(designs[i].letter, designs[i].file);
    add_checksum(facts, designs[i].file, checksums[i]);
  }
  ReportSection section = provenance_section(facts, "", "");
  for (const ComparedDesign& design : designs) {
    section.html +=
        details("The problem file of " + design.letter, preformatted(design.read.statement.text));
  }
  return section;
}

/// What tells one comparison from another at the foot of a printed sheet.
std::string compared_records(const std::vector<ComparedDesign>& designs,
                             const std::vector<std::string>& checksums) {
  constexpr std::size_t kDigits = 8;
  std::vector<std::string> records;
  for (std::size_t i = 0; i < designs.size(); ++i) {
    records.push_back(designs[i].letter + " " + checksums[i].substr(0, kDigits) + "...");
  }
  return fmt::format("{}, SHA-256 {}", short_version(), fmt::join(records, ", "));
}

}  // namespace

ReportPage comparison_report(const std::vector<ComparedDesign>& designs,
                             const std::vector<std::string>& checksums) {
  for (const ComparedDesign& design : designs) {
    check_possible(design.file, design.read.statement, design.review.evaluated);
  }
  const SharedCurves shared = shared_curves(designs);
  ReportPage page{.title = fmt::format("Comparison of {} designs", designs.size()),
                  .lead = comparison_lead(designs),
                  .record = compared_records(designs, checksums),
                  .sections = sections_of(comparison_document(designs)),
                  .data = {}};
  Json drawn = Json::array();
  for (std::size_t i = 0; i < designs.size(); ++i) {
    Json lines = lines_json(shared.figures[i]);
    lines["label"] = label_of(designs[i]);
    lines["letter"] = designs[i].letter;
    drawn.push_back(std::move(lines));
  }
  const std::string profiles = overlaid_profiles(designs);
  if (!profiles.empty()) {
    page.sections.push_back({"profiles", "Profiles", legend(designs) + profiles});
  }
  if (!shared.words.empty()) page.sections.push_back(curves_section(designs, shared));
  std::string apart;
  for (const std::string& words : unshared_words(shared.own, "curve")) apart += paragraph(words);
  if (!apart.empty()) page.sections.push_back({"own-curves", "Curves of some alone", apart});
  page.sections.push_back(compared_provenance(designs, checksums));
  page.data = {{"panels", panels_json(shared.figures.front(), shared.words)},
               {"designs", std::move(drawn)},
               {"overlaid", true}};
  return page;
}

}  // namespace camlaw::cli
