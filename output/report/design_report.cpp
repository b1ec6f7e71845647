// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "output/answers/buildable_output.h"
#include "output/answers/design_review.h"
#include "output/answers/next_step.h"
#include "output/answers/possible.h"
#include "output/answers/warnings.h"
#include "output/document/formatting.h"
#include "output/figure/chart_svg.h"
#include "output/figure/thinning.h"
#include "output/report/design_figure.h"
#include "output/report/figure_json.h"
#include "output/report/html.h"
#include "output/report/problem_sections.h"
#include "output/report/provenance.h"
#include "output/report/report.h"
#include "output/report/scene.h"
#include "output/report/sensitivity_section.h"
#include "output/report/tiles.h"
#include "output/report/timing_section.h"
#include "problems/results/judged_design.h"
#include "problems/results/recorded_design.h"
#include "problems/statement/parameters.h"

namespace camlaw::cli {
namespace {

using problems::ProblemStatement;

/// What the shades of rises and returns are, of those that there are.
std::string span_words(const std::vector<TimedSpan>& spans) {
  const auto has = [&](TimedSpan::Kind kind) {
    return std::ranges::any_of(spans, [&](const TimedSpan& span) { return span.kind == kind; });
  };
  const bool rises = has(TimedSpan::Kind::Rise), returns = has(TimedSpan::Kind::Return);
  if (!rises && !returns) return "";
  return paragraph(fmt::format("{}{}{}; where nothing is shaded the follower dwells.",
                               rises ? "Rises are shaded in blue" : "",
                               rises && returns ? ", returns in orange" : "",
                               !rises ? "Returns are shaded in orange" : ""));
}

/// The value of what is sought, and whose it is where that is no answer.
std::string objective_text(const ProblemStatement& design, const DesignReview& review,
                           bool is_searched) {
  if (!review.assessment) return "";
  const optim::ObjectiveReport& objective = review.assessment->objective;
  const problems::ObjectiveStatement& stated = design.objectives.front();
  if (std::isnan(objective.value)) return "";
  const char* whose = !is_searched                          ? " with the file's own values"
                      : review.met() < review.limits.size() ? " of a design that violates limits"
                                                            : "";
  return fmt::format("<p class=\"answer\">{}{} <b>{}</b></p>\n",
                     xml_escape(plain_name(stated.response.name)), whose,
                     xml_escape(kept_together(
                         typeset(with_unit(in_digits(objective.value), stated.response.unit)))));
}

std::string limits_words(const DesignReview& review) {
  if (review.limits.empty()) return "The problem states no limits.";
  if (review.met() == review.limits.size()) return "Every limit is met.";
  return fmt::format("{} of {} limits are met.", review.met(), review.limits.size());
}

/// Why the verdict is what it is.
std::string reasons(const DesignReview& review) {
  if (!review.is_certified()) return paragraph(limits_words(review));
  const optim::Assessment& a = *review.assessment;
  return paragraph(fmt::format("Certified: {}.", a.reason)) +
         (a.global ? paragraph(fmt::format("Global: {}.", *a.global)) : "");
}

/// The verdict of the search; of one that found no design with what cannot be met.
std::string said_of(const problems::ReadDesign& read) {
  return read.blamed.empty() || read.reason.empty()
             ? *read.verdict
             : fmt::format("{}: {}", *read.verdict, read.reason);
}

/// What stands under the title: the verdict, and of values that nobody searched for how to search.
std::string lead(const ReportedDesign& reported, const DesignReview& review) {
  const ProblemStatement& design = reported.read.statement;
  const auto& verdict = reported.read.verdict;
  std::string notes;
  for (const std::string& words : reported.review.words()) {
    notes += fmt::format("<p>{} {}</p>\n", badge("bad", "record"), escaped(words));
  }
  const VerdictBadge shown = verdict_badge(reported.read, reported.review, review);
  std::string html = fmt::format("<p>{}</p>\n", badge(shown.kind, shown.text)) + notes +
                     warnings_html(warnings_of(design)) +
                     objective_text(design, review, verdict.has_value()) + reasons(review);
  if (verdict) {
    const bool chosen = !review.held || !review.held->whole;
    return html + paragraph(fmt::format(
                      "The search said: {}. For this report the design was re-checked{}.",
                      said_of(reported.read), chosen ? " with the chosen options kept fixed" : ""));
  }
  html += paragraph(
      fmt::format("These are the file's own values, not the result of a search. {}",
                  design.objectives.empty()
                      ? "The file names no objective."
                      : fmt::format("To search: camlaw {}",
                                    search_command(design, reported.file, reported.settings))));
  return html;
}

}  // namespace

ReportPage design_report(const ReportedDesign& reported) {
  constexpr int kPoints = 2000;  // of each curve, which is thinned before it is written
  const ProblemStatement& design = reported.read.statement;
  // Of the time that a page takes, most goes to the peaks of the responses, then to sensitivities.
  constexpr double kPeaks = 0.5, kCurves = 0.6, kSensitivities = 0.7;
  const auto say = [&](const std::string& what, double done) {
    if (reported.progress) reported.progress(what, done);
  };
  const DesignReview review(reported.read, [&](std::size_t done, std::size_t all) {
    say(fmt::format("peak {} of {}", done + 1, all),
        kPeaks * static_cast<double>(done) / static_cast<double>(all));
  });
  check_possible(reported.file, design, review.evaluated);
  say("curves", kPeaks);
  Figure figure = design_figure(design, kPoints, review.evaluated);
  std::erase_if(figure.panels, [](const Panel& panel) { return !has_values(panel); });
  const std::vector<TimedSpan> spans = motion_spans(design);
  const auto words = panel_words(figure, design, review.evaluated);
  figure = thinned(std::move(figure));
  const std::string title = design.title.empty() ? design.mechanism->title : design.title;
  ReportPage page{.title = title, .lead = lead(reported, review), .sections = {}, .data = {}};
  page.sections = {
      tiles_section(design, review), problem_section(reported.read.problem), values_section(design),
      limits_section(design, review.limits, review.is_optimal(), reported.read.blamed)};
  if (auto timing = timing_section(design)) page.sections.push_back(*std::move(timing));
  if (!review.built.checks.empty()) page.sections.push_back(buildable_section(review.built));
  if (!figure.panels.empty()) {
    say("the mechanism in motion", kCurves);
    page.sections.push_back(motion_section(design, scene_svg(design, kPoints)));
    page.sections.push_back(
        {"curves", "Over the cycle", span_words(spans) + plots_html(figure, words)});
  }
  if (auto rulers = rulers_section(design)) page.sections.push_back(*std::move(rulers));
  say("sensitivities", kSensitivities);
  if (review.held) {
    page.sections.push_back(sensitivity_section(review.held->problem, review.held->x));
  }
  if (auto profile = profile_section(design)) page.sections.push_back(*std::move(profile));
  if (auto derivatives = derivatives_section(design)) {
    page.sections.push_back(*std::move(derivatives));
  }
  const ReportSection numbers = numbers_section(review.evaluated);
  if (!numbers.html.empty()) page.sections.push_back(numbers);
  Facts facts = reported.facts;
  facts.emplace_back("input", reported.file);
  add_checksum(facts, reported.file, reported.checksum);
  page.record = record_line(reported.file, reported.checksum);
  page.sections.push_back(provenance_section(facts, "The problem file", design.text));
  page.data = {{"panels", panels_json(figure, words)},
               {"designs", Json::array({lines_json(figure)})},
               {"spans", spans_json(spans)}};
  return page;
}

}  // namespace camlaw::cli
