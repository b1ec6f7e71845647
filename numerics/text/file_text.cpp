// SPDX-License-Identifier: MIT
#include "numerics/text/file_text.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>

namespace camlaw::problems {
namespace {

/// More than any such file has; what is longer is something else, such as /dev/zero.
constexpr std::size_t kMostBytes = 16U << 20U;

[[noreturn]] void refuse_file(const std::string& path, const std::string& why) {
  throw std::invalid_argument(fmt::format("{}: {}", path, why));
}

}  // namespace

namespace {

std::string text_of(std::istream& file) {
  std::string text;
  std::array<char, 1U << 16U> block;
  while (file && text.size() <= kMostBytes) {
    file.read(block.data(), block.size());
    text.append(block.data(), static_cast<std::size_t>(file.gcount()));
  }
  return text;
}

void check_size(const std::string& text, const std::string& path, const std::string& what) {
  if (text.size() <= kMostBytes) return;
  refuse_file(path, fmt::format("it is larger than {} MiB, the most that a {} may have",
                                kMostBytes >> 20U, what));
}

}  // namespace

std::string file_text(const std::string& path, const std::string& what) {
  namespace fs = std::filesystem;
  if (path == "-") {
    static const std::string text = text_of(std::cin);  // which can be read once only
    check_size(text, "standard input", what);
    return text;
  }
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (fs::is_directory(status)) refuse_file(path, fmt::format("it is a directory, not a {}", what));
  if (fs::is_block_file(status) || fs::is_socket(status)) {
    refuse_file(path, fmt::format("it is not a text file; a {} is needed", what));
  }
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  std::string text = text_of(file);
  if (!file.is_open() || file.bad()) {
    refuse_file(path, unreadable(errno));
  }
  check_size(text, path, what);
  return text;
}

std::string unreadable(int error) {
  return fmt::format("cannot be read: {}", error != 0 ? std::strerror(error) : "unknown cause");
}

}  // namespace camlaw::problems
