// SPDX-License-Identifier: MIT
// Files as earlier programs wrote and read them, a folder for each time: they go on being read.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "machines/registry.h"
#include "numerics/tables/sample_table.h"
#include "numerics/text/file_format.h"
#include "output/answers/claim_output.h"
#include "problems/fronts/stored_front.h"
#include "problems/law_files/law_file.h"
#include "problems/law_files/pieces_json.h"
#include "problems/published/table/stated_table.h"
#include "problems/results/recorded_design.h"
#include "problems/statement/first_file.h"
#include "tests/paths.h"
#include "tests/temporary_folder.h"

namespace camlaw::problems::formats_test {
namespace {

namespace fs = std::filesystem;
using Catch::Contains;
using testing::Folder, testing::read, testing::write;

std::vector<fs::path> files_of(const char* kind) {
  std::vector<fs::path> files;
  for (const auto& time : fs::directory_iterator(testing::source("tests/formats"))) {
    if (!fs::is_directory(time.path() / kind)) continue;
    for (const auto& file : fs::directory_iterator(time.path() / kind)) files.push_back(file);
  }
  REQUIRE_FALSE(files.empty());
  return files;
}

TEST_CASE("problem files of earlier programs are read", "[formats]") {
  for (const fs::path& file : files_of("problems")) {
    INFO(file);
    CHECK_NOTHROW(read_problem_file(file.string()));
  }
}

TEST_CASE("results of earlier programs are read and believed", "[formats]") {
  for (const fs::path& file : files_of("results")) {
    INFO(file);
    const ReadDesign design = read_design_file(file.string());
    CHECK(design.verdict == "certified optimum");
    CHECK(cli::reviewed(design).differences.empty());
  }
}

TEST_CASE("law files of earlier programs are read", "[formats]") {
  for (const fs::path& file : files_of("laws")) {
    INFO(file);
    CHECK(read_law_file(file.string(), "law").law()(1.0, Side::Left).s == Approx(1));
  }
}

TEST_CASE("tables of samples of earlier programs are read", "[formats]") {
  for (const fs::path& file : files_of("samples")) {
    INFO(file);
    CHECK(read_samples(file.string()).columns.size() >= 2);
  }
}

TEST_CASE("studies of earlier programs are read, their records whole", "[formats]") {
  for (const fs::path& file : files_of("studies")) {
    INFO(file);
    const Folder folder;  // what SQLite puts beside it is not to stay
    fs::copy_file(file, folder / "study.db");
    optim::StudyRecord record = optim::StudyRecord::read(folder / "study.db");
    const StoredFront stored = stored_front(FrontStudy::of(record), record);
    CHECK(stored.faults.empty());
    CHECK(stored.front.points.size() >= 6);
  }
}

TEST_CASE("a file states its format, and a newer one is refused in a sentence", "[formats]") {
  CHECK(kLawFormat.text() == "camlaw law 1");
  CHECK_NOTHROW(kLawFormat.check("camlaw law 1"));
  CHECK_THROWS_WITH(kLawFormat.check("camlaw law 2"),
                    "its format, 'camlaw law 2', is newer than this program, which reads up to "
                    "'camlaw law 1'");
  for (const char* other :
       {"", "camlaw", "camlaw law", "camlaw law ", "camlaw law x", "camlaw law 0", "camlaw law -1",
        "camlaw law 1.5", "camlaw lawn 1", "camlaw result 1"}) {
    INFO(other);
    CHECK_THROWS_WITH(kLawFormat.check(other), Contains("it must be 'camlaw law 1'"));
  }
}

TEST_CASE("each reader refuses what a newer program wrote", "[formats]") {
  const Folder folder;
  const std::string problem = read(files_of("problems").front());
  CHECK_NOTHROW(read_problem("format = \"camlaw problem 1\"\n" + problem, "p.toml"));
  CHECK_THROWS_WITH(read_problem("format = \"camlaw problem 2\"\n" + problem, "p.toml"),
                    Contains("p.toml:1: format: ") && Contains("is newer than this program"));

  auto result = nlohmann::ordered_json::parse(read(files_of("results").front()));
  for (const char* other : {"camlaw front 1", "camlaw fit 1", "camlaw evaluation 1"}) {
    write(folder / "other.json", nlohmann::json{{"format", other}}.dump());
    CHECK_THROWS_WITH(read_design_file(folder / "other.json"),
                      Contains(other) && Contains("it must be 'camlaw result 1'"));
  }
  result["format"] = "camlaw result 2";
  write(folder / "result.json", result.dump());
  CHECK_THROWS_WITH(read_design_file(folder / "result.json"),
                    Contains("is newer than this program"));

  auto law = nlohmann::ordered_json::parse(read(files_of("laws").front()));
  law["format"] = "camlaw law 2";
  write(folder / "law.json", law.dump());
  CHECK_THROWS_WITH(read_law_file(folder / "law.json", "law"),
                    Contains("is newer than this program"));

  const std::string table = "format = \"camlaw table 2\"\n";
  CHECK_THROWS_WITH(read_stated_table(table, "t.toml"),
                    Contains("t.toml:1: format: ") && Contains("is newer than this program"));
}

TEST_CASE("a study that a newer program wrote is refused in a sentence", "[formats]") {
  constexpr std::size_t kUserVersion = 60;  // its four bytes, most significant first (SQLite)
  const Folder folder;
  std::string study = read(files_of("studies").front());
  study[kUserVersion + 3] = 99;
  write(folder / "study.db", study);
  CHECK_THROWS_WITH(optim::StudyRecord::read(folder / "study.db"),
                    Contains("its tables are of version 99; this program, which is older, "));
}

std::string format_in(std::string_view toml) {
  const std::size_t at = toml.find("\nformat = ");
  if (at == std::string_view::npos) return "none";
  const std::size_t begin = at + std::string_view("\nformat = ").size();
  return std::string(toml.substr(begin, toml.find('\n', begin) - begin));
}

TEST_CASE("every problem file that is shipped or written states its format", "[formats]") {
  for (const auto& file : fs::recursive_directory_iterator(testing::source("problems"))) {
    if (file.path().extension() != ".toml") continue;
    INFO(file.path());
    const bool is_table = file.path().parent_path().filename() == "published";
    CHECK(format_in("\n" + read(file.path())) ==
          (is_table ? "\"camlaw table 1\"" : "\"camlaw problem 1\""));
  }
  for (const Mechanism& mechanism : mechanisms()) {
    INFO(mechanism.name);
    CHECK(format_in(first_file(mechanism)) == "\"camlaw problem 1\"");
  }
}

}  // namespace
}  // namespace camlaw::problems::formats_test
