// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <atomic>
#include <catch2/catch.hpp>
#include <functional>
#include <mutex>

#include "fitting/motions/law_fit.h"
#include "kinematics/laws/catalogue.h"
#include "kinematics/peaks.h"
#include "numerics/library_mutex.h"
#include "numerics/text/units.h"
#include "optim/pareto/scout.h"
#include "optim/search/optimise.h"
#include "optim/solvers/solver.h"
#include "problems/fronts/front_study.h"
#include "problems/statement/bind.h"
#include "tests/optim/pareto/outcomes.h"
#include "tests/optim/pareto/small_fronts.h"
#include "tests/paths.h"
#include "tests/threads/many_threads.h"

/// The library from eight threads at once gives what it gives from one, to the last bit.
namespace camlaw::read_and_solve_test {
namespace {

using optim::study_tests::bits;
using testing::in_threads;

constexpr int kThreads = 8;

/// Ipopt and NLopt, limits over the cycle, a free law, integer variables, a turn in sections.
constexpr std::array kFiles{"spine_cutter/least_radius.toml", "cams/roller_least_base.toml",
                            "free_law/least_acceleration.toml", "springs/follower_spring.toml",
                            "geneva/fastest.toml"};

std::string path_of(const std::string& file) { return testing::source("problems/") + file; }

std::string bits(const optim::Optimum& optimum) {
  const optim::Assessment& a = optimum.found.assessment;
  std::string text = std::string(to_string(a.verdict)) + "; " + a.reason + "; " +
                     optimum.found.solver + " " + bits(optimum.found.x) + bits(a.objective.value) +
                     bits(a.kkt_residual) + std::to_string(optimum.found.iterations) + " " +
                     std::to_string(optimum.found.evaluations);
  for (const optim::LimitReport& limit : a.limits) {
    text += "\n  " + limit.name + " " + bits(limit.margin) + bits(limit.multiplier);
  }
  return text;
}

std::string solved(const std::string& file) {
  const problems::BoundProblem bound(problems::read_problem_file(path_of(file)));
  return bits(optim::optimise(bound.space()));
}

/// The message of a quantity that cannot be read, or its value.
std::string reading(const std::string& text) {
  try {
    return bits(parse_quantity(text, "m", "mm", "stroke"));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

/// Checks that each of eight threads, which begin with different names, gets the answers that one
/// gets alone.
void check_in_threads(const std::vector<std::string>& names,
                      const std::function<std::string(const std::string&)>& answer) {
  std::vector<std::string> expected;
  for (const std::string& name : names) expected.push_back(answer(name));
  const auto results = in_threads(kThreads, [&](int thread) {
    std::string wrong;
    for (std::size_t i = 0; i < names.size(); ++i) {
      const std::size_t k = (i + static_cast<std::size_t>(thread)) % names.size();
      if (answer(names[k]) != expected[k]) wrong += names[k] + " ";
    }
    return wrong;
  });
  for (const std::string& wrong : results) CHECK(wrong == "");
}

}  // namespace

TEST_CASE("eight threads read and solve problem files as one does", "[threads]") {
  std::vector<std::string> expected;
  for (const char* file : kFiles) expected.push_back(solved(file));
  // Each thread begins with another file, so that different ones are solved side by side.
  const auto results = in_threads(kThreads, [](int thread) {
    std::string all;
    for (std::size_t k = 0; k < kFiles.size(); ++k) {
      all += solved(kFiles[(static_cast<std::size_t>(thread) + k) % kFiles.size()]);
    }
    return all;
  });
  for (std::size_t thread = 0; thread < results.size(); ++thread) {
    std::string all;
    for (std::size_t k = 0; k < kFiles.size(); ++k) all += expected[(thread + k) % kFiles.size()];
    CHECK(results[thread] == all);
  }
}

TEST_CASE("eight threads solve one problem that they share", "[threads]") {
  const problems::BoundProblem bound(
      problems::read_problem_file(path_of("cams/roller_least_base.toml")));
  const std::string expected = bits(optim::optimise(bound.space()));
  const auto results =
      in_threads(kThreads, [&](int) { return bits(optim::optimise(bound.space())); });
  for (const std::string& result : results) CHECK(result == expected);
}

TEST_CASE("units are read, and refused, in eight threads as in one", "[threads][units]") {
  const std::vector<std::string> texts{"40 mm",         "1.2e-3 m", "3 inch", "7 furlongs/(",
                                       "30 deg",        "1 mm/s",   "4,0 mm", "5 m^",
                                       "12 lightyears", "2 qqq",    "9 um",   "1 0.5 m"};
  std::vector<std::string> expected;
  for (const std::string& text : texts) expected.push_back(reading(text));
  const auto results = in_threads(kThreads, [&](int thread) {
    constexpr std::size_t kRounds = 400;
    for (std::size_t i = 0; i < kRounds * texts.size(); ++i) {
      const std::size_t k = (i + static_cast<std::size_t>(thread)) % texts.size();
      if (reading(texts[k]) != expected[k]) return texts[k] + " -> " + reading(texts[k]);
    }
    return std::string();
  });
  for (const std::string& wrong : results) CHECK(wrong == "");
}

TEST_CASE("every back end gives in eight threads what it gives in one", "[threads]") {
  optim::Problem problem = optim::search_tests::two_valleys();
  problem.constraints = {optim::search_tests::at_most("sum", optim::search_tests::sum(), 0.5)};
  const auto answer = [&](const std::string& solver) {
    return bits(optim::optimise(problem, {.solver = solver, .seed = 7, .max_evaluations = 300}));
  };
  const std::vector<std::string> names = optim::solver_names();
  check_in_threads(names, answer);
}

TEST_CASE("eight threads solve linear problems side by side", "[threads]") {
  const std::vector<std::string> files{"free_law/least_acceleration_at_jerk.toml",
                                       "spine_cutter/least_force_legendre.toml",
                                       "spine_cutter/least_force.toml"};
  check_in_threads(files, solved);
}

TEST_CASE("scouts, peaks and fits are the same in eight threads", "[threads]") {
  const auto work = [](int) {
    optim::Task task;
    task.kind = optim::Task::Kind::Scout;
    task.population = 20;
    task.generations = 10;
    std::string text = bits(optim::scout(task, optim::front_tests::two_centres_limited()));
    for (const char* name : {"modified-sine", "cycloidal", "legendre"}) {
      const Law<double> law = find_law(name).law();
      const auto peak = peaks(law);
      const auto proof = peaks(find_law(name).law<Interval>());
      text += bits(peak.max_velocity()) + bits(peak.max_acceleration()) +
              bits(proof.max_acceleration().upper());
    }
    problems::MotionSamples samples;
    const Law<double> law = find_law("modified-sine").law();
    for (int i = 0; i <= 60; ++i) {
      samples.place.push_back(i);
      samples.value.push_back(20 * law(std::clamp((i - 10) / 40.0, 0.0, 1.0)).s);
    }
    const auto guess = problems::guess_motion(samples);
    const auto fit = problems::fit_law(samples, find_law("polynomial-5"), guess);
    return text + bits(fit.begin) + bits(fit.end) + bits(fit.to);
  };
  const std::string expected = work(0);
  for (const std::string& result : in_threads(kThreads, work)) CHECK(result == expected);
}

TEST_CASE("a search that waits for Ipopt heeds its time limit and its user", "[threads]") {
  const optim::Program program({{-1, 1, 0.5, 1}, {-1, 1, 0.4, 1}},
                               optim::front_tests::distance(0.2, 0), 1, 1, {});
  std::atomic<bool> stop = false;
  const auto status = [&](optim::SolverOptions options) {
    optim::Status result = optim::Status::Failed;
    options.stop = &stop;
    std::thread([&] { result = optim::ipopt_solver().solve(program, options).status; }).join();
    return result;
  };
  CHECK(status({}) == optim::Status::Solved);
  const std::lock_guard lock(optim::ipopt_mutex());
  CHECK(status({.time_limit = 0.05}) == optim::Status::TimeLimit);
  stop = true;
  CHECK(status({}) == optim::Status::Stopped);
}

}  // namespace camlaw::read_and_solve_test
