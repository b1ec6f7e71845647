// SPDX-License-Identifier: MIT
#include "fitting/motions/fault_words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "numerics/tables/turn.h"

namespace camlaw::problems {
namespace {

std::string quantity(double value, const std::string& unit, int digits = 3) {
  return fmt::format("{:.{}g}{}", value, digits, unit == "1" ? "" : " " + unit);
}

std::string drift_words(const FaultTest& test, const std::string& unit) {
  return fmt::format(
      "the values drift by {} from the beginning of the record to its end (+- {}), as when the "
      "machine warms up or the indicator slips: measure again, or in both directions",
      quantity(test.size[0], unit), quantity(2 * std::sqrt(test.covariance(0, 0)), unit, 2));
}

std::string centre_words(const FaultTest& test, const std::string& unit, bool can_centre) {
  const double far = std::hypot(test.size[0], test.size[1]);
  const double towards = in_turn(std::atan2(test.size[1], test.size[0])) / kDegree;
  // A cam's fault is a length whatever its follower's unit is.
  return fmt::format(
      "the residuals vary once per turn, by {} towards {:.0f} deg, as when the cam was clamped off "
      "its centre{}",
      quantity(far, unit == "deg" ? "mm" : unit), towards,
      can_centre ? ": --shift centre fits the centre too" : "");
}

std::string size_words(const FaultTest& test) {
  const std::string& name = test.fault.names.front();
  return fmt::format(
      "the follower seems to have another {}, {} {} than stated (+- {}), as when it was forgotten "
      "or belongs to another follower: --set '{}=...' states it",
      name, quantity(std::abs(test.size[0]), "mm"), test.size[0] > 0 ? "less" : "more",
      quantity(2 * std::sqrt(test.covariance(0, 0)), "mm", 2), name);
}

std::string words_of(const FaultTest& test, const std::string& unit, bool can_centre) {
  switch (test.fault.kind) {
    case FaultKind::Drift:
      return drift_words(test, unit);
    case FaultKind::OffCentre:
      return centre_words(test, unit, can_centre);
    case FaultKind::OwnSize:
      return size_words(test);
  }
  return "";
}

}  // namespace

std::string told(const FaultyRow& row, const MotionSamples& samples) {
  const auto& kept = samples.place;
  const bool is_repeated = std::find(kept.begin(), kept.end(), row.place) != kept.end();
  const std::string at =
      quantity(row.place, samples.place_unit, 6) + (is_repeated ? ", a repeated place" : "");
  const std::string by = quantity(std::abs(row.distance), samples.unit);
  return row.line > 0 ? fmt::format("line {} ({}) by {}", row.line, at, by)
                      : fmt::format("{} by {}", at, by);
}

std::string many_far(const std::vector<FaultyRow>& rows, std::size_t of,
                     const MotionSamples& samples) {
  constexpr std::size_t kShown = 3;
  std::vector<std::string> worst;
  for (std::size_t i = 0; i < std::min(kShown, rows.size()); ++i) {
    worst.push_back(told(rows[i], samples));
  }
  return fmt::format(
      "{} of {} rows lie off the curve of the others: {}{}; they are left out, but so many cannot "
      "be slips; --loss huber or --loss cauchy fits all rows and limits the weight of such ones",
      rows.size(), of, fmt::join(worst, ", "), rows.size() > kShown ? ", ..." : "");
}

std::string fault_words(const std::vector<FaultTest>& seen, const std::string& unit,
                        bool can_centre) {
  std::string words = words_of(seen.front(), unit, can_centre);
  for (std::size_t i = 1; i < seen.size(); ++i) {
    words += "; or, as likely, " + words_of(seen[i], unit, can_centre);
  }
  return words;
}

}  // namespace camlaw::problems
