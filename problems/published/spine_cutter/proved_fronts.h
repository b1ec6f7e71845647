// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <functional>
#include <string>

#include "optim/pareto/pareto.h"
#include "problems/published/spine_cutter/study.h"

/// What a small cam costs in force, at best: fronts over (R, F), each point proved.
namespace camlaw::problems {

/// The front of several law families together, or of the free law.
struct ProvedFront {
  std::string name;
  optim::Front front;             ///< cam radius in mm against the physical peak force in N
  std::vector<std::string> laws;  ///< of each point, in a few words
  /// Its hypervolume as a share of that of the analytic limit, from the same reference; of the free
  /// law with mixtures of neighbouring designs, which are free laws as well.
  double share_of_limit = 0;
};

/// How much better than a published law the free law is, each optimum certified.
struct Saving {
  std::string law;
  double cam_radius, inertia_force;          ///< of the law, mm and N
  double least_radius = 0, least_force = 0;  ///< of the free law at the same force, radius
  optim::Verdict radius_verdict, force_verdict;
};

struct SpineCutterFronts {
  ProvedFront families;         ///< all that come to rest at both turns
  ProvedFront smooth;           ///< those of continuous acceleration through both turns
  ProvedFront free;             ///< quadratic splines on 64 even knots
  std::vector<Saving> savings;  ///< of the paper's choices, cosine and polynomial-5 alpha = -3
};

/// Told which front is looked for, and which share of all the work is done, 0 .. 1.
using FrontsProgress = std::function<void(const std::string& front, double done)>;

/// `workers` processes search side by side; the answer does not depend on them. Throws
/// optim::Interrupted where `stop` is set before the end.
SpineCutterFronts prove_fronts(const CutterGivens& cutter, int workers,
                               const FrontsProgress& progress = {},
                               const std::atomic<bool>* stop = nullptr);

}  // namespace camlaw::problems
