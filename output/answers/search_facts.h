// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "optim/search/optimise.h"
#include "output/document/json.h"

namespace camlaw::cli {

/// What is said of something, each with its name.
using Facts = std::vector<std::pair<std::string, std::string>>;

/// What a result says of the search that found it: solver, why, seed, starts, evaluations.
Facts facts_of_search(const Json& result);

/// How many of several starts ended at the objective of an answer.
std::string words_of_starts(const optim::Found& found);

}  // namespace camlaw::cli
