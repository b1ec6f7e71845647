// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>

#include "cli/commands.h"
#include "kinematics/limits.h"
#include "kinematics/shape.h"
#include "output/answers/law_json.h"
#include "output/document/document.h"
#include "output/document/formatting.h"
#include "output/document/printing.h"
#include "problems/law_files/law_file.h"

namespace camlaw::cli {
namespace {

std::string parameter_list(const Family& family) {
  std::vector<std::string> names;
  for (const Parameter& p : family.parameters) {
    if (p.name == kCrossover) continue;
    names.push_back(p.list ? p.name + "..."
                           : fmt::format("{}={:.4g}", p.name, p.default_value.front()));
  }
  return fmt::format("{}", fmt::join(names, " "));
}

void print_catalogue() {
  Table table{.columns = {words("law"), words("parameters"), words("ends"), words("class"),
                          numbers("C_v"), numbers("C_a+"), numbers("C_a-"), numbers("C_j+"),
                          numbers("C_j-"), numbers("C_Mdyn"), numbers("lambda")}};
  const auto add = [&](const Family& family) {
    const Law<double> law = family.make(family.defaults());
    const auto peak = peaks(law);
    const auto lambda = limit_index(peak);
    table.add({family.name, parameter_list(family), to_string(law.ends()),
               class_name(continuity(law)), shown(peak.max_velocity(), 4),
               shown(peak.high(Quantity::Acceleration).value, 4),
               shown(peak.low(Quantity::Acceleration).value, 4),
               shown(peak.high(Quantity::Jerk).value, 3), shown(peak.low(Quantity::Jerk).value, 3),
               shown(peak.max_dynamic_moment(), 4), lambda ? shown(*lambda, 3) : "-"});
  };
  for (const Family& family : catalogue()) add(family);
  for (const Member& law : problems::own_laws()) add(*law.family);
  say("{}\nConstants are those of the default parameters. Every R-R law also takes crossover=c.\n"
      "'camlaw law NAME' tells more of one law. Law files in the folder that {} names are laws "
      "too.\n",
      text_of(table), problems::kOwnLaws);
}

std::string ranges(const Family& family) {
  std::vector<std::string> lines;
  for (const Parameter& p : family.parameters) {
    if (p.name == kCrossover) continue;
    const std::string unit = p.unit == "1" ? "" : " " + p.unit;
    lines.push_back(fmt::format("`{}`{} {:g} .. {:g}{}: {}", p.name, p.list ? " (list)" : "", p.low,
                                p.high, unit, p.meaning));
  }
  return fmt::format("{}", fmt::join(lines, "<br>"));
}

/// The page docs/laws.md.
void print_law_page() {
  say("# Motion laws\n\nPrinted by `camlaw laws --markdown` from the catalogue in the code. "
      "Constants "
      "are those of the default\nparameters; every R-R law also takes `crossover` (0.02 .. 0.98), "
      "where its acceleration changes sign.\n\n"
      "| law | also called | formula | parameters | ends | class | C_v | C_a+ | C_a- | C_j+ | C_j- "
      "| C_Mdyn | "
      "source |\n|---|---|---|---|---|---|--:|--:|--:|--:|--:|--:|---|\n");
  for (const Family& family : catalogue()) {
    const Law<double> law = family.make(family.defaults());
    const auto peak = peaks(law);
    say("| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", family.name,
        fmt::join(family.aliases, ", "), markdown_cell(family.formula), ranges(family),
        to_string(law.ends()), class_name(continuity(law)), shown(peak.max_velocity(), 6),
        shown(peak.high(Quantity::Acceleration).value, 6),
        shown(peak.low(Quantity::Acceleration).value, 6), shown(peak.high(Quantity::Jerk).value, 5),
        shown(peak.low(Quantity::Jerk).value, 5), shown(peak.max_dynamic_moment(), 6),
        markdown_cell(family.source));
  }
}

void print_laws_json() {
  Json result = Json::array();
  for (const Family& family : catalogue()) {
    result.push_back(law_to_json({&family, family.defaults()}));
  }
  for (const Member& law : problems::own_laws()) result.push_back(law_to_json(law));
  print_data(result.dump(2) + "\n");
}

}  // namespace

Command laws_command() {
  struct Options {
    bool json = false, markdown = false;
  };
  const auto options = std::make_shared<Options>();
  return {.name = "laws",
          .help = "List the motion laws with their constants",
          .options = {json_switch(options->json),
                      {.names = "--markdown",
                       .target = &options->markdown,
                       .takes = {},
                       .help = "print the page docs/laws.md",
                       .excludes = "--json"}},
          .examples = {{"camlaw laws", "the table of laws and their constants"},
                       {"camlaw laws --json", "with every digit, formula and source"}},
          .run = [options] {
            options->json       ? print_laws_json()
            : options->markdown ? print_law_page()
                                : print_catalogue();
            return kDone;
          }};
}

}  // namespace camlaw::cli
