// SPDX-License-Identifier: MIT
#pragma once

#include <glpk.h>

#include <optional>
#include <vector>

/// A linear program that grows by rows: minimise c y, a y <= b, l <= y <= u. By GLPK's dual
/// simplex.
namespace camlaw::adversary {

class LinearProgram {
 public:
  explicit LinearProgram(const std::vector<double>& cost);
  ~LinearProgram() {
    if (program_ != nullptr) glp_delete_prob(program_);
  }
  LinearProgram(const LinearProgram&) = delete;
  LinearProgram& operator=(const LinearProgram&) = delete;

  void bound(std::size_t column, std::optional<double> lower, std::optional<double> upper);
  /// a y <= b, scaled to size one.
  void at_most(const std::vector<double>& a, double b);

  enum class End { Solved, Infeasible, Unknown };
  End solve();
  std::vector<double> solution() const;
  double value() const { return glp_get_obj_val(program_); }

 private:
  End simplex();
  glp_prob* program_;
};

}  // namespace camlaw::adversary
