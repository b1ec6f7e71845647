// SPDX-License-Identifier: MIT
#include "problems/published/spine_cutter/study.h"

#include <benchmark/benchmark.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <stdexcept>
#include <string>

#include "benchmarks/timing.h"

/// The spine-cutter study: the computation alone, and the whole program with its files.
namespace camlaw::benchmarks {
namespace {

void run_study() {
  auto study = problems::study_spine_cutter({});
  benchmark::DoNotOptimize(study);
}

/// A folder for results that is gone again afterwards.
class Scratch {
 public:
  Scratch()
      : path_(std::filesystem::temp_directory_path() /
              fmt::format("camlaw-benchmark-{}", ::getpid())) {
    std::filesystem::create_directory(path_);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

/// camlaw study spine-cutter --out DIR as a process of its own, what it prints thrown away.
void run_program(const std::string& out) {
  std::string words[] = {CAMLAW_PROGRAM, "study", "spine-cutter", "--out", out};
  char* arguments[6] = {};
  for (int i = 0; i < 5; ++i) arguments[i] = words[i].data();
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  pid_t child = 0;
  const int failed = posix_spawn(&child, CAMLAW_PROGRAM, &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  int status = 1;
  if (failed == 0) waitpid(child, &status, 0);
  if (failed != 0 || status != 0) throw std::runtime_error(CAMLAW_PROGRAM " does not run");
}

template <class Work>
void print_row(const char* name, Work&& work) {
  std::vector<double> times;
  for (int i = 0; i < 41; ++i) times.push_back(seconds(work));
  fmt::print("| {} | {:.4f} | {:.4f} to {:.4f} |\n", name, median(times), quantile(times, 0.25),
             quantile(times, 0.75));
}

}  // namespace

void print_study_table() {
  const Scratch scratch;
  fmt::print("the spine-cutter study, seconds\n\n| what | median | quartiles |\n|---|--:|--:|\n");
  print_row("study_spine_cutter", run_study);
  print_row("camlaw study spine-cutter --out DIR", [&] { run_program(scratch.path()); });
  fmt::print("\n");
}

void register_study() {
  benchmark::RegisterBenchmark("study/computation", [](benchmark::State& state) {
    for ([[maybe_unused]] const auto pass : state) run_study();
  })->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("study/program",
                               [](benchmark::State& state) {
                                 const Scratch scratch;
                                 for ([[maybe_unused]] const auto pass : state)
                                   run_program(scratch.path());
                               })
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime();
}

}  // namespace camlaw::benchmarks
