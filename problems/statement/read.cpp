// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "machines/registry.h"
#include "numerics/text/file_format.h"
#include "numerics/text/file_text.h"
#include "problems/statement/law_rooms.h"
#include "problems/statement/reading.h"
#include "problems/statement/toml_reader.h"

namespace camlaw::problems {
namespace {

constexpr FileFormat kProblemFormat{"camlaw problem", 1};

std::string known_mechanisms() {
  std::string names;
  for (const Mechanism& mechanism : mechanisms()) {
    names += (names.empty() ? "" : ", ") + mechanism.name;
  }
  return names;
}

/// Refuses what would do things to a terminal or break a line.
void check_printable(const Entry& entry) {
  for (std::size_t i = 0; i < entry.text.size(); ++i) {
    const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(entry.text[k]); };
    const bool c1 = byte(i) == 0xC2 && i + 1 < entry.text.size() && byte(i + 1) < 0xA0;
    if (byte(i) >= 0x20 && byte(i) != 0x7F && !c1) continue;
    refuse(entry, fmt::format("it has a control character, U+{:04X}; a title is one line of text",
                              c1 ? byte(i + 1) : byte(i)));
  }
}

}  // namespace

void read_mechanism(const Entry& file, ProblemStatement& problem) {
  const Entry* name = find(file, "mechanism");
  if (name == nullptr) {
    refuse(file, fmt::format("mechanism is missing; there are {}", known_mechanisms()));
  }
  const std::string& text = text_of(*name);
  problem.mechanism = located(*name, [&] { return &find_mechanism(text); });
  for (const MechanismParameter& parameter : problem.mechanism->parameters) {
    problem.constants.push_back(parameter.default_value);
  }
}

ProblemStatement read_problem(std::string_view toml, const std::string& source, LawFiles known) {
  const Entry file = parse_toml(toml, source);
  if (file.items.empty()) {
    refuse(file, "it is empty; a problem names at least its mechanism and law");
  }
  check_keys(file, {"format", "title", "mechanism", "constants", "law", "free", "program",
                    "variables", "objective", "objectives", "constraints", "solver"});
  if (const Entry* format = find(file, "format")) {
    const std::string& stated = text_of(*format);
    located(*format, [&] { kProblemFormat.check(stated); });
  }
  ProblemStatement problem;
  problem.source = source;
  problem.text = toml;
  problem.law_files = std::move(known);
  if (const Entry* title = find(file, "title")) {
    problem.title = text_of(*title);
    check_printable(*title);
  }
  FixedNames fixed;
  read_mechanism(file, problem);
  read_laws(file, problem, fixed);
  read_constants(file, problem, fixed);
  read_variables(file, problem, fixed);
  read_free_variables(file, problem, fixed);
  check_laws_at_start(file, problem);
  read_objectives(file, problem);
  read_constraints(file, problem);
  limit_to_laws(problem);
  read_solver(file, problem);
  return problem;
}

std::string problem_text(const std::string& path) { return file_text(path, "problem file"); }

ProblemStatement read_problem_file(const std::string& path) {
  return read_problem(problem_text(path), path);
}

}  // namespace camlaw::problems
