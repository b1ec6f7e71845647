// SPDX-License-Identifier: MIT
#include "tests/sets/hock_schittkowski/problems.h"

#include <fmt/format.h>

#include <iterator>
#include <string>

#include "tests/sets/hock_schittkowski/parts.h"

namespace camlaw::sets {
namespace hock_schittkowski {
namespace {

optim::Response response(optim::Function function, std::string name = {}) {
  return {.name = std::move(name), .measure = std::move(function)};
}

}  // namespace

optim::Constraint zero(optim::Function function) {
  return {.response = response(std::move(function)), .lower = 0, .upper = 0};
}

optim::Constraint at_least(double bound, optim::Function function) {
  return {.response = response(std::move(function)), .lower = bound};
}

optim::Constraint at_most(double bound, optim::Function function) {
  return {.response = response(std::move(function)), .upper = bound};
}

optim::Problem problem(int number, const std::vector<Row>& rows, optim::Function objective,
                       Answer answer, std::vector<optim::Constraint> constraints) {
  optim::Problem result{.name = fmt::format("HS{}", number),
                        .variables = {},
                        .objectives = {{.response = response(std::move(objective), "f")}},
                        .constraints = std::move(constraints)};
  for (const Row& row : rows) {
    result.variables.push_back({.name = fmt::format("x{}", result.variables.size() + 1),
                                .lower = row.lower,
                                .upper = row.upper,
                                .start = row.start});
  }
  for (std::size_t i = 0; i < result.constraints.size(); ++i) {
    result.constraints[i].response.name = fmt::format("c{}", i + 1);
  }
  result.known = {.objective = answer.objective,
                  .x = std::move(answer.x),
                  .source = fmt::format("Hock and Schittkowski 1981, problem {}", number)};
  return result;
}

}  // namespace hock_schittkowski

std::vector<optim::Problem> hock_schittkowski_problems() {
  using namespace hock_schittkowski;
  std::vector<optim::Problem> all;
  for (auto* list : {two_variables, three_variables, four_variables, more_variables}) {
    auto problems = list();
    std::move(problems.begin(), problems.end(), std::back_inserter(all));
  }
  return all;
}

}  // namespace camlaw::sets
