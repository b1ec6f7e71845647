// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "problems/statement/bind.h"

/// A design as a result keeps it, so that the result stands alone: the text of the problem, the law
/// files that it names, and what was chosen (docs/problem-files.md, "Answers").
namespace camlaw::problems {

/// A limit as a result has it; NaN for what is not there.
struct StatedLimit {
  std::string name;
  double value, bound, margin;
  bool is_upper = true;
  bool met = false;
};

/// What the checksum of a result says of it.
enum class Seal {
  None,    ///< it has no checksum: earlier versions wrote none
  Fits,    ///< it is as it was written, whatever was done to its layout
  Broken,  ///< it was changed since, by someone or by accident
};

/// The numbers that a result states of its design. None of them is believed: they are there to be
/// compared with what the design is (`differences`, judged_design.h).
struct StatedNumbers {
  std::map<std::string, double> objectives = {};  ///< of a point of a front, by name
  std::optional<std::vector<StatedLimit>> limits = {};
  std::map<std::string, double> variables = {};  ///< as they are shown, by name
  std::optional<double> best_possible = {};
  std::string program = {};  ///< that wrote it: "camlaw 0.1.0"; empty: it does not say
  /// What else it states, by its keys: nothing of this is compared with the design.
  std::vector<std::string> others = {};
  Seal seal = Seal::None;
};

/// A design that was read.
struct ReadDesign {
  ProblemStatement problem;                 ///< as it was asked: its own starts, every law
  ProblemStatement statement = problem;     ///< at the design; its laws are the one chosen
  std::optional<std::string> verdict = {};  ///< of a result: "certified optimum"
  std::string reason = {};                  ///< of the verdict: "follower_force cannot be met"
  std::vector<std::string> blamed = {};     ///< limits that cannot be met, or not together
  std::optional<double> objective = {};     ///< of a result: its value, in the listed unit
  bool global = false;                      ///< of a result: no better design exists, it says
  StatedNumbers stated = {};                ///< of a result: what else it says of its design
  std::string problem_file = {};            ///< of a result: where its problem stood, if it says so
};

/// The design of a result, the text of a result.json or what --json prints; `source` names it in
/// errors. Throws std::invalid_argument for anything else, for a result without a design, and where
/// the design does not fit the problem recorded with it.
ReadDesign read_result(std::string_view json, const std::string& source);

/// The design of a file: of a problem file its starts, of a result what was found. Throws
/// std::invalid_argument with the path and what is wrong.
ReadDesign read_design_file(const std::string& path);

/// Sets values in a design that was read, as set_values does. Throws std::invalid_argument where a
/// result's free law would become another: the coefficients that were found are its own.
void set_in_design(ProblemStatement& statement, const ReadDesign& read,
                   std::span<const std::string> settings);

}  // namespace camlaw::problems
