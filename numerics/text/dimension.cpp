// SPDX-License-Identifier: MIT
#include "numerics/text/dimension.h"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "numerics/text/unit_kinds.h"

namespace camlaw {
namespace {

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
  constexpr double kRounding = 1e-9;  // powers such as 1/3 + 1/3 + 1/3 add up with rounding
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
  struct Kind {
    UnitKind words;
    Dimension dimension;
  };
  static const std::vector<Kind> kinds = [] {
    std::vector<Kind> all;
    for (const UnitKind& kind : kUnitKinds) {
      if (!kind.has_angle) all.push_back({kind, si_unit(kind.unit).dimension});
    }
    return all;
  }();
  for (const auto& [words, dimension] : kinds) {
    if (dimension == d) return fmt::format("{} ({})", words.name, words.unit);
  }
  return fmt::format("a quantity in {}", unit_text(d));
}

}  // namespace camlaw
