// SPDX-License-Identifier: MIT
#pragma once

// The built program, run as a user runs it.
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/kinematics/reference_data.h"
#include "tests/temporary_folder.h"

namespace camlaw::cli {

namespace fs = std::filesystem;
using Catch::Matchers::Contains;
using ParsedJson = nlohmann::json;
using Words = std::vector<std::string>;

using testing::Folder, testing::read;

struct Outcome {
  int status = -1;
  std::string out, err;
  double memory = 0;  ///< the most that it held, bytes
  /// What it worked, s of the processor: whatever else the machine does.
  double worked = 0;
};

/// Waits until a child has made a file: true; or has ended without it: false.
bool has_made(pid_t child, const std::string& file);

/// The program as a process of its own, its output in files of a folder that is gone afterwards.
class Running {
 public:
  explicit Running(Words words);

  pid_t id() const { return child_; }
  Outcome wait() const;

 private:
  Folder folder_;
  std::string out_ = folder_ / "out", err_ = folder_ / "err";
  pid_t child_ = 0;
};

Outcome run(Words words);

/// What a run that is done prints.
std::string done(const Words& words);
/// The same of an export that says on the error stream, and nothing else there, which limits its
/// design does not meet; words of the output.
std::string done_unmet(const Words& words);

ParsedJson json_of(const Words& words);

/// What a run that fails says: one line on standard error and nothing else.
std::string failed(const Words& words, int status);

using CsvRows = std::vector<Words>;

CsvRows csv_of(const std::string& text);

/// That a picture is one file of XML, and holds numbers only.
void check_svg(const std::string& path);

}  // namespace camlaw::cli
