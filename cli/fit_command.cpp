// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>

#include "cli/commands.h"
#include "cli/files.h"
#include "cli/fit_output.h"
#include "problems/law_files/law_file.h"

namespace camlaw::cli {
namespace {

struct FitCommand {
  std::optional<std::string> data, constants, law, mechanism, loss, out;
  bool json = false;
};

optim::Loss loss_of(const std::string& name) {
  for (const auto& [known, loss] :
       {std::pair{"none", optim::Loss::None}, std::pair{"huber", optim::Loss::Huber},
        std::pair{"cauchy", optim::Loss::Cauchy}}) {
    if (name == known) return loss;
  }
  throw std::invalid_argument(
      fmt::format("--loss: no loss is called '{}'; there are none, huber, cauchy", name));
}

/// The law of --law; none where every law is tried.
std::optional<Member> law_of(const FitCommand& options) {
  if (!options.law || *options.law == "auto") return {};
  return problems::find_any_law(*options.law);
}

void fit_constants(const FitCommand& options) {
  for (const auto& [name, given] : {std::pair{"--loss", options.loss.has_value()},
                                    std::pair{"--out", options.out.has_value()}}) {
    if (!given) continue;
    throw std::invalid_argument(
        fmt::format("{}: it goes with a table of samples, not with --constants", name));
  }
  problems::ConstantsQuestion question{
      options.mechanism ? problems::read_problem_file(*options.mechanism) : problems::law_alone(),
      {}};
  question.constants = problems::parse_constants(*options.constants, *question.machine.mechanism);
  std::vector<problems::ConstantsFit> fits;
  if (const auto law = law_of(options)) {
    fits = problems::fit_constants(question, *law);
    if (fits.empty()) {
      throw std::invalid_argument(fmt::format(
          "--law {}: it prints none of these constants, whatever its coefficients", *options.law));
    }
  } else {
    fits = problems::rank_laws(question, problems::laws_to_try());
    if (fits.empty()) {
      throw std::invalid_argument(
          "--constants: no law of the catalogue explains them in fewer digits than are printed");
    }
  }
  fmt::print("{}", options.json ? constants_json(fits).dump(2) + "\n" : constants_text(fits));
}

void fit_samples(const FitCommand& options) {
  if (options.mechanism) {
    throw std::invalid_argument("--mechanism: it goes with --constants");
  }
  problems::LawFitOptions how;
  how.loss = loss_of(options.loss.value_or("none"));
  const auto law = law_of(options);
  const std::vector<Member> laws = law ? std::vector{*law} : problems::laws_to_try();
  if (options.out) check_writable({std::filesystem::path(*options.out) / "fit.json"});
  const problems::SampleTable table = problems::read_samples(*options.data);
  SamplesAnswer answer{*options.data, table.left_out, {}, {}};
  const problems::MotionSamples samples = problems::motion_samples(table);
  try {
    answer.cycle = problems::find_motions(samples);
    for (const problems::FoundMotion& motion : answer.cycle.motions) {
      answer.fits.push_back(problems::fit_motion(motion, laws, how));
    }
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("{}: {}", *options.data, error.what()));
  }
  const std::string json = samples_json(answer).dump(2) + "\n";
  fmt::print("{}", options.json ? json : samples_text(answer));
  if (!options.out) return;
  const std::filesystem::path out = *options.out;
  write_out({},
            {{out / "fit.json", json},
             {out / "law.json", samples_law(answer).dump(2) + "\n"},
             {out / "fit.svg", to_svg(samples_figure(answer))}},
            !options.json);
}

void run_fit(const FitCommand& options) {
  if (options.constants.has_value() == options.data.has_value()) {
    throw std::invalid_argument(
        "fit: give a table of samples, or printed constants, --constants \"B=1.6125,C=4.66\"");
  }
  options.data ? fit_samples(options) : fit_constants(options);
}

}  // namespace

void add_fit_command(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("fit", "Find the law behind measured samples or printed constants");
  const auto options = std::make_shared<FitCommand>();
  command->add_option("DATA", options->data,
                      "table with a header, such as \"angle [deg], lift [mm]\"");
  command->add_option("--constants", options->constants,
                      "what is printed, with its digits: \"B=1.6125, C=4.66\"");
  command->add_option("--law", options->law,
                      "a law whose coefficients are wanted; auto: every law");
  command->add_option("--mechanism", options->mechanism,
                      "a problem file: its responses can be printed constants, its variables are "
                      "unknown");
  command->add_option("--loss", options->loss,
                      "how much far-off samples count: none (all alike), huber or cauchy");
  add_switch(*command, "--json", options->json, "print JSON");
  command->add_option("--out", options->out,
                      "folder for fit.json, law.json (the law's own file) and fit.svg");
  command->callback([options] { run_fit(*options); });
}

}  // namespace camlaw::cli
