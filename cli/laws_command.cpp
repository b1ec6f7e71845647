// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>

#include "cli/commands.h"
#include "cli/law_json.h"
#include "cli/text_table.h"
#include "kinematics/limits.h"

namespace camlaw::cli {
namespace {

std::string parameter_list(const Family& family) {
  std::vector<std::string> names;
  for (const Parameter& p : family.parameters) {
    if (p.name == kCrossover) continue;
    names.push_back(p.list ? p.name + "..." : fmt::format("{}={:.4g}", p.name, p.standard.front()));
  }
  return fmt::format("{}", fmt::join(names, " "));
}

void print_catalogue() {
  TextTable table({{"law", TextTable::Align::Left},
                   {"parameters", TextTable::Align::Left},
                   {"ends", TextTable::Align::Left},
                   {"class", TextTable::Align::Left},
                   {"B"},
                   {"C+"},
                   {"C-"},
                   {"D+"},
                   {"D-"},
                   {"Cm"},
                   {"lambda"}});
  for (const Family& family : catalogue()) {
    const Law<double> law = family.make(family.standard());
    const auto peak = peaks(law);
    const auto lambda = limit_index(peak);
    const int smooth = continuity(law);
    table.add({family.name, parameter_list(family), to_string(law.ends()),
               smooth == kSmooth ? "smooth" : fmt::format("C{}", smooth), shown(peak.B(), 4),
               shown(peak.high(Quantity::Acceleration).value, 4),
               shown(peak.low(Quantity::Acceleration).value, 4),
               shown(peak.high(Quantity::Jerk).value, 3), shown(peak.low(Quantity::Jerk).value, 3),
               shown(peak.Cm(), 4), lambda ? shown(*lambda, 3) : "-"});
  }
  fmt::print(
      "{}\nConstants are those of the standard parameters. Every R-R law also takes crossover=c.\n"
      "'camlaw law NAME' tells more of one law.\n",
      table.text());
}

void print_json() {
  Json result = Json::array();
  for (const Family& family : catalogue()) {
    result.push_back(law_to_json({&family, family.standard()}));
  }
  fmt::print("{}\n", result.dump(2));
}

}  // namespace

void add_laws_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("laws", "List the motion laws with their constants");
  const auto json = std::make_shared<bool>(false);
  command->add_flag("--json", *json, "print JSON");
  command->callback([json] { *json ? print_json() : print_catalogue(); });
}

}  // namespace camlaw::cli
