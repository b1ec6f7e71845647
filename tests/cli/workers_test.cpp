// SPDX-License-Identifier: MIT
// --workers of the commands that search for one answer.
#include "tests/cli/program_runner.h"
#include "tests/paths.h"

namespace camlaw::cli::workers_test {
namespace {

std::string shipped(const std::string& name) { return testing::source("problems/") + name; }

std::vector<Words> commands() {
  return {{"optimize", shipped("die_press/least_approach.toml")},
          {"synthesize", shipped("free_law/least_acceleration_at_jerk.toml")},
          {"fit", shipped("cams/worn_cam.csv"), "--mechanism", "disc-cam-roller", "--set",
           "roller_radius=8 mm"}};
}

Words with(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

}  // namespace

TEST_CASE("the answer of a search does not depend on the workers", "[program][workers]") {
  for (const Words& command : commands()) {
    INFO(command.front());
    const std::string one = done(with(command, {"--json", "--workers", "1"}));
    CHECK(done(with(command, {"--json", "--workers", "3"})) == one);
  }
}

TEST_CASE("a count of workers that makes no sense is refused", "[program][workers]") {
  for (const Words& command : commands()) {
    for (const char* workers : {"0", "-1", "many", "1.5", "", "257"}) {
      INFO(command.front() << " " << workers);
      const std::string said = failed(with(command, {"--workers", workers}), 2);
      CHECK_THAT(said, Contains("--workers"));
    }
  }
  CHECK_THAT(failed({"fit", "--constants", "C_v=2", "--workers", "2"}, 2), Contains("--workers"));
}

}  // namespace camlaw::cli::workers_test
