// SPDX-License-Identifier: MIT
#include "problems/sweeps/sweep_study.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "optim/search/optimise.h"
#include "optim/verdict/verdict.h"
#include "problems/fronts/problem_settings.h"
#include "problems/law_files/json_text.h"
#include "problems/statement/assignment.h"
#include "problems/statement/auto_knots.h"
#include "problems/statement/impossible_values.h"
#include "problems/statement/law_names.h"
#include "problems/statement/parameters.h"
#include "problems/statement/parts.h"
#include "problems/statement/ranges.h"
#include "problems/statement/restated.h"
#include "problems/sweeps/optimum_point.h"

namespace camlaw::problems {
namespace {

ProblemStatement read_and_set(const std::string& text, const std::string& source,
                              const std::vector<std::string>& set, HeldFiles files) {
  ProblemStatement statement = read_problem(text, source, std::move(files));
  set_values(statement, set);
  return statement;
}

/// Leaves of each part that is named here the row that is named; the same words in a file that is
/// searched once are where that search begins.
void fix_parts(ProblemStatement& statement, const std::vector<std::string>& assignments) {
  for (const std::string& assignment : assignments) {
    const auto [name, row] = parse_assignment(assignment, "speed=60:15:120 rpm");
    const PartStatement* part = find_part(statement, name);
    if (part != nullptr) keep_item(statement, part->name, item_named(*part, row));
  }
}

/// What is swept; where that is nothing, a value that is refused is the likelier mistake.
const SweepSettings& with_good_values(const std::string& text, const std::string& source,
                                      const SweepSettings& settings, const HeldFiles& files) {
  if (settings.axes.empty() && !settings.sampling) {
    read_and_set(text, source, settings.set, files);
  }
  return settings;
}

void check_objectives(const ProblemStatement& statement, bool evaluates) {
  if (statement.objectives.empty()) {
    throw std::invalid_argument(fmt::format(
        "{}: a sweep compares designs by an objective; the file states none", statement.source));
  }
  if (statement.objectives.size() > 1 && !evaluates) {
    throw std::invalid_argument(
        fmt::format("{}: it has {} objectives; 'camlaw pareto' searches for its front, and "
                    "'camlaw sweep --evaluate' evaluates designs of it",
                    statement.source, statement.objectives.size()));
  }
}

/// As `camlaw optimize` searches where the command line says nothing.
optim::OptimiseOptions options_of(const SolverStatement& solver) {
  optim::OptimiseOptions options;
  options.solver = solver.name.value_or("auto");
  options.starts = solver.starts;
  options.seed = solver.seed.value_or(options.seed);
  options.time_limit = solver.time_limit;
  options.native = solver.native;
  return options;
}

/// Those that try every value of an axis or, of very many, some.
std::vector<std::size_t> tried(std::size_t count, std::size_t most) {
  std::vector<std::size_t> all;
  const std::size_t tries = std::min(count, most);
  for (std::size_t i = 0; i < tries; ++i)
    all.push_back(tries < 2 ? 0 : i * (count - 1) / (tries - 1));
  return all;
}

/// "stroke" of "stroke", "ranges.stroke.upper", "variation.stroke.lower" and "cases.fast.stroke".
std::string parameter_of_swept(const std::string& name) {
  for (const std::string_view table : {"ranges.", "variation."}) {
    const std::size_t end = name.rfind('.');
    if (name.starts_with(table) && end > table.size()) {
      return name.substr(table.size(), end - table.size());
    }
  }
  const std::string_view cases = "cases.";
  const std::size_t dot = name.starts_with(cases) ? name.find('.', cases.size()) : name.npos;
  return dot == name.npos ? name : name.substr(dot + 1);
}

/// Of a swept name that is of a parameter; of any other none.
std::string unit_of_swept(const ProblemStatement& statement, const std::string& name) {
  try {
    const std::string unit = find_parameter(statement, parameter_of_swept(name)).unit;
    return unit == "1" ? "" : unit;
  } catch (const std::invalid_argument&) {  // the bound of a limit, an angle of a segment
    return "";
  }
}

/// Why a swept value is refused, with the value where the reason does not name it.
std::string refusal(const std::string& name, const std::string& value, const std::string& why) {
  if (why.find(value) != std::string::npos) return why;
  return fmt::format("with {} = {}: {}", name, value, why);
}

}  // namespace

std::size_t SweptCombinations::done() const {
  return static_cast<std::size_t>(
      std::count_if(outcomes.begin(), outcomes.end(), [](const auto& o) { return o.has_value(); }));
}

SweepStudy::SweepStudy(const std::string& text, const std::string& source,
                       const SweepSettings& settings, HeldFiles files)
    : plan_(with_good_values(text, source, settings, files)),
      statement_(read_and_set(text, source, plan_.settings().set, std::move(files))),
      options_(options_of(statement_.solver)) {
  fix_parts(statement_, settings.fixed);
  check_objectives(statement_, settings.evaluates);
  refuse_auto_knots(statement_, "a sweep");
  refuse_reliabilities(statement_, "a sweep");
  check_values();
  plan_.take_units([&](const std::string& name) { return unit_of_swept(statement_, name); });
}

bool SweepStudy::is_sweep(const optim::StudySettings& settings) {
  return settings.contains(kSweepSetting);
}

SweepStudy SweepStudy::of(const optim::StudySettings& settings) {
  SweepStudy study(
      find_setting(settings, "problem"), find_setting(settings, "source"),
      sweep_settings(parse_json(find_setting(settings, kSweepSetting)), set_of(settings)),
      files_of(settings));
  check_laws(find_setting(settings, "laws"), study.settings().at("laws"));
  return study;
}

bool SweepStudy::is_start(const SweptName& name) const {
  if (plan_.settings().evaluates || !name.is_numeric) return false;
  try {
    const NamedParameter parameter = find_parameter(statement_, name.name);
    return find_variable(statement_, parameter, parameter.element.value_or(0)).has_value();
  } catch (const std::invalid_argument&) {  // a bound, an angle of a segment: no parameter
    return false;
  }
}

optim::StudySettings SweepStudy::settings() const {
  optim::StudySettings result = problem_settings(statement_);
  result[kSweepSetting] = to_json(plan_.settings()).dump();
  result["seed"] = fmt::format("{}", options_.seed);
  result["solver"] = options_.solver;
  return result;
}

void SweepStudy::check_same(const optim::StudyRecord& record) const {
  const optim::StudySettings mine = settings(), its = record.settings();
  check_kind(its, "a sweep");
  check_same_problem(its, mine);
  if (find_setting(its, "set") != mine.at("set") ||
      find_setting(its, kSweepSetting) != mine.at(kSweepSetting)) {
    refuse_to_resume("it belongs to another sweep: other values are set or swept");
  }
  check_same_settings(its, mine, {"versions", "seed", "solver"});
}

Possible<ProblemStatement> SweepStudy::stated(std::size_t combination) const {
  try {
    ProblemStatement statement = statement_;
    const std::vector<std::string> own = plan_.assignments(combination);
    set_values(statement, own);
    fix_parts(statement, own);
    return statement;
  } catch (const std::invalid_argument& refused) {  // values that are not possible together
    return Impossible{refused.what()};
  }
}

Possible<BoundProblem> SweepStudy::bound(std::size_t combination) const {
  Possible<ProblemStatement> statement = stated(combination);
  if (!statement) return statement.reason();
  try {
    return BoundProblem(std::move(*statement), plan_.settings().evaluates);
  } catch (const std::invalid_argument& refused) {
    return Impossible{refused.what()};
  }
}

/// Whether a text names a law; the files of the study get what it names.
bool SweepStudy::is_law(const std::string& text) {
  Entry name;
  name.kind = Entry::Kind::Text;
  name.place = statement_.source;
  name.text = text;
  try {
    read_law_name(name, statement_.files);
    return true;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

/// Whether a value says something, be it possible or not: a number in a unit, or a law that is
/// there. Any other word that is refused is taken for a slip of the pen.
bool SweepStudy::is_well_written(const SweepAxis& axis, std::size_t value) {
  return axis.is_numeric() || (is_law_setting(axis.name) && is_law(axis.values[value]));
}

/// What can be seen to be a mistake is refused before anything is worked out: a misspelt word, and
/// a name or a unit of which no value is possible. A value that is well written, but that no
/// combination takes, is left to its combinations, which tell why. What files the values name is
/// read here, once.
void SweepStudy::check_values() {
  // Each try reads the statement with its values; a value that is wrong by itself fails in all of
  // them, and an axis of numbers fails at its ends first.
  constexpr std::size_t kValues = 100, kTries = 64;
  std::size_t step = plan_.size();
  for (const SweepAxis& axis : plan_.settings().axes) {
    const std::size_t count = axis.values.size(), block = step;
    step /= count;
    if (axis.is_class) continue;
    std::optional<std::string> first_refused;
    bool is_any_taken = false;
    for (const std::size_t value : tried(count, axis.is_numeric() ? kValues : count)) {
      std::optional<std::string> why;
      for (const std::size_t k : tried(plan_.size() / count, kTries)) {
        // The k-th of the combinations with this value.
        const std::size_t combination = k / step * block + value * step + k % step;
        const auto possible = stated(combination);
        if (possible) {
          // A study keeps the files that swept values name, as it keeps the problem's own.
          statement_.files = possible->files;
          why.reset();
          break;
        }
        if (!why) why = possible.why();
      }
      if (!why) {
        is_any_taken = true;
      } else if (is_well_written(axis, value)) {
        if (!first_refused) first_refused = why;
      } else {
        throw std::invalid_argument(refusal(axis.name, axis.values[value], *why));
      }
    }
    if (!is_any_taken && first_refused) {
      throw std::invalid_argument(refusal(axis.name, axis.values.front(), *first_refused));
    }
  }
  if (!plan_.settings().sampling) return;
  std::optional<std::string> why;
  for (const std::size_t k : tried(plan_.size(), kTries)) {
    const auto possible = stated(k);
    if (possible) return;
    if (why) continue;
    why = fmt::format("with {}: {}", fmt::join(plan_.assignments(k), ", "), possible.why());
  }
  throw std::invalid_argument(*why);
}

optim::Problem SweepStudy::problem(std::size_t combination, optim::Design recorded) const {
  const auto problem = bound(combination);
  if (!problem) return {};
  const auto split = split_of(*problem, recorded);
  if (!split) return {};
  return as_recorded(problem->problem(split->options), problem->choices());
}

std::vector<SweptVariable> SweepStudy::variables(std::size_t combination,
                                                 optim::Design recorded) const {
  constexpr double kAtBound = 1e-9;  // of the bounds' distance
  std::vector<SweptVariable> result;
  const auto problem = bound(combination);
  if (!problem) return result;
  const auto split = split_of(*problem, recorded);
  if (!split) return result;
  const optim::Problem own = problem->problem(split->options);
  for (std::size_t i = 0; i < std::min(own.variables.size(), split->x.size()); ++i) {
    const optim::Variable& v = own.variables[i];
    const double x = split->x[i], near = kAtBound * (v.upper - v.lower);
    result.push_back({v.name, v.unit, x, "", x - v.lower <= near, v.upper - x <= near});
  }
  for (std::size_t i = 0; i < split->options.size(); ++i) {
    const optim::Choice& choice = problem->choices()[i];
    const std::size_t option = split->options[i];
    const double number = choice.values.empty() ? std::nan("") : choice.values[option];
    result.push_back({choice.name, choice.unit, number, choice.options[option]});
  }
  return result;
}

ProblemStatement SweepStudy::design(std::size_t combination, optim::Design recorded) const {
  const auto problem = bound(combination);
  const auto split = split_of(problem.value(), recorded);
  if (!split) throw std::invalid_argument("the design does not belong to its combination");
  return problem->at(split->options, split->x);
}

/// Not where the combination has choices of its own, or other variables than its neighbour.
bool SweepStudy::begins_at_neighbour(const optim::Task& task) const {
  if (task.starts.empty()) return false;
  const auto problem = bound(task.part);
  return problem && beginning_at(*problem, task.starts.front()).has_value();
}

optim::Outcome SweepStudy::searched(const optim::Task& task, const BoundProblem& bound,
                                    const optim::OptimiseOptions& options) const {
  const optim::ProblemSpace space = bound.space();
  optim::OptimiseOptions own = options;
  own.seed = task.seed;
  long evaluations = 0;
  std::optional<optim::Optimum> found;
  if (!task.starts.empty()) {
    if (const auto warm = beginning_at(bound, task.starts.front())) {
      optim::OptimiseOptions once = own;
      once.starts = 1;
      found = optim::optimise(optim::ProblemSpace::of(*warm), once);
      found->options = options_at_start(bound);
      evaluations += found->found.evaluations;
    }
  }
  if (!found || found->found.assessment.verdict != optim::Verdict::Certified) {
    optim::Optimum cold = optim::optimise(space, own);
    evaluations += cold.found.evaluations;
    const bool is_better =
        !found || optim::better(cold.problem, cold.found.assessment, found->found.assessment);
    if (is_better) found = std::move(cold);
  }
  say_impossible(bound, *found);
  return outcome_of(*found, task.part, evaluations);
}

optim::Outcome SweepStudy::carry_out(const optim::Task& task,
                                     const optim::OptimiseOptions& options) const {
  return optim::safely([&] {
    const auto problem = bound(task.part);
    optim::Outcome outcome;
    if (!problem) {
      outcome.failure = problem.why();
    } else if (plan_.settings().evaluates) {
      outcome = evaluated(*problem, task.part);
    } else {
      outcome = searched(task, *problem, options);
    }
    return outcome;
  });
}

namespace {

/// The chains of a run: what each comes to next, and where it begins.
struct Chain {
  std::vector<std::size_t> combinations;
  std::size_t next = 0;
  std::optional<std::vector<double>> start = {};
};

}  // namespace

SweptCombinations SweepStudy::run(optim::Executor& executor,
                                  const std::function<void(const SweepProgress&)>& progress) const {
  SweptCombinations sweep{.outcomes = std::vector<std::optional<optim::Outcome>>(plan_.size()),
                          .is_warm = std::vector<bool>(plan_.size(), false)};
  SweepProgress told{.all = plan_.size()};
  const optim::Sense sense = statement_.objectives.front().sense;
  const auto take = [&](const optim::Task& task, const optim::Outcome& outcome) {
    sweep.outcomes[task.part] = outcome;
    sweep.is_warm[task.part] = begins_at_neighbour(task);
    ++told.done;
    for (const optim::FrontPoint& point : outcome.points) {
      const double value = point.objectives.front();
      const bool is_least = sense == optim::Sense::Minimize;
      const bool is_good = point.verdict != optim::Verdict::Failed && std::isfinite(value);
      if (!is_good || (told.best && (is_least ? value >= *told.best : value <= *told.best)))
        continue;
      told.best = value;
    }
    if (progress) progress(told);
  };
  std::vector<Chain> chains;
  for (auto& chain : plan_.chains()) chains.push_back({std::move(chain)});
  while (!chains.empty() && !(options_.stop != nullptr && *options_.stop)) {
    std::vector<optim::Task> tasks;
    for (const Chain& chain : chains) {
      optim::Task task;
      task.part = chain.combinations[chain.next];
      task.bounds = std::vector<double>(statement_.objectives.size(), optim::kInfinity);
      task.seed = options_.seed;
      if (chain.start) task.starts = {*chain.start};
      tasks.push_back(std::move(task));
    }
    executor.run(tasks, take);
    for (Chain& chain : chains) {
      const auto& outcome = sweep.outcomes[chain.combinations[chain.next]];
      const bool has_design = outcome && !outcome->points.empty();
      chain.start = has_design ? std::optional(outcome->points.front().x) : std::nullopt;
      chain.next = outcome ? chain.next + 1 : chain.combinations.size();
    }
    std::erase_if(chains, [](const Chain& c) { return c.next >= c.combinations.size(); });
  }
  sweep.remark = executor.remark();
  return sweep;
}

}  // namespace camlaw::problems
