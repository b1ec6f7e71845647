// SPDX-License-Identifier: MIT
// check, evaluate, optimize and the cam shape, as a user runs them.
#include <cmath>
#include <numbers>

#include "tests/cli/program_runner.h"

namespace camlaw::cli {
namespace {

std::string shipped(const std::string& name) {
  return std::string(CAMLAW_SOURCE_DIR) + "/problems/spine_cutter/" + name;
}

/// A problem file in a folder.
std::string written(const Folder& folder, const std::string& text) {
  const std::string path = folder / "problem.toml";
  std::ofstream(path) << text;
  return path;
}

/// Force at most so much with a cam of at most so much.
std::string force_and_radius(const char* force, const char* radius) {
  return std::string(
             "title = \"both\"\nmechanism = \"spine-cutter\"\n"
             "[law]\nname = \"polynomial-5\"\n"
             "[variables.alpha]\nlower = -10\nupper = 10\nstart = -3\n"
             "[objective]\nminimize = \"peak_drive_torque\"\n"
             "[[constraints]]\nresponse = \"peak_inertia_force\"\nupper = \"") +
         force + "\"\n[[constraints]]\nresponse = \"minimum_cam_radius\"\nupper = \"" + radius +
         "\"\n";
}

}  // namespace

TEST_CASE("optimize gives the verdict with every key", "[program]") {
  const Json result = json_of({"optimize", shipped("least_radius.toml"), "--json"});
  for (const char* key :
       {"status", "verdict", "objective", "variables", "constraints", "kkt_residual", "evaluations",
        "wall_s", "solver", "reason", "global", "law", "seed", "active"}) {
    INFO(key);
    CHECK(result.contains(key));
  }
  CHECK(result["verdict"] == "certified optimum");
  CHECK(result["status"] == "solved");
  const double radius = 60 / (std::numbers::pi * std::tan(std::numbers::pi / 6));
  CHECK(result["objective"].get<double>() == Approx(radius).epsilon(1e-9));
  CHECK(result["variables"]["cam_radius"].get<double>() == Approx(radius).epsilon(1e-9));
  REQUIRE(result["constraints"].size() == 1);
  const Json& limit = result["constraints"][0];
  for (const char* key :
       {"name", "value", "bound", "margin", "unit", "worst_angle_deg", "proved", "multiplier"}) {
    INFO(key);
    CHECK(limit.contains(key));
  }
  CHECK(limit["unit"] == "deg");
  CHECK(limit["proved"] == true);
  CHECK(std::fmod(limit["worst_angle_deg"].get<double>(), 180) == Approx(90).epsilon(1e-6));
}

TEST_CASE("optimize writes its files and says so", "[program]") {
  const Folder folder;
  const std::string text = done({"optimize", shipped("least_force.toml"), "--out", folder / "out"});
  CHECK_THAT(text, Contains("certified optimum") && Contains("-3.33333") && Contains("wrote"));
  for (const char* name : {"result.json", "law.csv", "law.svg", "cycle.svg"}) {
    CHECK(folder.content().contains(std::string("out/") + name));
  }
  check_svg(folder / "out/law.svg");
  check_svg(folder / "out/cycle.svg");
  CHECK(Json::parse(read(folder / "out/result.json"))["verdict"] == "certified optimum");
}

TEST_CASE("optimize ends with 3 and names the limits that contradict each other", "[program]") {
  const Folder folder;
  const Outcome outcome =
      run({"optimize", written(folder, force_and_radius("5 N", "30 mm")), "--json"});
  CHECK(outcome.status == 3);
  const Json result = Json::parse(outcome.out);
  CHECK(result["verdict"] == "infeasible");
  CHECK(result["blamed"] == Json({"peak_inertia_force", "minimum_cam_radius"}));
}

TEST_CASE("optimize ends with 4 where there is no answer", "[program]") {
  const Folder folder;
  const std::string path = written(folder, force_and_radius("500 N", "300 mm"));
  const Outcome outcome = run({"optimize", path, "--solver", "lbfgs"});
  CHECK(outcome.status == 4);
  CHECK_THAT(outcome.out, Contains("failed") && Contains("lbfgs"));
}

TEST_CASE("the same problem and seed give the same answer", "[program]") {
  const auto answer = [](const char* seed) {
    Json result = json_of({"optimize", shipped("least_moment.toml"), "--json", "--seed", seed});
    result.erase("wall_s");
    return result;
  };
  CHECK(answer("7") == answer("7"));
  CHECK(answer("7")["objective"].get<double>() ==
        Approx(answer("8")["objective"].get<double>()).epsilon(1e-8));
}

TEST_CASE("check says a problem in words and compares derivatives", "[program]") {
  const std::string words =
      done({"check", shipped("least_radius.toml"), "--derivatives", "--scaling"});
  CHECK_THAT(words, Contains("cam_radius") && Contains("30 deg") && Contains("all agree") &&
                        Contains("tolerance"));
}

TEST_CASE("evaluate computes every response at the values that are set", "[program]") {
  const Json all = json_of({"evaluate", shipped("least_force.toml"), "--set", "alpha=0", "--json"});
  // The cubic at h = 1 mm: the paper's 4.56 N, doubled; R = 33.08 mm.
  CHECK(all["responses"]["peak_inertia_force"]["value"].get<double>() ==
        Approx(2 * 4.56).epsilon(1e-3));
  CHECK(all["responses"]["minimum_cam_radius"]["value"].get<double>() ==
        Approx(33.08).epsilon(1e-3));
  CHECK(all["constraints"][0]["met"] == true);
  CHECK_THAT(done({"evaluate", shipped("least_force.toml")}), Contains("inertia_force"));
}

TEST_CASE("a bad problem file is one line with its place and what is accepted", "[program]") {
  const Folder folder;
  const std::string path = written(folder, force_and_radius("30 deg", "30 mm"));
  CHECK_THAT(failed({"check", path}, 2),
             Contains("problem.toml:") && Contains("a force is wanted"));
  CHECK_THAT(failed({"optimize", folder / "nothing.toml"}, 2), Contains("nothing.toml"));
  CHECK_THAT(failed({"optimize", shipped("least_force.toml"), "--solver", "simplex"}, 2),
             Contains("simplex") && Contains("slsqp"));
  CHECK_THAT(failed({"evaluate", shipped("least_force.toml"), "--set", "alhpa=1"}, 2),
             Contains("alpha"));
  CHECK_THAT(failed({"reproduce", "spine-cutter", "--n", "10"}, 2), Contains("cam-shape"));
  CHECK_THAT(failed({"reproduce", "cam-shape", "--n", "2"}, 2), Contains("n"));
}

TEST_CASE("the cam shape of any size is certified at the true optimum", "[program]") {
  const Json shape = json_of({"reproduce", "cam-shape", "--n", "400", "--json"});
  for (const char* key : {"n", "printed", "objective", "true_optimum", "max_violation", "verdict",
                          "iterations", "wall_s"}) {
    INFO(key);
    CHECK(shape.contains(key));
  }
  CHECK(shape["n"] == 400);
  CHECK(shape["printed"] == 4.2757);
  CHECK(shape["verdict"] == "certified optimum");
  CHECK(shape["objective"].get<double>() == Approx(4.275688479).epsilon(1e-7));
}

}  // namespace camlaw::cli
