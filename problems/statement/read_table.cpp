// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <optional>
#include <sstream>

#include "kinematics/laws/lone_law.h"
#include "kinematics/program/table_motion.h"
#include "numerics/polynomial/lagrange.h"
#include "numerics/tables/columns.h"
#include "numerics/tables/line_source.h"
#include "numerics/tables/sample_table.h"
#include "numerics/tables/turn.h"
#include "numerics/text/file_text.h"
#include "problems/statement/parameters.h"
#include "problems/statement/program_timing.h"
#include "problems/statement/program_units.h"
#include "problems/statement/reading.h"
#include "problems/statement/toml_reader.h"

namespace camlaw::problems {
namespace {

constexpr std::size_t kMostStatedRows = 20000;
constexpr double kWidestGap = 30;  // deg between rows

/// A lift over the turn: places from 0 to 1, increasing.
struct TurnTable {
  std::vector<double> x, lift;
  std::string unit;          ///< of the lift; "1" where the table states none
  std::size_t left_out = 0;  ///< rows without one of the two numbers
};

/// The angle and the lift of a table, whatever else it holds.
SampleTable lift_columns(const SampleTable& table) {
  const SampleColumn* lift = find_column(table, ColumnKind::Displacement);
  const SampleColumn& angle = place_column(table, lift);
  if (lift == nullptr || lift == &angle) lift = &column_beside(table, &angle);
  return numbers_of(table, {&angle, lift});
}

/// Rows may begin anywhere and overlap a little; over more than a turn they are of another unit, or
/// of several turns.
void check_one_turn(const std::vector<double>& places) {
  const auto [first, last] = std::minmax_element(places.begin(), places.end());
  if (!(*last - *first > kTurnDegrees + kWidestGap)) return;
  throw std::invalid_argument(
      fmt::format("its angles run from {:.6g} to {:.6g} deg, over {:.3g} turns; give one turn, and "
                  "state the unit "
                  "that the angles are in",
                  *first, *last, (*last - *first) / kTurnDegrees));
}

/// A row that stands out of its neighbours far more than any other does of its own: of the place
/// between those before and behind it, by the cubic through two of each, it is at least a fiftieth
/// of the range away, and ten times as far as any row that does not count it as a neighbour.
std::optional<std::size_t> slip_of(const TurnTable& turn, double range) {
  constexpr double kShare = 0.02, kTimes = 10;
  const std::size_t rows = turn.x.size();
  if (rows < 12) return {};
  // With two rows of the turns before and after on each side.
  std::vector<double> x, lift;
  for (std::size_t k = 0; k < rows + 4; ++k) {
    const std::size_t row = (k + rows - 2) % rows;
    x.push_back(turn.x[row] + (k < 2 ? -1 : k < rows + 2 ? 0 : 1));
    lift.push_back(turn.lift[row]);
  }
  std::vector<double> off(rows);
  for (std::size_t i = 0; i < rows; ++i) {
    const std::array<std::size_t, 4> near{i, i + 1, i + 3, i + 4};
    off[i] = std::abs(lagrange_miss(x, lift, near, i + 2));
  }
  const auto worst =
      static_cast<std::size_t>(std::max_element(off.begin(), off.end()) - off.begin());
  double others = 0;
  for (std::size_t i = 0; i < rows; ++i) {
    const std::size_t apart = i > worst ? i - worst : worst - i;
    if (std::min(apart, rows - apart) > 2) others = std::max(others, off[i]);
  }
  if (!(off[worst] > kShare * range && off[worst] > kTimes * others)) return {};
  return worst;
}

/// The rows in their order round the turn, one at each place.
TurnTable turn_of(const SampleTable& table, const std::string& unit) {
  SampleColumn angle = table.columns[0];
  if (angle.unit.empty()) angle.unit = "deg";
  const std::vector<double> places = in_unit(table, angle, {"deg"}).values;
  check_one_turn(places);
  const UnitValues lift = in_unit(table, table.columns[1], {unit, "1"});
  std::vector<std::size_t> order(places.size());
  std::iota(order.begin(), order.end(), 0);
  std::vector<double> x(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    x[i] = in_period(places[i], 0, kTurnDegrees) / kTurnDegrees;
    if (x[i] >= 1) x[i] = 0;  // of an angle that rounding has left below 0
  }
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return x[a] < x[b]; });
  // Of the turn: a thousandth of a second of arc, below any table's digits.
  constexpr double kSamePlace = 1e-9;
  const double alike = 2 * resolution_of(table.columns[1]) * lift.factor;
  const auto check_again = [&](std::size_t i, double known) {
    if (std::abs(lift.values[i] - known) <= alike) return;
    throw std::invalid_argument(fmt::format(
        "at {:.6g} deg the lift is {} and {}; give one turn of a motion that returns",
        x[i] * kTurnDegrees, with_unit(known, lift.unit), with_unit(lift.values[i], lift.unit)));
  };
  TurnTable turn{{}, {}, lift.unit, table.left_out};
  for (const std::size_t i : order) {
    // The beginning is often there twice, as 0 and as 360 deg.
    if (!turn.x.empty() && x[i] - turn.x.back() < kSamePlace) {
      check_again(i, turn.lift.back());
    } else if (!turn.x.empty() && turn.x.front() + 1 - x[i] < kSamePlace) {
      check_again(i, turn.lift.front());
    } else {
      turn.x.push_back(x[i]);
      turn.lift.push_back(lift.values[i]);
    }
  }
  return turn;
}

