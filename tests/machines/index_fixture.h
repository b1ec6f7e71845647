// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "machines/registry.h"
#include "optim/problem/curve.h"
#include "problems/statement/bind.h"
#include "problems/statement/statement.h"

namespace camlaw::problems::testing {

/// The curves of a statement at `points` + 1 even places of the turn, each worked out where it is
/// asked for: those of a table's train take a hundred times as long as others.
class Curves {
 public:
  Curves(const ProblemStatement& statement, int points)
      : statement_(std::make_shared<const ProblemStatement>(statement)),
        responses_(curves_of(*statement_)),
        points_(points) {}

  const std::vector<double>& operator[](const std::string& name) const {
    const auto [at, is_new] = known_.try_emplace(name);
    if (is_new) at->second = values_of(name);
    return at->second;
  }

 private:
  std::vector<double> values_of(const std::string& name) const {
    for (const optim::Response& response : responses_) {
      if (response.name != name) continue;
      const auto trace = response.curve().trace({});
      const std::vector<double> breaks = trace->breaks();
      return trace->values(optim::even_places(breaks.front(), breaks.back(), points_));
    }
    throw std::out_of_range("no curve " + name);
  }

  std::shared_ptr<const ProblemStatement> statement_;  ///< which the responses may look at
  std::vector<optim::Response> responses_;
  int points_;
  mutable std::map<std::string, std::vector<double>> known_ = {};
};

/// A drive without the responses of the table's train, of which elastic_index_test.cpp takes care,
/// and without the life of its rollers (turret_life_test.cpp).
inline Mechanism rigid_drive(const char* name) {
  Mechanism drive = find_mechanism(name);
  std::erase_if(drive.responses, [](const MechanismResponse& response) {
    return response.name == "life" || response.name == "equivalent_load" ||
           response.name == "residual_amplitude" || response.name.starts_with("end_") ||
           response.name.starts_with("train_") || response.name.starts_with("elastic_");
  });
  return drive;
}

/// What a statement is refused with; empty where it is read.
inline std::string refusal_of(const std::string& text) {
  try {
    read_problem(text, "refused.toml");
  } catch (const std::invalid_argument& refused) {
    return refused.what();
  }
  return "";
}

}  // namespace camlaw::problems::testing
