// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "cli/commands.h"
#include "cli/files.h"
#include "cli/study_output.h"

namespace camlaw::cli {
namespace {

struct StudyOptions {
  std::string system;
  std::optional<std::string> out;
  std::vector<std::string> settings;
  bool json = false;
};

void run_study(const StudyOptions& options) {
  if (options.system != "spine-cutter") {
    throw std::invalid_argument(
        fmt::format("no study is called '{}'; there is spine-cutter", options.system));
  }
  SpineCutter<double> cutter;
  for (const std::string& setting : options.settings) problems::set_given(cutter, setting);
  const auto study = problems::study_spine_cutter(cutter);
  std::vector<OutputFile> files;
  if (options.out) {
    if (options.out->empty()) throw std::invalid_argument("--out: a folder's name is wanted");
    const std::filesystem::path out = *options.out;
    files = {{out / "study.csv", study_csv(study)},
             {out / "study.json", study_json(study)},
             {out / "trade_off.svg", to_svg(trade_off_figure(study))},
             {out / "motion.svg", to_svg(study_motion_figure(study))}};
    write_files(files);
  }
  fmt::print("{}", options.json ? study_json(study) : study_text(study));
  if (options.json || files.empty()) return;
  fmt::print("\nresults\n");
  for (const OutputFile& file : files) fmt::print("  {}\n", file.path.string());
}

}  // namespace

void add_study_command(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("study", "Compare all laws on a machine: table and pictures");
  const auto options = std::make_shared<StudyOptions>();
  command->add_option("SYSTEM", options->system, "the machine: spine-cutter")->required();
  command->add_option("--out", options->out, "folder for study.csv, study.json and the pictures");
  command
      ->add_option("--set", options->settings, "set a given: name=value, such as --set 'h=0.8 mm'")
      ->allow_extra_args(false);
  add_switch(*command, "--json", options->json, "print JSON");
  command->callback([options] { run_study(*options); });
}

}  // namespace camlaw::cli
