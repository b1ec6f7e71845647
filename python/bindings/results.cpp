// SPDX-License-Identifier: MIT
#include "python/bindings/results.h"

#include <fmt/format.h>
#include <nanobind/stl/tuple.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <tuple>

#include "numerics/text/file_text.h"
#include "optim/crew/crew.h"
#include "optim/search/free_memory.h"
#include "optim/search/memory.h"
#include "output/answers/buildable_output.h"
#include "output/answers/cycle_figure.h"
#include "output/answers/free_limit.h"
#include "output/answers/optimum_output.h"
#include "output/answers/rulers.h"
#include "output/answers/search_facts.h"
#include "output/answers/warnings.h"
#include "output/document/printing.h"
#include "output/document/short_version.h"
#include "output/report/html.h"
#include "output/report/report.h"
#include "problems/fronts/study_worker.h"
#include "problems/refinement/refined_knots.h"
#include "problems/results/input_files.h"
#include "problems/results/judged_design.h"
#include "problems/results/recorded_design.h"
#include "problems/results/seal.h"
#include "problems/results/start_settings.h"
#include "problems/results/stated_numbers.h"
#include "problems/statement/parameters.h"
#include "problems/statement/solver_settings.h"
#include "problems/tolerance/reliable_search.h"
#include "python/bindings/laws.h"
#include "python/bindings/module.h"
#include "python/bindings/problems.h"
#include "python/bindings/running.h"

namespace camlaw::python {
namespace {

using problems::Json;
using problems::ReadDesign;

/// The design for work that may be stopped.
ReadDesign within(const Work& work, ReadDesign design) {
  design.problem.stop = design.statement.stop = work.stop();
  return design;
}

/// How to search; what is not told is as the problem has it.
struct SearchSettings {
  std::optional<std::string> solver;
  std::optional<int> starts;
  std::optional<std::uint64_t> seed;
  std::optional<double> time_limit, memory;
  int workers = 1;
  bool table = false;  ///< every combination beside a free law, as the program's --table
};

optim::OptimiseOptions options_of(const SearchSettings& told,
                                  const problems::SolverStatement& stated) {
  optim::OptimiseOptions result;
  result.solver = told.solver ? problems::find_solver_name(*told.solver)
                              : stated.name.value_or(std::string("auto"));
  result.starts = told.starts ? told.starts : stated.starts;
  if (result.starts && (*result.starts < 1 || *result.starts > problems::kMostStarts)) {
    throw std::invalid_argument(
        fmt::format("starts: {} is outside 1 .. {}", *result.starts, problems::kMostStarts));
  }
  result.seed = told.seed.value_or(stated.seed.value_or(result.seed));
  result.time_limit = told.time_limit ? told.time_limit : stated.time_limit;
  if (result.time_limit && !(*result.time_limit > 0)) {
    throw std::invalid_argument(
        fmt::format("time_limit: {} s is not above zero", *result.time_limit));
  }
  result.memory = told.memory.value_or(optim::free_memory());
  result.native = stated.native;
  return result;
}

std::string words_of(const optim::Progress& progress) {
  return fmt::format("iteration {}, objective {:.8g}, violation {:.2e}", progress.iteration,
                     progress.objective, progress.violation);
}

/// What a search for the best law adds: how far it is from what is possible, and from named laws.
void measure(const cli::Answer& answer, const optim::OptimiseOptions& rest, int workers,
             Json& facts, cli::Document& document) {
  cli::Document more;
  more.fact("rulers", Json(nullptr));
  try {
    if (!cli::free_segments(answer.bound.statement()).empty()) {
      more.add("rulers", cli::segment_rulers(answer));
    } else if (const auto measured = cli::rulers(answer, rest, workers)) {
      more.add("rulers", cli::rulers_document(answer, *measured));
    }
  } catch (const std::exception& error) {
    more.say(
        fmt::format("\nthe law could not be compared with what is possible: {}\n", error.what()));
  }
  facts.update(cli::json_of(more));
  document.add(std::move(more));
}

/// Every combination of an answer; beside a free law, for which it searches, if that is told.
cli::Document combinations_of(const cli::Answer& answer, const SearchSettings& told,
                              optim::OptimiseOptions rest) {
  if (!told.table || answer.space.choices.empty()) return cli::combinations_document(answer);
  const optim::Deadline deadline(rest.time_limit, rest.stop, rest.spent);
  if (rest.time_limit) rest.time_limit = std::max(0.0, *rest.time_limit - rest.spent) / 2;
  rest.spent = 0;
  const cli::FreeLimit free = cli::free_limit(answer, rest, told.workers);
  return cli::combinations_document(answer, &free, deadline);
}

/// The design of an answer, as a result would give it back.
std::optional<ReadDesign> design_of(const cli::Answer& answer) {
  const optim::Found& found = answer.optimum.found;
  if (found.x.size() != answer.optimum.problem.variables.size()) return std::nullopt;
  ReadDesign design{answer.bound.statement()};
  design.statement = answer.bound.at(answer.optimum.options, found.x);
  if (!problems::are_possible(design.statement.laws)) return std::nullopt;
  design.verdict = std::string(optim::to_string(found.assessment.verdict));
  design.reason = found.assessment.reason;
  design.blamed = found.assessment.blamed;
  if (std::isfinite(found.assessment.objective.value)) {
    design.objective = found.assessment.objective.value;
  }
  design.global = found.assessment.global.has_value();
  return design;
}

void check_free(const problems::ProblemStatement& statement) {
  const auto is_free = [](const Member& law) { return bool(law.family->listed); };
  const bool program = statement.mechanism->moved_by == problems::MovedBy::Program;
  if (program ? !cli::free_segments(statement).empty()
              : std::any_of(statement.laws.begin(), statement.laws.end(), is_free)) {
    return;
  }
  throw std::invalid_argument(
      statement.source + (program
                              ? ": no segment's law is free; write law = \"free\" in a segment"
                              : ": no law of the problem is free; write [law] name = \"free\""));
}

/// What an answer refers to.
struct Searched {
  explicit Searched(problems::BoundProblem of) : bound(std::move(of)), space(bound.space()) {}

