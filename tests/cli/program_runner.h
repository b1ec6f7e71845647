// SPDX-License-Identifier: MIT
#pragma once

// The built program, run as a user runs it. CAMLAW_PROGRAM is its path.
#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <boost/property_tree/xml_parser.hpp>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "tests/kinematics/reference_data.h"
#include "tests/temporary_folder.h"

namespace camlaw::cli {

namespace fs = std::filesystem;
using Catch::Matchers::Contains;
using Json = nlohmann::json;
using Words = std::vector<std::string>;

using testing::Folder, testing::read;

struct Outcome {
  int status = -1;
  std::string out, err;
  double memory = 0;  ///< the most that it held, bytes
};

/// The program as a process of its own, its output in files of a folder that is gone afterwards.
class Running {
 public:
  explicit Running(Words words) {
    words.insert(words.begin(), "camlaw");
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    const int flags = O_WRONLY | O_CREAT | O_TRUNC;
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out_.c_str(), flags, 0600);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err_.c_str(), flags, 0600);
    const int failed =
        posix_spawn(&child_, CAMLAW_PROGRAM, &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (failed != 0) throw std::runtime_error("cannot start " CAMLAW_PROGRAM);
  }

  pid_t id() const { return child_; }
  Outcome wait() const {
    int status = 0;
    rusage used{};
    wait4(child_, &status, 0, &used);
    constexpr double kKibibyte = 1024;
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read(out_), read(err_),
            kKibibyte * static_cast<double>(used.ru_maxrss)};
  }

 private:
  Folder folder_;
  std::string out_ = folder_ / "out", err_ = folder_ / "err";
  pid_t child_ = 0;
};

inline Outcome run(Words words) { return Running(std::move(words)).wait(); }

/// What a run that is done prints.
inline std::string done(const Words& words) {
  const Outcome outcome = run(words);
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  CHECK(outcome.err.empty());
  return outcome.out;
}

inline Json json_of(const Words& words) { return Json::parse(done(words)); }

/// What a run that fails says: one line on standard error and nothing else.
inline std::string failed(const Words& words, int status) {
  const Outcome outcome = run(words);
  INFO(outcome.err);
  CHECK(outcome.status == status);
  CHECK(outcome.out.empty());
  CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  CHECK((outcome.err.size() > 1 && outcome.err.back() == '\n'));
  return outcome.err;
}

using Table = std::vector<Words>;

inline Table csv_of(const std::string& text) {
  Table rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    rows.push_back(testing::split_fields(line));
  }
  return rows;
}

inline void check_svg(const std::string& path) {
  INFO(path);
  boost::property_tree::ptree tree;
  REQUIRE_NOTHROW(boost::property_tree::read_xml(path, tree));
  CHECK(tree.count("svg") == 1);
  CHECK(read(path).find("nan") == std::string::npos);
}

}  // namespace camlaw::cli
