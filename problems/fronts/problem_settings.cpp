// SPDX-License-Identifier: MIT
#include "problems/fronts/problem_settings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "kinematics/laws/side_by_side.h"
#include "optim/pareto/nsga2.h"
#include "optim/solvers/solver.h"
#include "problems/law_files/json_text.h"
#include "problems/law_files/pieces_json.h"
#include "problems/statement/held_files.h"
#include "problems/statement/law_names.h"

namespace camlaw::problems {
namespace {

constexpr const char* kProgram = "camlaw 0.1.0";

/// The laws that are not the catalogue's, name and pieces: what a problem's text does not hold. Of
/// several side by side each by the name of what it moves.
std::string laws_of_files(const ProblemStatement& statement) {
  Json laws = Json::object();
  for (const Member& law : statement.laws) {
    const std::vector<Member> beside = laws_side_by_side(law);
    for (std::size_t i = 0; i < beside.size(); ++i) {
      if (is_of_catalogue(beside[i])) continue;
      laws[law.family->parts[i].name + ": " + beside[i].family->name] =
          pieces_to_json(beside[i].law());
    }
    if (beside.empty() && !is_of_catalogue(law)) {
      laws[law.family->name] = pieces_to_json(law.law());
    }
  }
  return laws.dump();
}

/// A setting of a study that is JSON.
Json setting_of(const char* name, const std::string& text) {
  try {
    return parse_json(text);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(
        fmt::format("the study's setting '{}' is damaged: {}", name, error.what()));
  }
}

}  // namespace

std::string problem_versions() {
  std::vector<std::string> all = optim::solver_versions();
  all.insert(all.begin(), kProgram);
  all.push_back(optim::pagmo_version());
  return fmt::format("{}", fmt::join(all, ", "));
}

const std::string& find_setting(const optim::StudySettings& settings, const char* name) {
  const auto at = settings.find(name);
  if (at == settings.end()) {
    throw std::invalid_argument(fmt::format("the study lacks its setting '{}'", name));
  }
  return at->second;
}

void check_laws(const std::string& its, const std::string& now) {
  if (its == now) return;
  const Json before = setting_of("laws", its), after = parse_json(now);
  for (const auto& [name, pieces] : before.items()) {
    if (after.contains(name) && after[name] == pieces) continue;
    throw std::invalid_argument(
        fmt::format("the law '{}' is not the one that the study was made with", name));
  }
  throw std::invalid_argument("the laws are not those that the study was made with");
}

HeldFiles files_of(const optim::StudySettings& settings) {
  HeldFiles files;
  const auto laws = settings.find("law_files"), tables = settings.find("tables");
  if (laws != settings.end()) files.laws = laws_from_json(setting_of("law_files", laws->second));
  if (tables != settings.end()) {
    files.tables = tables_from_json(setting_of("tables", tables->second));
  }
  return files;
}

std::vector<std::string> set_of(const optim::StudySettings& settings) {
  const auto at = settings.find("set");
  if (at == settings.end()) return {};
  const Json set = setting_of("set", at->second);
  const bool texts = set.is_array() && std::all_of(set.begin(), set.end(), [](const Json& text) {
                       return text.is_string();
                     });
  if (!texts) throw std::invalid_argument("the study's setting 'set' is not a list of texts");
  return set.get<std::vector<std::string>>();
}

std::string_view kind_of_study(const optim::StudySettings& settings) {
  if (settings.contains(kSweepSetting)) return "a sweep";
  return settings.contains(kYieldSetting) ? "a yield" : "a front";
}

void check_kind(const optim::StudySettings& its, std::string_view wanted) {
  const std::string_view kind = kind_of_study(its);
  if (kind == wanted) return;
  const char* command = kind == "a front" ? "pareto" : kind == "a sweep" ? "sweep" : "tolerance";
  refuse_to_resume(
      fmt::format("it is {}, not {}; 'camlaw {} FILE --db STUDY --resume' continues it", kind,
                  wanted, command));
}

optim::StudySettings problem_settings(const ProblemStatement& statement) {
  optim::StudySettings result{
      {"problem", statement.text},
      {"source", std::filesystem::absolute(statement.source).lexically_normal().string()},
      {"set", Json(statement.settings).dump()},
      {"laws", laws_of_files(statement)},
      {"versions", problem_versions()}};
  const HeldFiles& files = statement.files;
  if (!files.laws.empty()) result["law_files"] = laws_to_json(files.laws).dump();
  if (!files.tables.empty()) result["tables"] = Json(files.tables).dump();
  return result;
}

ProblemStatement stated_problem(const optim::StudySettings& settings) {
  ProblemStatement statement = read_problem(find_setting(settings, "problem"),
                                            find_setting(settings, "source"), files_of(settings));
  set_values(statement, set_of(settings));
  check_laws(find_setting(settings, "laws"), laws_of_files(statement));
  return statement;
}

void refuse_to_resume(const std::string& why) {
  throw std::invalid_argument("the study cannot be resumed: " + why);
}

void check_same_problem(const optim::StudySettings& its, const optim::StudySettings& mine) {
  if (find_setting(its, "problem") == mine.at("problem")) return;
  refuse_to_resume("the problem file is not the one that it was made with");
}

namespace {

/// Refuses where a file that the problem names holds something else than it did for the study.
void check_same_files(const optim::StudySettings& its, const optim::StudySettings& mine) {
  for (const char* kind : {"law_files", "tables"}) {
    const auto now = mine.find(kind), before = its.find(kind);
    if (now == mine.end()) continue;
    const Json kept = before == its.end() ? Json::object() : setting_of(kind, before->second);
    const Json found = parse_json(now->second);
    for (const auto& [name, content] : found.items()) {
      if (kept.contains(name) && kept[name] == content) continue;
      refuse_to_resume(
          fmt::format("the file '{}' is not as it was when the study was made; restore it, or "
                      "begin a new study in another file",
                      name));
    }
  }
}

}  // namespace

void check_same_settings(const optim::StudySettings& its, const optim::StudySettings& mine,
                         std::initializer_list<const char*> names) {
  check_same_files(its, mine);
  check_laws(find_setting(its, "laws"), mine.at("laws"));
  for (const char* name : names) {
    if (find_setting(its, name) == mine.at(name)) continue;
    refuse_to_resume(fmt::format("it was made with {} {}, now it is {}", name,
                                 find_setting(its, name), mine.at(name)));
  }
}

}  // namespace camlaw::problems
