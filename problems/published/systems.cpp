// SPDX-License-Identifier: MIT
#include "problems/published/systems.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "numerics/text/csv_rows.h"
#include "problems/baseline.csv.h"
#include "problems/published/balancing_cam/reproduction.h"
#include "problems/published/cam_shape/reproduction.h"
#include "problems/published/die_press/reproduction.h"
#include "problems/published/sheet_delivery/reproduction.h"
#include "problems/published/signature_feeder/reproduction.h"
#include "problems/published/spine_cutter/reproduction.h"

namespace camlaw::problems {

namespace {

/// A system whose reproduction is always short.
ReproducibleSystem quick(std::string name, SystemReproduction (*reproduce)()) {
  return {std::move(name), [reproduce](const std::atomic<bool>*) { return reproduce(); }};
}

}  // namespace

const std::vector<ReproducibleSystem>& reproducible_systems() {
  static const std::vector<ReproducibleSystem> systems{
      quick("spine-cutter", reproduce_spine_cutter),
      quick("balancing-cam", reproduce_balancing_cam),
      quick("die-press", reproduce_die_press),
      quick("sheet-delivery", reproduce_sheet_delivery),
      quick("signature-feeder", reproduce_signature_feeder),
      {"cam-shape", reproduce_cam_shape}};
  return systems;
}

namespace {

optim::Finding read_finding(const std::string& text) {
  using optim::Finding;
  for (const Finding verdict : {Finding::Reproduced, Finding::Explained, Finding::Unexplained}) {
    if (text == to_string(verdict)) return verdict;
  }
  throw std::invalid_argument("baseline.csv: there is no verdict '" + text + "'");
}

struct Expected {
  std::string system, id;
  optim::Finding verdict;
};

std::vector<Expected> read_baseline() {
  std::vector<Expected> result;
  for (const CsvRow& row : csv_rows(data::baseline, {"system", "id", "verdict"})) {
    result.push_back({row.cells[0], row.cells[1], read_finding(row.cells[2])});
  }
  return result;
}

}  // namespace

std::vector<std::string> worsened(const SystemReproduction& result) {
  static const std::vector<Expected> baseline = read_baseline();
  std::vector<std::string> worse;
  for (const Expected& expected : baseline) {
    if (expected.system != result.system) continue;
    const auto found =
        std::find_if(result.values.begin(), result.values.end(),
                     [&](const ReproducedValue& v) { return v.printed.id == expected.id; });
    if (found != result.values.end() && found->verdict <= expected.verdict) continue;
    worse.push_back(fmt::format("{}: {} was {} and is {}", expected.system, expected.id,
                                to_string(expected.verdict),
                                found == result.values.end() ? "gone" : to_string(found->verdict)));
  }
  return worse;
}

}  // namespace camlaw::problems
