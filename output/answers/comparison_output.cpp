// SPDX-License-Identifier: MIT
#include "output/answers/comparison_output.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <set>
#include <tuple>

#include "output/answers/comparison_table.h"
#include "output/answers/limit_text.h"
#include "output/document/formatting.h"
#include "problems/statement/parameters.h"

namespace camlaw::cli {
namespace {

using problems::ProblemStatement;
using Designs = std::vector<ComparedDesign>;

std::vector<std::string> letters_of(const Designs& designs) {
  std::vector<std::string> letters;
  for (const ComparedDesign& design : designs) letters.push_back(design.letter);
  return letters;
}

std::vector<RowCell> row_of(const Designs& designs,
                            const std::function<RowCell(const ComparedDesign&)>& cell) {
  std::vector<RowCell> row;
  for (const ComparedDesign& design : designs) row.push_back(cell(design));
  return row;
}

const ProblemStatement& statement_of(const ComparedDesign& design) { return design.read.statement; }

bool is_possible_best(const ComparedDesign& design) {
  return design.claim.differences.empty() && design.review.met() == design.review.limits.size();
}

RowCell verdict_cell(const ComparedDesign& design) {
  const VerdictBadge shown = verdict_badge(design.read, design.claim, design.review);
  const double rank = !is_possible_best(design)     ? 0
                      : design.review.built.fails() ? 1
                      : shown.kind == "good"        ? 3
                                                    : 2;
  return {shown.text, shown.text, rank};
}

std::string law_text(const ProblemStatement& design) {
  if (design.mechanism->moved_by == problems::MovedBy::Nothing || !design.cams.empty())
    return kNoValue;
  const Member law = design.laws.front().listed();
  return design.mechanism->moved_by == problems::MovedBy::Program ? law.family->formula
                                                                  : law.label();
}

/// What an objective asks for; designs that ask for the same can be ranked by it.
struct Asked {
  std::string name, unit;
  optim::Sense sense;
  auto operator<=>(const Asked&) const = default;
};

std::optional<Asked> asked_of(const ComparedDesign& design) {
  if (!design.review.assessment) return {};
  const problems::ObjectiveStatement& stated = statement_of(design).objectives.front();
  return Asked{stated.response.name, stated.response.unit, stated.sense};
}

std::string objective_title(const Asked& asked) {
  return fmt::format("{}, to be {}", asked.name,
                     asked.sense == optim::Sense::Minimize ? "minimised" : "maximised");
}

/// A design that meets its limits and whose record is right may be the best.
RowCell objective_cell(const ComparedDesign& design, const Asked& asked) {
  if (asked_of(design) != asked) return {};
  const double value = design.review.assessment->objective.value;
  RowCell cell = row_number(value);
  if (is_possible_best(design) && std::isfinite(value)) {
    cell.rank = asked.sense == optim::Sense::Minimize ? -value : value;
  }
  return cell;
}

Table answers_table(const Designs& designs) {
  ComparisonTable table("answers", names("", "of"), letters_of(designs), false);
  const auto line = [&](const char* name,
                        const std::function<std::string(const ComparedDesign&)>& of) {
    table.add(name, "", row_of(designs, [&](const ComparedDesign& design) {
                const std::string text = of(design);
                return RowCell{text, text, {}};
              }));
  };
  line("file", [](const auto& design) { return design.file; });
  line("title", [](const auto& design) { return statement_of(design).title; });
  line("machine", [](const auto& design) { return statement_of(design).mechanism->name; });
  line("law", [](const auto& design) { return law_text(statement_of(design)); });
  table.add("verdict", "", row_of(designs, verdict_cell));
  std::vector<Asked> all;
  for (const ComparedDesign& design : designs) {
    const auto asked = asked_of(design);
    if (asked && std::find(all.begin(), all.end(), *asked) == all.end()) all.push_back(*asked);
  }
  for (const Asked& asked : all) {
    const std::string unit = shown_unit(asked.unit);
    table.add(objective_title(asked) + (unit.empty() ? "" : ", " + unit), "",
              row_of(designs, [&](const auto& design) { return objective_cell(design, asked); }));
  }
  line("numbers are", [](const auto& design) {
    return design.read.verdict ? "the result of a search" : "as the file states them, not searched";
  });
  line("limits met", [](const auto& design) {
    return fmt::format("{} of {}", design.review.met(), design.review.limits.size());
  });
  return std::move(table).table();
}

const problems::VariableStatement* variable_of(const ComparedDesign& design,
                                               const std::string& name, const std::string& unit) {
  for (const auto& v : statement_of(design).variables) {
    if (v.name == name && v.unit == unit) return &v;
  }
  return nullptr;
}

RowCell variable_cell(const ComparedDesign& design, const std::string& name,
                      const std::string& unit) {
  const auto* v = variable_of(design, name, unit);
  if (v == nullptr) return {};
  return row_number(v->of_law ? v->start : statement_of(design).constants[v->parameter]);
}

std::optional<std::size_t> parameter_of(const ComparedDesign& design, const std::string& name,
                                        const std::string& unit) {
  const auto& parameters = statement_of(design).mechanism->parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (parameters[i].name == name && parameters[i].unit == unit) return i;
  }
  return {};
}

Table variables_table(const Designs& designs) {
  ComparisonTable table("variables", names("variable", "name"), letters_of(designs), true);
  UnitNames all;
  for (const ComparedDesign& design : designs) {
    for (const auto& v : statement_of(design).variables) take_name(all, v.name, v.unit);
  }
  for (const auto& [name, unit] : all) {
    table.add(name, unit, row_of(designs, [&](const auto& design) {
                return variable_cell(design, name, unit);
              }));
  }
  return std::move(table).table();
}

/// Parameters of the machines that two designs have and that nothing varies, where they differ.
Table constants_table(const Designs& designs) {
  ComparisonTable table("constants", names("parameter", "name"), letters_of(designs), true);
  UnitNames all;
  for (const ComparedDesign& design : designs) {
    for (const auto& p : statement_of(design).mechanism->parameters) take_name(all, p.name, p.unit);
  }
  for (const auto& [name, unit] : all) {
    std::set<double> values;
    bool varies = false;
    const auto row = row_of(designs, [&](const ComparedDesign& design) -> RowCell {
      const auto i = parameter_of(design, name, unit);
      if (!i) return {};
      varies = varies || variable_of(design, name, unit) != nullptr;
      values.insert(statement_of(design).constants[*i]);
      return row_number(statement_of(design).constants[*i]);
    });
    if (values.size() > 1 && !varies) table.add(name, unit, row);
  }
  return std::move(table).table();
}

/// A side of a limit by which designs are compared.
using SideKey = std::tuple<std::string, std::string, bool, bool>;  // name, unit, upper, equation

struct DesignSides {
  std::vector<std::pair<SideKey, optim::LimitReport>> sides;

