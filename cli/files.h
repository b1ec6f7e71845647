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
/// all are on the disk are they renamed into place. Makes missing folders. Throws std::runtime_error
/// naming the file and the reason; no temporary file is left behind then.
void write_files(const std::vector<OutputFile>& files);

}  // namespace camlaw::cli
