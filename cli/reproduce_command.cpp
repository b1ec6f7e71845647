// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <optional>

#include "cli/command.h"
#include "cli/exit_status.h"
#include "cli/files.h"
#include "cli/inputs.h"
#include "cli/interrupt.h"
#include "cli/progress_line.h"
#include "optim/problem/deadline.h"
#include "output/answers/reproduction_output.h"
#include "output/document/printing.h"
#include "output/report/report.h"
#include "problems/published/cam_shape/solve.h"
#include "problems/published/systems.h"
#include "problems/statement/solver_settings.h"

namespace camlaw::cli {
namespace {

using problems::SystemReproduction;

Document case_document(const problems::CamShapeCase& solved) {
  Document document;
  document.say(
      fmt::format("cam-shape, n = {}: {} ({})\n", solved.n, solved.verdict, solved.reason));
  if (solved.printed) document.say(fmt::format("printed        {:.10g}\n", *solved.printed));
  document.say(
      fmt::format("objective      {:.10f}\ntrue optimum   {:.10f}\nmax violation  {:.1e}\n"
                  "{} iterations, {:.3g} s\n",
                  solved.objective, solved.true_optimum, solved.max_violation, solved.iterations,
                  solved.wall_s));
  document.fact("n", solved.n);
  document.fact("printed", solved.printed);
  document.fact("objective", solved.objective);
  document.fact("true_optimum", solved.true_optimum);
  document.fact("max_violation", solved.max_violation);
  document.fact("verdict", solved.verdict);
  document.fact("reason", solved.reason);
  document.fact("iterations", solved.iterations);
  document.fact("wall_s", solved.wall_s);
  return document;
}

/// Every printed case.
Json cam_shape_cases() {
  Json cases = Json::array();
  for (const auto& printed : problems::printed_cam_shapes()) {
    cases.push_back(
        json_of(case_document(problems::solve_cam_shape(problems::points_of(printed)))));
  }
  return cases;
}

/// What used to reproduce and no longer does; whether there is any of it.
bool warn_of_worsened(const std::vector<SystemReproduction>& results) {
  bool any = false;
  for (const SystemReproduction& result : results) {
    for (const std::string& text : problems::worsened(result)) {
      any = true;
      warn(text);
    }
  }
  return any;
}

struct ReproduceOptions {
  std::vector<std::string> names;
  bool json = false;
  std::optional<std::string> n, report;
};

/// The one case that --n asks for.
int run_size(const ReproduceOptions& options) {
  if (options.names.size() != 1 || options.names.front() != "cam-shape") {
    throw std::invalid_argument("--n is for cam-shape alone: camlaw reproduce cam-shape --n 1000");
  }
  if (options.report) throw std::invalid_argument("--report goes with tables, not with --n");
  const auto n =
      problems::parse_integer(*options.n, problems::kLeastCamShape, problems::kMostCamShape, "--n");
  print(case_document(problems::solve_cam_shape(static_cast<int>(n))), options.json);
  return kDone;
}

int run_reproduce(const ReproduceOptions& options) {
  if (options.n) return run_size(options);
  std::vector<std::string> names = options.names;
  const bool json = options.json;
  keep_plain_outputs({options.report}, json);
  if (names.empty()) {
    for (const auto& system : problems::reproducible_systems()) names.push_back(system.name);
  }
  std::vector<problems::ReproducibleSystem> systems;
  for (const std::string& name : names) {
    systems.push_back(problems::find_reproducible(name));
    for (const std::string& file : systems.back().files) keep_input(file);
  }
  if (options.report) check_writable({*options.report});
  Json all = Json::array();
  std::vector<SystemReproduction> results;
  ProgressLine line(!json);
  const Interruptible interruptible;
  bool is_stopped = false;
  for (const problems::ReproducibleSystem& system : systems) {
    line.show(fmt::format("{}, {} of {}", system.name, results.size() + 1, systems.size()),
              static_cast<double>(results.size()) / static_cast<double>(systems.size()));
    try {
      results.push_back(system.reproduce(interruptible.flag()));
    } catch (const optim::Interrupted&) {
      line.clear();
      warn(fmt::format("stopped before {} was done", system.name));
      is_stopped = true;
      break;
    }
    line.clear();
    Document document = reproduction_document(results.back());
    if (systems.size() > 1) document.say("\n");
    if (json && results.back().is_shipped && system.name == "cam-shape")
      document.fact("cases", cam_shape_cases());
    if (!json) print(document, false);
    all.push_back(json_of(document));
  }
  Document end;
  end.take_list([all = std::move(all)] { return all; });
  if (systems.size() > 1) end.add(counts_table(results));
  print(end, json);
  if (options.report) {
    write_files({{*options.report, page_html(reproduction_report(results))}});
    if (!json) say_written({{*options.report, ""}});
  }
  if (is_stopped) return kNotSolved;
  return warn_of_worsened(results) ? kFailed : kDone;
}

}  // namespace

Command reproduce_command() {
  const auto options = std::make_shared<ReproduceOptions>();
  return {.name = "reproduce",
          .help = "Compute published tables again and explain the differences",
          .options = {{"SYSTEM", &options->names, takes::kSystem,
                       "systems to reproduce, or files of tables (all systems, if none is named)"},
                      json_switch(options->json),
                      {"--n", &options->n, takes::kNumber,
                       "cam-shape: solve it for this many radii instead"},
                      {"--report", &options->report, takes::kFile,
                       "write the tables as a page for the browser to this HTML file"}},
          .examples = {{"camlaw reproduce spine-cutter",
                        "the printed numbers, which agree, and what is behind those that do not"},
                       {"camlaw reproduce problems/published/die_press.toml",
                        "a table that is stated in a file, such as one of your own"},
                       {"camlaw reproduce cam-shape --n 1000",
                        "one case of the COPS cam, of any size"}},
          .run = [options] { return run_reproduce(*options); }};
}

}  // namespace camlaw::cli
