// SPDX-License-Identifier: MIT
// Problem files to begin with: every mechanism's own, and those that come with the program.
#include <regex>

#include "machines/registry.h"
#include "tests/cli/shell.h"
#include "tests/paths.h"

namespace camlaw::cli::first_file_test {
namespace {

/// The text with every optional line in use: those with '#' and no blank behind it.
std::string with_options(const std::string& text) {
  return std::regex_replace(text, std::regex("(^|\n)#(?! |\n)"), "$1");
}

Words mechanism_names() {
  Words names;
  for (const problems::Mechanism& m : problems::mechanisms()) names.push_back(m.name);
  return names;
}

void write_text(const std::string& path, const std::string& text) { std::ofstream(path) << text; }

}  // namespace

TEST_CASE("a new file of every mechanism is checked, evaluated and optimised as it is",
          "[program][heavy]") {
  const Folder folder;
  const std::string file = folder / "my.toml";
  for (const std::string& name : mechanism_names()) {
    INFO(name);
    const std::string text = done({"new", name});
    write_text(file, text);
    CHECK(done({"check", file}).size() > 100);
    CHECK(done({"evaluate", file}).size() > 100);
    const ParsedJson answer = json_of({"optimize", file, "--json"});
    INFO(answer.at("reason"));
    CHECK((answer.at("verdict") == "certified optimum" || answer.at("verdict") == "feasible"));
  }
}

TEST_CASE("the optional lines of a new file are accepted too, all at once", "[program]") {
  const Folder folder;
  const std::string file = folder / "my.toml";
  for (const std::string& name : mechanism_names()) {
    const std::string text = done({"new", name}), all = with_options(text);
    INFO(all);
    CHECK(all.size() < text.size());
    write_text(file, all);
    const Outcome outcome = run({"check", file});
    INFO(outcome.err);
    CHECK(outcome.status == 0);
  }
}

TEST_CASE("a new file ends with the few responses that are often used, and names where all are",
          "[program]") {
  for (const problems::Mechanism& m : problems::mechanisms()) {
    INFO(m.name);
    const std::string text = done({"new", m.name});
    const std::size_t begin = text.find("# Other responses");
    REQUIRE(begin != std::string::npos);
    const std::string end = text.substr(begin);
    CHECK_THAT(end, Contains("; all: camlaw mechanisms " + m.name + "\n"));
    const Words listed = lines_after(end, "#   ");
    CHECK(listed.size() >= 5);
    CHECK(listed.size() <= 6);
    for (const std::string& line : listed) {
      INFO(line);
      const std::string name = line.substr(0, line.find_first_of(",:"));
      CHECK(problems::find_response(m, name).response != nullptr);
      // What the file asks for already is not among the others.
      CHECK_THAT(text.substr(0, begin),
                 !Contains("response = \"" + name + "\"") && !Contains("mize = \"" + name + "\""));
    }
  }
}

TEST_CASE("a new file has a sentence before every number", "[program]") {
  for (const std::string& name : mechanism_names()) {
    std::istringstream lines(done({"new", name}));
    std::string before;
    bool in_constants = false;
    for (std::string line; std::getline(lines, line); before = line) {
      if (line.starts_with("[") || line.starts_with("#[")) in_constants = line == "[constants]";
      if (!in_constants || line.find(" = ") == std::string::npos || line.starts_with("# "))
        continue;
      INFO(name << ": " << line);
      CHECK(before.starts_with("# "));
      CHECK(before.ends_with("."));
    }
  }
}

TEST_CASE("mechanisms are listed with cams first, and a new file leaves what is there",
          "[program]") {
  const std::string list = done({"new"});
  CHECK(list.find("disc-cam-roller") < list.find("geneva"));
  CHECK(list.find("geneva") < list.find("spine-cutter"));
  CHECK(json_of({"new", "--json"}).size() == mechanism_names().size());
  const Folder folder;
  const std::string file = folder / "my.toml";
  CHECK_THAT(done({"new", "end-cam", "--out", file}), Contains("wrote " + file));
  CHECK(read(file) == done({"new", "end-cam"}));
  CHECK_THAT(failed({"new", "geneva", "--out", file}, 2), Contains("exists"));
  CHECK(read(file) == done({"new", "end-cam"}));
  CHECK_THAT(failed({"new", "disc-cam-rolle"}, 2), Contains("disc-cam-roller"));
  CHECK_THAT(failed({"new", "--out", folder / "x.toml"}, 2), Contains("mechanism"));
  const ParsedJson json = json_of({"new", "geneva", "--json"});
  CHECK(json.at("text") == done({"new", "geneva"}));
}

TEST_CASE("every example has a sentence, and its copy stands alone", "[program][heavy]") {
  const ParsedJson all = json_of({"examples", "--json"});
  CHECK(all.size() >= 50);
  for (const ParsedJson& example : all) {
    const auto name = example.at("name").get<std::string>();
    const auto sentence = example.at("sentence").get<std::string>();
    INFO(name << ": " << sentence);
    CHECK(sentence.size() > 10);
    CHECK((sentence.ends_with(".") || sentence.ends_with("?")));
    const Folder folder;
    const ParsedJson copied = json_of({"examples", name, "--out", folder / "copy", "--json"});
    const auto file = copied.at("written").at(0).get<std::string>();
    CHECK(fs::path(file).stem() == fs::path(name).filename());
    const Outcome outcome = run({"check", file});
    INFO(outcome.err);
    CHECK(outcome.status == 0);
  }
}

TEST_CASE("the commands in the copy of an example work where it was copied to", "[program]") {
  const ProjectFolder folder;
  fs::remove(folder / "problems");
  for (const std::string to : {"", "my torque"}) {
    const std::string option = to.empty() ? "" : " --out '" + to + "'";
    const Outcome copied = shell(folder, "camlaw examples cams/recorded_torque" + option);
    CHECK(copied.status == 0);
    const std::string file = (to.empty() ? "" : to + "/") + "recorded_torque.toml";
    const std::string text = read(folder / file);
    CHECK_THAT(text, !Contains("problems/"));
    const Words commands = lines_after(text, "#   ");
    REQUIRE_FALSE(commands.empty());
    CHECK(shell(folder, commands.front()).status == 0);
    const Words next = lines_after(copied.out, "next: ");
    REQUIRE_FALSE(next.empty());
    for (const std::string& command : next) {
      INFO(command);
      CHECK(shell(folder, command).status == 0);
    }
  }
}

TEST_CASE("an example is found by its name, brings its tables and replaces nothing", "[program]") {
  const Folder folder;
  const std::string out = folder / "mine";
  const std::string said = done({"examples", "roller_from_catalogue", "--out", out});
  CHECK_THAT(said, Contains("roller_from_catalogue.toml") && Contains("iko_c_lube"));
  CHECK(fs::exists(fs::path(out) / "iko_c_lube_cam_followers.csv"));
  CHECK(read(out + "/roller_from_catalogue.toml") ==
        read(testing::source("problems/cams/roller_from_catalogue.toml")));
  CHECK_THAT(failed({"examples", "cams/roller_from_catalogue", "--out", out}, 2),
             Contains("exists"));
  done({"examples", "problems/cams/recorded_torque.toml", "--out", folder / "torque"});
  CHECK(fs::exists(fs::path(folder / "torque") / "recorded_torque.csv"));
  CHECK_THAT(failed({"examples", "roller_least_bas"}, 2), Contains("roller_least_base"));
  CHECK_THAT(failed({"examples", "front"}, 2), Contains("die_press/front"));
}

}  // namespace camlaw::cli::first_file_test
