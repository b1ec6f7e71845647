// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace camlaw::cli {

/// A file to be written.
struct OutputFile {
  std::filesystem::path path;
  std::string content;
};

/// Writes files whole or not at all: each goes to a temporary file beside its place, and only when
/// all are on the disk are they renamed into place. Missing folders are made, links followed, and
/// what is no regular file (a pipe, /dev/stdout) is written to as it is. Throws
/// std::invalid_argument where two outputs are one file, std::runtime_error naming the file and the
/// reason where one cannot be written; no temporary file and no new folder is left behind then.
void write_files(const std::vector<OutputFile>& files);

}  // namespace camlaw::cli
