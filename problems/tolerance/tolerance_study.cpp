// SPDX-License-Identifier: MIT
#include "problems/tolerance/tolerance_study.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "problems/fronts/problem_settings.h"
#include "problems/tolerance/tolerance_worker.h"

namespace camlaw::problems {

ToleranceStudy::ToleranceStudy(const ProblemStatement& design,
                               const std::vector<std::string>& tolerances,
                               std::optional<std::size_t> samples, std::uint64_t seed)
    : settings_(problem_settings(restated_design(design))) {
  settings_[kYieldSetting] = fmt::format("{}", fmt::join(tolerances, "\n"));
  settings_["samples"] = samples ? fmt::format("{}", *samples) : "";
  settings_["seed"] = fmt::format("{}", seed);
}

void ToleranceStudy::check_same(const optim::StudyRecord& record) const {
  const optim::StudySettings its = record.settings();
  check_kind(its, kind_of_study(settings_));
  check_same_problem(its, settings_);
  if (find_setting(its, "set") != settings_.at("set")) {
    refuse_to_resume("it belongs to another design: other values are set");
  }
  if (its.at(kYieldSetting) != settings_.at(kYieldSetting)) {
    refuse_to_resume("its tolerances were stated otherwise");
  }
  check_same_settings(its, settings_, {"versions", "seed"});
  if (const std::string& samples = find_setting(its, "samples");
      samples != settings_.at("samples")) {
    refuse_to_resume(samples.empty() ? "it was begun without --samples"
                                     : fmt::format("it was begun with --samples {}", samples));
  }
}

}  // namespace camlaw::problems
