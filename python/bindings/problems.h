// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <tuple>
#include <utility>
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

/// A law's family, and the values of its parameters.
using ArgumentsState = std::pair<std::string, std::vector<std::vector<double>>>;
/// A part of a catalogue and the row that was chosen for it.
using PartState = std::pair<std::string, std::string>;
/// All of a problem: its text, what it is called, what was set beside it, and the files that were
/// read with it, laws as JSON and tables by path; of the design that it stands at the values of the
/// mechanism's parameters, the starts of the variables, the laws, and the parts that are chosen.
using ProblemState =
    std::tuple<std::string, std::string, std::vector<std::string>, std::string,
               std::map<std::string, std::string>, std::vector<double>, std::vector<double>,
               std::vector<ArgumentsState>, std::vector<PartState>>;
ProblemState state_of(const StatedProblem& problem);
StatedProblem problem_of(const ProblemState& state);

/// Every curve of the design at count + 1 even places: the place first, then each curve with its
/// unit, as 'camlaw evaluate --curves' writes them.
nb::dict curves_of(const StatedProblem& problem, int count);

}  // namespace camlaw::python
