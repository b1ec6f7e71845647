// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <functional>
#include <random>
#include <vector>

#include "machines/model/recorded_response.h"
#include "machines/registry.h"

/// The formulas of every machine, recorded, and numbers to try them at.
namespace camlaw::problems::testing {

inline Formula record_of(const Mechanism& mechanism, const MechanismResponse& response) {
  return whole_formula(response.write, mechanism.parameters.size(), other_names(response).size());
}

/// Calls look for each response that has one formula.
inline void for_each_formula(
    const std::function<void(const Mechanism&, const MechanismResponse&)>& look) {
  int looked_at = 0;
  for (const Mechanism& mechanism : mechanisms()) {
    for (const MechanismResponse& response : mechanism.responses) {
      if (!response.write) continue;
      INFO(mechanism.name << " " << response.name);
      look(mechanism, response);
      ++looked_at;
    }
  }
  CHECK(looked_at > 200);
}

/// Numbers that parameters and a motion may have, about their usual ones.
inline std::vector<double> some_inputs(const Mechanism& mechanism,
                                       const MechanismResponse& response, std::mt19937_64& random) {
  std::uniform_real_distribution<double> about(0.8, 1.2), motion(-2, 2);
  std::vector<double> u;
  for (const MechanismParameter& p : mechanism.parameters) {
    u.push_back(p.default_value * about(random));
  }
  for (std::size_t i = 0; i < other_names(response).size(); ++i) {
    u.push_back(response.curve ? motion(random) : 10 * about(random));
  }
  return u;
}

/// The same with small numbers, as far as they are accepted, in place of parameters that are 0
/// unless somebody states them, such as friction.
inline std::vector<double> without_zeros(const Mechanism& mechanism, std::vector<double> u,
                                         std::mt19937_64& random) {
  std::uniform_real_distribution<double> small(0.05, 0.15);
  for (std::size_t i = 0; i < mechanism.parameters.size(); ++i) {
    const MechanismParameter& p = mechanism.parameters[i];
    if (u[i] == 0) u[i] = std::clamp(small(random), p.low, p.high);
  }
  return u;
}

}  // namespace camlaw::problems::testing
