// SPDX-License-Identifier: MIT
#include "problems/statement/buildable.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "machines/model/known_names.h"
#include "problems/statement/added_part.h"
#include "problems/statement/bind.h"
#include "problems/statement/check_limits.h"
#include "problems/statement/law_rooms.h"
#include "problems/statement/parameters.h"
#include "problems/statement/parts.h"
#include "problems/statement/ranges.h"
#include "problems/statement/variation.h"

namespace camlaw::problems {
namespace {

using optim::Part;

/// Whether the bound is counted from a keyway that the problem states for the same cam.
bool is_beyond_keyway(const BuildableCheck& check, const ProblemStatement& problem) {
  constexpr std::string_view kWall = "wall";
  if (!check.input.ends_with(kWall)) return false;
  const std::string of_cam = check.input.substr(0, check.input.size() - kWall.size());
  return problem.buildable.inputs.contains(of_cam + "keyway_depth");
}

/// Which material a permissible pressure is of, and who says so.
std::string material_of(const BuildableCheck& check, const ProblemStatement& problem) {
  const PartStatement* part = part_behind(check, problem);
  if (part == nullptr) return problem.buildable.material;
  const PartItem& item = part->items[part->start];
  return fmt::format("{}, {}", item.name, item.source.empty() ? part->catalogue : item.source);
}

std::string note_of(const BuildableCheck& check, const ProblemStatement& problem) {
  const auto& needs = check.needs;
  const bool pressed = std::any_of(needs.begin(), needs.end(), is_allowable_pressure);
  if (pressed) return material_of(check, problem);
  const bool is_own = problem.buildable.inputs.contains(check.input);
  if (!is_beyond_keyway(check, problem)) return is_own ? "" : check.standard;
  return (is_own ? "wall" : check.standard) + " beyond keyway_depth";
}

/// Whether intervals prove it, where it is a number.
void judge(BuildableAnswer& answer) {
  const optim::LimitReport& report = answer.report;
  if (std::isnan(report.margin)) {
    answer.built = Built::Fails;  // there is no such profile, or no such contact
  } else if (!report.met) {
    answer.built = Built::Fails;
  } else if (report.proved) {
    answer.built = Built::Holds;
  } else {
    answer.why = "it holds wherever it was evaluated, which is not a proof";
  }
}

/// Whether a check is made with the same machine as another: not with a rigid train where the other
/// has an elastic one.
bool goes_with(const BuildableCheck& first, const BuildableCheck& check) {
  return (first.only_with.empty() || first.only_with == check.only_with) &&
         (first.only_without.empty() || first.only_without == check.only_without);
}

/// What was judged and waits for a check that does not hold says nothing.
void await(std::vector<BuildableAnswer>& answers) {
  for (BuildableAnswer& answer : answers) {
    if (!answer.limit.of_check) continue;
    for (const BuildableAnswer& first : answers) {
      const auto& after = answer.check->after;
      const bool waits = std::find(after.begin(), after.end(), first.check->name) != after.end() &&
                         goes_with(*first.check, *answer.check);
      if (!waits || first.built == Built::Holds) continue;
      answer.built = Built::NotChecked;
      answer.why = fmt::format("{} {}", first.check->name,
                               first.built == Built::Fails ? "fails" : "is not checked");
    }
  }
}

/// How the design stands to the limits of these answers that have none missing.
std::vector<optim::LimitReport> reports_of(const ProblemStatement& design,
                                           const std::vector<BuildableAnswer>& answers) {
  ProblemStatement asked = design;
  asked.constraints.clear();
  for (const BuildableAnswer& answer : answers) {
    if (answer.why.empty()) asked.constraints.push_back(answer.limit);
  }
  return standing(asked);
}

}  // namespace

int Buildability::count(Built built) const {
  return static_cast<int>(
      std::count_if(checks.begin(), checks.end(), [&](const auto& a) { return a.built == built; }));
}

Buildability buildability(const ProblemStatement& design) {
  Buildability result{{}, design.buildable.require};
  if (design.laws.empty()) return result;
  for (const BuildableCheck* check : checks_for(design)) {
    BuildableAnswer answer{check, Built::NotChecked, missing(*check, design)};
    if (answer.why.empty()) answer.limit = limit_of(*check, design);
    if (answer.why.empty()) answer.note = note_of(*check, design);
    result.checks.push_back(std::move(answer));
  }
  const std::vector<optim::LimitReport> reports = reports_of(design, result.checks);
  std::size_t next = 0;
  for (BuildableAnswer& answer : result.checks) {
    if (!answer.why.empty()) continue;
    answer.report = reports[next++];
    answer.report.name = answer.limit.response.name;
    judge(answer);
  }
  await(result.checks);
  return result;
}

const BuildableInput* find_input(const Mechanism& mechanism, std::string_view name) {
  const auto& all = mechanism.inputs;
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const auto& input) { return input.name == name; });
  return found == all.end() ? nullptr : &*found;
}

double accepted_input(const BuildableInput& input, double value) {
  if (value > 0) return value;
  throw std::invalid_argument(
      fmt::format("{} is {}; it must be above 0", input.name, with_unit(value, input.unit)));
}

}  // namespace camlaw::problems
