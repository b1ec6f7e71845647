// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "benchmarks/accuracy/accuracy.h"
#include "benchmarks/timing.h"
#include "optim/search/optimise.h"
#include "tests/sets/hock_schittkowski/problems.h"

namespace camlaw::benchmarks {
namespace {

/// How one back end did on all problems.
struct Score {
  int refused = 0, certified = 0, feasible = 0, failed = 0;
  int known = 0;     ///< certified, and the known least value to 1e-6
  double worst = 0;  ///< error of those, over max(1, |f|)
  long evaluations = 0;
  std::vector<std::string> not_certified;
};

void add(const optim::Problem& problem, const std::string& solver, Score& score) {
  using optim::Verdict;
  const optim::Found found = optim::optimise(problem, {.solver = solver}).found;
  score.evaluations += found.evaluations;
  const optim::Assessment& a = found.assessment;
  if (found.x.empty()) {
    ++score.refused;
    return;
  }
  if (a.verdict != Verdict::Certified) {
    ++(a.verdict == Verdict::Feasible ? score.feasible : score.failed);
    score.not_certified.push_back(problem.name);
    return;
  }
  ++score.certified;
  const double known = problem.known->objective;
  const double error = std::abs(a.objective.value - known) / std::max(1.0, std::abs(known));
  if (error > 1e-6) {
    score.not_certified.push_back(problem.name + " (another valley)");
    return;
  }
  ++score.known;
  score.worst = std::max(score.worst, error);
}

}  // namespace

void print_hock_schittkowski_table() {
  fmt::print(
      "the 33 Hock-Schittkowski problems\n\n| back end | refused | certified | with the known "
      "least "
      "value | largest error | feasible only | failed | evaluations | seconds | which not "
      "|\n|---|--:|--:|--:|--:|--:|--:|--:|--:|---|\n");
  std::vector<std::string> names = optim::solver_names();
  names.insert(names.begin(), "auto");
  for (const std::string& name : names) {
    Score score;
    const double time = seconds([&] {
      for (const optim::Problem& problem : sets::hock_schittkowski_problems()) {
        add(problem, name, score);
      }
    });
    fmt::print("| {} | {} | {} | {} | {:.1e} | {} | {} | {} | {:.2f} | {} |\n", name, score.refused,
               score.certified, score.known, score.worst, score.feasible, score.failed,
               score.evaluations, time, fmt::join(score.not_certified, ", "));
  }
  fmt::print("\n");
}

}  // namespace camlaw::benchmarks
