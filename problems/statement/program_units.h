// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "machines/model/mechanism.h"
#include "problems/statement/statement.h"
#include "problems/statement/toml_entry.h"

/// Lengths, times and rates of a motion program as a file states them.
namespace camlaw::problems {

/// The tables of a program's segments, and of the points that one passes. Each must be a table.
const std::vector<Entry>& segment_tables(const Entry& program);
const std::vector<Entry>& point_tables(const Entry& segment);
/// What the i-th segment, counted from 0, is called.
std::string segment_name(const Entry& segment, std::size_t i);

/// Which derivative of the displacement an entry states.
enum class Rate { Velocity = 1, Acceleration = 2 };

/// Whether an entry carries a unit: "22 mm", not 0.5.
bool has_unit(const Entry& entry);

/// Whether an entry states a rate by time, "0.3 m/s", and not by the cam's angle, "0.02 mm/deg".
bool is_by_time(const Entry& entry, Rate rate);

/// The parameter whose value is the motion's at displacement 1: stroke, or swing.
std::optional<std::size_t> stroke_of(const Mechanism& mechanism);
/// Gives the machine that stroke. Refuses the entry that it comes from where it is not accepted.
void set_stroke(const Entry& entry, std::size_t place, double stroke, ProblemStatement& problem);

/// What they become: parts of the stroke, of the cycle, and both together.
struct ProgramUnits {
  std::string unit;              ///< of displacement, "mm" or "deg"; empty: the machine lists none
  std::optional<double> stroke;  ///< in it
  std::string why_none;          ///< where there is no stroke: why, and what to write
  std::optional<ProgramTiming> timing = {};
  /// The stroke's parameter, where displacements with units rest on it.
  std::optional<std::size_t> told_by_motion = {};

  /// A displacement in parts of the stroke; a bare number is that already.
  double level(const Entry& entry) const;
  /// The same, of a tolerance: above or equal to 0.
  double tolerance(const Entry& entry) const;
  /// A rate in strokes per cycle and per cycle^2; a bare number is that already.
  double rate(const Entry& entry, Rate rate) const;
  /// deg of the cycle of a table's `angle` or `time`; none where it has neither. Refuses both.
  std::optional<double> angle(const Entry& table) const;

 private:
  double stroke_for(const Entry& entry) const;
};

/// Finds the units of a file's program. Where it states displacements with units, and the file does
/// not state the stroke, the stroke is the highest of them, and becomes the machine's. There is no
/// stroke where it varies, and where the machine has no parameter called stroke or swing.
ProgramUnits read_program_units(const Entry& file, const Entry& program, ProblemStatement& problem);

}  // namespace camlaw::problems
