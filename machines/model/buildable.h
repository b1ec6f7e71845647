// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// What must hold of a machine that is made and run, whatever a problem seeks or limits.
namespace camlaw::problems {

/// A number that checks need and the machine's formulas do not. It has no default: where a problem
/// does not state it, what needs it is not checked.
struct BuildableInput {
  std::string name, unit, meaning;
};

/// How a follower is kept on its cam.
enum class Closure : char {
  Any,
  Force,  ///< by a spring or a load
  Form,   ///< in a groove
};

/// A stated number by the name of its parameter or input; none where the problem does not state it.
using StatedNumber = std::function<std::optional<double>(std::string_view)>;

/// A limit on a response that every design of the machine is looked at by. At the bound it holds.
struct BuildableCheck {
  std::string name;      ///< "wall"
  std::string fault;     ///< "the wall round the bore is too thin": what it is that fails
  std::string response;  ///< of the mechanism, or one of its named peaks
  bool is_upper;         ///< whether the bound is one from above
  /// In the response's listed unit, of what the check needs and, if it is stated, its input.
  double (*bound)(const StatedNumber&);
  std::vector<std::string> needs = {};   ///< parameters and inputs that the problem must state
  std::vector<std::string> one_of = {};  ///< ... and one of these
  /// An input that replaces a standard, and that standard in words.
  std::string input = {}, standard = {};
  Closure closure = Closure::Any;  ///< the followers that it is made for
  std::string after = {};          ///< a check that must hold for this one to mean something
};

}  // namespace camlaw::problems
