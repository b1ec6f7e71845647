// SPDX-License-Identifier: MIT
#include "output/answers/motion_export.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "numerics/text/units.h"
#include "output/document/formatting.h"
#include "output/export/chords.h"
#include "output/export/motion.h"
#include "problems/statement/parameters.h"

namespace camlaw::cli {
namespace {

/// In what the master is counted.
problems::MasterUnit master_of(const ExportOptions& o, const problems::ExportedMotion& motion) {
  const std::string unit = o.master.value_or(motion.place_unit == "1" ? "x" : motion.place_unit);
  const bool is_own = unit == motion.place_unit || (unit == "x" && motion.place_unit == "1");
  if (!is_own && unit != "ms" && unit != "increments") {
    throw std::invalid_argument(fmt::format("--master {}: use {}, ms or increments", unit,
                                            motion.place_unit == "1" ? "x" : motion.place_unit));
  }
  if (is_own) {
    if (o.cycle)
      throw std::invalid_argument("--cycle is only for --master ms and --master increments");
    return {motion.master};
  }
  if (!o.cycle) {
    throw std::invalid_argument(
        fmt::format("--master {}: say with --cycle {}", unit,
                    unit == "ms" ? "how long a cycle takes, such as --cycle '500 ms'"
                                 : "how many increments a cycle has, such as --cycle 65536"));
  }
  const double cycle = unit == "ms" ? parse_quantity(*o.cycle, "ms", "ms", "--cycle")
                                    : parse_quantity(*o.cycle, "1", "1", "--cycle");
  if (!(cycle > 0) || !std::isfinite(cycle)) {
    throw std::invalid_argument(fmt::format("--cycle {}: it must be above 0", *o.cycle));
  }
  if (unit == "increments" && cycle != std::floor(cycle)) {
    throw std::invalid_argument(fmt::format(
        "--cycle {}: a cycle has a whole number of increments, such as 65536", *o.cycle));
  }
  const char* heading = unit == "ms" ? "time [ms]" : "master [increments]";
  return {heading, cycle / (motion.end() - motion.begin()), unit == "increments"};
}

std::string columns_of(const ExportOptions& o) {
  if (!o.columns) return "s";
  std::string letters = *o.columns;
  std::erase_if(letters, [](char c) { return c == ',' || c == ' '; });
  constexpr std::string_view kAll = "svaj";
  const bool known = letters.find_first_not_of(kAll) == std::string::npos;
  auto sorted = letters;
  std::sort(sorted.begin(), sorted.end());
  const bool once = std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
  if (!known || !once || !letters.starts_with('s')) {
    throw std::invalid_argument(fmt::format(
        "--columns {}: begin with s; any of v, a and j may follow, such as s,v,a", *o.columns));
  }
  return letters;
}

problems::TableStyle style_of(const ExportOptions& o, int decimals) {
  problems::TableStyle style{decimals};
  style.decimal_comma = o.decimal_comma;
  const std::string separator = o.separator.value_or(o.decimal_comma ? ";" : ",");
  if (separator == "tab") {
    style.separator = '\t';
  } else if (separator == "space") {
    style.separator = ' ';
  } else if (separator == "," || separator == ";") {
    style.separator = separator[0];
  } else {
    throw std::invalid_argument(
        fmt::format("--separator {}: use ',', ';', tab or space", separator));
  }
  if (style.decimal_comma && style.separator == ',') {
    throw std::invalid_argument("--separator ,: with --decimal-comma use ';', tab or space");
  }
  return style;
}

/// The largest value less the least, at some places, in the unit that is written.
double range_of(const problems::ExportedMotion& motion) {
  // Half a degree of a turn: a peak of three waves a turn is missed by 1e-4.
  constexpr int kLooks = 720;
  const auto values =
      motion.trace->values(optim::even_places(motion.begin(), motion.end(), kLooks));
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return motion.slave_factor * (*most - *least);
}

double tolerance_of(const ExportOptions& o, const problems::ExportedMotion& motion, int decimals) {
  constexpr double kShare = 1e-5;  // of the range
  const double digit = std::pow(10.0, -decimals);
  if (!o.tolerance) return std::max(kShare * range_of(motion), 10 * digit);
  const double tolerance = parse_quantity(*o.tolerance, motion.unit, motion.unit, "--tolerance");
  if (tolerance >= 10 * digit && std::isfinite(tolerance)) return tolerance;
  throw std::invalid_argument(fmt::format("--tolerance: {} is outside {:.6g} .. {}",
                                          problems::with_unit(tolerance, motion.unit), 10 * digit,
                                          with_unit("inf", motion.unit)));
}

int steps_of(const ExportOptions& o, const problems::ExportedMotion& motion) {
  constexpr int kSteps = 360;  // a point each degree of a turn
  if (!o.step) return kSteps;
  return problems::count_steps(
      motion.end() - motion.begin(),
      parse_quantity(*o.step, motion.place_unit, motion.place_unit, "--step"), motion.place_unit);
}

/// What a controller of 32 bits has of a number.
double single(double value) { return static_cast<double>(static_cast<float>(value)); }

/// Points at even steps; of a controller of 32 bits as these have them.
std::vector<problems::MotionKnot> points_of(const ExportOptions& o,
                                            const problems::ExportedMotion& motion,
                                            const problems::DriveFormat& drive,
                                            const problems::WrittenMotion& written) {
  constexpr int kAllDigits = 12;  // decimals: the 24 bits of a controller hold seven digits
  const int steps = steps_of(o, motion);
  if (static_cast<std::size_t>(steps) > drive.most) {
    throw std::invalid_argument(fmt::format("--step: {} steps are more than the {} that {} takes",
                                            steps, drive.most, drive.name));
  }
  auto knots =
      problems::even_knots(written, steps, drive.decimals > 0 ? drive.decimals : kAllDigits);
  if (drive.decimals > 0) return knots;
  for (problems::MotionKnot& knot : knots) {
    knot = {single(knot.master), single(knot.s), single(knot.v), single(knot.a)};
  }
  return knots;
}

/// Refuses even steps between which a drive leaves the motion by much of its range.
void check_step(const ExportOptions& o, const problems::ExportedMotion& motion, double deviation) {
  constexpr double kShare = 0.01;  // a hundredth of the range shows on any machine
  const double range = range_of(motion);
  if (!o.step || !(deviation > kShare * range)) return;
  throw std::invalid_argument(
      fmt::format("--step {}: between these points the drive deviates from the exact {} by {}, "
                  "which is more than a "
                  "hundredth of its range of {}; use a smaller step",
                  *o.step, motion.slave_heading(), with_unit(in_digits(deviation, 4), motion.unit),
                  with_unit(in_digits(range, 4), motion.unit)));
}

std::string drive_text(const ExportOptions& o, const problems::DriveFormat& drive,
                       const problems::ExportedMotion& motion, const problems::MasterUnit& master,
                       Exported& e) {
  const problems::WrittenMotion written{motion, master.per_place};
  problems::PiecewiseMotion path;
  problems::MotionDeviation deviation;
  if (drive.path == problems::DrivePath::Quintics) {
    auto found = problems::quintics_within(written, tolerance_of(o, motion, drive.decimals),
                                           drive.decimals, drive.most);
    path = std::move(found.path), deviation = found.deviation;
  } else {
    auto knots = points_of(o, motion, drive, written);
    path = drive.path == problems::DrivePath::Lines
               ? problems::lines_between(std::move(knots))
               : problems::cubic_spline_through(std::move(knots));
    deviation = problems::deviation_of(written, path);
    check_step(o, motion, deviation.most);
  }
  e.motion = {motion.slave_heading(), path.knots.size(), drive.path, motion.unit, deviation,
              drive.description};
  const bool fractions = std::any_of(
      path.knots.begin(), path.knots.end(),
      [](const problems::MotionKnot& knot) { return knot.master != std::round(knot.master); });
  if (master.whole && fractions) {
    e.notes.push_back("places of the master are fractions of an increment, as the drive has them");
  }
  std::vector<std::string> comments = comments_of(e);
  comments.push_back(
      fmt::format("master: {}; slave: {}; derivatives are with respect to the master",
                  master.heading, motion.slave_heading()));
  return drive.text(path, comments);
}

}  // namespace

problems::LengthUnit unit_of(const ExportOptions& o) {
  const std::string unit = o.unit.value_or("mm");
  if (unit == "mm") return problems::kMillimetre;
  if (unit == "inch") return problems::kInch;
  throw std::invalid_argument(fmt::format("--unit {}: use mm or inch", unit));
}

Possible<problems::ExportedMotion> exported_motion(const Exported& e,
                                                   const std::optional<std::string>& slave) {
  auto motion = problems::motion_of(e.design.statement, slave, e.accuracy.unit.mm != 1);
  if (!motion || !e.on_shaft || !e.on_shaft->from_shaft) return motion;
  const bool advances = e.design.statement.mechanism->advances.has_value();
  return problems::by_shaft(*motion, e.on_shaft->phase, advances);
}

std::string motion_text(const ExportOptions& o, const FormatRow& format, Exported& e) {
  const problems::ExportedMotion motion = exported_motion(e, o.slave).value();
  const problems::MasterUnit master = master_of(o, motion);
  if (e.on_shaft) {
    const bool by_shaft = e.on_shaft->from_shaft && problems::turns_with_shaft(motion);
    e.placed.push_back(by_shaft ? "the master is counted from the shaft's zero"
                                : "the master is counted from the cam's own zero");
    e.notes.push_back(e.placed.back());
  }
  if (format.drive != nullptr) return drive_text(o, *format.drive, motion, master, e);
  const int decimals = e.accuracy.decimals;
  const problems::MotionTable table =
      problems::table_of(motion, o.step, decimals, master, columns_of(o));
  if (table.moved > 0) {
    e.notes.push_back(
        fmt::format("the rows stand at whole increments, at most {:.3g} from even steps; the slave "
                    "is exact there",
                    table.moved));
  }
  return warning_head(e) + problems::table_text(table, style_of(o, decimals));
}

}  // namespace camlaw::cli
