// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace camlaw::optim {

/// What NSGA-II evolves.
struct Evolution {
  std::vector<double> lower, upper;  ///< of the genes, finite
  std::size_t integers = 0;          ///< so many of the last genes are integers
  std::size_t objectives = 2;
  std::size_t population = 8;  ///< a multiple of four
  unsigned generations = 1, seed = 1;
  /// The costs of a design. What it throws ends the evolution and comes out of nsga2().
  std::function<std::vector<double>(const std::vector<double>& genes)> costs;
};

struct Evolved {
  std::vector<double> genes, costs;
};

/// The last generation of NSGA-II (Deb and others 2002; pagmo), the same for the same seed. The
/// method is a plug-in, camlaw-nsga2.so, that is loaded when it is first asked for. Throws as
/// require_nsga2() does.
std::vector<Evolved> nsga2(const Evolution& evolution);

/// Whether the plug-in is there.
bool has_nsga2();
/// Throws std::runtime_error, which names the plug-in and says why, where it is not.
void require_nsga2();

/// "pagmo 2.18.0", what the plug-in was built with; "no pagmo" where it was not built.
std::string pagmo_version();

}  // namespace camlaw::optim
