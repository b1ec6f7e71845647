// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "output/answers/front_output.h"
#include "output/answers/front_words.h"
#include "output/answers/warnings.h"
#include "output/document/formatting.h"
#include "output/figure/chart_svg.h"
#include "output/report/figure_json.h"
#include "output/report/front_data.h"
#include "output/report/html.h"
#include "output/report/problem_sections.h"
#include "output/report/provenance.h"
#include "output/report/report.h"
#include "output/report/sensitivity_section.h"

namespace camlaw::cli {
namespace {

using optim::FrontPoint;

/// The charts, who is chosen, and what is compared.
std::string front_html(const Figure& still) {
  std::string charts;
  for (std::size_t i = 0; i < still.panels.size(); ++i) {
    const Panel& panel = still.panels[i];
    charts += fmt::format(
        "<figure class=\"front\" data-pair=\"{}\"><div class=\"canvas tall\"><canvas role=\"img\" "
        "aria-label=\"The front: {} over {}\"></canvas></div></figure>\n",
        i, xml_escape(plain_name(panel.y.label)), xml_escape(plain_name(panel.x.label)));
  }
  return "<div class=\"fronts\">\n" + charts +
         "</div>\n<div class=\"controls\"><label>design A <select "
         "id=\"design-a\"></select></label>\n<label>design B <select "
         "id=\"design-b\"></select></label>\n<fieldset><legend>a click "
         "selects</legend><label><input type=\"radio\" name=\"chooses\" value=\"a\" checked> "
         "A</label> <label><input type=\"radio\" name=\"chooses\" value=\"b\"> "
         "B</label></fieldset></div>\n<div class=\"table\" tabindex=\"0\"><table id=\"compare\" "
         "aria-live=\"polite\"></table></div>\n<noscript>" +
         (still.panels.empty() ? "" : to_svg(still)) + "</noscript>\n";
}

std::string lead(const FrontAnswer& answer) {
  const optim::Front& front = answer.front;
  std::vector<std::string> ranges;
  for (std::size_t i = 0; i < front.objectives.size(); ++i) {
    const auto& o = front.objectives[i];
    const auto text = [&](double cost) { return in_digits(answer.value(i, cost), 5); };
    ranges.push_back(fmt::format("{} from {} to {}", plain_name(o.name), text(front.ideal[i]),
                                 with_unit(text(front.nadir[i]), o.unit)));
  }
  const bool all = front.certified() == front.points.size();
  const std::string certified =
      fmt::format("{} of {} points certified", front.certified(), front.points.size());
  std::string badges = badge(all && answer.failing() == 0 ? "good" : "plain", certified);
  if (answer.failing() > 0) {
    badges += badge("unsure", fmt::format("{} cannot be built", answer.failing()));
  }
  if (front.stopped) {
    badges += badge("bad", "not finished");
  } else if (!front.complete) {
    badges += badge("plain", "not complete");
  }
  std::string notes;
  for (const std::string& note : answer.notes) {
    notes += fmt::format("<p>{} {}</p>\n", badge("bad", "record"), escaped(note));
  }
  const std::string built = text_of(front_buildable(answer));
  return fmt::format("<p>{}</p>\n", badges) + notes + warnings_html(answer.warnings) +
         (built.empty() ? "" : preformatted(built)) +
         paragraph(fmt::format("{}.", fmt::join(ranges, "; ")));
}

ReportSection points_section(const FrontAnswer& answer, const std::vector<std::size_t>& shown) {
  constexpr std::size_t kFewPoints = 12;
  std::string html = html_of(points_table(answer, shown));
  if (shown.size() > kFewPoints) html = details(fmt::format("All {} points", shown.size()), html);
  if (shown.size() < answer.front.points.size()) {
    html += paragraph(fmt::format("{} of {} points are shown, evenly chosen.", shown.size(),
                                  answer.front.points.size()));
  }
  return {"points", "Points", html};
}

ReportSection knee_sensitivity(const FrontAnswer& answer) {
  const auto knee = optim::knee(answer.costs(), answer.front.tolerances, answer.front.sizes);
  const std::size_t k = knee ? knee->point : 0;
  const FrontPoint& point = answer.front.points[k];
  const auto& space = answer.study.space();
  ReportSection section = sensitivity_section(space.problem(space.options(point.part)), point.x);
  section.html =
      paragraph(fmt::format("Of point {}{}.", k + 1, knee ? ", the knee" : "")) + section.html;
  return section;
}

Facts facts_of(const FrontAnswer& answer, const std::string& file) {
  const auto settings = answer.study.settings();
  return {{"study", file},
          {"points requested", settings.at("points")},
          {"method", settings.at("method")},
          {"seed", settings.at("seed")},
          {"solver requested", settings.at("solver")},
          {"made with", settings.at("versions")},
          {"problem file", settings.at("source")}};
}

}  // namespace

ReportPage front_report(const FrontAnswer& answer, const std::string& file) {
  const problems::ProblemStatement& stated = answer.study.bound().statement();
  const auto shown = shown_points(answer);
  const auto [figure, words] = front_panels(answer, shown);
  const Figure still = front_figure(answer);
  ReportPage page{.title = stated.title.empty() ? "Front" : stated.title,
                  .lead = lead(answer),
                  .record = record_line(file, ""),
                  .sections = {problem_section(stated), {"front", "The front", front_html(still)}},
                  .data = {{"panels", panels_json(figure, words)},
                           {"designs", designs_json(answer, shown, figure)},
                           {"front", objectives_json(answer, shown, still)}}};
  if (!figure.panels.empty()) {
    page.sections.push_back(motion_section(stated, page.data["designs"].front()["scene"]));
    page.sections.push_back({"curves", "Over the cycle", plots_html(figure, words)});
  }
  page.sections.push_back(points_section(answer, shown));
  page.sections.push_back(
      {"measures", "The front as a whole", preformatted(text_of(front_summary(answer)))});
  page.sections.push_back(knee_sensitivity(answer));
  page.sections.push_back(provenance_section(facts_of(answer, file), "The problem file",
                                             answer.study.settings().at("problem")));
  return page;
}

}  // namespace camlaw::cli
