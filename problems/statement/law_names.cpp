// SPDX-License-Identifier: MIT
#include "problems/statement/law_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "kinematics/shape.h"
#include "numerics/text/names.h"
#include "numerics/text/units.h"
#include "problems/law_files/law_file.h"
#include "problems/statement/parameters.h"
#include "problems/statement/reading.h"
#include "problems/statement/solver_settings.h"
#include "problems/statement/toml_reader.h"

namespace camlaw::problems {
namespace {

double read_value(std::string_view text, const Parameter& parameter, const std::string& what) {
  return parse_quantity(text, parameter.unit, parameter.unit, what);
}

/// "polynomial-5 alpha=-3" is an entry of the catalogue in its own right, which has no alpha that
/// could vary; the same law as a member of polynomial-5 has one.
Member as_family_member(const Member& law) {
  if (!is_of_catalogue(law)) return law;
  const std::string& name = law.family->name;
  const std::size_t space = name.find(' ');
  if (space == std::string::npos || name.find('=') == std::string::npos) return law;
  const Family& family = find_family(name.substr(0, space));
  Member result{&family, family.defaults()};
  set_argument(result, name.substr(space + 1));
  return result;
}

Member find_law_of(const Entry& name, HeldFiles& files) {
  if (const auto known = files.laws.find(name.text); known != files.laws.end())
    return known->second;
  const Member found = find_any_law(name.text, folder_of(name), read_value);
  if (is_law_file(found)) files.laws.emplace(name.text, found);
  return found;
}

/// The parameters that a law's name gives: those before an equals sign.
std::set<std::string> given_in(std::string_view name, const Family& family) {
  std::set<std::string> given;
  for (std::size_t equals = name.find('='); equals != std::string_view::npos;
       equals = name.find('=', equals + 1)) {
    const std::size_t end = name.find_last_not_of(' ', equals - 1) + 1;
    const std::size_t start = name.rfind(' ', end - 1) + 1;
    given.insert(family.parameters[family.parameter(name.substr(start, end - start))].name);
  }
  return given;
}

}  // namespace

std::string folder_of(const Entry& entry) {
  return std::filesystem::path(entry.place).parent_path().string();
}

void check_accepted(const Entry& entry, const NamedParameter& parameter, double value) {
  if (const auto why = refusal(parameter, value)) refuse(entry, *why);
}

void tell_apart(std::vector<Member>& laws) {
  std::map<std::string, int> count;
  for (const Member& law : laws) ++count[law.name()];
  for (Member& law : laws) {
    if (count[law.name()] > 1 && is_law_file(law)) law = called_by_path(law);
  }
}

void leave_to_free_law(const Entry& names, LawList& list) {
  const auto free = std::find_if(list.laws.begin(), list.laws.end(),
                                 [](const Member& law) { return bool(law.family->listed); });
  if (free == list.laws.end()) return;
  const auto& varied = free->family->parameters;
  const auto shares = [&](const Member& law) {
    return std::any_of(varied.begin(), varied.end(), [&](const auto& parameter) {
      return parameter.list && index_in(*law.family, parameter.name);
    });
  };
  LawList kept;
  for (std::size_t i = 0; i < list.laws.size(); ++i) {
    const Member& law = list.laws[i];
    if (!law.family->listed && shares(law)) {
      if (list.is_of_class[i]) continue;
      refuse(names,
             fmt::format("{} has the coefficients that the free law varies; name only one of "
                         "the two",
                         law.family->name));
    }
    kept.laws.push_back(law);
    kept.is_of_class.push_back(list.is_of_class[i]);
  }
  list = std::move(kept);
}

NamedLaw read_law_name(const Entry& name, HeldFiles& files) {
  const std::string& text = text_of(name);
  const Member found = located(name, [&] { return find_law_of(name, files); });
  const Member law = as_family_member(found);
  for (std::size_t i = 0; i < law.arguments.size(); ++i) {
    for (const double value : law.arguments.list(i)) {
      check_accepted(name, named(law.family->parameters[i]), value);
    }
  }
  // An entry of the catalogue with parameters in its name may have been found by another name.
  if (law.family->parameters.empty()) return {law, {}};
  const std::string& told = law.family == found.family ? text : found.family->name;
  return {law, given_in(told, *law.family)};
}

namespace {

/// What laws of a class have.
struct LawClass {
  std::optional<std::string> ends;
  std::optional<int> continuity;

  bool holds(const Law<double>& law) const {
    return (!ends || to_string(law.ends()) == *ends) &&
           (!continuity || camlaw::continuity(law) >= *continuity);
  }
};

/// The laws of the catalogue with their default parameters: where parameters decide the ends or how
/// smooth a law is, these are what a class is about.
std::vector<std::pair<Member, Law<double>>> laws_of_catalogue() {
  std::vector<std::pair<Member, Law<double>>> result;
  for (const Family& family : catalogue()) {
    Member member = as_family_member({&family, family.defaults()});
    if (auto law = member.possible_law()) result.emplace_back(std::move(member), std::move(*law));
  }
  return result;
}

std::string ends_of_catalogue() {
  std::set<std::string> all;
  for (const auto& law : laws_of_catalogue()) all.insert(to_string(law.second.ends()));
  std::string text;
  for (const std::string& ends : all) text += (text.empty() ? "" : ", ") + ends;
  return text;
}

/// Reads one condition, "ends R-R" or "continuity >= 2"; whether it is one.
bool read_condition(const Entry& name, std::string_view text, LawClass& found) {
  if (text == "all") return true;
  const auto rest = [&](std::string_view word) { return trimmed(text.substr(word.size())); };
  if (text.starts_with("ends ")) {
    found.ends = std::string(rest("ends"));
    const auto all = laws_of_catalogue();
    if (std::none_of(all.begin(), all.end(), [&](const auto& law) {
          return to_string(law.second.ends()) == *found.ends;
        })) {
      refuse(name, "no law has the ends '" + *found.ends + "'; there are " + ends_of_catalogue());
    }
    return true;
  }
  if (text.starts_with("continuity")) {
    std::string_view least = rest("continuity");
    if (!least.starts_with(">=")) refuse(name, "write a condition such as continuity >= 2");
    least = trimmed(least.substr(2));
    located(name, [&] {
      found.continuity = static_cast<int>(parse_integer(std::string(least), 0, 9, "continuity"));
    });
    return true;
  }
  return false;
}

}  // namespace

std::optional<std::vector<Member>> read_law_class(const Entry& name) {
  if (name.kind != Entry::Kind::Text) return {};
  LawClass wanted;
  bool is_first = true;
  for (const std::string_view condition : parted(name.text, ',')) {
    if (!read_condition(name, condition, wanted)) {
      if (is_first) return {};  // the name of a law
      refuse(name, "'" + std::string(condition) +
                       "' is not a condition on laws; write all, ends R-R or continuity >= 2");
    }
    is_first = false;
  }
  std::vector<Member> laws;
  for (auto& [member, law] : laws_of_catalogue()) {
    const bool is_there = std::any_of(laws.begin(), laws.end(), [&](const Member& other) {
      return other.name() == member.name();
    });
    if (!is_there && wanted.holds(law)) laws.push_back(std::move(member));
  }
  if (laws.empty()) refuse(name, "no law of the catalogue meets it");
  return laws;
}

bool is_of_catalogue(const Member& law) {
  return std::any_of(catalogue().begin(), catalogue().end(),
                     [&](const Family& family) { return &family == &*law.family; });
}

}  // namespace camlaw::problems
