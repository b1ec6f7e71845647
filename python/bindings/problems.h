// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "problems/statement/bind.h"
#include "python/bindings/running.h"
#include "python/bindings/values.h"

namespace camlaw::python {

/// A problem as it is stated, with what was set beside its text.
struct StatedProblem {
  problems::ProblemStatement statement;

  /// The statement for work that may be stopped; it must not outlive the work.
  problems::ProblemStatement within(const Work& work) const {
    problems::ProblemStatement result = statement;
    result.stop = work.stop();
    return result;
  }
};

/// A limit as it stands, by the words that the program has for it.
nb::dict dict_of(const optim::LimitReport& limit);
nb::list list_of(const std::vector<optim::LimitReport>& limits);

/// Every curve of the design at count + 1 even places: the place first, then each curve with its
/// unit, as 'camlaw evaluate --curves' writes them.
nb::dict curves_of(const StatedProblem& problem, int count);

}  // namespace camlaw::python
