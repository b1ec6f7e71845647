// SPDX-License-Identifier: MIT
#include <cstdio>

#include "optim/search/optimise.h"
#include "problems/statement/bind.h"

/// Prints the objective of the best design of a problem file.
int main(int count, char** words) {
  if (count != 2) return 2;
  const camlaw::problems::BoundProblem bound(camlaw::problems::read_problem_file(words[1]));
  const auto optimum = camlaw::optim::optimise(bound.space());
  std::printf("%.2f\n", optimum.found.assessment.objective.value);
}
