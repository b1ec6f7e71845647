// SPDX-License-Identifier: MIT
#include "tests/cli/program_runner.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>

#include <boost/property_tree/xml_parser.hpp>
#include <chrono>
#include <stdexcept>
#include <thread>

namespace camlaw::cli {

bool has_made(pid_t child, const std::string& file) {
  while (!fs::exists(file)) {
    siginfo_t ended{};
    const bool is_child =
        waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOHANG | WNOWAIT) == 0;
    if (!is_child || ended.si_pid != 0) return fs::exists(file);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

Running::Running(Words words) {
  words.insert(words.begin(), "camlaw");
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  const int flags = O_WRONLY | O_CREAT | O_TRUNC;
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out_.c_str(), flags, 0600);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err_.c_str(), flags, 0600);
  const int failed = posix_spawn(&child_, testing::program().c_str(), &actions, nullptr,
                                 arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) throw std::runtime_error("cannot start " + testing::program());
}

Outcome Running::wait() const {
  int status = 0;
  rusage used{};
  wait4(child_, &status, 0, &used);
  constexpr double kKibibyte = 1024;
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read(out_), read(err_),
          kKibibyte * static_cast<double>(used.ru_maxrss),
          seconds(used.ru_utime) + seconds(used.ru_stime)};
}

Outcome run(Words words) { return Running(std::move(words)).wait(); }

std::string done(const Words& words) {
  const Outcome outcome = run(words);
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  CHECK(outcome.err.empty());
  return outcome.out;
}

std::string done_unmet(const Words& words) {
  const Outcome outcome = run(words);
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  CHECK_FALSE(outcome.err.empty());
  std::istringstream said(outcome.err);
  for (std::string line; std::getline(said, line);) CHECK_THAT(line, Contains(": limit not met: "));
  return outcome.out;
}

ParsedJson json_of(const Words& words) { return ParsedJson::parse(done(words)); }

std::string failed(const Words& words, int status) {
  const Outcome outcome = run(words);
  INFO(outcome.err);
  CHECK(outcome.status == status);
  CHECK(outcome.out.empty());
  CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  CHECK((outcome.err.size() > 1 && outcome.err.back() == '\n'));
  return outcome.err;
}

CsvRows csv_of(const std::string& text) {
  CsvRows rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    rows.push_back(testing::split_fields(line));
  }
  return rows;
}

void check_svg(const std::string& path) {
  INFO(path);
  boost::property_tree::ptree tree;
  REQUIRE_NOTHROW(boost::property_tree::read_xml(path, tree));
  CHECK(tree.count("svg") == 1);
  CHECK(read(path).find("nan") == std::string::npos);
}

}  // namespace camlaw::cli
