// SPDX-License-Identifier: MIT
#include "problems/results/design_json.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "problems/law_files/json_text.h"
#include "problems/statement/held_files.h"

namespace camlaw::problems {
namespace {

namespace fs = std::filesystem;

/// Where the problem's file stands; empty where it was read from no file.
std::string path_of_problem(const ProblemStatement& problem) {
  std::error_code ignored;
  if (!fs::is_regular_file(problem.source, ignored)) return "";
  return fs::absolute(problem.source).lexically_normal().string();
}

}  // namespace

Json recorded_design(const BoundProblem& bound, const std::vector<std::size_t>& options,
                     optim::Design x) {
  const ProblemStatement& problem = bound.statement();
  const bool finite = std::all_of(x.begin(), x.end(), [](double v) { return std::isfinite(v); });
  if (!finite || options.size() != bound.choices().size() ||
      x.size() != bound.problem(options).variables.size()) {
    return nullptr;
  }
  Json variables = Json::object();
  const ProblemStatement found = bound.at(options, x);
  for (const VariableStatement& v : found.variables) variables[v.name] = v.start;
  Json design = {
      {"source", fs::path(problem.source).filename().string()},
      {"problem", problem.text},
      {"set", problem.settings},
      {"law_files", laws_to_json(problem.files.laws)},
      {"law", problem.chooses_law() ? Json(problem.laws[options.front()].name()) : Json(nullptr)},
      {"variables", std::move(variables)}};
  if (const std::string path = path_of_problem(problem); !path.empty()) design["path"] = path;
  if (!problem.files.tables.empty()) design["tables"] = problem.files.tables;
  for (const PartStatement& part : found.parts) {
    design["parts"][part.name] = part.items[part.start].name;
  }
  return design;
}

}  // namespace camlaw::problems
