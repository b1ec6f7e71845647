// SPDX-License-Identifier: MIT
#include <dlfcn.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>
#include <tuple>

#include "numerics/library_mutex.h"
#include "numerics/text/units.h"
#include "optim/crew/child_process.h"
#include "optim/solvers/exit_guard.h"
#include "optim/solvers/solver.h"
#include "optim/study/recorded_executor.h"
#include "optim/study/workers.h"
#include "problems/fronts/study_worker.h"
#include "tests/optim/pareto/outcomes.h"
#include "tests/optim/pareto/small_fronts.h"
#include "tests/paths.h"
#include "tests/temporary_folder.h"
#include "tests/threads/many_threads.h"

/// Fronts from a program that has threads of its own.
namespace camlaw::busy_process_test {
namespace {

using optim::study_tests::bits;

/// The tests are not beside the program.
const int kWorkerIsNamed = setenv(problems::kWorkerVariable, CAMLAW_WORKER_PROGRAM, 0);

/// Ends this process where a test hangs.
class Watchdog {
 public:
  Watchdog() { alarm(kSeconds); }
  ~Watchdog() { alarm(0); }

 private:
  static constexpr unsigned kSeconds = 300;
};

/// Three threads beside the test's own, one of which does what it is given until the test is over.
class Company {
 public:
  explicit Company(const std::function<void(const std::atomic<bool>& over)>& busy) {
    threads_.emplace_back([this, busy] { busy(over_); });
    for (int i = 0; i < 2; ++i) threads_.emplace_back([this] { wait(); });
  }
  ~Company() {
    over_ = true;
    for (std::thread& thread : threads_) thread.join();
  }
  void wait() const {
    while (!over_) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }

 private:
  std::atomic<bool> over_ = false;
  std::vector<std::thread> threads_;
};

/// A solver that a program registers.
class OwnSlsqp final : public optim::Solver {
 public:
  std::string name() const override { return "own-slsqp"; }
  bool is_global() const override { return false; }
  std::optional<std::string> refusal(const optim::Program& program) const override {
    return optim::find_solver("slsqp").refusal(program);
  }

