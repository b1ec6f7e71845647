// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fitting/motions/motion_fit.h"

/// What may be wrong with all samples of a record together: it drifts, the cam sat off its centre,
/// a size of the follower was forgotten (docs/optimisation.md, "Faults of a record").
namespace camlaw::problems {

enum class FaultKind {
  Drift,      ///< the zero moves from the begin of the record to its end
  OffCentre,  ///< once round per turn: the cam's centre lies elsewhere
  OwnSize,    ///< a size of the follower is another one
};

/// A fault of unknown size: by how much one of each of its unknowns changes the sample at a place.
struct PossibleFault {
  FaultKind kind;
  std::vector<std::string> names;  ///< of its unknowns
  std::vector<std::function<double(double place)>> by;
  /// Where it jumps: here, and every `jump_period` before and after; 0: nowhere.
  double jump = 0, jump_period = 0;
  /// Steps from 0 may not lead to the right size, as where the sign of the stated one is wrong.
  bool may_be_far = false;
};

/// The drift of a record whose first place is `first` and which goes over `range`; the unknown is
/// what the zero has moved by at its end. `period`: the record begins anew there; 0: not at all.
PossibleFault drift(double first, double range, double period);
/// Once round per turn: cosine and sine of the place in deg.
PossibleFault off_centre();

/// What the samples say of a fault.
struct FaultTest {
  PossibleFault fault;
  /// By how much the sum of the motions' scores, each of its best law, falls with the fault fitted
  /// along, to first order; below 0 where it rises.
  double gain = 0;
  double score = 0;            ///< that sum with it
  Eigen::VectorXd size;        ///< of its unknowns, by the laws that are best with it
  Eigen::MatrixXd covariance;  ///< of these
  /// A size that is surely not 0 with which laws without coefficients tell the samples.
  bool with_plain_laws = false;
};

/// What laws with and without a fault are compared by, the less the better: of n samples, p numbers
/// and the sum of squares that is left.
struct FaultScore {
  std::function<double(std::size_t n, std::size_t p, double sum)> of;
  bool weighted = true;  ///< squares count as the law's own fit has weighed them
};
FaultScore by_aicc();

/// How the laws of all motions of a cycle would fare with a fault fitted along. For law l with
/// residuals r, Jacobian J and the fault's columns E it is one step of Gauss and Newton:
///   r' = r less its part in the span of [J E].
FaultTest test_fault(const std::vector<std::vector<LawFit>>& rankings,
                     const std::vector<MotionSamples>& samples, PossibleFault fault,
                     const FaultScore& score = by_aicc());

/// Deviations and intervals of a law's numbers with the error of a fault that was fitted along and
/// taken out of the samples: what the numbers follow of it, K = J^+ E, adds K C K^T to their
/// covariance, C being the fault's.
void widen(LawFit& fit, const MotionSamples& samples, const PossibleFault& fault,
           const Eigen::MatrixXd& covariance);

/// The gain in AICc from which on a fault is taken to be there; of one with which plain laws tell
/// the samples it is enough that these do as well.
inline constexpr double kGainOfFault = 8, kGainWithPlainLaws = -4;

/// Of the faults those that are seen, the likeliest first; others follow that explain the samples
/// nearly as well.
std::vector<FaultTest> seen_faults(std::vector<FaultTest> tests);

}  // namespace camlaw::problems
