// SPDX-License-Identifier: MIT
// Sweeps over the rows of a catalogue, against searches of files in which the part is settled.
#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "optim/search/optimise.h"
#include "problems/sweeps/sweep_study.h"
#include "problems/sweeps/sweep_worker.h"
#include "tests/problems/complaint.h"
#include "tests/temporary_folder.h"

namespace camlaw::problems::swept_parts_test {
namespace {

using Catch::Contains;
using testing::complaint, testing::Folder;

/// A cam whose roller comes from a catalogue, and which is least with the largest of the three.
std::string cam_with_rollers(const Folder& folder) {
  std::ofstream(folder / "rollers.csv") << "name, roller_radius [mm]\nsmall, 6\nlarge, 12\n"
                                           "middle, 9\n";
  return R"(
mechanism = "disc-cam-roller"
[constants]
stroke = "25 mm"
[program]
segments = [{name = "rise", angle = 90, law = "modified-sine"}, {name = "high", angle = 70},
            {name = "back", angle = 110, law = "cycloidal"}, {name = "low"}]
[variables.base_radius]
lower = "20 mm"
upper = "60 mm"
[objective]
minimize = "outer_radius"
[[constraints]]
response = "pressure_angle"
lower = "-30 deg"
upper = "30 deg"
[parts.roller]
catalogue = "rollers.csv"
)";
}

SweepSettings asked(const std::vector<std::string>& assignments) {
  SweepSettings settings;
  add_settings(settings, assignments);
  return settings;
}

SweptCombinations swept(const SweepStudy& study) {
  optim::ProcessExecutor executor(sweep_service(study), study.options(), 1, worker_program(study));
  return study.run(executor);
}

/// The row of the roller in the design of each combination.
std::vector<std::string> rows_of(const SweepStudy& study) {
  const SweptCombinations sweep = swept(study);
  std::vector<std::string> rows;
  for (std::size_t i = 0; i < sweep.outcomes.size(); ++i) {
    const ProblemStatement design = study.design(i, sweep.outcomes[i]->points.at(0).x);
    rows.push_back(design.parts.front().items.size() == 1 ? design.parts.front().items.front().name
                                                          : "several");
  }
  return rows;
}

/// The optimum of the file in which the part is settled by `choose`.
double optimum_with(const std::string& text, const std::string& source, const std::string& row) {
  const ProblemStatement alone = read_problem(text + "choose = '" + row + "'\n", source);
  return optim::optimise(BoundProblem(alone).space()).found.assessment.objective.value;
}

}  // namespace

TEST_CASE("a part that is swept is fixed to each of its rows", "[sweep]") {
  const Folder folder;
  const std::string text = cam_with_rollers(folder), source = folder / "cam.toml";
  const SweepStudy study(text, source, asked({"roller=large,small,middle", "stroke=20,25 mm"}));
  const SweptCombinations sweep = swept(study);
  REQUIRE(sweep.outcomes.size() == 6);
  for (std::size_t i = 0; i < sweep.outcomes.size(); ++i) {
    const auto values = study.plan().values(i);
    INFO(values[0].text << ", " << values[1].text);
    const optim::FrontPoint& point = sweep.outcomes[i]->points.at(0);
    std::string stroke = text;
    stroke.replace(stroke.find("25 mm"), 5, values[1].text);
    CHECK(point.objectives[0] == Approx(optimum_with(stroke, source, values[0].text)));
  }
  const std::vector<std::string> rows{"large", "large", "small", "small", "middle", "middle"};
  CHECK(rows_of(study) == rows);
  CHECK(rows_of(SweepStudy::of(study.settings())) == rows);  // as a study records it
  CHECK(sweep.outcomes[3]->points[0].objectives[0] >
        sweep.outcomes[1]->points[0].objectives[0] + 1);
  CHECK_THAT(complaint([&] { SweepStudy(text, source, asked({"roller=large,smal"})); }),
             Contains("smal"));
}

TEST_CASE("a part that is set to one row is fixed in a whole sweep", "[sweep]") {
  const Folder folder;
  const std::string text = cam_with_rollers(folder), source = folder / "cam.toml";
  SweepSettings settings = asked({"roller=middle", "law=modified-sine,cycloidal"});
  const SweepStudy study(text, source, settings);
  CHECK(rows_of(study) == std::vector<std::string>{"middle", "middle"});
  CHECK(rows_of(SweepStudy::of(study.settings())) == rows_of(study));
  // A design that the sweep begins at, as of --start, is another thing: its part may be left.
  settings.fixed.clear();
  const SweepStudy begun(text, source, settings);
  CHECK(rows_of(begun) == std::vector<std::string>{"large", "large"});
}

TEST_CASE("rows are swept whatever their names hold", "[sweep]") {
  const Folder folder;
  const std::string text = cam_with_rollers(folder), source = folder / "cam.toml";
  std::ofstream(folder / "rollers.csv") << "name; roller_radius [mm]\n608-2RS; 11\nA, long; 12\n"
                                           "10; 13\n10..20; 14\n";
  std::ofstream(folder / "rollers.csv", std::ios::app) << "3/8\" wide; 15\nM:1; 16\n";
  const std::vector<std::string> names{"608-2RS", "A, long", "10", "10..20", "3/8\" wide", "M:1"};
  const SweepStudy study(text, source,
                         asked({R"(roller=608-2RS,"A, long","10","10..20","3/8"" wide","M:1")"}));
  CHECK(rows_of(study) == names);
  const SweepStudy one(text, source, asked({R"(roller="A, long")", "stroke=20,25 mm"}));
  CHECK(rows_of(one) == std::vector<std::string>{"A, long", "A, long"});
  const SweepStudy inch(text, source, asked({R"(roller="3/8"" wide")", "stroke=20,25 mm"}));
  CHECK(rows_of(inch) == std::vector<std::string>{names[4], names[4]});
}

TEST_CASE("rows whose names read as the same number are told apart", "[sweep]") {
  const Folder folder;
  const std::string text = cam_with_rollers(folder), source = folder / "cam.toml";
  std::ofstream(folder / "rollers.csv") << "name; roller_radius [mm]\n1.50; 8\n2.00; 9\n1.5; 10\n"
                                           "2; 11\n10.0 mm; 12\n12.0 mm; 13\n";
  for (const std::vector<std::string>& names :
       {std::vector<std::string>{"1.50", "2.00"}, {"2", "1.5"}, {"10.0 mm", "12.0 mm"}}) {
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "" : ",") + listed_value(name);
    CHECK(rows_of(SweepStudy(text, source, asked({"roller=" + list}))) == names);
  }
}

TEST_CASE("a refused sweep names the value", "[sweep]") {
  const Folder folder;
  const std::string text = cam_with_rollers(folder), source = folder / "cam.toml";
  const auto refused = [&](const std::string& setting) {
    return complaint([&] { SweepStudy(text, source, asked({setting})); });
  };
  CHECK_THAT(refused("roller=small,nosuch"), Contains("nosuch"));
  CHECK_THAT(refused("stroke=-5,-6 mm"), Contains("-5 mm"));
  CHECK_THAT(refused("stroke=10,20 mmm"), Contains("with stroke = 20 mmm: ") && Contains("mmm"));
}

}  // namespace camlaw::problems::swept_parts_test
