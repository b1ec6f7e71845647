// SPDX-License-Identifier: MIT
#include "problems/statement/bind.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <stdexcept>
#include <tuple>

#include "kinematics/laws/build.h"
#include "machines/model/given_law.h"
#include "machines/model/kernel_of.h"
#include "machines/model/law_binding.h"
#include "machines/model/responses.h"
#include "optim/search/interruptible.h"
#include "problems/statement/choices.h"
#include "problems/statement/known_limit.h"
#include "problems/statement/law_rooms.h"
#include "problems/statement/parameters.h"
#include "problems/statement/parts.h"

namespace camlaw::problems {
namespace {

using optim::Part;

/// Integer variables are tried one by one while there are no more combinations than this.
constexpr double kTried = 5000;

[[noreturn]] void refuse(const ProblemStatement& statement, const std::string& why) {
  throw std::invalid_argument(
      statement.source.empty() ? why : fmt::format("{}: {}", statement.source, why));
}

/// Refuses more combinations of choices than a search takes.
void check_combinations(const ProblemStatement& statement,
                        const std::vector<optim::Choice>& choices) {
  double product = 1;
  std::string factors;
  for (const optim::Choice& choice : choices) {
    product *= static_cast<double>(choice.options.size());
    factors +=
        fmt::format("{}{} of {}", factors.empty() ? "" : ", ", choice.options.size(), choice.name);
  }
  if (product > optim::kMostCombinations) {
    refuse(statement, fmt::format("there are {:.6g} combinations to choose from ({}); at most {} "
                                  "are tried",
                                  product, factors, optim::kMostCombinations));
  }
}

optim::Choice choice_of(const VariableStatement& v) {
  optim::Choice choice{v.name, v.unit, {}, v.values, 0};
  for (double value = std::ceil(v.lower); v.values.empty() && value <= v.upper; ++value) {
    choice.values.push_back(value);
  }
  for (const double value : choice.values) {
    if (std::abs(value - v.start) < std::abs(choice.values[choice.start] - v.start)) {
      choice.start = choice.options.size();
    }
    choice.options.push_back(fmt::format("{:.10g}", value));
  }
  return choice;
}

/// Limits on a peak are limits on its curve at every angle.
optim::Constraint limit_on(const ProblemStatement& statement, const ConstraintStatement& c,
                           const Binding& binding) {
  optim::Constraint result;
  result.response = response_of(statement, c.response, binding);
  result.lower = c.lower;
  result.upper = c.upper;
  result.tolerance = c.tolerance;
  result.is_edge = c.required_by.has_value();
  if (c.response.part == Part::Magnitude && c.upper) result.lower = -*c.upper;
  return result;
}

/// A response that is the same at every design.
optim::Response constant(const std::string& name, const std::string& unit, double value) {
  const auto kernel =
      detail::kernel_of([value]<class T>(std::span<const T>) { return camlaw::number<T>(value); });
  return {name, unit, function_of({}, kernel, optim::Shape::Linear)};
}

/// Curves that objectives and limits may be on, each over the whole cycle or a window.
using Over = std::tuple<const MechanismResponse*, std::string, double, double>;
using SharedCurves = std::map<Over, optim::Response>;

/// Of responses on one curve each has the same one.
void share_curve(const ResponseName& name, optim::Response& response, SharedCurves& curves) {
  if (!response.is_curve()) return;
  const CycleWindow window = name.window.value_or(CycleWindow{});
  const Over over{name.response, window.segment, window.from, window.to};
  response.measure = curves.emplace(over, response).first->second.measure;
}

std::vector<optim::Constraint> constraints_of(const ProblemStatement& statement,
                                              const Binding& binding, SharedCurves& curves) {
  std::vector<optim::Constraint> result;
  std::map<std::string, int> seen;
  for (const ConstraintStatement& c : statement.constraints) {
    result.push_back(limit_on(statement, c, binding));
    share_curve(c.response, result.back().response, curves);
    const int number = ++seen[c.response.name];
    if (number > 1) result.back().response.name += fmt::format(" ({})", number);
  }
  return result;
}

/// The problems of the combinations that were asked for first. They are pure, and what they have
/// worked out of themselves serves each search.
class KnownProblems {
 public:
  template <class Make>
  optim::Problem get(const std::vector<std::size_t>& options, const Make& make) {
    constexpr std::size_t kKept = 64;  // combinations beyond these are made anew for each search
    {
      const std::lock_guard lock(guard_);
      const auto found = known_.find(options);
      if (found != known_.end()) return found->second;
    }
    optim::Problem made = make();
    const std::lock_guard lock(guard_);
    if (known_.size() < kKept) known_.emplace(options, made);
    return made;
  }

