// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "output/document/text_table.h"
#include "output/report/html.h"
#include "output/report/report.h"
#include "problems/published/systems.h"

namespace camlaw::cli {
namespace {

using problems::SystemReproduction;
using Align = HtmlTable::Align;

std::string verdict_badge(optim::Finding verdict) {
  const char* kind = verdict == optim::Finding::Reproduced  ? "good"
                     : verdict == optim::Finding::Explained ? "plain"
                                                            : "bad";
  return badge(kind, problems::to_string(verdict));
}

ReportSection overview(const std::vector<SystemReproduction>& results) {
  HtmlTable table(
      {{"system", Align::Left}, {"values"}, {"reproduced"}, {"explained"}, {"unexplained"}});
  for (const SystemReproduction& r : results) {
    table.add_html({fmt::format("<a href=\"#{0}\">{0}</a>", r.system),
                    fmt::format("{}", r.values.size()), fmt::format("{}", r.reproduced),
                    fmt::format("{}", r.explained), fmt::format("{}", r.unexplained)});
  }
  return {
      "overview", "All systems",
      table.html() + paragraph("Reproduced: all printed digits come out with the inputs that the "
                               "source states. Explained: they come out under the departures "
                               "listed with each system. Unexplained: they do not.")};
}

/// The printed table beside ours, value by value, with what each difference comes from.
std::string values_table(const SystemReproduction& result) {
  HtmlTable table({{"value", Align::Left},
                   {"law", Align::Left},
                   {"condition", Align::Left},
                   {"place", Align::Left},
                   {"printed"},
                   {"ours, as stated"},
                   {"difference"},
                   {"ours, with departures"},
                   {"unit", Align::Left},
                   {"", Align::Left},
                   {"cause", Align::Left}});
  for (const auto& v : result.values) {
    const int decimals = v.printed.number.decimals;
    const bool explained = v.verdict == optim::Finding::Explained;
    const double difference = v.stated_value - v.printed.number.value;
    std::vector<std::string> cells{plain_name(v.printed.quantity),
                                   v.printed.law,
                                   v.printed.condition,
                                   v.printed.place,
                                   optim::as_printed(v.printed.number.value, decimals),
                                   shown(v.stated_value, decimals + 2),
                                   shown(difference, decimals + 2),
                                   explained ? shown(v.explained_value, decimals + 2) : "",
                                   shown_unit(v.printed.unit)};
    for (std::string& cell : cells) cell = escaped(cell);
    cells.push_back(verdict_badge(v.verdict));
    cells.push_back(escaped(fmt::format("{}", fmt::join(v.causes, "; "))));
    table.add_html(std::move(cells));
  }
  return table.empty() ? "" : table.html();
}

std::string departures_html(const SystemReproduction& r) {
  std::string html;
  if (!r.departures.empty()) {
    html += paragraph(fmt::format(
        "The smallest set of departures that explains the most digits, of {} sets looked at:",
        r.tried));
    html += list_of_lines(fmt::format("{}", fmt::join(r.departures, "\n")));
    if (r.equals.empty()) html += paragraph("No other set as small explains as many.");
  }
  for (const auto& other : r.equals) {
    html += paragraph(fmt::format("Another set explains as many: {}", fmt::join(other, "; ")));
  }
  for (const std::string& note : r.notes) html += paragraph(note);
  return html;
}

std::string lead(const std::vector<SystemReproduction>& results) {
  std::size_t values = 0, reproduced = 0, explained = 0, worse = 0;
  for (const SystemReproduction& r : results) {
    values += r.values.size(), reproduced += r.reproduced, explained += r.explained;
    worse += problems::worsened(r).size();
  }
  const std::size_t unexplained = values - reproduced - explained;
  std::string html =
      "<p>" + badge("good", fmt::format("{} reproduced", reproduced)) + " " +
      badge("plain", fmt::format("{} explained", explained)) + " " +
      badge(unexplained > 0 ? "bad" : "plain", fmt::format("{} unexplained", unexplained)) +
      "</p>\n";
  html += paragraph(
      fmt::format("{} published values of {}, computed again.", values,
                  results.size() == 1 ? "one system" : fmt::format("{} systems", results.size())));
  if (worse > 0)
    html += paragraph(fmt::format("{} of them have become worse than the baseline.", worse));
  return html;
}

}  // namespace

ReportPage reproduction_report(const std::vector<SystemReproduction>& results) {
  ReportPage page{.title = "Published tables, computed again",
                  .lead = lead(results),
                  .sections = {overview(results)},
                  .data = Json::object()};
  for (const SystemReproduction& r : results) {
    page.sections.push_back({r.system, plain_name(r.title),
                             paragraph(r.source) + values_table(r) + departures_html(r)});
  }
  page.sections.push_back(provenance_section({}, "", ""));
  return page;
}

}  // namespace camlaw::cli
