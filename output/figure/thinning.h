// SPDX-License-Identifier: MIT
#pragma once

#include "output/figure/chart.h"

namespace camlaw::cli {

/// A curve with fewer samples that looks the same: none of those left out is farther from the
/// straight line between its neighbours than `share` of the curve's range (Douglas and Peucker
/// 1973, with the distance taken along y). The lowest and the highest sample stay, as do both ends
/// of each stretch with values; of a gap one sample stays.
Line thinned(const Line& line, double share);

/// The same of every curve of a figure, to an eighth of a pixel of a chart 600 pixels high.
Figure thinned(Figure figure);

}  // namespace camlaw::cli
