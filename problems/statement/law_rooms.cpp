// SPDX-License-Identifier: MIT
#include "problems/statement/law_rooms.h"

#include <algorithm>
#include <cmath>

#include "kinematics/laws/build.h"
#include "machines/model/kernel_of.h"
#include "machines/model/law_binding.h"
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
    if (!v.of_law) continue;
    const auto parameter = index_in(*law.family, v.law_parameter);
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

ConstraintStatement constraint_of(const Member& law, std::size_t number, bool several) {
  const Room& room = law.family->rooms[number];
  const std::string& family = law.family->name;
  const optim::Shape shape = room.linear ? optim::Shape::Linear : optim::Shape::General;
  MechanismResponse response;
  response.name = several ? family + ": " + room.name : room.name;
  response.unit = "1";
  response.meaning = room.is_equal ? "remainder of the law's parameters, which must be 0"
                                   : "remainder of the law's parameters, which must not be below 0";
  response.sees_law = true;
  response.number = [family, number, shape](const Binding& binding, optim::Shape) {
    return left_over(binding, family, number, shape);
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
      if (holds(room, over_ranges(room, law, ranges_of(law, problem)))) continue;
      problem.constraints.push_back(constraint_of(law, i, problem.chooses_law()));
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
