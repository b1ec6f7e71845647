// SPDX-License-Identifier: MIT
// An answer is one document: what a command prints for people and what --json gives say the same.
#include <cmath>
#include <fstream>
#include <regex>
#include <sstream>

#include "tests/cli/program_runner.h"
#include "tests/paths.h"

namespace camlaw::cli::answers_test {
namespace {

const std::string kCam = testing::source("problems/cams/roller_least_base.toml");
const std::string kFront = testing::source("problems/spine_cutter/front.toml");

/// A number as people read it, and what rounding it may have cost.
struct Shown {
  std::string text;
  double value, rounding;
};

/// The numbers of a text; of "1.23e-05" half of the last digit is 5e-8.
std::vector<Shown> numbers_of(const std::string& text) {
  static const std::regex number("-?[0-9]+(\\.[0-9]+)?(e[+-]?[0-9]+)?");
  std::vector<Shown> all;
  for (std::sregex_iterator i(text.begin(), text.end(), number), end; i != end; ++i) {
    const std::string& decimals = (*i)[1].str();
    const double value = std::stod(i->str());
    const std::string power = (*i)[2];
    const double places = decimals.empty() ? 0 : static_cast<double>(decimals.size()) - 1;
    const double exponent = power.empty() ? 0 : std::stod(power.substr(1));
    all.push_back({i->str(), value, 0.5 * std::pow(10, exponent - places)});
  }
  return all;
}

/// Every number that programs find: as such, within words, as a list's length, and as the width of
/// an interval.
void collect(const ParsedJson& json, std::vector<double>& numbers) {
  if (json.is_number()) numbers.push_back(json.get<double>());
  if (json.is_string()) {
    for (const Shown& shown : numbers_of(json.get<std::string>())) numbers.push_back(shown.value);
  }
  if (json.is_array()) numbers.push_back(static_cast<double>(json.size()));
  if (json.is_array() && json.size() == 2 && json[0].is_number() && json[1].is_number()) {
    numbers.push_back(json[1].get<double>() - json[0].get<double>());
  }
  if (json.is_structured()) {
    for (const auto& [key, value] : json.items()) {
      if (json.is_object()) collect(ParsedJson(key), numbers);
      collect(value, numbers);
    }
  }
}

/// That a command's --json is JSON, and has every number that it prints without. `room` is for
/// numbers that are not rounded to the nearest.
void check_same_numbers(const Words& words, double room = 0) {
  std::string line;
  for (const std::string& word : words) line += " " + word;
  INFO("camlaw" << line);
  Words as_json = words;
  as_json.emplace_back("--json");
  std::vector<double> numbers;
  collect(json_of(as_json), numbers);
  Words quiet = words;
  if (words.front() != "export") quiet.emplace_back("--quiet");  // there it says nothing else
  std::string text = done(quiet);
  text.erase(std::min(text.find("\nwrote "), text.size()));
  REQUIRE_FALSE(numbers_of(text).empty());
  for (const Shown& shown : numbers_of(text)) {
    INFO(shown.text);
    CHECK(std::any_of(numbers.begin(), numbers.end(), [&](double value) {
      // Signs may be hyphens of a name.
      const double off = std::min(std::abs(value - shown.value), std::abs(value + shown.value));
      return off <= shown.rounding * (1 + 1e-9) + (room + 1e-14) * std::abs(value);
    }));
  }
}

}  // namespace

TEST_CASE("what is printed of laws and mechanisms is in their JSON", "[program]") {
  check_same_numbers({"laws"});
  check_same_numbers({"law", "modified-sine crossover=0.4"});
  check_same_numbers({"law", "fourier", "--param", "a=0.1,-0.05"});
  check_same_numbers({"law", "parabolic"});
  check_same_numbers({"mechanisms", "disc-cam-knife-edge"});
  check_same_numbers({"mechanisms", "die-press", "--formula", "running_stress"});
}

TEST_CASE("what check, evaluate, verify and export print is in their JSON", "[program]") {
  const Folder folder;
  check_same_numbers({"check", kCam, "--derivatives", "--scaling"});
  check_same_numbers({"check", kFront, "--derivatives"});
  check_same_numbers({"evaluate", kCam});
  const std::string result = folder / "result.json";
  std::ofstream(result) << done({"optimize", kCam, "--json"});
  check_same_numbers({"verify", result});
  for (const char* ending : {"dxf", "csv", "nc"}) {
    // Deviations are rounded up.
    check_same_numbers({"export", result, "--out", folder / "cam." + ending}, 2e-3);
  }
}

TEST_CASE("what front, study and fit print is in their JSON", "[program]") {
  const Folder folder;
  const std::string study = folder / "study.db";
  done({"pareto", kFront, "--points", "4", "--db", study});
  check_same_numbers({"front", study, "--knee"});
  check_same_numbers({"study", "sheet-delivery"});
  check_same_numbers({"fit", "--constants", "B=1.6125, C=4.66"});
}

/// The lines of a text that begin with these words.
std::vector<std::string> lines_with(const std::string& text, const std::string& words) {
  std::vector<std::string> found;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(words)) found.push_back(line);
  }
  return found;
}

