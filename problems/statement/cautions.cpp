// SPDX-License-Identifier: MIT
#include "problems/statement/cautions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "problems/statement/bind.h"
#include "problems/statement/parameters.h"

namespace camlaw::problems {
namespace {

constexpr const char* kUndercut = "the profile is undercut";
constexpr const char* kTool = "the tool does not fit a hollow of the profile";

std::string at_place(double place, const std::string& unit) {
  return fmt::format("at {:.4g}{}", place + 0.0, unit == "1" ? "" : " " + unit);
}

std::optional<double> find_constant(const ProblemStatement& design, std::string_view name) {
  const auto& all = design.mechanism->parameters;
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const auto& p) { return p.name == name; });
  if (found == all.end()) return {};
  return design.constants[static_cast<std::size_t>(found - all.begin())];
}

bool is_or_ends_with(std::string_view name, std::string_view part) {
  return name == part || name.ends_with("_" + std::string(part));
}

/// Whether the roller runs in a groove, so that the cam has an outer flank: only the problem knows.
bool asks_for_groove(const ProblemStatement& problem) {
  const auto is_of_groove = [](const ResponseName& name) {
    return name.name.find("groove") != std::string::npos ||
           name.name.find("outer_undercut") != std::string::npos;
  };
  const auto& wanted = problem.objectives;
  const auto& limits = problem.constraints;
  return std::any_of(wanted.begin(), wanted.end(),
                     [&](const auto& o) { return is_of_groove(o.response); }) ||
         std::any_of(limits.begin(), limits.end(),
                     [&](const auto& c) { return is_of_groove(c.response); });
}

bool is_flat_faced(const Mechanism& mechanism) {
  return std::any_of(mechanism.peaks.begin(), mechanism.peaks.end(),
                     [](const NamedPeak& peak) { return peak.name == "least_profile_radius"; });
}

void add_of_curve(const ProblemStatement& design, const MechanismResponse& response,
                  std::vector<Caution>& found) {
  const bool undercut = is_or_ends_with(response.name, "undercut") &&
                        (response.name != "outer_undercut" || asks_for_groove(design));
  const bool tool = is_or_ends_with(response.name, "tool_fit");
  const bool radius = response.name == "profile_radius" && is_flat_faced(*design.mechanism);
  if (!undercut && !tool && !radius) return;
  const EvaluatedResponse r = evaluate_response(design, response);
  if (undercut && r.highest >= 1) {
    found.push_back({kUndercut, fmt::format("{} reaches {:.4g} {}, and a cusp begins at 1", r.name,
                                            r.highest, at_place(r.highest_at, r.along))});
  }
  if (tool && r.highest > 1) {
    found.push_back({kTool, fmt::format("{} reaches {:.4g} {}, and 1 is the most", r.name,
                                        r.highest, at_place(r.highest_at, r.along))});
  }
  if (radius && r.lowest <= 0) {
    found.push_back(
        {kUndercut, fmt::format("{} falls to {} {}, and a cusp begins at 0", r.name,
                                with_unit(r.lowest, r.unit), at_place(r.lowest_at, r.along))});
  }
}

void add_of_contact(const ProblemStatement& design, const MechanismResponse& response,
                    std::vector<Caution>& found) {
  const auto speed = find_constant(design, "speed");
  if (response.name != "contact_loss_speed" || !speed) return;
  const EvaluatedResponse r = evaluate_response(design, response);
  if (!(r.value < *speed)) return;
  found.push_back({"the follower leaves the cam",
                   fmt::format("contact is lost from {} on, and the cam runs at {}",
                               with_unit(r.value, r.unit), with_unit(*speed, r.unit))});
}

void add_of_bore(const ProblemStatement& design, std::vector<Caution>& found) {
  const auto base = find_constant(design, "base_radius"),
             bore = find_constant(design, "bore_radius");
  if (!base || !bore || !(*base <= *bore)) return;
  found.push_back({"the bore takes the whole base circle",
                   fmt::format("base_radius is {} and bore_radius {}", with_unit(*base, "mm"),
                               with_unit(*bore, "mm"))});
}

bool speaks_of_jerk(const ResponseName& name) {
  return name.response != nullptr && name.response->name.find("jerk") != std::string::npos;
}

/// Where the jerk of a law is sought or limited: what stands beside its ends is not part of the
/// law, so a jump of the acceleration there is in none of its responses.
void add_of_ends(const ProblemStatement& design, std::vector<Caution>& found) {
  const auto& sought = design.objectives;
  const auto& limits = design.constraints;
  const bool jerk = std::any_of(sought.begin(), sought.end(),
                                [](const auto& o) { return speaks_of_jerk(o.response); }) ||
                    std::any_of(limits.begin(), limits.end(),
                                [](const auto& c) { return speaks_of_jerk(c.response); });
  if (!jerk || design.mechanism->moved_by != MovedBy::Law || design.laws.empty()) return;
  constexpr double kNone = 1e-6;  // beside s'' of 4, the least peak that there is
  const Law<double> law = design.laws.front().law<double>();
  const double begin = law.derivatives<3>(0.0, Side::Right)[2];
  const double end = law.derivatives<3>(1.0, Side::Left)[2];
  if (std::abs(begin) <= kNone && std::abs(end) <= kNone) return;
  found.push_back({"the acceleration jumps at an end of the law",
                   fmt::format("s'' begins with {:.4g} and ends with {:.4g}; beside a dwell the "
                               "jerk is infinite there, and the jerk that is limited or sought is "
                               "that between the ends",
                               begin, end)});
}

}  // namespace

std::vector<Caution> cautions(const ProblemStatement& design) {
  std::vector<Caution> found;
  for (const MechanismResponse& response : design.mechanism->responses) {
    if (response.curve) {
      add_of_curve(design, response, found);
    } else {
      add_of_contact(design, response, found);
    }
  }
  add_of_bore(design, found);
  add_of_ends(design, found);
  // Of a profile that is undercut what a tool would do in its hollows says nothing.
  const auto is = [](const char* what) { return [=](const Caution& c) { return c.what == what; }; };
  if (std::any_of(found.begin(), found.end(), is(kUndercut))) std::erase_if(found, is(kTool));
  return found;
}

}  // namespace camlaw::problems
