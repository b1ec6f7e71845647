// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fitting/motions/readings.h"

/// How the samples of a cam's motion may be divided into stretches that follow a law and others
/// that depart from it, before laws are fitted to them (docs/optimisation.md, "Worn cams").
namespace camlaw::problems {

/// More worn regions leave too little of a motion to tell its law.
inline constexpr std::size_t kMostStretches = 2;

/// A law with windows, before it is fitted without them.
struct Sketch {
  std::size_t law;  ///< in the ranking
  std::vector<Departure> windows;
  double score;
};

/// Each law as it is and with windows, narrow ones and wide ones: what the ends of a stretch make
/// of the samples a law may follow.
std::vector<Sketch> sketches_of(const FoundMotion& motion, const std::vector<LawFit>& ranking,
                                const Scatter& scatter);

/// (WR1) without what tells up from down; `squares`: those outside with the scatter left out.
double departure_score(double squares, std::size_t samples, const LawFit& law,
                       std::size_t stretches);

/// Whether the samples outside the stretches show the motion and the rests beside it.
bool shows_motion(const MotionSamples& samples, const LawFit& law,
                  const std::vector<Departure>& departures);

}  // namespace camlaw::problems
