// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <stdexcept>

#include "numerics/text/file_format.h"
#include "numerics/text/file_text.h"
#include "numerics/text/names.h"
#include "optim/study/record.h"
#include "problems/statement/advancing_cycle.h"
#include "problems/statement/law_rooms.h"
#include "problems/statement/problem_format.h"
#include "problems/statement/reading.h"
#include "problems/statement/toml_reader.h"

namespace camlaw::problems {

void read_motion(const Entry& file, ProblemStatement& problem, FixedNames& fixed) {
  read_laws(file, problem, fixed);
  read_constants(file, problem, fixed);
  read_parts(file, problem);
  read_variables(file, problem, fixed);
  read_free_variables(file, problem, fixed);
  read_tolerances(file, problem);
  check_laws_at_start(file, problem);
  located(file, [&] { check_advancing_cycle(problem); });
}

ProblemStatement read_problem(std::string_view toml, const std::string& source) {
  return read_problem(toml, source, HeldFiles());
}

ProblemStatement read_problem(std::string_view toml, const std::string& source, HeldFiles known) {
  return read_entries(parse_toml(toml, source), toml, source, std::move(known));
}

ProblemStatement read_entries(const Entry& file, std::string_view toml, const std::string& source,
                              HeldFiles known) {
  if (file.items.empty()) {
    refuse(file,
           "the file is empty; a problem file names at least a mechanism and its law or program");
  }
  check_keys(file, {"format",    "title",      "mechanism",   "machine", "cams",   "responses",
                    "constants", "law",        "free",        "program", "parts",  "variables",
                    "objective", "objectives", "constraints", "cases",   "ranges", "variation",
                    "buildable", "profile",    "solver"});
  if (const Entry* format = find(file, "format")) {
    const std::string& stated = text_of(*format);
    located(*format, [&] { kProblemFormat.check(stated); });
  }
  ProblemStatement problem;
  problem.source = source;
  problem.text = toml;
  problem.files = std::move(known);
  read_title(file, problem);
  FixedNames fixed;
  if (find(file, "cams") != nullptr) {
    read_cams(file, problem, fixed);
  } else {
    read_mechanism(file, problem);
    read_motion(file, problem, fixed);
  }
  read_cases(file, problem);
  read_ranges(file, problem);
  read_variation(file, problem);
  read_objectives(file, problem);
  read_constraints(file, problem);
  read_buildable(file, problem);
  read_profile_errors(file, problem);
  limit_to_laws(problem);
  read_solver(file, problem);
  return problem;
}

namespace {

/// What a JSON file says of itself, "camlaw result 1"; empty where it does not say.
std::string stated_format(std::string_view json) {
  constexpr std::string_view kKey = "\"format\"";
  const std::size_t key = json.find(kKey);
  if (key == std::string_view::npos) return "";
  const std::size_t begin = json.find('"', key + kKey.size());
  if (begin == std::string_view::npos) return "";
  return std::string(json.substr(begin + 1, json.find('"', begin + 1) - begin - 1));
}

/// Refuses files of other kinds that are easily taken for a problem file, and says what reads them.
void refuse_other_kinds(const std::string& path, std::string_view text) {
  const std::string_view content = trimmed(text, " \t\r\n");
  if (content.starts_with('<')) {
    throw std::invalid_argument(path + ": it is a page (HTML or XML), not a problem file");
  }
  if (content.starts_with('{')) {
    const std::string format = stated_format(content);
    if (format.starts_with("camlaw result")) {
      throw std::invalid_argument(
          fmt::format("{0}: it is a result, not a problem file; 'camlaw evaluate {0}' shows its "
                      "design, 'camlaw "
                      "verify {0}' checks its claim again",
                      path));
    }
    throw std::invalid_argument(path + ": it is JSON, not a problem file (TOML)");
  }
  if (path.ends_with(".csv")) {
    throw std::invalid_argument(fmt::format(
        "{0}: it is a table, not a problem file; 'camlaw fit {0}' reads tables of samples", path));
  }
}

}  // namespace

std::string text_of_file(const std::string& path, const std::string& what) {
  if (optim::begins_as_study(path)) {
    throw std::invalid_argument(
        fmt::format("{0}: it is a study, not a {1}; 'camlaw front {0} --point N --result FILE' "
                    "makes a result of a point of a front",
                    path, what));
  }
  return file_text(path, what);
}

std::string problem_text(const std::string& path) {
  std::string text = text_of_file(path, "problem file");
  refuse_other_kinds(path, text);
  return text;
}

ProblemStatement read_problem_file(const std::string& path) {
  return read_problem(problem_text(path), path);
}

}  // namespace camlaw::problems
