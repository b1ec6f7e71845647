// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "optim/crew/crew.h"
#include "optim/verdict/assessment.h"
#include "optim/verdict/tolerance.h"
#include "optim/verdict/yield.h"
#include "problems/tolerance/grid_rooms.h"
#include "problems/tolerance/worst_parts.h"

/// What becomes of a design that manufacture makes other than it is meant.
namespace camlaw::problems {

/// A limit at the nominal design.
struct LimitSlopes {
  optim::LimitReport report;
  std::vector<double> slopes;  ///< of its value by each number that varies, exact
};

struct ToleranceAnswer {
  std::vector<LimitSlopes> limits;
  /// Of each number that varies the limits that hold as meant and that it breaks by itself.
  std::vector<std::vector<std::size_t>> broken_alone;
  std::vector<WorstPart> worst;       ///< of each side of each limit
  std::vector<BreakFactor> factors;   ///< of each of these
  std::optional<optim::Yield> yield;  ///< none where there are no limits
  GridReport grid;
  optim::ToleranceReport spreads;
  std::optional<std::size_t> samples_asked = {};  ///< ToleranceOptions::samples
  std::string cut_short = {};  ///< why the work ended before its end; empty: it did not

  /// Whether it is proved that every part meets every limit, so that nothing fails; false where the
  /// worst parts are not known.
  bool nothing_fails(const std::vector<optim::Variation>& variations) const;
};

struct ToleranceOptions {
  /// Without: 100000, fewer where limits need a search for each part.
  std::optional<std::size_t> samples = {};
  std::size_t least = 0;  ///< without samples: no fewer than these
  std::uint64_t seed = 1;
  bool factors = true;
  optim::Hands hands = {};  ///< who counts the parts of the yield; nobody: the calling thread
};

/// The yield of the design's limits, and how it was worked out.
optim::Yield yield_of(const VariedDesign& varied, const ToleranceOptions& options,
                      GridReport& grid);

/// All of it, as far as the design's deadline lets it get.
ToleranceAnswer tolerance_of(const VariedDesign& varied, const ToleranceOptions& options = {});

}  // namespace camlaw::problems
