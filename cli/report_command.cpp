// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

#include "cli/claim_output.h"
#include "cli/commands.h"
#include "cli/files.h"
#include "cli/help.h"
#include "cli/inputs.h"
#include "cli/printing.h"
#include "cli/report/report.h"
#include "problems/fronts/stored_front.h"
#include "problems/results/recorded_design.h"
#include "problems/statement/file_text.h"

namespace camlaw::cli {
namespace {

struct ReportOptions {
  std::string input;
  std::optional<std::string> output;
  std::vector<std::string> settings;
};

/// What a result says of the search that found it.
Facts facts_of(const std::string& result) {
  const Json said = problems::parse_json(problems::file_text(result, "result"));
  Facts facts;
  const auto add = [&](const char* name, const char* key) {
    const auto at = said.find(key);
    if (at == said.end() || at->is_null()) return;
    facts.emplace_back(name, at->is_string() ? at->get<std::string>() : at->dump());
  };
  add("solver", "solver"), add("why", "why_solver"), add("seed", "seed"), add("starts", "starts");
  add("starts that agreed", "agreed"), add("combinations of choices", "combinations");
  add("evaluations", "evaluations");
  return facts;
}

/// A design with values of its own: what a result says of its search holds no longer.
problems::ReadDesign with_settings(const problems::ReadDesign& read,
                                   const std::vector<std::string>& settings) {
  problems::ReadDesign changed{read.problem};
  changed.statement = read.statement;
  problems::set_values(changed.statement, settings);
  return changed;
}

ReportPage design_page(const std::string& input, const std::vector<std::string>& settings,
                       int& status) {
  problems::ReadDesign read = problems::read_design_file(input);
  keep_inputs(read);
  const ClaimReview review = reviewed(read);
  if (!review.differences.empty()) status = kNotSolved;
  say_review(input, review);
  if (!settings.empty()) read = with_settings(read, settings);
  Facts facts = read.verdict ? facts_of(input) : Facts{};
  return design_report(
      {.read = std::move(read), .file = input, .facts = std::move(facts), .review = review});
}

ReportPage study_page(const std::string& file, int& status) {
  optim::StudyRecord record = optim::StudyRecord::read(file);
  const problems::FrontStudy study = problems::FrontStudy::of(record);
  keep_inputs(study.bound().statement());
  const problems::StoredFront stored = problems::stored_front(study, record);
  if (!stored.faults.empty()) status = kNotSolved;
  for (const std::string& note : stored.notes) warn(fmt::format("{}: {}", file, note));
  if (stored.front.points.empty()) {
    throw std::invalid_argument(
        fmt::format("{}: the study has no design to report on; 'camlaw front' says why", file));
  }
  return front_report(FrontAnswer{study, stored}, file);
}

ReportPage page_of(const std::string& input, const std::vector<std::string>& settings,
                   int& status) {
  const std::string extension = ending_of(input);
  if (extension == ".db" && !settings.empty()) {
    throw std::invalid_argument(
        "--set: a study's designs are what they are; pareto takes --set, and report with a problem "
        "file or a result");
  }
  if (extension == ".db") return study_page(input, status);
  if (extension == ".toml" || extension == ".json" || input == kStandardStream)
    return design_page(input, settings, status);
  throw std::invalid_argument(fmt::format(
      "{}: a report is made of a problem file (.toml), a result (.json) or a study (.db)", input));
}

/// Refuses to write a page under a name that says it is something else.
void check_ending(const std::filesystem::path& output) {
  const std::string ending = ending_of(output.string());
  if (ending == ".html" || ending == ".htm" || output == kStandardStream) return;
  throw std::invalid_argument(fmt::format(
      "--out: {}: a report is a page for the browser; .html and .htm are accepted endings",
      output.string()));
}

void run_report(const ReportOptions& options, int& status) {
  keep_standard_output({options.output});
  if (options.input == kStandardStream && !options.output) {
    throw std::invalid_argument("a report of standard input needs the page's name, --out FILE");
  }
  const std::filesystem::path output =
      options.output ? std::filesystem::path(*options.output)
                     : std::filesystem::path(options.input).replace_extension(".html");
  keep_input(options.input);
  check_writable({output});
  check_ending(output);
  const std::vector<OutputFile> files{
      {output, page_html(page_of(options.input, options.settings, status))}};
  write_files(files);
  say_written(files);
}

}  // namespace

void add_report_command(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand(
      "report", "Write a page for the browser about a design or a front: one HTML file");
  const auto options = std::make_shared<ReportOptions>();
  command
      ->add_option(
          "INPUT", options->input,
          "a problem file (.toml), at its own values, a result of 'camlaw optimize' (.json) or a "
          "study of 'camlaw pareto' (.db)")
      ->required()
      ->type_name(takes::kFile);
  add_set_option(*command, options->settings);
  command
      ->add_option("-o,--out", options->output,
                   "the HTML file; else beside the input, under its name")
      ->type_name(takes::kFile);
  add_examples(*command, {{"camlaw report problems/cams/roller_least_base.toml -o cam.html",
                           "the design at the file's own values, on one page"},
                          {"camlaw report results/front/study.db -o front.html",
                           "the front of a study, after 'camlaw pareto'"}});
  command->callback([options, &status] { run_report(*options, status); });
}

}  // namespace camlaw::cli
