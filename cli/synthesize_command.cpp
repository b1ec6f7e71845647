// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "cli/command.h"
#include "cli/search_outputs.h"
#include "cli/search_run.h"
#include "kinematics/program/segment_merits.h"
#include "output/answers/rulers.h"
#include "output/document/printing.h"
#include "problems/law_files/law_file.h"

namespace camlaw::cli {
namespace {

void check_free(const problems::ProblemStatement& statement) {
  if (!statement.cams.empty()) {
    throw std::invalid_argument(statement.source +
                                ": there are several cams on the shaft, and a law is measured for "
                                "one machine; 'camlaw optimize' finds free laws of several");
  }
  if (statement.mechanism->moved_by == problems::MovedBy::Program) {
    if (!free_segments(statement).empty()) return;
    throw std::invalid_argument(statement.source +
                                ": no segment's law is free; write law = \"free\" in a segment");
  }
  const bool free = std::any_of(statement.laws.begin(), statement.laws.end(),
                                [](const Member& law) { return bool(law.family->listed); });
  if (free) return;
  throw std::invalid_argument(statement.source +
                              ": no law of the problem is free; write [law] name = \"free\"");
}

/// Where a law's file comes from.
Json provenance(const Answer& answer) {
  const problems::ProblemStatement& statement = answer.bound.statement();
  const optim::Assessment& a = answer.optimum.found.assessment;
  return {{"problem", std::filesystem::path(statement.source).filename().string()},
          {"title", statement.title},
          {"verdict", std::string(optim::to_string(a.verdict))},
          {"objective", statement.objectives.front().response.name},
          {"value", to_json(a.objective.value)},
          {"unit", answer.optimum.problem.objective().response.unit}};
}

/// Rulers are an addition: where they fail the answer stands without them.
Document measure(const Answer& answer, const optim::OptimiseOptions& rest, int workers) {
  Document document;
  document.fact("rulers", Json(nullptr));
  try {
    if (!free_segments(answer.bound.statement()).empty()) {
      document.add("rulers", segment_rulers(answer));
      return document;
    }
    if (const auto measured = rulers(answer, rest, workers)) {
      document.add("rulers", rulers_document(answer, *measured));
    }
  } catch (const std::exception& error) {
    document.say(fmt::format("\nthe law is not measured: {}\n", error.what()));
  }
  return document;
}

/// A law's own file, as far as it can be read again.
OutputFile law_json(const Answer& answer, const Law<double>& law, const std::string& label,
                    const std::filesystem::path& file) {
  const std::string& stated = answer.bound.statement().title;
  const std::string title = stated.empty() ? label : stated;
  std::string text = problems::law_text(law, title, provenance(answer).dump());
  problems::check_law_text(text);
  return {file, std::move(text)};
}

/// The files of the laws that were free: of a motion program one for each such segment.
std::vector<OutputFile> law_files(const Answer& answer, const Member& law,
                                  const std::filesystem::path& out) {
  const std::vector<std::string> free = free_segments(answer.bound.statement());
  if (free.empty()) return {law_json(answer, law.law(), law.label(), out / "law.json")};
  std::vector<OutputFile> files;
  for (const SegmentMerits& segment : segment_merits(law)) {
    if (std::find(free.begin(), free.end(), segment.name) == free.end() || !segment.law) continue;
    files.push_back(law_json(answer, *segment.law, segment.name, out / (segment.name + ".json")));
  }
  return files;
}

std::vector<OutputFile> figures(const Answer& answer, const std::filesystem::path& out) {
  std::vector<OutputFile> files = answer_files(answer, out);
  const auto law = answer.law();
  if (!law) return files;
  try {
    for (OutputFile& file : law_files(answer, *law, out)) files.push_back(std::move(file));
  } catch (const std::invalid_argument& error) {
    warn(fmt::format("no law file is written: a law could not be read back: {}", error.what()));
  }
  return files;
}

/// Beside the files that each problem may have: those of a motion program's free segments.
std::vector<std::string> segment_files(const problems::ProblemStatement& statement) {
  std::vector<std::string> files = free_segments(statement);
  for (std::string& name : files) name += ".json";
  return files;
}

}  // namespace

Command synthesize_command() {
  const auto options = std::make_shared<SearchOptions>();
  const SearchCommand synthesize{
      .files = {"result.json", "law.csv", "law.svg", "cycle.svg", "law.json"},
      .more_files = segment_files,
      .check = check_free,
      .measure = measure,
      .figures = figures};
  return {
      .name = "synthesize",
      .help = "Find the best law there is for a problem file",
      .options = search_options(*options,
                                "result.json, law.json (the law's own file; of a motion program "
                                "SEGMENT.json for each free one), law.csv, law.svg and cycle.svg"),
      .examples = {{"camlaw synthesize problems/free_law/least_acceleration_at_jerk.toml --out "
                    "results/free",
                    "the best law there is for a limit on jerk, measured, as a file"},
                   {"camlaw law results/free/law.json", "the law that was found, like any other"}},
      .run = [options, synthesize] { return run_search(*options, synthesize); }};
}

}  // namespace camlaw::cli
