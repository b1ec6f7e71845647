// SPDX-License-Identifier: MIT
#include "problems/fronts/study_worker.h"

#include <fmt/format.h>

#include <cstdlib>
#include <iterator>
#include <stdexcept>

#include "numerics/own_files.h"
#include "optim/study/encoding.h"

namespace camlaw::problems {
namespace {

constexpr const char* kName = "camlaw-worker";

/// The texts of a study: how many settings, then name and text of each.
void add(std::vector<std::string>& texts, const FrontStudy& study) {
  const optim::StudySettings settings = study.settings();
  texts.push_back(fmt::format("{}", settings.size()));
  for (const auto& [name, text] : settings) texts.insert(texts.end(), {name, text});
}

class Reader {
 public:
  explicit Reader(const std::vector<std::string>& texts) : texts_(texts) {}
  bool at_end() const { return next_ == texts_.size(); }
  const std::string& text() { return texts_.at(next_++); }
  FrontStudy study() {
    optim::StudySettings settings;
    for (std::size_t left = std::stoul(text()); left > 0; --left) {
      const std::string& name = text();
      settings[name] = text();
    }
    FrontStudy study = FrontStudy::of(settings);
    const std::string mine = study.settings().at("versions");
    if (settings["versions"] == mine) return study;
    throw std::invalid_argument(
        fmt::format("the worker program is of {}, the caller of {}", mine, settings["versions"]));
  }

 private:
  const std::vector<std::string>& texts_;
  std::size_t next_ = 0;
};

}  // namespace

std::string worker_path() {
  if (const char* named = secure_getenv(kWorkerVariable)) return named;
  return own_program(kName).value_or(kName);  // which fails with a message that names it
}

optim::WorkerProgram worker_program(const FrontStudy& study) {
  std::vector<std::string> texts{""};
  add(texts, study);
  return {worker_path(), optim::encoded(texts)};
}

optim::ProblemSpace JoinedStudies::space() const {
  std::vector<optim::ProblemSpace> spaces;
  for (const FrontStudy& study : studies) spaces.push_back(study.space());
  return optim::joined(choice, names, spaces);
}

optim::WorkerProgram worker_program(const JoinedStudies& joined) {
  std::vector<std::string> texts{joined.choice};
  for (std::size_t i = 0; i < joined.names.size(); ++i) {
    texts.push_back(joined.names[i]);
    add(texts, joined.studies[i]);
  }
  return {worker_path(), optim::encoded(texts)};
}

optim::ProblemSpace space_of_worker(const std::string& problem) {
  const auto texts = optim::decoded_texts(problem);
  if (!texts) throw std::invalid_argument("what was sent is not a study");
  Reader reader(*texts);
  const std::string choice = reader.text();
  if (choice.empty()) return reader.study().space();
  std::vector<std::string> names;
  std::vector<FrontStudy> studies;
  while (!reader.at_end()) {
    names.push_back(reader.text());
    studies.push_back(reader.study());
  }
  return JoinedStudies{choice, names, studies}.space();
}

}  // namespace camlaw::problems
