// SPDX-License-Identifier: MIT
#include "optim/study/workers.h"

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <stdexcept>

#include "optim/study/efforts.h"
#include "optim/study/recorded_executor.h"
#include "tests/optim/pareto/outcomes.h"
#include "tests/optim/pareto/small_fronts.h"
#include "tests/temporary_folder.h"

namespace camlaw::optim::workers_test {

using namespace study_tests;
using namespace front_tests;

namespace {

/// Ends this process as a fault does: with the usual action, not the test runner's.
void fall(int signal) {
  std::signal(signal, SIG_DFL);
  raise(signal);
}

/// Two centres, where something happens at designs with x = 0.9.
ProblemSpace dangerous(void (*happening)()) {
  Problem problem = two_centres();
  problem.objectives[0].response.measure =
      observed(distance(0, 0), [happening](std::span<const double> u) {
        if (u[0] == 0.9) happening();
      });
  return ProblemSpace::of(std::move(problem));
}

/// Searches for the least f2 with f1 at most so much: x goes up to the square root of it.
std::vector<Task> bounded_tasks(const std::vector<double>& bounds) {
  std::vector<Task> tasks;
  for (const double bound : bounds) {
    Task task;
    task.sought = 1;
    task.bounds = {bound, kInfinity};
    tasks.push_back(task);
  }
  return tasks;
}

std::size_t open_files() {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) {
    count += entry.exists();
  }
  return count;
}

}  // namespace

TEST_CASE("workers give what this process gives, to the last bit", "[study]") {
  for (const ProblemSpace& space :
       {ProblemSpace::of(two_centres_limited()), two_rooms(), ProblemSpace::of(three_centres())}) {
    ParetoOptions options;
    options.points = 12;
    const std::string expected = bits(pareto(space, options));
    for (const int workers : {1, 2, 5}) {
      INFO(workers);
      ProcessExecutor executor(space, options.solve, workers);
      CHECK(bits(pareto(space, options, executor)) == expected);
    }
  }
}

TEST_CASE("workers give each outcome, in the order of the tasks", "[study]") {
  const ProblemSpace space = ProblemSpace::of(two_centres());
  const auto tasks = bounded_tasks({0.5, 0.04, 0.3, 0.01, 0.16, 0.2, 0.09});
  const OptimiseOptions options;
  DirectExecutor direct(space, options);
  const std::string expected = bits(direct.run(tasks, {}));
  for (const int workers : {1, 3, 20}) {
    ProcessExecutor executor(space, options, workers);
    std::multiset<std::string> told, given;
    const auto outcomes = executor.run(tasks, [&](const Task& task, const Outcome& outcome) {
      told.insert(task.text() + bits(outcome));
    });
    CHECK(bits(outcomes) == expected);
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      given.insert(tasks[i].text() + bits(*outcomes.at(i)));
    }
    CHECK(told == given);
  }
  ProcessExecutor executor(space, options, 2);
  CHECK(executor.run({}, {}).empty());
}

TEST_CASE("searches that are expected to take long are handed out first", "[study]") {
  Efforts efforts;
  const auto of = [](Task::Kind kind, std::size_t part) {
    Task task;
    task.kind = kind;
    task.part = part;
    return task;
  };
  const auto took = [](long evaluations) {
    Outcome outcome;
    outcome.evaluations = evaluations;
    return outcome;
  };
  using Kind = Task::Kind;
  const std::vector<Task> tasks{of(Kind::Bounded, 0), of(Kind::Toward, 0), of(Kind::Bounded, 1),
                                of(Kind::Bounded, 0), of(Kind::Bounded, 2)};
  using Places = std::vector<std::size_t>;
  CHECK(efforts.longest_first(tasks) == Places{0, 1, 2, 3, 4});
  efforts.learn(tasks[0], took(100));
  efforts.learn(tasks[0], took(0));
  efforts.learn(tasks[1], took(20));
  efforts.learn(tasks[2], took(60));
  CHECK(efforts.longest_first(tasks) == Places{4, 2, 0, 3, 1});
  CHECK(efforts.longest_first({}).empty());
}

TEST_CASE("no workers at all are refused", "[study]") {
  const ProblemSpace space = ProblemSpace::of(two_centres());
  const OptimiseOptions options;
  CHECK_THROWS_AS(ProcessExecutor(space, options, 0), std::invalid_argument);
  CHECK_THROWS_AS(ProcessExecutor(space, options, -3), std::invalid_argument);
}

TEST_CASE("a process that dies takes its own task with it only", "[study]") {
  struct Case {
    void (*happening)();
    std::string said;
  };
  const std::vector<Case> cases{
      {[] { fall(SIGABRT); }, "killed by signal 6"},
      {[] { fall(SIGSEGV); }, "killed by signal 11"},
      {[] { fall(SIGKILL); }, "killed by signal 9"},
      {[] { _exit(3); }, "ended by itself with status 3"},
      {[] { _exit(0); }, "ended by itself with status 0"},
      {[] { throw std::runtime_error("no such cam"); }, "no such cam"},
  };
  for (const Case& c : cases) {
    INFO(c.said);
    const ProblemSpace space = dangerous(c.happening);
    const OptimiseOptions options;
    ProcessExecutor executor(space, options, 2);
    auto tasks = bounded_tasks({0.25, 0.81, 0.16});
    for (Task& task : tasks) task.starts = {{0.1, 0}};
    tasks[1].starts = {{0.9, 0}};
    const auto outcomes = executor.run(tasks, {});
    REQUIRE(outcomes.size() == 3);
    CHECK_THAT(outcomes[1]->failure, Catch::Contains(c.said));
    CHECK(outcomes[1]->points.empty());
    for (const std::size_t i : {0, 2}) {
      INFO(outcomes[i]->failure);
      REQUIRE(outcomes[i]->points.size() == 1);
      CHECK(outcomes[i]->points[0].costs[0] == Approx(tasks[i].bounds[0]));
    }
  }
}

