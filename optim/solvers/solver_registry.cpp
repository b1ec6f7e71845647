// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <mutex>
#include <stdexcept>

#include "optim/solvers/solver.h"

/// The solvers by name: camlaw's own and those that a program registers.
namespace camlaw::optim {

/// The back ends in the order of their listing, a line for each: its name, after which the function
/// that has it is called (clp_solver), which the back end's file defines. NLopt's methods follow.
#define CAMLAW_BACK_ENDS(BACK_END) \
  BACK_END(ipopt)                  \
  BACK_END(clp)                    \
  BACK_END(interior)               \
  BACK_END(sequential)

#define CAMLAW_DECLARED(name) const Solver& name##_solver();
CAMLAW_BACK_ENDS(CAMLAW_DECLARED)
#undef CAMLAW_DECLARED

namespace {

/// A solver by the name that it was registered with, so that none can change it afterwards.
struct Named {
  std::string name;
  const Solver* solver;
};

struct Registry {
  std::mutex mutex;
  std::vector<Named> all;
  std::size_t built_in = 0;  ///< of all, the first
  std::vector<std::unique_ptr<const Solver>>
      owned;  ///< none is ever let go: searches refer to them
};

/// Never destroyed: at the program's end other threads may still search.
Registry& registry() {
  static Registry& known = *[] {
    auto* made = new Registry;
    const auto add = [&](const Solver& solver) { made->all.push_back({solver.name(), &solver}); };
#define CAMLAW_ADDED(name) add(name##_solver());
    CAMLAW_BACK_ENDS(CAMLAW_ADDED)
#undef CAMLAW_ADDED
    for (const Solver* solver : nlopt_solvers()) add(*solver);
    made->built_in = made->all.size();
    return made;
  }();
  return known;
}

std::vector<Named> all_solvers() {
  const std::lock_guard lock(registry().mutex);
  return registry().all;
}

/// Names that read_problem would take for something else.
bool is_word_of_files(std::string_view name) {
  constexpr std::string_view kWords[] = {"auto", "name", "starts", "seed", "time_limit"};
  return std::find(std::begin(kWords), std::end(kWords), name) != std::end(kWords);
}

bool is_well_formed(std::string_view name) {
  const auto is_letter = [](char c) { return c >= 'a' && c <= 'z'; };
  return !name.empty() && is_letter(name.front()) &&
         std::all_of(name.begin(), name.end(),
                     [&](char c) { return is_letter(c) || c == '-' || (c >= '0' && c <= '9'); });
}

auto named(const std::vector<Named>& all, std::string_view name) {
  return std::find_if(all.begin(), all.end(), [&](const Named& n) { return n.name == name; });
}

}  // namespace

std::vector<std::string> solver_names() {
  std::vector<std::string> names;
  for (const Named& known : all_solvers()) names.push_back(known.name);
  return names;
}

const Solver& find_solver(std::string_view name) {
  const std::vector<Named> all = all_solvers();
  if (const auto found = named(all, name); found != all.end()) return *found->solver;
  throw std::invalid_argument(
      fmt::format("'{}' is not a solver; use one of {}", name, fmt::join(solver_names(), ", ")));
}

void register_solver(std::unique_ptr<const Solver> solver) {
  if (solver == nullptr) throw std::invalid_argument("no solver was given to register");
  const std::string name = solver->name();
  if (is_word_of_files(name)) {
    throw std::invalid_argument(
        fmt::format("a solver cannot be called '{}': the word has a meaning in [solver]", name));
  }
  if (!is_well_formed(name)) {
    throw std::invalid_argument(fmt::format(
        "a solver cannot be called '{}': a name has the letters a to z, digits and -, and begins "
        "with a letter",
        name));
  }
  Registry& known = registry();
  const std::lock_guard lock(known.mutex);
  if (named(known.all, name) != known.all.end()) {
    throw std::invalid_argument(fmt::format("a solver is called '{}' already", name));
  }
  known.owned.reserve(known.owned.size() + 1);  // so that nothing is half registered
  known.all.push_back({name, solver.get()});
  known.owned.push_back(std::move(solver));
}

bool is_registered(std::string_view name) {
  const std::lock_guard lock(registry().mutex);
  const auto found = named(registry().all, name);
  return found != registry().all.end() &&
         static_cast<std::size_t>(found - registry().all.begin()) >= registry().built_in;
}

}  // namespace camlaw::optim
