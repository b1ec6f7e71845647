// SPDX-License-Identifier: MIT
// report of several results on one page, and reports as printed records, as a user runs them.
#include <cmath>

#include "numerics/text/sha256.h"
#include "output/answers/comparison_table.h"
#include "tests/cli/report_pages.h"

namespace camlaw::cli::report_test {
namespace {

/// The cells of the row of a section's table whose first cell is this, as they stand there.
Words row_of(const std::string& section, const std::string& name) {
  const std::string begin = "<tr><td>" + name + "</td>";
  const std::size_t from = section.find(begin);
  REQUIRE(from != std::string::npos);
  const std::string row = section.substr(from, section.find("</tr>", from) - from);
  Words cells;
  for (std::size_t at = row.find("<td"); at != std::string::npos; at = row.find("<td", at + 1)) {
    const std::size_t text = row.find('>', at) + 1;
    cells.push_back(row.substr(text, row.find("</td>", text) - text));
  }
  return cells;
}

/// A page about several files.
std::string page_about(Words files, const Folder& folder, int status = 0) {
  const std::string page = folder / "comparison.html";
  files.insert(files.begin(), "report");
  files.insert(files.end(), {"-o", page});
  CHECK(run(files).status == status);
  return read(page);
}

const std::string kRoller = shipped("cams/roller_least_base.toml");
const std::string kFlat = shipped("cams/flat_least_base.toml");

TEST_CASE("a comparison marks the better objective and the wider margin of each row",
          "[cli][report]") {
  const Folder folder;
  done({"optimize", kRoller, "--out", folder / "out"});
  const std::string result = folder / "out/result.json";
  const std::string page = page_about({kRoller, result}, folder);
  CHECK(page.size() < 3'000'000);
  const double radius = ParsedJson::parse(read(result))["objective"];
  const Words least = row_of(section_of(page, "answers"), "base radius, to be minimised, mm");
  REQUIRE(least.size() == 3);
  CHECK(least[1] == "60");  // the file's own
  const Words whose = row_of(section_of(page, "answers"), "numbers are");
  CHECK(whose[1] == "as the file states them, not searched");
  CHECK(whose[2] == "the result of a search");
  CHECK_THAT(least[2], Contains("badge good") && Contains(", best") &&
                           Contains(std::to_string(radius).substr(0, 7)));
  const Words verdicts = row_of(section_of(page, "answers"), "verdict");
  CHECK_THAT(verdicts[2], Contains("certified optimum, best"));
  // The larger cam keeps more of the pressure angle, which holds the smaller one.
  const Words margins = row_of(section_of(page, "limits"), "margin of pressure angle, at most");
  REQUIRE(margins.size() == 4);
  CHECK_THAT(margins[2], Contains(", best"));
  CHECK(margins[3] == "0");
  CHECK(count_of(page, "parameters-that-differ") == 0);
}

TEST_CASE("a comparison draws the shared curves of all designs and every cam's profile",
          "[cli][report]") {
  const Folder folder;
  const std::string page = page_about({kRoller, kFlat}, folder);
  const ParsedJson data = data_of(page);
  REQUIRE(data["designs"].size() == 2);
  for (const char* curve : {"displacement", "velocity", "acceleration", "jerk"}) {
    const std::size_t panel = panel_of(data, curve);
    CHECK(data["designs"][0]["lines"][panel]["y"] != data["designs"][1]["lines"][panel]["y"]);
  }
  // A flat face has no roller, and so no pressure angle of one.
  CHECK_THROWS(panel_of(data, "pressure_angle"));
  CHECK_THAT(section_of(page, "own-curves"),
             Contains("Only A has the curves") && Contains("pressure_angle"));
  const std::string profiles = section_of(page, "profiles");
  CHECK(count_of(profiles, "<path class=\"c0\"") == 1);
  CHECK(count_of(profiles, "<path class=\"c1\"") == 1);
}

TEST_CASE("a comparison says what designs of different machines do not share", "[cli][report]") {
  const Folder folder;
  const std::string page = page_about({kRoller, shipped("spine_cutter/least_radius.toml")}, folder);
  const std::string apart = section_of(page, "what-they-do-not-share");
  CHECK_THAT(apart, Contains("The machines differ (disc-cam-roller, spine-cutter)"));
  CHECK_THAT(apart, Contains("Only B has the variables alpha, cam_radius."));
  CHECK_THAT(section_of(page, "profiles"), Contains("B has no profile to draw."));
  const Words radius = row_of(section_of(page, "variables"), "cam radius");
  REQUIRE(radius.size() == 4);
  CHECK(radius[2] == kNoValue);
  CHECK(radius[3] == "40");
  CHECK(count_of(section_of(page, "answers"), "mm, best") == 0);
}

TEST_CASE("a result that was changed by hand is not the best of a comparison", "[cli][report]") {
  const Folder folder;
  done({"optimize", kRoller, "--out", folder / "out"});
  ParsedJson result = ParsedJson::parse(read(folder / "out/result.json"));
  result["objective"] = 30;
  result["design"]["variables"]["base_radius"] = 30;
  std::ofstream(folder / "changed.json") << sealed(result);
  const std::string page = page_about({folder / "changed.json", kRoller}, folder, 4);
  const std::string answers = section_of(page, "answers");
  CHECK_THAT(row_of(answers, "verdict")[1], Contains("the result is wrong"));
  CHECK(count_of(row_of(answers, "base radius, to be minimised, mm")[1], "best") == 0);
  CHECK_THAT(row_of(answers, "verdict")[2], Contains(", best"));
}

TEST_CASE("a comparison of what cannot stand side by side is refused in one line",
          "[cli][report]") {
  const Folder folder;
  const std::string page = folder / "p.html";
  CHECK(failed({"report", kRoller, kRoller, kRoller, kRoller, kRoller, "-o", page}, 2) ==
        "camlaw: a comparison takes at most 4 results, and 5 are named\n");
  CHECK_THAT(failed({"report", kRoller, folder / "study.db", "-o", page}, 2),
             Contains("study.db: a comparison needs results (.json) or problem files (.toml)"));
  CHECK_THAT(failed({"report", kRoller, kFlat, "--set", "stroke=20 mm", "-o", page}, 2),
             Contains("--set changes one design"));
  CHECK_THAT(failed({"report", kRoller, folder / "none.json", "-o", page}, 2),
             Contains("none.json"));
  CHECK(folder.content().empty());
}

TEST_CASE("a comparison without a name is written beside the first result", "[cli][report]") {
  const Folder folder;
  std::ofstream(folder / "a.toml") << read(kRoller);
  std::ofstream(folder / "b.toml") << read(kFlat);
  done({"report", folder / "a.toml", folder / "b.toml"});
  CHECK(folder.content() == std::set<std::string>{"a.toml", "b.toml", "comparison.html"});
  // Such a page is replaced as camlaw wrote it; under a name that was asked for, whatever it is.
  done({"report", folder / "a.toml", folder / "b.toml"});
  const std::string page = folder / "comparison.html", edited = read(page) + "<!-- mine -->\n";
  testing::write(page, edited);
  CHECK_THAT(failed({"report", folder / "a.toml", folder / "b.toml"}, 2),
             Contains("is not a page of camlaw, or was changed since"));
  CHECK(read(page) == edited);
  done({"report", folder / "a.toml", folder / "b.toml", "-o", page});
  CHECK(read(page) != edited);
}

TEST_CASE("the best of a row is marked only where one is better", "[cli][report]") {
  const auto texts = [](const std::vector<RowCell>& row) {
    Words all;
    for (const Cell& cell : marked(row)) all.push_back(cell.text);
    return all;
  };
  CHECK(texts({{"1", 1, -1}, {"2", 2, -2}, {}}) == Words{"1, best", "2", kNoValue});
  CHECK(texts({{"1", 1, 1}, {"1", 1, 1}}) == Words{"1", "1"});
  CHECK(texts({{"1", 1, 1}, {"2", 2, {}}}) == Words{"1", "2"});
}

TEST_CASE("a report says the checksum that sha256sum has for its file", "[cli][report]") {
  const Folder folder;
  const std::string file = folder / "cam.toml", text = read(kFlat);
  std::ofstream(file) << text;
  const std::string page = page_of(file, folder), digest = sha256(text);
  CHECK_THAT(section_of(page, "provenance"), Contains("<dt>SHA-256 of cam.toml</dt><dd>" + digest));
  // At the foot of each printed sheet, without a date.
  CHECK_THAT(page, Contains("@bottom-left { content: \"camlaw ") &&
                       Contains("cam.toml, SHA-256 " + digest.substr(0, 16)));
  CHECK_THAT(section_of(page, "provenance"), Contains("eigen ") && Contains("ipopt "));
}

TEST_CASE("a title cannot leave the style sheet that prints it", "[cli][report]") {
  const Folder folder;
  std::string text = read(kFlat);
  const std::string title = "title = ", evil = "title = '\"; } </style> body { x: \"'\n";
  const std::size_t at = text.find(title);
  text.replace(at, text.find('\n', at) + 1 - at, evil);
  std::ofstream(folder / "cam.toml") << text;
  const std::string page = page_of(folder / "cam.toml", folder);
  CHECK(count_of(page, "</style>") == 1);
  CHECK_THAT(page, Contains("content: \"\\000022;"));
}

TEST_CASE("each tile says what its number means for the design", "[cli][report]") {
  const Folder folder;
  done({"optimize", kRoller, "--out", folder / "out"});
  const std::string tiles = section_of(page_of(folder / "out/result.json", folder), "glance");
  CHECK(count_of(tiles, "<div class=\"tile ") == 4);  // the objective and three limits
  CHECK_THAT(tiles, Contains("Least radius of the profile"));
  CHECK_THAT(tiles, Contains("The design is at its upper limit of 30 deg, the nearer of the "
                             "two; easing it by 1 deg would reduce base radius by 2.95 mm."));
  CHECK_THAT(
      tiles,
      Contains("At 1 the profile is undercut; the design is 0.615 below its upper limit of"));
  // Names of people keep their spelling.
  const std::string values = section_of(page_of(folder / "out/result.json", folder), "values");
  CHECK_THAT(values, Contains("Young&apos;s modulus</td>") &&
                         Contains("Poisson&apos;s ratio</td>") && !Contains("youngs"));
}

TEST_CASE("a curve that is not defined has no place where it is highest", "[cli]") {
  std::istringstream lines(done({"evaluate", kRoller}));
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("end_deviation ") && !line.starts_with("train_force ")) continue;
    CHECK_THAT(line, Contains(" - ") && !Contains(" deg "));
    ++count;
  }
  CHECK(count == 2);
}