TEST_CASE("a study goes on where processes die", "[study]") {
  Problem problem = two_centres();
  problem.objectives[0].response.measure = observed(distance(0, 0), [](std::span<const double> u) {
    if (u[0] > 0.72 && u[0] < 0.77 && std::abs(u[1]) < 1e-3) fall(SIGSEGV);
  });
  const ProblemSpace space = ProblemSpace::of(std::move(problem));
  ParetoOptions options;
  options.points = 8;
  options.method = ParetoMethod::Sweep;
  ProcessExecutor executor(space, options.solve, 2);
  const Front front = pareto(space, options, executor);
  CHECK(front.complete);
  CHECK_FALSE(front.failures.empty());
  for (const FailedTask& failed : front.failures) {
    CHECK_THAT(failed.why, Catch::Contains("signal 11"));
  }
  CHECK(front.points.size() >= 4);
}

TEST_CASE("what a killed process left out is searched for when the study goes on", "[study]") {
  // The first to look at a design near the end is killed, as by someone else; the next is not.
  const testing::Folder folder;
  const std::string mark = folder / "killed";
  Problem problem = two_centres();
  problem.objectives[0].response.measure =
      observed(distance(0, 0), [mark](std::span<const double> u) {
        if (u[0] < 0.72 || u[0] > 0.77 || std::filesystem::exists(mark)) return;
        std::ofstream(mark) << "once";
        fall(SIGKILL);
      });
  const ProblemSpace space = ProblemSpace::of(std::move(problem));
  ParetoOptions options;
  options.points = 8;
  options.method = ParetoMethod::Sweep;
  ProcessExecutor workers(space, options.solve, 1);
  const auto run = [&](StudyRecord& record, Executor* others) {
    RecordedExecutor recorded(space, record, others);
    return pareto(space, options, recorded);
  };
  {
    StudyRecord record = StudyRecord::create(folder / "s.db", {});
    CHECK(run(record, &workers).failures.size() == 1);
    CHECK(run(record, nullptr).failures.size() == 1);  // looked at, not gone on with
  }
  StudyRecord record = StudyRecord::open(folder / "s.db");
  const Front resumed = run(record, &workers);
  CHECK(resumed.failures.empty());
  CHECK(bits(resumed) == bits(pareto(space, options, workers)));
  CHECK(bits(run(record, nullptr)) == bits(resumed));
}

TEST_CASE("nothing is left open after a run", "[study]") {
  const ProblemSpace space = dangerous([] { _exit(3); });
  const OptimiseOptions options;
  const auto tasks = bounded_tasks({0.25, 0.81, 0.16, 0.9});
  const std::size_t before = open_files();
  ProcessExecutor executor(space, options, 3);
  executor.run(tasks, {});
  CHECK(open_files() == before);
  // Nor after one that is given up because an outcome could not be taken.
  for (int round = 0; round < 5; ++round) {
    CHECK_THROWS_WITH(
        executor.run(tasks, [](const Task&,
                               const Outcome&) { throw std::runtime_error("the disk is full"); }),
        "the disk is full");
    CHECK(open_files() == before);
  }
}

TEST_CASE("a run that is given up closes no file of others", "[study]") {
  const ProblemSpace space = ProblemSpace::of(two_centres());
  const OptimiseOptions options;
  ProcessExecutor executor(space, options, 1);
  int opened = -1;
  CHECK_THROWS(executor.run(bounded_tasks({0.25}), [&](const Task&, const Outcome&) {
    opened = dup(STDIN_FILENO);  // takes the number that the worker's pipe had
    throw std::runtime_error("given up");
  }));
  REQUIRE(opened >= 0);
  CHECK(close(opened) == 0);
}

TEST_CASE("a study that is to stop starts nothing, or gives what is done", "[study]") {
  const ProblemSpace space = ProblemSpace::of(two_centres());
  std::atomic<bool> stop = true;
  OptimiseOptions options;
  options.stop = &stop;
  const auto tasks = bounded_tasks({0.25, 0.81, 0.16, 0.5, 0.4});
  ProcessExecutor executor(space, options, 2);
  DirectExecutor direct(space, options);
  CHECK(bits(executor.run(tasks, {})) == bits(Outcomes(tasks.size())));
  CHECK(bits(direct.run(tasks, {})) == bits(Outcomes(tasks.size())));
  stop = false;
  const Outcomes all = direct.run(tasks, {});
  std::size_t told = 0;
  const auto outcomes = executor.run(tasks, [&](const Task&, const Outcome&) {
    if (++told == 2) stop = true;
  });
  CHECK(told <= 4);
  REQUIRE(outcomes.size() == tasks.size());
  std::size_t done = 0;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    if (!outcomes[i]) continue;
    ++done;
    CHECK(bits(*outcomes[i]) == bits(*all[i]));
  }
  CHECK(done <= told);
  CHECK(done >= 2);
}

}  // namespace camlaw::optim::workers_test
