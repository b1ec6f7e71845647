// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>

#include "cli/command.h"
#include "cli/files.h"
#include "cli/inputs.h"
#include "cli/progress_line.h"
#include "numerics/text/file_text.h"
#include "numerics/text/sha256.h"
#include "output/answers/claim_output.h"
#include "output/answers/comparison_output.h"
#include "output/answers/search_facts.h"
#include "output/document/printing.h"
#include "output/report/report.h"
#include "problems/fronts/stored_front.h"
#include "problems/results/recorded_design.h"
#include "problems/sweeps/stored_sweep.h"

namespace camlaw::cli {
namespace {

struct ReportOptions {
  std::vector<std::string> inputs;
  std::optional<std::string> output;
  std::vector<std::string> settings;
};

/// A design with values of its own: what a result says of its search holds no longer.
problems::ReadDesign with_settings(const problems::ReadDesign& read,
                                   const std::vector<std::string>& settings) {
  problems::ReadDesign changed{read.problem};
  changed.statement = read.statement;
  problems::set_in_design(changed.statement, read, settings);
  return changed;
}

/// The SHA-256 of an input as it stands on the disk.
std::string checksum_of(const std::string& input) {
  return sha256(problems::file_text(input, "problem file or a result"));
}

/// A file's name without its folders, which a line has no room for.
std::string name_of(const std::string& input) {
  return std::filesystem::path(input).filename().string();
}

/// What is claimed of a design, judged again.
ClaimReview claim_of(const problems::ReadDesign& read, const std::string& input) {
  const ProgressLine line(true, "report: judging " + name_of(input));
  return reviewed(read);
}

/// A page, and whether what it tells of a file was found as it is claimed there.
struct JudgedPage {
  ReportPage page;
  int status;
};

JudgedPage design_page(const std::string& input, const std::vector<std::string>& settings) {
  problems::ReadDesign read = problems::read_design_file(input);
  keep_inputs(read, input);
  const ClaimReview review = claim_of(read, input);
  say_review(input, review);
  if (!settings.empty()) read = with_settings(read, settings);
  Facts facts;
  if (read.verdict) {
    facts = facts_of_search(problems::parse_json(problems::file_text(input, "result")));
  }
  ProgressLine line(true);
  const auto progress = [&line](const std::string& what, double done) {
    line.show("report: " + what, done);
  };
  return {design_report({.read = std::move(read),
                         .file = input,
                         .facts = std::move(facts),
                         .review = review,
                         .checksum = checksum_of(input),
                         .settings = settings,
                         .progress = progress}),
          status_of(review)};
}

JudgedPage sweep_page(optim::StudyRecord& record, const std::string& file) {
  const problems::SweepStudy study = problems::SweepStudy::of(record.settings());
  keep_recorded(study.statement(), file);
  const problems::StoredSweep stored = [&] {
    const ProgressLine line(true, "report: judging the designs of the study");
    return problems::stored_sweep(study, record);
  }();
  SweepAnswer answer(study, stored.sweep);
  answer.notes = stored.notes;
  for (const std::string& note : stored.notes) warn(fmt::format("{}: {}", file, note));
  const bool is_whole = stored.faults.empty() && !answer.is_stopped;
  const ProgressLine line(true, "report: the map of the sweep");
  return {sweep_report(answer, file), is_whole ? kDone : kNotSolved};
}

JudgedPage study_page(const std::string& file) {
  optim::StudyRecord record = optim::StudyRecord::read(file);
  if (problems::SweepStudy::is_sweep(record.settings())) return sweep_page(record, file);
  const problems::FrontStudy study = problems::FrontStudy::of(record);
  keep_recorded(study.bound().statement(), file);
  const problems::StoredFront stored = [&] {
    const ProgressLine line(true, "report: judging the points of the study");
    return problems::stored_front(study, record);
  }();
  for (const std::string& note : stored.notes) warn(fmt::format("{}: {}", file, note));
  if (stored.front.points.empty()) {
    throw std::invalid_argument(
        fmt::format("{}: the study has no design to report on; 'camlaw front' says why", file));
  }
  const ProgressLine line(true, "report: curves of the points");
  return {front_report(FrontAnswer{study, stored}, file), status_of(stored)};
}

bool is_design(const std::string& input) {
  const std::string extension = ending_of(input);
  return extension == ".toml" || extension == ".json";
}

/// Refuses an input of which no report is made.
void check_kind(const std::string& input) {
  const std::string extension = ending_of(input);
  if (extension == ".db" || is_design(input) || input == kStandardStream) return;
  const bool is_page = extension == ".html" || extension == ".htm";
  throw std::invalid_argument(
      fmt::format("{}: {}a report is made from a problem file (.toml), a result (.json) or a study "
                  "(.db)",
                  input, is_page ? "this is a page, which may be a report already; " : ""));
}

JudgedPage page_of(const std::string& input, const std::vector<std::string>& settings) {
  const std::string extension = ending_of(input);
  if (extension == ".db" && !settings.empty()) {
    throw std::invalid_argument(
        "--set cannot change a study's designs; use it with 'camlaw pareto', or report on a "
        "problem file or a result");
  }
  if (extension == ".db") return study_page(input);
  return design_page(input, settings);
}

/// Refuses what cannot be put side by side.
void check_compared(const ReportOptions& options) {
  if (options.inputs.size() > kMostCompared) {
    throw std::invalid_argument(
        fmt::format("a comparison takes at most {} results, and {} are named", kMostCompared,
                    options.inputs.size()));
  }
  if (!options.settings.empty()) {
    throw std::invalid_argument("--set changes one design; a comparison takes results as they are");
  }
  for (const std::string& input : options.inputs) {
    if (is_design(input)) continue;
    throw std::invalid_argument(
        fmt::format("{}: a comparison needs results (.json) or problem files (.toml)", input));
  }
}

JudgedPage comparison_page(const std::vector<std::string>& inputs) {
  std::vector<ComparedDesign> designs;
  std::vector<std::string> checksums;
  int status = kDone;
  for (const std::string& input : inputs) {
    problems::ReadDesign read = problems::read_design_file(input);
    keep_inputs(read, input);
    ClaimReview review = claim_of(read, input);
    say_review(input, review);
    if (status_of(review) != kDone) status = status_of(review);
    const ProgressLine line(true, "report: proofs of " + name_of(input));
    DesignReview judged(read);
    designs.push_back({std::string(1, static_cast<char>('A' + designs.size())), input,
                       std::move(read), std::move(review), std::move(judged)});
    checksums.push_back(checksum_of(input));
  }
  const ProgressLine line(true, "report: curves of all designs");
  return {comparison_report(designs, checksums), status};
}

/// Refuses to write a page under a name that says it is something else.
void check_ending(const std::filesystem::path& output) {
  const std::string ending = ending_of(output.string());
  if (ending == ".html" || ending == ".htm" || output == kStandardStream) return;
  throw std::invalid_argument(
      fmt::format("--out: {}: a report is a page for the browser, whose name ends in .html or .htm",
                  output.string()));
}

/// The page beside its input, or, of several, beside the first.
std::filesystem::path usual_output(const std::vector<std::string>& inputs) {
  const std::filesystem::path first(inputs.front());
  return inputs.size() > 1 ? first.parent_path() / "comparison.html"
                           : std::filesystem::path(first).replace_extension(".html");
}

/// A page that the user has not named replaces what camlaw wrote there, and nothing else.
void keep_other_page(const std::filesystem::path& output) {
  std::error_code ignored;
  if (!std::filesystem::exists(output, ignored)) return;
  std::ifstream stream(output, std::ios::binary);
  const std::string there{std::istreambuf_iterator<char>(stream), {}};
  if (there.empty() || is_unchanged_page(there)) return;
  throw RefusedOutput(
      fmt::format("'{}' is not a page of camlaw, or was changed since, and would be replaced; name "
                  "the page with --out FILE, or move that file away",
                  output.string()));
}

int run_report(const ReportOptions& options) {
  keep_standard_output({options.output});
  const bool is_comparison = options.inputs.size() > 1;
  if (is_comparison) check_compared(options);
  if (options.inputs.front() == kStandardStream && !options.output) {
    throw std::invalid_argument("a report on standard input needs the page's name, --out FILE");
  }
  const std::filesystem::path output =
      options.output ? std::filesystem::path(*options.output) : usual_output(options.inputs);
  for (const std::string& input : options.inputs) {
    check_kind(input);  // before the page's name, which would be that of a page given as input
    keep_input(input);
  }
  check_writable({output});
  check_ending(output);
  if (!options.output) keep_other_page(output);
  const JudgedPage judged = is_comparison ? comparison_page(options.inputs)
                                          : page_of(options.inputs.front(), options.settings);
  if (!options.output) keep_other_page(output);
  const std::vector<OutputFile> files{{output, page_html(judged.page)}};
  write_files(files);
  say_written(files);
  return judged.status;
}

}  // namespace

Command report_command() {
  const auto options = std::make_shared<ReportOptions>();
  return {
      .name = "report",
      .help =
          "Write a page for the browser about a design, a front or a sweep, or comparing designs",
      .options =
          {{.names = "INPUT",
            .target = &options->inputs,
            .takes = takes::kFile,
            .help = "a problem file (.toml), at its own values, a result of 'camlaw "
                    "optimize' (.json) or a study of 'camlaw pareto' or 'camlaw sweep' (.db); "
                    "two to four problem files or results are compared on one page",
            .required = true},
           set_option(options->settings),
           {"-o,--out", &options->output, takes::kFile,
            "the HTML file; one of this name is replaced (by default next to the input, with "
            "its name; for several inputs comparison.html next to the first; there only "
            "camlaw's own page is replaced)"}},
      .examples = {{"camlaw report problems/cams/roller_least_base.toml -o cam.html",
                    "the design at the file's own values, on one page"},
                   {"camlaw report problems/cams/roller_least_base.toml "
                    "problems/cams/flat_least_base.toml -o both.html",
                    "two cams side by side: what was found, margins, profiles, curves"},
                   {"camlaw report results/front/study.db -o front.html",
                    "the front of a study, after 'camlaw pareto'"}},
      .run = [options] { return run_report(*options); }};
}

}  // namespace camlaw::cli
