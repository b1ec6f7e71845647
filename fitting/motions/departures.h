// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fitting/motions/law_fit.h"

/// Where measured samples depart from the law that was fitted to them: worn or damaged stretches.
namespace camlaw::problems {

/// Of the stroke: what less departs from a law than this is of no account.
inline constexpr double kLeastDeparture = 2e-5;

/// A stretch of neighbouring samples on one side of the law.
struct Departure {
  double from, to;    ///< places
  double most;        ///< the largest difference, samples less law, of a curve through neighbours
  std::size_t count;  ///< of samples
};

/// Stretches in which the mean of nine neighbouring samples lies more than 4.5 standard deviations
/// of such a mean off the law, `noise` being that of one sample: in 1000 samples of the law itself
/// chance makes one in about a hundredth of all cases. Each is told half a window wider, and those
/// on one side that meet as one. Its largest difference is that of parabolas through nine
/// neighbours (Savitzky and Golay 1964); what is within the samples' resolution is no departure.
/// None where more than half of the samples departs: then it is not the law that the others follow.
std::vector<Departure> departures(const MotionSamples& samples, const LawFit& fit, double noise);

/// Whether a place lies in one of the stretches, in a cycle that begins anew after `period` (0: not
/// at all).
bool departs(double place, const std::vector<Departure>& stretches, double period = 0);

/// Samples without those that depart.
MotionSamples without(const MotionSamples& samples, const std::vector<Departure>& stretches,
                      double period = 0);

}  // namespace camlaw::problems
