// SPDX-License-Identifier: MIT
#include "optim/solvers/solver.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>

namespace camlaw::optim {
namespace {

std::vector<const Solver*> all_solvers() {
  std::vector<const Solver*> all{&ipopt_solver()};
  all.insert(all.end(), nlopt_solvers().begin(), nlopt_solvers().end());
  return all;
}

}  // namespace

std::string_view to_string(Status status) {
  switch (status) {
    case Status::Solved:
      return "solved";
    case Status::Acceptable:
      return "solved to a looser tolerance";
    case Status::Stalled:
      return "stalled";
    case Status::IterationLimit:
      return "limit of iterations";
    case Status::TimeLimit:
      return "time limit";
    case Status::Infeasible:
      return "infeasible";
    case Status::Unbounded:
      return "unbounded";
    case Status::NonFiniteStart:
      return "not a number at the start";
    case Status::Stopped:
      return "stopped";
    case Status::Failed:
      return "failed";
  }
  return "?";
}

std::vector<std::string> solver_names() {
  std::vector<std::string> names;
  for (const Solver* solver : all_solvers()) names.push_back(solver->name());
  return names;
}

const Solver& find_solver(std::string_view name) {
  for (const Solver* solver : all_solvers()) {
    if (solver->name() == name) return *solver;
  }
  throw std::invalid_argument(
      fmt::format("no solver is called '{}'; there are {}", name, fmt::join(solver_names(), ", ")));
}

std::vector<std::string> solver_versions() { return {ipopt_version(), nlopt_version()}; }

}  // namespace camlaw::optim
