// SPDX-License-Identifier: MIT
#include "problems/fronts/study_worker.h"

#include <cstdlib>
#include <memory>
#include <stdexcept>

#include "numerics/own_files.h"
#include "optim/search/search_task.h"
#include "optim/study/encoding.h"
#include "problems/fronts/problem_settings.h"
#include "problems/fronts/sent_settings.h"

namespace camlaw::problems {
namespace {

constexpr const char* kName = "camlaw-worker";

/// What a worker is to do, as the first text says it.
constexpr const char *kFront = "front", *kJoined = "joined fronts", *kOptimum = "optimum";

}  // namespace

std::string worker_path() {
  if (const char* named = secure_getenv(kWorkerVariable)) return named;
  return own_program(kName).value_or(kName);  // which fails with a message that names it
}

optim::WorkerProgram worker_program(const FrontStudy& study) {
  std::vector<std::string> texts{kFront};
  add_settings_to(texts, study.settings());
  return {worker_path(), optim::encoded(texts)};
}

optim::WorkerProgram worker_program(const ProblemStatement& statement) {
  std::vector<std::string> texts{kOptimum};
  add_settings_to(texts, problem_settings(statement));
  return {worker_path(), optim::encoded(texts)};
}

optim::ProblemSpace JoinedStudies::space() const {
  std::vector<optim::ProblemSpace> spaces;
  for (const FrontStudy& study : studies) spaces.push_back(study.space());
  return optim::joined(choice, names, spaces);
}

optim::WorkerProgram worker_program(const JoinedStudies& joined) {
  std::vector<std::string> texts{kJoined, joined.choice};
  for (std::size_t i = 0; i < joined.names.size(); ++i) {
    texts.push_back(joined.names[i]);
    add_settings_to(texts, joined.studies[i].settings());
  }
  return {worker_path(), optim::encoded(texts)};
}

optim::Service service_of_worker(const std::string& problem) {
  const auto texts = optim::decoded_texts(problem);
  if (!texts || texts->empty()) throw std::invalid_argument("what was sent is not a study");
  SentTexts reader(*texts);
  const std::string what = reader.text();
  if (what == kOptimum) {
    return optim::search_service(std::make_shared<optim::SearchDesk>(
        BoundProblem(stated_problem(reader.settings())).space()));
  }
  if (what == kFront) return optim::study_service(FrontStudy::of(reader.settings()).space());
  if (what != kJoined) throw std::invalid_argument("what was sent is not a study");
  const std::string choice = reader.text();
  std::vector<std::string> names;
  std::vector<FrontStudy> studies;
  while (!reader.at_end()) {
    names.push_back(reader.text());
    studies.push_back(FrontStudy::of(reader.settings()));
  }
  return optim::study_service(JoinedStudies{choice, names, studies}.space());
}

}  // namespace camlaw::problems