TEST_CASE("evaluate shows both sides of a limit with two bounds, each with its margin",
          "[program]") {
  const ParsedJson said = json_of({"evaluate", kCam, "--json"});
  CHECK(said["format"] == "camlaw evaluation 1");
  const ParsedJson& angle = said["responses"]["pressure_angle"];
  const ParsedJson& limit = said["constraints"][0];
  const double to_lower = angle["lowest"].get<double>() + 40;
  const double to_upper = 30 - angle["highest"].get<double>();
  const bool is_upper = to_upper < to_lower;
  CHECK(limit["side"] == (is_upper ? "upper" : "lower"));
  CHECK(limit["other_side"]["side"] == (is_upper ? "lower" : "upper"));
  CHECK(limit["margin"].get<double>() == Approx(std::min(to_lower, to_upper)).epsilon(1e-9));
  CHECK(limit["other_side"]["margin"].get<double>() ==
        Approx(std::max(to_lower, to_upper)).epsilon(1e-9));
  CHECK(said["constraints"][1]["other_side"].is_null());  // it has an upper bound alone
  const auto lines = lines_with(done({"evaluate", kCam}), "met pressure_angle");
  REQUIRE(lines.size() == 2);
  CHECK_THAT(lines[0], Contains(is_upper ? "<= 30 deg" : ">= -40 deg") && Contains(", critical"));
  CHECK_THAT(lines[1], Contains(is_upper ? ">= -40 deg" : "<= 30 deg") && Contains(", other"));
}

TEST_CASE("optimize's table has a row for each side and says which is critical", "[program]") {
  const Folder folder;
  const std::string lines =
      "mechanism = 'spine-cutter'\n[law]\nname = 'modified-sine'\n[variables.cam_radius]\n"
      "lower = '10 mm'\nupper = '100 mm'\nstart = '50 mm'\n[objective]\n"
      "minimize = 'cam_radius'\n[[constraints]]\n"
      "response = 'cam_pressure_angle'\nupper = '30 deg'\n";
  const auto rows = [&](const std::string& lower) {
    std::ofstream(folder / "p.toml") << lines << lower;
    return lines_with(done({"optimize", folder / "p.toml"}), "cam_pressure_angle ");
  };
  const auto two = rows("lower = '-35 deg'\n");
  REQUIRE(two.size() == 2);
  CHECK_THAT(two[0], Contains("<= 30") && Contains(" critical "));
  CHECK_THAT(two[1], Contains(">= -35") && Contains(" 5 ") && Contains(" other "));
  const auto even = rows("lower = '-30 deg'\n");
  REQUIRE(even.size() == 2);
  CHECK_THAT(even[0] + even[1], Contains(">= -30") && Contains("<= 30"));
  CHECK_THAT(even[0], Contains(" both "));
  const auto one = rows("");
  REQUIRE(one.size() == 1);
  CHECK_THAT(one[0], !Contains("critical"));
}

