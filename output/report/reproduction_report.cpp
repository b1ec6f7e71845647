// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "output/answers/reproduction_output.h"
#include "output/document/formatting.h"
#include "output/document/short_version.h"
#include "output/report/html.h"
#include "output/report/provenance.h"
#include "output/report/report.h"
#include "problems/published/systems.h"

namespace camlaw::cli {
namespace {

using problems::SystemReproduction;

ReportSection overview(const std::vector<SystemReproduction>& results) {
  Table table = counts_table(results);
  for (auto& row : table.rows) {
    row.front().html = fmt::format("<a href=\"#{0}\">{0}</a>", row.front().text);
  }
  return {
      "overview", "All systems",
      html_of(table) + paragraph("Reproduced: all printed digits come out with the inputs that the "
                                 "source states. Explained: they come out under the departures "
                                 "listed with each system. Unexplained: they do not.")};
}

std::string departures_html(const SystemReproduction& r) {
  std::string html;
  if (!r.departures.empty()) {
    html += paragraph(fmt::format(
        "The smallest set of departures that explains the most digits, of {} sets tried:",
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
                  .record = short_version(),
                  .sections = {overview(results)},
                  .data = Json::object()};
  for (const SystemReproduction& r : results) {
    page.sections.push_back({r.system, plain_name(r.title),
                             paragraph(r.source) + html_of(values_table(r)) + departures_html(r)});
  }
  page.sections.push_back(provenance_section({}, "", ""));
  return page;
}

}  // namespace camlaw::cli
