// SPDX-License-Identifier: MIT
#include "numerics/text/dimension.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>
#include <vector>

namespace camlaw {
namespace {

/// Kinds that messages name.
constexpr std::pair<const char*, const char*> kKinds[] = {{"a length", "m"},
                                                          {"an area", "m2"},
                                                          {"a volume", "m3"},
                                                          {"a time", "s"},
                                                          {"a frequency", "1/s"},
                                                          {"a velocity", "m/s"},
                                                          {"an acceleration", "m/s2"},
                                                          {"a mass", "kg"},
                                                          {"a density", "kg/m3"},
                                                          {"a force", "N"},
                                                          {"a spring rate", "N/m"},
                                                          {"a stress", "Pa"},
                                                          {"a torque or an energy", "N m"},
                                                          {"a power", "W"},
                                                          {"a moment of inertia", "kg m2"}};

std::string unit_text(const Dimension& d) {
  std::string text;
  for (std::size_t i = 0; i < d.powers.size(); ++i) {
    if (d.powers[i] == 0) continue;
    text += fmt::format("{}{}", text.empty() ? "" : " ", Dimension::kUnits[i]);
    if (d.powers[i] != 1) text += fmt::format("^{:.4g}", d.powers[i]);
  }
  return text;
}

}  // namespace

bool operator==(const Dimension& a, const Dimension& b) {
  constexpr double kRounding = 1e-9;
  for (std::size_t i = 0; i < a.powers.size(); ++i) {
    if (std::abs(a.powers[i] - b.powers[i]) > kRounding) return false;
  }
  return true;
}

Dimension operator*(const Dimension& a, const Dimension& b) {
  Dimension result;
  for (std::size_t i = 0; i < a.powers.size(); ++i) result.powers[i] = a.powers[i] + b.powers[i];
  return result;
}

Dimension operator/(const Dimension& a, const Dimension& b) { return a * power(b, -1); }

Dimension power(const Dimension& d, double exponent) {
  Dimension result;
  for (std::size_t i = 0; i < d.powers.size(); ++i) result.powers[i] = exponent * d.powers[i];
  return result;
}

std::string to_string(const Dimension& d) {
  if (d.is_plain()) return "a plain number";
  static const std::vector<Dimension> kinds = [] {
    std::vector<Dimension> all;
    for (const auto& [name, unit] : kKinds) all.push_back(si_unit(unit).dimension);
    return all;
  }();
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    if (kinds[i] == d) return fmt::format("{} ({})", kKinds[i].first, kKinds[i].second);
  }
  return fmt::format("a quantity in {}", unit_text(d));
}

}  // namespace camlaw
