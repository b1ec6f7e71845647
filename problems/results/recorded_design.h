// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "numerics/text/file_format.h"
#include "problems/law_files/pieces_json.h"
#include "problems/results/stated_numbers.h"
#include "problems/statement/bind.h"

/// A design as a result keeps it, so that the result stands alone: the text of the problem, the law
/// files that it names, and what was chosen (docs/problem-files.md, "Answers").
namespace camlaw::problems {

inline constexpr FileFormat kResultFormat{"camlaw result", 1};

/// The object that a result has under "design": `source` (the file's name), `problem` (its text),
/// `set` (what was set beside it, as set_values takes it), `law_files` by name, `law` where there
/// were several to choose from, `variables` by name. Numbers keep every digit. Null where x is no
/// design.
Json recorded_design(const BoundProblem& bound, const std::vector<std::size_t>& options,
                     optim::Design x);

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
};

/// The design of a result, the text of a result.json or what --json prints; `source` names it in
/// errors. Throws std::invalid_argument for anything else, for a result without a design, and where
/// the design does not fit the problem recorded with it.
ReadDesign read_result(std::string_view json, const std::string& source);

/// The design of a file: of a problem file its starts, of a result what was found. Throws
/// std::invalid_argument with the path and what is wrong.
ReadDesign read_design_file(const std::string& path);

}  // namespace camlaw::problems
