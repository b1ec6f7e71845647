// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <memory>
#include <optional>

#include "cli/commands.h"
#include "cli/files.h"
#include "cli/interrupt.h"
#include "cli/law_figure.h"
#include "cli/optimum_output.h"

namespace camlaw::cli {
namespace {

struct OptimizeOptions {
  std::string file;
  std::optional<std::string> solver, out;
  std::optional<int> starts;
  std::optional<std::uint64_t> seed;
  std::optional<double> time_limit;
  bool json = false;
};

/// What the command line says, else what the file says.
optim::OptimiseOptions search_options(const OptimizeOptions& options,
                                      const problems::SolverStatement& file) {
  optim::OptimiseOptions result;
  result.solver = options.solver.value_or(file.name.value_or("auto"));
  result.starts = options.starts ? options.starts : file.starts;
  result.seed = options.seed.value_or(file.seed.value_or(result.seed));
  result.time_limit = options.time_limit ? options.time_limit : file.time_limit;
  return result;
}

/// One line that is written over while the search runs; on a terminal only.
class ProgressLine {
 public:
  explicit ProgressLine(bool shown) : shown_(shown && isatty(STDERR_FILENO) != 0) {}
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine() {
    if (printed_) fmt::print(stderr, "\r{:78}\r", "");
  }
  void operator()(const optim::Progress& progress) {
    if (!shown_) return;
    printed_ = true;
    fmt::print(stderr, "\riteration {:6}   objective {:14.8g}   violation {:9.2e}",
               progress.iteration, progress.objective, progress.violation);
    std::fflush(stderr);
  }

 private:
  bool shown_, printed_ = false;
};

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

std::vector<OutputFile> result_files(const Answer& answer, const std::optional<Member>& law,
                                     const std::filesystem::path& out) {
  constexpr int kSamples = 361;
  std::vector<OutputFile> files{{out / "result.json", answer_json(answer).dump(2) + "\n"}};
  if (!law) return files;
  const Law<double> shape = law->law();
  files.push_back({out / "law.csv", motion_csv(shape, kSamples)});
  files.push_back(
      {out / "law.svg", to_svg(motion_figure(law->label(), {{.name = "", .law = shape}}))});
  const Figure cycle = cycle_figure(answer);
  if (!cycle.panels.empty()) files.push_back({out / "cycle.svg", to_svg(cycle)});
  return files;
}

void run_optimize(const OptimizeOptions& options, int& status) {
  if (options.out && options.out->empty()) {
    throw std::invalid_argument("--out: a folder's name is wanted");
  }
  const problems::BoundProblem bound(problems::read_problem_file(options.file));
  const optim::ProblemSpace space = bound.space();
  auto search = search_options(options, bound.statement().solver);
  optim::Optimum optimum;
  {
    const Interruptible interruptible;
    ProgressLine line(!options.json);
    search.stop = interruptible.flag();
    search.progress = [&line](const optim::Progress& progress) { line(progress); };
    optimum = optim::optimise(space, search);
  }
  const Answer answer{bound, space, optimum};
  Json json = answer_json(answer);
  json["seed"] = search.seed;
  std::optional<Member> law;  // none where the model gave no design
  if (optimum.found.x.size() == optimum.problem.variables.size()) {
    law = bound.at(optimum.options, optimum.found.x).laws.front();
  }
  json["law"] = law ? Json(law->name()) : Json(nullptr);
  std::vector<OutputFile> files;
  if (options.out) files = result_files(answer, law, *options.out);
  if (!files.empty()) files.front().content = json.dump(2) + "\n";
  write_files(files);
  fmt::print("{}", options.json ? json.dump(2) + "\n" : answer_text(answer));
  for (const OutputFile& file : files) {
    if (!options.json) fmt::print("wrote {}\n", file.path.string());
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
  command->add_option("--starts", options->starts, "how many places to search from")
      ->check(CLI::Range(1, 100000));
  command->add_option("--seed", options->seed, "for starts and for methods that draw numbers");
  command->add_option("--time-limit", options->time_limit, "seconds")->check(CLI::PositiveNumber);
  command->add_flag("--json", options->json, "print JSON");
  command->add_option("--out", options->out,
                      "folder for result.json, law.csv, law.svg and cycle.svg");
  command->callback([options, &status] { run_optimize(*options, status); });
}

}  // namespace camlaw::cli
