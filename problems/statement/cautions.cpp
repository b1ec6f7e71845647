// SPDX-License-Identifier: MIT
#include "problems/statement/cautions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "machines/contact/crowned_roller.h"
#include "machines/model/known_names.h"
#include "machines/model/main_sizes.h"
#include "problems/statement/bind.h"
#include "problems/statement/buildable.h"
#include "problems/statement/doubtful_angles.h"
#include "problems/statement/left_to_defaults.h"
#include "problems/statement/parameters.h"
#include "problems/statement/variation.h"

namespace camlaw::problems {
namespace {

bool speaks_of_jerk(const ResponseName& name) {
  return name.response != nullptr && is_of_jerk(*name.response);
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
  constexpr double kNoJump = 1e-6;  // beside s'' of 4, the least peak that there is
  const Law<double> law = design.laws.front().law<double>();
  const double begin = law.derivatives<3>(0.0, Side::Right)[2];
  const double end = law.derivatives<3>(1.0, Side::Left)[2];
  if (std::abs(begin) <= kNoJump && std::abs(end) <= kNoJump) return;
  found.push_back({"the acceleration jumps at an end of the law",
                   fmt::format("s'' begins with {:.4g} and ends with {:.4g}; next to a dwell the "
                               "jerk is infinite there, and limits and objectives use the jerk "
                               "between the ends",
                               begin, end)});
}

/// Whether a problem states a parameter, itself or by a part that it names.
bool states(const ProblemStatement& design, const std::string& parameter) {
  const auto at = parameter_called(*design.mechanism, parameter);
  return at && design.stated.contains(*at);
}

/// Whether a problem states a parameter, or asks for a response of the same family.
bool counts(const ProblemStatement& design, const std::string& parameter,
            const std::string& family) {
  if (states(design, parameter)) return true;
  const auto is_asked = [&](const auto& of) {
    return of.response.response != nullptr && of.response.response->name.starts_with(family);
  };
  return std::any_of(design.objectives.begin(), design.objectives.end(), is_asked) ||
         std::any_of(design.constraints.begin(), design.constraints.end(), is_asked);
}

/// Where a limit, an objective or a check is about a contact along the whole face, which a crowned
/// roller does not have. Of a shaft's cam the names begin with `prefix`.
void add_of_line_contact(const ProblemStatement& design, const std::string& prefix,
                         std::vector<Caution>& found) {
  if (!states(design, prefix + "crown_radius")) return;
  std::vector<std::string> asked;
  const auto ask = [&](const MechanismResponse* response) {
    if (response == nullptr) return;
    const std::string name = response->in_case ? response->in_case->response : response->name;
    if (!name.starts_with(prefix)) return;
    const std::string own = name.substr(prefix.size());
    if (crowned_twin(own).empty()) return;
    if (std::find(asked.begin(), asked.end(), own) == asked.end()) asked.push_back(own);
  };
  for (const ObjectiveStatement& o : design.objectives) ask(o.response.response);
  for (const ConstraintStatement& c : design.constraints) ask(c.response.response);
  for (const BuildableCheck* check : checks_for(design)) {
    const bool is_made = design.buildable.inputs.contains(prefix + "allowable_pressure");
    if (is_made) ask(find_response(*design.mechanism, check->response).response);
  }
  for (const std::string& own : asked) {
    found.push_back(
        {fmt::format("{}{} is that of a line contact, and the roller is crowned", prefix, own),
         fmt::format(
             "a crowned roller bears on an ellipse: where that is shorter than the face, the "
             "stress is higher and the film thinner; see {}{} and crown_fraction",
             prefix, crowned_twin(own))});
  }
}

/// Where the crown of a roller counts: a contact outside of what its formulas are checked for. On a
/// shaft each cam's names have a prefix.
void add_of_crown(const ProblemStatement& design, std::vector<Caution>& found) {
  constexpr std::string_view kElongation = "crown_elongation";
  for (const MechanismResponse& response : design.mechanism->responses) {
    if (!response.name.ends_with(kElongation)) continue;
    const std::string prefix = response.name.substr(0, response.name.size() - kElongation.size());
    add_of_line_contact(design, prefix, found);
    if (!counts(design, prefix + "crown_radius", prefix + "crown_")) continue;
    const EvaluatedResponse known = evaluate_response(design, response);
    const bool is_long = known.highest > kKnownElongation;
    if (!is_long && !(known.lowest > 0 && known.lowest < 1 / kKnownElongation)) continue;
    found.push_back(
        {"the contact of a crowned roller is outside the range in which its formulas were checked",
         fmt::format(
             "{} is {:.4g} at {:.4g} {}; from {:.2g} to {:.3g} {}crown_stress is within 0.5 % "
             "of Hertz's solution",
             response.name, is_long ? known.highest : known.lowest,
             is_long ? known.highest_at : known.lowest_at, known.along, 1 / kKnownElongation,
             kKnownElongation, prefix)});
  }
}

/// Variations of the law and the program, which searches and judged limits leave out. A law that is
/// chosen need not have what varies of another.
void add_of_varying_law(const ProblemStatement& design, std::vector<Caution>& found) {
  const auto sees_law = [](const auto& of) {
    return of.response.response != nullptr && of.response.response->sees_law;
  };
  const bool counts = std::any_of(design.objectives.begin(), design.objectives.end(), sees_law) ||
                      std::any_of(design.constraints.begin(), design.constraints.end(), sees_law);
  if (!counts) return;
  std::string names;
  for (const VariationStatement& variation : variations_of(design)) {
    if (!variation.parameter.of_law) continue;
    const std::vector<double> values = values_of(design, variation.parameter);
    if (variation.index >= values.size()) continue;
    names += fmt::format("{}{} ({})", names.empty() ? "" : ", ", variation.name(),
                         variation_text(variation, values[variation.index]));
  }
  if (names.empty()) return;
  found.push_back({"the limits are judged without a variation of the motion",
                   names + "; `camlaw tolerance` shows what it does to them"});
}

/// Where the objective or a limit depends on a main size that the file does not state.
void add_of_defaults(const ProblemStatement& design, std::vector<Caution>& found) {
  const bool asks = !design.objectives.empty() || !design.constraints.empty();
  if (!asks || design.mechanism->moved_by != MovedBy::Program) return;  // of published machines
  std::vector<std::string> names, values;
  for (const std::size_t i : left_to_defaults(design)) {
    const MechanismParameter& p = design.mechanism->parameters[i];
    if (!is_main_size(p.name)) continue;
    names.push_back(p.name);
    values.push_back(fmt::format("{} = {}", p.name, with_unit(design.constants[i], p.unit)));
  }
  if (names.empty()) return;
  const bool one = names.size() == 1;
  found.push_back({fmt::format("{} {} not stated", listed(names), one ? "is" : "are"),
                   fmt::format("the default{} {} {} used; state your own in [constants]",
                               one ? "" : "s", listed(values), one ? "is" : "are")});
}

void add_of_units(const ProblemStatement& design, std::vector<Caution>& found) {
  for (const std::string& doubt : doubtful_angles(design)) {
    found.push_back({"a number without a unit is suspiciously small", doubt});
  }
}

}  // namespace

std::vector<Caution> cautions_of_file(const ProblemStatement& problem) {
  std::vector<Caution> found;
  add_of_units(problem, found);
  add_of_defaults(problem, found);
  return found;
}

std::vector<Caution> cautions(const ProblemStatement& design) {
  std::vector<Caution> found = cautions_of_file(design);
  add_of_ends(design, found);
  add_of_crown(design, found);
  add_of_varying_law(design, found);
  return found;
}

}  // namespace camlaw::problems
