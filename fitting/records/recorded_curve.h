// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "machines/model/mechanism.h"
#include "numerics/tables/sample_table.h"

/// Curves of a machine that were recorded over its cycle.
namespace camlaw::problems {

/// A curve as it was recorded: places and values in the response's units.
struct RecordedCurve {
  ResponseName response;
  std::vector<double> place, value;
  std::size_t each = 1;      ///< measured samples that one of these is the mean of
  std::size_t left_out = 0;  ///< of those, far off their neighbours
  std::size_t lacking = 0;   ///< rows of the table without a number
};

/// Whether a column is called as a curve of the machine.
bool has_recorded_curve(const SampleTable& table, const Mechanism& mechanism);

/// The column called as a curve of the machine (case, spaces and underscores do not matter), or as
/// `name`, in any unit of its kind; the place is the column called angle, cam_angle, phi, theta, x,
/// t or time, else the first. Many samples are condensed(). Throws std::invalid_argument: no such
/// column, several, units of another kind.
RecordedCurve recorded_curve(const SampleTable& table, const Mechanism& mechanism,
                             const std::optional<std::string>& name = {});

}  // namespace camlaw::problems
