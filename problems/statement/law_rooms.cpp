// SPDX-License-Identifier: MIT
#include "problems/statement/law_rooms.h"

#include <algorithm>
#include <cmath>

#include "kinematics/laws/build.h"
#include "machines/model/kernel_of.h"
#include "machines/model/law_binding.h"
#include "machines/model/load_case.h"
#include "machines/model/responses.h"
#include "problems/statement/parameters.h"

namespace camlaw::problems {
namespace {

/// What a room may be over ranges of a law's parameters. Infinite where the formula does not bound
/// it.
Interval over_ranges(const Room& room, const Member& law, std::span<const LawRange> varying) {
  Arguments<Interval> arguments = law.arguments.as<Interval>();
  for (const LawRange& range : varying) {
    arguments.values()[range.parameter][range.element] = Interval(range.lower, range.upper);
  }
  return room.left.make(arguments);
}

/// The ranges of the problem's variables in one of its laws.
std::vector<LawRange> ranges_of(const Member& law, const ProblemStatement& problem) {
  std::vector<LawRange> ranges;
  for (const VariableStatement& v : problem.variables) {
    const auto parameter = law_place(*law.family, v);
    if (!parameter || v.element >= law.arguments.list(*parameter).size()) continue;
    ranges.push_back({*parameter, v.element, v.lower, v.upper});
  }
  return ranges;
}

bool holds(const Room& room, const Interval& over_box) {
  return over_box.lower() >= -kLeastRoom && (!room.is_equal || over_box.upper() <= kLeastRoom);
}

/// What the room of that number leaves, for a binding to a law of the family; 1 for other laws.
optim::Function left_over(const Binding& binding, const std::string& family, std::size_t number,
                          optim::Shape shape) {
  const auto& law = binding.law;
  if (law->member().family->name != family) {
    return function_of(
        {}, detail::kernel_of([]<class T>(std::span<const T>) { return camlaw::number<T>(1); }),
        optim::Shape::Linear);
  }
  std::vector<std::size_t> variables;
  for (const LawVariable& v : law->variables()) variables.push_back(v.variable);
  const auto left = [law, number]<class T>(std::span<const T> u) -> T {
    return law->member().family->rooms[number].left.make(law->arguments_of(u));
  };
  return function_of(variables, detail::kernel_of(left), shape);
}

/// Whether a room is linear in what varies of a law.
bool is_linear_in(const Room& room, std::span<const LawRange> varying) {
  if (room.linear || !room.factor) return room.linear;
  const auto is_factor = [&](const LawRange& range) { return range.parameter == *room.factor; };
  return varying.size() == 1 || std::none_of(varying.begin(), varying.end(), is_factor);
}

/// The fastest case of a range that gives a law's room its factor: times leave least there.
std::optional<LoadCase> fastest_of_range(const Room& room, const Member& law,
                                         const ProblemStatement& problem) {
  const auto& by = law.family->parameters[*room.factor].given_by;
  for (const ParameterRange& range : problem.ranges) {
    if (range.parameter == by)
      return LoadCase{.name = {}, .parameters = {{range.parameter, range.upper}}};
  }
  return {};
}

/// In a load case, where there is one; its name may be empty.
ConstraintStatement constraint_of(const Member& law, std::size_t number, bool several,
                                  std::span<const LawRange> varying, const LoadCase* load) {
  const Room& room = law.family->rooms[number];
  const std::string& family = law.family->name;
  const optim::Shape shape =
      is_linear_in(room, varying) ? optim::Shape::Linear : optim::Shape::General;
  MechanismResponse response;
  response.name = several ? family + ": " + room.name : room.name;
  if (load != nullptr && !load->name.empty()) response.name = load->name + "." + response.name;
  response.unit = "1";
  response.meaning = room.is_equal ? "remainder of the law's parameters, which must be 0"
                                   : "remainder of the law's parameters, which must not be below 0";
  response.sees_law = true;
  if (room.factor) {
    const auto& by = law.family->parameters[*room.factor].given_by;
    if (by && load == nullptr) response.uses = ParameterSet{*by};
  }
  using Set = std::vector<std::pair<std::size_t, double>>;
  const Set set = load == nullptr ? Set{} : load->parameters;
  response.number = [family, number, shape, set](const Binding& binding, optim::Shape) {
    return left_over(in_case(binding, set), family, number, shape);
  };
  ConstraintStatement constraint;
  constraint.of_law = std::make_shared<const MechanismResponse>(std::move(response));
  constraint.response.name = constraint.of_law->name;
  constraint.response.response = constraint.of_law.get();
  constraint.response.unit = "1";
  constraint.lower = 0;
  if (room.is_equal) constraint.upper = 0;
  constraint.tolerance = kLeastRoom;
  return constraint;
}

}  // namespace

void limit_to_laws(ProblemStatement& problem) {
  std::erase_if(problem.constraints, [](const ConstraintStatement& c) { return c.of_law; });
  for (const Member& law : problem.laws) {
    for (std::size_t i = 0; i < law.family->rooms.size(); ++i) {
      const Room& room = law.family->rooms[i];
      const std::vector<LawRange> varying = ranges_of(law, problem);
      const auto add = [&](const Member& own, const LoadCase* load) {
        if (holds(room, over_ranges(room, own, varying))) return;
        problem.constraints.push_back(constraint_of(law, i, problem.chooses_law(), varying, load));
      };
      const bool differs = room.factor && law.family->parameters[*room.factor].given_by;
      const auto fastest = differs ? fastest_of_range(room, law, problem) : std::nullopt;
      if (fastest) {
        add(law_in_case(law, problem, *fastest), &*fastest);
        continue;
      }
      if (!differs || problem.cases.empty()) {
        add(law, nullptr);
        continue;
      }
      for (const LoadCase& load : problem.cases) add(law_in_case(law, problem, load), &load);
    }
  }
}

std::optional<double> most_room(const ConstraintStatement& constraint, const Member& law,
                                std::span<const LawRange> varying) {
  if (!constraint.of_law) return {};
  for (const Room& room : law.family->rooms) {
    const std::string& name = constraint.response.name;
    if (name == room.name || name == law.family->name + ": " + room.name) {
      return over_ranges(room, law, varying).upper();
    }
  }
  return {};
}

ConstraintStatement valid_limit(const Mechanism& mechanism, const ValidityLimit& limit) {
  ConstraintStatement constraint;
  constraint.response = find_response(mechanism, limit.response);
  if (std::isfinite(limit.lower)) constraint.lower = limit.lower;
  if (std::isfinite(limit.upper)) constraint.upper = limit.upper;
  return constraint;
}

}  // namespace camlaw::problems
