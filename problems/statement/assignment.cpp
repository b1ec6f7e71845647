// SPDX-License-Identifier: MIT
#include "problems/statement/assignment.h"

#include <fmt/format.h>

#include <stdexcept>

#include "numerics/text/names.h"

namespace camlaw::problems {

SettingText parse_assignment(std::string_view written, std::string_view example) {
  const std::size_t equals = written.find('=');
  const std::string_view name = trimmed(written.substr(0, equals));
  if (equals == std::string_view::npos || name.empty()) {
    throw std::invalid_argument(
        fmt::format("'{}' sets nothing; write name=value, such as {}", written, example));
  }
  return {name, trimmed(written.substr(equals + 1))};
}

}  // namespace camlaw::problems
