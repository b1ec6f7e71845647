// SPDX-License-Identifier: MIT
#include "problems/sweeps/sweep_worker.h"

#include <fmt/format.h>

#include <memory>
#include <stdexcept>

#include "optim/study/encoding.h"
#include "problems/fronts/problem_settings.h"
#include "problems/fronts/study_worker.h"

namespace camlaw::problems {
namespace {

constexpr const char* kSweepWork = "sweep";

}  // namespace

optim::Service sweep_service(SweepStudy study) {
  const auto shared = std::make_shared<const SweepStudy>(std::move(study));
  return optim::task_service(
      [shared](const optim::Task& task, const optim::OptimiseOptions& options) {
        return shared->carry_out(task, options);
      });
}

optim::WorkerProgram worker_program(const SweepStudy& study) {
  std::vector<std::string> texts{kSweepWork};
  for (const auto& [name, text] : study.settings()) texts.insert(texts.end(), {name, text});
  return {worker_path(), optim::encoded(texts)};
}

std::optional<optim::Service> service_of_sweep(const std::string& sent) {
  const auto texts = optim::decoded_texts(sent);
  if (!texts || texts->size() % 2 == 0 || texts->front() != kSweepWork) return {};
  optim::StudySettings settings;
  for (std::size_t i = 1; i < texts->size(); i += 2) settings[(*texts)[i]] = (*texts)[i + 1];
  const std::string mine = problem_versions(), its = find_setting(settings, "versions");
  if (its != mine) {
    throw std::invalid_argument(
        fmt::format("the worker program is of {}, the caller of {}", mine, its));
  }
  return sweep_service(SweepStudy::of(settings));
}

}  // namespace camlaw::problems
