// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "tests/adversarial/answer.h"
#include "tests/adversarial/case.h"
#include "tests/adversarial/judge.h"

/// What makes an answer wrong.
namespace camlaw::adversary {

struct Wrong {
  char kind;  ///< 'a' .. 'g', as in README.md
  std::string what;
};

struct Outcome {
  Answer answer;
  Truth truth;
  std::vector<Spot> fine;  ///< the places at which designs are looked at before anything is wrong
  std::vector<Wrong> wrong;
  bool crashed = false;             ///< an exception reached us; `answer.reason` has its words
  bool right = false;               ///< feasible only, though no better design is known
  bool other_valley = false;        ///< certified nearby, and a better design is elsewhere
  double solve_s = 0, judge_s = 0;  ///< of the processor
};

/// Solves the case with the program's defaults and judges the answer.
Outcome judged(const Case& test, Random random);

/// The largest difference between the judge's curves and the program's at designs in the box, as a
/// share of the curve's size: the judge's formulas checked once.
double difference(const Case& test, Random random, std::string& where);

}  // namespace camlaw::adversary