 private:
  std::mutex guard_;
  std::map<std::vector<std::size_t>, optim::Problem> known_;
};

}  // namespace

struct BoundProblem::Slot {
  std::size_t variable;         ///< of the statement
  std::optional<double> fixed;  ///< by a choice
  /// Of the chosen law's family: the law's own, or one that the machine's gives it.
  std::optional<std::size_t> parameter;
};

BoundProblem::BoundProblem(ProblemStatement statement, bool may_be_constant)
    : statement_(std::move(statement)) {
  const bool chooses = statement_.chooses_law() || chooses_part(statement_);
  if (!may_be_constant && statement_.variables.empty() && !chooses) {
    refuse(statement_,
           "the problem has no variables, so nothing can be optimised: write a table such as "
           "[variables.NAME] with lower and upper, or use 'camlaw evaluate'");
  }
  if (statement_.chooses_law()) {
    optim::Choice choice{"law", "", {}, {}, 0};
    for (const Member& member : statement_.laws) choice.options.push_back(member.label());
    choices_.push_back(std::move(choice));
  }
  for (std::size_t i = 0; i < statement_.parts.size(); ++i) {
    const PartStatement& part = statement_.parts[i];
    if (!part.is_chosen()) continue;
    optim::Choice choice{part.name, "", {}, {}, part.start};
    for (const PartItem& item : part.items) choice.options.push_back(item.name);
    choices_.push_back(std::move(choice));
    parts_.push_back(i);
  }
  double tried = 1;
  for (const VariableStatement& v : statement_.variables) {
    if (v.integer && v.values.empty()) tried *= std::floor(v.upper) - std::ceil(v.lower) + 1;
  }
  for (std::size_t i = 0; i < statement_.variables.size(); ++i) {
    const VariableStatement& v = statement_.variables[i];
    if (v.values.empty() && !(v.integer && tried <= kTried)) continue;
    choices_.push_back(choice_of(v));
    chosen_.push_back(i);
  }
  check_combinations(statement_, choices_);
}

BoundProblem BoundProblem::with_stop(const std::atomic<bool>* stop) const {
  BoundProblem result = *this;
  result.statement_.stop = stop;
  return result;
}

void BoundProblem::check_objective() const {
  if (!statement_.objectives.empty()) return;
  refuse(statement_, "the problem has no objective; write [objective] minimize = \"...\"");
}

optim::ProblemSpace BoundProblem::space() const {
  check_objective();
  if (statement_.objectives.size() > 1) {
    refuse(statement_, "several objectives have a front, not an optimum; 'camlaw pareto' finds it");
  }
  return {choices_,
          [bound = *this](const auto& options) { return bound.problem(options).alone(0); }};
}

optim::ProblemSpace BoundProblem::front_space() const {
  check_objective();
  if (statement_.objectives.size() < 2) {
    refuse(statement_,
           "a single objective has an optimum, not a front; 'camlaw optimize' finds it; "
           "for a front write a table [[objectives]] with minimize = \"...\" for each objective");
  }
  return {choices_,
          [bound = *this, known = std::make_shared<KnownProblems>()](const auto& options) {
            return known->get(options, [&] { return bound.problem(options); });
          }};
}

std::optional<std::vector<double>> BoundProblem::reference() const {
  std::vector<double> result;
  for (const ObjectiveStatement& o : statement_.objectives) {
    if (!o.reference) return {};
    result.push_back(o.sense == optim::Sense::Minimize ? *o.reference : -*o.reference);
  }
  return result;
}

const Member& BoundProblem::law(const std::vector<std::size_t>& options) const {
  return statement_.chooses_law() ? statement_.laws[options.front()] : statement_.laws.front();
}

std::vector<BoundProblem::Slot> BoundProblem::slots(const std::vector<std::size_t>& options) const {
  const Family& family = *law(options).family;
  const std::size_t first = choices_.size() - chosen_.size();
  std::vector<Slot> result;
  for (std::size_t i = 0; i < statement_.variables.size(); ++i) {
    const VariableStatement& v = statement_.variables[i];
    Slot slot{i, {}, law_place(family, v)};
    if (v.of_law && !slot.parameter) continue;  // not a parameter of this law
    const auto at = std::find(chosen_.begin(), chosen_.end(), i);
    if (at != chosen_.end()) {
      const auto k = first + static_cast<std::size_t>(at - chosen_.begin());
      slot.fixed = choices_[k].values[options[k]];
    }
    result.push_back(slot);
  }
  return result;
}

/// The law of a combination, its variables at their starts; where those make no law beside what is
/// chosen, on the straight way to their lower bounds.
Member BoundProblem::member(const std::vector<std::size_t>& options) const {
  constexpr double kShares[] = {1, 0.75, 0.5, 0.25, 0.1, 0};
  const std::vector<Slot> all = slots(options);
  Member member = law(options);
  for (const double share : kShares) {
    for (const Slot& slot : all) {
      const VariableStatement& v = statement_.variables[slot.variable];
      if (!slot.parameter) continue;
      const double start = share == 1 ? v.start : v.lower + share * (v.start - v.lower);
      member.arguments.values()[*slot.parameter][v.element] = slot.fixed.value_or(start);
    }
    if (member.possible_law()) break;
  }
  return member;
}

Binding BoundProblem::binding(const std::vector<std::size_t>& options) const {
  Binding binding;
  binding.constants = statement_.constants;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const PartStatement& part = statement_.parts[parts_[i]];
    const std::size_t at = first_part() + i;  // without options it is the start
    put_item(part, at < options.size() ? options[at] : part.start, binding.constants);
  }
  std::vector<LawVariable> law_variables;
  std::vector<std::pair<std::size_t, std::size_t>> parameters;
  std::size_t variable = 0;
  for (const Slot& slot : slots(options)) {
    const VariableStatement& v = statement_.variables[slot.variable];
    if (slot.fixed && v.of_law) continue;  // the member has it
    if (slot.fixed) {
      binding.constants[v.parameter] = *slot.fixed;
    } else if (v.of_law) {
      law_variables.push_back({*slot.parameter, v.element, variable++});
    } else {
      parameters.emplace_back(v.parameter, variable++);
    }
  }
  std::sort(parameters.begin(), parameters.end());
  for (const auto& [parameter, index] : parameters) {
    binding.parameters.push_back(parameter);
    binding.variables.push_back(index);
  }
  Member law = member(options);
  for (const Slot& slot : slots(options)) {
    const VariableStatement& v = statement_.variables[slot.variable];
    if (v.of_law || !slot.parameter) continue;
    binding.constants[v.parameter] = law.arguments.list(*slot.parameter)[v.element];
  }
  binding.law = given_law(std::move(law), std::move(law_variables), binding);
  return binding;
}

