// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <string_view>

/// What quantities measure. A number with a dimension is counted in the units of the SI; angles and
/// revolutions are plain numbers, in radians.
namespace camlaw {

/// Powers of m, kg, s, A, K, mol and cd.
struct Dimension {
  static constexpr std::array<std::string_view, 7> kUnits{"m", "kg", "s", "A", "K", "mol", "cd"};
  std::array<double, 7> powers{};

  bool is_plain() const { return *this == Dimension{}; }
  /// Powers that differ by rounding are equal: those of roots need not be exact.
  friend bool operator==(const Dimension& a, const Dimension& b);
  friend Dimension operator*(const Dimension& a, const Dimension& b);
  friend Dimension operator/(const Dimension& a, const Dimension& b);
};
Dimension power(const Dimension& d, double exponent);

/// "a force (N)", "a plain number", "a quantity in m^2 kg s^-3".
std::string to_string(const Dimension& d);

/// A unit's dimension, and the unit of the SI that it is converted to, in the spelling of the unit
/// library: of rpm "rad.s-1".
struct SiUnit {
  Dimension dimension;
  std::string unit;
};

/// Of a unit in the library's spelling. Throws std::invalid_argument where it cannot be read, and
/// of scales that do not begin at 0, such as degC.
SiUnit si_unit(const std::string& unit);

/// The same of one that people write, and the spelling that the library knows it by. Refuses 1/min
/// and Hz, which may count revolutions or not.
struct WrittenUnit {
  SiUnit si;
  std::string spelled;
};
WrittenUnit written_unit(std::string_view written);

}  // namespace camlaw
