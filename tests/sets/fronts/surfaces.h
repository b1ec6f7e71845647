// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "optim/problem/problem.h"

/// Problems with three objectives or more whose fronts are known point by point: to measure by how
/// evenly a search covers them.
///
/// Sources: DTLZ2 and DTLZ7: Deb, Thiele, Laumanns, Zitzler, CEC 2002. Inverted simplex: after
/// Jain and Deb, IEEE Transactions on Evolutionary Computation 18 (2014) 602.
namespace camlaw::sets {

struct KnownSurface {
  optim::Problem problem;
  /// The costs for numbers from 0 to 1, `parameters` of them: all of the front and nothing else.
  std::function<std::vector<double>(const std::vector<double>&)> costs;
  std::size_t parameters = 0;
  bool is_connected = true;
};

/// "sphere" (DTLZ2), "inverted" (a simplex that points away from the ideal), "centres" (squares of
/// the distances from a simplex' corners; convex), "patches" (DTLZ7: 2^(objectives - 1) of them),
/// "curve" (all objectives follow one variable). Throws std::invalid_argument for any other name
/// and for fewer than three objectives.
KnownSurface known_surface(const std::string& name, std::size_t objectives);

}  // namespace camlaw::sets
