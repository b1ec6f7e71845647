// SPDX-License-Identifier: MIT
// check, evaluate, optimize and the cam shape, as a user runs them.
#include <cmath>
#include <numbers>
#include <sstream>
#include <string>

#include "tests/cli/program_runner.h"
#include "tests/paths.h"

namespace camlaw::cli::optimize_test {
namespace {

std::string shipped(const std::string& name) {
  return testing::source("problems/spine_cutter/") + name;
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
  const ParsedJson result = json_of({"optimize", shipped("least_radius.toml"), "--json"});
  for (const char* key :
       {"status", "verdict", "objective", "variables", "constraints", "kkt_residual", "evaluations",
        "solver", "reason", "global", "law", "seed", "active"}) {
    INFO(key);
    CHECK(result.contains(key));
  }
  CHECK(result["verdict"] == "certified optimum");
  CHECK(result["status"] == "solved");
  const double radius = 60 / (std::numbers::pi * std::tan(std::numbers::pi / 6));
  CHECK(result["objective"].get<double>() == Approx(radius).epsilon(1e-9));
  CHECK(result["variables"]["cam_radius"].get<double>() == Approx(radius).epsilon(1e-9));
  REQUIRE(result["constraints"].size() == 1);
  const ParsedJson& limit = result["constraints"][0];
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
  CHECK(ParsedJson::parse(read(folder / "out/result.json"))["verdict"] == "certified optimum");
}

TEST_CASE("optimize ends with 3 and names the limits that contradict each other", "[program]") {
  const Folder folder;
  const Outcome outcome =
      run({"optimize", written(folder, force_and_radius("7 N", "30 mm")), "--json"});
  CHECK(outcome.status == 3);
  const ParsedJson result = ParsedJson::parse(outcome.out);
  CHECK(result["verdict"] == "infeasible");
  CHECK(result["blamed"] == ParsedJson({"peak_inertia_force", "minimum_cam_radius"}));
  // No polynomial-5 has less than 6.72 N, whatever the radius.
  const Outcome alone =
      run({"optimize", written(folder, force_and_radius("5 N", "30 mm")), "--json"});
  CHECK(ParsedJson::parse(alone.out)["blamed"] == ParsedJson({"peak_inertia_force"}));
}

TEST_CASE("an infeasible answer says what would cure it, and that it is none", "[program]") {
  const Folder folder;
  const std::string text = read(testing::source("problems/cams/roller_least_base.toml"));
  const auto with_upper = [&](const std::string& upper) {
    const std::string old = "upper = \"120 mm\"\nstart = \"60 mm\"";
    std::string own = text;
    REQUIRE(own.find(old) != std::string::npos);
    own.replace(own.find(old), old.size(), "upper = \"" + upper + "\"\nstart = \"20 mm\"");
    return written(folder, own);
  };
  const std::string file = with_upper("40 mm");
  const Outcome shown = run({"optimize", file});
  CHECK(shown.status == 3);
  // The least radius is that of the shipped problem, 52.6479 mm.
  CHECK_THAT(
      shown.out,
      Contains("easing the upper bound of base_radius by 12.65 mm\n") &&
          Contains(
              "not an answer: the design that comes nearest to the limits\nbase_radius = 40 mm") &&
          Contains("not met") && Contains("not tried"));
  const ParsedJson json = ParsedJson::parse(run({"optimize", file, "--json"}).out);
  CHECK(
      json["shown"].get<std::string>().starts_with("not an answer: the design that comes nearest"));
  const ParsedJson& cures = json["cures"];
  CHECK(cures["alone"] == true);
  bool has_bound = false;
  for (const ParsedJson& cure : cures["easings"]) {
    if (cure["name"] != "base_radius") continue;
    has_bound = true;
    CHECK(cure["is_bound"] == true);
    CHECK(cure["side"] == "upper");
    CHECK(cure["by"].get<double>() == Approx(12.6479193).epsilon(1e-6));
  }
  CHECK(has_bound);
  CHECK(run({"optimize", with_upper("52.65 mm")}).status == 0);
  CHECK(run({"optimize", with_upper("52.64 mm")}).status == 3);
}

TEST_CASE("a limit that no variable changes is cured by easing it, and the start is no answer",
          "[program]") {
  const Folder folder;
  const std::string file = testing::source("problems/cams/roller_least_base.toml");
  const Words asked{"optimize", file, "--set", "speed=900 rpm"};
  const Outcome shown = run(asked);
  CHECK(shown.status == 3);
  CHECK_THAT(shown.out, Contains("not an answer: the values at the start\n") &&
                            Contains("this would let every limit be met\n  easing the limit on "
                                     "follower_force by ") &&
                            Contains("; then [buildable] still fails: contact\n"));
  Words as_json = asked;
  as_json.push_back("--json");
  const ParsedJson json = ParsedJson::parse(run(as_json).out);
  REQUIRE(json["cures"]["easings"].size() == 1);
  CHECK(json["cures"]["easings"][0]["still_fails"] == ParsedJson({"contact"}));
  const double by = json["cures"]["easings"][0]["by"];
  const auto status_with = [&](double lower) {
    std::string text = read(file);
    const std::string old = "lower = \"0 N\"";
    REQUIRE(text.find(old) != std::string::npos);
    text.replace(text.find(old), old.size(), "lower = \"" + std::to_string(lower) + " N\"");
    const std::size_t required = text.find("require = true");  // contact would still fail
    if (required != std::string::npos) text.replace(required, 14, "require = false");
    return run({"optimize", written(folder, text), "--set", "speed=900 rpm"}).status;
  };
  CHECK(status_with(-1.001 * by) == 0);
  CHECK(status_with(-0.999 * by) == 3);
}

TEST_CASE("optimize ends with 4 where there is no answer", "[program]") {
  const Folder folder;
  const std::string path = written(folder, force_and_radius("500 N", "300 mm"));
  const Outcome outcome = run({"optimize", path, "--solver", "lbfgs"});
  CHECK(outcome.status == 4);
  CHECK_THAT(outcome.out, Contains("failed") && Contains("lbfgs"));
}

TEST_CASE("a folder that cannot be written to is found out before the search", "[program]") {
  const Folder folder;
  std::ofstream(folder / "plain") << "not a folder";
  CHECK_THAT(failed({"optimize", shipped("least_radius.toml"), "--out", folder / "plain/x"}, 1),
             Contains("cannot write") && Contains("plain/x"));
  CHECK(folder.content() == std::set<std::string>{"plain"});
}

TEST_CASE("a file that fails after the search does not take the answer with it", "[program]") {
  const Folder folder;
  fs::create_symlink("/dev/full", folder / "law.csv");
  Words words{"optimize", shipped("least_radius.toml"), "--out", folder / ""};
  const Outcome text = run(words);
  CHECK(text.status == 1);
  CHECK_THAT(text.out, Contains("certified optimum"));
  CHECK_THAT(text.err, Contains("law.csv"));
  words.push_back("--json");
  CHECK(ParsedJson::parse(run(words).out)["verdict"] == "certified optimum");
}

TEST_CASE("files of an earlier answer do not stay beside a new one", "[program]") {
  const Folder folder;
  const std::string path = written(folder, force_and_radius("500 N", "300 mm"));
  done({"optimize", path, "--out", folder / "out"});
  REQUIRE(folder.content().contains("out/cycle.svg"));
  std::ofstream(folder / "out/notes.txt") << "the user's own";
  const Outcome outcome = run({"optimize", path, "--solver", "lbfgs", "--out", folder / "out"});
  CHECK(outcome.status == 4);
  CHECK_THAT(outcome.out, Contains("removed " + (folder / "out/cycle.svg")));
  CHECK(folder.content() == std::set<std::string>{"out", "out/.camlaw.json", "out/notes.txt",
                                                  "out/result.json", "problem.toml"});
}

TEST_CASE("optimize's settings are read as the file's are", "[program]") {
  const auto refused = [](const char* option, const char* value) {
    return failed({"optimize", shipped("least_radius.toml"), option, value}, 2);
  };
  CHECK_THAT(refused("--seed", "-5"), Contains("--seed: -5 is out of range") && Contains("from 0"));
  CHECK_THAT(refused("--seed", "9223372036854775808"), Contains("to 9223372036854775807"));
  CHECK_THAT(refused("--seed", "1.5"), Contains("'1.5' is not an integer"));
  CHECK_THAT(refused("--starts", "0"), Contains("from 1 to 1000000"));
  CHECK_THAT(refused("--starts", "1000001"), Contains("from 1 to 1000000"));
  CHECK_THAT(refused("--time-limit", "nan"), Contains("--time-limit: nan"));
  CHECK_THAT(refused("--time-limit", "-1"), Contains("-1 s is not a time above zero"));
  CHECK_THAT(refused("--time-limit", "3 mm"), Contains("a time is needed"));
  CHECK_THAT(refused("--solver", "ipot"),
             Contains("did you mean ipopt") && Contains("auto, ipopt"));
  failed({"optimize", shipped("least_radius.toml"), "--json=3"}, 2);
  const ParsedJson answer =
      json_of({"optimize", shipped("least_radius.toml"), "--json", "--solver", "IPOPT",
               "--time-limit", "1 min", "--starts", "1000000", "--seed", "9223372036854775807"});
  CHECK(answer["solver_asked"] == "ipopt");
  CHECK(answer["seed"] == 9223372036854775807);
}

TEST_CASE("options of one solver are kept, and have effect where it runs", "[program][solvers]") {
  const Folder folder;
  const std::string plain = force_and_radius("30 N", "40 mm");
  const std::string own = "[solver.ipopt]\nmu_strategy = \"adaptive\"\n";
  const auto answer = [&](const std::string& text, const char* solver) {
    return json_of({"optimize", written(folder, text), "--json", "--solver", solver});
  };
  const ParsedJson adaptive = answer(plain + own, "ipopt");
  CHECK(adaptive["iterations"] != answer(plain, "ipopt")["iterations"]);
  CHECK(adaptive["objective"].get<double>() ==
        Approx(answer(plain, "ipopt")["objective"].get<double>()).epsilon(1e-6));
  CHECK(adaptive["design"]["problem"] == plain + own);
  CHECK(answer(plain + own, "slsqp")["iterations"] == answer(plain, "slsqp")["iterations"]);
  CHECK_THAT(done({"check", written(folder, plain + own)}),
             Contains("Run ipopt with mu_strategy = adaptive."));
  CHECK_THAT(failed({"optimize", written(folder, plain + "[solver.ipopt]\nmax_iter = 3\n")}, 2),
             Contains("solver.ipopt.max_iter: ipopt: option max_iter cannot be set"));
}

TEST_CASE("text tells units, sides and solvers, and no rounding", "[program]") {
  const std::string text = done({"optimize", shipped("least_force.toml"), "--solver", "direct-l"});
  CHECK_THAT(text, Contains("solver direct-l, then slsqp"));
  const std::string table = text.substr(0, text.find("optimality conditions met to"));
  CHECK_THAT(table, Contains(" deg  yes") && !Contains("e-15") && !Contains("-0 "));
}

TEST_CASE("an infeasible answer shows no prices, and tells equal limits apart", "[program]") {
  const Folder folder;
  const std::string text =
      force_and_radius("5 N", "30 mm") +
      "[[constraints]]\nresponse = \"peak_inertia_force\"\nupper = \"400 N\"\n";
  const Outcome outcome = run({"optimize", written(folder, text)});
  CHECK(outcome.status == 3);
  CHECK_THAT(outcome.out, !Contains("price") && Contains("least-violation conditions met to"));
  CHECK_THAT(outcome.out, Contains("peak_inertia_force (2)"));
}

TEST_CASE("the picture of a cycle counts in parts of a turn and names its curves", "[program]") {
  const Folder folder;
  done({"optimize", shipped("least_radius.toml"), "--out", folder / "out"});
  const std::string svg = read(folder / "out/cycle.svg");
  CHECK_THAT(svg, Contains(">60<") && Contains(">300<") && !Contains(">50<"));
  CHECK_THAT(svg, Contains(">cam_pressure_angle, deg<") && !Contains(">peak cam_pressure_angle"));
}

TEST_CASE("the same problem and seed give the same answer", "[program]") {
  const auto answer = [](const char* seed) {
    ParsedJson result =
        json_of({"optimize", shipped("least_moment.toml"), "--json", "--seed", seed});
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

TEST_CASE("check says where there is nothing to scale or to differentiate", "[program]") {
  const Folder folder;
  const std::string path = written(folder,
                                   "mechanism = 'spine-cutter'\nlaw.name = 'cosine'\n"
                                   "[variables.stroke]\nlower = 10\nupper = 20\n");
  CHECK_THAT(done({"check", path}), Contains("There is no objective"));
  for (const char* option : {"--scaling", "--derivatives"}) {
    CHECK_THAT(failed({"check", path, option}, 2), Contains(option) && Contains("there is none"));
  }
}

TEST_CASE("evaluate computes every response at the values that are set", "[program]") {
  const ParsedJson all =
      json_of({"evaluate", shipped("least_force.toml"), "--set", "alpha=0", "--json"});
  // The cubic at h = 1 mm: the paper's 4.56 N, doubled; R = 33.08 mm.
  CHECK(all["responses"]["peak_inertia_force"]["value"].get<double>() ==
        Approx(2 * 4.56).epsilon(1e-3));
  CHECK(all["responses"]["minimum_cam_radius"]["value"].get<double>() ==
        Approx(33.08).epsilon(1e-3));
  CHECK(all["constraints"][0]["met"] == true);
  CHECK_THAT(done({"evaluate", shipped("least_force.toml")}), Contains("inertia_force"));
}

TEST_CASE("evaluate does not take a pole's other side for rounding", "[program]") {
  const Folder folder;
  const std::string path = written(
      folder,
      "mechanism = 'disc-cam-roller'\n"
      "[program]\nsegments = [{name = 'rise', angle = 60, law = 'modified-sine'},"
      "{name = 'back', law = 'cycloidal'}]\n"
      "[responses]\npole = {formula = 'tan(angle / 2)'}\nrise = {formula = '1 / sin(angle)'}\n");
  std::istringstream text(done({"evaluate", path}));
  std::string row, sampled;
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with("pole ")) row = line;
    if (line.starts_with("sampled, not proved")) sampled = line;
  }
  // Its lowest was told as 0, beside 1e16.
  CHECK_THAT(row, Contains(" -"));
  CHECK_THAT(sampled, Contains("pole") && Contains("rise"));
}

TEST_CASE("evaluate tells limits from the side that was written", "[program]") {
  const std::string text = done({"evaluate", shipped("least_radius.toml")});
  // As high at both of its peaks.
  CHECK_THAT(text,
             Contains("met peak cam_pressure_angle = 27.17028 <= 30 deg (worst at 270 deg)") ||
                 Contains("met peak cam_pressure_angle = 27.17028 <= 30 deg (worst at 90 deg)"));
  const ParsedJson all = json_of({"evaluate", shipped("least_radius.toml"), "--json"});
  CHECK(all["constraints"][0]["side"] == "upper");
}

TEST_CASE("what a cam does not bear stands beside every verdict", "[program]") {
  const Folder folder;
  const std::string cam =
      "mechanism = 'disc-cam-roller'\n[constants]\nroller_radius = '40 mm'\n"
      "[program]\nsegments = [{name = 'rise', angle = 60, law = 'modified-sine'},"
      "{name = 'back', law = 'cycloidal'}]\n"
      "[variables.base_radius]\nlower = '20 mm'\nupper = '60 mm'\nstart = '20 mm'\n";
  const std::string path = written(folder, cam + "[objective]\nminimize = 'base_radius'\n");
  CHECK_THAT(done({"evaluate", path}), Contains("buildable: 0 checks hold, 1 fails, 6 are not") &&
                                           Contains("FAILS") &&
                                           Contains("the profile is undercut"));
  const auto amber = Contains(
      "certified optimum within the limits stated; cannot be built: undercut 1.131 at 52.5 deg\n");
  CHECK_THAT(done({"optimize", path, "--out", folder / "out"}), amber);
  const std::string result = folder / "out" + "/result.json";
  const ParsedJson answer = ParsedJson::parse(read(result));
  CHECK(answer["verdict"] == "certified optimum");
  const ParsedJson& built = answer["buildable"];
  CHECK((built["fails"] == 1 && built["holds"] == 0 && built["not_checked"] == 6));
  CHECK_THAT(built["summary"].get<std::string>(), Contains("cannot be built: undercut 1.131 at"));
  CHECK((built["checks"][0]["check"] == "undercut" && built["checks"][0]["answer"] == "fails"));
  CHECK(built["checks"][0]["value"].get<double>() == Approx(1.131).epsilon(1e-3));
  CHECK(built["checks"][1]["remark"] == "cutter_radius is not stated");
  CHECK_THAT(done({"verify", result}), Contains("1 fails") && Contains("the claim holds"));
  done({"report", result, "-o", folder / "page.html"});
  CHECK_THAT(read(folder / "page.html"), Contains("badge unsure") && Contains("cannot be built") &&
                                             Contains("Can it be built?"));
  CHECK_THAT(done({"export", result, "--out", folder / "cam.dxf"}), Contains("cannot be built"));
  const std::string several =
      written(folder, cam +
                          "[[objectives]]\nminimize = 'base_radius'\n"
                          "[[objectives]]\nminimize = 'peak_pressure_angle'\n");
  CHECK_THAT(done({"pareto", several, "--points", "5"}),
             Contains("cannot be built: at point") && Contains("the profile is undercut"));
  const ParsedJson front = json_of({"pareto", several, "--points", "5", "--json"});
  CHECK(front["buildable"]["points_that_fail"].get<int>() > 0);
  CHECK(front["points"][0]["buildable"]["checks"][0]["check"] == "undercut");
}

TEST_CASE("checks that are required are limits, and decide the exit status", "[program]") {
  const Folder folder;
  const std::string cam =
      "mechanism = 'disc-cam-roller'\n[constants]\nroller_radius = '40 mm'\n"
      "[program]\nsegments = [{name = 'rise', angle = 60, law = 'modified-sine'},"
      "{name = 'back', law = 'cycloidal'}]\n[objective]\nminimize = 'base_radius'\n"
      "[buildable]\nrequire = true\n[variables.base_radius]\nlower = '20 mm'\n";
  const std::string narrow = written(folder, cam + "upper = '21 mm'\n");
  CHECK_THAT(run({"optimize", narrow}).out, Contains("undercut"));
  CHECK(run({"optimize", narrow}).status == 3);
  const std::string wide = written(folder, cam + "upper = '60 mm'\n");
  const ParsedJson answer = json_of({"optimize", wide, "--json"});
  CHECK(answer["verdict"] == "certified optimum");
  CHECK(answer["constraints"][0]["name"] == "undercut");
  CHECK((answer["buildable"]["required"] == true && answer["buildable"]["fails"] == 0));
  CHECK_THAT(done({"check", wide}), Contains("undercut must be at most"));
}

TEST_CASE("a limit with a wrong unit is named by check and beside the verdict", "[program]") {
  const Folder folder;
  const std::string path =
      written(folder,
              "mechanism = 'disc-cam-roller'\n"
              "[program]\nsegments = [{name = 'rise', angle = 90, law = 'modified-sine'},"
              "{name = 'back', law = 'cycloidal'}]\n"
              "[variables.base_radius]\nlower = '50 mm'\nupper = '90 mm'\n"
              "[objective]\nminimize = 'base_radius'\n"
              "[[constraints]]\nresponse = 'pressure_angle'\nupper = '30 urad'\n"
              "[[constraints]]\nresponse = 'drive_torque'\nupper = '1 PN m'\n");
  const auto named = Contains("caution: the limit drive_torque <= 1e+15 N m is never active");
  CHECK_THAT(done({"check", path}), named);
  CHECK_THAT(run({"optimize", path}).out, named);
  CHECK_THAT(done({"evaluate", path}), named);
}

TEST_CASE("a machine that is not possible is bad input", "[program]") {
  const Words words{"evaluate", shipped("least_radius.toml"), "--set", "depth=60 mm"};
  CHECK_THAT(failed(words, 2), Contains("spine-cutter is not possible with these values") &&
                                   Contains("depth = 60 mm"));
}

TEST_CASE("check refuses what optimize refuses, and says nothing else", "[program]") {
  const Folder folder;
  const std::string head =
      "mechanism = \"spine-cutter\"\nlaw.name = \"cubic\"\n"
      "[objective]\nminimize = \"peak_inertia_force\"\n";
  std::string values = "values = [1";
  for (int i = 2; i <= 400; ++i) values.append(",").append(std::to_string(i));
  values += "]\n";
  const std::string many = "[variables.stroke]\n" + values + "[variables.mass]\n" + values;
  for (const std::string& rest : {std::string(), many}) {
    const std::string path = written(folder, head + rest);
    const std::string error = failed({"check", path}, 2);
    CHECK_THAT(error, Contains(path + ": "));
    CHECK(error == failed({"optimize", path}, 2));
  }
  CHECK_THAT(failed({"check", "/dev/zero"}, 2), Contains("/dev/zero: it is larger than 16 MiB"));
}

TEST_CASE("a bad problem file is one line with its place and what is accepted", "[program]") {
  const Folder folder;
  const std::string path = written(folder, force_and_radius("30 deg", "30 mm"));
  CHECK_THAT(failed({"check", path}, 2),
             Contains("problem.toml:") && Contains("a force is needed"));
  CHECK_THAT(failed({"optimize", folder / "nothing.toml"}, 2), Contains("nothing.toml"));
  CHECK_THAT(failed({"optimize", shipped("least_force.toml"), "--solver", "simplex"}, 2),
             Contains("simplex") && Contains("slsqp"));
  CHECK_THAT(failed({"evaluate", shipped("least_force.toml"), "--set", "alhpa=1"}, 2),
             Contains("alpha"));
  CHECK_THAT(failed({"reproduce", "spine-cutter", "--n", "10"}, 2), Contains("cam-shape"));
  CHECK_THAT(failed({"reproduce", "cam-shape", "--n", "2"}, 2), Contains("n"));
}

TEST_CASE("the cam shape of any size is certified at the true optimum", "[program]") {
  const ParsedJson shape = json_of({"reproduce", "cam-shape", "--n", "400", "--json"});
  for (const char* key :
       {"n", "printed", "objective", "true_optimum", "max_violation", "verdict", "iterations"}) {
    INFO(key);
    CHECK(shape.contains(key));
  }
  CHECK(shape["n"] == 400);
  CHECK(shape["printed"] == 4.2757);
  CHECK(shape["verdict"] == "certified optimum");
  CHECK(shape["objective"].get<double>() == Approx(4.275688479).epsilon(1e-7));
}

TEST_CASE("a limit that the file does not state says what requires it", "[program][check]") {
  const std::string file = testing::source("problems/cams/load_cases.toml");
  const ParsedJson checked = json_of({"check", file, "--json"});
  std::map<std::string, ParsedJson> by;
  for (const auto& c : checked["constraints"]) by[c["name"]] = c["required_by"];
  CHECK(by.at("undercut").is_null());
  CHECK(by.at("setting_up.follower_force").is_null());
  CHECK(by.at("setting_up.contact_force") == "peak_stress");
  CHECK_THAT(done({"check", file}),
             Contains("production.contact_force must be at least 0 N over the whole cycle, which "
                      "peak_stress requires.") &&
                 Contains("undercut must be at most 0.7 over the whole cycle.\n"));
  const std::string found = done({"optimize", file});
  CHECK_THAT(found, Contains("setting_up.contact_force is a limit because"));
  CHECK_THAT(found, !Contains("undercut is a limit because"));
}

namespace {

/// What optimize warns of, of the cam of roller_least_base.toml with other words in its file.
std::string warned(const Folder& folder,
                   const std::vector<std::pair<std::string, std::string>>& in) {
  std::string text = read(testing::source("problems/cams/roller_least_base.toml"));
  for (const auto& [from, to] : in) text.replace(text.find(from), from.size(), to);
  std::string all;
  const ParsedJson result = json_of({"optimize", written(folder, text), "--json"});
  for (const auto& warning : result["warnings"]) all += warning.get<std::string>() + "\n";
  return all;
}

}  // namespace

TEST_CASE("an objective that nothing moves is not shown as if it were sought", "[program]") {
  const Folder folder;
  CHECK_THAT(warned(folder, {{"minimize = \"base_radius\"", "minimize = \"peak acceleration\""}}),
             Contains("nothing that varies changes peak acceleration"));
  CHECK(warned(folder, {}).empty());
}

TEST_CASE("a variable that an optimum does not depend on is named", "[program]") {
  // The pressure angle decides on the base circle, whatever the spring.
  const Folder folder;
  const std::string varied = "[variables.spring_rate]\nlower = 6\nupper = 40\n\n[objective]";
  CHECK_THAT(warned(folder, {{"spring_rate = \"6 N/mm\"\n", ""}, {"[objective]", varied}}),
             Contains("is one of many values: it changes neither base_radius nor a limit"));
  // The least force is the spring's, the stroke's and the preload's: no variable is idle.
  CHECK(warned(folder, {{"spring_rate = \"6 N/mm\"\n", ""},
                        {"[objective]", varied},
                        {"minimize = \"base_radius\"", "minimize = \"peak contact_force\""}})
            .empty());
}

TEST_CASE("of a limit that no variable changes it is said what would change it", "[program]") {
  const Outcome outcome = run({"optimize", testing::source("problems/cams/roller_least_base.toml"),
                               "--set", "speed=900 rpm"});
  CHECK(outcome.status == 3);
  CHECK_THAT(
      outcome.out,
      Contains("follower_force depends on stroke, speed, mass, spring_rate, spring_preload, load "
               "and the motion where it is worst: let one of them vary, as "
               "[variables.spring_preload]") &&
          Contains("; a larger spring_rate or spring_preload, or a smaller stroke, speed or mass "
                   "helps"));
}

TEST_CASE("of limits that contradict one another it is said which constants help", "[program]") {
  // The force at a given speed grows with the angle of the rise, which is bounded.
  const Folder folder;
  const std::string file = written(
      folder,
      "mechanism = 'disc-cam-roller'\n[constants]\nstroke = 20\nspeed = 900\nmass = 1\n"
      "spring_preload = 50\n[program]\nsegments = [{name = 'rise', angle = 110, law = "
      "'modified-sine'}, {law = 'cycloidal'}]\n[variables.rise_angle]\nlower = 90\nupper = 130\n"
      "[objective]\nminimize = 'highest acceleration'\n[[constraints]]\n"
      "response = 'follower_force'\nlower = 0\n");
  const Outcome outcome = run({"optimize", file});
  CHECK(outcome.status == 3);
  CHECK_THAT(outcome.out,
             Contains("follower_force depends on constants too: a larger "
                      "spring_rate or spring_preload, or a smaller stroke, speed or mass helps"));
}

TEST_CASE("an objective that is a whole number says why the next better one is not possible",
          "[program]") {
  // n >= 3.5 by the product with the size, which is at most 2.
  const Folder folder;
  const std::string file = written(
      folder,
      "[machine]\nname = 'boxes'\n[machine.parameters.n]\ndefault = 5\n"
      "[machine.parameters.size]\ndefault = 1\n[responses.room]\nformula = 'n * size'\n"
      "[variables.n]\ntype = 'integer'\nlower = 1\nupper = 9\n[variables.size]\nlower = 0.5\n"
      "upper = 2\n[objective]\nminimize = 'n'\n[[constraints]]\nresponse = 'room'\nlower = 7\n");
  const std::string said = done({"optimize", file});
  CHECK_THAT(said, Contains("n = 4") && Contains("n = 3 is not possible: "));
}

TEST_CASE("what would change a limit at rest is what the response has a slope by there",
          "[program]") {
  // At rest and at the lowest place the force is F_0 + F_L, whatever the speed.
  const Folder folder;
  const std::string file =
      written(folder,
              "mechanism = 'disc-cam-roller'\n[constants]\nstroke = 20\nroller_radius = 10\n"
              "speed = 300\n[program]\nsegments = [{angle = 110, law = 'modified-sine'}, "
              "{angle = 50}, {angle = 120, law = 'cycloidal'}, {}]\n[variables.base_radius]\n"
              "lower = 10\nupper = 120\n[objective]\nminimize = 'base_radius'\n"
              "[[constraints]]\nresponse = 'follower_force'\nlower = 60\n");
  const Outcome outcome = run({"optimize", file});
  CHECK(outcome.status == 3);
  CHECK_THAT(outcome.out,
             Contains("follower_force depends on spring_preload and load where it is worst: let "
                      "one of them vary, as [variables.spring_preload]"));
}

TEST_CASE("a search replaces no figure that somebody made or changed", "[program]") {
  const Folder folder;
  const std::string problem = testing::source("problems/cams/roller_least_base.toml");
  const Words words{"optimize", problem, "--out", folder / "out"};
  fs::create_directory(folder / "out");
  for (const char* name : {"law.csv", "law.svg", "cycle.svg"}) {
    testing::write(folder / (std::string("out/") + name), "mine");
    CHECK_THAT(failed(words, 2),
               Contains(name) && Contains("is not in the list of files that camlaw wrote there"));
    CHECK(read(folder / (std::string("out/") + name)) == "mine");
    fs::remove(folder / (std::string("out/") + name));
  }
  done(words);
  done(words);
  testing::write(folder / "out/law.csv", read(folder / "out/law.csv") + "# mine\n");
  CHECK_THAT(failed(words, 2), Contains("out/law.csv' was changed since camlaw wrote it"));
  // A result is known by its own checksum, wherever it came from.
  fs::create_directory(folder / "copy");
  fs::copy(folder / "out/result.json", folder / "copy/result.json");
  done({"optimize", problem, "--out", folder / "copy"});
}

TEST_CASE("a fit that was taken at another size is named with its deviations", "[program]") {
  // ISO 286: h11 is 160 um above 30 to 50 mm, 190 um above 50 to 80 mm.
  const Folder folder;
  const auto with_fit = [&](const std::string& start) {
    return warned(folder,
                  {{"start = \"60 mm\"", "start = \"" + start + "\""},
                   {"[buildable]", "[variation.base_radius]\nfit = \"h11\"\n\n[buildable]"}});
  };
  CHECK_THAT(with_fit("45 mm"), Contains("was taken at its start of 45 mm, +0 and -0.16 mm") &&
                                    Contains("it is +0 and -0.19 mm"));
  CHECK(with_fit("60 mm").empty());
}

}  // namespace camlaw::cli::optimize_test
