// SPDX-License-Identifier: MIT
#include "optim/pareto/nsga2.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <limits>
#include <stdexcept>
#include <utility>

#include "numerics/own_files.h"
#include "optim/pareto/nsga2_plugin.h"

#define CAMLAW_TEXT_OF(name) #name
#define CAMLAW_TEXT(name) CAMLAW_TEXT_OF(name)

namespace camlaw::optim {
namespace {

constexpr const char* kNsga2Plugin = "camlaw-nsga2.so";

struct Loaded {
  CamlawNsga2 function = nullptr;
  std::string why_not = {};
};

/// Stays loaded: the function is needed until the program ends.
Loaded load() {
  if (!CAMLAW_HAS_PAGMO) return {.why_not = "this build does not include it"};
  const auto path = own_file(kNsga2Plugin);
  if (!path) return {.why_not = "it is not installed"};
  void* plugin = dlopen(path->c_str(), RTLD_NOW | RTLD_LOCAL);
  void* function = plugin != nullptr ? dlsym(plugin, CAMLAW_TEXT(CAMLAW_NSGA2)) : nullptr;
  if (function != nullptr) return {.function = reinterpret_cast<CamlawNsga2>(function)};
  const char* error = dlerror();
  return {.why_not = error != nullptr ? error : "it has no such function"};
}

const Loaded& loaded() {
  static const Loaded once = load();
  return once;
}

/// What the plug-in calls. Its frames are C: what is thrown waits until they are left.
struct Callee {
  const Evolution& evolution;
  std::vector<Evolved> last = {};
  std::exception_ptr error = {};
};

void measure(void* self, const double* genes, double* costs) {
  auto& callee = *static_cast<Callee*>(self);
  const Evolution& evolution = callee.evolution;
  std::fill_n(costs, evolution.objectives, std::numeric_limits<double>::max());
  if (callee.error) return;
  try {
    const std::vector<double> own = evolution.costs({genes, genes + evolution.lower.size()});
    std::copy_n(own.begin(), std::min(own.size(), evolution.objectives), costs);
  } catch (...) {
    callee.error = std::current_exception();
  }
}

void take(void* self, const double* genes, const double* costs) {
  auto& callee = *static_cast<Callee*>(self);
  if (callee.error) return;
  const Evolution& evolution = callee.evolution;
  try {
    callee.last.push_back(
        {{genes, genes + evolution.lower.size()}, {costs, costs + evolution.objectives}});
  } catch (...) {
    callee.error = std::current_exception();
  }
}

}  // namespace

bool has_nsga2() { return loaded().function != nullptr; }

void require_nsga2() {
  if (has_nsga2()) return;
  throw std::runtime_error(
      fmt::format("NSGA-II is a plug-in, {}: {}", kNsga2Plugin, loaded().why_not));
}

std::vector<Evolved> nsga2(const Evolution& evolution) {
  require_nsga2();
  Callee callee{evolution};
  const CamlawEvolved asked{.genes = evolution.lower.size(),
                            .integers = evolution.integers,
                            .objectives = evolution.objectives,
                            .lower = evolution.lower.data(),
                            .upper = evolution.upper.data(),
                            .population = evolution.population,
                            .generations = evolution.generations,
                            .seed = evolution.seed,
                            .self = &callee,
                            .measure = measure,
                            .take = take};
  const char* error = loaded().function(&asked);
  if (callee.error) std::rethrow_exception(callee.error);
  if (error != nullptr) throw std::runtime_error(error);
  return std::move(callee.last);
}

std::string pagmo_version() { return CAMLAW_PAGMO; }

}  // namespace camlaw::optim
