// SPDX-License-Identifier: MIT
#include "cli/files.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace camlaw::cli {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& reason) {
  throw std::runtime_error(fmt::format("cannot write '{}': {}", path.string(), reason));
}

void write_temporary(const OutputFile& file, const std::filesystem::path& temporary) {
  if (file.path.has_parent_path()) {
    std::error_code error;
    std::filesystem::create_directories(file.path.parent_path(), error);
    if (error) fail(file.path, error.message());
  }
  if (std::filesystem::is_directory(file.path)) fail(file.path, "it is a folder");
  errno = 0;
  std::ofstream stream(temporary, std::ios::binary | std::ios::trunc);
  stream << file.content;
  stream.close();
  if (!stream) fail(file.path, errno != 0 ? std::strerror(errno) : "the disk took not all of it");
}

}  // namespace

void write_files(const std::vector<OutputFile>& files) {
  std::vector<std::filesystem::path> temporaries;
  const auto clean_up = [&] {
    std::error_code ignored;
    for (const auto& path : temporaries) std::filesystem::remove(path, ignored);
  };
  try {
    for (const OutputFile& file : files) {
      std::filesystem::path temporary = file.path;
      temporary += fmt::format(".{}.tmp", getpid());
      temporaries.push_back(temporary);
      write_temporary(file, temporary);
    }
    for (std::size_t i = 0; i < files.size(); ++i) {
      std::error_code error;
      std::filesystem::rename(temporaries[i], files[i].path, error);
      if (error) fail(files[i].path, error.message());
    }
  } catch (...) {
    clean_up();
    throw;
  }
}

}  // namespace camlaw::cli
