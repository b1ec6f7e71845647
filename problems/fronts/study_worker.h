// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "optim/study/workers.h"
#include "problems/fronts/front_study.h"

/// Studies of problem files sent to processes that are started afresh (optim/study/workers.h).
namespace camlaw::problems {

/// The environment variable that names the worker program.
inline constexpr const char* kWorkerVariable = "CAMLAW_WORKER";

/// Where the worker program is: as kWorkerVariable says; else camlaw-worker beside the running
/// program, or in libexec/camlaw next to its folder, or where this build or the Debian package
/// installs it. A bare name, which cannot be started, where it is in none of these.
std::string worker_path();

/// How a process is started that works on a study.
optim::WorkerProgram worker_program(const FrontStudy& study);

/// How one is started that searches for the optimum of a problem, as it was read and set.
optim::WorkerProgram worker_program(const ProblemStatement& statement);

/// Several studies as one, optim::joined() by the same names.
struct JoinedStudies {
  std::string choice;
  std::vector<std::string> names;
  std::span<const FrontStudy> studies;

  optim::ProblemSpace space() const;
};
optim::WorkerProgram worker_program(const JoinedStudies& joined);

/// What a worker program does for the problem that it was sent. Throws std::invalid_argument where
/// it comes from another version of camlaw or its libraries, and where a law file is not what it
/// was.
optim::Service service_of_worker(const std::string& problem);

}  // namespace camlaw::problems
