// SPDX-License-Identifier: MIT
#include "output/export/motion_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "numerics/text/units.h"
#include "output/export/chords.h"
#include "problems/statement/bind.h"

namespace camlaw::problems {
namespace {

/// A motion over a cycle.
struct Motion {
  std::string master, master_unit, slave;
  double begin = 0, end = 1;
  std::function<std::vector<double>(std::span<const optim::Place>)> values;
};

Motion curve_motion(const ProblemStatement& statement, const optim::Response& response) {
  const auto name = find_response(*statement.mechanism, response.name);
  Motion motion;
  motion.master_unit = name.response->along;
  motion.master = motion.master_unit == "1" ? "x" : place_name(statement);
  motion.slave = fmt::format("{} [{}]", response.name, response.unit);
  const std::shared_ptr<const optim::Trace> trace = response.curve().trace({});
  motion.begin = trace->breaks().front();
  motion.end = trace->breaks().back();
  motion.values = [trace](std::span<const optim::Place> places) { return trace->values(places); };
  return motion;
}

Possible<Motion> law_motion(const ProblemStatement& statement) {
  auto law = statement.laws.front().possible_law();
  if (!law) return law.reason();
  Motion motion{.master = "x", .master_unit = "1", .slave = "s [1]", .values = {}};
  motion.values = [law = std::move(*law)](std::span<const optim::Place> places) {
    std::vector<double> result;
    for (const optim::Place& place : places) {
      result.push_back(law(place.angle, place.from_left ? Side::Left : Side::Right).s);
    }
    return result;
  };
  return motion;
}

Possible<Motion> motion_of(const ProblemStatement& statement,
                           const std::optional<std::string>& slave) {
  std::vector<std::string> names;
  for (const optim::Response& response : curves_of(statement)) {
    if (response.name == slave.value_or("displacement")) return curve_motion(statement, response);
    names.push_back(response.name);
  }
  if (!slave && statement.mechanism->moved_by != MovedBy::Nothing) return law_motion(statement);
  const std::string& mechanism = statement.mechanism->name;
  if (names.empty()) {
    return Impossible{fmt::format("{} has no motion over a cycle", mechanism)};
  }
  return Impossible{fmt::format(
      "{}; its curves are {}",
      slave ? fmt::format("{} has no curve '{}'", mechanism, *slave)
            : fmt::format("{} has no displacement of its own; name the slave", mechanism),
      fmt::join(names, ", "))};
}

double step_of(const Motion& motion, const std::optional<std::string>& text) {
  constexpr int kSteps = 360;
  if (!text) return (motion.end - motion.begin) / kSteps;
  return parse_quantity(*text, motion.master_unit, motion.master_unit, "--step");
}

/// What comes back comes back in every digit; rounding is not a motion.
void close(MotionTable& table) {
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

}  // namespace

MotionTable motion_table(const ProblemStatement& statement, const std::optional<std::string>& slave,
                         const std::optional<std::string>& step, int decimals) {
  return possible_motion_table(statement, slave, step, decimals).value();
}

Possible<MotionTable> possible_motion_table(const ProblemStatement& statement,
                                            const std::optional<std::string>& slave,
                                            const std::optional<std::string>& step, int decimals) {
  const auto found = motion_of(statement, slave);
  if (!found) return found.reason();
  const Motion& motion = *found;
  const int count =
      count_steps(motion.end - motion.begin, step_of(motion, step), motion.master_unit);
  const auto places = optim::even_places(motion.begin, motion.end, count);
  MotionTable table{motion.master, motion.slave, {}, motion.values(places)};
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!std::isfinite(table.values[i])) {
      return Impossible{fmt::format("{} has no value at {} = {:.6g}", motion.slave, motion.master,
                                    places[i].angle)};
    }
    table.places.push_back(places[i].angle);
  }
  close(table);
  for (double& value : table.values) value = rounded(value, decimals);
  return table;
}

std::string table_text(const MotionTable& table, int decimals) {
  if (!keeps_places(table, decimals)) {
    int enough = decimals + 1;
    while (!keeps_places(table, enough)) ++enough;
    throw std::invalid_argument(
        fmt::format("places of {} that are {:.6g} apart cannot be told with {} decimals; {} or "
                    "more are wanted",
                    table.master, table.places[1] - table.places[0], decimals, enough));
  }
  std::string text = fmt::format("{},{}\n", table.master, table.slave);
  for (std::size_t i = 0; i < table.places.size(); ++i) {
    text += fmt::format("{:.{}f},{:.{}f}\n", table.places[i] + 0.0, decimals, table.values[i],
                        decimals);
  }
  return text;
}

}  // namespace camlaw::problems
