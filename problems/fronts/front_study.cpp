// SPDX-License-Identifier: MIT
#include "problems/fronts/front_study.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <charconv>
#include <stdexcept>

#include "optim/pareto/scout.h"

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

std::size_t points_of(const std::string& text) {
  std::size_t points = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, points);
  if (error == std::errc() && rest == end && points >= 2 && points <= kMostPoints) return points;
  throw std::invalid_argument(fmt::format(
      "the study's setting 'points' is no number from 2 to {}: '{}'", kMostPoints, text));
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
      bound_(read_problem(text_, source)),
      space_(bound_.front_space()) {
  const SolverStatement& solver = bound_.statement().solver;
  options_.points = settings.points;
  options_.method = settings.method;
  options_.reference = bound_.reference();
  options_.seed = solver.seed.value_or(1);
  options_.solve.solver = solver.name.value_or("auto");
  options_.solve.starts = solver.starts;
  options_.solve.time_limit = solver.time_limit;
}

FrontStudy FrontStudy::of(const optim::StudyRecord& record) {
  const optim::StudySettings settings = record.settings();
  return {find(settings, "problem"),
          find(settings, "source"),
          {points_of(find(settings, "points")), parse_method(find(settings, "method"))}};
}

optim::StudySettings FrontStudy::settings() const {
  return {{"problem", text_},
          {"source", source_},
          {"points", fmt::format("{}", options_.points)},
          {"method", std::string(to_string(options_.method))},
          {"seed", fmt::format("{}", options_.seed)},
          {"solver", options_.solve.solver},
          {"versions", versions()}};
}

void FrontStudy::check_same(const optim::StudyRecord& record) const {
  const optim::StudySettings mine = settings(), its = record.settings();
  const auto refuse = [](const std::string& why) {
    throw std::invalid_argument("the study cannot be resumed: " + why);
  };
  if (find(its, "problem") != text_) {
    refuse("the problem file is not the one that it was made with");
  }
  for (const char* name : {"versions", "seed", "solver"}) {
    if (find(its, name) == mine.at(name)) continue;
    refuse(
        fmt::format("it was made with {} {}, now it is {}", name, find(its, name), mine.at(name)));
  }
}

optim::Front FrontStudy::run(optim::Executor& executor) const {
  return optim::pareto(space_, options_, executor);
}

std::optional<Member> FrontStudy::law(const optim::FrontPoint& point) const {
  if (bound_.statement().mechanism->moved_by == MovedBy::Nothing) return {};
  return bound_.at(space_.options(point.part), point.x).laws.front().listed();
}

}  // namespace camlaw::problems
