// SPDX-License-Identifier: MIT
// What a text says of worst places and of combinations, --json says too.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tests/cli/program_runner.h"
#include "tests/paths.h"

namespace camlaw::cli::told_places_test {
namespace {

std::string cam_file(const std::string& name) { return testing::source("problems/cams/") + name; }

const ParsedJson& named(const ParsedJson& list, const std::string& name) {
  for (const ParsedJson& one : list) {
    if (one.at("name") == name) return one;
  }
  FAIL("nothing is called " + name);
  return list;
}

/// "speed = 350 rpm" of such an entry of worst_at.
std::string in_words(const ParsedJson& worst_at, const std::string& name) {
  const ParsedJson& at = worst_at.at(name);
  return fmt::format("{} = {:g} {}", name, at.at("value").get<double>(),
                     at.at("unit").get<std::string>());
}

/// Of a search, certified or not.
ParsedJson answer_of(const std::string& file) {
  return ParsedJson::parse(run({"optimize", file, "--starts", "1", "--json"}).out);
}

}  // namespace

TEST_CASE("the worst place in ranges is in the JSON as in the text", "[program]") {
  const std::string file = cam_file("speed_range.toml");
  const Words design{"--set", "spring_rate=9.6347 N/mm", "--set", "base_radius=38.811 mm"};
  Words plain{"evaluate", file}, as_json{"evaluate", file, "--json"};
  plain.insert(plain.end(), design.begin(), design.end());
  as_json.insert(as_json.end(), design.begin(), design.end());
  const ParsedJson json = json_of(as_json);
  const std::string text = done(plain);
  const ParsedJson& force = named(json.at("constraints"), "follower_force");
  REQUIRE(force.at("worst_at").is_object());
  for (const char* name : {"speed", "load"}) {
    CHECK_THAT(text, Contains(in_words(force.at("worst_at"), name)));
  }
  // The force on the roller is least at the highest speed and without a load.
  CHECK(force.at("worst_at").at("speed").at("value") == 350);
  CHECK(force.at("worst_at").at("load").at("value").get<double>() == Approx(0).margin(1e-9));
  CHECK(named(json.at("constraints"), "pressure_angle").at("worst_at").is_null());

  const ParsedJson made = json_of({"evaluate", cam_file("tolerances.toml"), "--json"});
  const ParsedJson& angle = named(made.at("constraints"), "pressure_angle");
  CHECK(angle.at("worst_at").at("base_radius").at("value").get<double>() ==
        Approx(52.68 - 0.05).epsilon(1e-9));
  CHECK(angle.at("worst_at").at("base_radius").at("unit") == "mm");
}

TEST_CASE("what a proof over ranges leaves open is in the JSON as in the text", "[program]") {
  // The two signs cancel, also where both change: their bounds there do not.
  const Folder folder;
  const std::string own = folder / "own.toml";
  std::ofstream(own) << "[machine]\nmoved_by = 'law'\n"
                        "[machine.parameters.b]\ndefault = 1\nlower = -5\nupper = 5\n"
                        "[responses.f]\nformula = 'v + sign(b - 1.3) - sign(2 * b - 2.6)'\n"
                        "[law]\nname = 'cosine'\n[ranges.b]\nlower = -1\nupper = 4\n"
                        "[[constraints]]\nresponse = 'f'\nupper = 2.6\n"
                        "[[constraints]]\nresponse = 'f'\nupper = 30\n";
  const ParsedJson limits = json_of({"evaluate", own, "--json"}).at("constraints");
  CHECK(limits[0].at("met").get<bool>());
  CHECK_FALSE(limits[0].at("proved").get<bool>());
  const ParsedJson& left = limits[0].at("undecided");
  REQUIRE(left.is_object());
  const double place = left.at("from").get<double>();
  CHECK(left.at("to").get<double>() >= place);
  const ParsedJson& part = left.at("ranges").at("b");
  CHECK(part.at("lower").get<double>() <= 1.3);
  CHECK(part.at("upper").get<double>() >= 1.3);
  CHECK(part.at("unit") == "1");
  CHECK_THAT(done({"evaluate", own}),
             Contains(fmt::format("not decided: f at {:.9g}, b from ", place)));
  CHECK(limits[1].at("proved").get<bool>());
  CHECK(limits[1].at("undecided").is_null());
}

TEST_CASE("what the proof of an objective over ranges leaves open is told as that of a limit",
          "[program]") {
  // The two signs cancel, as above.
  const Folder folder;
  const std::string own = folder / "own.toml";
  std::ofstream(own) << "[machine]\nmoved_by = 'law'\n"
                        "[machine.parameters.gain]\ndefault = 1\nlower = -5\nupper = 5\n"
                        "[machine.parameters.b]\ndefault = 1\nlower = -5\nupper = 5\n"
                        "[responses.f]\n"
                        "formula = 'v + gain^2 + sign(b - 1.3) - sign(2 * b - 2.6)'\n"
                        "[law]\nname = 'cosine'\n[ranges.b]\nlower = -1\nupper = 4\n"
                        "[variables.gain]\nlower = -1\nupper = 2\n"
                        "[objective]\nminimize = 'highest f'\n";
  const ParsedJson found = answer_of(own);
  const ParsedJson& left = found.at("objective_undecided");
  REQUIRE(left.is_object());
  CHECK(left.at("to").get<double>() >= left.at("from").get<double>());
  const ParsedJson& part = left.at("ranges").at("b");
  CHECK(part.at("lower").get<double>() <= 1.3);
  CHECK(part.at("upper").get<double>() >= 1.3);
  CHECK(found.at("objective_why_not_proved").is_null());
  CHECK_THAT(run({"optimize", own}).out, Contains("not decided: highest f "));
}

/// A cam whose offset is anywhere from 0 to `most`.
std::string cam_with_offsets(const std::string& most) {
  return "mechanism = 'disc-cam-roller'\n[constants]\nmass = '1.5 kg'\nspring_rate = '8 N/mm'\n"
         "speed = '100 rpm'\nspring_preload = '120 N'\nroller_radius = '10 mm'\n"
         "[program]\nsegments = [{name = 'rise', angle = 90, law = 'modified-sine'}, "
         "{name = 'high', angle = 70}, {name = 'back', angle = 110, law = 'cycloidal'}, "
         "{name = 'low'}]\n[ranges.offset]\nlower = '0 mm'\nupper = '" +
         most +
         "'\n[[constraints]]\nresponse = 'follower_force'\nlower = '0 N'\nupper = '2000 N'\n";
}

TEST_CASE("over a range that leaves all machines possible limits are proved", "[program]") {
  const Folder folder;
  const std::string own = folder / "own.toml";
  const std::string more =
      "[[constraints]]\nresponse = 'pressure_angle'\nlower = -45\nupper = 45\n"
      "[[constraints]]\nresponse = 'wall'\nlower = '1 mm'\n";
  std::ofstream(own) << cam_with_offsets("5 mm") << more;
  const ParsedJson json = json_of({"evaluate", own, "--json"});
  CHECK(json.at("constraints").size() >= 3);
  for (const ParsedJson& limit : json.at("constraints")) {
    INFO(limit.at("name"));
    CHECK(limit.at("met") == true);
    CHECK(limit.at("proved") == true);
    CHECK(limit.at("why_not_proved").is_null());
  }
  std::ofstream(own) << cam_with_offsets("5 mm") << more
                     << "[variables.base_radius]\nlower = '20 mm'\nupper = '60 mm'\n"
                        "start = '40 mm'\n[objective]\nminimize = 'base_radius'\n";
  const ParsedJson found = answer_of(own);
  CHECK(found.at("verdict") == "certified optimum");
}

TEST_CASE("why nothing is proved over a range at whose edge no machine is possible is said",
          "[program]") {
  const Folder folder;
  const std::string own = folder / "own.toml";
  // The offset is less than the prime radius, 50 mm, by its last digit.
  const std::string cam = cam_with_offsets("49.999999999999993 mm");
  std::ofstream(own) << cam << "[variables.load]\nlower = '10 N'\nupper = '50 N'\n"
                     << "[objective]\nminimize = 'highest follower_force'\n";
  const std::string why = "the range of offset may decide whether the machine is possible";
  const ParsedJson json = json_of({"evaluate", own, "--json"});
  for (const ParsedJson& limit : json.at("constraints")) {
    INFO(limit.at("name"));
    CHECK(limit.at("proved") == false);
    CHECK(limit.at("why_not_proved") == why);
  }
  CHECK_THAT(done({"evaluate", own}), Contains("follower_force is not proved, as " + why + "\n"));
  const ParsedJson found = answer_of(own);
  CHECK(found.at("objective_why_not_proved") == why);
  CHECK(found.at("objective_undecided").is_null());
}

TEST_CASE("the objective's case and place are in the JSON as in the text", "[program]") {
  const std::string file = cam_file("load_cases.toml");
  const ParsedJson json = json_of({"optimize", file, "--json"});
  CHECK(json.at("objective_case") == "setting_up");
  CHECK(json.at("objective_worst_at").is_null());
  CHECK_THAT(done({"optimize", file}),
             Contains(fmt::format("at {:.4g} deg in case setting_up",
                                  json.at("objective_worst_angle_deg").get<double>())));

  // f is worst at an end of q, and in the case of the larger r.
  const Folder folder;
  const std::string own = folder / "own.toml";
  std::ofstream(own) << "[machine]\n[machine.parameters.p]\ndefault = 1\nlower = 0\nupper = 10\n"
                        "[machine.parameters.q]\ndefault = 1\nlower = 0\nupper = 9\n"
                        "[machine.parameters.r]\ndefault = 1\nlower = 0\nupper = 9\n"
                        "[responses.f]\nformula = 'r * (p - q)^2'\n"
                        "[ranges.q]\nlower = 1\nupper = 4\n"
                        "[[cases]]\nname = 'low'\nr = 1\n[[cases]]\nname = 'high'\nr = 3\n"
                        "[variables.p]\nlower = 0\nupper = 2\nstart = 1\n"
                        "[objective]\nminimize = 'f'\n";
  const ParsedJson found = json_of({"optimize", own, "--json"});
  CHECK(found.at("variables").at("p").get<double>() == Approx(2));
  CHECK(found.at("objective").get<double>() == Approx(12));  // 3 (2 - 4)^2
  CHECK(found.at("objective_case") == "high");
  CHECK(found.at("objective_worst_angle_deg").is_null());  // f is a number
  CHECK(found.at("objective_worst_at").at("q").at("value").get<double>() == Approx(4));
  CHECK(found.at("objective_worst_at").at("q").at("unit") == "1");
  CHECK_THAT(done({"optimize", own}), Contains("in case high, q = 4"));
  const ParsedJson& parts = found.at("objective_cases");
  REQUIRE(parts.size() == 2);
  CHECK(parts[0].at("case") == "low");
  CHECK(parts[0].at("value").get<double>() == Approx(4));
  CHECK(parts[1].at("value").get<double>() == Approx(12));
  CHECK(parts[1].at("worst_at").at("q").at("value").get<double>() == Approx(4));
}

TEST_CASE("the objective in each load case is told, of a worst case and of a mean", "[program]") {
  const std::string file = cam_file("load_cases.toml");
  const ParsedJson json = json_of({"optimize", file, "--json"});
  const ParsedJson& parts = json.at("objective_cases");
  REQUIRE(parts.size() >= 2);
  double most = 0;
  for (const ParsedJson& part : parts) {
    const double value = part.at("value");
    if (part.at("case") == json.at("objective_case")) {
      CHECK(value == Approx(json.at("objective").get<double>()).epsilon(1e-9));
      CHECK(part.at("worst_angle_deg").get<double>() ==
            Approx(json.at("objective_worst_angle_deg").get<double>()).margin(1e-4));
    }
    CHECK(part.at("unit") == json.at("objective_unit"));
    most = std::max(most, value);
  }
  CHECK(most == Approx(json.at("objective").get<double>()).epsilon(1e-9));
  CHECK_THAT(done({"optimize", file}), Contains("objective in case"));

  // The weighted mean of the parts is the objective.
  const Folder folder;
  const std::string mean = folder / "mean.toml";
  std::ofstream(mean) << "[machine]\n[machine.parameters.p]\ndefault = 1\nlower = 0\nupper = 10\n"
                         "[machine.parameters.r]\ndefault = 1\nlower = 0\nupper = 9\n"
                         "[responses.f]\nformula = 'r * (p - 4)^2'\n"
                         "[[cases]]\nname = 'low'\nr = 1\n"
                         "[[cases]]\nname = 'high'\nr = 3\nweight = 3\n"
                         "[variables.p]\nlower = 0\nupper = 2\nstart = 1\n"
                         "[objective]\nminimize = 'f'\ncases = 'mean'\n";
  const ParsedJson found = json_of({"optimize", mean, "--json"});
  CHECK(found.at("objective").get<double>() == Approx(10));  // (4 + 3 * 12) / 4
  REQUIRE(found.at("objective_cases").size() == 2);
  CHECK(found.at("objective_cases")[0].at("value").get<double>() == Approx(4));
  CHECK(found.at("objective_cases")[1].at("value").get<double>() == Approx(12));
  CHECK(found.at("objective_cases")[1].at("weight") == 3);
}

TEST_CASE("each combination of a table has its verdict and its margins", "[program]") {
  const Folder folder;
  const std::string path = folder / "laws.toml";
  std::ofstream(path) << "mechanism = 'spine-cutter'\n"
                         "[law]\nname = ['cosine', 'cycloidal', 'parabolic']\n"
                         "[variables.cam_radius]\nlower = '20 mm'\nupper = '90 mm'\n"
                         "[objective]\nminimize = 'cam_radius'\n"
                         "[[constraints]]\nresponse = 'pressure_angle'\nlower = '-50 deg'\n"
                         "upper = '50 deg'\n"
                         "[[constraints]]\nresponse = 'peak_inertia_force'\nupper = '7.5 N'\n";
  const ParsedJson table = json_of({"optimize", path, "--table", "--json"}).at("table");
  REQUIRE(table.size() == 3);
  std::size_t designs = 0;
  for (const ParsedJson& row : table) {
    const std::string law = row.at("law");
    INFO(law);
    const ParsedJson alone =
        ParsedJson::parse(run({"optimize", path, "--set", "law=" + law, "--json"}).out);
    CHECK(row.at("verdict") == alone.at("verdict"));
    if (alone.at("verdict") == "infeasible") {
      CHECK(row.at("margins").is_null());
      continue;
    }
    ++designs;
    const ParsedJson& limits = alone.at("constraints");
    REQUIRE(row.at("margins").size() == limits.size());
    // The one of two limits that is the nearer as a share of its bound.
    const double angle = row.at("margins")[0].at("margin"),
                 force = row.at("margins")[1].at("margin");
    CHECK(row.at("least_margin") == (angle / 50 < force / 7.5 ? angle : force));
    for (std::size_t i = 0; i < limits.size(); ++i) {
      const ParsedJson& margin = row.at("margins")[i];
      CHECK(margin.at("name") == limits[i].at("name"));
      CHECK(margin.at("unit") == limits[i].at("unit"));
      CHECK(margin.at("margin").get<double>() ==
            Approx(limits[i].at("margin").get<double>()).margin(1e-6));
    }
  }
  CHECK(designs > 0);
  CHECK(designs < 3);
  CHECK_THAT(run({"optimize", path, "--table"}).out,
             Contains("verdict") && Contains("certified optimum  met") &&
                 Contains("infeasible         cannot be met"));
}

TEST_CASE("a table names parts and laws as --set takes them", "[program]") {
  const Folder folder;
  std::ofstream(folder / "rollers.csv") << "name; roller_radius [mm]\n"
                                           "KR 30 PP; 15\nKR 40 PP; 20\nKR 52 PP; 26\n";
  const std::string rollers = folder / "rollers.toml", laws = folder / "laws.toml";
  std::ofstream(rollers) << "mechanism = 'disc-cam-roller'\n[constants]\nstroke = '28 mm'\n"
                            "[parts.roller]\ncatalogue = 'rollers.csv'\n"
                            "[program]\nsegments = [{name = 'up', angle = '100 deg', law = "
                            "'modified-sine'}, {name = 'dn', law = 'modified-sine'}]\n"
                            "[variables.base_radius]\nlower = '10 mm'\nupper = '100 mm'\n"
                            "[objective]\nminimize = 'outer_radius'\n"
                            "[[constraints]]\nresponse = 'pressure_angle'\n"
                            "lower = '-30 deg'\nupper = '30 deg'\n";
  std::ofstream(laws) << "mechanism = 'spine-cutter'\n"
                         "[law]\nname = ['polynomial-5 alpha=-3', 'polynomial-5 alpha=-1']\n"
                         "[variables.cam_radius]\nlower = '20 mm'\nupper = '90 mm'\n"
                         "[objective]\nminimize = 'cam_radius'\n"
                         "[[constraints]]\nresponse = 'pressure_angle'\nlower = '-50 deg'\n"
                         "upper = '50 deg'\n";
  for (const auto& [path, choice] : {std::pair{rollers, "roller"}, std::pair{laws, "law"}}) {
    const ParsedJson table = json_of({"optimize", path, "--table", "--json"}).at("table");
    REQUIRE(table.size() > 1);
    for (const ParsedJson& row : table) {
      const std::string name = row.at(choice);
      INFO(name);
      done({"evaluate", path, "--set", fmt::format("{}={}", choice, name)});
      CHECK_THAT(done({"optimize", path, "--table"}), Contains("\n" + name + "  "));
    }
  }
  // A search that begins with a row may leave it, and says so; a sweep keeps to each.
  const Words begun{"optimize", rollers, "--set", "roller=KR 52 PP"};
  CHECK_THAT(done(begun), Contains("roller = KR 52 PP is where the search begins"));
  CHECK_THAT(done({"optimize", rollers}), !Contains("where the search begins"));
  const ParsedJson table = json_of({"optimize", rollers, "--table", "--json"}).at("table");
  const ParsedJson swept =
      json_of({"sweep", rollers, "--set", "roller=KR 52 PP,KR 30 PP,KR 40 PP", "--json"});
  for (const ParsedJson& combination : swept.at("combinations")) {
    INFO(combination.at("roller"));
    const auto row = std::find_if(table.begin(), table.end(), [&](const ParsedJson& one) {
      return one.at("roller") == combination.at("roller");
    });
    REQUIRE(row != table.end());
    CHECK(combination.at("outer_radius [mm]").get<double>() ==
          Approx(row->at("objective").get<double>()).epsilon(1e-7));
  }
}

TEST_CASE("a limit that the nominal design violates is said before what varies", "[program]") {
  const auto answer = [](const std::string& bound, bool json) {
    Words words{"tolerance", cam_file("tolerances.toml"), "--samples", "64", "--set", bound};
    if (json) words.push_back("--json");
    return done(words);
  };
  const auto violated = [&](const std::string& bound) {
    return ParsedJson::parse(answer(bound, true)).at("violated_at_nominal");
  };
  // As meant the pressure angle is 29.98913 deg.
  const std::string met = "pressure_angle.upper=30 deg", broken = "pressure_angle.upper=29.9 deg";
  CHECK(violated(met).empty());
  CHECK_THAT(answer(met, false),
             !Contains("the nominal design") &&
                 Contains("the first limit to be violated is pressure_angle, at 0.5452 times"));
  CHECK(violated(broken) == ParsedJson{"pressure_angle"});
  CHECK_THAT(answer(broken, false),
             Contains("the nominal design itself violates pressure_angle by 0.0891341 deg: 'alone "
                      "violates' leaves it out\n") &&
                 Contains("the first other limit to be violated is follower_force, at 13.33 times "
                          "these variations\n") &&
                 !Contains("at 0 times"));
}

TEST_CASE("a row of a table has what tells it apart and no more", "[program]") {
  const Folder folder;
  const auto names = [&](const std::string& problem) {
    std::ofstream(folder / "p.toml") << problem;
    std::set<std::string> all;
    const ParsedJson answer = json_of({"optimize", folder / "p.toml", "--table", "--json"});
    for (const ParsedJson& row : answer.at("table")) all.insert(row.at("law"));
    return all;
  };
  using Names = std::set<std::string>;
  CHECK(names("mechanism = 'spine-cutter'\n[law]\nname = ['boundary-5', 'polynomial-5 alpha=-5', "
              "'polynomial-5', 'table', 'legendre c=-1.8,0.1', 'scca a=0.25']\n"
              "[variables.stroke]\nlower = '39 mm'\nupper = '41 mm'\n"
              "[objective]\nminimize = 'peak_inertia_force'\n") ==
        Names{"boundary-5", "polynomial-5 alpha=-3", "polynomial-5 alpha=-5", "table",
              "legendre c=-1.8,0.1", "scca a=0.25"});
  // The peak, as the table's free law of least mean squares takes 20 s.
  CHECK(names("mechanism = 'servo-axis'\n[constants]\nstroke = '90 deg'\n"
              "[program]\ncycle_time = '0.5 s'\nsegments = [\n"
              "{name = 'go', angle = '150 deg', law = ['polynomial-7 A=6', 'polynomial-7 A=7', "
              "'boundary-5']},\n{name = 'back', law = ['scca', 'modified-sine']}]\n"
              "[objective]\nminimize = 'peak_torque'\n") ==
        Names{"go=polynomial-7 back=scca go_A=6", "go=polynomial-7 back=scca go_A=7",
              "go=polynomial-7 back=modified-sine go_A=6",
              "go=polynomial-7 back=modified-sine go_A=7", "go=boundary-5 back=scca",
              "go=boundary-5 back=modified-sine"});
}

TEST_CASE("an infinite film is said with its place", "[program]") {
  const Folder folder;
  std::ofstream(folder / "p.toml")
      << "mechanism = 'disc-cam-roller'\n[constants]\nspring_preload = 0\n"
         "base_radius = '60 mm'\n[program]\nsegments = [{name = 'rise', angle = 110, law = "
         "'modified-sine'}, {name = 'high', angle = 50}, {name = 'back', angle = 120, law = "
         "'cycloidal'}, {name = 'low'}]\n"
         "[[constraints]]\nresponse = 'lambda_ratio'\nlower = 0.1\n";
  const std::string text = done({"evaluate", folder / "p.toml"});
  CHECK_THAT(text, Contains("film_thickness, lambda_ratio, crown_film and crown_lambda become "
                            "infinite: contact_force is 0 N "
                            "at 0 deg\n") &&
                       Contains("\nmet lambda_ratio = "));
  const ParsedJson all = json_of({"evaluate", folder / "p.toml", "--json"}).at("responses");
  CHECK(all.at("film_thickness").at("highest") == "inf");
  CHECK(all.at("film_thickness").at("lowest").get<double>() > 0.1);
  CHECK(all.at("film_thickness").at("why_infinite") == "contact_force is 0 N at 0 deg");
  CHECK_FALSE(all.at("contact_stress").contains("why_infinite"));
}

TEST_CASE("spreads of fewer samples than were asked for say so", "[program]") {
  const auto answer = [](const std::string& samples, bool json) {
    Words words{"tolerance", cam_file("tolerances.toml"), "--samples", samples};
    if (json) words.push_back("--json");
    return done(words);
  };
  CHECK_THAT(
      answer("2000", false),
      Contains("the rest over 1000 samples\nthese spreads take 1000 of the 2000 samples asked "
               "for: each needs a search of every limit and objective\n"));
  const ParsedJson many = ParsedJson::parse(answer("2000", true));
  CHECK(many.at("samples_asked") == 2000);
  CHECK(many.at("spread").at("samples") == 1000);
  CHECK_THAT(answer("64", false), !Contains("asked for"));
  CHECK(ParsedJson::parse(answer("64", true)).at("samples_asked") == 64);
}

}  // namespace camlaw::cli::told_places_test
