// SPDX-License-Identifier: MIT
// verify: a stored design and its claim, judged again.
#include "tests/cli/program_runner.h"

namespace camlaw::cli {
namespace {

const std::string kCam = std::string(CAMLAW_SOURCE_DIR) + "/problems/cams/roller_least_base.toml";

std::string stored(const Folder& folder, const Json& result) {
  const std::string path = folder / "result.json";
  std::ofstream(path) << result.dump();
  return path;
}

}  // namespace

TEST_CASE("a claim of the program's own holds when it is judged again", "[program]") {
  const Folder folder;
  const Json result = json_of({"optimize", kCam, "--json"});
  const std::string path = stored(folder, result);
  const Json again = json_of({"verify", path, "--json"});
  CHECK(again["holds"] == true);
  CHECK(again["verdict"] == result["verdict"]);
  CHECK(again["objective"].get<double>() ==
        Approx(result["objective"].get<double>()).epsilon(1e-12));
  const Outcome text = run({"verify", path});
  CHECK(text.status == 0);
  CHECK(text.out.find("the claim holds") != std::string::npos);
}

TEST_CASE("a claim that was edited does not hold", "[program]") {
  const Folder folder;
  const Json result = json_of({"optimize", kCam, "--json"});
  Json better = result;
  better["objective"] = result["objective"].get<double>() - 1;
  Json moved = result;
  const double radius = result["variables"]["base_radius"].get<double>();
  moved["design"]["variables"]["base_radius"] = radius - 1;
  Json bigger = result;
  bigger["design"]["variables"]["base_radius"] = radius + 1;
  bigger["objective"] = radius + 1;
  for (const Json& edited : {better, moved, bigger}) {
    const Outcome outcome = run({"verify", stored(folder, edited)});
    INFO(outcome.out);
    CHECK(outcome.status == 4);
    CHECK(outcome.out.find("the claim does not hold") != std::string::npos);
  }
}

TEST_CASE("a claim about whole and listed variables alone is judged with them held", "[program]") {
  const Folder folder;
  const std::string file = folder / "whole.toml";
  std::ofstream(file) << R"(mechanism = "spine-cutter"
[law]
name = "cosine"
[variables.blades]
type = "integer"
lower = 10
upper = 24
start = 17
[objective]
minimize = "peak_inertia_force"
)";
  const Json result = json_of({"optimize", file, "--json"});
  REQUIRE(result["verdict"] == "certified optimum");
  const Json again = json_of({"verify", stored(folder, result), "--json"});
  CHECK(again["holds"] == true);
  CHECK(again["choices_held"] == true);
}

TEST_CASE("a problem file claims nothing that could be verified", "[program]") {
  const Outcome outcome = run({"verify", kCam});
  CHECK(outcome.status == 2);
  CHECK(outcome.err.find("claims nothing") != std::string::npos);
}

}  // namespace camlaw::cli
