// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <stdexcept>

#include "problems/statement/parameters.h"
#include "problems/statement/reading.h"
#include "problems/statement/toml_reader.h"

namespace camlaw::problems {
namespace {

/// A name taken apart: "law.c[2]".
struct Spelling {
  std::string full;
  Owner owner;
  std::string bare;
  std::optional<std::size_t> element;
};

Spelling taken_apart(std::string_view name, Owner owner) {
  Spelling result{std::string(name), owner, "", {}};
  for (const auto& [prefix, of] : {std::pair{"machine.", Owner::Machine}, {"law.", Owner::Law}}) {
    if (owner == Owner::Either && name.starts_with(prefix)) {
      result.owner = of;
      name.remove_prefix(std::string_view(prefix).size());
    }
  }
  const std::size_t bracket = name.find('[');
  result.bare = name.substr(0, bracket);
  if (bracket == std::string_view::npos) return result;
  std::size_t number = 0;
  const auto [end, error] =
      std::from_chars(name.data() + bracket + 1, name.data() + name.size(), number);
  if (error != std::errc{} || std::string_view(end, name.data() + name.size()) != "]" ||
      number == 0) {
    throw std::invalid_argument(
        fmt::format("'{}' names no element; a list's elements are {}[1], {}[2], ...", result.full,
                    result.bare, result.bare));
  }
  result.element = number - 1;
  return result;
}

/// What all laws that have the parameter accept.
void join(NamedParameter& known, const Family& family, const Parameter& p) {
  if (p.list != known.list || p.unit != known.unit) {
    throw std::invalid_argument(fmt::format(
        "{} is not the same in all laws: in {} it is {} in unit {}, in another law {} in unit {}",
        p.name, family.name, p.list ? "a list" : "a number", p.unit,
        known.list ? "a list" : "a number", known.unit));
  }
  known.low = std::max(known.low, p.low);
  known.high = std::min(known.high, p.high);
  known.integer |= p.structural && !p.list;
  known.structural |= p.structural;
}

std::optional<NamedParameter> find_in_laws(const ProblemStatement& problem,
                                           const std::string& name) {
  std::optional<NamedParameter> result;
  for (const Member& law : problem.laws) {
    const auto i = index_in(*law.family, name);
    if (!i || law.family->parameters[*i].given_by) continue;
    const Parameter& p = law.family->parameters[*i];
    if (result) {
      join(*result, *law.family, p);
    } else {
      result = named(p);
    }
  }
  return result;
}

const Entry* entry_of(const Entry* table, const MechanismParameter& parameter) {
  if (table == nullptr || table->kind != Entry::Kind::Table) return nullptr;
  for (const Entry& entry : table->items) {
    const bool owned = entry.key.starts_with("machine.");
    const std::string_view bare = std::string_view(entry.key).substr(owned ? 8 : 0);
    if (bare == parameter.name || bare == parameter.symbol) return &entry;
  }
  return nullptr;
}

std::optional<NamedParameter> find_in_machine(const Mechanism& mechanism, const std::string& name) {
  for (std::size_t i = 0; i < mechanism.parameters.size(); ++i) {
    const MechanismParameter& p = mechanism.parameters[i];
    if (p.name != name && p.symbol != name) continue;
    NamedParameter result;
    result.name = p.name;
    result.parameter = i;
    result.unit = p.unit;
    result.low = p.low;
    result.high = p.high;
    result.integer = p.integer;
    return result;
  }
  return {};
}

/// Where else there is a parameter of that name.
std::string elsewhere(const ProblemStatement& problem, const Spelling& name) {
  if (name.owner == Owner::Machine) {
    if (!find_in_laws(problem, name.bare)) return "";
    return problem.mechanism->moved_by == MovedBy::Program
               ? "; it is a parameter of the program, and only the machine's are accepted here"
               : "; it is a parameter of the law, under [law]";
  }
  if (find_in_machine(*problem.mechanism, name.bare)) {
    return "; it is a parameter of the machine, under [constants]";
  }
  if (problem.mechanism->moved_by == MovedBy::Nothing) return "";
  std::vector<std::string> names;
  for (const Family& family : catalogue()) {
    if (index_in(family, name.bare)) names.push_back(family.name);
  }
  return names.empty() || names.size() > 5 ? ""
                                           : fmt::format("; {} {} it", fmt::join(names, ", "),
                                                         names.size() == 1 ? "has" : "have");
}

[[noreturn]] void refuse_unknown(const ProblemStatement& problem, const Spelling& name) {
  std::vector<std::string> known, owners;
  bool several = false;
  const bool has_law = problem.mechanism->moved_by != MovedBy::Nothing && !problem.laws.empty();
  if (name.owner == Owner::Law && !has_law) {
    throw std::invalid_argument(fmt::format("{} has no law, so there is no parameter '{}' of one",
                                            problem.mechanism->name, name.bare));
  }
  if (name.owner != Owner::Law) {
    owners.push_back(problem.mechanism->name);
    for (const auto& p : problem.mechanism->parameters) known.push_back(p.name);
  }
  if (name.owner != Owner::Machine && has_law) {
    const bool alone = owners.empty();
    if (problem.mechanism->moved_by == MovedBy::Program) {
      owners.emplace_back(alone ? "the motion program" : "its motion program");
    } else {
      owners.push_back((problem.laws.size() == 1 ? "law " : "laws ") + law_names(problem));
      several = several || problem.laws.size() > 1;
    }
    several = several || !alone;
    for (const Member& law : problem.laws) {
      for (const Parameter& p : law.family->parameters) {
        const bool is_known = std::find(known.begin(), known.end(), p.name) != known.end();
        if (!p.given_by && !is_known) known.push_back(p.name);
      }
    }
  }
  throw std::invalid_argument(fmt::format(
      "{} {} no parameter '{}'; {}{}", fmt::join(owners, " and "), several ? "have" : "has",
      name.bare,
      known.empty() ? "there is none"
                    : suggestion(name.bare, known, several ? "they accept" : "it accepts"),
      elsewhere(problem, name)));
}

/// Refuses an element that is not there, in any of the laws.
void check_element(const ProblemStatement& problem, const NamedParameter& p) {
  if (!p.element) return;
  if (!p.list) {
    throw std::invalid_argument(fmt::format("{} is a single number, it has no elements", p.name));
  }
  for (const Member& law : problem.laws) {
    const auto i = index_in(*law.family, p.law_parameter);
    if (!i) continue;
    const std::size_t count = law.arguments.list(*i).size();
    if (*p.element >= count) {
      throw std::invalid_argument(fmt::format("no element {}; {} of law {} has {} values",
                                              *p.element + 1, p.name, law.family->name, count));
    }
  }
}

}  // namespace

NamedParameter named(const Parameter& p) {
  NamedParameter result;
  result.name = p.name;
  result.of_law = true;
  result.law_parameter = p.name;
  result.unit = p.unit;
  result.low = p.low;
  result.high = p.high;
  result.integer = p.structural && !p.list;
  result.list = p.list;
  result.structural = p.structural;
  return result;
}

NamedParameter find_parameter(const ProblemStatement& problem, std::string_view name, Owner owner) {
  const Spelling spelling = taken_apart(name, owner);
  const auto of_law =
      spelling.owner == Owner::Machine ? std::nullopt : find_in_laws(problem, spelling.bare);
  const auto of_machine = find_in_machine(*problem.mechanism, spelling.bare);
  if (spelling.owner == Owner::Either && of_law && of_machine) {
    throw std::invalid_argument(
        fmt::format("both the machine and the law have '{}'; write machine.{} or law.{}",
                    spelling.bare, spelling.bare, spelling.bare));
  }
  if (!of_law && (!of_machine || spelling.owner == Owner::Law)) refuse_unknown(problem, spelling);
  NamedParameter result = of_law ? *of_law : *of_machine;
  if (of_law && of_machine) result.name = "law." + result.name;
  result.element = spelling.element;
  check_element(problem, result);
  return result;
}

StatedParameter stated_parameter(const Entry& file, const MechanismParameter& parameter) {
  const Entry* variables = find(file, "variables");
  StatedParameter result{entry_of(find(file, "constants"), parameter),
                         entry_of(variables, parameter)};
  if (result.varying == nullptr && variables != nullptr) {
    result.varying = entry_of(find(*variables, "machine"), parameter);
  }
  return result;
}

}  // namespace camlaw::problems
