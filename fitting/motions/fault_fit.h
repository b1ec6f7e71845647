// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <functional>

#include "fitting/motions/record_faults.h"

/// A fault of a record fitted along with the laws of its motions.
namespace camlaw::problems {

/// A record without a fault of some size, and what more of the fault would do to it.
struct WithoutFault {
  MotionSamples samples;
  PossibleFault fault;
};
/// Impossible where nothing is left, as where the follower cannot follow.
using TakeOut = std::function<Possible<WithoutFault>(const Eigen::VectorXd& size)>;

/// What laws were found for each motion, all that were tried.
struct RankedMotions {
  std::vector<std::vector<LawFit>> rankings;
  std::vector<MotionSamples> samples;
  std::vector<std::string> untried = {};  ///< laws that the deadline left no time for

  std::size_t count() const;  ///< of all samples
};

struct FaultFit {
  Eigen::VectorXd size;
  Eigen::MatrixXd covariance;
  double score = 0;       ///< of test_fault, with the fault
  std::size_t count = 0;  ///< of the samples that it was found by
  std::vector<std::string> untried = {};
};

/// Steps of Gauss and Newton for the fault and the laws of all motions together, from a size; the
/// laws are those that are best with it, some of these without coefficients. `first`: laws about
/// the start where they are known already. Impossible where the samples do not determine the fault,
/// and as take_out and possible_motions are.
Possible<FaultFit> fit_fault(const TakeOut& take_out, Eigen::VectorXd start,
                             const std::vector<Member>& laws, const LawFitOptions& options,
                             const RankedMotions* first = nullptr);

/// The test of a fault that may be large, so that one step does not lead to it: with a fault as far
/// off as the samples say, and laws without coefficients. The others follow much of what a fault
/// makes of a law, and do not lead to it. Its gain where it cannot be found is 0.
FaultTest followed(const FaultTest& test, const RankedMotions& motions, const TakeOut& take_out,
                   const LawFitOptions& options);

/// The centre about which a record of a whole turn was taken.
struct Centre {
  std::complex<double> place;  ///< in the unit of the fault's unknowns
  Eigen::Matrix2d covariance;  ///< of x and y
  std::vector<std::string> untried = {};

  double x_error() const;
  double y_error() const;
};

/// Begins with the dwells, in which nothing but the centre moves the samples. Throws
/// std::invalid_argument where fit_fault is impossible.
Centre find_centre(const TakeOut& take_out, const std::vector<Member>& laws,
                   const LawFitOptions& options);

}  // namespace camlaw::problems
