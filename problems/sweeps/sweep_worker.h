// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "optim/study/workers.h"
#include "problems/sweeps/sweep_study.h"

/// Sweeps sent to processes that are started afresh (problems/fronts/study_worker.h).
namespace camlaw::problems {

/// What a worker does for a sweep. Holds the study.
optim::Service sweep_service(SweepStudy study);

/// How a process is started that works on a sweep.
optim::WorkerProgram worker_program(const SweepStudy& study);

/// What a worker program does for a sweep that it was sent; none where it was sent something else.
/// Throws std::invalid_argument where it comes from another version of camlaw or its libraries.
std::optional<optim::Service> service_of_sweep(const std::string& sent);

}  // namespace camlaw::problems
