// SPDX-License-Identifier: MIT
#include "output/answers/claim_output.h"

#include <fmt/format.h>

#include "output/answers/law_output.h"
#include "output/document/printing.h"
#include "output/document/short_version.h"
#include "problems/results/judged_design.h"
#include "problems/results/recorded_design.h"

namespace camlaw::cli {

std::vector<std::string> ClaimReview::words() const {
  std::vector<std::string> all = notes;
  for (const std::string& difference : differences) {
    all.push_back("the result is wrong: " + difference);
  }
  return all;
}

ClaimReview reviewed(const problems::ReadDesign& read) {
  return {problems::record_notes(read, short_version()), problems::differences(read)};
}

std::string record_text(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& sentence : words) {
    text += fmt::format("{}: {}\n", shaded("record", Shade::Bad), sentence);
  }
  return text;
}

Json review_json(const ClaimReview& review) {
  return {{"notes", review.notes}, {"differences", review.differences}};
}

void say_review(const std::string& file, const ClaimReview& review) {
  for (const std::string& words : review.words()) {
    warn(fmt::format("{}: {}", file, words));
  }
}

void say_first_law(const std::string& file, const problems::ProblemStatement& statement) {
  if (!statement.chooses_law()) return;
  warn(
      fmt::format("{}: this is the first of {} laws to choose from, {}; --set takes another, and "
                  "'camlaw optimize' finds the best",
                  file, statement.laws.size(),
                  law_in_words(statement.laws.front(), statement.mechanism->moved_by)));
}

}  // namespace camlaw::cli
