// SPDX-License-Identifier: MIT
#include "output/answers/judged_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "output/document/formatting.h"
#include "problems/results/judged_design.h"
#include "problems/results/recorded_design.h"
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

namespace {

/// Whether a curve of this name runs over the shaft's angle, not over a cam's.
bool is_of_shaft(const std::string& name, const problems::Mechanism& shaft) {
  const auto& all = shaft.responses;
  return std::any_of(all.begin(), all.end(), [&](const problems::MechanismResponse& r) {
    return r.name == name && r.curve && !r.cam;
  });
}

}  // namespace

TakenCam take_cam(const std::optional<std::string>& name, const std::string& file,
                  const char* example, const std::optional<std::string>& slave,
                  problems::ProblemStatement& statement) {
  if (name) {
    const std::size_t cam = problems::find_cam(statement, *name);
    const double phase = statement.constants[statement.mechanism->cams[cam].phase];
    TakenCam taken{unmet_words(statement), problems::ShaftPlace{*name, phase}};
    statement = problems::cam_alone(statement, cam);
    return taken;
  }
  if (statement.cams.empty()) return {};
  if (slave && is_of_shaft(*slave, *statement.mechanism)) return {};
  throw std::invalid_argument(fmt::format(
      "{}: there are several cams on the shaft; say which to export, such as {}{}", file,
      fmt::format(fmt::runtime(example), statement.cams.front().name),
      slave ? "; without it the slave is a curve of the shaft itself, such as shaft_torque" : ""));
}

}  // namespace camlaw::cli
