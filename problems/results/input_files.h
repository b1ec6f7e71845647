// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "problems/results/recorded_design.h"

/// What a problem is read from: its own file, and the laws, tables and catalogues that it names.
/// No output takes the place of one of them.
namespace camlaw::problems {

/// The paths of what a problem was read from, as far as it was read from files.
std::vector<std::string> input_files(const ProblemStatement& problem);

/// A problem as it was when something was found out about it: that of a result, a study, an answer.
struct RecordedProblem {
  ProblemStatement problem;  ///< its source: the problem file's place then
  std::string record;        ///< the record's own file; empty where there is none
};

RecordedProblem recorded_problem(const ReadDesign& result, const std::string& file);

/// The same wherever the problem stands: where it stood when it was recorded, and by its name in
/// the record's folder and the two above it, for folders are copied and moved.
std::vector<std::string> input_files(const RecordedProblem& recorded);

/// Whether a file holds what the problem was read from: its text, a table's, or a law's pieces.
/// So an input is known wherever it was moved to.
bool holds_input(const RecordedProblem& recorded, const std::string& path);

/// Whether a path leads to what the record's problem is read from, by its place or by its content.
bool is_read_by(const RecordedProblem& recorded, const std::string& path);
/// The same of a problem, by the place alone.
bool is_read_by(const ProblemStatement& problem, const std::string& path);

}  // namespace camlaw::problems
