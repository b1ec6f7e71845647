// SPDX-License-Identifier: MIT
// What camlaw evaluate says of values that make no machine, and of curves without numbers.
#include <fmt/format.h>

#include "machines/registry.h"
#include "tests/cli/program_runner.h"

namespace camlaw::cli::impossible_machines_test {
namespace {

std::string file_of(const Folder& folder, const std::string& text) {
  const std::string path = folder / "f.toml";
  std::ofstream(path) << text;
  return path;
}

const char* const kProgram =
    "[program]\nsegments = [{angle = 120, law = 'cycloidal'}, {law = 'cycloidal'}]\n";

}  // namespace

TEST_CASE("values that make no machine are answered with the condition that fails", "[program]") {
  const Folder folder;
  const auto refused = [&](const std::string& text) {
    return failed({"evaluate", file_of(folder, text)}, 2);
  };
  CHECK_THAT(
      refused(std::string("mechanism = 'servo-axis'\nconstants.corner_speed = 7000\n") + kProgram),
      Contains("servo-axis is not possible with these values: corner_speed = 7000 rpm, "
               "maximum_speed = 6000 rpm; corner_speed must be below maximum_speed\n"));
  const std::string feeder =
      "mechanism = 'signature-feeder'\n[constants]\ncrank_radius = 135\ncentre_distance = 177\n";
  CHECK_THAT(refused(feeder + "offset = 0\npinion_radius = 95"),
             Contains(": crank_radius = 135 mm, centre_distance = 177 mm, pinion_radius = 95 mm; "
                      "pinion_radius must be below centre_distance - crank_radius\n"));
  CHECK_THAT(refused(feeder + "offset = 42\npinion_radius = 20"),
             Contains("offset = 42 mm; offset must be less in size than"));
}

TEST_CASE("a search that ends at values that make no machine names the condition", "[program]") {
  const Folder folder;
  const std::string why =
      "disc-cam-roller is not possible with these values: base_radius = 40 mm, roller_radius = 10 "
      "mm, offset = 170 mm; offset must be less in size than base_radius + roller_radius";
  const std::string cam =
      "mechanism = 'disc-cam-roller'\n[constants]\nstroke = 30\nroller_radius = 10\noffset = 170\n"
      "[variables.base_radius]\nlower = 20\nupper = 150\nstart = 40\n";
  const auto answer = [](const Words& words) { return ParsedJson::parse(run(words).out); };
  const std::string one =
      file_of(folder, cam + kProgram + "[objective]\nminimize = 'peak_torque'\n");
  CHECK_THAT(failed({"evaluate", one}, 2), Contains(": " + why + "\n"));
  // No base radius up to 150 mm makes a machine of this offset.
  const ParsedJson none = answer({"optimize", one, "--json", "--out", folder / "out"});
  CHECK(none["verdict"] == "infeasible");
  CHECK(none["global"] == "no values within the bounds of the variables make a possible machine");
  CHECK_THAT(none["reason"].get<std::string>(),
             Contains("no values within the bounds of the variables make a possible machine; ") &&
                 Contains("undefined at the start (peak_torque): " + why));
  CHECK(run({"optimize", one}).status == 3);
  CHECK(run({"verify", folder / "out/result.json"}).status == 0);
  const std::string two = file_of(folder, cam + kProgram +
                                              "[[objectives]]\nminimize = 'peak_torque'\n"
                                              "[[objectives]]\nminimize = 'outer_radius'\n");
  CHECK(answer({"pareto", two, "--points", "3", "--json"})["why_impossible"] == why);
}

TEST_CASE("where no machine of the box is possible the answer is infeasible", "[program]") {
  const Folder folder;
  const auto verdict = [&](const std::string& base, const std::string& roller) {
    const std::string path =
        file_of(folder,
                "mechanism = 'disc-cam-oscillating-roller'\n[constants]\nswing = 16\n"
                "arm_length = 68\npivot_distance = 149\nbase_radius = " +
                    base + "\n[variables.roller_radius]\nlower = 4\nupper = " + roller +
                    "\n[variables.speed]\nlower = 50\nupper = 700\n[objective]\nminimize = "
                    "'peak_torque'\n" +
                    kProgram);
    return ParsedJson::parse(run({"optimize", path, "--starts", "1", "--json"}).out);
  };
  // There is a machine where base_radius + roller_radius is above 149 - 68 = 81 mm.
  const ParsedJson none = verdict("56", "20");
  CHECK(none["verdict"] == "infeasible");
  CHECK_THAT(none["reason"].get<std::string>(),
             Contains("base_radius + roller_radius must be above the difference of arm_length and "
                      "pivot_distance"));
  CHECK(verdict("66", "20")["verdict"] != "infeasible");
}

TEST_CASE("constants that make no machine whatever varies are infeasible", "[program]") {
  const Folder folder;
  const std::string path = file_of(
      folder,
      std::string("mechanism = 'servo-axis'\n[constants]\ncorner_speed = 7000\n"
                  "[variables.load_inertia]\nlower = 0.01\nupper = 0.02\n[objective]\nminimize = "
                  "'peak_torque'\n") +
          kProgram);
  const ParsedJson answer = ParsedJson::parse(run({"optimize", path, "--json"}).out);
  CHECK(answer["verdict"] == "infeasible");
  CHECK_THAT(answer["reason"].get<std::string>(),
             Contains("corner_speed must be below maximum_speed"));
}

TEST_CASE("a search that ends next to impossible machines names their condition", "[program]") {
  const Folder folder;
  const std::string path =
      file_of(folder, std::string("mechanism = 'disc-cam-oscillating-roller'\n[constants]\nswing = "
                                  "20\npivot_distance = 150\narm_length = 100\nroller_radius = "
                                  "10\n[variables.base_radius]\nlower = 5\nupper = 100\nstart = "
                                  "60\n[objective]\nminimize = 'base_radius'\n") +
                          kProgram);
  const ParsedJson answer = ParsedJson::parse(run({"optimize", path, "--json"}).out);
  CHECK(answer["verdict"] == "feasible");
  CHECK_THAT(answer["reason"].get<std::string>(),
             Contains("it ended next to designs for which the machine is not possible: "
                      "base_radius + roller_radius must be above the difference of arm_length and "
                      "pivot_distance"));
}

TEST_CASE("a follower that jams is said to, and where", "[program]") {
  const Folder folder;
  const std::string path = file_of(
      folder, std::string("mechanism = 'disc-cam-roller'\n[constants]\nstroke = 30\nbase_radius = "
                          "20\nguide_friction = 0.6\nguide_length = 40\n") +
                  kProgram);
  const ParsedJson answer = json_of({"evaluate", path, "--json"});
  const double most = answer["responses"]["guide_fraction"]["highest"];
  const double at = answer["responses"]["guide_fraction"]["highest_at"];
  const std::string why = fmt::format(
      "friction in the guide jams the follower, guide_fraction {:.4g} at {:.4g} deg", most, at);
  CHECK(most > 1);
  for (const char* name : {"contact_force", "drive_torque", "life", "peak_stress", "torque_rms"}) {
    CHECK(answer["responses"][name]["why_undefined"] == why);
  }
  for (const char* name : {"elastic_force", "train_frequency", "guide_fraction", "undercut"}) {
    CHECK_FALSE(answer["responses"][name].contains("why_undefined"));
  }
  CHECK_THAT(done({"evaluate", path}), Contains(" more are undefined: " + why + "\n") &&
                                           Contains("friction in the guide jams the follower\n"));
}

TEST_CASE("a machine names a condition where it is impossible, and nowhere else", "[program]") {
  int found = 0;
  for (const problems::Mechanism& mechanism : problems::mechanisms()) {
    if (!mechanism.why_impossible) continue;
    const std::string& name = mechanism.name;
    std::vector<double> usual;
    for (const auto& parameter : mechanism.parameters) usual.push_back(parameter.default_value);
    for (std::size_t i = 0; i < usual.size(); ++i) {
      const problems::MechanismParameter& parameter = mechanism.parameters[i];
      for (const double bound : {parameter.low, parameter.default_value, parameter.high}) {
        std::vector<double> values = usual;
        values[i] = bound;
        INFO(name << ": " << parameter.name << " = " << bound);
        const std::string why = mechanism.why_impossible(values);
        CHECK(why.empty() == mechanism.responses.front().is_possible(values));
        if (why.empty()) continue;
        ++found;
        CHECK_THAT(why, Contains(parameter.name));  // it is about what was changed
      }
    }
  }
  CHECK(found > 30);
}

TEST_CASE("a curve without numbers says why, if that is known", "[program]") {
  const Folder folder;
  const std::string path = file_of(folder,
                                   "mechanism = 'follower-train'\nlaw.name = 'cycloidal'\n"
                                   "[constants]\nslowest_speed = 360\nfastest_speed = 240\n");
  const std::string why =
      "slowest_speed must be below fastest_speed, but they are 360 rpm and 240 rpm";
  CHECK_THAT(done({"evaluate", path}), Contains("residual_over_speed is undefined: " + why + "\n"));
  const ParsedJson answer = json_of({"evaluate", path, "--json"});
  CHECK(answer["responses"]["residual_over_speed"]["why_undefined"] == why);
  CHECK(answer["responses"]["residual_over_speed"]["highest"].is_null());
  CHECK_FALSE(answer["responses"]["deviation"].contains("why_undefined"));
}

TEST_CASE("a variable that decides on the machines of a range is judged by them", "[program]") {
  const Folder folder;
  // No base radius up to 20 mm leaves room for an offset of 30 mm beside a roller of 10 mm.
  const std::string file = file_of(
      folder, std::string("mechanism = 'disc-cam-roller'\n[constants]\nroller_radius = '10 mm'\n"
                          "[ranges.offset]\nlower = '-10 mm'\nupper = '30 mm'\n"
                          "[variables.base_radius]\nlower = '10 mm'\nupper = '60 mm'\n"
                          "[objective]\nminimize = 'base_radius'\n"
                          "[[constraints]]\nresponse = 'follower_force'\nlower = 0\n") +
                  kProgram);
  const ParsedJson found = ParsedJson::parse(run({"optimize", file, "--json"}).out);
  CHECK(found.at("verdict") == "feasible");  // the least, 20 mm, is not possible itself
  CHECK(found.at("global").is_null());
  CHECK_THAT(found.at("reason").get<std::string>(),
             Contains("offset must be less in size than base_radius + roller_radius"));
  const double radius = found.at("variables").at("base_radius").get<double>();
  CHECK(radius > 20);
  CHECK(radius < 20.01);
}

TEST_CASE("machines that are impossible in the middle of a range alone are seen", "[program]") {
  const Folder folder;
  // The second cam has no base radius at offsets about 0.
  const std::string file = file_of(
      folder,
      std::string(
          "mechanism = 'disc-cam-conjugate'\n[constants]\nstroke = '20 mm'\n"
          "roller_radius = '10 mm'\nbase_radius = '40 mm'\noffset = '14 mm'\n"
          "roller_distance = '79.9 mm'\n[ranges.offset]\nlower = '-14 mm'\n"
          "upper = '17.3 mm'\n[[constraints]]\nresponse = 'follower_force'\nlower = -1e4\n") +
          kProgram);
  const ParsedJson json = json_of({"evaluate", file, "--json"});
  const ParsedJson& limit = json.at("constraints").at(0);
  CHECK(limit.at("met") == false);
  CHECK_THAT(limit.at("why_no_value").get<std::string>(), Contains("does not exist at offset = "));
}

TEST_CASE("a search that runs into jammed followers comes back to the best that is not",
          "[program]") {
  const Folder folder;
  const std::string file =
      file_of(folder,
              "mechanism = 'disc-cam-roller'\n[constants]\nstroke = '20 mm'\noverhang = '60 mm'\n"
              "guide_friction = 0.9\n[program]\nsegments = [{angle = 100, law = 'cycloidal'}, "
              "{angle = 60}, "
              "{angle = 110, law = 'cycloidal'}, {}]\n"
              "[variables.base_radius]\nlower = '20 mm'\nupper = '200 mm'\nstart = '150 mm'\n"
              "[objective]\nminimize = 'base_radius'\n"
              "[[constraints]]\nresponse = 'contact_stress'\nupper = '1000 MPa'\n");
  const ParsedJson found = ParsedJson::parse(run({"optimize", file, "--json"}).out);
  CHECK(found.at("verdict") == "certified optimum");
  CHECK(found.at("variables").at("base_radius").get<double>() == Approx(38.81944665).epsilon(1e-6));
}

TEST_CASE("a search moves along the edge of what makes a machine", "[program][long]") {
  // roller_distance > stroke + base_radius + 2 roller_radius = 25 + 10 + 8 mm: the second cam has
  // no base radius below.
  const Folder folder;
  const std::string file = file_of(
      folder, std::string("mechanism = 'disc-cam-conjugate'\n[constants]\nstroke = '25 mm'\n"
                          "[variables]\nbase_radius = {lower = 10, upper = 80, start = 60}\n"
                          "roller_radius = {lower = 4, upper = 20}\n"
                          "roller_distance = {lower = 20, upper = 300}\n"
                          "[objective]\nminimize = 'roller_distance'\n"
                          "[[constraints]]\nresponse = 'undercut'\nupper = 0.8\n") +
                  kProgram);
  const ParsedJson found =
      ParsedJson::parse(run({"optimize", file, "--starts", "1", "--json"}).out);
  const double distance = found.at("variables").at("roller_distance").get<double>();
  CHECK(distance > 43);
  CHECK(distance < 43.001);
  CHECK(found.at("verdict") == "feasible");
  CHECK_THAT(found.at("reason").get<std::string>(),
             Contains("optimality hold at this distance from the edge"));
}

}  // namespace camlaw::cli::impossible_machines_test
