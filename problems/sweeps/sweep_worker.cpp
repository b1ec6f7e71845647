// SPDX-License-Identifier: MIT
#include "problems/sweeps/sweep_worker.h"

#include <memory>

#include "optim/study/encoding.h"
#include "problems/fronts/sent_settings.h"
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
  add_settings_to(texts, study.settings());
  return {worker_path(), optim::encoded(texts)};
}

std::optional<optim::Service> service_of_sweep(const std::string& sent) {
  const auto texts = optim::decoded_texts(sent);
  if (!texts || texts->empty() || texts->front() != kSweepWork) return {};
  SentTexts reader(*texts);
  reader.text();
  return sweep_service(SweepStudy::of(reader.settings()));
}

}  // namespace camlaw::problems
