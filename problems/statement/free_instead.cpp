// SPDX-License-Identifier: MIT
#include "problems/statement/free_instead.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "kinematics/law_conditions.h"
#include "problems/statement/assignment.h"
#include "problems/statement/made_entries.h"
#include "problems/statement/parameters.h"
#include "problems/statement/reading.h"
#include "problems/statement/restated.h"
#include "problems/statement/toml_reader.h"

namespace camlaw::problems {
namespace {

constexpr const char* kPlace = "the free law instead";

/// The laws that stand in one place: under a law setting's name, "law" or "infeed.rise.law", those
/// of each member.
using LawsByPlace = std::map<std::string, std::vector<Member>>;

void add_places(const std::string& owner, const Member& member, LawsByPlace& places) {
  if (!member.family->parts.empty()) {
    for (const LawPart& part : member.family->parts) {
      add_places(part.name + ".", *part.law, places);
    }
  } else if (member.family->spans) {
    for (const NamedSpan& span : member.family->spans(member.arguments)) {
      if (span.law) places[fmt::format("{}{}.law", owner, span.name)].push_back(*span.law);
    }
  } else {
    places[owner + "law"].push_back(member);
  }
}

LawsByPlace places_of(std::span<const Member> members) {
  LawsByPlace places;
  for (const Member& member : members) add_places("", member, places);
  return places;
}

bool is_choice(const std::vector<Member>& laws) {
  return std::any_of(laws.begin(), laws.end(),
                     [&](const Member& law) { return law.name() != laws.front().name(); });
}

bool is_free_member(const Member& law) { return bool(law.family->listed); }

/// The table, of the file or of a cam, that has the program or the law of a place.
Entry& owner_of(Entry& file, std::string_view place) {
  Entry* cams = find_entry(file, "cams");
  Entry* cam = cams == nullptr ? nullptr : find_entry(*cams, place.substr(0, place.find('.')));
  return cam == nullptr ? file : *cam;
}

/// How many derivatives vanish at an end.
int rests(const LawConditions& wanted, bool at_end) {
  const bool* rest = wanted.rest[at_end ? 1 : 0];
  return !rest[0] ? 0 : rest[1] ? 2 : 1;
}

/// The table [free] of a law that comes as near as its knots allow to every law that meets these
/// conditions.
void put_free_table(Entry& owner, const LawConditions& wanted, int knots) {
  const bool jumps = wanted.continuity < 2;  // the acceleration, inside
  const int continuity = jumps ? 1 : 2;
  Entry& table = entry_or_made(owner, "free", Entry::Kind::Table, kPlace);
  const auto put = [&](const char* key, int value) {
    put_entry(table, written_entry(table, key, std::to_string(value), kPlace));
  };
  put("degree", continuity + 1);
  put("continuity", continuity);
  put("knots", knots);
  put("begin", std::min(rests(wanted, false), continuity));
  put("end", std::min(rests(wanted, true), continuity));
}

/// Whether a name is of a parameter that the laws of one problem have and those of another do not.
bool is_lost(std::string_view name, const ProblemStatement& before, const ProblemStatement& now) {
  constexpr std::string_view kOfLaw = "law.";
  if (name.starts_with(kOfLaw)) name.remove_prefix(kOfLaw.size());
  name = name.substr(0, name.find('['));
  const auto has = [&](const ProblemStatement& problem) {
    return std::any_of(problem.laws.begin(), problem.laws.end(),
                       [&](const Member& law) { return index_in(*law.family, name).has_value(); });
  };
  return has(before) && !has(now);
}

/// Takes what `is_of_lost` says of a name out of a file's variables and of the values in [law].
template <class Lost>
void take_out(Entry& file, Lost is_of_lost) {
  const auto is_gone = [&](const Entry& entry) { return is_of_lost(entry.key); };
  if (Entry* variables = find_entry(file, "variables")) {
    std::erase_if(variables->items, is_gone);
    if (Entry* owned = find_entry(*variables, "law")) std::erase_if(owned->items, is_gone);
  }
  Entry* law = find_entry(file, "law");
  if (law != nullptr && law->kind == Entry::Kind::Table) {
    std::erase_if(law->items,
                  [&](const Entry& entry) { return entry.key != "name" && is_of_lost(entry.key); });
  }
}

/// A file's entries with what its settings say that only the file can; the other settings.
std::vector<std::string> put_settings(Entry& file, const ProblemStatement& problem) {
  const ProblemStatement plain = read_entries(file, problem.text, problem.source, problem.files);
  std::vector<std::string> left;
  for (const std::string& setting : problem.settings) {
    const auto [name, text] = parse_assignment(setting, "stroke=30 mm");
    if (is_of_file(plain, name)) {
      restate(file, plain, name, text, setting);
    } else {
      left.push_back(setting);
    }
  }
  return left;
}

/// Puts the free law in the places of laws that are chosen. Whether one of them has these knots.
bool put_free_laws(Entry& file, const ProblemStatement& problem, std::span<const Member> designs,
                   int knots) {
  const LawsByPlace stated = places_of(problem.laws);
  const LawsByPlace wanted = places_of(designs.empty() ? std::span(problem.laws) : designs);
  struct Owned {
    LawConditions conditions = {};
    bool is_stated = false;  ///< by the file's own [free]
  };
  std::map<Entry*, Owned> owners;
  for (const auto& [place, laws] : stated) {
    if (!is_choice(laws)) continue;
    Owned& owned = owners[&owner_of(file, place)];
    owned.is_stated |= std::any_of(laws.begin(), laws.end(), is_free_member);
    for (const Member& law : wanted.at(place)) {
      owned.conditions = shared_conditions(owned.conditions, conditions_of(law.law()));
    }
    restate(file, problem, place, "free", kPlace);
  }
  if (owners.empty()) throw std::invalid_argument("no law is chosen among several");
  bool has_these_knots = false;
  for (const auto& [owner, owned] : owners) {
    if (owned.is_stated) continue;
    put_free_table(*owner, owned.conditions, knots);
    has_these_knots = true;
  }
  return has_these_knots;
}

}  // namespace

FreeInstead with_free_law(const ProblemStatement& problem, std::span<const Member> designs,
                          int knots) {
  Entry file = parse_toml(problem.text, problem.source);
  std::vector<std::string> settings = put_settings(file, problem);
  const bool has_these_knots = put_free_laws(file, problem, designs, knots);
  const auto read = [&](const Entry& entries) {
    return read_entries(entries, problem.text, problem.source, problem.files);
  };
  Entry without = file;  // any parameter of the laws, to see which of them the free law has
  const ProblemStatement none;
  take_out(without, [&](std::string_view name) { return is_lost(name, problem, none); });
  const ProblemStatement bare = read(without);
  const auto is_gone = [&](std::string_view name) { return is_lost(name, problem, bare); };
  take_out(file, is_gone);
  ProblemStatement result = read(file);
  std::erase_if(settings, [&](const std::string& setting) {
    return is_gone(parse_assignment(setting, "stroke=30 mm").name);
  });
  result.stop = problem.stop;
  set_values(result, settings);
  return {std::move(result), has_these_knots};
}

}  // namespace camlaw::problems
