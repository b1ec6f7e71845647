// SPDX-License-Identifier: MIT
#include "problems/statement/cautions.h"

#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>

#include "problems/statement/bind.h"
#include "problems/statement/doubtful_limits.h"

namespace camlaw::problems::cautions_test {

using Catch::Contains;

namespace {

std::string cam(const std::string& mechanism, const std::string& rest) {
  return "mechanism = '" + mechanism +
         "'\n[program]\nsegments = [{name = 'rise', angle = 80, law = 'cycloidal'}, {name = "
         "'back', law = 'cycloidal'}]\n" +
         rest;
}

std::vector<std::string> said(const std::string& text) {
  std::vector<std::string> all;
  for (const Caution& caution : cautions(read_problem(text, "f.toml"))) {
    all.push_back(caution.text());
  }
  return all;
}

std::vector<std::string> doubts(const std::string& text) {
  return doubtful_limits(BoundProblem(read_problem(text, "f.toml"), true));
}

const std::string kSound =
    "[constants]\nbase_radius = '80 mm'\nspeed = '60 rpm'\nspring_preload = '200 N'\n";

}  // namespace

TEST_CASE("a sound cam has no cautions", "[cautions]") {
  for (const char* mechanism : {"disc-cam-roller", "disc-cam-flat"}) {
    CHECK(said(cam(mechanism, kSound)).empty());
  }
  CHECK(said("mechanism = 'spine-cutter'\n[law]\nname = 'cosine'\n").empty());
}

TEST_CASE("what a cam does not bear is said, whatever its limits", "[cautions]") {
  struct Case {
    std::string mechanism, constants, part;
  };
  const std::vector<Case> cases = {
      {"disc-cam-roller", "base_radius = '15 mm'\nroller_radius = '60 mm'\n",
       "the profile is undercut: undercut reaches "},
      {"disc-cam-flat", "base_radius = '5 mm'\n", "the profile is undercut: profile_radius falls"},
      {"disc-cam-roller", "speed = '3000 rpm'\n", "the follower leaves the cam: contact is lost"},
      {"disc-cam-roller", "base_radius = '10 mm'\nbore_radius = '10 mm'\n",
       "the bore takes the whole base circle: base_radius is 10 mm and bore_radius 10 mm"},
      {"disc-cam-conjugate", "base_radius = '25 mm'\nroller_radius = '45 mm'\n",
       "the profile is undercut: second_undercut"},
      {"disc-cam-roller", "cutter_radius = '500 mm'\n", "the tool does not fit a hollow"},
  };
  for (const Case& c : cases) {
    INFO(c.constants);
    const auto all = said(cam(c.mechanism, "[constants]\n" + c.constants));
    CHECK(std::any_of(all.begin(), all.end(),
                      [&](const auto& text) { return text.find(c.part) != std::string::npos; }));
  }
}

TEST_CASE("the speed at which contact is lost is where its caution begins", "[cautions]") {
  const std::string sound = "[constants]\nbase_radius = '80 mm'\nspring_preload = '200 N'\n";
  double lost = 0;
  for (const auto& r : evaluate(read_problem(cam("disc-cam-roller", sound), "f.toml"))) {
    if (r.name == "contact_loss_speed") lost = r.value;
  }
  REQUIRE(lost > 100);
  const auto at = [&](double speed) {
    return said(cam("disc-cam-roller", sound + fmt::format("speed = '{:.12g} rpm'\n", speed)));
  };
  CHECK(at(lost * (1 - 1e-6)).empty());
  CHECK(at(lost * (1 + 1e-6)).size() == 1);
}

TEST_CASE("a law whose jerk counts and whose acceleration jumps at its ends is named",
          "[cautions]") {
  const auto law = [](const std::string& alpha, const std::string& response) {
    return "mechanism = 'law'\n[law]\nname = 'polynomial-5'\nalpha = " + alpha +
           "\n[objective]\nminimize = 'C'\n[[constraints]]\nresponse = '" + response +
           "'\nupper = 80\n";
  };
  const auto jumps = said(law("-5", "D"));  // s''(0) = 6 + 0.6 alpha
  REQUIRE(jumps.size() == 1);
  CHECK_THAT(jumps[0], Contains("jumps at an end") && Contains("begins with 3 and ends with -3"));
  CHECK(said(law("-5", "jerk")).size() == 1);
  CHECK(said(law("-10", "D")).empty());  // 3-4-5: from rest to rest
  CHECK(said(law("-5", "B")).empty());   // nobody asks for the jerk
}

TEST_CASE("a limit with a wrong unit is named, with what it was read as", "[cautions]") {
  const std::string varies = "[variables.base_radius]\nlower = '30 mm'\nupper = '120 mm'\n";
  const auto limited = [&](const std::string& limit) {
    return doubts(cam("disc-cam-roller", varies + "[[constraints]]\n" + limit));
  };
  const auto low = limited("response = 'contact_stress'\nupper = '800 mPa'\n");
  REQUIRE(low.size() == 1);
  CHECK_THAT(low.front(), Contains("contact_stress <= 8e-07 MPa is never met"));
  const auto high = limited("response = 'contact_stress'\nupper = '800 PPa'\n");
  REQUIRE(high.size() == 1);
  CHECK_THAT(high.front(), Contains("is never active"));
  CHECK(limited("response = 'contact_stress'\nupper = '800 MPa'\n").empty());
  CHECK(limited("response = 'follower_force'\nlower = 0\n").empty());
  CHECK(limited("response = 'peak_pressure_angle'\nupper = '30 deg'\n").empty());
  CHECK(limited("response = 'follower_force'\nlower = '1 GN'\n").size() == 1);
  CHECK(limited("response = 'follower_force'\nlower = '-10 GN'\n").size() == 1);
}

TEST_CASE("no limit of a shipped problem is doubtful", "[cautions]") {
  namespace fs = std::filesystem;
  int count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(CAMLAW_SOURCE_DIR "/problems")) {
    if (entry.path().extension() != ".toml") continue;
    INFO(entry.path());
    CHECK(doubtful_limits(BoundProblem(read_problem_file(entry.path()), true)).empty());
    ++count;
  }
  CHECK(count > 35);
}

TEST_CASE("a bound on a pressure angle beyond 90 deg is refused", "[cautions]") {
  for (const char* limit : {"response = 'pressure_angle'\nupper = '95 deg'\n",
                            "response = 'pressure_angle'\nlower = '-1.6 rad'\n",
                            "response = 'peak_pressure_angle'\nupper = '95 deg'\n"}) {
    CHECK_THROWS_WITH(
        read_problem(cam("disc-cam-roller", std::string("[[constraints]]\n") + limit), "f.toml"),
        Contains("pressure_angle is never outside"));
  }
  read_problem(
      cam("disc-cam-roller", "[[constraints]]\nresponse = 'pressure_angle'\nupper = '90 deg'\n"),
      "f.toml");
}

}  // namespace camlaw::problems::cautions_test
