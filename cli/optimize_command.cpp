// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdio>
#include <memory>
#include <optional>

#include "cli/commands.h"
#include "cli/cycle_figure.h"
#include "cli/files.h"
#include "cli/interrupt.h"
#include "cli/law_figure.h"
#include "cli/optimum_output.h"
#include "cli/progress_line.h"
#include "problems/statement/solver_settings.h"

namespace camlaw::cli {
namespace {

struct OptimizeOptions {
  std::string file;
  std::optional<std::string> solver, out, starts, seed, time_limit;
  bool json = false;
};

/// What the command line says of solving.
problems::SolverStatement stated_options(const OptimizeOptions& options) {
  problems::SolverStatement result;
  if (options.solver) result.name = problems::find_solver_name(*options.solver);
  if (options.starts) {
    result.starts = static_cast<int>(
        problems::parse_whole(*options.starts, 1, problems::kMostStarts, "--starts"));
  }
  if (options.seed) {
    result.seed = static_cast<std::uint64_t>(
        problems::parse_whole(*options.seed, 0, problems::kMostSeed, "--seed"));
  }
  if (options.time_limit) {
    result.time_limit = problems::parse_time_limit(*options.time_limit, "--time-limit");
  }
  return result;
}

/// What the command line says, else what the file says.
optim::OptimiseOptions search_options(const problems::SolverStatement& line,
                                      const problems::SolverStatement& file) {
  optim::OptimiseOptions result;
  result.solver = line.name.value_or(file.name.value_or("auto"));
  result.starts = line.starts ? line.starts : file.starts;
  result.seed = line.seed.value_or(file.seed.value_or(result.seed));
  result.time_limit = line.time_limit ? line.time_limit : file.time_limit;
  return result;
}

std::string progress_text(const optim::Progress& progress) {
  return fmt::format("iteration {:6}   objective {:14.8g}   violation {:9.2e}", progress.iteration,
                     progress.objective, progress.violation);
}

int exit_status(optim::Verdict verdict) {
  switch (verdict) {
    case optim::Verdict::Certified:
    case optim::Verdict::Feasible:
      return kDone;
    case optim::Verdict::Infeasible:
      return kInfeasible;
    case optim::Verdict::Failed:
      break;
  }
  return kNotSolved;
}

constexpr const char* kFileNames[] = {"result.json", "law.csv", "law.svg", "cycle.svg"};

/// All files that --out may make.
std::vector<std::filesystem::path> possible_files(const std::filesystem::path& out) {
  std::vector<std::filesystem::path> paths;
  for (const char* name : kFileNames) paths.push_back(out / name);
  return paths;
}

/// Those of an earlier run that this one does not write: they must not stay beside its own.
std::vector<std::filesystem::path> remove_stale(const std::filesystem::path& out,
                                                const std::vector<OutputFile>& written) {
  std::vector<std::filesystem::path> stale = possible_files(out);
  for (const OutputFile& file : written) std::erase(stale, file.path);
  return remove_files(stale);
}

std::vector<OutputFile> result_files(const Answer& answer, const std::string& json,
                                     const std::filesystem::path& out) {
  constexpr int kSamples = 361;
  std::vector<OutputFile> files{{out / "result.json", json}};
  if (const std::optional<Member> law = answer.law()) {
    const Law<double> shape = law->law();
    files.push_back({out / "law.csv", motion_csv(shape, kSamples)});
    files.push_back(
        {out / "law.svg", to_svg(motion_figure(law->label(), {{.name = "", .law = shape}}))});
  }
  const Figure cycle = cycle_figure(answer);
  if (!cycle.panels.empty()) files.push_back({out / "cycle.svg", to_svg(cycle)});
  return files;
}

/// Writes the files of --out, and says so unless only JSON is wanted.
void write_out(const std::filesystem::path& out, const std::vector<OutputFile>& files, bool says) {
  std::fflush(stdout);
  write_files(files);
  const auto removed = remove_stale(out, files);
  if (!says) return;
  for (const OutputFile& file : files) fmt::print("wrote {}\n", file.path.string());
  for (const auto& path : removed) fmt::print("removed {}, of an earlier run\n", path.string());
}

void run_optimize(const OptimizeOptions& options, int& status) {
  if (options.out && options.out->empty()) {
    throw std::invalid_argument("--out: a folder's name is wanted");
  }
  const problems::SolverStatement stated = stated_options(options);
  const problems::BoundProblem bound(problems::read_problem_file(options.file));
  const optim::ProblemSpace space = bound.space();
  auto search = search_options(stated, bound.statement().solver);
  if (options.out) check_writable(possible_files(*options.out));
  optim::Optimum optimum;
  {
    const Interruptible interruptible;
    ProgressLine line(!options.json);
    search.stop = interruptible.flag();
    search.progress = [&line](const optim::Progress& p) { line.show(progress_text(p)); };
    optimum = optim::optimise(space, search);
  }
  const Answer answer{bound, space, optimum, search.solver, search.seed};
  const std::string json = answer_json(answer).dump(2) + "\n";
  // Printed first: the search is not lost where a file cannot be written after all.
  fmt::print("{}", options.json ? json : answer_text(answer));
  if (options.out) {
    write_out(*options.out, result_files(answer, json, *options.out), !options.json);
  }
  status = exit_status(optimum.found.assessment.verdict);
}

}  // namespace

void add_optimize_command(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("optimize", "Find the best design of a problem file");
  const auto options = std::make_shared<OptimizeOptions>();
  command->add_option("FILE", options->file, "the problem file (TOML)")->required();
  command->add_option("--solver", options->solver,
                      fmt::format("auto, {}", fmt::join(optim::solver_names(), ", ")));
  command->add_option("--starts", options->starts,
                      fmt::format("how many places to search from, 1 to {}; by default 1 where "
                                  "the problem is convex or the solver global, else 8",
                                  problems::kMostStarts));
  command->add_option("--seed", options->seed,
                      "for starts and for methods that draw numbers; a whole number from 0");
  command->add_option("--time-limit", options->time_limit, "such as 30, \"30 s\" or \"1 min\"");
  add_switch(*command, "--json", options->json, "print JSON");
  command->add_option("--out", options->out,
                      "folder for result.json, law.csv, law.svg and cycle.svg");
  command->callback([options, &status] { run_optimize(*options, status); });
}

}  // namespace camlaw::cli
