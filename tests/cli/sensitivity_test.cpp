// SPDX-License-Identifier: MIT
// evaluate --sensitivity, and reproduce of a table's file, as a user runs them.
#include <algorithm>
#include <cmath>
#include <map>

#include "tests/cli/program_runner.h"
#include "tests/paths.h"

namespace camlaw::cli::sensitivity_test {
namespace {

using testing::write;

std::string shipped(const std::string& name) { return testing::source("problems/") + name; }

const std::string kForce = "peak_inertia_force";

}  // namespace

TEST_CASE("the sensitivities of a problem file are told to people and programs",
          "[cli][sensitivity]") {
  const std::string file = shipped("spine_cutter/least_force.toml");
  const ParsedJson said =
      json_of({"evaluate", file, "--sensitivity", "--over", "block_speed=0.2:0.4 m/s", "--over",
               "stroke=38:42 mm", "--samples", "256", "--json"});
  const ParsedJson& sensitivity = said["sensitivity"];
  // F = 4 m C S V^2 / S_rev^2: the exponents are the elasticities.
  std::map<std::string, double> elasticities;
  for (const ParsedJson& row : sensitivity["derivatives"]) {
    if (row["number"] == kForce)
      elasticities[row["parameter"]] =
          row["elasticity"].is_null() ? std::nan("") : row["elasticity"].get<double>();
  }
  CHECK(elasticities["mass"] == Approx(1).epsilon(1e-12));
  CHECK(elasticities["stroke"] == Approx(1).epsilon(1e-12));
  CHECK(elasticities["block_speed"] == Approx(2).epsilon(1e-12));
  CHECK(elasticities["cutter_diameter"] == Approx(-2 * 50.0 / 48).epsilon(1e-12));
  const ParsedJson& sobol = sensitivity["sobol"];
  CHECK(sobol["ranges_from"] == "stated");
  double sum = 0;
  for (const ParsedJson& row : sobol["indices"]) {
    if (row["number"] == kForce) sum += row["first"].get<double>();
    CHECK(row["first_low"].get<double>() <= row["first_high"].get<double>());
  }
  CHECK(sum == Approx(1).margin(0.05));  // nearly a sum: V^2 and S
  const std::string text = done({"evaluate", file, "--sensitivity", "--samples", "16"});
  CHECK_THAT(text,
             Contains("% per %") && Contains("1 % to either side") && Contains("block_speed"));
}

TEST_CASE("options of sensitivities are checked", "[cli][sensitivity]") {
  const std::string file = shipped("spine_cutter/least_force.toml");
  CHECK_THAT(failed({"evaluate", file, "--over", "stroke=38:42 mm"}, 2), Contains("--sensitivity"));
  CHECK_THAT(failed({"evaluate", file, "--samples", "64"}, 2), Contains("--sensitivity"));
  CHECK_THAT(failed({"evaluate", file, "--sensitivity", "--over", "strok=1:2 mm"}, 2),
             Contains("stroke"));
  CHECK_THAT(failed({"evaluate", file, "--sensitivity", "--over", "blades=10:20"}, 2),
             Contains("blades"));
  CHECK_THAT(failed({"evaluate", file, "--sensitivity", "--samples", "1"}, 2),
             Contains("--samples"));
}

TEST_CASE("a report has the sensitivities of a design", "[cli][sensitivity][report]") {
  const Folder folder;
  const std::string page = folder / "page.html";
  done({"report", shipped("spine_cutter/least_force.toml"), "-o", page});
  CHECK_THAT(read(page), Contains("Sensitivities") && Contains("Sobol indices"));
}

TEST_CASE("reproduce takes the file of a table", "[cli][sensitivity]") {
  const Folder folder;
  const std::string path = folder / "cutter.toml", page = folder / "page.html";
  write(path,
        "mechanism = \"spine-cutter\"\n[[values]]\nid = \"chord\"\nresponse = "
        "\"chord_of_contact\"\nset = \"depth = 0.4 mm\"\nprinted = \"8.91 mm\"\n"
        "[[values]]\nid = \"blades\"\nresponse = \"blades_in_contact\"\nset = \"depth = 0.6 mm\"\n"
        "printed = \"1.47\"\n[hypotheses.number]\nstated = \"17\"\nset = \"blades={}\"\n"
        "alternatives = [\"10:1:30\"]\n");
  const ParsedJson said = json_of({"reproduce", path, "--json"});
  REQUIRE(said.size() == 1);
  CHECK(said[0]["system"] == "cutter");
  CHECK(said[0]["reproduced"] == 1);
  CHECK(said[0]["explained"] == 1);
  CHECK(said[0]["departures"] ==
        ParsedJson::array({"number: 21 (stated 17), one of 21 tried, needed by 1 value"}));
  CHECK_THAT(done({"reproduce", path, "--report", page}), Contains("number: 21"));
  CHECK_THAT(read(page), Contains("chord"));
  CHECK_THAT(failed({"reproduce", path, "--report", path}, 2), Contains("cutter.toml"));
  write(path,
        "mechanism = \"spine-cutter\"\n[[values]]\nid = \"chord\"\nresponse = \"chor\"\n"
        "printed = \"1\"\n");
  CHECK_THAT(failed({"reproduce", path}, 2),
             Contains("cutter.toml:4") && Contains("'chord'.response"));
}

TEST_CASE("the program's tables are its files, by name and by path", "[cli][sensitivity]") {
  for (const char* name : {"die-press", "sheet-delivery", "motion-laws", "signature-feeder"}) {
    INFO(name);
    std::string file = name;
    std::replace(file.begin(), file.end(), '-', '_');
    CHECK(json_of({"reproduce", name, "--json"}) ==
          json_of({"reproduce", shipped("published/" + file + ".toml"), "--json"}));
  }
}

}  // namespace camlaw::cli::sensitivity_test
