// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
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
#include "cli/watched_run.h"
#include "cli/workers.h"
#include "optim/search/free_memory.h"
#include "optim/study/workers.h"
#include "output/answers/front_output.h"
#include "output/answers/front_words.h"
#include "output/answers/next_step.h"
#include "output/answers/warnings.h"
#include "output/document/printing.h"
#include "output/document/terminal.h"
#include "problems/fronts/study_worker.h"
#include "problems/statement/solver_settings.h"

namespace camlaw::cli {
namespace {

namespace fs = std::filesystem;

struct ParetoCommand {
  std::string file;
  std::optional<std::string> method, points, workers, executor, db, out, start;
  RunLimits limits;
  std::vector<std::string> settings;
  bool resume = false, json = false;
};

/// As asked for; what is not, as the study that is gone on with has it.
problems::FrontSettings settings_of(const ParetoCommand& options,
                                    const std::optional<std::string>& study) {
  problems::FrontSettings settings;
  if (options.resume && study) {
    settings = problems::FrontStudy::settings_of(optim::StudyRecord::read(*study));
    settings.files = {};  // those that there are, so that others than the study's are noticed
  }
  if (!options.settings.empty()) settings.set = options.settings;
  if (options.method) {
    try {
      settings.method = problems::parse_method(*options.method);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(fmt::format("--method: {}", error.what()));
    }
  }
  if (options.points) {
    settings.points = static_cast<std::size_t>(
        problems::parse_integer(*options.points, 2, problems::kMostPoints, "--points"));
  }
  return settings;
}

/// With the settings that begin the study at the design of --start. One that is gone on with has
/// them already, or cannot have them any more.
problems::FrontSettings begun(const ParetoCommand& options, const std::optional<std::string>& study,
                              problems::FrontSettings settings) {
  const bool has_them = options.resume && study && options.settings.empty();
  if (!options.start) return settings;
  if (has_them) {
    check_began_at(options.file, settings.set, *options.start);
    return settings;
  }
  settings.set = settings_from(options.file, settings.set, *options.start);
  return settings;
}

void show(ProgressLine& line, const optim::StudyProgress& progress) {
  constexpr std::size_t kEnds = 2;  // the first points tell nothing of the pace
  const double done = progress.points > kEnds ? static_cast<double>(progress.points) /
                                                    static_cast<double>(progress.wanted)
                                              : 0;
  line.show(front_progress(progress), std::min(done, 1.0));
}

std::vector<OutputFile> front_files(const FrontAnswer& answer, const Document& document,
                                    const fs::path& out) {
  std::vector<OutputFile> files{{out / "front.json", json_text(document)}};
  if (answer.front.points.empty()) return files;
  files.push_back({out / "front.csv", front_csv(answer)});
  const Figure figure = front_figure(answer);
  if (!figure.panels.empty()) files.push_back({out / "front.svg", to_svg(figure)});
  return files;
}

/// The front, and what of the record was not believed and has been solved again.
problems::StoredFront look(problems::FrontStudy& study, std::optional<optim::StudyRecord>& record,
                           const ParetoCommand& options, int count, optim::MpiRanks* ranks) {
  ProgressLine line(!options.json);
  study.options().progress = [&](const optim::StudyProgress& p) { show(line, p); };
  const auto workers =
      executor_of(optim::study_service(study.space()), problems::worker_program(study),
                  study.options().solve, count, ranks);
  if (!record) return {.front = study.run(*workers)};
  optim::RecordedExecutor recorded(study.space(), *record, workers.get());
  problems::StoredFront found{.front = study.run(recorded),
                              .faults = recorded.faults(),
                              .resuming = problems::Resuming::Works};
  found.notes = problems::fault_notes(
      found.faults, found.front.stopped ? "--resume solves it again" : "it was solved again");
  return found;
}

int run_pareto(const ParetoCommand& options) {
  const auto began = std::chrono::steady_clock::now();
  const auto ranks = ranks_of(options.executor, options.workers);
  if (has_served(ranks.get())) return kDone;
  const auto limit = time_limit_of(options.limits);
  check_folder(options.out);
  const int wanted = workers_of(options.workers);  // refused before anything is written
  const auto path = study_file(options.db, options.out, options.resume);
  if (options.resume) check_there(*path);
  keep_input(options.file);
  problems::FrontStudy study(problems::problem_text(options.file), options.file,
                             begun(options, path, settings_of(options, path)));
  keep_inputs(study.bound().statement());
  if (path && options.resume) keep_input(*path);
  const fs::path out = options.out.value_or("");
  const std::vector<fs::path> possible{out / "front.json", out / "front.csv", out / "front.svg"};
  if (options.out) check_outputs(possible, path);
  const optim::ProblemSpace& space = study.space();
  const int workers = optim::workers_with_room(wanted, space.problem(space.options(0)).alone(0),
                                               memory_of(options.limits));
  const Interruptible interruptible;
  study.options().solve.stop = interruptible.flag();
  const auto work = [&](const ChildTeller* teller) {
    auto record = record_of(path, study, options.resume);
    const problems::StoredFront found = look(study, record, options, workers, ranks.get());
    const optim::Front& front = found.front;
    if (teller != nullptr) teller->answers();
    FrontAnswer answer{study, found};
    for (std::string& note : begins_with_parts(study.bound().statement(), options.settings)) {
      answer.warnings.push_back(std::move(note));
    }
    const Document document = front_document(answer);
    print(document, options.json);
    if (path && !options.json && !is_quiet()) say("study {}\n", *path);
    if (options.out) write_out(possible, front_files(answer, document, out), !options.json);
    if (!path || options.json || front.points.empty()) return status_of(front);
    say_next(fmt::format("front {} --knee --sensitivity", shell_word(*path)));
    say_next("report " + shell_word(*path));
    return status_of(front);
  };
  if (!limit) return work(nullptr);
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - began;
  if (ranks) {  // no copy of this process could speak to the others
    interruptible.ask_after(std::max(0.0, *limit - spent.count()));
    return work(nullptr);
  }
  // The searches of a study end where its process is asked to; what is recorded stays.
  const Watch watch{limit, spent.count(), interruptible.flag()};
  const auto ended = watched(watch, [&](const ChildTeller& teller) { return work(&teller); });
  if (const int* status = std::get_if<int>(&ended)) return *status;
  throw NotSolved(fmt::format("{}{}", std::get<Unfinished>(ended).why,
                              path ? fmt::format("; --resume continues {}", *path) : ""));
}

}  // namespace

Command pareto_command() {
  const auto options = std::make_shared<ParetoCommand>();
  return {.name = "pareto",
          .help =
              "Find the front of a problem file with two or more objectives, each a table "
              "[[objectives]]",
          .options = {problem_file(options->file),
                      set_option(options->settings),
                      start_option(options->start),
                      {"--points", &options->points, takes::kNumber, "number of designs (50)"},
                      {"--method", &options->method, "{auto,sweep,nsga2}",
                       "auto, sweep (searches by gradients) or nsga2, polished by gradients"},
                      workers_option(options->workers),
                      executor_option(options->executor),
                      {"--db", &options->db, takes::kFile, "record the study in this file"},
                      {"--resume", &options->resume, takes::kNothing,
                       "resume the study of --db; damaged or wrong parts are solved again"},
                      time_limit_option(options->limits),
                      memory_option(options->limits),
                      json_switch(options->json),
                      {"-o,--out", &options->out, takes::kFolder,
                       "folder for front.json, front.csv, front.svg and, without --db, study.db"}},
          .examples =
              {{"camlaw pareto problems/spine_cutter/front.toml --points 12 --out results/front",
                "the front of cam radius and force, with pictures and the study's file"},
               {"camlaw pareto problems/spine_cutter/front.toml --points 16 --out results/front "
                "--resume",
                "more points of the same study; those that it has are not searched again"},
               {"mpirun -n 17 camlaw pareto problems/spine_cutter/front.toml --executor mpi --db "
                "front.db",
                "by 16 processes of a cluster and one that hands out the work"}},
          .run = [options] { return run_pareto(*options); }};
}

}  // namespace camlaw::cli
