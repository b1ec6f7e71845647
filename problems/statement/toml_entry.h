// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace camlaw::problems {

/// A value of a TOML file that knows where it stands, so that who reads it can say what is wrong
/// there. toml++ is included in toml_entry.cpp alone.
struct Entry {
  enum class Kind { Text, Integer, Float, Truth, Date, List, Table };

  Kind kind = Kind::Table;
  std::string place;         ///< "file.toml:12"; of the whole file "file.toml"
  std::string path;          ///< "variables.alpha.lower"; of the whole file empty
  std::string key;           ///< the last part of it
  std::string text;          ///< of Text
  double number = 0;         ///< of Integer and Float
  std::int64_t integer = 0;  ///< of Integer; of Truth 0 or 1
  std::vector<Entry> items;  ///< of List, and of Table in the order of the file

  bool is_number() const { return kind == Kind::Integer || kind == Kind::Float; }
};

/// "a text", "a list": a kind in messages.
std::string_view to_string(Entry::Kind kind);

/// Reads TOML; `source` names it in errors. Throws std::invalid_argument with the line of what is
/// not TOML, or not UTF-8.
Entry parse_toml(std::string_view text, const std::string& source);

/// Throws std::invalid_argument "place: path: why".
[[noreturn]] void refuse(const Entry& entry, const std::string& why);

}  // namespace camlaw::problems