optim::Problem BoundProblem::problem(const std::vector<std::size_t>& options) const {
  optim::Problem problem;
  problem.name = statement_.title;
  const Member chosen = member(options);
  std::vector<LawRange> varying;
  for (const Slot& slot : slots(options)) {
    if (slot.fixed) continue;
    const VariableStatement& v = statement_.variables[slot.variable];
    if (slot.parameter) varying.push_back({*slot.parameter, v.element, v.lower, v.upper});
    const double start =
        slot.parameter ? chosen.arguments.list(*slot.parameter)[v.element] : v.start;
    problem.variables.push_back({v.name, v.unit, v.lower, v.upper, start, v.scale, v.integer});
  }
  const bool has_room = std::none_of(
      statement_.constraints.begin(), statement_.constraints.end(),
      [&](const auto& c) { return most_room(c, chosen, varying).value_or(0) < -kLeastRoom; });
  if (!has_room && !choices_.empty()) return without_designs(chosen, varying, std::move(problem));
  const Binding bound = binding(options);
  SharedCurves curves;
  for (const ObjectiveStatement& objective : statement_.objectives) {
    problem.objectives.push_back({response_of(statement_, objective.response, bound),
                                  objective.sense, objective.response.part, objective.tolerance,
                                  known_limit(statement_, objective, chosen)});
    share_curve(objective.response, problem.objectives.back().response, curves);
  }
  const bool follows_parts = std::any_of(parts_.begin(), parts_.end(), [&](std::size_t part) {
    return !statement_.parts[part].inputs.empty();
  });
  problem.domain = margins_that_decide(*statement_.mechanism, bound);
  problem.constraints = follows_parts ? constraints_of(with_parts(options), bound, curves)
                                      : constraints_of(statement_, bound, curves);
  return problem;
}

