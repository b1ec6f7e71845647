// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <stdexcept>

#include "numerics/text/file_format.h"
#include "numerics/text/file_text.h"
#include "optim/study/record.h"
#include "problems/statement/advancing_cycle.h"
#include "problems/statement/law_rooms.h"
#include "problems/statement/problem_format.h"
#include "problems/statement/reading.h"
#include "problems/statement/toml_reader.h"

namespace camlaw::problems {
namespace {}  // namespace

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
    refuse(file, "it is empty; a problem names at least its mechanism and law");
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

std::string text_of_file(const std::string& path, const std::string& what) {
  if (optim::begins_as_study(path)) {
    throw std::invalid_argument(
        fmt::format("{0}: it is a study, not a {1}; 'camlaw front {0} --point N --result FILE' "
                    "makes a result of a point of a front",
                    path, what));
  }
  return file_text(path, what);
}

std::string problem_text(const std::string& path) { return text_of_file(path, "problem file"); }

ProblemStatement read_problem_file(const std::string& path) {
  return read_problem(problem_text(path), path);
}

}  // namespace camlaw::problems
