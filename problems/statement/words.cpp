// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "problems/statement/left_to_defaults.h"
#include "problems/statement/parameters.h"
#include "problems/statement/parts.h"
#include "problems/statement/profile_errors.h"
#include "problems/statement/program_timing.h"
#include "problems/statement/variation.h"

namespace camlaw::problems {
namespace {

using optim::Sense;

/// " (tolerance 0.01 mm)", where there is one.
std::string tolerance_note(const std::optional<double>& tolerance, const std::string& unit) {
  return tolerance ? fmt::format(" (tolerance {})", with_unit(*tolerance, unit)) : "";
}

std::string constants_sentence(const ProblemStatement& problem) {
  std::vector<std::string> parts, defaults;
  const std::vector<std::size_t> left = left_to_defaults(problem);
  for (const std::size_t i : used_parameters(problem)) {
    if (!is_constant(problem, i)) continue;
    const MechanismParameter& p = problem.mechanism->parameters[i];
    const bool is_default = std::find(left.begin(), left.end(), i) != left.end();
    const bool by_motion = problem.told_by_motion.contains(i) && !problem.stated.contains(i);
    (is_default ? defaults : parts)
        .push_back(fmt::format("{} = {}{}", p.name, with_unit(problem.constants[i], p.unit),
                               by_motion ? " (from the motion)" : ""));
  }
  std::string words = parts.empty() ? "" : fmt::format("It has {}.\n", listed(parts));
  if (!defaults.empty()) {
    words +=
        fmt::format("By default, as the file does not state them, it has {}.\n", listed(defaults));
  }
  return words;
}

/// What comes from catalogues.
std::string parts_sentences(const ProblemStatement& problem) {
  constexpr std::size_t kShown = 12;
  std::string words;
  for (const PartStatement& part : problem.parts) {
    const std::string& start = part.items[part.start].name;
    std::vector<std::string> names;
    for (const PartItem& item : part.items) names.push_back(item.name);
    if (!part.is_chosen()) {
      words += fmt::format("The {} is {} of {}.\n", part.name, start, part.catalogue);
    } else if (names.size() > kShown) {
      words += fmt::format("Choose the {} from {} of {}, starting at {}.\n", part.name,
                           names.size(), part.catalogue, start);
    } else {
      words += fmt::format("Choose the {} from {} of {}, starting at {}.\n", part.name,
                           listed(names), part.catalogue, start);
    }
    if (!part.is_chosen() || part.inputs.empty() || !problem.buildable.require) continue;
    words += fmt::format("Limits that need {} follow the {}; they are stated for {}.\n",
                         listed(part.inputs), part.name, start);
  }
  return words;
}

bool varies(const ProblemStatement& problem, const std::string& law_parameter,
            std::size_t element) {
  return std::any_of(problem.variables.begin(), problem.variables.end(), [&](const auto& v) {
    return v.of_law && v.law_parameter == law_parameter && v.element == element;
  });
}

/// "alpha = -3", "c = [-1.8, varies]"; empty where every number varies.
std::string fixed_text(const ProblemStatement& problem, const Parameter& parameter,
                       const std::vector<double>& values) {
  constexpr std::size_t kShown = 8;
  std::vector<std::string> parts;
  bool all_vary = true;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const bool varied = varies(problem, parameter.name, i);
    all_vary &= varied;
    parts.push_back(varied ? "varies" : fmt::format("{:.6g}", values[i]));
  }
  if (all_vary) return "";
  const std::string unit = parameter.unit == "1" ? "" : " " + parameter.unit;
  if (!parameter.list) return fmt::format("{} = {}{}", parameter.name, parts.front(), unit);
  if (parts.size() > kShown) return fmt::format("{} values of {}", parts.size(), parameter.name);
  return fmt::format("{} = [{}]{}", parameter.name, fmt::join(parts, ", "), unit);
}

/// A law with the parameters that stay, but for a crossover left where it is.
std::string law_text(const ProblemStatement& problem, const Member& law) {
  std::vector<std::string> fixed;
  for (std::size_t i = 0; i < law.arguments.size(); ++i) {
    const Parameter& parameter = law.family->parameters[i];
    const auto& values = law.arguments.list(i);
    if (parameter.name == kCrossover && values == parameter.default_value) continue;
    const std::string text = fixed_text(problem, parameter, values);
    if (!text.empty()) fixed.push_back(text);
  }
  const std::string what = law.family->listed ? fmt::format(", {}", law.family->formula) : "";
  return law.family->name + what + (fixed.empty() ? "" : fmt::format(" ({})", listed(fixed)));
}

std::string laws_sentence(const ProblemStatement& problem) {
  std::vector<std::string> laws;
  if (problem.mechanism->moved_by == MovedBy::Nothing) return "";
  if (!problem.cams.empty() && !problem.chooses_law()) {
    return fmt::format("The motions are {}.\n", problem.laws.front().family->formula);
  }
  if (problem.mechanism->moved_by == MovedBy::Program) {
    if (problem.chooses_law()) {
      return fmt::format("Choose one of {} motion programs; the first is {}.\n",
                         problem.laws.size(), problem.laws.front().family->formula);
    }
    return fmt::format(
        "The motion program is {}; displacements are in strokes: 0 is where the stroke begins, and "
        "1 "
        "is where it ends.\n",
        problem.laws.front().family->formula);
  }
  for (const Member& law : problem.laws) laws.push_back(law_text(problem, law));
  if (laws.size() == 1) {
    return fmt::format(
        "The motion law is {}{}.\n", laws.front(),
        problem.finds_knots ? "; the search adds knots where they improve the objective" : "");
  }
  return fmt::format("Choose the motion law among {}.\n", listed(laws));
}

/// Of a program that follows the speed, with the speed and the times that it has now.
ProgramTiming followed(ProgramTiming timing, const ProblemStatement& problem) {
  timing.speed = problem.constants[*speed_of(*problem.mechanism)];
  const Member& law = problem.laws.front();
  for (ProgramTiming::Segment& s : timing.segments) {
    s.time = law.arguments.scalar(*index_in(*law.family, s.name + "_time"));
  }
  return timing;
}

std::string timing_sentence(const ProblemStatement& problem) {
  if (!problem.timing) return "";
  ProgramTiming timing = *problem.timing;
  if (timing.follows) timing = followed(timing, problem);
  std::vector<std::string> times;
  for (const ProgramTiming::Segment& s : timing.segments) {
    times.push_back(
        fmt::format("{} takes {:.6g} s ({:.6g} deg)", s.name, s.time, timing.angle_of(s.time)));
  }
  return fmt::format(
      "At {:.6g} rpm a turn takes {:.6g} s{}{}.{}\n", timing.speed, timing.turn(),
      times.empty() ? "" : ": ", listed(times),
      timing.follows ? " At other speeds the times stay the same, and the angles change." : "");
}

/// " (of polynomial-5)", where not every law has what varies.
std::string owner_note(const ProblemStatement& problem, const VariableStatement& v) {
  std::vector<std::string> owners;
  for (const Member& law : problem.laws) {
    if (v.of_law && index_in(*law.family, v.law_parameter)) owners.push_back(law.family->name);
  }
  const bool all = owners.size() == problem.laws.size();
  return v.of_law && !all ? fmt::format(" (of {})", listed(owners)) : "";
}

std::string variable_sentence(const ProblemStatement& problem, const VariableStatement& v) {
  const std::string name = v.name + owner_note(problem, v);
  const std::string start = with_unit(v.start, v.unit);
  if (!v.values.empty()) {
    return fmt::format("Choose {} among {}, starting at {}.\n", name, values_text(v.values, v.unit),
                       start);
  }
  return fmt::format("Vary {} {} {:.6g} and {}{}, starting at {}.\n", name,
                     v.integer ? "in steps of 1 between" : "between", v.lower,
                     with_unit(v.upper, v.unit), measured_bounds(v), start);
}

/// Numbers of one list that vary together, beyond which they are not named one by one.
constexpr std::size_t kListedOneByOne = 12;

/// Where the run of variables from one on ends that are of one list and have bounds.
std::size_t end_of_list(const std::vector<VariableStatement>& all, std::size_t from) {
  const VariableStatement& first = all[from];
  std::size_t end = from + 1;
  while (end < all.size() && first.of_law && first.values.empty() && all[end].of_law &&
         all[end].law_parameter == first.law_parameter && all[end].values.empty()) {
    ++end;
  }
  return end;
}

std::string list_sentence(const ProblemStatement& problem, std::size_t from, std::size_t end) {
  const VariableStatement& v = problem.variables[from];
  const bool alike = std::all_of(
      problem.variables.begin() + static_cast<std::ptrdiff_t>(from),
      problem.variables.begin() + static_cast<std::ptrdiff_t>(end),
      [&](const auto& other) { return other.lower == v.lower && other.upper == v.upper; });
  return fmt::format(
      "Vary {} numbers of {}{} {}.\n", end - from, v.law_parameter, owner_note(problem, v),
      alike ? fmt::format("between {:.6g} and {}", v.lower, with_unit(v.upper, v.unit))
            : "each within bounds of its own");
}

std::string wanted_text(const ObjectiveStatement& objective) {
  const ResponseName& response = objective.response;
  return fmt::format("the {} {}{}{}", objective.sense == Sense::Minimize ? "least" : "greatest",
                     response.name, response.unit == "1" ? "" : fmt::format(" ({})", response.unit),
                     tolerance_note(objective.tolerance, response.unit));
}

/// "In the case fast it has speed = 400 rpm."
std::string cases_sentence(const ProblemStatement& problem) {
  std::string words;
  const bool weighs = std::any_of(problem.objectives.begin(), problem.objectives.end(),
                                  [](const auto& o) { return o.over == OverCases::Mean; });
  for (const LoadCase& load : problem.cases) {
    std::vector<std::string> parts;
    for (const auto& [parameter, value] : load.parameters) {
      const MechanismParameter& p = problem.mechanism->parameters[parameter];
      parts.push_back(p.name + " = " + with_unit(value, p.unit));
    }
    words += fmt::format("In the case {} it has {}{}.\n", load.name, listed(parts),
                         weighs ? fmt::format(", with weight {:.6g}", load.weight) : "");
  }
  return words;
}

/// "It has any speed between 100 and 400 rpm."
std::string ranges_sentence(const ProblemStatement& problem) {
  std::vector<std::string> parts;
  for (const ParameterRange& range : problem.ranges) {
    const MechanismParameter& p = problem.mechanism->parameters[range.parameter];
    parts.push_back(fmt::format("any {} between {:.6g} and {}", p.name, range.lower,
                                with_unit(range.upper, p.unit)));
  }
  return parts.empty() ? "" : fmt::format("It may have {}.\n", listed(parts));
}

/// "In manufacture base_radius varies by +-0.05 mm."
std::string variation_sentence(const ProblemStatement& problem) {
  std::vector<std::string> parts;
  for (const VariationStatement& v : variations_of(problem)) {
    parts.push_back(v.name() + " varies by " + variation_text(v, meant_value(problem, v)));
  }
  return parts.empty() ? "" : fmt::format("In manufacture {}.\n", listed(parts));
}

std::string objectives_sentence(const std::vector<ObjectiveStatement>& objectives) {
  if (objectives.empty()) return "There is no objective.\n";
  std::vector<std::string> wanted;
  for (const ObjectiveStatement& objective : objectives) wanted.push_back(wanted_text(objective));
  return fmt::format("Find {}{}.\n", wanted.size() > 1 ? "the front of " : "", listed(wanted));
}

std::string limits_text(const ConstraintStatement& c) {
  const std::string& unit = c.response.unit;
  if (c.lower && c.upper) {
    return *c.lower == *c.upper
               ? "equal to " + with_unit(*c.lower, unit)
               : fmt::format("between {:.6g} and {}", *c.lower, with_unit(*c.upper, unit));
  }
  return c.lower ? "at least " + with_unit(*c.lower, unit) : "at most " + with_unit(*c.upper, unit);
}

/// The numbers of checks of whether it can be built; those that are required are among the limits.
std::string buildable_sentence(const ProblemStatement& problem) {
  std::vector<std::string> parts;
  for (const BuildableInput& input : problem.mechanism->inputs) {
    const auto stated = problem.buildable.inputs.find(input.name);
    const PartStatement* part = part_with_input(problem, input.name);
    const bool is_chosen = part != nullptr && part->is_chosen();
    if (stated == problem.buildable.inputs.end() || is_chosen) continue;
    parts.push_back(input.name + " = " + with_unit(stated->second, input.unit));
  }
  const std::string& material = problem.buildable.material;
  if (!material.empty()) parts.push_back("material = " + material);
  return parts.empty() ? ""
                       : fmt::format("For the checks of [buildable] it has {}.\n", listed(parts));
}

std::string constraint_sentence(const ConstraintStatement& c) {
  const bool curve = c.response.response != nullptr && c.response.response->curve;
  const bool everywhere = curve && c.response.part == optim::Part::Value && !c.response.window;
  const bool is_size = c.is_size || c.response.part == optim::Part::Magnitude;
  const bool several = is_size || (c.lower && c.upper);
  const std::string share = c.reliability
                                ? fmt::format("{} for {:.6g} % of all parts",
                                              several ? ", each bound" : "", 100 * *c.reliability)
                                : "";
  const std::string by = c.of_check ? "[buildable]" : c.required_by.value_or("");
  return fmt::format("{} must be {}{}{}{}{}.\n", c.response.name, limits_text(c),
                     everywhere ? " over the whole cycle" : "", share,
                     tolerance_note(c.tolerance, c.response.unit),
                     by.empty() ? "" : fmt::format(", which {} requires", by));
}

/// "mu_strategy = adaptive, max_soc = 2".
std::string text(const optim::NativeOptions& options) {
  std::vector<std::string> parts;
  for (const auto& [name, value] : options) {
    parts.push_back(fmt::format("{} = {}", name, optim::to_text(value)));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string solver_sentence(const SolverStatement& solver) {
  std::vector<std::string> parts;
  if (solver.name) parts.push_back("with " + *solver.name);
  if (solver.starts) {
    parts.push_back(fmt::format("from {} start{}", *solver.starts, *solver.starts == 1 ? "" : "s"));
  }
  if (solver.seed) parts.push_back(fmt::format("with seed {}", *solver.seed));
  if (solver.time_limit) parts.push_back(fmt::format("for at most {:.6g} s", *solver.time_limit));
  std::string words = parts.empty() ? "" : fmt::format("Solve {}.\n", fmt::join(parts, ", "));
  for (const auto& [name, options] : solver.native) {
    if (!options.empty()) words += fmt::format("Run {} with {}.\n", name, text(options));
  }
  return words;
}

}  // namespace

std::string in_words(const ProblemStatement& problem) {
  std::string words = problem.title.empty() ? "" : problem.title + "\n\n";
  words +=
      fmt::format("The mechanism is {}: {}.\n", problem.mechanism->name, problem.mechanism->title);
  words += constants_sentence(problem) + cases_sentence(problem) + ranges_sentence(problem) +
           variation_sentence(problem) + laws_sentence(problem) + timing_sentence(problem);
  for (const LeftOut& left : problem.left_out) {
    words += fmt::format("Left out because it does not fit: {}: {}.\n", left.what, left.why);
  }
  words += parts_sentences(problem);
  for (std::size_t i = 0; i < problem.variables.size();) {
    const std::size_t next = end_of_list(problem.variables, i);
    words += next - i > kListedOneByOne ? list_sentence(problem, i, next)
                                        : variable_sentence(problem, problem.variables[i]);
    i = next - i > kListedOneByOne ? next : i + 1;
  }
  words += objectives_sentence(problem.objectives);
  for (const ConstraintStatement& c : problem.constraints) words += constraint_sentence(c);
  if (problem.profile) {
    words +=
        fmt::format("Its profile is judged with these errors: {}.\n", words_of(*problem.profile));
  }
  return words + buildable_sentence(problem) + solver_sentence(problem.solver);
}

}  // namespace camlaw::problems
