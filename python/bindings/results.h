// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "output/answers/claim_output.h"
#include "problems/results/recorded_design.h"
#include "python/bindings/values.h"

namespace camlaw::python {

/// A design that was found, as a result has it: what --json gives, and what the design is.
struct StoredResult {
  problems::Json facts;                             ///< with the checksum
  std::optional<problems::ReadDesign> design = {};  ///< none where the model gave no design
  /// What is said of a search, in words and as a notebook shows it; a file has facts alone.
  std::optional<std::string> text = {}, html = {};
  std::string file = {};  ///< as it was named
  /// Of a search, what was found in each combination of choices, the best first; a list of objects.
  problems::Json combinations = problems::Json::array();
  /// Draws what was limited and sought, over the cycle; of a search alone.
  std::function<cli::Figure()> cycle = {};

  void say(const cli::Document& document);
};

/// A result of these facts, which it seals, for a design that a problem's statement has.
StoredResult result_of(problems::Json facts, problems::ReadDesign design);

}  // namespace camlaw::python