TEST_CASE("what only rounding leaves is not printed as a number", "[program]") {
  const Folder folder;
  std::ofstream(folder / "law.toml") << done({"new", "law"});
  const std::string file = folder / "law.toml";
  const std::string text = done({"evaluate", file});
  // The law is symmetric about its middle: with a whole period ratio one part vanishes.
  CHECK(std::regex_search(text, std::regex("\nresidual_cosine +0 +1 ")));
  CHECK_THAT(text, !Contains("e-1"));
  CHECK(json_of({"evaluate", file, "--json"})["responses"]["residual_cosine"]["value"] == 0);
  // Only the law is chosen: no number was varied.
  CHECK_THAT(done({"optimize", testing::source("problems/spine_cutter/all_laws.toml")}),
             !Contains("conditions met to"));
  CHECK_THAT(done({"optimize", testing::source("problems/motions/through_points.toml")}),
             Contains("optimality conditions met to rounding;"));
}

TEST_CASE("check tells programs what it understood", "[program]") {
  const ParsedJson plain = json_of({"check", kCam, "--json"});
  CHECK(plain["mechanism"] == "disc-cam-roller");
  CHECK(plain["variables"][0]["name"] == "base_radius");
  CHECK(plain["variables"][0]["upper"] == 120);
  CHECK(plain["objectives"] ==
        ParsedJson{{{"name", "base_radius"}, {"unit", "mm"}, {"sense", "minimize"}}});
  CHECK(plain["constraints"][0]["lower"] == -40);
  CHECK(plain["constraints"][1]["lower"].is_null());
  CHECK(plain["shapes"][0]["depends_on"] == ParsedJson{{"base_radius", "linear"}});
  CHECK(plain["warnings"].empty());
  CHECK_FALSE(plain.contains("scaling"));
  CHECK_FALSE(plain.contains("agrees"));
  const ParsedJson front = json_of({"check", kFront, "--derivatives", "--scaling", "--json"});
  REQUIRE(front["derivatives"].size() == 2);
  CHECK(front["derivatives"][1]["of"] == "peak_inertia_force");
  CHECK(front["derivatives"][1]["worst"]["variable"] == "alpha");
  CHECK(front["scaling"][0]["of"] == "alpha");
  CHECK(front["agrees"] == true);
}

TEST_CASE("the list of laws is a table for spreadsheets too", "[program]") {
  const Folder folder;
  const std::string csv = folder / "laws.csv";
  CHECK_THAT(done({"laws", "--csv", csv}), Contains("wrote " + csv));
  const CsvRows rows = csv_of(read(csv));
  const ParsedJson laws = json_of({"laws", "--json"});
  REQUIRE(rows.size() == laws.size() + 1);
  for (std::size_t k = 0; k < laws.size(); ++k) {
    for (std::size_t i = 0; i < rows[0].size(); ++i) {
      const ParsedJson& value = laws[k].at(rows[0][i]);
      INFO(rows[k + 1][0] << " " << rows[0][i]);
      if (value.is_number()) CHECK(std::stod(rows[k + 1][i]) == value.get<double>());
    }
  }
  failed({"laws", "--csv", csv, "--markdown"}, 2);
}

TEST_CASE("export tells programs what it wrote, where that went to a file", "[program]") {
  const Folder folder;
  const std::string dxf = folder / "cam.dxf";
  const ParsedJson said = json_of({"export", kCam, "--out", dxf, "--json"});
  CHECK(fs::exists(dxf));
  REQUIRE(said["curves"].size() == 3);
  CHECK(said["curves"][0]["name"] == "profile");
  CHECK(said["curves"][0]["pieces"] == "cubics");
  CHECK(said["curves"][0]["worst_deviation_mm"] <= said["curves"][0]["tolerance_mm"]);
  CHECK(said["provenance"]["file"] == "roller_least_base.toml");
  CHECK_THAT(failed({"export", kCam, "--format", "dxf", "--json"}, 2), Contains("--out"));
}

}  // namespace camlaw::cli::answers_test
