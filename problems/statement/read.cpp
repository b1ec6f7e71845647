// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

#include "optim/solvers/solver.h"
#include "problems/statement/reading.h"
#include "problems/statement/toml_reader.h"

namespace camlaw::problems {
namespace {

std::string known_mechanisms() {
  std::string names;
  for (const Mechanism& mechanism : mechanisms()) {
    names += (names.empty() ? "" : ", ") + mechanism.name;
  }
  return names;
}

std::string contents(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    throw std::invalid_argument(
        fmt::format("{}: it is a directory; a problem file is wanted", path));
  }
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  std::string text(std::istreambuf_iterator<char>(file), {});
  if (!file.is_open() || file.bad()) {
    throw std::invalid_argument(fmt::format("{}: it cannot be read: {}", path,
                                            errno != 0 ? std::strerror(errno) : "unknown cause"));
  }
  return text;
}

}  // namespace

void read_mechanism(const Entry& file, ProblemStatement& problem) {
  const Entry* name = find(file, "mechanism");
  if (name == nullptr) {
    refuse(file, fmt::format("mechanism is missing; there are {}", known_mechanisms()));
  }
  const std::string& text = text_of(*name);
  problem.mechanism = located(*name, [&] { return &find_mechanism(text); });
  for (const MechanismParameter& parameter : problem.mechanism->parameters) {
    problem.constants.push_back(parameter.standard);
  }
}

void read_solver(const Entry& file, ProblemStatement& problem) {
  const Entry* solver = find(file, "solver");
  if (solver == nullptr) return;
  expect(*solver, Entry::Kind::Table, "a table, [solver]");
  check_keys(*solver, {"name", "starts", "seed", "time_limit"});
  if (const Entry* name = find(*solver, "name")) {
    problem.solver.name = text_of(*name);
    located(*name, [&] { optim::find_solver(name->text); });
  }
  constexpr int kMostStarts = 1'000'000;
  if (const Entry* starts = find(*solver, "starts")) {
    problem.solver.starts = static_cast<int>(whole_of(*starts, 1, kMostStarts));
  }
  if (const Entry* seed = find(*solver, "seed")) {
    const auto most = std::numeric_limits<std::int64_t>::max();
    problem.solver.seed = static_cast<std::uint64_t>(whole_of(*seed, 0, most));
  }
  problem.solver.time_limit = find_positive(*solver, "time_limit", "s");
}

ProblemStatement read_problem(std::string_view toml, const std::string& source) {
  const Entry file = parse_toml(toml, source);
  if (file.items.empty()) {
    refuse(file, "it is empty; a problem names at least its mechanism and law");
  }
  check_keys(file, {"title", "mechanism", "constants", "law", "program", "variables", "objective",
                    "constraints", "solver"});
  ProblemStatement problem;
  if (const Entry* title = find(file, "title")) problem.title = text_of(*title);
  FixedNames fixed;
  read_mechanism(file, problem);
  read_laws(file, problem, fixed);
  read_constants(file, problem, fixed);
  read_variables(file, problem, fixed);
  check_laws_at_start(file, problem);
  read_objective(file, problem);
  read_constraints(file, problem);
  read_solver(file, problem);
  return problem;
}

ProblemStatement read_problem_file(const std::string& path) {
  return read_problem(contents(path), path);
}

}  // namespace camlaw::problems
