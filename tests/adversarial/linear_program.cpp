// SPDX-License-Identifier: MIT
#include "tests/adversarial/linear_program.h"

#include <algorithm>
#include <cmath>
#include <csetjmp>

namespace camlaw::adversary {
namespace {

/// GLPK ends the process where one of its assertions fails; from here it comes back.
std::jmp_buf come_back;
void failed(void*) { std::longjmp(come_back, 1); }

}  // namespace

LinearProgram::LinearProgram(const std::vector<double>& cost) : program_(glp_create_prob()) {
  glp_term_out(GLP_OFF);
  glp_add_cols(program_, static_cast<int>(cost.size()));
  for (std::size_t i = 0; i < cost.size(); ++i) {
    glp_set_obj_coef(program_, static_cast<int>(i) + 1, cost[i]);
    glp_set_col_bnds(program_, static_cast<int>(i) + 1, GLP_FR, 0, 0);
  }
}

void LinearProgram::bound(std::size_t column, std::optional<double> lower,
                          std::optional<double> upper) {
  const int kind = lower && upper ? (*lower == *upper ? GLP_FX : GLP_DB)
                   : lower        ? GLP_LO
                   : upper        ? GLP_UP
                                  : GLP_FR;
  glp_set_col_bnds(program_, static_cast<int>(column) + 1, kind, lower.value_or(0),
                   upper.value_or(0));
}

void LinearProgram::at_most(const std::vector<double>& a, double b) {
  // A place where the model gives no number says nothing about others.
  if (!std::isfinite(b) ||
      !std::all_of(a.begin(), a.end(), [](double x) { return std::isfinite(x); })) {
    return;
  }
  double size = 0;
  for (const double x : a) size = std::max(size, std::abs(x));
  // A row that nothing moves is kept as it is: it is met or nothing is.
  if (!(size > 1e-13 * std::abs(b))) size = std::max(std::abs(b), 1e-300);
  std::vector<int> index{0};
  std::vector<double> entry{0};
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::abs(a[i]) <= 1e-13 * size) continue;
    index.push_back(static_cast<int>(i) + 1);
    entry.push_back(a[i] / size);
  }
  const int row = glp_add_rows(program_, 1);
  glp_set_row_bnds(program_, row, GLP_UP, 0, b / size);
  glp_set_mat_row(program_, row, static_cast<int>(index.size()) - 1, index.data(), entry.data());
}

LinearProgram::End LinearProgram::solve() {
  if (setjmp(come_back) != 0) {
    // All that GLPK had is gone with its environment.
    glp_free_env();
    program_ = nullptr;
    return End::Unknown;
  }
  glp_error_hook(failed, nullptr);
  const End end = simplex();
  glp_error_hook(nullptr, nullptr);
  return end;
}

LinearProgram::End LinearProgram::simplex() {
  glp_smcp options;
  glp_init_smcp(&options);
  options.msg_lev = GLP_MSG_OFF;
  options.meth = GLP_DUALP;
  options.tol_bnd = 1e-9;
  options.tol_dj = 1e-9;
  options.it_lim = 5000;
  if (glp_simplex(program_, &options) != 0) {
    // A basis that rows have made singular: from a basis of slacks.
    glp_std_basis(program_);
    options.meth = GLP_PRIMAL;
    if (glp_simplex(program_, &options) != 0) return End::Unknown;
  }
  switch (glp_get_status(program_)) {
    case GLP_OPT:
      return End::Solved;
    case GLP_NOFEAS:
      return End::Infeasible;
    default:
      return End::Unknown;
  }
}

std::vector<double> LinearProgram::solution() const {
  std::vector<double> y;
  for (int i = 1; i <= glp_get_num_cols(program_); ++i) y.push_back(glp_get_col_prim(program_, i));
  return y;
}

}  // namespace camlaw::adversary
