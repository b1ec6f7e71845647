// SPDX-License-Identifier: MIT
#include "output/document/formatting.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>

namespace camlaw::cli {
namespace {

/// Spreadsheets take a cell that begins like this for a formula and carry it out.
bool looks_like_formula(const std::string& cell) {
  if (cell.empty() || std::string_view("=+-@\t").find(cell.front()) == std::string_view::npos) {
    return false;
  }
  char* end = nullptr;
  std::strtod(cell.c_str(), &end);
  return *end != 0 || end == cell.c_str();
}

std::string quoted(const std::string& text) {
  const std::string cell = looks_like_formula(text) ? "'" + text : text;
  if (cell.find_first_of(",\"\n\r") == std::string::npos) return cell;
  std::string result = "\"";
  for (const char c : cell) {
    if (c == '"') result += '"';
    result += c;
  }
  result += '"';
  return result;
}

/// So many significant digits, of numbers below a million without a power of ten: 15000.
std::string with_few_powers(double value, int digits) {
  constexpr double kPlain = 1e6;
  const std::string text = fmt::format("{:.{}g}", value + 0.0, digits);
  if (std::abs(value) >= kPlain || text.find("e+") == std::string::npos) return text;
  return fmt::format("{:.0f}", std::strtod(text.c_str(), nullptr));
}

}  // namespace

std::string to_csv(const std::vector<std::vector<std::string>>& rows) {
  std::string result;
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (i > 0) result += ',';
      result += quoted(row[i]);
    }
    result += '\n';
  }
  return result;
}

std::string shown(double value, int decimals) {
  if (std::isnan(value)) return "-";
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  std::string text = fmt::format("{:.{}f}", value, decimals);
  const bool zero = text.find_first_not_of("-0.") == std::string::npos;
  return zero && text.front() == '-' ? text.substr(1) : text;
}

std::string significant(double value, double size, int digits) {
  if (!std::isfinite(value)) return shown(value, 0);
  constexpr double kLeast = 1e-290;  // smaller ones have no quantum
  if (size > kLeast && std::isfinite(size)) {
    const double quantum = std::pow(10, std::floor(std::log10(size)) - 6);
    if (std::abs(value) < 0.5 * quantum) value = 0;
    // Above, as many digits as reach down to the quantum.
    if (value != 0) {
      const double own = std::floor(std::log10(std::abs(value)) - std::log10(quantum)) + 1;
      digits = std::clamp(static_cast<int>(own), 1, digits);
    }
  }
  return with_few_powers(value, digits);
}

std::string in_digits(double value, int digits) {
  if (!std::isfinite(value)) return shown(value, 0);
  return with_few_powers(value, digits);
}

std::string plain_name(std::string_view name) {
  constexpr std::pair<std::string_view, std::string_view> kOwnNames[] = {
      {"youngs modulus", "Young's modulus"}, {"poisson ratio", "Poisson's ratio"}};
  std::string result(name);
  std::replace(result.begin(), result.end(), '_', ' ');
  for (const auto& [plain, written] : kOwnNames) {
    const std::size_t at = result.find(plain);
    if (at != std::string::npos) result.replace(at, plain.size(), written);
  }
  return result;
}

std::string shown_unit(const std::string& unit) { return unit == "1" ? "" : unit; }

std::string with_unit(const std::string& text, const std::string& unit) {
  return unit == "1" || unit.empty() ? text : text + " " + unit;
}

std::string exact(double value) { return std::isnan(value) ? "" : fmt::format("{}", value); }

}  // namespace camlaw::cli
