// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "fitting/motions/fault_words.h"
#include "numerics/tables/turn.h"
#include "output/answers/fit_output.h"
#include "output/document/formatting.h"

namespace camlaw::cli {
namespace {

using problems::FaultyRow;

constexpr std::size_t kListedRows = 5;

std::string stray_text(const problems::MotionRecord& record) {
  if (record.stray.empty()) return "";
  const std::string& unit = record.samples.place_unit;
  std::vector<std::string> rows;
  for (std::size_t i = 0; i < std::min(kListedRows, record.stray.size()); ++i) {
    const FaultyRow& row = record.stray[i];
    rows.push_back(
        fmt::format("line {} at {}", row.line, with_unit(in_digits(row.place, 12), unit)));
  }
  return fmt::format("{} row{} far from all others, left out: {}{}\n", record.stray.size(),
                     record.stray.size() == 1 ? "" : "s", fmt::join(rows, ", "),
                     record.stray.size() > kListedRows ? ", ..." : "");
}

std::string far_text(const problems::MotionRecord& record) {
  if (record.far.empty()) return "";
  std::vector<std::string> rows;
  for (std::size_t i = 0; i < std::min(kListedRows, record.far.size()); ++i) {
    rows.push_back(problems::told(record.far[i], record.samples));
  }
  return fmt::format("{} row{} off the curve of the others, left out: {}{}\n", record.far.size(),
                     record.far.size() == 1 ? "" : "s", fmt::join(rows, ", "),
                     record.far.size() > kListedRows ? ", ..." : "");
}

/// Of a cam's profile in mm, whatever its follower's unit is.
std::string centre_unit(const SamplesAnswer& answer) {
  return answer.cam() != nullptr ? "mm" : answer.motion()->record.samples.unit;
}

std::string centre_text(const SamplesAnswer& answer) {
  const auto& centre = answer.centre();
  if (!centre) return "";
  const double towards = problems::in_turn(std::arg(centre->place)) / problems::kDegree;
  return fmt::format("fitted centre: {} off, towards {} deg (x {} +- {}, y {} +- {})\n",
                     with_unit(number(std::abs(centre->place)), centre_unit(answer)),
                     in_digits(towards, 4), number(centre->place.real()),
                     in_digits(centre->x_error(), 2), number(centre->place.imag()),
                     in_digits(centre->y_error(), 2));
}

Json rows_json(const std::vector<FaultyRow>& rows) {
  Json list = Json::array();
  for (const FaultyRow& row : rows) {
    list.push_back({{"line", row.line > 0 ? Json(row.line) : Json(nullptr)},
                    {"abscissa", to_json(row.place)},
                    {"value", to_json(row.value)},
                    {"distance", to_json(row.distance)}});
  }
  return list;
}

std::string kind_name(problems::FaultKind kind) {
  switch (kind) {
    case problems::FaultKind::Drift:
      return "drift";
    case problems::FaultKind::OffCentre:
      return "off-centre";
    case problems::FaultKind::OwnSize:
      return "size of the follower";
  }
  return "";
}

Json fault_json(const problems::FaultTest& test) {
  Json unknowns = Json::array();
  for (std::size_t i = 0; i < test.fault.names.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    unknowns.push_back({{"name", test.fault.names[i]},
                        {"value", to_json(test.size[k])},
                        {"standard_deviation", to_json(std::sqrt(test.covariance(k, k)))}});
  }
  return {{"kind", kind_name(test.fault.kind)},
          {"gain", to_json(test.gain)},
          {"unknowns", std::move(unknowns)}};
}

}  // namespace

void add_record_faults(const SamplesAnswer& answer, Document& document) {
  for (const std::string& note : answer.notes) document.say(note + "\n");
  document.fact("notes", answer.notes);
  static const problems::MotionRecord kNone{};
  const problems::MotionRecord& record =
      answer.motion() != nullptr ? answer.motion()->record : kNone;
  document.say(stray_text(record) + far_text(record) + centre_text(answer));
  document.fact("outliers_in_abscissa", rows_json(record.stray));
  document.fact("outliers_in_value", rows_json(record.far));
  Json faults = Json::array();
  for (const auto& test : answer.faults()) faults.push_back(fault_json(test));
  document.fact("faults", faults);
  const auto& centre = answer.centre();
  document.fact("centre", !centre ? Json(nullptr)
                                  : Json{{"x", to_json(centre->place.real())},
                                         {"y", to_json(centre->place.imag())},
                                         {"x_standard_deviation", to_json(centre->x_error())},
                                         {"y_standard_deviation", to_json(centre->y_error())},
                                         {"unit", centre_unit(answer)}});
}

}  // namespace camlaw::cli
