// SPDX-License-Identifier: MIT
#include "output/export/motion_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "numerics/text/units.h"
#include "output/export/chords.h"
#include "output/export/motion.h"
#include "problems/statement/statement.h"

namespace camlaw::problems {
namespace {

double table_step_of(const ExportedMotion& motion, const std::optional<std::string>& text) {
  constexpr int kSteps = 360;  // a row each degree of a turn
  if (!text) return (motion.end() - motion.begin()) / kSteps;
  return parse_quantity(*text, motion.place_unit, motion.place_unit, "--step");
}

/// What comes back comes back in every digit; rounding is not a motion.
void close_table(MotionTable& table) {
  // Of the range: a cycle returns to its beginning with rounding.
  constexpr double kRounding = 1e-9;
  const auto [least, most] = std::minmax_element(table.values.begin(), table.values.end());
  double &first = table.values.front(), &last = table.values.back();
  table.closed = std::abs(last - first) <= kRounding * (*most - *least);
  if (table.closed) last = first;
}

/// Whether places are as even in so many decimals as they are meant.
bool keeps_places(const MotionTable& table, int decimals) {
  constexpr double kShare = 0.05;  // of a step
  const double step = table.places[1] - table.places[0];
  return std::all_of(table.places.begin(), table.places.end(), [&](double place) {
    return std::abs(rounded(place, decimals) - place) <= kShare * step;
  });
}

/// Where the rows stand, and how far that is from even places, in the master's unit.
struct TablePlaces {
  std::vector<optim::Place> places;
  double moved = 0;
};

/// The same at whole numbers of the master. Throws std::invalid_argument where there are fewer of
/// these than rows.
void make_whole(const ExportedMotion& motion, const MasterUnit& master, TablePlaces& rows) {
  const double begin = motion.begin(), cycle = master.per_place * (motion.end() - begin);
  const auto steps = static_cast<double>(rows.places.size() - 1);
  if (steps > cycle) {
    throw std::invalid_argument(
        fmt::format("--step: {:.0f} steps do not fit on the {:.0f} increments of a cycle; use a "
                    "larger --step, or a --cycle of more increments",
                    steps, cycle));
  }
  for (optim::Place& place : rows.places) {
    const double even = master.per_place * (place.angle - begin), whole = std::round(even);
    constexpr double kRounding = 1e-9;  // increments: an even place is one within this
    if (std::abs(whole - even) <= kRounding) continue;
    rows.moved = std::max(rows.moved, std::abs(whole - even));
    place.angle = begin + whole / master.per_place;
  }
}

TablePlaces table_places(const ExportedMotion& motion, const std::optional<std::string>& step,
                         const MasterUnit& master) {
  const int count =
      count_steps(motion.end() - motion.begin(), table_step_of(motion, step), motion.place_unit);
  TablePlaces rows{optim::even_places(motion.begin(), motion.end(), count)};
  if (master.whole) make_whole(motion, master, rows);
  return rows;
}

Possible<MotionTable> table_at(const ExportedMotion& motion, const TablePlaces& rows, int decimals,
                               const MasterUnit& master) {
  const std::vector<optim::Place>& places = rows.places;
  MotionTable table{master.heading, motion.slave_heading(), {}, motion.trace->values(places)};
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!std::isfinite(table.values[i])) {
      return Impossible{fmt::format("{} has no value at {} = {:.6g}", motion.slave_heading(),
                                    motion.master, places[i].angle)};
    }
    const double at = master.per_place * places[i].angle;
    table.places.push_back(master.whole ? std::round(at) : at);
  }
  table.moved = rows.moved;
  close_table(table);
  for (double& value : table.values) value = rounded(motion.slave_factor * value, decimals);
  return table;
}

/// At a place inside the motion the derivative from its right, at the end that from its left.
TableColumn derivative_column(const ExportedMotion& motion, const std::vector<optim::Place>& places,
                              char letter, const MasterUnit& master) {
  constexpr std::string_view kLetters = "svaj";
  const int order = static_cast<int>(kLetters.find(letter));
  const std::string& heading = master.heading;
  const std::size_t open = heading.find('['), shut = heading.find(']');
  const std::string by =
      open == std::string::npos ? heading : heading.substr(open + 1, shut - open - 1);
  TableColumn column{fmt::format("{} [{} / {}{}]", letter, motion.unit, by,
                                 order == 1 ? "" : fmt::format("^{}", order)),
                     order,
                     {}};
  for (const optim::Place& place : places) {
    const double value = motion.at(place)[static_cast<std::size_t>(order)];
    if (!std::isfinite(value)) {
      throw std::invalid_argument(
          fmt::format("--columns {}: {} has no {} at {} = {:.6g}{}", letter, motion.slave_heading(),
                      order == 3 ? "third derivative" : "such derivative", motion.master,
                      place.angle, order == 3 && !motion.velocity ? "; use s, v and a" : ""));
    }
    column.values.push_back(value / std::pow(master.per_place, order));
  }
  return column;
}

/// A number with so many decimals, and with the decimal sign that is wanted.
std::string decimal_text(double value, int decimals, const TableStyle& style) {
  std::string text = fmt::format("{:.{}f}", rounded(value, decimals), decimals);
  if (style.decimal_comma) std::replace(text.begin(), text.end(), '.', ',');
  return text;
}

}  // namespace

MotionTable motion_table(const ProblemStatement& statement, const std::optional<std::string>& slave,
                         const std::optional<std::string>& step, int decimals) {
  return possible_motion_table(statement, slave, step, decimals).value();
}

Possible<MotionTable> possible_motion_table(const ProblemStatement& statement,
                                            const std::optional<std::string>& slave,
                                            const std::optional<std::string>& step, int decimals) {
  const auto motion = motion_of(statement, slave);
  if (!motion) return motion.reason();
  return possible_table_of(*motion, step, decimals, {motion->master});
}

Possible<MotionTable> possible_table_of(const ExportedMotion& motion,
                                        const std::optional<std::string>& step, int decimals,
                                        const MasterUnit& master) {
  return table_at(motion, table_places(motion, step, master), decimals, master);
}

MotionTable table_of(const ExportedMotion& motion, const std::optional<std::string>& step,
                     int decimals, const MasterUnit& master, const std::string& columns) {
  const TablePlaces rows = table_places(motion, step, master);
  MotionTable table = table_at(motion, rows, decimals, master).value();
  for (const char letter : columns.substr(1)) {
    table.more.push_back(derivative_column(motion, rows.places, letter, master));
  }
  return table;
}

std::string table_text(const MotionTable& table, int decimals) {
  return table_text(table, TableStyle{decimals});
}

std::string table_text(const MotionTable& table, const TableStyle& style) {
  if (!keeps_places(table, style.decimals)) {
    int enough = style.decimals + 1;
    while (!keeps_places(table, enough)) ++enough;
    throw std::invalid_argument(fmt::format(
        "places of {} that are {:.6g} apart cannot be told apart with {} decimals; use {} or more",
        table.master, table.places[1] - table.places[0], style.decimals, enough));
  }
  std::string text = fmt::format("{}{}{}", table.master, style.separator, table.slave);
  for (const TableColumn& column : table.more) text += style.separator + column.heading;
  text += "\n";
  for (std::size_t i = 0; i < table.places.size(); ++i) {
    text += decimal_text(table.places[i], style.decimals, style) + style.separator +
            decimal_text(table.values[i], style.decimals, style);
    for (const TableColumn& column : table.more) {
      text += style.separator +
              decimal_text(column.values[i], style.decimals + 2 * column.order, style);
    }
    text += "\n";
  }
  return text;
}

}  // namespace camlaw::problems
