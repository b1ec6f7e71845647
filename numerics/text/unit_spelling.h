// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

/// Units as engineers write them, in the spelling of the unit library.
namespace camlaw {

/// "Nm" is "N m", "°" and "Grad" are "deg", "kgm²" is "kg m2", "U/min" is "rev/min". What needs no
/// other spelling stays.
std::string spelled_out(std::string_view written);

/// Why a unit that could be read is not taken: its spelling means one thing to one reader and
/// another to the next, such as "grad". Empty for all others.
std::optional<std::string> ambiguous(std::string_view written);

/// Whether a unit counts how often something happens in a time as revolutions are counted: 1/min,
/// min-1, Hz. Spelled out.
bool counts_turns(std::string_view unit);

/// Whether a name is one of an angle that people use: prefixes only of the radian, milli and micro.
bool is_angle_name(std::string_view name);

/// Calls look(name) for every name in a unit.
template <class Look>
void for_each_name(std::string_view unit, const Look& look);

// ---------------------------------------------------------------------------------------------

/// Whether a character can be part of a unit's name.
inline bool is_name_character(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z') || byte == '_' ||
         byte >= 0x80;
}

template <class Look>
void for_each_name(std::string_view unit, const Look& look) {
  while (!unit.empty()) {
    std::size_t length = 0;
    while (length < unit.size() && is_name_character(unit[length])) ++length;
    if (length > 0) look(unit.substr(0, length));
    unit.remove_prefix(length > 0 ? length : 1);
  }
}

}  // namespace camlaw
