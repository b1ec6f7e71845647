// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "output/answers/sweep_answer.h"
#include "output/document/formatting.h"
#include "output/report/html.h"
#include "output/report/problem_sections.h"
#include "output/report/provenance.h"
#include "output/report/report.h"

namespace camlaw::cli {
namespace {

/// As assets/sweep.js takes it.
const char* state_name(SweepState state) {
  switch (state) {
    case SweepState::NotDone:
      return "open";
    case SweepState::Design:
      return "design";
    case SweepState::Passes:
      return "passes";
    case SweepState::NoDesign:
      return "none";
    case SweepState::Failed:
      break;
  }
  return "failed";
}

/// Limits by name, in the order in which they first appear.
std::vector<std::pair<std::string, std::string>> limits_of_rows(const SweepAnswer& answer) {
  std::vector<std::pair<std::string, std::string>> all;
  for (const SweepRow& row : answer.rows) {
    for (const optim::Standing& limit : row.limits) {
      const std::pair one{limit.name, shown_unit(limit.unit)};
      if (std::find(all.begin(), all.end(), one) == all.end()) all.push_back(one);
    }
  }
  return all;
}

Json names_json(const SweepAnswer& answer) {
  const problems::SweepPlan& plan = answer.study.plan();
  Json all = Json::array();
  const auto& axes = plan.settings().axes;
  for (std::size_t k = 0; k < plan.names().size(); ++k) {
    const problems::SweptName& name = plan.names()[k];
    Json one{{"name", answer.swept_title(k)},
             {"unit", name.unit},
             {"numeric", name.is_numeric},
             {"sampled", k >= axes.size()}};
    if (k < axes.size()) one["values"] = axes[k].values, one["numbers"] = axes[k].numbers;
    all.push_back(std::move(one));
  }
  return all;
}

Json row_json(const SweepRow& row, std::size_t axes,
              const std::vector<std::pair<std::string, std::string>>& limits) {
  Json places = Json::array(), numbers = Json::array();
  for (std::size_t k = 0; k < row.values.size(); ++k) {
    places.push_back(row.values[k].index);
    if (k >= axes) numbers.push_back(row.values[k].number);
  }
  std::vector<std::string> held = row.active;
  if (row.state == SweepState::Passes) {
    for (const optim::Standing& limit : row.limits) {
      if (!limit.met) held.push_back(limit.name);
    }
  }
  Json result{{"v", places},
              {"s", state_name(row.state)},
              {"o", row.objectives.empty() ? Json(nullptr) : to_json(row.objectives.front())},
              {"verdict", row.verdict},
              {"held", held}};
  if (!numbers.empty()) result["n"] = numbers;
  const bool has_design = row.state == SweepState::Design || row.state == SweepState::Passes;
  if (!has_design && !row.reason.empty()) result["why"] = row.reason;
  if (row.limits.empty()) return result;
  Json margins = Json::array();
  for (const auto& [name, unit] : limits) {
    const auto found = std::find_if(row.limits.begin(), row.limits.end(),
                                    [&](const auto& limit) { return limit.name == name; });
    margins.push_back(found == row.limits.end() ? Json(nullptr) : to_json(found->margin));
  }
  result["m"] = margins;
  return result;
}

Json sweep_json(const SweepAnswer& answer) {
  const auto& plan = answer.study.plan();
  const auto limits = limits_of_rows(answer);
  Json rows = Json::array(), named = Json::array();
  for (const SweepRow& row : answer.rows) {
    rows.push_back(row_json(row, plan.settings().axes.size(), limits));
  }
  for (const auto& [name, unit] : limits) named.push_back({{"name", name}, {"unit", unit}});
  const problems::ObjectiveStatement& objective = answer.study.statement().objectives.front();
  return {{"names", names_json(answer)},
          {"axes", plan.settings().axes.size()},
          {"objective",
           {{"name", objective.response.name}, {"unit", shown_unit(objective.response.unit)}}},
          {"maximize", objective.sense == optim::Sense::Maximize},
          {"evaluated", plan.settings().evaluates},
          {"limits", named},
          {"rows", rows}};
}

std::string map_html() {
  return "<div class=\"controls\" id=\"sweep-controls\"></div>\n<div class=\"controls\" "
         "id=\"sweep-held\"></div>\n<figure class=\"sweep\" id=\"sweep-map\"></figure>\n<ul "
         "id=\"sweep-legend\"></ul>\n<div class=\"table\" tabindex=\"0\"><table id=\"swept\" "
         "aria-live=\"polite\"></table></div>\n<p class=\"notes\">Point at a place or click it to "
         "see its values here; the table of all combinations is below.</p>\n";
}

std::string sweep_lead(const SweepAnswer& answer) {
  const auto count = [&](SweepState state) { return answer.count(state); };
  std::string badges = badge(count(SweepState::Design) > 0 ? "good" : "bad",
                             fmt::format("{} of {} combinations have a design",
                                         count(SweepState::Design), answer.rows.size()));
  if (count(SweepState::NoDesign) > 0) {
    badges += badge("plain", fmt::format("{} without a design", count(SweepState::NoDesign)));
  }
  if (count(SweepState::Failed) > 0) {
    badges += badge("unsure", fmt::format("{} failed", count(SweepState::Failed)));
  }
  if (answer.is_stopped) badges += badge("bad", "not finished");
  std::string html = fmt::format("<p>{}</p>\n", badges);
  for (const std::string& note : answer.notes) {
    html += fmt::format("<p>{} {}</p>\n", badge("bad", "record"), escaped(note));
  }
  if (const auto best = answer.best()) {
    const auto& response = answer.study.statement().objectives.front().response;
    html += paragraph(
        fmt::format("The best {} is {} at {}.", plain_name(response.name),
                    with_unit(in_digits(answer.rows[*best].objectives.front(), 5), response.unit),
                    combination_text(answer, *best)));
  }
  return html;
}

Facts facts_of_sweep(const SweepAnswer& answer, const std::string& file) {
  const auto settings = answer.study.settings();
  return {{"study", file},
          {"seed", settings.at("seed")},
          {"solver requested", settings.at("solver")},
          {"made with", settings.at("versions")},
          {"problem file", settings.at("source")}};
}

/// Rows of a table that is too long for a page: evenly chosen.
Table on_page(Table table) {
  constexpr std::size_t kMost = 500;
  table.shown = table.rows.size();
  if (table.rows.size() <= kMost) return table;
  std::vector<std::vector<Cell>> rows;
  for (std::size_t i = 0; i < kMost; ++i) {
    rows.push_back(table.rows[i * (table.rows.size() - 1) / (kMost - 1)]);
  }
  table.rows = std::move(rows);
  table.shown = kMost;
  return table;
}

}  // namespace

ReportPage sweep_report(const SweepAnswer& answer, const std::string& file) {
  const problems::ProblemStatement& stated = answer.study.statement();
  const Table table = on_page(combinations_table(answer));
  std::string all = details(fmt::format("{} combinations", table.rows.size()), html_of(table));
  if (table.rows.size() < answer.rows.size()) {
    all +=
        paragraph(fmt::format("{} of {} combinations are shown, evenly chosen; sweep.csv has all.",
                              table.rows.size(), answer.rows.size()));
  }
  ReportPage page{.title = stated.title.empty() ? "Sweep" : stated.title,
                  .lead = sweep_lead(answer),
                  .record = record_line(file, ""),
                  .sections = {{"map", "The map", map_html()}},
                  .data = {{"sweep", sweep_json(answer)}}};
  std::string best;
  for (const Table& one : best_tables(answer)) best += html_of(one);
  if (!best.empty()) page.sections.push_back({"best", "Best for each choice", best});
  page.sections.push_back({"combinations", "All combinations", all});
  page.sections.push_back(problem_section(stated));
  page.sections.push_back(provenance_section(facts_of_sweep(answer, file), "The problem file",
                                             answer.study.settings().at("problem")));
  return page;
}

}  // namespace camlaw::cli