 private:
  optim::Solution search(const optim::Program& program, const optim::SolverOptions& options,
                         const optim::WarmStart* warm) const override {
    return optim::find_solver("slsqp").solve(program, options, warm);
  }
};

void allocate(const std::atomic<bool>& over) {
  while (!over) {
    std::vector<std::unique_ptr<char[]>> blocks;
    for (std::size_t size = 16; size < (1U << 20U); size *= 2) {
      blocks.push_back(std::make_unique<char[]>(size));
    }
  }
}

/// Holds a library's lock from `held` on.
void hold(optim::LibraryMutex& mutex, std::atomic<bool>& held, const std::atomic<bool>& over) {
  const std::lock_guard lock(mutex);
  held = true;
  while (!over) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

/// Is in the middle of a search by Ipopt from `held` on.
void solve(std::atomic<bool>& held, const std::atomic<bool>& over) {
  const optim::Problem problem = optim::front_tests::two_centres_limited().alone(0);
  optim::OptimiseOptions options{.solver = "ipopt", .starts = 1};
  options.progress = [&](const optim::Progress&) {
    held = true;
    while (!over) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  };
  optim::optimise(problem, options);
}

problems::FrontStudy study_of(const std::string& file) {
  const std::string path = testing::source("problems/") + file;
  return {problems::problem_text(path), path, {8, optim::ParetoMethod::Sweep}};
}

optim::ProcessExecutor workers_of(const problems::FrontStudy& study) {
  return {study.space(), study.options().solve, 2, problems::worker_program(study)};
}

/// Another worker program than the one beside this.
class OtherWorker {
 public:
  explicit OtherWorker(const char* path) : before_(std::getenv(problems::kWorkerVariable)) {
    setenv(problems::kWorkerVariable, path, 1);
  }
  ~OtherWorker() { setenv(problems::kWorkerVariable, before_.c_str(), 1); }

 private:
  std::string before_;
};

/// Processes that this thread has begun and that are not gone.
std::vector<pid_t> children() {
  std::ifstream file("/proc/self/task/" + std::to_string(gettid()) + "/children");
  std::vector<pid_t> result;
  for (pid_t child = 0; file >> child;) result.push_back(child);
  return result;
}

}  // namespace

TEST_CASE("pareto works beside threads that hold the locks of malloc, units and Ipopt",
          "[threads][study]") {
  const Watchdog watchdog;
  problems::FrontStudy study = study_of("spine_cutter/front.toml");
  study.options().solve.solver = "ipopt";  // so that every search needs its lock
  const std::string expected = bits(optim::pareto(study.space(), study.options()));
  const auto run = [&] {
    CHECK_FALSE(optim::has_one_thread());
    optim::ProcessExecutor workers = workers_of(study);
    const optim::Front front = study.run(workers);
    CHECK(front.remark == "");
    CHECK(front.failures.empty());
    CHECK(front.points.front().solver == "ipopt");
    CHECK(bits(front) == expected);
  };
  std::atomic<bool> held = false;
  const auto while_held = [&] {
    while (!held) std::this_thread::yield();
    run();
    held = false;
  };
  SECTION("malloc") {
    const Company company(allocate);
    run();
  }
  SECTION("units") {
    const Company company([&](const auto& over) { hold(unit_mutex(), held, over); });
    while_held();
  }
  SECTION("Ipopt's lock") {
    const Company company([&](const auto& over) { hold(optim::ipopt_mutex(), held, over); });
    while_held();
  }
  SECTION("Ipopt in a search") {
    const Company company([&](const auto& over) { solve(held, over); });
    while_held();
  }
}

TEST_CASE("several studies at once, each from a thread of its own", "[threads][study]") {
  const Watchdog watchdog;
  const testing::Folder folder;
  const std::vector<std::string> files{"spine_cutter/front.toml", "die_press/front.toml"};
  std::vector<std::string> expected;
  for (const auto& file : files) {
    const problems::FrontStudy study = study_of(file);
    expected.push_back(bits(optim::pareto(study.space(), study.options())));
  }
  const auto results = testing::in_threads(3, [&](int thread) {
    const problems::FrontStudy study = study_of(files[static_cast<std::size_t>(thread) % 2]);
    optim::ProcessExecutor workers = workers_of(study);
    auto record = optim::StudyRecord::create(folder / std::to_string(thread), study.settings());
    optim::RecordedExecutor recorded(study.space(), record, &workers);
    return bits(study.run(recorded));
  });
  for (std::size_t i = 0; i < results.size(); ++i) CHECK(results[i] == expected[i % 2]);
}

TEST_CASE("studies that are joined by a choice are sent as such", "[threads][study]") {
  const Watchdog watchdog;
  const std::string path = testing::source("problems/spine_cutter/front.toml");
  std::string text = problems::problem_text(path);
  const problems::FrontSettings settings{6, optim::ParetoMethod::Sweep};
  std::vector<problems::FrontStudy> studies{{text, path, settings}};
  const std::string law = "name = \"polynomial-5\"\n\n[variables.alpha]";
  text.replace(text.find(law), law.size(), "name = \"polynomial-7\"\n\n[variables.A]");
  studies.emplace_back(text, path, settings);
  const problems::JoinedStudies joined{"law", {"five", "seven"}, studies};
  const optim::ProblemSpace space = joined.space();
  const auto& options = studies.front().options();
  const std::string expected = bits(optim::pareto(space, options));
  const Company company(allocate);
  optim::ProcessExecutor workers(space, options.solve, 2, problems::worker_program(joined));
  const optim::Front front = optim::pareto(space, options, workers);
  CHECK(front.remark == "");
  CHECK(bits(front) == expected);
}

TEST_CASE("a problem of one's own functions is searched in the calling process",
          "[threads][study]") {
  using namespace optim;
  const ProblemSpace space = ProblemSpace::of(front_tests::two_centres_limited());
  ParetoOptions options;
  options.points = 8;
  const std::string expected = bits(pareto(space, options));
  const Company company(allocate);
  ProcessExecutor executor(space, options.solve, 2);
  const Front front = pareto(space, options, executor);
  CHECK(bits(front) == expected);
  CHECK_THAT(front.remark,
             Catch::Contains("in the calling process") && Catch::Contains("is not sent as data"));
  std::atomic<bool> stop = true;
  options.solve.stop = &stop;
  CHECK_FALSE(executor.run({Task{}}, {}).at(0));
}

TEST_CASE("without a worker program that works the front is found here", "[threads][study]") {
  const Watchdog watchdog;
  const problems::FrontStudy study = study_of("spine_cutter/front.toml");
  const std::string expected = bits(optim::pareto(study.space(), study.options()));
  const Company company(allocate);
  for (const auto& [path, said] : {std::pair{"/no/such/program", "No such file"},
                                   {"/bin/false", "status 1"},
                                   {"/bin/true", "status 0"}}) {
    INFO(path);
    const OtherWorker other(path);
    optim::ProcessExecutor workers = workers_of(study);
    const optim::Front front = study.run(workers);
    CHECK(bits(front) == expected);
    CHECK_THAT(front.remark, Catch::Contains(said) && Catch::Contains("in the calling process"));
  }
}

TEST_CASE("tasks of workers that do not begin are done here in their order", "[threads][study]") {
  const Watchdog watchdog;
  const problems::FrontStudy study = study_of("spine_cutter/front.toml");
  std::vector<optim::Task> tasks(5);
  for (optim::Task& task : tasks) {
    task.starts = {{static_cast<double>(&task - tasks.data())}};
    task.bounds.assign(2, optim::kInfinity);
  }
  const Company company(allocate);
  optim::WorkerProgram program = problems::worker_program(study);
  program.path = "/bin/true";
  optim::ProcessExecutor workers(study.space(), study.options().solve, 3, program);
  std::vector<double> order;
  const auto outcomes = workers.run(
      tasks, [&](const optim::Task& task, const auto&) { order.push_back(task.starts[0][0]); });
  CHECK(outcomes.size() == tasks.size());
  CHECK(order == std::vector<double>{0, 1, 2, 3, 4});
  CHECK_THAT(workers.remark(), Catch::Contains("in the calling process"));
}

TEST_CASE("a program that is not a worker is not waited for", "[threads][study]") {
  const Watchdog watchdog;
  const testing::Folder folder;
  const problems::FrontStudy study = study_of("spine_cutter/front.toml");
  const std::string expected = bits(optim::pareto(study.space(), study.options()));
  const Company company(allocate);
  const auto program = [&](const std::string& line) {
    const std::string path = folder / "program";
    testing::write(path, "#!/bin/sh\n" + line + "\n");
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
    return path;
  };
  // What says something at once is waited for longer than a busy machine takes to begin it.
  constexpr std::chrono::milliseconds kShort{200}, kLong{20000};
  for (const auto& [line, patience, said] :
       {std::tuple{"exec sleep 1000", kShort, "did not identify itself as one within 0.2 s"},
        {"exec 0<&-; exec sleep 1000", kLong, "killed by signal 9"},
        {"printf 'Enter your name, please:' >&0; exec sleep 1000", kLong,
         "is not that of a worker"},
        {"printf 'no' >&0; exec sleep 1000", kShort,
         "did not identify itself as one within 0.2 s"}}) {
    INFO(line);
    optim::WorkerProgram worker = problems::worker_program(study);
    worker.path = program(line);
    worker.problem += std::string(std::size_t{1} << 22U, ' ');  // more than a socket holds
    worker.patience = patience;
    const auto began = std::chrono::steady_clock::now();
    optim::ProcessExecutor workers(study.space(), study.options().solve, 2, worker);
    const optim::Front front = study.run(workers);
    CHECK(std::chrono::steady_clock::now() - began < std::chrono::seconds(60));
    CHECK(bits(front) == expected);
    CHECK_THAT(front.remark, Catch::Contains(said) && Catch::Contains("in the calling process"));
    CHECK(children().empty());
  }
}

TEST_CASE("a solver that no other process knows searches in this one",
          "[threads][study][solvers]") {
  const Watchdog watchdog;
  optim::register_solver(std::make_unique<OwnSlsqp>());
  problems::FrontStudy study = study_of("spine_cutter/front.toml");
  study.options().solve.solver = "own-slsqp";
  const std::string expected = bits(optim::pareto(study.space(), study.options()));
  const Company company(allocate);
  optim::ProcessExecutor workers = workers_of(study);
  const optim::Front front = study.run(workers);
  CHECK(bits(front) == expected);
  CHECK_THAT(front.remark, Catch::Contains("other processes do not know the solver own-slsqp"));
}

TEST_CASE("a study that is stopped does not wait for workers that say nothing",
          "[threads][study]") {
  const Watchdog watchdog;
  const problems::FrontStudy study = study_of("spine_cutter/front.toml");
  const Company company(allocate);
  optim::OptimiseOptions options = study.options().solve;
  std::atomic<bool> stop = false;
  options.stop = &stop;
  optim::WorkerProgram silent = problems::worker_program(study);
  silent.path = "/usr/bin/cat";  // which says nothing before it is spoken to
  silent.patience = std::chrono::hours(1);
  optim::ProcessExecutor workers(study.space(), options, 2, silent);
  std::thread stopper([&stop] {
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    stop = true;
  });
  const auto began = std::chrono::steady_clock::now();
  for (const auto& outcome : workers.run({optim::Task{}, optim::Task{}}, {})) CHECK_FALSE(outcome);
  CHECK(std::chrono::steady_clock::now() - began < std::chrono::seconds(60));
  stopper.join();
  CHECK(children().empty());
}

TEST_CASE("a worker program refuses what is not a study of its own version", "[threads][study]") {
  using problems::service_of_worker;
  CHECK_THROWS_WITH(service_of_worker("nonsense"), "what was sent is not a study");
  const problems::FrontStudy study = study_of("spine_cutter/front.toml");
  std::string problem = problems::worker_program(study).problem;
  CHECK(service_of_worker(problem));
  const std::string version = "camlaw 0.";
  problem.replace(problem.find(version), version.size(), "camlaw 9.");
  CHECK_THROWS_WITH(service_of_worker(problem), Catch::Contains("the worker program is of camlaw"));
}

TEST_CASE("a worker that is killed takes its own task with it only", "[threads][study]") {
  const Watchdog watchdog;
  const problems::FrontStudy study = study_of("spine_cutter/front.toml");
  const std::vector<std::vector<double>> starts{{-3}, {-2}, {-1}, {0}, {1}, {2}};
  std::vector<optim::Task> tasks;
  for (const auto& start : starts) {
    tasks.emplace_back().starts = {start};
    tasks.back().bounds.assign(2, optim::kInfinity);
  }
  optim::DirectExecutor direct(study.space(), study.options().solve);
  const auto expected = direct.run(tasks, {});
  const Company company(allocate);
  optim::ProcessExecutor workers = workers_of(study);
  const std::vector<optim::Task> first(tasks.begin(), tasks.begin() + 2);
  REQUIRE(workers.run(first, {}).size() == 2);  // now both workers are ready
  bool killed = false;
  const auto outcomes = workers.run(tasks, [&](const auto&, const auto&) {
    if (std::exchange(killed, true)) return;
    for (const pid_t child : children()) kill(child, SIGKILL);
  });
  CHECK(workers.remark() == "");
  REQUIRE(outcomes.size() == expected.size());
  std::size_t died = 0;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    died += outcomes[i]->died;
    if (outcomes[i]->died) {
      CHECK_THAT(outcomes[i]->failure, Catch::Contains("killed by signal 9"));
    } else {
      CHECK(bits(outcomes[i]) == bits(expected[i]));
    }
  }
  CHECK(died <= 2);
}

TEST_CASE("workers that were started go with their executor", "[threads][study]") {
  const Watchdog watchdog;
  const problems::FrontStudy study = study_of("spine_cutter/front.toml");
  const Company company(allocate);
  {
    optim::ProcessExecutor workers = workers_of(study);
    optim::Task task;
    task.bounds.assign(2, optim::kInfinity);
    CHECK(workers.run({task, task}, {}).size() == 2);
    CHECK(children().size() == 2);
    CHECK(workers.run({task}, {}).size() == 1);
    CHECK(children().size() == 2);
  }
  CHECK(children().empty());
}

TEST_CASE("a solver that ends the program does not end it as if all were well", "[threads]") {
  const auto status_of = [](void (*ending)()) {
    const pid_t child = fork();
    if (child == 0) {
      close(STDERR_FILENO), close(STDOUT_FILENO);
      ending();
      _exit(99);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  };
  // What MUMPS calls, from the library that it comes with.
  const auto abort_as_mumps_does = [] {
    int communicator = 0, code = 0, error = 0;
    auto* abort = reinterpret_cast<void (*)(int*, int*, int*)>(dlsym(RTLD_DEFAULT, "mpi_abort_"));
    if (abort != nullptr) abort(&communicator, &code, &error);
  };
  static auto* const ending = +abort_as_mumps_does;
  CHECK(status_of([] { ending(); }) == 0);
  CHECK(status_of([] {
          const optim::ExitGuard guard("the linear solver of Ipopt");
          ending();
        }) == EXIT_FAILURE);
  // The model's own end, and one that tells of a failure, are left as they are.
  CHECK(status_of([] {
          const optim::ExitGuard guard("the linear solver of Ipopt"), model(nullptr);
          std::exit(0);
        }) == 0);
  CHECK(status_of([] {
          const optim::ExitGuard guard("the linear solver of Ipopt");
          std::exit(7);
        }) == 7);
}

}  // namespace camlaw::busy_process_test
