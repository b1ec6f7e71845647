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

/// "from its formula", "proof DS10".
std::string reason_text(const problems::KnownShape& shape) {
  std::string text = shape.reason();
  const auto put = [&](std::string_view from, std::string_view to) {
    const std::size_t at = text.find(from);
    if (at != std::string::npos) text.replace(at, from.size(), to);
  };
  put("rules", "from its formula");
  put("enclosure", "from bounds on its slopes");
  // That the formula holds for every machine of the box, too, is for programs.
  text = text.substr(0, text.find(", possible machines by"));
  while (text.find("theory.md (") != std::string::npos) {
    put("theory.md (", "proof ");
    put(")", "");
  }
  return text;
}

/// A designer's word for a shape.
std::string plain_word(const std::string& word) {
  if (word == "convex") return "curves upwards";
  if (word == "concave") return "curves downwards";
  if (word == "quasiconvex") return "one valley";
  if (word == "quasiconcave") return "one hill";
  if (word == "quasilinear") return "monotonic";
  return word;
}

/// What it means, with the term of optimisation.
std::string meaning_of(const std::string& word) {
  if (word == "linear") return "linear: equal steps of the variables change it equally";
  if (word == "curves upwards") return "curves upwards (convex): it has one valley";
  if (word == "curves downwards") return "curves downwards (concave): it has one hill";
  if (word == "one valley")
    return "one valley (quasiconvex): it falls to its lowest value and rises after it";
  if (word == "one hill")
    return "one hill (quasiconcave): it rises to its highest value and falls after it";
  if (word == "monotonic") return "monotonic (quasilinear): it only rises or only falls";
  return "";
}

}  // namespace

std::string shape_legend(const Table& shapes) {
  std::set<std::string> words;
  bool has_proof = false;
  for (const auto& row : shapes.rows) {
    words.insert(row.at(2).text);
    for (const auto& [variable, word] : row.at(1).value.items()) {
      words.insert(plain_word(word.get<std::string>()));
    }
    has_proof |= row.at(3).text.find("proof ") != std::string::npos;
  }
  std::vector<std::string> meanings;
  for (const std::string& word : words) {
    if (std::string meaning = meaning_of(word); !meaning.empty()) {
      meanings.push_back(std::move(meaning));
    }
  }
  if (meanings.empty()) return "";
  return fmt::format("jointly: with everything that it depends on varying together; {}{}\n",
                     fmt::join(meanings, "; "),
                     has_proof ? "; the tags name proofs in docs/theory.md" : "");
}

Table shape_table(const ProblemStatement& statement) {
  Table table{.key = "shapes",
              .columns = {words("response", "response"), words("depends on", "depends_on"),
                          words("jointly", "shape"), words("why", "known_by")},
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
      parts.push_back(fmt::format("{} ({})", group.name, plain_word(word)));
      alone[group.name] = word;
      if (shape) together.insert(together.end(), group.variables.begin(), group.variables.end());
    }
    const auto shape = shape_in(statement, name, together);
    table.add(
        {name.name,
         {parts.empty() ? "nothing that varies" : fmt::format("{}", fmt::join(parts, ", ")), alone},
         shape ? Cell(plain_word(words_of(shape->best())), words_of(shape->best())) : Cell(""),
         shape ? Cell(reason_text(*shape), shape->reason()) : Cell("")});
  }
  return table;
}

}  // namespace camlaw::cli
