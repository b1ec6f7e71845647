// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "machines/model/mechanism.h"
#include "optim/problem/deadline.h"
#include "optim/problem/problem.h"
#include "problems/statement/variation.h"

/// A design whose parameters manufacture makes other than they are meant: what varies of it is what
/// has a variation, and nothing else.
namespace camlaw::problems {

struct VariedDesign {
  ProblemStatement design;  ///< nominal; its limits and objectives are those of one part
  std::vector<VariationStatement> statements;
  Binding binding;                           ///< in which they vary
  optim::Problem problem;                    ///< its variables are what varies, in this order
  std::vector<double> meant;                 ///< their values
  std::vector<optim::Variation> variations;  ///< of each
  /// Once it has passed, the problem's responses throw optim::Interrupted.
  optim::Deadline deadline = optim::Deadline({}, nullptr);

  /// Whether a number of the law varies.
  bool varies_law() const;
};

/// What is to vary: as `tolerances` say, "base_radius=0.05 mm", as much to either side; without any
/// of them the design's own variations. Throws std::invalid_argument for names and values that are
/// not accepted.
std::vector<VariationStatement> asked_variations(const ProblemStatement& design,
                                                 const std::vector<std::string>& tolerances);

/// The design that a statement begins with. Throws std::invalid_argument where nothing varies, and
/// where a variation reaches values that its parameter does not accept.
VariedDesign varied_design(const ProblemStatement& design,
                           std::vector<VariationStatement> variations,
                           const optim::Deadline& deadline = optim::Deadline({}, nullptr));

}  // namespace camlaw::problems
