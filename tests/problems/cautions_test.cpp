// SPDX-License-Identifier: MIT
#include "problems/statement/cautions.h"

#include <catch2/catch.hpp>

#include "problems/statement/bind.h"
#include "problems/statement/doubtful_limits.h"
#include "tests/shipped_problems.h"

namespace camlaw::problems::cautions_test {

using Catch::Contains;

namespace {

std::string cam(const std::string& mechanism, const std::string& rest) {
  return "mechanism = '" + mechanism +
         "'\n[program]\nsegments = [{name = 'rise', angle = 80, law = 'cycloidal'}, {name = "
         "'back', law = 'cycloidal'}]\n" +
         rest;
}

/// The cautions, of which those about sizes that are not stated have a test of their own.
std::vector<std::string> said(const std::string& text, bool of_defaults = false) {
  std::vector<std::string> all;
  for (const Caution& caution : cautions(read_problem(text, "f.toml"))) {
    if (caution.what.ends_with("not stated") == of_defaults) all.push_back(caution.text());
  }
  return all;
}

std::vector<std::string> doubts(const std::string& text) {
  return doubtful_limits(BoundProblem(read_problem(text, "f.toml"), true));
}

}  // namespace

TEST_CASE("a law whose jerk counts and whose acceleration jumps at its ends is named",
          "[cautions]") {
  const auto law = [](const std::string& alpha, const std::string& response) {
    return "mechanism = 'law'\n[law]\nname = 'polynomial-5'\nalpha = " + alpha +
           "\n[objective]\nminimize = 'C'\n[[constraints]]\nresponse = '" + response +
           "'\nupper = 80\n";
  };
  const auto jumps = said(law("-5", "C_j"));  // s''(0) = 6 + 0.6 alpha
  REQUIRE(jumps.size() == 1);
  CHECK_THAT(jumps[0], Contains("jumps at an end") && Contains("begins with 3 and ends with -3"));
  CHECK(said(law("-5", "jerk")).size() == 1);
  CHECK(said(law("-10", "C_j")).empty());  // 3-4-5: from rest to rest
  CHECK(said(law("-5", "C_v")).empty());   // nobody asks for the jerk
}

TEST_CASE("a variation of the motion is named where a verdict leaves it out", "[cautions]") {
  const std::string limit = "[[constraints]]\nresponse = 'pressure_angle'\nupper = 30\n";
  const auto with = [&](const std::string& varied) {
    return said(cam("disc-cam-roller", limit + "[variation." + varied + "]\nplus = 0.1\n"));
  };
  CHECK(with("base_radius").empty());
  const auto angle = with("rise_angle");
  REQUIRE(angle.size() == 1);
  CHECK_THAT(angle[0],
             Contains("judged without a variation") && Contains("rise_angle (+0.1/+0 deg)"));
}

TEST_CASE("a variation of the motion is not named where it moves nothing", "[cautions]") {
  const std::string varied = "[variation.rise_angle]\nplus = 0.1\n";
  const std::string size = "[[constraints]]\nresponse = 'base_radius'\nupper = 60\n";
  CHECK(said(cam("disc-cam-roller", size + varied)).empty());
  // Of two laws one has no alpha.
  const std::string laws =
      "mechanism = 'law'\n[law]\nname = ['polynomial-5', 'constant-velocity']\n[variation.alpha]\n"
      "plus = 0.1\n[objective]\nminimize = 'C_v'\n";
  const BoundProblem bound(read_problem(laws, "f.toml"), true);
  REQUIRE(bound.choices().size() == 1);
  CHECK(cautions(bound.at({0}, {})).size() == 1);
  CHECK(cautions(bound.at({1}, {})).empty());
}

TEST_CASE("a contact of a crowned roller beyond its formulas is named, where the crown counts",
          "[cautions]") {
  const auto with = [](const std::string& mechanism, const std::string& constants,
                       const std::string& limits) {
    return said("mechanism = '" + mechanism + "'\n[constants]\nspring_preload = 400\n" + constants +
                "[program]\nsegments = [{name = 'rise', angle = 80, law = 'cycloidal'}, {name = "
                "'back', law = 'cycloidal'}]\n" +
                limits);
  };
  const std::string limit = "[[constraints]]\nresponse = 'crown_stress'\nupper = 900\n";
  const auto found = with("disc-cam-roller", "crown_radius = '20 m'\n", "");
  REQUIRE(found.size() == 1);
  CHECK_THAT(found[0], Contains("crown_elongation is ") && Contains("from 0.021 to 46.6"));
  CHECK(with("disc-cam-roller", "crown_radius = '300 mm'\n", limit).empty());
  CHECK(with("disc-cam-roller", "", limit).empty());
  // Half a meter on a roller that is thin: alpha is about 1000, and counts where the crown is
  // asked.
  CHECK(with("disc-cam-roller", "roller_radius = 0.5\n", "").empty());
  CHECK(with("disc-cam-roller", "roller_radius = 0.5\n", limit).size() == 1);
  // A limit of the line contact beside a stated crown.
  const auto of_line = with("disc-cam-roller", "crown_radius = '300 mm'\n",
                            "[[constraints]]\nresponse = 'max_shear'\nupper = 900\n");
  REQUIRE(of_line.size() == 1);
  CHECK_THAT(of_line[0],
             Contains("max_shear is that of a line contact") && Contains("crown_shear"));
  const auto checked = with("disc-cam-roller", "crown_radius = '300 mm'\nface_width = 12\n",
                            "[buildable]\nallowable_pressure = 900\n");
  REQUIRE(checked.size() == 1);
  CHECK_THAT(checked[0], Contains("contact_stress") && Contains("crown_stress"));
  CHECK(with("disc-cam-roller", "", "[[constraints]]\nresponse = 'max_shear'\nupper = 900\n")
            .empty());
  // A crown that is sharper than the roller: only the axes of the ellipse change their places.
  CHECK(with("disc-cam-roller", "crown_radius = '3 mm'\n", "").empty());
  const auto sharp =
      with("disc-cam-roller", "crown_radius = 1\nbase_radius = 2000\nroller_radius = 2000\n", "");
  REQUIRE(sharp.size() == 1);
  CHECK_THAT(sharp[0], Contains("crown_elongation is 0.0"));
}

TEST_CASE("a main size that counts and is not stated is named with its default", "[cautions]") {
  const std::string limit = "[[constraints]]\nresponse = 'pressure_angle'\nupper = 30\n";
  const auto of_cam = [](const std::string& rest) {
    return said(cam("disc-cam-roller", rest), true);
  };
  const auto found = of_cam(limit + "[constants]\nbase_radius = '50 mm'\n");
  REQUIRE(found.size() == 1);
  CHECK(found[0] ==
        "stroke and roller_radius are not stated: the defaults stroke = 20 mm and roller_radius = "
        "10 mm are used; state your own in [constants]");
  const std::string sizes = "[constants]\nstroke = 30\nroller_radius = 8\n";
  const std::string varies = "[variables.base_radius]\nlower = 20\nupper = 90\n";
  CHECK(of_cam(limit + sizes + varies).empty());
  CHECK(of_cam(limit + sizes).size() == 1);
  // The force does not depend on the radii, and without a limit nothing is asked of the sizes.
  const std::string force = "[[constraints]]\nresponse = 'follower_force'\nlower = 0\n";
  CHECK(of_cam(force + "[constants]\nstroke = 30\n").empty());
  CHECK(of_cam("").empty());
  // The numbers of a published machine are its own.
  CHECK(said("mechanism = 'spine-cutter'\n[law]\nname = 'cosine'\n[objective]\nminimize = "
             "'peak_inertia_force'\n",
             true)
            .empty());
}

TEST_CASE("angles that are plain numbers and hardly degrees are named", "[cautions]") {
  const auto turn = [](const std::string& first, const std::string& second = "") {
    const std::string rest = second.empty() ? "" : "angle = " + second + ", ";
    const std::string low = second.empty() ? "" : ", {name = 'low'}";
    return said(
        "mechanism = 'disc-cam-roller'\n[program]\nsegments = [{name = 'rise', angle = " + first +
        ", law = 'cycloidal'}, {" + rest + "name = 'back', law = 'cycloidal'}" + low + "]\n");
  };
  const auto found = turn("1.9", "2.1");
  REQUIRE(found.size() == 1);
  CHECK_THAT(found[0], Contains("angle = 1.9 is read as 1.9 deg") && Contains("\"1.9 rad\""));
  CHECK(turn("0.25").size() == 1);
  CHECK(turn("'1.9 deg'").empty());
  CHECK(turn("1.9", "'2.1 deg'").empty());
  CHECK(turn("2", "120").empty());  // a short segment beside a long one
  CHECK(turn("80").empty());
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
  int count = 0;
  for (const std::string& file : testing::shipped_problem_files()) {
    INFO(file);
    CHECK(doubtful_limits(BoundProblem(read_problem_file(file), true)).empty());
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
