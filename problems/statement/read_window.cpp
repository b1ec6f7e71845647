// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <optional>
#include <stdexcept>
#include <string>

#include "kinematics/laws/side_by_side.h"
#include "machines/model/cycle.h"
#include "machines/model/shaft.h"
#include "machines/model/windowed.h"
#include "problems/statement/curve_places.h"
#include "problems/statement/parameters.h"
#include "problems/statement/reading.h"
#include "problems/statement/toml_reader.h"

namespace camlaw::problems {
namespace {

/// The segment of a cam that `over` names for a curve over its shaft's turn.
CycleWindow read_over_on_shaft(const Entry& over, const ProblemStatement& problem,
                               const MechanismResponse& response) {
  const Mechanism& shaft = *problem.mechanism;
  CycleWindow window{text_of(over)};
  located(over, [&] {
    const CamSegment named = cam_segment(window.segment, shaft);
    for (const Member& law : problem.laws) {
      window_at({named.segment}, Cycle{"deg", {{0, 360}}}, laws_side_by_side(law).at(named.cam));
    }
    const ShaftCam& cam = shaft.cams[named.cam];
    if (response.uses.holds(cam.phase)) return;
    throw std::invalid_argument(
        fmt::format("{} does not depend on {}, whose segment this is; write from and to",
                    response.name, cam.name));
  });
  return window;
}

/// The segment that `over` names, which every law must have.
CycleWindow read_over(const Entry& over, const ProblemStatement& problem,
                      const MechanismResponse& response) {
  if (!problem.cams.empty() && !response.cam && runs_over_turn(response)) {
    return read_over_on_shaft(over, problem, response);
  }
  CycleWindow window{text_of(over)};
  const bool is_of_cam = response.cam && !problem.cams.empty();
  const Mechanism& mechanism =
      is_of_cam ? *problem.mechanism->cams[*response.cam].mechanism : *problem.mechanism;
  if (mechanism.moved_by != MovedBy::Program || !response.cycle) {
    refuse(over, fmt::format("{} has no motion program, whose segments have names; write from and "
                             "to",
                             mechanism.name));
  }
  located(over, [&] {
    for (const Member& law : problem.laws) {
      window_at(window, *response.cycle,
                is_of_cam ? laws_side_by_side(law).at(*response.cam) : law);
    }
  });
  return window;
}

/// An end of the window; where it is not stated, that of the cycle.
double read_end(const Entry* entry, const CurvePlaces& all, double otherwise) {
  if (entry == nullptr) return otherwise;
  const double value = quantity_of(*entry, all.unit);
  if (const std::string why = why_outside(value, all); !why.empty()) refuse(*entry, why);
  return value;
}

}  // namespace

void read_window(const Entry& table, const ProblemStatement& problem, ResponseName& response) {
  const Entry *over = find(table, "over"), *from = find(table, "from"), *to = find(table, "to");
  const Entry* const any = over != nullptr ? over : from != nullptr ? from : to;
  if (any == nullptr) return;
  if (response.response == nullptr || !response.response->curve) {
    refuse(*any, fmt::format("{} is a number, which has no places in the cycle; a window is for "
                             "curves and their peaks",
                             response.name));
  }
  const std::optional<CurvePlaces> all = places_of(*response.response);
  if (!all) refuse(*any, fmt::format("{} takes no windows", response.name));
  if (over != nullptr) {
    if (from != nullptr || to != nullptr) {
      refuse(from != nullptr ? *from : *to, "over already says where; drop one of the two");
    }
    response.window = read_over(*over, problem, *response.response);
    response.name += " over " + response.window->segment;
    return;
  }
  CycleWindow window{"", read_end(from, *all, all->begin), read_end(to, *all, all->end)};
  if (!(window.from < window.to)) {
    refuse(*any,
           fmt::format("the window from {} to {} is empty; state one that crosses the end of the "
                       "cycle as two limits",
                       with_unit(window.from, all->unit), with_unit(window.to, all->unit)));
  }
  response.name += fmt::format(" from {:.6g} to {}", window.from, with_unit(window.to, all->unit));
  response.window = window;
}

}  // namespace camlaw::problems
