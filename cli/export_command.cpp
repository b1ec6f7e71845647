// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <memory>

#include "cli/command.h"
#include "cli/export_options.h"
#include "cli/files.h"
#include "cli/inputs.h"
#include "output/answers/claim_output.h"
#include "output/answers/judged_words.h"
#include "output/answers/shop_export.h"
#include "output/document/printing.h"
#include "output/document/terminal.h"

namespace camlaw::cli {
namespace {

/// A study has many designs: says how one of them becomes a result.
[[noreturn]] void refuse_study(const std::string& file) {
  throw std::invalid_argument(
      fmt::format("{0}: a study has many designs; 'camlaw front {0} --knee --result FILE' writes "
                  "one of its designs as a result",
                  file));
}

int run_export(ExportOptions options) {
  keep_plain_outputs({options.out}, options.json);
  if (options.json && !options.out) {
    throw std::invalid_argument("--json reports on the file that was written, so it needs --out");
  }
  const FormatRow& format = format_of(options);
  check_options(options, format);
  if (ending_of(options.file) == ".db") refuse_study(options.file);
  keep_input(options.file);
  problems::ReadDesign design = problems::read_design_file(options.file);
  keep_inputs(design, options.file);
  const ClaimReview review = reviewed(design);
  say_review(options.file, review);
  problems::set_in_design(design.statement, design, options.settings);
  take_bore(options, design.statement);
  const std::vector<std::string> words = record_words(design, review);
  TakenCam taken = take_cam(options.cam, options.file, "--cam {}", options.slave, design.statement);
  const problems::ProblemStatement shown = design.statement;
  const ExportedText written =
      exported_text(options, format, std::move(design), words, std::move(taken));
  say_first_law(options.file, shown);
  if (!options.out || (is_quiet() && !options.json)) {
    for (const std::string& limit : written.unmet) warn(fmt::format("{}: {}", options.file, limit));
  }
  if (!options.out) {
    print_data(written.text);
    return status_of(review);
  }
  flush_printed();
  write_files({{*options.out, written.text}});
  if (options.json || !is_quiet()) print(written.about, options.json);
  if (!options.json) say_written({{*options.out, ""}});
  return status_of(review);
}

}  // namespace

Command export_command() {
  const auto options = std::make_shared<ExportOptions>();
  return {.name = "export",
          .help = "Export a cam's curves, motion or law for CAD, machining and drives",
          .options = export_options(*options),
          .examples =
              {{"camlaw export problems/cams/roller_least_base.toml --format dxf --out cam.dxf",
                "the profile as a drawing for CAD"},
               {"camlaw export problems/cams/roller_least_base.toml --format table --step '1 deg' "
                "--out table.csv",
                "a table, degree by degree"}},
          .run = [options] { return run_export(*options); }};
}

}  // namespace camlaw::cli