  problems::BoundProblem bound;
  optim::ProblemSpace space;
  optim::Optimum optimum;
};

StoredResult searched(const problems::ProblemStatement& statement, const SearchSettings& told,
                      bool synthesize, Work& work) {
  const auto began = std::chrono::steady_clock::now();
  const auto seconds_since_start = [began] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  };
  optim::OptimiseOptions search = options_of(told, statement.solver);
  search.stop = work.stop();
  std::string stage;  // of several searches which it is
  const auto begins = [&](const std::string& next) { stage = next + ": "; };
  search.progress = [&](const optim::Progress& p) { work.tell(p.done, stage + words_of(p)); };
  std::optional<problems::RefinedKnots> knots;
  problems::ProblemStatement stated = statement;
  if (stated.finds_knots) {
    knots = problems::find_knots(stated, search, told.workers, seconds_since_start, begins);
  }
  const auto found = std::make_shared<Searched>(problems::BoundProblem(std::move(stated)));
  const optim::ProblemSpace& space = found->space;
  const int workers =
      optim::workers_with_room(told.workers, space.problem(space.options(0)), *search.memory);
  optim::Crew crew(
      {.workers = workers, .program = problems::worker_program(found->bound.statement())});
  found->optimum = knots ? knots->optimum : optim::optimise(space, search, crew);
  search.spent = seconds_since_start() - found->optimum.wall_s;
  problems::ReachedReliability reached =
      problems::search_until_reached(found->bound, search, found->optimum, begins);
  cli::Answer answer{found->bound, space, found->optimum, search.solver, search.seed};
  answer.reached = std::move(reached);
  answer.knots = knots;
  answer.warnings = cli::warnings_of(answer);
  optim::OptimiseOptions rest = search;
  rest.spent = seconds_since_start();
  answer.easings = optim::easings(found->optimum.problem, found->optimum.found, rest);
  answer.built = cli::buildability_of(answer);
  cli::Document document = cli::answer_document(answer);
  Json facts = cli::json_of(document);
  if (told.table) begins("free law");
  rest.spent = seconds_since_start();
  cli::Document combinations = combinations_of(answer, told, rest);
  const Json table = cli::json_of(combinations);
  if (told.table) {
    facts.update(table);
    document.add(std::move(combinations));
  }
  if (synthesize) {
    if (rest.time_limit) rest.time_limit = *rest.time_limit - seconds_since_start();
    rest.spent = 0;
    measure(answer, rest, workers, facts, document);
  }
  problems::seal(facts);
  StoredResult result{.facts = std::move(facts)};
  result.say(document);
  if (table.contains("table")) result.combinations = table["table"];
  if (auto design = design_of(answer)) {
    design->stated = problems::stated_numbers(result.facts);
    result.design = std::move(*design);
  }
  result.cycle = [found, answer] { return cli::cycle_figure(answer); };
  return result;
}

nb::tuple found_by_search(const StatedProblem& problem, bool synthesize,
                          std::optional<std::string> solver, std::optional<int> starts,
                          std::optional<std::uint64_t> seed, std::optional<double> time_limit,
                          std::optional<double> memory, std::optional<int> workers, bool table,
                          nb::handle progress) {
  const SearchSettings told{std::move(solver),   starts, seed, time_limit, memory,
                            workers_of(workers), table};
  if (synthesize) check_free(problem.statement);
  std::optional<StoredResult> result;
  const bool interrupted = run_beside(
      [&](Work& work) { result = searched(problem.statement, told, synthesize, work); }, progress);
  return nb::make_tuple(std::move(*result), interrupted);
}

StoredResult result_of_text(const std::string& text, const std::string& path) {
  ReadDesign design = problems::read_result(text, path);
  return {.facts = problems::parse_json(text), .design = std::move(design), .file = path};
}

StoredResult result_file(const std::string& path) {
  const Unlocked released;
  return result_of_text(problems::file_text(path, "result"), path);
}

const ReadDesign& design_in(const StoredResult& result) {
  if (result.design) return *result.design;
  throw std::invalid_argument("the result has no design: its search found none");
}

/// The claim of a result judged again.
nb::dict verified(const StoredResult& result) {
  struct Verified {
    problems::VerifiedDesign found;
    std::vector<std::string> notes;
  };
  const auto [found, notes] = run_whole([&](const Work& work) {
    const ReadDesign design = within(work, design_in(result));
    return Verified{problems::verified(design, problems::held_to_parts(design.statement)),
                    problems::record_notes(design, cli::short_version())};
  });
  nb::dict object;
  object["holds"] = found.disagreements.empty();
  object["claimed"] = *result.design->verdict;
  object["verdict"] = std::string(optim::to_string(found.found.verdict));
  object["reason"] = found.found.reason;
  object["global"] = found.found.global;
  object["best_possible"] = found.found.best_possible;
  object["objective"] = found.found.objective.value;
  object["kkt_residual"] = found.found.kkt_residual;
  object["limits"] = list_of(found.limits);
  object["disagreements"] = found.disagreements;
  object["not_judged"] = found.not_judged;
  object["record"] = notes;
  object["choices_held"] = !found.whole;
  return object;
}

std::vector<std::string> review_of(const StoredResult& result) {
  if (!result.design) return {};
  return run_whole(
      [&](const Work& work) { return cli::reviewed(within(work, *result.design)).words(); });
}

std::string result_report_of(const StoredResult& result) {
  return run_whole([&](const Work& work) {
    const ReadDesign design = within(work, design_in(result));
    return cli::page_html(cli::design_report({.read = design,
                                              .file = result.file,
                                              .facts = cli::facts_of_search(result.facts),
                                              .review = cli::reviewed(design)}));
  });
}

std::string report_of_problem(const StatedProblem& problem) {
  return run_whole([&](const Work& work) {
    const ReadDesign design{problem.within(work)};
    return cli::page_html(
        cli::design_report({.read = design, .file = problem.statement.source, .review = {}}));
  });
}

/// What is drawn of a result that was found, or that was pickled; nothing of one that was read.
cli::Figure cycle_figure_of(const StoredResult& result) {
  if (!result.cycle) return {};
  return without_lock([&] { return result.cycle(); });
}

/// A result as its file has it, whether there is a design, what it is called, and what a search
/// says of it in words and in HTML, and of its combinations.
using ResultState = std::tuple<std::string, bool, std::string, std::optional<std::string>,
                               std::optional<std::string>, std::string>;

ResultState result_state_of(const StoredResult& result) {
  return {result.facts.dump(), result.design.has_value(), result.file, result.text,
          result.html,         result.combinations.dump()};
}

StoredResult result_from(const ResultState& state) {
  const Unlocked released;
  const auto& [facts, has_design, file, text, html, combinations] = state;
  StoredResult result;
  if (has_design) {
    result = result_of_text(facts, file);
  } else {
    result.facts = problems::parse_json(facts);
    result.file = file;
  }
  result.text = text;
  result.html = html;
  result.combinations = problems::parse_json(combinations);
  return result;
}

}  // namespace

