// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "cli/commands.h"
#include "cli/fit_output.h"
#include "problems/law_files/law_file.h"

namespace camlaw::cli {
namespace {

struct FitCommand {
  std::optional<std::string> data, constants, law, mechanism;
  bool json = false;
};

/// The machine of --mechanism; without one the law alone.
problems::ProblemStatement machine_of(const FitCommand& options) {
  if (options.mechanism) return problems::read_problem_file(*options.mechanism);
  problems::ProblemStatement machine;
  machine.mechanism = &problems::find_mechanism("law");
  for (const auto& p : machine.mechanism->parameters) machine.constants.push_back(p.standard);
  return machine;
}

void fit_constants(const FitCommand& options) {
  problems::ConstantsQuestion question{machine_of(options), {}};
  question.constants = problems::parse_constants(*options.constants, *question.machine.mechanism);
  std::vector<problems::ConstantsFit> fits;
  if (options.law && *options.law != "auto") {
    fits = problems::fit_constants(question, problems::find_any_law(*options.law));
    if (fits.empty()) {
      throw std::invalid_argument(fmt::format(
          "--law {}: it prints none of these constants, whatever its coefficients", *options.law));
    }
  } else {
    fits = problems::rank_laws(question, problems::laws_to_try());
  }
  fmt::print("{}", options.json ? constants_json(fits).dump(2) + "\n" : constants_text(fits));
}

void run_fit(const FitCommand& options) {
  if (!options.constants) {
    throw std::invalid_argument("fit: give the printed constants, --constants \"B=1.6125,C=4.66\"");
  }
  fit_constants(options);
}

}  // namespace

void add_fit_command(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("fit", "Find the law, and its coefficients, behind printed constants");
  const auto options = std::make_shared<FitCommand>();
  command->add_option("--constants", options->constants,
                      "what is printed, with its digits: \"B=1.6125, C=4.66\"");
  command->add_option("--law", options->law,
                      "a law whose coefficients are wanted; auto: every law");
  command->add_option("--mechanism", options->mechanism,
                      "a problem file: its responses can be printed constants, its variables are "
                      "unknown");
  add_switch(*command, "--json", options->json, "print JSON");
  command->callback([options] { run_fit(*options); });
}

}  // namespace camlaw::cli