TEST_CASE("each constant of a law has a sentence on what it decides", "[cli][report]") {
  const Folder folder;
  const std::string rulers =
      section_of(page_of(shipped("spine_cutter/least_radius.toml"), folder), "rulers");
  for (const char* constant : {"C_v", "C_a", "C_j", "C_Mdyn"}) {
    CHECK_THAT(row_of(rulers, constant).back(), Catch::Matchers::StartsWith("It sets "));
  }
}

TEST_CASE("a report marks rises and dwells, the base circle and the sense of rotation",
          "[cli][report]") {
  const Folder folder;
  const std::string page = page_of(kRoller, folder);
  const ParsedJson spans = data_of(page)["spans"];
  REQUIRE(spans.size() == 4);  // rise 80, dwell 60, return 100, dwell 120
  const std::vector<std::pair<std::string, double>> ends{
      {"rise", 80}, {"dwell", 140}, {"return", 240}, {"dwell", 360}};
  for (std::size_t i = 0; i < ends.size(); ++i) {
    CHECK(spans[i]["kind"] == ends[i].first);
    CHECK(spans[i]["to"].get<double>() == Approx(ends[i].second));
  }
  CHECK_THAT(page, Contains("<circle class=\"base\" cx=\"0.000\" cy=\"0.000\" r=\"60.000\"/>"));
  CHECK_THAT(page, Contains("class=\"arrow\"") && Contains("class=\"head\""));
}

TEST_CASE("a report tries 0.02 mm and 0.1 deg where nobody says more", "[cli][report]") {
  const Folder folder;
  const std::string tolerances =
      section_of(page_of(shipped("cams/end_rise_share.toml"), folder), "sensitivity");
  CHECK_THAT(tolerances, Contains("by radius \u00b1 0.02 mm"));
  CHECK_THAT(tolerances, Contains("by rise angle \u00b1 0.1 deg"));
}

}  // namespace
}  // namespace camlaw::cli::report_test
