// SPDX-License-Identifier: MIT
#include "problems/published/table/printed_text.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <stdexcept>

#include "numerics/text/names.h"

namespace camlaw::problems {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Of an exponent that follows at `at`, "e-3", with its end in `at`; 0 where there is none.
int exponent_at(std::string_view text, std::size_t& at) {
  if (at >= text.size() || (text[at] != 'e' && text[at] != 'E')) return 0;
  const char* first = text.data() + at + 1;
  const char* const last = text.data() + text.size();
  if (first != last && *first == '+') ++first;
  int exponent = 0;
  const auto [end, error] = std::from_chars(first, last, exponent);
  if (error != std::errc{}) return 0;
  at = static_cast<std::size_t>(end - text.data());
  return exponent;
}

}  // namespace

PrintedText read_printed_text(std::string_view text) {
  const std::string_view all = trimmed(text);
  const auto refuse_print = [&](const std::string& why) {
    throw std::invalid_argument(fmt::format("'{}' {}", text, why));
  };
  std::size_t at = !all.empty() && (all[0] == '-' || all[0] == '+') ? 1 : 0;
  const bool has_plus = at == 1 && all[0] == '+';
  std::size_t digits = 0;
  int decimals = 0;
  for (; at < all.size() && is_digit(all[at]); ++at) ++digits;
  if (at < all.size() && all[at] == '.') {
    for (++at; at < all.size() && is_digit(all[at]); ++at) ++digits, ++decimals;
  }
  if (digits == 0) refuse_print("does not begin with a number; write it as printed, \"12.34 mm\"");
  if (at < all.size() && (all[at] == ',' || all[at] == '.')) {
    refuse_print(
        "has marks between its digits; use a point for the decimals and no thousands separators");
  }
  decimals -= exponent_at(all, at);
  if (decimals < 0 || decimals > optim::kMaxDecimals) {
    refuse_print(fmt::format("has {} decimals; use 0 to {}: write it in another unit", decimals,
                             optim::kMaxDecimals));
  }
  PrintedText result;
  result.number.decimals = decimals;
  const char* const first = all.data() + (has_plus ? 1 : 0);
  const auto [end, error] = std::from_chars(first, all.data() + at, result.number.value);
  if (error != std::errc{} || end != all.data() + at || !std::isfinite(result.number.value)) {
    refuse_print("is not a number that can be compared");
  }
  result.unit = trimmed(all.substr(at));
  return result;
}

}  // namespace camlaw::problems
