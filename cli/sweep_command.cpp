// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <optional>

#include "cli/command.h"
#include "cli/files.h"
#include "cli/inputs.h"
#include "cli/interrupt.h"
#include "cli/progress_line.h"
#include "cli/ranks.h"
#include "cli/run_limits.h"
#include "cli/study_file.h"
#include "cli/workers.h"
#include "optim/study/recorded_executor.h"
#include "optim/study/workers.h"
#include "output/answers/next_step.h"
#include "output/answers/sweep_answer.h"
#include "output/document/printing.h"
#include "output/document/terminal.h"
#include "problems/fronts/problem_settings.h"
#include "problems/fronts/stored_front.h"
#include "problems/statement/solver_settings.h"
#include "problems/sweeps/sweep_worker.h"

namespace camlaw::cli {
namespace {

namespace fs = std::filesystem;

struct SweepCommand {
  std::string file;
  std::optional<std::string> sample, seed, workers, executor, db, out, start;
  RunLimits limits;
  std::vector<std::string> settings, over;
  bool evaluates = false, cold = false, resume = false, json = false;
};

/// As asked for; where nothing is, as the study that is gone on with has it.
problems::SweepSettings settings_of(const SweepCommand& options,
                                    const std::optional<std::string>& study) {
  const bool asks = !options.settings.empty() || options.sample || options.evaluates ||
                    options.cold || options.seed || !options.over.empty();
  if (options.resume && study) {
    const optim::StudySettings record = optim::StudyRecord::read(*study).settings();
    problems::check_kind(record, "a sweep");
    if (!asks) {
      problems::SweepSettings settings = problems::SweepStudy::of(record).plan().settings();
      if (options.start) check_began_at(options.file, settings.set, *options.start);
      return settings;
    }
  }
  if (options.seed && !options.sample) {
    throw std::invalid_argument("--seed is for samples by lhs; add --sample lhs 64");
  }
  problems::SweepSettings settings{.evaluates = options.evaluates, .is_cold = options.cold};
  problems::add_settings(settings, options.settings);
  if (options.sample) {
    const std::uint64_t seed = options.seed ? static_cast<std::uint64_t>(problems::parse_integer(
                                                  *options.seed, 0, problems::kMostSeed, "--seed"))
                                            : 1;
    settings.sampling = problems::stated_sampling(*options.sample, seed, options.over);
  } else if (!options.over.empty()) {
    throw std::invalid_argument(
        "--over is a range from which samples are drawn; say how many: --sample sobol 64");
  }
  problems::check_set_or_swept(settings, options.settings);
  if (!options.start) return settings;
  // Throws where nothing is swept: a design sweeps nothing.
  settings = problems::SweepPlan(settings).settings();
  settings.set = settings_from(options.file, settings.set, *options.start);
  return settings;
}

/// "27 of 100 combinations, best 49.2 mm".
std::string progress_text(const problems::SweepProgress& progress, const std::string& unit) {
  std::string text = fmt::format("{} of {} combinations", progress.done, progress.all);
  if (progress.best) {
    text += fmt::format(", best {:.6g}{}", *progress.best, unit == "1" ? "" : " " + unit);
  }
  return text;
}

/// The sweep, and what of its record was not believed and has been worked out again.
SweepAnswer sweep_of(const problems::SweepStudy& study, std::optional<optim::StudyRecord>& record,
                     const SweepCommand& options, int count, optim::MpiRanks* ranks) {
  ProgressLine line(!options.json);
  const std::string unit = study.statement().objectives.front().response.unit;
  const auto show = [&](const problems::SweepProgress& p) {
    line.show(progress_text(p, unit), static_cast<double>(p.done) / static_cast<double>(p.all));
  };
  const auto workers = executor_of(problems::sweep_service(study), problems::worker_program(study),
                                   study.options(), count, ranks);
  if (!record) {
    const problems::SweptCombinations sweep = study.run(*workers, show);
    SweepAnswer answer(study, sweep);
    if (!sweep.remark.empty()) answer.notes.push_back(sweep.remark);
    return answer;
  }
  optim::RecordedExecutor recorded(
      [&](std::size_t part, optim::Design x) { return study.problem(part, x); }, *record,
      workers.get());
  const problems::SweptCombinations sweep = study.run(recorded, show);
  SweepAnswer answer(study, sweep);
  if (!sweep.remark.empty()) answer.notes.push_back(sweep.remark);
  const std::string then = answer.is_stopped ? "--resume solves it again" : "it was solved again";
  for (std::string& note : problems::fault_notes(recorded.faults(), then)) {
    answer.notes.push_back(std::move(note));
  }
  return answer;
}

int status_of(const SweepAnswer& answer) {
  if (answer.is_stopped) return kNotSolved;
  if (answer.count(SweepState::Design) > 0 || answer.count(SweepState::Passes) > 0) return kDone;
  return answer.count(SweepState::Failed) > 0 ? kNotSolved : kInfeasible;
}

std::vector<OutputFile> sweep_files(const SweepAnswer& answer, const Document& document,
                                    const fs::path& out) {
  return {{out / "sweep.json", json_text(document)},
          {out / "sweep.csv", csv_of(combinations_table(answer))}};
}

/// Refuses a name for Parquet, which the program does not write.
void check_no_parquet(const char* option, const std::optional<std::string>& path) {
  if (!path || fs::path(*path).extension() != ".parquet") return;
  throw std::invalid_argument(fmt::format(
      "{}: '{}': this program writes a sweep as CSV, JSON and a study; for Parquet write it with "
      "--db sweep.db and convert that in Python: "
      "camlaw.Sweep.load(\"sweep.db\").parquet(\"sweep.parquet\")",
      option, *path));
}

int run_sweep(const SweepCommand& options) {
  const auto began = std::chrono::steady_clock::now();
  check_no_parquet("--out", options.out);
  check_no_parquet("--db", options.db);
  const auto ranks = ranks_of(options.executor, options.workers);
  if (has_served(ranks.get())) return kDone;
  const auto limit = time_limit_of(options.limits);
  check_folder(options.out);
  const int wanted = workers_of(options.workers);  // refused before anything is written
  const auto path = study_file(options.db, options.out, options.resume);
  if (options.resume) check_there(*path);
  keep_input(options.file);
  problems::SweepStudy study(problems::problem_text(options.file), options.file,
                             settings_of(options, path));
  keep_inputs(study.statement());
  if (path && options.resume) keep_input(*path);
  const fs::path out = options.out.value_or("");
  const std::vector<fs::path> possible{out / "sweep.json", out / "sweep.csv"};
  if (options.out) check_outputs(possible, path);
  study.options().memory = memory_of(options.limits);
  const Interruptible interruptible;
  study.options().stop = interruptible.flag();
  if (limit) {
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - began;
    interruptible.ask_after(std::max(0.0, *limit - spent.count()));
  }
  auto record = record_of(path, study, options.resume);
  const SweepAnswer answer = sweep_of(study, record, options, wanted, ranks.get());
  const Document document = sweep_document(answer);
  print(document, options.json);
  if (path && !options.json && !is_quiet()) say("study {}\n", *path);
  if (options.out) write_out(possible, sweep_files(answer, document, out), !options.json);
  if (path && !options.json) {
    if (answer.is_stopped) say("--resume continues it\n");
    say_next("report " + shell_word(*path));
  }
  return status_of(answer);
}

}  // namespace

Command sweep_command() {
  const auto options = std::make_shared<SweepCommand>();
  return {
      .name = "sweep",
      .help = "Find the best design for each of many settings: speeds, laws, sizes",
      .options =
          {problem_file(options->file),
           {"--set", &options->settings, takes::kSetting,
            "what is swept: 'speed=60:15:120 rpm' (from, step, to), 'law=cycloidal,modified-sine', "
            "'law=all'; one value is the same in all combinations"},
           {"--sample", &options->sample, takes::kSampling,
            "draw samples from the ranges of --over: sobol 64 or lhs 64"},
           {"--over", &options->over, takes::kRange,
            "a range for --sample: 'base_radius=30:60 mm'"},
           {"--seed", &options->seed, takes::kNumber, "seed of samples by lhs, an integer from 0"},
           {"--evaluate", &options->evaluates, takes::kNothing,
            "evaluate the file's own design in each combination, without a search"},
           {"--cold", &options->cold, takes::kNothing,
            "search each combination as 'camlaw optimize' does, not from its neighbour's design"},
           start_option(options->start),
           workers_option(options->workers),
           executor_option(options->executor),
           {"--db", &options->db, takes::kFile, "record the study in this file"},
           {"--resume", &options->resume, takes::kNothing,
            "resume the study of --db; damaged or wrong parts are solved again"},
           time_limit_option(options->limits),
           memory_option(options->limits),
           json_switch(options->json),
           {"-o,--out", &options->out, takes::kFolder,
            "folder for sweep.json, sweep.csv and, without --db, study.db; Parquet is written from "
            "Python alone"}},
      .examples =
          {{"camlaw sweep problems/cams/roller_least_base.toml --set 'law=modified-sine,cycloidal' "
            "--set 'stroke=20:5:30 mm' --out results/sweep",
            "the least base circle for each law and stroke, with the study's file"},
           {"camlaw report results/sweep/study.db -o sweep.html",
            "a page with a map: which law is best where"},
           {"camlaw sweep problems/cams/roller_least_base.toml --evaluate --sample sobol 16 "
            "--over 'base_radius=45:70 mm' --over 'roller_radius=8:14 mm'",
            "sixteen designs evaluated, spread evenly over two ranges"}},
      .run = [options] { return run_sweep(*options); }};
}

}  // namespace camlaw::cli
