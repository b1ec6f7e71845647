// SPDX-License-Identifier: MIT
#include "output/answers/value_lines.h"

#include <fmt/format.h>

#include <algorithm>

#include "output/document/formatting.h"

namespace camlaw::cli {
namespace {

/// Numbers of one list beyond which they are not printed one by one.
constexpr std::size_t kListedOneByOne = 12;

/// "coefficients" of "coefficients[3]"; else empty.
std::string list_of(const std::string& name) {
  const std::size_t bracket = name.find('[');
  return bracket == std::string::npos ? "" : name.substr(0, bracket);
}

/// Where the run of values of one list ends that begins at one.
std::size_t end_of_list(const std::vector<DesignValue>& values, std::size_t from) {
  const std::string list = list_of(values[from].name);
  std::size_t end = from + 1;
  while (!list.empty() && end < values.size() && list_of(values[end].name) == list) ++end;
  return end;
}

std::string long_list(const std::vector<DesignValue>& values, std::size_t from, std::size_t end) {
  const auto [least, most] = std::minmax_element(
      values.begin() + static_cast<std::ptrdiff_t>(from),
      values.begin() + static_cast<std::ptrdiff_t>(end),
      [](const DesignValue& a, const DesignValue& b) { return a.number < b.number; });
  return fmt::format("  {}: {} numbers from {:.6g} to {}; --json has them\n",
                     list_of(values[from].name), end - from, least->number,
                     with_unit(fmt::format("{:.6g}", most->number), values[from].unit));
}

}  // namespace

std::string value_lines(const std::vector<DesignValue>& values, std::size_t from,
                        const std::string& left_out) {
  std::string lines;
  for (std::size_t i = from; i < values.size();) {
    const std::size_t end = end_of_list(values, i);
    if (end - i > kListedOneByOne) {
      lines += long_list(values, i, end);
      i = end;
      continue;
    }
    for (; i < end; ++i) {
      if (values[i].name == left_out) continue;
      lines += fmt::format("  {} = {}\n", values[i].name, values[i].words());
    }
  }
  return lines;
}

}  // namespace camlaw::cli
