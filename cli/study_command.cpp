// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "cli/command.h"
#include "cli/files.h"
#include "cli/progress_line.h"
#include "optim/crew/crew.h"
#include "output/answers/delivery_study.h"
#include "output/answers/study_fronts.h"
#include "output/answers/study_output.h"
#include "output/document/printing.h"

namespace camlaw::cli {
namespace {

struct StudyOptions {
  std::string system;
  std::optional<std::string> out;
  std::vector<std::string> settings;
  bool json = false, table = false;
};

/// What a study prints and writes.
struct StudyOutput {
  Document answer;
  std::vector<OutputFile> files;
};

StudyOutput study_cutter(const StudyOptions& options, const std::filesystem::path& out) {
  problems::CutterGivens cutter;
  for (const std::string& setting : options.settings) problems::set_given(cutter, setting);
  const auto study = problems::study_spine_cutter(cutter);
  Figure trade_off = trade_off_figure(study);
  Document answer;
  std::vector<OutputFile> files{{out / "study.csv", csv_of(study_table(study))}};
  if (!options.table) {
    ProgressLine line(!options.json);
    const auto fronts = problems::prove_fronts(
        cutter, optim::usual_workers(), [&line](const std::string& front, double done) {
          line.show(fmt::format("front of {}, {:.0f} %", front, 100 * done), done);
        });
    line.clear();
    draw_fronts(fronts, trade_off.panels.front());
    answer.add(fronts_document(fronts));
    answer.say("\n");
    files.push_back({out / "fronts.csv", csv_of(fronts_table(fronts))});
  }
  answer.add(study_document(study));
  files.push_back({out / "study.json", json_text(answer)});
  files.push_back({out / "trade_off.svg", to_svg(trade_off)});
  files.push_back({out / "motion.svg", to_svg(study_motion_figure(study))});
  return {std::move(answer), std::move(files)};
}

StudyOutput study_delivery(const StudyOptions& options, const std::filesystem::path& out) {
  if (!options.settings.empty()) {
    throw std::invalid_argument("--set: the study of the sheet delivery has no inputs to set");
  }
  const auto choices = problems::trade_off_sheet_delivery();
  const Document answer = delivery_document(choices);
  return {answer,
          {{out / "study.csv", csv_of(delivery_table(choices))},
           {out / "study.json", json_text(answer)},
           {out / "trade_off.svg", to_svg(delivery_figure(choices))}}};
}

int run_study(const StudyOptions& options) {
  check_folder(options.out);
  const std::filesystem::path out = options.out.value_or("");
  const bool is_cutter = options.system == "spine-cutter";
  if (!is_cutter && options.system != "sheet-delivery") {
    throw std::invalid_argument(
        fmt::format("'{}' is not a study; use spine-cutter or sheet-delivery", options.system));
  }
  std::vector<std::filesystem::path> possible{out / "study.csv", out / "study.json",
                                              out / "trade_off.svg"};
  if (is_cutter) possible.push_back(out / "motion.svg");
  const std::filesystem::path fronts = out / "fronts.csv";
  if (is_cutter && !options.table) possible.push_back(fronts);
  if (options.out) check_out(possible, {fronts});
  const StudyOutput study = is_cutter ? study_cutter(options, out) : study_delivery(options, out);
  print(study.answer, options.json);
  possible.push_back(fronts);
  if (options.out) write_out(possible, study.files, !options.json);
  return kDone;
}

}  // namespace

Command study_command() {
  const auto options = std::make_shared<StudyOptions>();
  return {.name = "study",
          .help = "Compare laws on a published machine: a table and pictures",
          .options = {{.names = "SYSTEM",
                       .target = &options->system,
                       .takes = "{spine-cutter,sheet-delivery}",
                       .help = "the machine: spine-cutter or sheet-delivery",
                       .required = true},
                      {"-o,--out", &options->out, takes::kFolder,
                       "folder for study.csv, study.json and the pictures"},
                      {"--set", &options->settings, takes::kSetting,
                       "set an input: name=value, such as --set 'h=0.8 mm'"},
                      {"--table", &options->table, takes::kNothing,
                       "spine cutter: only the table of laws, without the proved fronts"},
                      json_switch(options->json)},
          .examples = {{"camlaw study spine-cutter --out results/spine-cutter",
                        "laws compared on the spine cutter, with proved fronts and pictures"},
                       {"camlaw study spine-cutter --table --set 'h=1.0 mm' --set 'V=1.2 m/s'",
                        "the table alone, for another depth and speed"},
                       {"camlaw study sheet-delivery --out results/delivery",
                        "what a delivery's laws cost, and what they gain"}},
          .run = [options] { return run_study(*options); }};
}

}  // namespace camlaw::cli
