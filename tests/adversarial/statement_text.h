// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

/// Pieces of problem files, every number with all its digits.
namespace camlaw::adversary {

inline std::string digits(double x) { return fmt::format("{:.17g}", x); }

inline std::string list_of(const std::vector<double>& values) {
  std::string text;
  for (const double x : values) text += (text.empty() ? "" : ", ") + digits(x);
  return "[" + text + "]";
}

inline std::string variable_text(const std::string& name, double lower, double upper,
                                 double start) {
  return fmt::format("[variables.{}]\nlower = {}\nupper = {}\nstart = {}\n", name, digits(lower),
                     digits(upper), digits(start));
}

inline std::string objective_text(const std::string& response, bool least = true) {
  return fmt::format("[objective]\n{} = \"{}\"\n", least ? "minimize" : "maximize", response);
}

inline std::string at_least(const std::string& response, double bound) {
  return fmt::format("[[constraints]]\nresponse = \"{}\"\nlower = {}\n", response, digits(bound));
}
inline std::string at_most(const std::string& response, double bound) {
  return fmt::format("[[constraints]]\nresponse = \"{}\"\nupper = {}\n", response, digits(bound));
}

}  // namespace camlaw::adversary
