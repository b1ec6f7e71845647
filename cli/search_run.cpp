// SPDX-License-Identifier: MIT
#include "cli/search_run.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "cli/help.h"
#include "cli/inputs.h"
#include "cli/interrupt.h"
#include "cli/progress_line.h"
#include "cli/search_outputs.h"
#include "cli/search_progress.h"
#include "cli/watched_run.h"
#include "cli/workers.h"
#include "optim/crew/crew.h"
#include "optim/cycle/proof_time.h"
#include "optim/search/free_memory.h"
#include "optim/verdict/verdict.h"
#include "output/answers/free_limit.h"
#include "output/answers/next_step.h"
#include "output/answers/warnings.h"
#include "output/document/printing.h"
#include "problems/fronts/study_worker.h"
#include "problems/refinement/refined_knots.h"
#include "problems/results/seal.h"
#include "problems/statement/solver_settings.h"
#include "problems/tolerance/reliable_search.h"

namespace camlaw::cli {
namespace {

/// What the command line says of solving.
problems::SolverStatement stated_options(const SearchOptions& options) {
  problems::SolverStatement result;
  if (options.solver) result.name = problems::find_solver_name(*options.solver);
  if (options.starts) {
    result.starts = static_cast<int>(
        problems::parse_integer(*options.starts, 1, problems::kMostStarts, "--starts"));
  }
  if (options.seed) {
    result.seed = static_cast<std::uint64_t>(
        problems::parse_integer(*options.seed, 0, problems::kMostSeed, "--seed"));
  }
  result.time_limit = time_limit_of(options.limits);
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
  result.native = file.native;
  return result;
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

class Seconds {
 public:
  double spent() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
  }

 private:
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
};

/// The search's own options for what comes after it: a share of the time that is left.
optim::OptimiseOptions rest_of(optim::OptimiseOptions search, const Seconds& clock,
                               double share = 1) {
  if (search.time_limit)
    search.time_limit = share * std::max(0.0, *search.time_limit - clock.spent());
  search.spent = 0;
  return search;
}

/// Whether one step of a search may take so long that it is not left to itself.
bool is_large(const problems::ProblemStatement& statement) {
  // A factorisation then takes longer than a person waits for Ctrl-C (optimisation: Time).
  constexpr std::size_t kLarge = 100;
  std::size_t pieces = 0;
  for (const Member& law : statement.laws) {
    for (const auto& list : law.arguments.values()) pieces = std::max(pieces, list.size());
  }
  return statement.variables.size() + statement.constraints.size() + pieces >= kLarge;
}

/// The answer of a search that was ended from outside: the best design that it told of, else the
/// start.
optim::Optimum unfinished_optimum(const optim::ProblemSpace& space, const Unfinished& unfinished) {
  std::vector<std::size_t> first;
  for (const optim::Choice& choice : space.choices) first.push_back(choice.start);
  optim::Optimum result{first, space.problem(first), {}};
  result.found.assessment.reason = unfinished.why;
  const auto look = [&](const std::vector<std::size_t>& options, const std::vector<double>& x) {
    optim::Problem problem = options == result.options ? result.problem : space.problem(options);
    optim::Found found = optim::cut_short(problem, x, unfinished.why);
    const bool first_look = result.found.x.empty();
    if (!first_look && !optim::better(problem, found.assessment, result.found.assessment)) return;
    result = {options, std::move(problem), std::move(found)};
  };
  for (const auto* told : {&unfinished.best, &unfinished.last}) {
    if (!*told) continue;
    try {
      look((*told)->options.empty() ? first : (*told)->options, (*told)->x);
    } catch (const std::exception&) {
      // At a design that was not worked out yet the model may throw: the other one counts.
    }
  }
  if (result.found.x.empty()) look(first, result.problem.start());
  return result;
}

SearchState begun_state(const problems::ProblemStatement& statement) {
  SearchState begun;
  if (!statement.objectives.empty()) begun.unit = statement.objectives.front().response.unit;
  return begun;
}

/// A search that shows how far it is.
optim::OptimiseOptions shown_by(SearchProgress& shown, optim::OptimiseOptions how) {
  how.progress = [&shown](const optim::Progress& p) { shown.heard(p); };
  how.candidate = [&shown, tell = how.candidate](const optim::Candidate& c) {
    shown.heard(c);
    if (tell) tell(c);
  };
  return how;
}

/// The free law's search, which shows how far it is.
FreeLimit shown_free_limit(const Answer& answer, const optim::OptimiseOptions& rest, int workers,
                           bool is_shown) {
  ProgressLine line(is_shown);
  SearchProgress shown(line, begun_state(answer.bound.statement()));
  shown.begins("free law");
  return free_limit(answer, line.is_shown() ? shown_by(shown, rest) : rest, workers);
}

/// Prints an answer as soon as there is one, then what is measured of it: nothing is lost where
/// that is stopped, or fails. Returns the JSON.
std::string show(const SearchCommand& command, const Answer& answer,
                 const optim::OptimiseOptions& search, const Seconds& clock, int workers,
                 const SearchOptions& options) {
  const bool json = options.json;
  const Document document = answer_document(answer);
  Json result = json_of(document);
  if (!json) print_text(text_of(document));
  flush_printed();
  const auto show_more = [&](const Document& more) {
    if (!json) print_text(text_of(more));
    result.update(json_of(more));
    flush_printed();
  };
  if (options.table && !answer.space.choices.empty()) {
    constexpr double kShare = 0.5;  // the rows of the table have the other half at least
    const FreeLimit free = shown_free_limit(answer, rest_of(search, clock, kShare), workers, !json);
    const optim::Deadline deadline(search.time_limit, search.stop, clock.spent());
    show_more(combinations_document(answer, &free, deadline));
  }
  if (command.measure) show_more(command.measure(answer, rest_of(search, clock), workers));
  problems::seal(result);
  std::string text = result.dump(2) + "\n";
  if (json) print_data(text);
  flush_printed();
  return text;
}

/// The knots that the file leaves to the program; none where it states them, or needs none.
std::optional<problems::RefinedKnots> found_knots(problems::ProblemStatement& statement,
                                                  const optim::OptimiseOptions& search, int workers,
                                                  bool is_shown, const Seconds& clock) {
  if (!statement.finds_knots) return {};
  ProgressLine line(is_shown);
  SearchProgress shown(line, begun_state(statement));
  return problems::find_knots(
      statement, line.is_shown() ? shown_by(shown, search) : search, workers,
      [&] { return clock.spent(); }, [&shown](const auto& stage) { shown.begins(stage); });
}

/// A search of the command line, ready to begin.
struct SearchRun {
  const SearchOptions& options;
  const SearchCommand& command;
  const problems::BoundProblem& bound;
  const optim::ProblemSpace& space;
  const std::optional<problems::RefinedKnots>& knots;
  std::vector<std::filesystem::path> outputs;  ///< that --out may make
  optim::OptimiseOptions search;
  int workers;
  const Seconds& clock;
};

/// A search's end: the optimum, and what was reached of limits on shares.
struct SearchEnd {
  optim::Optimum optimum;
  problems::ReachedReliability reached;
};

/// Gives the answer; returns the exit status.
int give(const SearchRun& run, const SearchEnd& end) {
  const auto& [optimum, reached] = end;
  Answer answer{run.bound, run.space, optimum, run.search.solver, run.search.seed};
  answer.reached = reached;
  answer.knots = run.knots;
  // The doubts of a large problem take time of their own.
  const bool late = run.search.time_limit && run.clock.spent() >= *run.search.time_limit;
  if (!late || !is_large(run.bound.statement())) {
    const optim::Deadline deadline(run.search.time_limit, nullptr, run.clock.spent());
    const optim::ProofTime proofs(deadline);
    answer.warnings = warnings_of(answer);
    answer.easings = optim::easings(optimum.problem, optimum.found, rest_of(run.search, run.clock));
    answer.built = buildability_of(answer);
  }
  for (std::string& note : begins_with_parts(run.bound.statement(), run.options.settings)) {
    answer.warnings.push_back(std::move(note));
  }
  // Printed first: the search is not lost where a file cannot be written after all.
  const std::string json =
      show(run.command, answer, run.search, run.clock, run.workers, run.options);
  if (run.options.out) {
    std::vector<OutputFile> files = run.command.figures(answer, *run.options.out);
    files.insert(files.begin(), {run.outputs.front(), json});
    write_out(run.outputs, files, !run.options.json);
    if (!run.options.json) say_next("report " + shell_word(run.outputs.front().string()));
  }
  return exit_status(optimum.found.assessment.verdict);
}

/// Searches. What is told of the first search is kept where this process is ended; of the further
/// ones, for limits that are stricter than those stated, nothing is.
SearchEnd searched(const SearchRun& run, const optim::OptimiseOptions& how) {
  SearchState begun = begun_state(run.bound.statement());
  for (const optim::Choice& choice : run.space.choices) begun.combinations *= choice.options.size();
  ProgressLine line(!run.options.json);
  SearchProgress shown(line, begun);
  const auto followed = [&](const optim::OptimiseOptions& o) {
    return line.is_shown() ? shown_by(shown, o) : o;
  };
  const auto begins = [&](const std::string& stage) { shown.begins(stage); };
  optim::Optimum optimum;
  optim::OptimiseOptions further = run.search;
  if (run.knots) {
    optimum = run.knots->optimum;
    optimum.wall_s = run.clock.spent();
    further.spent = 0;  // it is in the optimum's
  } else {
    optim::Crew crew(
        {.workers = run.workers, .program = problems::worker_program(run.bound.statement())});
    optimum = optim::optimise(run.space, followed(how), crew);
    if (!crew.remark().empty()) warn(crew.remark());
  }
  problems::ReachedReliability reached =
      search_until_reached(run.bound, followed(further), optimum, begins);
  return {std::move(optimum), std::move(reached)};
}

/// What a search that was ended from outside has told of.
SearchEnd told_of(const SearchRun& run, const Unfinished& unfinished) {
  optim::Optimum optimum = unfinished_optimum(run.space, unfinished);
  optimum.wall_s = run.clock.spent();
  optimum.found.solver = run.search.solver;
  optimum.found.why_solver = "ended from outside";
  problems::ReachedReliability reached = judge_optimum(run.bound, run.search, optimum);
  return {std::move(optimum), std::move(reached)};
}

/// Searches in a process of its own, which is ended where a step takes longer than the limit.
int give_watched(const SearchRun& run) {
  const Watch watch{run.search.time_limit, run.clock.spent(), run.search.stop};
  const auto ended = watched(watch, [&](const ChildTeller& teller) {
    optim::OptimiseOptions how = run.search;
    how.candidate = [&teller](const optim::Candidate& c) { teller.candidate(c); };
    const SearchEnd end = searched(run, how);
    teller.answers();
    return give(run, end);
  });
  if (const int* status = std::get_if<int>(&ended)) return *status;
  SearchRun rest = run;
  rest.search.spent = 0;  // it is in the optimum's
  return give(rest, told_of(rest, std::get<Unfinished>(ended)));
}

}  // namespace

int run_search(const SearchOptions& options, const SearchCommand& command) {
  const Seconds clock;
  check_folder(options.out);
  const problems::SolverStatement stated = stated_options(options);
  const int wanted = workers_of(options.workers);
  keep_input(options.file);
  problems::ProblemStatement statement = problems::read_problem_file(options.file);
  keep_inputs(statement);
  problems::set_values(statement, options.settings);
  if (options.start) begin_with(statement, *options.start);
  command.check(statement);
  auto search = search_options(stated, statement.solver);
  auto outputs = checked_outputs(options, command, statement);
  const Interruptible interruptible;
  search.stop = interruptible.flag();
  search.memory = memory_of(options.limits);
  const auto knots = found_knots(statement, search, wanted, !options.json, clock);
  const problems::BoundProblem bound(std::move(statement));
  const optim::ProblemSpace space = bound.space();
  search.spent = clock.spent();
  const int workers =
      optim::workers_with_room(wanted, space.problem(space.options(0)), *search.memory);
  const SearchRun run{options, command, bound, space, knots, std::move(outputs),
                      search,  workers, clock};
  if (!knots && is_large(bound.statement())) return give_watched(run);
  return give(run, searched(run, search));
}

std::vector<Option> search_options(SearchOptions& options, const std::string& files) {
  return {problem_file(options.file),
          set_option(options.settings),
          start_option(options.start),
          {"--solver", &options.solver, takes::kSolver,
           fmt::format("auto, {}", fmt::join(optim::solver_names(), ", "))},
          {"--starts", &options.starts, takes::kNumber,
           fmt::format("number of starting points, 1 to {} (1 if the problem is convex or the "
                       "solver global, 3 if it is large, otherwise 8)",
                       problems::kMostStarts)},
          {"--seed", &options.seed, takes::kNumber,
           "seed of starting points and random methods, an integer from 0"},
          workers_option(options.workers),
          time_limit_option(options.limits),
          memory_option(options.limits),
          {"--table", &options.table, takes::kNothing,
           "list the result for each law and each other choice"},
          json_switch(options.json),
          {"-o,--out", &options.out, takes::kFolder, "folder for " + files}};
}

}  // namespace camlaw::cli
