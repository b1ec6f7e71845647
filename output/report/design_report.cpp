// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "output/answers/buildable_output.h"
#include "output/answers/next_step.h"
#include "output/answers/possible.h"
#include "output/answers/warnings.h"
#include "output/document/formatting.h"
#include "output/figure/chart_svg.h"
#include "output/report/design_figure.h"
#include "output/report/figure_json.h"
#include "output/report/html.h"
#include "output/report/problem_sections.h"
#include "output/report/provenance.h"
#include "output/report/report.h"
#include "output/report/scene.h"
#include "output/report/sensitivity_section.h"
#include "output/report/timing_section.h"
#include "problems/results/judged_design.h"
#include "problems/statement/parameters.h"

namespace camlaw::cli {
namespace {

using problems::ProblemStatement;

/// All that is found out about a design before it is told.
struct Review {
  std::vector<problems::EvaluatedResponse> evaluated;
  std::optional<problems::HeldProblem> held;
  std::optional<optim::Assessment> assessment;  ///< of a problem with one objective
  std::vector<optim::LimitReport> limits;
  problems::Buildability built;

  explicit Review(const problems::ReadDesign& read)
      : evaluated(problems::evaluate(read.statement)),
        held(problems::held_problem(read)),
        built(problems::buildability(read.statement)) {
    const ProblemStatement& design = read.statement;
    if (held && design.objectives.size() == 1) assessment = problems::judged(*held);
    limits =
        assessment ? problems::as_stated(design, assessment->limits) : problems::standing(design);
  }
  /// Of the problem with its choices held: so far prices hold.
  bool is_optimal() const { return assessment && assessment->verdict == optim::Verdict::Certified; }
  bool is_certified() const { return is_optimal() && held->whole; }
  std::size_t met() const {
    return static_cast<std::size_t>(std::count_if(
        limits.begin(), limits.end(), [](const optim::LimitReport& l) { return l.met; }));
  }
};

/// The value of what is sought.
std::string objective_text(const ProblemStatement& design, const Review& review) {
  if (!review.assessment) return "";
  const optim::ObjectiveReport& objective = review.assessment->objective;
  const problems::ObjectiveStatement& stated = design.objectives.front();
  if (std::isnan(objective.value)) return "";
  return fmt::format("<p class=\"answer\">{} <b>{}</b></p>\n",
                     xml_escape(plain_name(stated.response.name)),
                     xml_escape(with_unit(in_digits(objective.value), stated.response.unit)));
}

std::string limits_words(const Review& review) {
  if (review.limits.empty()) return "The problem states no limits.";
  if (review.met() == review.limits.size()) return "Every limit is met.";
  return fmt::format("{} of {} limits are met.", review.met(), review.limits.size());
}

/// Why the verdict is what it is.
std::string reasons(const Review& review) {
  if (!review.is_certified()) return paragraph(limits_words(review));
  const optim::Assessment& a = *review.assessment;
  return paragraph(fmt::format("Certified: {}.", a.reason)) +
         (a.global ? paragraph(fmt::format("Global: {}.", *a.global)) : "");
}

/// The badge: what this page finds itself, or the words of the search where they agree with it.
std::string verdict_badge(const std::optional<std::string>& said, const Review& review) {
  using optim::Verdict;
  const auto good = [&](const std::string& verdict) {
    const Headline line = headline(verdict, review.built);
    return badge(line.spoilt ? "unsure" : "good", line.text);
  };
  if (review.is_certified()) return good(std::string(to_string(Verdict::Certified)));
  const bool meets = review.met() == review.limits.size();
  if (!meets) {
    const bool agrees = said == to_string(Verdict::Infeasible);
    return badge("bad", agrees ? *said : "violates a limit");
  }
  // Among its choices the search compared designs; among what varies evenly this page looks itself.
  const bool optimal = said == to_string(Verdict::Certified) && review.is_optimal();
  if (optimal) return good(*said);
  const bool agrees = said == to_string(Verdict::Feasible) ||
                      (said == to_string(Verdict::Certified) && !review.held);
  const Headline line = headline(agrees ? *said : "meets its limits", review.built);
  return badge(line.spoilt ? "unsure" : "plain", line.text);
}

/// The verdict of the search; of one that found no design with what cannot be met.
std::string said_of(const problems::ReadDesign& read) {
  return read.blamed.empty() || read.reason.empty()
             ? *read.verdict
             : fmt::format("{}: {}", *read.verdict, read.reason);
}

/// What stands under the title: the verdict, and of values that nobody searched for how to search.
std::string lead(const ReportedDesign& reported, const Review& review) {
  const ProblemStatement& design = reported.read.statement;
  const auto& verdict = reported.read.verdict;
  const bool believed = reported.review.is_believed();
  std::string notes;
  for (const std::string& words : reported.review.words()) {
    notes += fmt::format("<p>{} {}</p>\n", badge("bad", "record"), escaped(words));
  }
  const std::string shown = reported.review.differences.empty()
                                ? verdict_badge(believed ? verdict : std::nullopt, review)
                                : badge("bad", "the result is wrong");
  std::string html = "<p>" + shown + "</p>\n" + notes + warnings_html(warnings_of(design)) +
                     objective_text(design, review) + reasons(review);
  if (verdict) {
    const bool chosen = !review.held || !review.held->whole;
    return html +
           paragraph(fmt::format(
               "The search said: {}. For this report the design was judged again{}.",
               said_of(reported.read), chosen ? ", what was chosen among options held" : ""));
  }
  html += paragraph(fmt::format(
      "These are the file's own values, not the result of a search. {}",
      design.objectives.empty()
          ? "The file names no objective."
          : fmt::format("To search: camlaw {}", search_command(design, reported.file))));
  return html;
}

}  // namespace

ReportPage design_report(const ReportedDesign& reported) {
  constexpr int kPoints = 360;
  const ProblemStatement& design = reported.read.statement;
  const Review review(reported.read);
  check_possible(reported.file, design, review.evaluated);
  Figure figure = design_figure(design, kPoints);
  std::erase_if(figure.panels, [](const Panel& panel) { return !has_values(panel); });
  const auto words = panel_words(figure, design, review.evaluated);
  const std::string title = design.title.empty() ? design.mechanism->title : design.title;
  ReportPage page{.title = title, .lead = lead(reported, review), .sections = {}, .data = {}};
  page.sections = {
      problem_section(reported.read.problem), values_section(design),
      limits_section(design, review.limits, review.is_optimal(), reported.read.blamed)};
  if (auto timing = timing_section(design)) page.sections.push_back(*std::move(timing));
  if (!review.built.checks.empty()) page.sections.push_back(buildable_section(review.built));
  if (!figure.panels.empty()) {
    page.sections.push_back(motion_section(design, scene_svg(design, kPoints)));
    page.sections.push_back({"curves", "Over the cycle", plots_html(figure, words)});
  }
  if (auto rulers = rulers_section(design)) page.sections.push_back(*std::move(rulers));
  if (review.held) {
    page.sections.push_back(sensitivity_section(review.held->problem, review.held->x));
  }
  if (auto derivatives = derivatives_section(design)) {
    page.sections.push_back(*std::move(derivatives));
  }
  const ReportSection numbers = numbers_section(review.evaluated);
  if (!numbers.html.empty()) page.sections.push_back(numbers);
  Facts facts = reported.facts;
  facts.emplace_back("input", reported.file);
  page.sections.push_back(provenance_section(facts, "The problem file", design.text));
  page.data = {{"panels", panels_json(figure, words)},
               {"designs", Json::array({lines_json(figure)})}};
  return page;
}

}  // namespace camlaw::cli
