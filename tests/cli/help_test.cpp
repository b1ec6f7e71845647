// SPDX-License-Identifier: MIT
#include <regex>

#include "tests/cli/command_help.h"
#include "tests/cli/shell.h"
#include "tests/paths.h"

namespace camlaw::cli::help_test {
namespace {

/// The words of a command line, as a shell reads them.
Words words_of(const Folder& folder, const std::string& line) {
  return lines_after(shell(folder, "printf '%s\\n' " + line).out, "");
}

/// What bash offers behind these words, the last of them unfinished.
std::set<std::string> offers(const Folder& folder, const Words& words) {
  std::string line = "source <(camlaw completion bash)\nCOMP_WORDS=(";
  for (const std::string& word : words) line += "'" + word + "' ";
  line += ")\nCOMP_CWORD=" + std::to_string(words.size() - 1) +
          "\n_camlaw\nprintf '%s\\n' \"${COMPREPLY[@]}\"";
  const Outcome outcome = shell(folder, line);
  CHECK(outcome.err.empty());
  const Words lines = lines_after(outcome.out, "");
  return {lines.begin(), lines.end()};
}

}  // namespace

TEST_CASE("every command has examples in its help, and they work", "[documents][heavy]") {
  const ProjectFolder folder;
  const Words all = commands();
  CHECK(all.size() >= 13);
  for (const std::string& command : all) {
    const auto examples = lines_after(done({command, "--help"}), "  camlaw ");
    INFO(command);
    CHECK_FALSE(examples.empty());
    for (const std::string& example : examples) {
      INFO(example);
      const Outcome outcome = shell(folder, "camlaw " + example);
      INFO(outcome.err);
      CHECK(outcome.status == 0);
    }
  }
}

TEST_CASE("help is a word as well as an option", "[documents]") {
  CHECK(done({"help"}) == done({"--help"}));
  CHECK(done({"help", "fit"}) == done({"fit", "--help"}));
  const Folder folder;
  const Outcome unknown = shell(folder, "camlaw help fitt");
  CHECK(unknown.status == 2);
  CHECK_THAT(unknown.err, Contains("there is no command 'fitt'") && Contains("fit"));
}

TEST_CASE("-o is short for --out in every command", "[documents]") {
  for (const std::string& command : commands()) {
    for (const OptionHelp& option : options_of(command)) {
      if (option.name != "--out") continue;
      INFO(command);
      CHECK_THAT(done({command, "--help"}), Contains("  -o,--out "));
    }
  }
}

TEST_CASE("the help of options shows what they take and do, nothing of the parser", "[documents]") {
  for (const std::string& command : commands()) {
    INFO(command);
    const std::string help = done({command, "--help"});
    CHECK_THAT(help, !Contains("Excludes") && !Contains("Needs:") && !Contains("REQUIRED") &&
                         !Contains("FILE FILE"));
  }
  CHECK(std::regex_search(done({"laws", "--help"}), std::regex("\n  --json +print JSON\n")));
}

TEST_CASE("the README names every command", "[documents]") {
  const std::string page = read(testing::source("README.md"));
  for (const std::string& command : commands()) {
    CHECK_THAT(page, Contains("camlaw " + command));
  }
}

TEST_CASE("what the README says to try has commands, options and files that exist", "[documents]") {
  const Folder folder;
  const auto lines = lines_after(read(testing::source("README.md")), "    ./run ");
  CHECK(lines.size() >= 15);
  for (const std::string& line : lines) {
    INFO(line);
    if (line.starts_with(" ") || line.starts_with("ARGS")) continue;  // what ./run is
    const Words words = words_of(folder, line);
    const std::string help = done({words.front(), "--help"});
    for (const std::string& word : words) {
      if (word.starts_with("--")) CHECK_THAT(help, Contains(word));
      if (word.starts_with("problems/")) CHECK(fs::exists(testing::source(word)));
    }
  }
}

TEST_CASE("the version names the program and the libraries behind it with their versions",
          "[program]") {
  const std::string text = done({"--version"});
  CHECK(text.starts_with("camlaw 0.1.0\n"));
  for (const char* library : {"ipopt", "nlopt", "ceres", "pagmo", "sqlite", "eigen", "boost"}) {
    INFO(library);
    CHECK(std::regex_search(text, std::regex(std::string("\n") + library + R"( \d+\.\d+\.\d+)")));
  }
}

TEST_CASE("bash completes commands, options, names and words", "[program]") {
  const Folder folder;
  using Set = std::set<std::string>;
  CHECK(offers(folder, {"camlaw", "opt"}) == Set{"optimize"});
  CHECK(offers(folder, {"camlaw", "law", "modified-si"}).contains("modified-sine"));
  CHECK(offers(folder, {"camlaw", "law", "cubic", "--sa"}) == Set{"--samples"});
  CHECK(offers(folder, {"camlaw", "pareto", "x.toml", "--method", "s"}) == Set{"sweep"});
  CHECK(offers(folder, {"camlaw", "fit", "x.csv", "--shift", ""}) ==
        Set{"centre", "abscissa", "value"});
  CHECK(offers(folder, {"camlaw", "mechanisms", "geneva-"}) == Set{"geneva-spherical"});
  CHECK(offers(folder, {"camlaw", "optimize", "--solver", "ip"}) == Set{"ipopt"});
  CHECK(offers(folder, {"camlaw", "reproduce", "spine"}) == Set{"spine-cutter"});
  std::ofstream(folder / "some problem.toml") << "";
  CHECK(offers(folder, {"camlaw", "check", "some"}) == Set{"some problem.toml"});
}

TEST_CASE("scripts of all shells and the manual page have every command and option", "[program]") {
  const std::string man = done({"man"});
  CHECK_THAT(man, Contains(".TH CAMLAW 1") && Contains(".SH EXIT STATUS"));
  const std::string zsh = done({"completion", "zsh"}), fish = done({"completion", "fish"});
  for (const std::string& command : commands()) {
    INFO(command);
    CHECK_THAT(man, Contains(".SS camlaw " + command + "\n"));
    CHECK_THAT(zsh, Contains("    " + command + ")\n"));
    CHECK_THAT(fish, Contains("__fish_use_subcommand -a " + command + " "));
  }
  CHECK_THAT(man, Contains("\\-\\-time\\-limit TIME"));
  CHECK_THAT(zsh, Contains("--time-limit["));
  CHECK_THAT(fish, Contains("-l time-limit -x"));
  CHECK_THAT(failed({"completion", "tcsh"}, 2), Contains("tcsh") && Contains("fish"));
}

TEST_CASE("a quiet run leaves out what was not asked for, and keeps the answer", "[program]") {
  const Folder folder;
  const std::string csv = folder / "cubic.csv";
  const std::string said = done({"law", "cubic", "--csv", csv});
  CHECK_THAT(said, Contains("wrote " + csv));
  fs::remove(csv);
  for (const Words& words : {Words{"law", "cubic", "--csv", csv, "--quiet"},
                             Words{"-q", "law", "cubic", "--csv", csv}}) {
    const std::string text = done(words);
    CHECK(text + "wrote " + csv + "\n" == said);
    CHECK(fs::remove(csv));
  }
}

}  // namespace camlaw::cli::help_test
