// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "machines/registry.h"
#include "optim/problem/curve.h"
#include "problems/statement/bind.h"
#include "problems/statement/statement.h"

namespace camlaw::problems::testing {

/// Every curve of a statement at `points` + 1 even places of the turn.
class Curves {
 public:
  Curves(const ProblemStatement& statement, int points) {
    for (const optim::Response& response : curves_of(statement)) {
      const auto trace = response.curve().trace({});
      const std::vector<double> breaks = trace->breaks();
      all_[response.name] =
          trace->values(optim::even_places(breaks.front(), breaks.back(), points));
    }
  }
  const std::vector<double>& operator[](const std::string& name) const { return all_.at(name); }

 private:
  std::map<std::string, std::vector<double>> all_;
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