ProblemStatement BoundProblem::with_parts(const std::vector<std::size_t>& options) const {
  ProblemStatement result = statement_;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const std::size_t at = first_part() + i;  // without options it is the start
    if (at >= options.size()) break;
    start_with(result, result.parts[parts_[i]].name, options[at]);
  }
  return result;
}

/// The problem of a combination that leaves its law no room: a limit that no design meets. Its
/// other responses are numbers without a meaning, and bound nothing.
optim::Problem BoundProblem::without_designs(const Member& chosen,
                                             std::span<const LawRange> varying,
                                             optim::Problem problem) const {
  for (const ObjectiveStatement& objective : statement_.objectives) {
    problem.objectives.push_back({constant(objective.response.name, objective.response.unit, 0),
                                  objective.sense, Part::Value, objective.tolerance});
  }
  for (const ConstraintStatement& c : statement_.constraints) {
    const double left = most_room(c, chosen, varying).value_or(0);
    optim::Constraint limit;
    limit.response = constant(c.response.name, c.response.unit, std::min(left, 0.0));
    limit.lower = left < -kLeastRoom ? 0 : -1;
    limit.tolerance = c.tolerance;
    problem.constraints.push_back(std::move(limit));
  }
  return problem;
}

ProblemStatement BoundProblem::at(const std::vector<std::size_t>& options, optim::Design x) const {
  ProblemStatement result = statement_;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    keep_item(result, result.parts[parts_[i]].name, options[first_part() + i]);
  }
  Member member = law(options);
  std::size_t variable = 0;
  for (const Slot& slot : slots(options)) {
    VariableStatement& v = result.variables[slot.variable];
    v.start = slot.fixed ? *slot.fixed : x[variable++];
    if (slot.parameter) member.arguments.values()[*slot.parameter][v.element] = v.start;
    if (!v.of_law) result.constants[v.parameter] = v.start;
  }
  result.laws = {std::move(member)};
  return result;
}

optim::Response response_of(const ProblemStatement& statement, const ResponseName& name,
                            const Binding& binding) {
  optim::Response response = make_response(*statement.mechanism, name, binding);
  if (statement.stop == nullptr) return response;
  return optim::interruptible(std::move(response), optim::Deadline({}, statement.stop));
}

std::vector<optim::Constraint> constraints_of(const ProblemStatement& statement,
                                              const Binding& binding) {
  SharedCurves curves;
  return constraints_of(statement, binding, curves);
}

}  // namespace camlaw::problems
