// SPDX-License-Identifier: MIT
#include "output/answers/warnings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include "optim/problem/inputs.h"
#include "output/answers/front_words.h"
#include "output/document/printing.h"
#include "problems/sensitivity/sensitivity.h"
#include "problems/statement/assignment.h"
#include "problems/statement/cautions.h"
#include "problems/statement/doubtful_limits.h"
#include "problems/statement/parameters.h"
#include "problems/statement/parts.h"
#include "problems/statement/variation.h"

namespace camlaw::cli {
namespace {

void add_cautions(const problems::ProblemStatement& design, Warnings& warnings) {
  for (const problems::Caution& caution : problems::cautions(design)) {
    warnings.push_back(caution.text());
  }
}

/// A fit's deviations follow from the size, by steps. A search takes those of the size that it
/// began with, whatever it finds.
void add_fits_of_other_sizes(const problems::ProblemStatement& begun,
                             const problems::ProblemStatement& design, Warnings& warnings) {
  for (const problems::VariationStatement& variation : problems::variations_of(begun)) {
    if (!variation.fit) continue;
    const double from = problems::meant_value(begun, variation);
    const double to = problems::meant_value(design, variation);
    const std::string& unit = variation.parameter.unit;
    const optim::Variation taken = variation.at(from);
    optim::Variation own;
    try {
      own = variation.at(to);
    } catch (const std::invalid_argument& error) {
      warnings.push_back(fmt::format("the fit of {} was taken at its start of {}: {}",
                                     variation.name(), problems::with_unit(from, unit),
                                     error.what()));
      continue;
    }
    if (taken.lower == own.lower && taken.upper == own.upper) continue;
    warnings.push_back(fmt::format(
        "the fit of {0} was taken at its start of {1}, {2:+.4g} and {3:+.4g} {7}; at {4} it is "
        "{5:+.4g} and {6:+.4g} {7}: search again with this start",
        variation.name(), problems::with_unit(from, unit), taken.upper, taken.lower,
        problems::with_unit(to, unit), own.upper, own.lower, unit));
  }
}

bool varies(const optim::Variable& v) { return v.lower < v.upper; }

/// Whether one of these variables varies.
bool any_varies(const optim::Problem& problem, const std::set<std::size_t>& variables) {
  return std::any_of(variables.begin(), variables.end(),
                     [&](std::size_t i) { return varies(problem.variables[i]); });
}

/// Where nothing that varies moves the objective, every design that meets the limits is as good:
/// which one is shown means nothing.
void add_still_objective(const optim::Problem& problem, Warnings& warnings) {
  const optim::Response& sought = problem.objective().response;
  const bool any = std::any_of(problem.variables.begin(), problem.variables.end(), varies);
  if (!any || any_varies(problem, optim::inputs_of(sought, problem))) return;
  warnings.push_back(fmt::format(
      "nothing that varies changes {}: any design that meets the limits is as good as this one",
      sought.name));
}

/// Of an optimum the variables that change neither the objective nor a limit with a price: where
/// they stand follows from where the search began.
void add_idle_variables(const optim::Optimum& optimum, Warnings& warnings) {
  constexpr std::size_t kNamed = 3;
  const optim::Problem& problem = optimum.problem;
  std::set<std::size_t> counting = optim::inputs_of(problem.objective().response, problem);
  if (!any_varies(problem, counting)) return;  // that is said of all
  std::set<std::string> pushing;
  for (const optim::LimitReport& limit : optimum.found.assessment.limits) {
    if (limit.multiplier != 0 || limit.at_rest) pushing.insert(limit.name);  // NaN among them
  }
  for (const optim::Constraint& c : problem.constraints) {
    if (pushing.contains(c.response.name)) counting.merge(optim::inputs_of(c.response, problem));
  }
  std::vector<std::string> idle;
  for (std::size_t i = 0; i < problem.variables.size(); ++i) {
    const optim::Variable& v = problem.variables[i];
    if (!varies(v) || counting.contains(i)) continue;
    idle.push_back(fmt::format("{} = {}", v.name, problems::with_unit(optimum.found.x[i], v.unit)));
  }
  if (idle.empty()) return;
  const std::size_t more = idle.size() > kNamed ? idle.size() - kNamed : 0;
  if (more > 0) idle.resize(kNamed);
  const std::string named =
      problems::listed(idle) + (more > 0 ? fmt::format(" and {} more", more) : "");
  const std::string& sought = problem.objective().response.name;
  warnings.push_back(
      idle.size() == 1
          ? fmt::format(
                "{} is one of many values: it changes neither {} nor a limit that holds the "
                "design; to choose it, limit or minimise what depends on it",
                named, sought)
          : fmt::format("{} are some of many values: they change neither {} nor a limit that holds "
                        "the design; to choose them, limit or minimise what depends on them",
                        named, sought));
}

/// The constants that would change a limit.
struct Movers {
  std::vector<std::string> names;
  std::string
      example;  ///< of them the one to let vary: the last that the file states, else the first
  std::vector<std::string> more, less;  ///< which help if larger, or smaller; no load of 0
};

bool is_machine_at_rest(const Law<double>& motion, double share) {
  constexpr double kRest = 1e-9;
  const auto at = motion(std::clamp(share, 0.0, 1.0));
  return std::abs(at.v) < kRest && std::abs(at.a) < kRest;
}

/// Whether a curve at a place of the cycle depends on the law's shape: at rest it does not.
bool sees_motion_at(const Answer& answer, const optim::Response& response, double place) {
  const std::optional<Member> law = answer.law();
  if (!law || !response.is_curve()) return true;
  const auto breaks = response.curve().trace(answer.optimum.found.x)->breaks();
  return !is_machine_at_rest(law->law(),
                             (place - breaks.front()) / (breaks.back() - breaks.front()));
}

/// The machine's parameters by which a limit has a slope at its worst place, whether the file
/// states them or not, and those that are integers.
Movers movers_of(const Answer& answer, const problems::ResponseName& asked,
                 const optim::LimitReport& limit) {
  // Of the value, for a change of the parameter by its size: of places that are equally high, to
  // 1e-9 of the value, one may stand just beside a rest.
  constexpr double kRounding = 1e-6;
  const optim::Optimum& optimum = answer.optimum;
  const problems::ProblemStatement design = answer.bound.at(optimum.options, optimum.found.x);
  const problems::LocalSensitivity local = problems::local_sensitivity(design);
  const auto numbers = problems::design_numbers(design, local.parameters);
  std::set<std::size_t> moving;
  std::map<std::size_t, double> slopes;  // of the value where it breaks the limit
  for (const std::size_t i : asked.response->uses) {
    if (design.mechanism->parameters[i].integer) moving.insert(i);
  }
  const optim::Part other = limit.is_upper ? optim::Part::Lowest : optim::Part::Highest;
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const problems::DesignNumber& number = numbers[k];
    if (number.is_objective || number.response.name != limit.name || number.part == other) continue;
    for (std::size_t i = 0; i < local.parameters.size(); ++i) {
      const problems::DesignParameter& parameter = local.parameters[i];
      const problems::Sensitivity& by = local.numbers[k].by[i];
      const double slope = std::max({std::abs(by.slope), std::abs(by.low), std::abs(by.high)});
      const double least = kRounding * std::max(std::abs(limit.value), std::abs(limit.bound));
      if (!(slope * std::max(std::abs(parameter.value), 1.0) > least)) continue;
      if (!parameter.of_machine || parameter.varies) continue;
      moving.insert(*parameter.of_machine);
      slopes[*parameter.of_machine] = by.low * by.high > 0 ? by.slope : 0;  // one sign, or none
    }
  }
  Movers result;
  for (const std::size_t i : moving) {
    result.names.push_back(design.mechanism->parameters[i].name);
    const bool is_used = design.stated.contains(i) || design.constants[i] != 0;
    if (result.example.empty() || design.stated.contains(i)) result.example = result.names.back();
    const double helps = (limit.is_upper ? -1 : 1) * slopes[i];
    if (helps == 0 || !is_used) continue;
    (helps > 0 ? result.more : result.less).push_back(result.names.back());
  }
  return result;
}

/// "a larger spring_rate or spring_preload, or a smaller speed, helps"; empty where nothing is
/// known to.
std::string what_helps(const Movers& movers) {
  const auto one_of = [](const char* how, const std::vector<std::string>& names) {
    if (names.empty()) return std::string();
    const std::string first = fmt::format("{}", fmt::join(names.begin(), names.end() - 1, ", "));
    return fmt::format("a {} {}{}{}", how, first, first.empty() ? "" : " or ", names.back());
  };
  const std::string more = one_of("larger", movers.more), less = one_of("smaller", movers.less);
  if (more.empty() && less.empty()) return "";
  return fmt::format("{}{}{} helps", more, more.empty() || less.empty() ? "" : ", or ", less);
}

/// Of limits that cannot be met: which constants would change them.
void add_what_changes(const Answer& answer, Warnings& warnings) {
  const problems::ProblemStatement& problem = answer.bound.statement();
  const optim::Optimum& optimum = answer.optimum;
  for (const std::string& blamed : optimum.found.assessment.blamed) {
    const auto& limits = optimum.problem.constraints;
    const auto limit = std::find_if(limits.begin(), limits.end(),
                                    [&](const auto& c) { return c.response.name == blamed; });
    const auto& all = problem.constraints;
    const auto stated = std::find_if(all.begin(), all.end(), [&](const auto& c) {
      return c.response.name == blamed && c.response.response != nullptr;
    });
    const auto& reports = optimum.found.assessment.limits;
    const auto report = std::find_if(reports.begin(), reports.end(),
                                     [&](const auto& r) { return r.name == blamed && !r.met; });
    if (limit == limits.end() || stated == all.end() || report == reports.end()) continue;
    const bool has_variables =
        any_varies(optimum.problem, optim::inputs_of(limit->response, optimum.problem));
    Movers movers;
    try {
      movers = movers_of(answer, stated->response, *report);
    } catch (const std::invalid_argument&) {
      continue;  // numbers without a value there: there is nothing to advise
    }
    if (movers.names.empty()) continue;
    const std::string helps = what_helps(movers);
    if (has_variables) {
      if (!helps.empty()) {
        warnings.push_back(fmt::format("{} depends on constants too: {}", blamed, helps));
      }
      continue;
    }
    const auto place = report->worst_angle;
    const bool sees_motion = stated->response.response->sees_law &&
                             (!place || sees_motion_at(answer, limit->response, *place));
    if (sees_motion) movers.names.emplace_back("the motion");
    const bool one = movers.names.size() == 1;
    warnings.push_back(fmt::format(
        "{} depends on {}{}: let {} vary, as [variables.{}] with lower and upper in place of its "
        "constant{}",
        blamed, problems::listed(movers.names), place ? " where it is worst" : "",
        one ? "it" : "one of them", movers.example, helps.empty() ? "" : "; " + helps));
  }
}

/// The laws of classes that make no program, which are not searched.
void add_left_out(const problems::ProblemStatement& problem, Warnings& warnings) {
  if (problem.left_out.empty()) return;
  std::vector<std::string> names;
  for (const problems::LeftOut& left : problem.left_out) names.push_back(left.what);
  warnings.push_back(fmt::format("left out because they do not fit: {}; 'camlaw check' says why",
                                 fmt::join(names, "; ")));
}

/// Of a problem's limits alone.
Warnings doubts_of(const problems::ProblemStatement& problem) {
  try {
    return problems::doubtful_limits(problems::BoundProblem(problem, true));
  } catch (const std::invalid_argument&) {
    return {};  // more combinations than can be searched: that is said where one searches
  }
}

}  // namespace

