// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// Formulas as people write them: "mass * speed^2 * peak acceleration / (1 kN)". docs/formulas.md
/// has the grammar.
namespace camlaw {

/// What is written, as a tree.
struct FormulaTree {
  enum class Kind {
    Number,    ///< with `text` its unit, which may be empty
    Name,      ///< `text`, with the word before it: "peak", "highest", "lowest", or none
    Function,  ///< `text` of the parts
    Negate,
    Add,
    Subtract,
    Multiply,
    Divide,
    Power
  };

  Kind kind = Kind::Number;
  std::size_t at = 0;  ///< the character that it begins at, from 0
  double number = 0;
  std::string text = {};
  std::string part = {};   ///< of a name: the word before it
  bool is_closed = false;  ///< whether it stands in parentheses, or its unit in brackets
  std::vector<FormulaTree> parts = {};

  /// "peak force": a name with its word.
  std::string full_name() const { return part.empty() ? text : part + " " + text; }
  /// Whether it is root(NAME, ...), which gives a name to what it looks for.
  bool is_root() const {
    return kind == Kind::Function && text == "root" && !parts.empty() &&
           parts[0].kind == Kind::Name;
  }
};

/// Refuses a formula for what is written at a character, counted from 0. Throws
/// std::invalid_argument.
[[noreturn]] void refuse_formula(std::size_t at, const std::string& why);

/// Reads a formula. Throws std::invalid_argument with the place of what cannot be read, and where
/// it is nested deeper than 64 levels or has more than 2000 parts.
FormulaTree parse_formula(std::string_view text);

/// The names of a formula, each once, in the order in which they are written, without those that
/// its roots give.
std::vector<FormulaTree> names_in(const FormulaTree& tree);

}  // namespace camlaw
