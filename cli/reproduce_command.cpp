// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <optional>

#include "cli/commands.h"
#include "cli/files.h"
#include "cli/progress_line.h"
#include "output/answers/law_json.h"
#include "output/document/printing.h"
#include "output/document/text_table.h"
#include "output/report/report.h"
#include "problems/published/cam_shape/solve.h"
#include "problems/published/systems.h"
#include "problems/statement/solver_settings.h"

namespace camlaw::cli {
namespace {

using problems::SystemReproduction;

std::string counts(const SystemReproduction& result) {
  return fmt::format("{} values: {} reproduced, {} explained, {} unexplained", result.values.size(),
                     result.reproduced, result.explained, result.unexplained);
}

void print_system(const SystemReproduction& result) {
  say("{}: {}\n{}\n\n", result.system, result.title, result.source);
  TextTable table({{"value", TextTable::Align::Left},
                   {"printed"},
                   {"unit", TextTable::Align::Left},
                   {"as stated"},
                   {"with all departures"},
                   {"verdict", TextTable::Align::Left},
                   {"needs", TextTable::Align::Left}});
  for (const auto& value : result.values) {
    const int decimals = value.printed.number.decimals;
    const bool explained = value.verdict == optim::Finding::Explained;
    table.add({value.printed.id, optim::as_printed(value.printed.number.value, decimals),
               value.printed.unit, shown(value.stated_value, decimals + 2),
               explained ? shown(value.explained_value, decimals + 2) : "",
               std::string(problems::to_string(value.verdict)),
               fmt::format("{}", fmt::join(value.causes, "; "))});
  }
  if (!result.values.empty()) say("{}\n", table.text());
  if (!result.departures.empty()) {
    say("the smallest set of departures that explains the most digits ({} sets looked at):\n",
        result.tried);
    for (const std::string& departure : result.departures) say("  {}\n", departure);
  }
  for (const auto& other : result.equals) {
    say("another set explains as many: {}\n", fmt::join(other, "; "));
  }
  if (!result.departures.empty() && result.equals.empty()) {
    say("no other set as small explains as many\n");
  }
  for (const std::string& note : result.notes) say("{}\n", note);
  say("{}\n", counts(result));
}

/// One line for each of several systems.
void print_counts(const std::vector<SystemReproduction>& results) {
  TextTable table({{"system", TextTable::Align::Left},
                   {"values"},
                   {"reproduced"},
                   {"explained"},
                   {"unexplained"}});
  for (const auto& result : results) {
    table.add({result.system, fmt::format("{}", result.values.size()),
               fmt::format("{}", result.reproduced), fmt::format("{}", result.explained),
               fmt::format("{}", result.unexplained)});
  }
  print_text(table.text());
}

Json reproduction_json(const SystemReproduction& result) {
  Json values = Json::array();
  for (const auto& value : result.values) {
    values.push_back({{"id", value.printed.id},
                      {"quantity", value.printed.quantity},
                      {"law", value.printed.law},
                      {"condition", value.printed.condition},
                      {"place", value.printed.place},
                      {"printed", value.printed.number.value},
                      {"decimals", value.printed.number.decimals},
                      {"unit", value.printed.unit},
                      {"value", to_json(value.stated_value)},
                      {"explained_value", to_json(value.explained_value)},
                      {"verdict", problems::to_string(value.verdict)},
                      {"causes", value.causes}});
  }
  return {{"system", result.system},         {"title", result.title},
          {"source", result.source},         {"reproduced", result.reproduced},
          {"explained", result.explained},   {"unexplained", result.unexplained},
          {"departures", result.departures}, {"equal_sets", result.equals},
          {"notes", result.notes},           {"worsened", problems::worsened(result)},
          {"values", std::move(values)}};
}

const problems::ReproducibleSystem& find_system(const std::string& name) {
  std::vector<std::string> known;
  for (const auto& system : problems::reproducible_systems()) {
    if (system.name == name) return system;
    known.push_back(system.name);
  }
  throw std::invalid_argument(
      fmt::format("no system is called '{}'; there is {}", name, fmt::join(known, ", ")));
}

Json case_json(const problems::CamShapeCase& solved) {
  return {{"n", solved.n},
          {"printed", solved.printed ? Json(*solved.printed) : Json(nullptr)},
          {"objective", to_json(solved.objective)},
          {"true_optimum", solved.true_optimum},
          {"max_violation", to_json(solved.max_violation)},
          {"verdict", solved.verdict},
          {"reason", solved.reason},
          {"iterations", solved.iterations},
          {"wall_s", solved.wall_s}};
}

/// Every printed case.
Json cam_shape_cases() {
  Json cases = Json::array();
  for (const auto& printed : problems::printed_cam_shapes()) {
    cases.push_back(case_json(problems::solve_cam_shape(problems::points_of(printed))));
  }
  return cases;
}

/// One case of the cam-shape problem, of any size.
void run_cam_shape(int n, bool json) {
  const problems::CamShapeCase solved = problems::solve_cam_shape(n);
  if (json) {
    print_data(case_json(solved).dump(2) + "\n");
    return;
  }
  say("cam-shape, n = {}: {} ({})\n", solved.n, solved.verdict, solved.reason);
  if (solved.printed) say("printed        {:.10g}\n", *solved.printed);
  say("objective      {:.10f}\ntrue optimum   {:.10f}\nmax violation  {:.1e}\n"
      "{} iterations, {:.3g} s\n",
      solved.objective, solved.true_optimum, solved.max_violation, solved.iterations,
      solved.wall_s);
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
  run_cam_shape(static_cast<int>(n), options.json);
  return kDone;
}

int run_reproduce(const ReproduceOptions& options) {
  if (options.n) return run_size(options);
  std::vector<std::string> names = options.names;
  const bool json = options.json;
  keep_standard_output({options.report}, json);
  if (options.report) check_writable({*options.report});
  if (names.empty()) {
    for (const auto& system : problems::reproducible_systems()) names.push_back(system.name);
  }
  std::vector<const problems::ReproducibleSystem*> systems;
  for (const std::string& name : names) systems.push_back(&find_system(name));
  Json all = Json::array();
  std::vector<SystemReproduction> results;
  ProgressLine line(!json);
  for (const auto* system : systems) {
    line.show(fmt::format("{}, {} of {}", system->name, results.size() + 1, systems.size()),
              static_cast<double>(results.size()) / static_cast<double>(systems.size()));
    results.push_back(system->reproduce());
    line.clear();
    if (json) {
      all.push_back(reproduction_json(results.back()));
      if (system->name == "cam-shape") all.back()["cases"] = cam_shape_cases();
    } else {
      print_system(results.back());
      if (systems.size() > 1) say("\n");
    }
  }
  if (json) {
    print_data(all.dump(2) + "\n");
  } else if (systems.size() > 1) {
    print_counts(results);
  }
  if (options.report) {
    write_files({{*options.report, page_html(reproduction_report(results))}});
    if (!json) say_written({{*options.report, ""}});
  }
  return warn_of_worsened(results) ? kFailed : kDone;
}

}  // namespace

Command reproduce_command() {
  const auto options = std::make_shared<ReproduceOptions>();
  return {.name = "reproduce",
          .help = "Compute published tables again and explain the differences",
          .options = {{"SYSTEM", &options->names, takes::kSystem,
                       "systems to reproduce (all, if none is named)"},
                      json_switch(options->json),
                      {"--n", &options->n, takes::kNumber,
                       "cam-shape: solve it for this many radii instead"},
                      {"--report", &options->report, takes::kFile,
                       "write the tables as a page for the browser to this HTML file"}},
          .examples = {{"camlaw reproduce spine-cutter",
                        "the printed numbers, which agree, and what is behind those that do not"},
                       {"camlaw reproduce cam-shape --n 1000",
                        "one case of the COPS cam, of any size"}},
          .run = [options] { return run_reproduce(*options); }};
}

}  // namespace camlaw::cli
