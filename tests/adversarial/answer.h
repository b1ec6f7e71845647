// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "optim/search/optimise.h"

/// What the program said, read off its own structures here and nowhere else: they gain fields.
namespace camlaw::adversary {

enum class Said { Certified, Feasible, Infeasible, Failed };

struct SaidLimit {
  std::string name;
  bool met = false, proved = false, is_upper = false, is_equation = false;
  double bound = 0, value = 0, tolerance = 0, price = 0;
};

struct Answer {
  Said said = Said::Failed;
  bool global = false;
  std::string reason;
  double objective = 0, objective_tolerance = 0;
  std::vector<double> x;  ///< in the order of the names that were asked for
  std::vector<SaidLimit> limits;
  bool at_a_bound = false;  ///< a variable stands at its own bound
  int starts = 0;
  long evaluations = 0;
  double wall_s = 0;
};

/// Of a problem of one combination. Throws std::runtime_error where a variable is missing.
Answer answer_of(const optim::Optimum& optimum, const std::vector<std::string>& names);

/// The same design judged again, as an answer to the problem in a box `wider` times as wide.
Answer in_wider_box(const optim::Optimum& optimum, double wider,
                    const std::vector<std::string>& names);

/// What `camlaw optimize` calls each verdict.
const char* word(Said said);

}  // namespace camlaw::adversary
