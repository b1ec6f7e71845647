// SPDX-License-Identifier: MIT
#include "problems/results/recorded_design.h"

#include <catch2/catch.hpp>
#include <filesystem>

#include "problems/law_files/json_text.h"
#include "problems/law_files/law_file.h"
#include "problems/law_files/pieces_json.h"
#include "problems/results/design_json.h"
#include "tests/paths.h"
#include "tests/temporary_folder.h"

namespace camlaw::problems::recorded_design_test {
namespace {

namespace fs = std::filesystem;
using Catch::Contains;
using testing::Folder;

/// What optimize prints of a design, as far as the reader looks at it.
std::string result_text(const Json& design) {
  return Json{{"verdict", "feasible"}, {"design", design}}.dump(2);
}

/// The design in the middle of the box, of the last option of each choice.
struct Chosen {
  std::vector<std::size_t> options;
  std::vector<double> x;
};

Chosen chosen(const BoundProblem& bound) {
  Chosen result;
  for (const auto& choice : bound.choices()) result.options.push_back(choice.options.size() - 1);
  for (const auto& v : bound.problem(result.options).variables) {
    result.x.push_back(v.start + 0.1 * (v.upper - v.start));
  }
  return result;
}

void check_same(const ProblemStatement& a, const ProblemStatement& b) {
  CHECK(a.constants == b.constants);
  REQUIRE(a.laws.size() == 1);
  CHECK(a.laws.front().name() == b.laws.front().name());
  CHECK(a.laws.front().arguments.values() == b.laws.front().arguments.values());
  CHECK(pieces_to_json(a.laws.front().law()) == pieces_to_json(b.laws.front().law()));
}

/// What is said against a text.
std::string complaint(const std::string& text) {
  try {
    read_result(text, "r.json");
    return "accepted";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

constexpr const char* kChoices = R"(
mechanism = "spine-cutter"
[law]
name = ["cosine", "polynomial-5", "modified-sine"]
[variables.alpha]
lower = -10
upper = 0
[variables.cam_radius]
lower = "20 mm"
upper = "80 mm"
[variables.blades]
values = [17, 19, 21]
[objective]
minimize = "cam_radius"
)";

}  // namespace

TEST_CASE("A recorded design comes back to the last bit", "[results]") {
  for (const char* folder : {"cams", "spine_cutter", "springs", "free_law", "die_press"}) {
    for (const auto& file : fs::directory_iterator(testing::source("problems/") + folder)) {
      if (file.path().extension() != ".toml") continue;
      INFO(file.path());
      const BoundProblem bound(read_problem_file(file.path()));
      const auto [options, x] = chosen(bound);
      const auto read = read_result(result_text(recorded_design(bound, options, x)), "r.json");
      check_same(read.statement, bound.at(options, x));
      CHECK(read.verdict == "feasible");
      CHECK(read.statement.source == file.path().filename());
      CHECK(read.statement.text == testing::read(file.path()));
    }
  }
}

TEST_CASE("Choices of laws and of listed values are part of a recorded design", "[results]") {
  const BoundProblem bound(read_problem(kChoices, "f.toml"));
  for (std::size_t law = 0; law < 3; ++law) {
    const std::vector<std::size_t> options{law, 1};
    const std::vector<double> x = law == 1 ? std::vector{-1.0 / 3, 30.1} : std::vector{30.1};
    const auto read = read_result(result_text(recorded_design(bound, options, x)), "r.json");
    check_same(read.statement, bound.at(options, x));
  }
}

TEST_CASE("A result stands alone without the law files of its problem", "[results]") {
  const Folder folder;
  const std::string problem =
      "mechanism = 'disc-cam-roller'\n[program]\nsegments = [{name = 'rise', angle = 180, law = "
      "'own.json'}, {name = 'return', law = ['cycloidal', 'own.json']}]\n"
      "[variables.rise_angle]\nlower = 100\nupper = 200\nstart = 180\n"
      "[objective]\nminimize = 'peak_pressure_angle'\n";
  std::ofstream(folder / "own.json")
      << law_file(find_law("scca a=0.3 b=0.3 c=0.4").law(), "own", nullptr).dump();
  const BoundProblem bound(read_problem(problem, folder / "p.toml"));
  const auto result = result_text(recorded_design(bound, {1}, std::vector{150.25}));
  fs::remove(folder / "own.json");
  check_same(read_result(result, "r.json").statement, bound.at({1}, std::vector{150.25}));
}

TEST_CASE("What is not a result is refused with what it should be", "[results]") {
  const BoundProblem bound(read_problem(kChoices, "f.toml"));
  const Json design = recorded_design(bound, {1, 0}, std::vector{-2.0, 30.0});
  CHECK(complaint(result_text(design)) == "accepted");
  CHECK(recorded_design(bound, {1, 0}, std::vector{-2.0}).is_null());
  CHECK(recorded_design(bound, {1, 0}, std::vector{std::nan(""), 30.0}).is_null());
  CHECK_THAT(complaint("{\"verdict\": \"fea"),
             Contains("r.json: it is not valid JSON, or it is incomplete"));
  const std::string deep(100000, '[');
  CHECK_THAT(complaint("{\"verdict\": " + deep),
             Contains("r.json: its brackets are nested more than 64 deep"));
  CHECK_THAT(complaint("{}"),
             Contains("r.json: it is not a result with a design in it; give a problem"));
  CHECK_THAT(complaint("{\"verdict\": \"failed\", \"design\": null}"),
             Contains("r.json: it holds no design; its verdict is \"failed\""));
  const auto without = [&](const char* key) {
    Json damaged = design;
    damaged.erase(key);
    return complaint(result_text(damaged));
  };
  for (const char* key : {"problem", "source", "law", "law_files", "variables"}) {
    CHECK_THAT(without(key), Contains(std::string("r.json: its design has no ") + key));
  }
  const auto with = [&](const char* key, const Json& value) {
    Json damaged = design;
    damaged["variables"][key] = value;
    return complaint(result_text(damaged));
  };
  CHECK_THAT(with("alpha", 3), Contains("alpha of its design: 3 is outside the bounds -10 .. 0"));
  CHECK_THAT(with("blades", 18), Contains("blades of its design: 18 is not one of 17, 19 and 21"));
  CHECK_THAT(with("alpha", "x"), Contains("its design has no number for alpha"));
}

TEST_CASE("A design is read from a problem file or from a result, whatever it is called",
          "[results]") {
  const Folder folder;
  std::ofstream(folder / "a") << kChoices;
  CHECK_FALSE(read_design_file(folder / "a").verdict);
  const BoundProblem bound(read_problem(kChoices, "f.toml"));
  std::ofstream(folder / "b") << "\n"
                              << result_text(recorded_design(bound, {0, 2}, std::vector{33.0}));
  const auto read = read_design_file(folder / "b");
  CHECK(read.verdict == "feasible");
  CHECK(read.statement.laws.front().name() == "cosine");
  CHECK_THROWS_WITH(read_design_file(folder / "none"), Contains("none: cannot be read"));
}

}  // namespace camlaw::problems::recorded_design_test