void StoredResult::say(const cli::Document& document) {
  text = cli::unshaded(cli::text_of(document));
  html = cli::html_of(document);
}

StoredResult result_of(Json facts, ReadDesign design) {
  problems::seal(facts);
  design.stated = problems::stated_numbers(facts);
  return {.facts = std::move(facts), .design = std::move(design)};
}

void add_results(nb::module_& module) {
  nb::class_<StoredResult>(module, "Result")
      .def_prop_ro("file", [](const StoredResult& r) { return r.file; })
      .def("is_input",
           [](const StoredResult& r, const std::string& path) {
             return r.design && without_lock([&] {
                      return problems::is_read_by(problems::recorded_problem(*r.design, r.file),
                                                  path);
                    });
           })
      .def("combinations", [](const StoredResult& r) { return python_of(r.combinations); })
      .def("facts", [](const StoredResult& r) { return python_of(r.facts); })
      .def("json_text", [](const StoredResult& r) { return r.facts.dump(2) + "\n"; })
      .def_prop_ro("text", [](const StoredResult& r) { return r.text; })
      .def_prop_ro("html", [](const StoredResult& r) { return r.html; })
      .def("design",
           [](const StoredResult& r) -> std::optional<StatedProblem> {
             if (!r.design) return std::nullopt;
             return StatedProblem{r.design->statement};
           })
      .def("problem", [](const StoredResult& r) { return StatedProblem{design_in(r).problem}; })
      .def("review", &review_of)
      .def("cycle_figure", [](const StoredResult& r) { return dict_of(cycle_figure_of(r)); })
      .def("verify", &verified)
      .def("report", &result_report_of)
      .def("__getstate__", &result_state_of)
      .def("__setstate__", [](StoredResult& result, const ResultState& state) {
        new (&result) StoredResult(result_from(state));
      });
  module.def("search", &found_by_search, nb::arg("problem"), nb::arg("synthesize"),
             nb::arg("solver").none(), nb::arg("starts").none(), nb::arg("seed").none(),
             nb::arg("time_limit").none(), nb::arg("memory").none(), nb::arg("workers").none(),
             nb::arg("table"), nb::arg("progress").none());
  module.def("result_file", &result_file, nb::arg("path"));
  module.def(
      "beginning_at",
      [](const StatedProblem& problem, const StoredResult& result) {
        StatedProblem changed = problem;
        without_lock([&] {
          problems::set_values(changed.statement,
                               problems::start_settings(problem.statement, design_in(result)));
        });
        return changed;
      },
      nb::arg("problem"), nb::arg("result"));
  module.def("report_of_problem", &report_of_problem, nb::arg("problem"));
}

}  // namespace camlaw::python
