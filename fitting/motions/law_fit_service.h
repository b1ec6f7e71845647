// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fitting/motions/law_fit.h"
#include "optim/crew/crew.h"

/// Fits of laws as orders that any process can carry out (optim/crew/crew.h).
namespace camlaw::problems {

/// What fits of many laws have in common, as bytes: the samples, and how they are fitted.
std::string samples_of_orders(const MotionSamples& samples, const MotionGuess& guess,
                              const LawFitOptions& options);

/// One law to be fitted, as bytes; `samples` are those of samples_of_orders().
std::string law_fit_order(const std::string& samples, const Member& law,
                          const LawFitOptions& options);

/// What came of the order; none where the law cannot be fitted. `law` as it was ordered. Throws
/// std::runtime_error for what is no such answer.
std::optional<LawFit> law_fit_answer(const std::string& answer, const Member& law);

/// Carries such orders out. `laws` are known beside those of the catalogue.
optim::Service law_fit_service(const std::vector<Member>& laws);

/// How a process is started that carries such orders out.
optim::WorkerProgram law_fit_program();
/// What a worker program does for what it was sent: this, or what problems::service_of_worker()
/// does. Throws std::invalid_argument as that does.
optim::Service service_of_worker_or_fits(const std::string& problem);

}  // namespace camlaw::problems
