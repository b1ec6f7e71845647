// SPDX-License-Identifier: MIT
#include "fitting/records/recorded_curve.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <stdexcept>

#include "fitting/samples/condensed.h"
#include "numerics/tables/columns.h"

namespace camlaw::problems {
namespace {

/// "Drive torque" and "drive_torque" are one name.
std::string plain(const std::string& name) {
  std::string result;
  for (const char c : name) {
    result += c == ' ' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return result;
}

std::vector<std::string> curve_names(const Mechanism& mechanism) {
  std::vector<std::string> names;
  for (const MechanismResponse& r : mechanism.responses) {
    if (r.curve) names.push_back(r.name);
  }
  return names;
}

/// "has the name of a curve of servo-axis, such as ...": what a column may be called.
std::string which_curves(const Mechanism& mechanism) {
  constexpr std::size_t kNamed = 6;
  std::vector<std::string> curves = curve_names(mechanism);
  if (curves.size() > kNamed) curves.resize(kNamed);
  return fmt::format(
      "has the name of a curve of {0}, such as {1} (all: 'camlaw mechanisms {0}'); with "
      "--mechanism, name the column of the record after the curve that it holds, or call it lift "
      "if it is the follower's motion",
      mechanism.name, fmt::join(curves, ", "));
}

const SampleColumn& recorded_column(const SampleTable& table, const Mechanism& mechanism,
                                    const std::optional<std::string>& name) {
  const std::vector<std::string> curves = curve_names(mechanism);
  std::vector<const SampleColumn*> found;
  std::vector<std::string> names;
  for (const SampleColumn& column : table.columns) {
    const bool wanted =
        name ? plain(column.name) == plain(*name)
             : std::find(curves.begin(), curves.end(), plain(column.name)) != curves.end();
    if (!wanted) continue;
    found.push_back(&column);
    names.push_back(column.name);
  }
  if (found.empty()) {
    throw std::invalid_argument(
        fmt::format("{}: no column {}", table.source,
                    name ? fmt::format("is called '{}'", *name) : which_curves(mechanism)));
  }
  if (found.size() > 1) {
    throw std::invalid_argument(
        fmt::format("{}: several columns are curves of {}: {}; choose one by --response NAME",
                    table.source, mechanism.name, fmt::join(names, ", ")));
  }
  return *found.front();
}

}  // namespace

bool has_recorded_curve(const SampleTable& table, const Mechanism& mechanism) {
  const std::vector<std::string> curves = curve_names(mechanism);
  return std::any_of(table.columns.begin(), table.columns.end(), [&](const SampleColumn& column) {
    return std::find(curves.begin(), curves.end(), plain(column.name)) != curves.end();
  });
}

RecordedCurve recorded_curve(const SampleTable& table, const Mechanism& mechanism,
                             const std::optional<std::string>& name) {
  const SampleColumn& column = recorded_column(table, mechanism, name);
  RecordedCurve record{find_response(mechanism, plain(column.name)), {}, {}};
  if (record.response.response == nullptr || !record.response.response->curve ||
      record.response.part != optim::Part::Value) {
    throw std::invalid_argument(fmt::format("{}: '{}' is not a curve of {}; there are {}",
                                            table.source, column.name, mechanism.name,
                                            fmt::join(curve_names(mechanism), ", ")));
  }
  const SampleTable own = numbers_of(table, {&place_column(table, &column), &column});
  record.lacking = own.left_out;
  UnitValues values = in_unit(own, own.columns[1], {record.response.unit});
  Condensed means =
      condensed(in_unit(own, own.columns[0], {record.response.response->along}).values,
                std::move(values.values), std::abs(values.factor) * resolution_of(own.columns[1]));
  record.place = std::move(means.place);
  record.value = std::move(means.value);
  record.each = means.each;
  record.left_out = means.left_out;
  return record;
}

}  // namespace camlaw::problems