void check_turn(const TurnTable& turn) {
  if (turn.x.size() > kMostStatedRows) {
    throw std::invalid_argument(
        fmt::format("{} rows; at most {} are accepted", turn.x.size(), kMostStatedRows));
  }
  for (std::size_t i = 0; i < turn.x.size(); ++i) {
    const bool last = i + 1 == turn.x.size();
    const double next = last ? turn.x.front() + 1 : turn.x[i + 1];
    constexpr double kRounding = 1e-9;  // of what turns of a table's angles are told to
    if ((next - turn.x[i]) * kTurnDegrees <= kWidestGap * (1 + kRounding)) continue;
    throw std::invalid_argument(
        fmt::format("there are no rows from {:.6g} to {:.6g} deg; give the lift over the whole "
                    "turn, with rows at most {:g} deg apart",
                    turn.x[i] * kTurnDegrees, next * kTurnDegrees, kWidestGap));
  }
}

TableSmoothing read_smoothing(const Entry& program, const std::string& unit, double range) {
  const Entry* entry = find(program, "smoothing");
  if (entry == nullptr || (entry->kind == Entry::Kind::Text && entry->text == "auto")) return {};
  using Smoothing = TableSmoothing::Kind;
  if (entry->kind == Entry::Kind::Text && entry->text == "none") return {Smoothing::None};
  const double deviation = located(*entry, [&] {
    try {
      return positive_of(*entry, unit);
    } catch (const std::invalid_argument&) {
      throw std::invalid_argument(
          fmt::format("write \"none\", \"auto\", or how far the motion may be from the rows, root "
                      "mean square, such as {}",
                      unit == "1" ? "0.0001" : fmt::format("\"0.002 {}\"", unit)));
    }
  });
  return {Smoothing::Deviation, deviation / range};
}

/// Where a file lies that an entry names, from the problem file's folder.
std::string path_of(const Entry& name) {
  return (std::filesystem::path(folder_of(name)) / text_of(name)).string();
}

std::string words_of(const std::string& name, const TurnTable& turn, const TableMotion& motion,
                     double range) {
  const std::size_t rows = turn.x.size();
  const std::string left_out =
      turn.left_out == 0
          ? ""
          : fmt::format(" ({} without a number left out)",
                        turn.left_out == 1 ? "1 row" : fmt::format("{} rows", turn.left_out));
  if (motion.greatest == 0)
    return fmt::format("the lift of {}, through all {} rows{}", name, rows, left_out);
  return fmt::format(
      "the lift of {}, {} rows{}, smoothed: it is {} from them (root mean square), at most {}, and "
      "its greatest acceleration is {:.3g} of that of the curve through all rows",
      name, rows, left_out, with_unit(motion.deviation * range, turn.unit),
      with_unit(motion.greatest * range, turn.unit), motion.acceleration_kept);
}

}  // namespace

const std::string& table_text(const Entry& name, HeldFiles& files) {
  const std::string& path = text_of(name);
  const auto known = files.tables.find(path);
  if (known != files.tables.end()) return known->second;
  std::istringstream raw(located(name, [&] { return file_text(path_of(name), "table"); }));
  LineSource lines(raw, path);
  std::string text;
  for (std::string line; lines.next(line);) text += line + "\n";
  return files.tables.emplace(path, std::move(text)).first->second;
}

void read_table(const Entry& file, const Entry& program, ProblemStatement& problem) {
  check_keys(program, {"table", "smoothing", "cycle_time"});
  const Entry& name = *find(program, "table");
  const auto place = stroke_of(*problem.mechanism);
  if (!place) {
    refuse(name, fmt::format("{} has no parameter called stroke or swing, which a table's lift "
                             "would be",
                             problem.mechanism->name));
  }
  const MechanismParameter& parameter = problem.mechanism->parameters[*place];
  problem.timing = read_timing(file, program, problem);
  const std::string& text = table_text(name, problem.files);
  const TurnTable turn = located(name, [&] {
    const SampleTable table = parse_samples(text, path_of(name));
    TurnTable rows = turn_of(lift_columns(table), parameter.unit);
    check_turn(rows);
    return rows;
  });
  const auto [lowest, highest] = std::minmax_element(turn.lift.begin(), turn.lift.end());
  const double range = *highest - *lowest;
  if (!(range > 0)) refuse(name, "the lift is the same everywhere");
  const StatedParameter stated = stated_parameter(file, parameter);
  const Entry* other = stated.fixed != nullptr ? stated.fixed : stated.varying;
  if (turn.unit == "1") {
    if (other == nullptr) {
      refuse(name,
             fmt::format("its lift has no unit: write one in its line of names, such as \"lift "
                         "[{}]\", or state the {} in [constants]",
                         parameter.unit, parameter.name));
    }
  } else {
    if (other != nullptr) {
      refuse(*other, fmt::format("the table's lift already gives the {}, {}; drop this entry",
                                 parameter.name, with_unit(range, parameter.unit)));
    }
    set_stroke(name, *place, range, problem);
    problem.told_by_motion.insert(*place);
  }
  std::vector<double> s;
  for (const double lift : turn.lift) s.push_back((lift - *lowest) / range);
  const TableSmoothing smoothing = read_smoothing(program, turn.unit, range);
  const Entry* stated_smoothing = find(program, "smoothing");
  const auto slip = stated_smoothing == nullptr ? slip_of(turn, range) : std::nullopt;
  if (slip) {
    refuse(name, fmt::format("the row at {:.6g} deg, {}, is far off the curve through its "
                             "neighbours; correct it, or state the smoothing to keep it",
                             turn.x[*slip] * kTurnDegrees, with_unit(turn.lift[*slip], turn.unit)));
  }
  const TableMotion motion = located(stated_smoothing != nullptr ? *stated_smoothing : name,
                                     [&] { return table_motion(turn.x, s, smoothing); });
  problem.laws = {lone_law(
      {"table " + name.text, words_of(name.text, turn, motion, range), "periodic", "a table"},
      motion.law)};
}

}  // namespace camlaw::problems
