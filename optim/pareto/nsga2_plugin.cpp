// SPDX-License-Identifier: MIT
// NSGA-II of pagmo as a plug-in: what does not ask for it needs no pagmo.
#include "optim/pareto/nsga2_plugin.h"

#include <cstdio>
#include <exception>
#include <pagmo/algorithm.hpp>
#include <pagmo/algorithms/nsga2.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>
#include <utility>
#include <vector>

namespace {

/// The problem as pagmo sees it, which copies it.
struct Evolved {
  const CamlawEvolved* asked = nullptr;

  std::vector<double> fitness(const std::vector<double>& genes) const {
    std::vector<double> costs(asked->objectives);
    asked->measure(asked->self, genes.data(), costs.data());
    return costs;
  }
  std::pair<std::vector<double>, std::vector<double>> get_bounds() const {
    return {{asked->lower, asked->lower + asked->genes},
            {asked->upper, asked->upper + asked->genes}};
  }
  std::vector<double>::size_type get_nobj() const { return asked->objectives; }
  std::vector<double>::size_type get_nix() const { return asked->integers; }
};

void evolve(const CamlawEvolved& asked) {
  // Crossover and mutation as Deb and others have them (2002), the latter's share pagmo's own.
  constexpr double kCrossover = 0.95, kCrossoverIndex = 10, kMutation = 0.1, kMutationIndex = 50;
  const pagmo::problem problem{Evolved{&asked}};
  const pagmo::algorithm method{pagmo::nsga2(asked.generations, kCrossover, kCrossoverIndex,
                                             kMutation, kMutationIndex, asked.seed)};
  const pagmo::population last =
      method.evolve(pagmo::population(problem, asked.population, asked.seed));
  for (std::size_t i = 0; i < last.size(); ++i) {
    asked.take(asked.self, last.get_x()[i].data(), last.get_f()[i].data());
  }
}

}  // namespace

extern "C" const char* CAMLAW_NSGA2(const CamlawEvolved* asked) {
  static thread_local char error[256];
  try {
    evolve(*asked);
    return nullptr;
  } catch (const std::exception& thrown) {
    std::snprintf(error, sizeof error, "%s", thrown.what());
  } catch (...) {
    std::snprintf(error, sizeof error, "something that is not a std::exception");
  }
  return error;
}
