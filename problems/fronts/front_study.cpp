// SPDX-License-Identifier: MIT
#include "problems/fronts/front_study.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <charconv>
#include <stdexcept>

#include "problems/fronts/problem_settings.h"
#include "problems/statement/auto_knots.h"
#include "problems/statement/ranges.h"

namespace camlaw::problems {
namespace {

constexpr std::array kMethods{std::pair{optim::ParetoMethod::Automatic, "auto"},
                              std::pair{optim::ParetoMethod::Sweep, "sweep"},
                              std::pair{optim::ParetoMethod::Nsga2, "nsga2"}};

ProblemStatement read_and_set(const std::string& text, const std::string& source,
                              const FrontSettings& settings) {
  ProblemStatement statement = read_problem(text, source, settings.files);
  set_values(statement, settings.set);
  return statement;
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
  throw std::invalid_argument(fmt::format("'{}' is not a method; use auto, sweep or nsga2", text));
}

std::string_view to_string(optim::ParetoMethod method) {
  for (const auto& [known, name] : kMethods) {
    if (known == method) return name;
  }
  return "";
}

FrontStudy::FrontStudy(const std::string& text, const std::string& source,
                       const FrontSettings& settings)
    : bound_(read_and_set(text, source, settings)), space_(bound_.front_space()) {
  refuse_auto_knots(bound_.statement(), "a front");
  refuse_reliabilities(bound_.statement(), "a front");
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
  FrontStudy study(find_setting(settings, "problem"), find_setting(settings, "source"),
                   settings_of(settings));
  check_laws(find_setting(settings, "laws"), study.settings().at("laws"));
  return study;
}

FrontSettings FrontStudy::settings_of(const optim::StudyRecord& record) {
  const optim::StudySettings settings = record.settings();
  if (record.has_checksums()) find_setting(settings, "set");  // only earlier programs left it out
  FrontSettings result = settings_of(settings);
  result.scouts = record.scouted();
  return result;
}

FrontSettings FrontStudy::settings_of(const optim::StudySettings& settings) {
  if (const std::string_view kind = kind_of_study(settings); kind != "a front") {
    throw std::invalid_argument(kind == "a sweep"
                                    ? "the study is a sweep, not a front; 'camlaw report' shows it"
                                    : fmt::format("the study is a yield, not a front; 'camlaw "
                                                  "tolerance {} --db FILE --resume' shows it",
                                                  find_setting(settings, "source")));
  }
  return {points_of(find_setting(settings, "points")),
          parse_method(find_setting(settings, "method")),
          set_of(settings),
          {},
          files_of(settings)};
}

optim::StudySettings FrontStudy::settings() const {
  optim::StudySettings result = problem_settings(bound_.statement());
  result["points"] = fmt::format("{}", options_.points);
  result["method"] = std::string(to_string(options_.method));
  result["seed"] = fmt::format("{}", options_.seed);
  result["solver"] = options_.solve.solver;
  return result;
}

void FrontStudy::check_same(const optim::StudyRecord& record) const {
  const optim::StudySettings mine = settings(), its = record.settings();
  check_kind(its, "a front");
  check_same_problem(its, mine);
  if (set_of(its) != bound_.statement().settings) {
    const auto words = [](const std::vector<std::string>& set) {
      return set.empty() ? std::string("nothing set")
                         : fmt::format("--set '{}'", fmt::join(set, "' --set '"));
    };
    refuse_to_resume(fmt::format("it was made with {}, now it is {}", words(set_of(its)),
                                 words(bound_.statement().settings)));
  }
  check_same_settings(its, mine, {"versions", "seed", "solver"});
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
