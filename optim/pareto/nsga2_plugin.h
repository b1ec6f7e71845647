// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

/// Between the library and the plug-in that has NSGA-II: plain C, as the plug-in is loaded by name.
/// Bounds are finite, the last `integers` of the genes are integers between integer bounds.
struct CamlawEvolved {
  std::size_t genes, integers, objectives;
  const double* lower;
  const double* upper;
  std::size_t population;  ///< a multiple of four
  unsigned generations, seed;
  void* self;
  /// Writes the costs of a design; throws nothing.
  void (*measure)(void* self, const double* genes, double* costs);
  /// Takes a design of the last generation; throws nothing.
  void (*take)(void* self, const double* genes, const double* costs);
};

/// The function's name; its number grows when what is passed changes.
#define CAMLAW_NSGA2 camlaw_nsga2_1

extern "C" {
/// Evolves and hands over the last generation. Null, or what went wrong, which lives until the
/// thread's next call.
const char* CAMLAW_NSGA2(const CamlawEvolved* evolved);
using CamlawNsga2 = const char* (*)(const CamlawEvolved* evolved);
}
