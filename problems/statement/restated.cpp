// SPDX-License-Identifier: MIT
#include "problems/statement/restated.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>
#include <stdexcept>
#include <vector>

#include "machines/model/known_names.h"
#include "numerics/text/names.h"
#include "numerics/text/units.h"
#include "problems/statement/cases.h"
#include "problems/statement/made_entries.h"
#include "problems/statement/parameters.h"
#include "problems/statement/program_timing.h"
#include "problems/statement/program_units.h"
#include "problems/statement/reading.h"
#include "problems/statement/table_settings.h"
#include "problems/statement/toml_reader.h"

namespace camlaw::problems {
namespace {

using Kind = Entry::Kind;

constexpr std::string_view kFreeTable = "free.", kLaw = "law", kLower = ".lower", kUpper = ".upper";

/// What "base_radius.upper" bounds; none where the name is of no bound.
std::optional<std::string_view> bounded(std::string_view name) {
  for (const std::string_view end : {kLower, kUpper}) {
    if (name.ends_with(end)) return name.substr(0, name.size() - end.size());
  }
  return {};
}

bool has_range(const ProblemStatement& problem, std::string_view name) {
  return std::any_of(problem.ranges.begin(), problem.ranges.end(), [&](const auto& range) {
    const MechanismParameter& p = problem.mechanism->parameters[range.parameter];
    return p.name == name || p.symbol == name;
  });
}

const VariableStatement* variable_named(const ProblemStatement& problem, std::string_view name) {
  const auto found = std::find_if(problem.variables.begin(), problem.variables.end(),
                                  [&](const VariableStatement& v) {
                                    return v.name == name || v.name == "law." + std::string(name);
                                  });
  return found == problem.variables.end() ? nullptr : &*found;
}

/// Whether a response or a peak is one of the mechanism's, in a load case or in all, as limits name
/// them: "peak contact_stress", "fast.peak_stress".
bool has_response(const Mechanism& mechanism, std::string_view name) {
  const std::string_view bare = name.substr(name.rfind(' ') + 1);  // npos + 1 is 0
  const auto is_called = [&](const auto& known) { return known.name == bare; };
  return std::any_of(mechanism.responses.begin(), mechanism.responses.end(), is_called) ||
         std::any_of(mechanism.peaks.begin(), mechanism.peaks.end(), is_called);
}

/// Whether the file limits a response on this side.
bool is_limited(const ProblemStatement& problem, std::string_view name, bool from_above) {
  return std::any_of(problem.constraints.begin(), problem.constraints.end(),
                     [&](const ConstraintStatement& limit) {
                       return is_on(limit, name) && (from_above ? limit.upper : limit.lower);
                     });
}

/// The case of "fast.load" whose parameter no case sets.
const LoadCase* case_without(const ProblemStatement& problem, std::string_view name) {
  const auto [owner, parameter] = at_last_dot(name);
  const LoadCase* load = find_case(problem, owner);
  if (load == nullptr || parameter == "weight") return nullptr;
  for (const auto& [set, value] : load->parameters) {
    const MechanismParameter& p = problem.mechanism->parameters[set];
    if (p.name == parameter || p.symbol == parameter) return nullptr;
  }
  return load;
}

Entry laws_entry(const Entry& table, std::string_view key, std::string_view text,
                 const std::string& place) {
  const std::vector<std::string> names = law_list(text);
  if (names.size() == 1) return made_text(table, key, names.front(), place);
  Entry list = made_entry(Kind::List, table, key, place);
  for (const std::string& name : names) list.items.push_back(made_text(list, key, name, place));
  return list;
}

/// Gives the segments of a program that have a law another; of `segment` that one, be it without a
/// law so far. Whether there is such a segment.
bool put_segment_law(Entry& program, std::optional<std::string_view> segment, std::string_view text,
                     const std::string& place) {
  Entry* list = find_entry(program, "segments");
  if (list == nullptr) return false;
  bool is_put = false;
  for (std::size_t i = 0; i < list->items.size(); ++i) {
    Entry& table = list->items[i];
    if (table.kind != Kind::Table) continue;
    const Entry* law = find(table, kLaw);
    const bool moves = law != nullptr && law->text != "joining";
    if (segment ? segment_name(table, i) != *segment : !moves) continue;
    put_entry(table, laws_entry(table, kLaw, text, place));
    is_put = true;
  }
  return is_put;
}

/// Of a file, or of the table of one of its cams.
bool put_law(Entry& motion, std::optional<std::string_view> segment, std::string_view text,
             const std::string& place) {
  if (Entry* program = find_entry(motion, "program")) {
    return program->kind == Kind::Table && put_segment_law(*program, segment, text, place);
  }
  Entry* law = find_entry(motion, kLaw);
  if (segment || law == nullptr || law->kind != Kind::Table) return false;
  put_entry(*law, laws_entry(*law, "name", text, place));
  return true;
}

void put_laws(Entry& file, std::string_view name, std::string_view text, const std::string& place) {
  const std::string_view owner = at_last_dot(name).first;
  Entry* cams = find_entry(file, "cams");
  if (owner.empty() && cams == nullptr) {
    if (put_law(file, {}, text, place)) return;
    throw std::invalid_argument(
        fmt::format("{}: the file names no law that this could replace", name));
  }
  if (!owner.empty() && cams == nullptr) {
    if (put_law(file, owner, text, place)) return;
    throw std::invalid_argument(fmt::format("{}: the program has no segment '{}'", name, owner));
  }
  bool is_put = false;
  for (Entry& cam : cams->items) {
    if (owner.empty() || cam.key == owner) {
      is_put = put_law(cam, {}, text, place) || is_put;
    } else if (owner.starts_with(cam.key + ".")) {
      is_put = put_law(cam, owner.substr(cam.key.size() + 1), text, place) || is_put;
    }
  }
  if (!is_put) {
    throw std::invalid_argument(fmt::format(
        "{}: there is neither a cam '{}' nor a segment of that name; write infeed.law or "
        "infeed.rise.law",
        name, owner));
  }
}

/// The entry of a variable, by its own name or as one of the law's.
Entry* variable_entry(Entry& file, std::string_view name) {
  Entry* variables = find_entry(file, "variables");
  if (variables == nullptr) return nullptr;
  for (const char* owner : {"", "law", "machine"}) {
    Entry* table = *owner == '\0' ? variables : find_entry(*variables, owner);
    Entry* found = table == nullptr ? nullptr : find_entry(*table, name);
    if (found != nullptr && found->kind == Kind::Table) return found;
  }
  return nullptr;
}

void put_variable_bound(Entry& file, const VariableStatement& variable, std::string_view name,
                        std::string_view text, const std::string& place) {
  const auto [owner, side] = at_last_dot(name);
  Entry* entry = variable_entry(file, owner);
  if (entry == nullptr) {
    throw std::invalid_argument(
        fmt::format("{}: the bounds of {} are not in a table of their own; change them in the file",
                    name, variable.name));
  }
  put_entry(*entry, made_text(*entry, side, text, place));
  // A start that the file states for other bounds may lie outside of these.
  const double bound = parse_quantity(text, variable.unit, variable.unit, std::string(name));
  const bool leaves = side == "upper" ? variable.start > bound : variable.start < bound;
  if (leaves) std::erase_if(entry->items, [](const Entry& item) { return item.key == "start"; });
}

void put_limit(Entry& file, std::string_view name, std::string_view text,
               const std::string& place) {
  const auto [response, side] = at_last_dot(name);
  Entry& list = entry_or_made(file, "constraints", Kind::List, place);
  for (Entry& table : list.items) {
    // One that was made here for the same response, not one of the file.
    const Entry* own = find(table, "response");
    const bool is_made = table.place.find('=') != std::string::npos &&
                         table.place.starts_with(std::string(response) + ".");
    if (!is_made || own == nullptr || own->text != response) continue;
    put_entry(table, made_text(table, side, text, place));
    return;
  }
  Entry table = made_item(list, place);
  table.items = {made_text(table, "response", response, place),
                 made_text(table, side, text, place)};
  list.items.push_back(std::move(table));
}

/// "free.knots": a key of the table [free], which is made where the file has none.
void put_free(Entry& file, std::string_view name, std::string_view text, const std::string& place) {
  const std::string_view key = name.substr(kFreeTable.size());
  Entry& table = entry_or_made(file, "free", Kind::Table, place);
  if (table.kind != Kind::Table) return;  // which is refused where it is read
  put_entry(table, written_entry(table, key, text, place));
}

/// The speed of a machine whose program has times that stay: none where this is not its name.
const MechanismParameter* speed_of_times(const ProblemStatement& problem, std::string_view name) {
  // A program that follows the speed has it as any other parameter.
  if (!holds_angles_of_speed(problem)) return nullptr;
  for (const MechanismParameter& p : problem.mechanism->parameters) {
    if (p.unit == "rpm" && p.name == known::kSpeed && (name == p.name || name == p.symbol))
      return &p;
  }
  return nullptr;
}

void drop(Entry& table, std::string_view key) {
  std::erase_if(table.items, [&](const Entry& item) { return item.key == key; });
}

/// Gives the machine another speed, from which the times of its program make other angles. On a
/// shaft the programs of other cams keep theirs.
void put_speed(Entry& file, const ProblemStatement& problem, const MechanismParameter& speed,
               std::string_view text, const std::string& place) {
  if (problem.cams.empty()) drop(*find_entry(file, "program"), "cycle_time");
  for (const CamStatement& cam : problem.cams) {
    if (!cam.alone->timing) continue;
    Entry& program = *find_entry(*find_entry(*find_entry(file, "cams"), cam.name), "program");
    drop(program, "cycle_time");
    const bool has_times = !cam.alone->timing->segments.empty() || has_rates_by_time(program);
    if (!has_times || holds_angles_of_speed(*cam.alone) || find(program, "times_at") != nullptr) {
      continue;
    }
    const std::string held = fmt::format("{:.17g} rpm", cam.alone->timing->speed);
    put_entry(program, made_text(program, "times_at", held, place));
  }
  Entry& constants = entry_or_made(file, "constants", Kind::Table, place);
  std::erase_if(constants.items, [&](const Entry& item) { return item.key == speed.symbol; });
  put_entry(constants, made_text(constants, speed.name, text, place));
}

/// Not so "3-4-5", which is a law.
bool is_number(std::string_view part) {
  if (part.starts_with('+')) part.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
  return error == std::errc() && end == part.data() + part.size();
}

/// Whether what follows a comma is of the law before it: a number, and perhaps more of its
/// parameters, such as "1 s=0".
bool is_of_law_before(std::string_view part) {
  const std::size_t space = part.find(' ');
  return is_number(part.substr(0, space)) &&
         (space == std::string_view::npos || part.find('=', space) != std::string_view::npos);
}

}  // namespace

std::vector<std::string> law_list(std::string_view text) {
  for (const std::string_view word : {"all", "ends ", "continuity"}) {
    if (text.starts_with(word)) return {std::string(text)};
  }
  std::vector<std::string> names;
  for (const std::string_view part : parted(text, ',')) {
    if (is_of_law_before(part) && !names.empty()) {
      names.back() += fmt::format(",{}", part);
    } else {
      names.emplace_back(part);
    }
  }
  return names;
}

bool is_on(const ConstraintStatement& limit, std::string_view response) {
  if (limit.of_law || limit.of_check) return false;
  const MechanismResponse* declared = limit.response.response;
  for (const std::string& name : {limit.response.name, limit.one_value.name}) {
    if (name == response) return true;
    if (declared == nullptr || !declared->in_case) continue;
    const std::string prefix = declared->in_case->name + ".";
    const std::size_t at = name.find(prefix);
    const bool is_in_case = at != std::string::npos;
    if (is_in_case && name.substr(0, at) + name.substr(at + prefix.size()) == response) return true;
  }
  return false;
}

bool is_law_setting(std::string_view name) { return name == kLaw || name.ends_with(".law"); }

bool is_free_setting(const ProblemStatement& problem, std::string_view name) {
  const bool has_cam = std::any_of(problem.cams.begin(), problem.cams.end(),
                                   [](const CamStatement& cam) { return cam.name == "free"; });
  return name.starts_with(kFreeTable) && !is_law_setting(name) && !has_cam;
}

bool is_of_file(const ProblemStatement& problem, std::string_view name) {
  if (is_law_setting(name) || is_free_setting(problem, name)) return true;
  if (speed_of_times(problem, name) != nullptr) return true;
  if (is_table_setting(problem, name)) return true;
  if (const auto response = bounded(name)) {
    if (has_range(problem, *response)) return false;
    if (variable_named(problem, *response) != nullptr) return true;
    return has_response(*problem.mechanism, *response) &&
           !is_limited(problem, *response, name.ends_with(kUpper));
  }
  return case_without(problem, name) != nullptr;
}

void restate(Entry& file, const ProblemStatement& problem, std::string_view name,
             std::string_view text, const std::string& assignment) {
  if (text.empty()) {
    throw std::invalid_argument(fmt::format("'{}' sets nothing; give a value", assignment));
  }
  if (is_law_setting(name)) return put_laws(file, name, text, assignment);
  if (is_free_setting(problem, name)) return put_free(file, name, text, assignment);
  if (const MechanismParameter* speed = speed_of_times(problem, name)) {
    return put_speed(file, problem, *speed, text, assignment);
  }
  if (is_table_setting(problem, name)) {
    return put_in_table(file, problem, name, text, assignment);
  }
  if (const auto response = bounded(name)) {
    if (const VariableStatement* variable = variable_named(problem, *response)) {
      return put_variable_bound(file, *variable, name, text, assignment);
    }
    return put_limit(file, name, text, assignment);
  }
  const LoadCase& load = *case_without(problem, name);
  put_in_case(file, problem, load.name, at_last_dot(name).second, text, assignment);
}

}  // namespace camlaw::problems
