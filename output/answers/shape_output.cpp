// SPDX-License-Identifier: MIT
#include "output/answers/shape_output.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "problems/statement/bind.h"

namespace camlaw::cli {
namespace {

using problems::ProblemStatement, problems::ResponseName, problems::VariableStatement;

const char* words_of(optim::Shape shape) {
  switch (shape) {
    case optim::Shape::Quasiconvex:
      return "quasiconvex";
    case optim::Shape::Quasiconcave:
      return "quasiconcave";
    case optim::Shape::Quasilinear:
      return "quasilinear";
    case optim::Shape::Convex:
      return "convex";
    case optim::Shape::Concave:
      return "concave";
    case optim::Shape::Linear:
      return "linear";
    case optim::Shape::General:
      break;
  }
  return "not known";
}

/// Variables that a line names together: one of the machine, or all numbers of a law's parameter.
struct Group {
  std::string name;
  std::vector<VariableStatement> variables;
};

std::vector<Group> groups_of(const ProblemStatement& statement) {
  std::vector<Group> groups;
  for (const VariableStatement& v : statement.variables) {
    const std::string name = v.of_law ? v.law_parameter : v.name;
    const auto same = std::find_if(groups.begin(), groups.end(), [&](const Group& group) {
      return group.name == name && group.variables.front().of_law == v.of_law;
    });
    if (same == groups.end()) {
      groups.push_back({name, {v}});
    } else {
      same->variables.push_back(v);
    }
  }
  return groups;
}

bool depends_on(const ProblemStatement& statement, const ResponseName& name, const Group& group) {
  const VariableStatement& v = group.variables.front();
  if (name.response == nullptr) return !v.of_law && v.parameter == name.parameter;
  if (v.of_law && name.response->cam) {  // whose law alone moves it
    const std::string& cam = statement.mechanism->cams[*name.response->cam].name;
    return name.response->sees_law && v.law_parameter.starts_with(cam + ".");
  }
  if (v.of_law) return name.response->sees_law;
  return name.response->uses.holds(v.parameter);
}

/// Where these alone vary; none where they are chosen one by one.
std::optional<problems::KnownShape> shape_in(const ProblemStatement& statement,
                                             const ResponseName& name,
                                             const std::vector<VariableStatement>& varying) {
  ProblemStatement own = statement;
  own.variables = varying;
  own.laws = {statement.laws.front()};
  const problems::BoundProblem bound(own, true);
  if (!bound.choices().empty()) return {};
  return known_shape(*statement.mechanism, name, bound.binding({}));
}

}  // namespace

Table shape_table(const ProblemStatement& statement) {
  Table table{.key = "shapes",
              .columns = {words("response", "response"), words("depends on", "depends_on"),
                          words("shape in all", "shape"), words("known by", "known_by")},
              .caption = "\n"};
  std::vector<ResponseName> names;
  for (const auto& objective : statement.objectives) names.push_back(objective.response);
  for (const auto& constraint : statement.constraints) names.push_back(constraint.response);
  std::set<std::string> seen;
  for (const ResponseName& name : names) {
    if (!seen.insert(name.name).second) continue;
    std::vector<std::string> parts;
    Json alone = Json::object();
    std::vector<VariableStatement> together;
    for (const Group& group : groups_of(statement)) {
      if (!depends_on(statement, name, group)) continue;
      const auto shape = shape_in(statement, name, group.variables);
      const char* const word = shape ? words_of(shape->best()) : "chosen";
      parts.push_back(fmt::format("{} ({})", group.name, word));
      alone[group.name] = word;
      if (shape) together.insert(together.end(), group.variables.begin(), group.variables.end());
    }
    const auto shape = shape_in(statement, name, together);
    table.add(
        {name.name,
         {parts.empty() ? "nothing that varies" : fmt::format("{}", fmt::join(parts, ", ")), alone},
         shape ? words_of(shape->best()) : "",
         shape ? shape->reason() : ""});
  }
  return table;
}

}  // namespace camlaw::cli
