// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "output/figure/chart.h"

namespace camlaw::cli {

/// Data, what was fitted to them, and what is left.
struct FitPicture {
  std::string title;
  Axis x, y;         ///< of the data
  std::string dots;  ///< what the data are called
  std::string left;  ///< what is left, such as "samples less law"
  std::span<const double> place, value;
  std::span<const double> residual;  ///< model less data
  Line model;
};

/// Draws them as two panels, the data beside what is left of them. Of many data a part is drawn.
void draw(FitPicture picture, Figure& figure);

}  // namespace camlaw::cli
