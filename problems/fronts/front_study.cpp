// SPDX-License-Identifier: MIT
#include "problems/fronts/front_study.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <stdexcept>

#include "optim/pareto/nsga2.h"
#include "optim/solvers/solver.h"
#include "problems/law_files/json_text.h"
#include "problems/law_files/pieces_json.h"
#include "problems/statement/held_files.h"

namespace camlaw::problems {
namespace {

constexpr std::array kMethods{std::pair{optim::ParetoMethod::Automatic, "auto"},
                              std::pair{optim::ParetoMethod::Sweep, "sweep"},
                              std::pair{optim::ParetoMethod::Nsga2, "nsga2"}};

constexpr const char* kProgram = "camlaw 0.1.0";

const std::string& find(const optim::StudySettings& settings, const char* name) {
  const auto at = settings.find(name);
  if (at == settings.end()) {
    throw std::invalid_argument(fmt::format("the study lacks its setting '{}'", name));
  }
  return at->second;
}

std::string versions() {
  std::vector<std::string> all = optim::solver_versions();
  all.insert(all.begin(), kProgram);
  all.push_back(optim::pagmo_version());
  return fmt::format("{}", fmt::join(all, ", "));
}

/// The laws that are not the catalogue's, name and pieces: what a problem's text does not hold.
std::string laws_of_files(const ProblemStatement& statement) {
  Json laws = Json::object();
  for (const Member& law : statement.laws) {
    const auto& all = catalogue();
    const bool listed = std::any_of(all.begin(), all.end(),
                                    [&](const Family& family) { return law.family == &family; });
    if (!listed) laws[law.family->name] = pieces_to_json(law.law());
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

ProblemStatement read_and_set(const std::string& text, const std::string& source,
                              const FrontSettings& settings) {
  ProblemStatement statement = read_problem(text, source, settings.files);
  set_values(statement, settings.set);
  return statement;
}

/// The files beside the problem; studies of problems without any, and of earlier programs, have
/// none.
HeldFiles files_of(const optim::StudySettings& settings) {
  HeldFiles files;
  const auto laws = settings.find("law_files"), tables = settings.find("tables");
  if (laws != settings.end()) files.laws = laws_from_json(setting_of("law_files", laws->second));
  if (tables != settings.end()) {
    files.tables = tables_from_json(setting_of("tables", tables->second));
  }
  return files;
}

/// What was set beside the file; studies of earlier programs have none.
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

std::size_t points_of(const std::string& text) {
  std::size_t points = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, points);
  if (error == std::errc() && rest == end && points >= 2 && points <= kMostPoints) return points;
  throw std::invalid_argument(fmt::format(
      "the study's setting 'points' is not a number from 2 to {}: '{}'", kMostPoints, text));
}

}  // namespace

optim::ParetoMethod parse_method(std::string_view text) {
  for (const auto& [method, name] : kMethods) {
    if (text == name) return method;
  }
  throw std::invalid_argument(
      fmt::format("no method is called '{}'; there are auto, sweep, nsga2", text));
}

std::string_view to_string(optim::ParetoMethod method) {
  for (const auto& [known, name] : kMethods) {
    if (known == method) return name;
  }
  return "";
}

FrontStudy::FrontStudy(std::string text, const std::string& source, const FrontSettings& settings)
    : text_(std::move(text)),
      source_(source),
      bound_(read_and_set(text_, source, settings)),
      space_(bound_.front_space()) {
  const SolverStatement& solver = bound_.statement().solver;
  options_.points = settings.points;
  options_.method = settings.method;
  options_.scouts = settings.scouts;
  options_.reference = bound_.reference();
  options_.seed = solver.seed.value_or(1);
  options_.solve.solver = solver.name.value_or("auto");
  options_.solve.starts = solver.starts;
  options_.solve.time_limit = solver.time_limit;
  options_.solve.native = solver.native;
}

FrontStudy FrontStudy::with_stop(const std::atomic<bool>* stop) const {
  FrontStudy result = *this;
  result.bound_ = bound_.with_stop(stop);
  result.space_ = result.bound_.front_space();
  return result;
}

FrontStudy FrontStudy::of(const optim::StudyRecord& record) {
  FrontStudy study = of(record.settings());
  study.options_.scouts = record.scouted();
  return study;
}

FrontStudy FrontStudy::of(const optim::StudySettings& settings) {
  FrontStudy study(find(settings, "problem"), find(settings, "source"), settings_of(settings));
  check_laws(find(settings, "laws"), study.settings().at("laws"));
  return study;
}

FrontSettings FrontStudy::settings_of(const optim::StudyRecord& record) {
  const optim::StudySettings settings = record.settings();
  if (record.has_checksums()) find(settings, "set");  // only earlier programs left it out
  FrontSettings result = settings_of(settings);
  result.scouts = record.scouted();
  return result;
}

FrontSettings FrontStudy::settings_of(const optim::StudySettings& settings) {
  return {points_of(find(settings, "points")),
          parse_method(find(settings, "method")),
          set_of(settings),
          {},
          files_of(settings)};
}

optim::StudySettings FrontStudy::settings() const {
  optim::StudySettings result{
      {"problem", text_},
      {"source", std::filesystem::absolute(source_).lexically_normal().string()},
      {"set", Json(bound_.statement().settings).dump()},
      {"laws", laws_of_files(bound_.statement())},
      {"points", fmt::format("{}", options_.points)},
      {"method", std::string(to_string(options_.method))},
      {"seed", fmt::format("{}", options_.seed)},
      {"solver", options_.solve.solver},
      {"versions", versions()}};
  const HeldFiles& files = bound_.statement().files;
  if (!files.laws.empty()) result["law_files"] = laws_to_json(files.laws).dump();
  if (!files.tables.empty()) result["tables"] = Json(files.tables).dump();
  return result;
}

void FrontStudy::check_same(const optim::StudyRecord& record) const {
  const optim::StudySettings mine = settings(), its = record.settings();
  const auto refuse = [](const std::string& why) {
    throw std::invalid_argument("the study cannot be resumed: " + why);
  };
  if (find(its, "problem") != text_) {
    refuse("the problem file is not the one that it was made with");
  }
  if (set_of(its) != bound_.statement().settings) {
    const auto words = [](const std::vector<std::string>& set) {
      return set.empty() ? std::string("nothing set")
                         : fmt::format("--set '{}'", fmt::join(set, "' --set '"));
    };
    refuse(fmt::format("it was made with {}, now it is {}", words(set_of(its)),
                       words(bound_.statement().settings)));
  }
  check_laws(find(its, "laws"), mine.at("laws"));
  for (const char* name : {"versions", "seed", "solver"}) {
    if (find(its, name) == mine.at(name)) continue;
    refuse(
        fmt::format("it was made with {} {}, now it is {}", name, find(its, name), mine.at(name)));
  }
}

optim::Front FrontStudy::run(optim::Executor& executor) const {
  return optim::pareto(space_, options_, executor);
}

ProblemStatement FrontStudy::design(const optim::FrontPoint& point) const {
  return bound_.at(space_.options(point.part), point.x);
}

std::optional<Member> FrontStudy::law(const optim::FrontPoint& point) const {
  if (bound_.statement().mechanism->moved_by == MovedBy::Nothing) return {};
  return design(point).laws.front().listed();
}

}  // namespace camlaw::problems
