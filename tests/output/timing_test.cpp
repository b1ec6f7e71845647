// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <map>

#include "output/report/design_figure.h"
#include "output/report/timing_section.h"
#include "tests/paths.h"

/// The timing diagram of several cams on one shaft.
namespace camlaw::cli::timing_test {

using Catch::Contains;
using Kind = TimedSpan::Kind;

namespace {

problems::ProblemStatement shipped() {
  return problems::read_problem_file(testing::source("problems/shaft/two_cams.toml"));
}

}  // namespace

TEST_CASE("the curves of a shaft's cams stand in the groups of these curves", "[shaft][report]") {
  const problems::ProblemStatement design = shipped();
  const Figure figure = design_figure(design, 40);
  std::map<std::string, std::string> groups;
  const std::vector<PanelWords> words = panel_words(figure, design, {});
  for (std::size_t i = 0; i < words.size(); ++i) groups[figure.panels[i].y.label] = words[i].group;
  for (const std::string cam : {"infeed.", "press."}) {
    INFO(cam);
    for (const char* motion : {"displacement", "velocity", "acceleration", "jerk"}) {
      CHECK(groups.at(cam + motion) == "Motion");
    }
    CHECK(groups.at(cam + "inertia_fraction") == "Forces, torques and power");
    CHECK(groups.at(cam + "pressure_angle") == "Geometry");
    CHECK(groups.at(cam + "contact_half_width") == "Contact");
  }
}

TEST_CASE("the parts of a cam's motion stand where the shaft has turned them", "[shaft][report]") {
  problems::ProblemStatement design = shipped();
  set_value(design, "press.phase=270");
  const std::vector<TimedSpan> press = timed_spans(design, 1);
  REQUIRE(press.size() == 4);
  const std::vector<std::tuple<std::string, Kind, double, double>> wanted{
      {"down", Kind::Rise, 270, 350},
      {"press", Kind::Dwell, 350, 380},
      {"up", Kind::Return, 20, 100},
      {"open", Kind::Dwell, 100, 270}};
  for (std::size_t i = 0; i < press.size(); ++i) {
    const auto& [name, kind, from, to] = wanted[i];
    CHECK(press[i].name == name);
    CHECK(press[i].kind == kind);
    CHECK(press[i].from == Approx(from));
    CHECK(press[i].to == Approx(to));
  }
  CHECK(timed_spans(design, 0).front().from == 0);
}

TEST_CASE("a part that goes over the end of the turn is two bars, the longer one named",
          "[shaft][report]") {
  problems::ProblemStatement design = shipped();
  set_value(design, "press.phase=270");
  const auto section = timing_section(design);
  REQUIRE(section);
  CHECK_THAT(section->html,
             Contains("left:97.222%;width:2.778%") && Contains("left:0.000%;width:5.556%"));
  CHECK_THAT(section->html, Contains("20 deg\">press</i>") && Contains("20 deg\"></i>"));
  const auto single =
      problems::read_problem_file(testing::source("problems/cams/roller_least_base.toml"));
  CHECK(!timing_section(single));
}

}  // namespace camlaw::cli::timing_test