  explicit DesignSides(const ComparedDesign& design) {
    const SidedLimits sided = both_sides(statement_of(design), design.review.limits);
    const auto add = [&](const optim::LimitReport& limit) {
      sides.emplace_back(SideKey{limit.name, limit.unit, limit.is_upper, limit.is_equation}, limit);
    };
    for (std::size_t i = 0; i < sided.limits.size(); ++i) {
      add(sided.limits[i]);
      if (sided.others[i]) add(*sided.others[i]);
    }
  }
  const optim::LimitReport* find(const SideKey& key) const {
    for (const auto& [its, limit] : sides) {
      if (its == key) return &limit;
    }
    return nullptr;
  }
};

std::string with_bound(const optim::LimitReport& limit) {
  const char* sign = limit.is_equation ? "=" : limit.is_upper ? "\u2264" : "\u2265";
  const double size = std::max(std::abs(limit.value), std::abs(limit.bound));
  return fmt::format("{} {} {}{}", significant(limit.value, size), sign, in_digits(limit.bound),
                     limit.met ? "" : ", not met");
}

Table limits_side_by_side(const Designs& designs) {
  ComparisonTable table("limits", names("limit", "name"), letters_of(designs), true);
  std::vector<DesignSides> sides;
  std::vector<SideKey> keys;
  for (const ComparedDesign& design : designs) {
    sides.emplace_back(design);
    for (const auto& [key, limit] : sides.back().sides) {
      if (std::find(keys.begin(), keys.end(), key) == keys.end()) keys.push_back(key);
    }
  }
  const auto row = [&](const SideKey& key, const auto& cell) {
    std::vector<RowCell> cells;
    for (const DesignSides& its : sides) {
      const optim::LimitReport* limit = its.find(key);
      cells.push_back(limit == nullptr || std::isnan(limit->value) ? RowCell{} : cell(*limit));
    }
    return cells;
  };
  for (const SideKey& key : keys) {
    const auto& [response, unit, is_upper, is_equation] = key;
    const std::string name = response + (is_equation ? ", equal to"
                                         : is_upper  ? ", at most"
                                                     : ", at least");
    table.add(name, unit, row(key, [](const optim::LimitReport& limit) {
                return RowCell{with_bound(limit), to_json(limit.value), {}};
              }));
    table.add("margin of " + name, unit, row(key, [](const optim::LimitReport& limit) {
                const double size = std::max(std::abs(limit.value), std::abs(limit.bound));
                // What is within the tolerance is as good as at the bound.
                const bool at_bound = std::abs(limit.margin) <= limit.tolerance;
                return RowCell{significant(limit.margin, size, 4), to_json(limit.margin),
                               !limit.met ? std::nullopt
                               : at_bound ? std::optional(0.0)
                                          : std::optional(limit.margin)};
              }));
  }
  return std::move(table).table();
}

RowCell check_cell(const ComparedDesign& design, const std::string& name) {
  for (const problems::BuildableAnswer& answer : design.review.built.checks) {
    if (answer.check->name != name) continue;
    const std::string text(problems::to_string(answer.built));
    using problems::Built;
    const double rank = answer.built == Built::Holds ? 2 : answer.built == Built::Fails ? 0 : 1;
    return {text, text, rank};
  }
  return {};
}

Table checks_table(const Designs& designs) {
  ComparisonTable table("buildable", names("check", "name"), letters_of(designs), false);
  UnitNames all;
  for (const ComparedDesign& design : designs) {
    for (const auto& answer : design.review.built.checks) take_name(all, answer.check->name, "");
  }
  for (const auto& [name, unit] : all) {
    table.add(name, "",
              row_of(designs, [&](const auto& design) { return check_cell(design, name); }));
  }
  return std::move(table).table();
}

RowCell response_cell(const ComparedDesign& design, const std::string& name,
                      const std::string& unit) {
  for (const problems::EvaluatedResponse& r : design.review.evaluated) {
    if (!r.is_curve && r.name == name && r.unit == unit && std::isfinite(r.value))
      return row_number(r.value);
  }
  return {};
}

/// Numbers that at least two have.
Table numbers_table(const Designs& designs) {
  ComparisonTable table("numbers", names("number", "name"), letters_of(designs), true);
  UnitNames all;
  for (const ComparedDesign& design : designs) {
    for (const auto& r : design.review.evaluated) {
      if (!r.is_curve) take_name(all, r.name, r.unit);
    }
  }
  for (const auto& [name, unit] : all) {
    const auto row =
        row_of(designs, [&](const auto& design) { return response_cell(design, name, unit); });
    const auto known = std::count_if(row.begin(), row.end(),
                                     [](const RowCell& cell) { return !cell.value.is_null(); });
    if (known > 1) table.add(name, unit, row);
  }
  return std::move(table).table();
}

std::vector<OwnNames> own_names(
    const Designs& designs,
    const std::function<std::vector<std::string>(const ComparedDesign&)>& names) {
  std::vector<OwnNames> all;
  for (const ComparedDesign& design : designs) all.push_back({design.letter, names(design)});
  return all;
}

/// Sentences on what only some of them have, and on what cannot be ranked.
std::vector<std::string> apart_words(const Designs& designs) {
  std::vector<std::string> words;
  const auto add = [&](const std::vector<std::string>& more) {
    words.insert(words.end(), more.begin(), more.end());
  };
  std::set<std::string> machines;
  std::set<std::optional<Asked>> objectives;
  for (const ComparedDesign& design : designs) {
    machines.insert(statement_of(design).mechanism->name);
    objectives.insert(asked_of(design));
  }
  if (machines.size() > 1) {
    words.push_back(fmt::format("The machines differ ({}): only what they share is compared.",
                                fmt::join(machines, ", ")));
  }
  if (objectives.size() > 1) {
    words.push_back(
        "The designs do not all ask for the same objective: only those that do are ranked by it.");
  }
  add(unshared_words(own_names(designs,
                               [](const ComparedDesign& design) {
                                 std::vector<std::string> names;
                                 for (const auto& v : statement_of(design).variables)
                                   names.push_back(v.name);
                                 return names;
                               }),
                     "variable"));
  add(unshared_words(own_names(designs,
                               [](const ComparedDesign& design) {
                                 std::vector<std::string> names;
                                 for (const auto& l : design.review.limits) names.push_back(l.name);
                                 return names;
                               }),
                     "limit"));
  return words;
}

void add_table(Document& document, const char* title, Table table, const std::string& note) {
  if (table.rows.empty()) return;
  document.add(Heading{title});
  document.add(std::move(table));
  if (!note.empty()) document.say(note + "\n");
}

}  // namespace

Document comparison_document(const Designs& designs) {
  Document document;
  add_table(
      document, "Answers", answers_table(designs),
      "Each design was re-checked, as in a report of its own. A design that violates a limit, "
      "or whose record is wrong, is not the best of any objective.");
  add_table(document, "Variables", variables_table(designs), "");
  add_table(document, "Limits", limits_side_by_side(designs),
            "The margin is the distance to the design's own bound; the widest is marked.");
  add_table(document, "Can it be built?", checks_table(designs), "");
  add_table(document, "Parameters that differ", constants_table(designs), "");
  add_table(
      document, "Numbers", numbers_table(designs),
      "Whether more or less of these is better depends on the machine's use: none is marked.");
  const std::vector<std::string> apart = apart_words(designs);
  document.fact("not_shared", apart);
  if (!apart.empty()) {
    document.add(Heading{"What they do not share"});
    for (const std::string& sentence : apart) document.say(sentence + "\n");
  }
  return document;
}

}  // namespace camlaw::cli
