// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "optim/problem/problem.h"

/// Problems with two or three objectives whose fronts are known, to prove the search for fronts by.
///
/// Sources: ZDT: Zitzler, Deb, Thiele, Evolutionary Computation 8 (2000) 173. DTLZ2: Deb, Thiele,
/// Laumanns, Zitzler, CEC 2002. Tanaka, Osyczka and Kundu, Srinivas and Deb: as collected in Deb,
/// Multi-Objective Optimization Using Evolutionary Algorithms, Wiley 2001, section 8.3.
namespace camlaw::sets {

struct KnownFront {
  optim::Problem problem;
  std::vector<double> reference;  ///< of the hypervolume
  double hypervolume;             ///< of the whole front: in closed form, or by its own formula
  /// Smooth, and with one valley for each point of the front: a sweep alone reaches it.
  bool smooth;
};

/// ZDT1 to 4 and 6, DTLZ2 with two and with three objectives, Tanaka, Osyczka, Srinivas.
std::vector<KnownFront> known_fronts();

/// Hypervolume of a front of two costs that is given as a dense list of points, in any order,
/// dominated ones among them.
double area_dominated(std::vector<std::pair<double, double>> points, double reference_x,
                      double reference_y);

}  // namespace camlaw::sets
