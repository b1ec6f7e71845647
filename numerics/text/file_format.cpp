// SPDX-License-Identifier: MIT
#include "numerics/text/file_format.h"

#include <fmt/format.h>

#include <charconv>
#include <stdexcept>

namespace camlaw {
namespace {

/// The version after the kind and a blank; 0 where there is none.
int version_in(std::string_view stated, std::string_view kind) {
  if (!stated.starts_with(kind) || stated.size() < kind.size() + 2 || stated[kind.size()] != ' ') {
    return 0;
  }
  const std::string_view digits = stated.substr(kind.size() + 1);
  int version = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), version);
  return error == std::errc{} && end == digits.data() + digits.size() ? version : 0;
}

}  // namespace

std::string FileFormat::text() const { return fmt::format("{} {}", kind, version); }

void FileFormat::check(std::string_view stated) const {
  const int found = version_in(stated, kind);
  if (found < 1) {
    throw std::invalid_argument(
        fmt::format("its format is '{}'; it must be '{}'", stated.substr(0, 80), text()));
  }
  if (found > version) {
    throw std::invalid_argument(fmt::format(
        "its format, '{}', is newer than this program, which reads up to '{}'", stated, text()));
  }
}

}  // namespace camlaw
