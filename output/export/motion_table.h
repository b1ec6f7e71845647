// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "numerics/possible.h"

/// Motions as the cam tables of controllers: where the slave is for each place of the master.
namespace camlaw::problems {

struct ExportedMotion;
struct MasterUnit;
struct ProblemStatement;  // problems/statement/statement.h

/// A derivative of the slave by the master.
struct TableColumn {
  std::string heading;  ///< "v [mm / deg]"
  int order = 1;
  std::vector<double> values;
};

struct MotionTable {
  std::string master, slave;           ///< with units: "cam_angle [deg]", "displacement [mm]"
  std::vector<double> places, values;  ///< at even places, ends included; of a master that has
                                       ///< whole numbers only at the nearest of these
  bool closed = false;                 ///< the last value is the first
  std::vector<TableColumn> more = {};
  double moved = 0;  ///< how far a row is from its even place at most, in the master's unit
};

/// The table of a mechanism's motion. `slave` names one of its curves; none: the curve
/// "displacement", else the law itself, s over x. The step is in the unit of the master; none: a
/// 360th of the cycle. Values are rounded to the decimals; a motion that comes back ends in the
/// digits in which it begins, a law in exactly 0 and 1. Impossible where there is no such curve,
/// with those that there are, and where the motion jumps to infinity. Throws std::invalid_argument
/// for steps that do not divide the cycle.
Possible<MotionTable> possible_motion_table(const ProblemStatement& statement,
                                            const std::optional<std::string>& slave,
                                            const std::optional<std::string>& step, int decimals);
/// The same; throws std::invalid_argument where it is impossible.
MotionTable motion_table(const ProblemStatement& statement, const std::optional<std::string>& slave,
                         const std::optional<std::string>& step, int decimals);

/// The same of a motion, its master counted in another unit (the step is still in that of the
/// places), with further columns: `columns` are letters of "svaj", s first. A derivative that is
/// infinite or unknown throws std::invalid_argument.
Possible<MotionTable> possible_table_of(const ExportedMotion& motion,
                                        const std::optional<std::string>& step, int decimals,
                                        const MasterUnit& master);
MotionTable table_of(const ExportedMotion& motion, const std::optional<std::string>& step,
                     int decimals, const MasterUnit& master, const std::string& columns = "s");

/// How numbers stand in a table.
struct TableStyle {
  int decimals = 6;
  char separator = ',';
  bool decimal_comma = false;
};

/// "master,slave" and a row each, all with so many decimals, a derivative with two more for each
/// order. Throws std::invalid_argument with how many it takes where they leave a place off by more
/// than a twentieth of a step.
std::string table_text(const MotionTable& table, const TableStyle& style);
std::string table_text(const MotionTable& table, int decimals);

}  // namespace camlaw::problems
