// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "python/bindings/problems.h"

/// Problems as data that Python pickles.
namespace camlaw::python {

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
ProblemState problem_state_of(const StatedProblem& problem);
StatedProblem problem_of(const ProblemState& state);

}  // namespace camlaw::python
