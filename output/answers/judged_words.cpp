// SPDX-License-Identifier: MIT
#include "output/answers/judged_words.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "output/document/formatting.h"
#include "problems/results/judged_design.h"
#include "problems/statement/shaft_cams.h"

namespace camlaw::cli {

std::vector<std::string> judged_words(const problems::ReadDesign& read) {
  const auto held = problems::held_problem(read);
  if (!held) return {};
  const optim::Assessment found = problems::judged(*held);
  if (optim::is_feasible(found)) {
    return {fmt::format("judged again: {}", optim::to_string(found.verdict))};
  }
  return {"judged again: the design does not meet its limits"};
}

std::vector<std::string> record_words(const problems::ReadDesign& read, const ClaimReview& review) {
  std::vector<std::string> words = review.words();
  if (review.is_believed()) return words;
  // Nobody judged the design that the record has now.
  for (std::string& sentence : judged_words(read)) words.push_back(std::move(sentence));
  return words;
}

std::vector<std::string> unmet_words(const problems::ProblemStatement& design) {
  std::vector<std::string> words;
  for (const optim::LimitReport& limit : problems::standing(design)) {
    if (limit.met) continue;
    const char* side = limit.is_equation ? "equal to" : limit.is_upper ? "at most" : "at least";
    const std::string value =
        std::isnan(limit.value) ? "undefined" : with_unit(in_digits(limit.value), limit.unit);
    words.push_back(fmt::format("limit not met: {} is {} and must be {} {}", limit.name, value,
                                side, with_unit(in_digits(limit.bound), limit.unit)));
  }
  return words;
}

std::vector<std::string> take_cam(const std::optional<std::string>& name, const std::string& file,
                                  const char* example, problems::ProblemStatement& statement) {
  if (name) {
    std::vector<std::string> unmet = unmet_words(statement);
    statement = problems::cam_alone(statement, problems::find_cam(statement, *name));
    return unmet;
  }
  if (statement.cams.empty()) return {};
  throw std::invalid_argument(
      fmt::format("{}: there are several cams on the shaft; say which to export, such as {}", file,
                  fmt::format(fmt::runtime(example), statement.cams.front().name)));
}

}  // namespace camlaw::cli