Warnings warnings_of_file(const problems::ProblemStatement& problem) {
  Warnings warnings;
  for (const problems::Caution& caution : problems::cautions_of_file(problem)) {
    warnings.push_back(caution.text());
  }
  const Warnings doubts = doubts_of(problem);
  warnings.insert(warnings.end(), doubts.begin(), doubts.end());
  return warnings;
}

Warnings warnings_of(const problems::ProblemStatement& design) {
  Warnings warnings;
  add_cautions(design, warnings);
  const Warnings doubts = doubts_of(design);
  warnings.insert(warnings.end(), doubts.begin(), doubts.end());
  return warnings;
}

Warnings warnings_of(const Answer& answer) {
  const optim::Optimum& optimum = answer.optimum;
  const optim::Verdict verdict = optimum.found.assessment.verdict;
  const bool has_design =
      verdict == optim::Verdict::Certified || verdict == optim::Verdict::Feasible;
  Warnings warnings;
  add_left_out(answer.bound.statement(), warnings);
  if (has_design) {
    const problems::ProblemStatement design = answer.bound.at(optimum.options, optimum.found.x);
    if (answer.bound.choices().empty()) add_still_objective(optimum.problem, warnings);
    if (verdict == optim::Verdict::Certified) add_idle_variables(optimum, warnings);
    add_fits_of_other_sizes(answer.bound.statement(), design, warnings);
    add_cautions(design, warnings);
  }
  if (verdict == optim::Verdict::Infeasible) {
    add_what_changes(answer, warnings);
  }
  const Warnings doubts = problems::doubtful_limits(answer.bound);
  warnings.insert(warnings.end(), doubts.begin(), doubts.end());
  return warnings;
}

