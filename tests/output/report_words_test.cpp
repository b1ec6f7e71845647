// SPDX-License-Identifier: MIT
// Words and numbers of pages and of programs for machine tools that a newcomer is to understand.
#include <catch2/catch.hpp>

#include "output/answers/fit_output.h"
#include "output/report/design_figure.h"
#include "output/report/html.h"
#include "problems/statement/evaluate.h"
#include "tests/cli/program_runner.h"
#include "tests/output/picture.h"

namespace camlaw::cli::report_words_test {

using Catch::Matchers::Contains;
using picture::shipped;

TEST_CASE("numbers and units are set as print has them", "[cli][report]") {
  CHECK(typeset("-3.5 m/s2") == "−3.5 m/s²");
  CHECK(typeset("2 kg m2, at -10 deg") == "2 kg m², at −10 deg");
  CHECK(typeset("1e-05 1/mm3 (-inf)") == "1e-05 1/mm³ (−inf)");
  CHECK(typeset("0.6 um") == "0.6 µm");
  CHECK(typeset("pair-2 of cam2, 2026-12-01, um2x") == "pair-2 of cam2, 2026-12-01, um2x");
}

TEST_CASE("a page shows first what a problem asks for", "[cli][report]") {
  const problems::ProblemStatement design = shipped("cams/roller_least_base");
  const Figure figure = design_figure(design, 40);
  const std::vector<PanelWords> words = panel_words(figure, design, {});
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& name = figure.panels[i].y.label;
    INFO(name);
    if (name == "displacement" || name == "pressure_angle") CHECK(words[i].is_main);
    if (name == "normal_force") CHECK_FALSE(words[i].is_main);
  }
  const std::string html = plots_html(figure, words);
  const std::size_t fold = html.find("<details class=\"more\"><summary>More curves (");
  REQUIRE(fold != std::string::npos);
  std::size_t folded = 0;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::size_t at = html.find("data-panel=\"" + std::to_string(i) + "\"");
    REQUIRE(at != std::string::npos);
    CHECK((at < fold) == words[i].is_main);
    if (at > fold) ++folded;
  }
  CHECK_THAT(html, Contains("More curves (" + std::to_string(folded) + ")"));
}

TEST_CASE("a figure has the same points where peaks are known", "[cli][report]") {
  const problems::ProblemStatement design = shipped("cams/flat_least_base");
  std::vector<std::size_t> told;
  const auto evaluated = problems::evaluate(
      design, [&](std::size_t done, std::size_t all) { told.push_back(all - done); });
  CHECK(told.size() == design.mechanism->responses.size());
  CHECK(told.back() == 1);
  const Figure searched = design_figure(design, 30), known = design_figure(design, 30, evaluated);
  REQUIRE(searched.panels.size() == known.panels.size());
  for (std::size_t i = 0; i < known.panels.size(); ++i) {
    INFO(known.panels[i].y.label);
    CHECK(searched.panels[i].lines.front().y.size() == known.panels[i].lines.front().y.size());
  }
}

TEST_CASE("fitted numbers have the digits that their intervals leave", "[fit]") {
  optim::FitResult fit;
  fit.parameters = {
      {.name = "a", .unit = "mm", .value = 12.3456789, .low = 12.31, .high = 12.38},
      {.name = "b", .unit = "N", .value = 1234567.8, .low = 1204567.8, .high = 1264567.8},
      {.name = "c", .unit = "1", .value = 0.0123456, .low = 0.0123456, .high = 0.0123456}};
  const Table table = fitted_table(fit);
  CHECK(table.rows[0][1].text == "12.346");
  CHECK(table.rows[1][1].text == "1.235e+06");
  CHECK(table.rows[2][1].text == "0.0123456");
}

TEST_CASE("a program for a milling machine warns of a cut without depth or tool", "[cli]") {
  const std::string roller = testing::source("problems/") + "cams/roller_least_base.toml";
  const std::string text = done({"export", roller, "--format", "gcode"});
  CHECK_THAT(text, Contains("caution: the cut has no depth"));
  CHECK_THAT(done({"export", roller, "--format", "gcode", "--depth", "6 mm", "--set",
                   "cutter_radius=4 mm"}),
             !Contains("caution"));
}

}  // namespace camlaw::cli::report_words_test
