// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "output/document/json.h"
#include "problems/law_files/json_text.h"
#include "problems/results/recorded_design.h"

/// What a command says of a result that it was given: whether it is as it was written, and whether
/// its numbers are those of its design (docs/problem-files.md, "What a record is worth").
namespace camlaw::cli {

struct ClaimReview {
  std::vector<std::string> notes;        ///< on the record as such
  std::vector<std::string> differences;  ///< numbers that are not the design's: it is wrong

  /// Whether the words of the result, such as its verdict, may be shown as such.
  bool is_believed() const { return notes.empty() && differences.empty(); }
  /// Everything, a sentence each.
  std::vector<std::string> words() const;
};

/// Of a problem file nothing.
ClaimReview reviewed(const problems::ReadDesign& read);

/// What is to be said of a record, a line each; empty where there is nothing to say.
std::string record_text(const std::vector<std::string>& words);
Json review_json(const ClaimReview& review);
/// The same on standard error, for commands whose output is for other programs.
void say_review(const std::string& file, const ClaimReview& review);
/// Of a problem with several laws to choose from: that its first is looked at, on standard error.
void say_first_law(const std::string& file, const problems::ProblemStatement& statement);

}  // namespace camlaw::cli