Warnings begins_with_parts(const problems::ProblemStatement& problem,
                           const std::vector<std::string>& set) {
  Warnings warnings;
  for (const std::string& assignment : set) {
    const auto [name, row] = problems::parse_assignment(assignment, "speed=60 rpm");
    const problems::PartStatement* part = problems::find_part(problem, name);
    if (part == nullptr || !part->is_chosen()) continue;
    warnings.push_back(
        fmt::format("{0} = {1} is where the search begins, and it may choose another row; choose = "
                    "\"{1}\" next to its catalogue fixes it",
                    part->name, part->items[problems::item_named(*part, row)].name));
  }
  return warnings;
}

Warnings warnings_of(const FrontAnswer& answer) {
  struct Shared {
    std::vector<std::size_t> points;
    std::string detail;  ///< of the first of them
  };
  std::map<std::string, Shared> all;
  for (std::size_t k = 0; k < answer.front.points.size(); ++k) {
    for (const auto& caution : problems::cautions(answer.study.design(answer.front.points[k]))) {
      Shared& shared = all[caution.what];
      if (shared.points.empty()) shared.detail = caution.detail;
      shared.points.push_back(k);
    }
  }
  Warnings warnings;
  add_left_out(answer.study.bound().statement(), warnings);
  if (!answer.front.remark.empty()) warnings.push_back(answer.front.remark);
  for (const auto& [what, shared] : all) {
    warnings.push_back(fmt::format("at {} {}: {}{}", points_text(shared.points), what,
                                   shared.points.size() > 1 ? "at the first " : "", shared.detail));
  }
  const Warnings doubts = problems::doubtful_limits(answer.study.bound());
  warnings.insert(warnings.end(), doubts.begin(), doubts.end());
  return warnings;
}

std::string warnings_text(const Warnings& warnings) {
  std::string text;
  for (const std::string& warning : warnings) {
    text += fmt::format("{}: {}\n", shaded(kWarningWord, Shade::Unsure), warning);
  }
  return text;
}

}  // namespace camlaw::cli
