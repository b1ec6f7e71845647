// SPDX-License-Identifier: MIT
#include "output/answers/check_output.h"

#include <fmt/format.h>

#include <optional>
#include <stdexcept>

#include "optim/problem/check_derivatives.h"
#include "output/answers/optimum_output.h"
#include "output/answers/shape_output.h"
#include "output/answers/warnings.h"
#include "output/document/formatting.h"
#include "problems/statement/bind.h"

namespace camlaw::cli {
namespace {

using problems::BoundProblem, problems::ProblemStatement;

/// The first combination with each law, and each objective.
class Variants {
 public:
  explicit Variants(BoundProblem bound) : bound_(std::move(bound)) {}

  std::size_t size() const { return count_of_laws() * objectives().size(); }
  std::string law(std::size_t i) const {
    return has_laws() ? choices().front().options[i % count_of_laws()] : "";
  }
  const std::string& objective(std::size_t i) const {
    return objectives()[i / count_of_laws()].response.name;
  }
  optim::Problem problem(std::size_t i) const {
    std::vector<std::size_t> chosen(choices().size(), 0);
    if (has_laws()) chosen.front() = i % count_of_laws();
    return bound_.problem(chosen).alone(i / count_of_laws());
  }

 private:
  const std::vector<optim::Choice>& choices() const { return bound_.choices(); }
  const std::vector<problems::ObjectiveStatement>& objectives() const {
    return bound_.statement().objectives;
  }
  bool has_laws() const { return bound_.statement().chooses_law(); }
  std::size_t count_of_laws() const { return has_laws() ? choices().front().options.size() : 1; }

  BoundProblem bound_;
};

/// Refuses a problem without an objective; `asked` is what looks at it, `file` names the problem.
void check_objective(const ProblemStatement& statement, const std::string& file,
                     const char* asked) {
  if (!statement.objectives.empty()) return;
  throw std::invalid_argument(fmt::format(
      "{}: {} needs an objective, and there is none; write [objective] minimize = \"...\"", file,
      asked));
}

Variants variants_of(const ProblemStatement& statement, const char* asked) {
  check_objective(statement, statement.source, asked);
  return Variants(BoundProblem(statement));
}

std::vector<CheckedVariant> checked_by_differences(const Variants& variants) {
  std::vector<CheckedVariant> result;
  for (std::size_t i = 0; i < variants.size(); ++i) {
    const optim::Problem problem = variants.problem(i);
    result.push_back({variants.law(i), variants.objective(i),
                      optim::check_derivatives(problem, problem.start())});
  }
  return result;
}

/// "law cycloidal, peak force", of what varies among these.
std::string label_of(const CheckedVariant& variant, bool several_objectives) {
  std::string text = variant.law.empty() ? "" : "law " + variant.law;
  if (several_objectives) text += (text.empty() ? "" : ", ") + variant.objective;
  return text;
}

/// What varies, what is sought and what must hold, for programs; people read it in words.
void add_statement(const ProblemStatement& statement, Document& document) {
  Table variables{.key = "variables",
                  .columns = {data("name"), data("unit"), data("lower"), data("upper"),
                              data("start"), data("integer"), data("values")},
                  .shown = 0};
  for (const auto& v : statement.variables) {
    variables.add({datum(v.name), datum(v.unit), datum(v.lower), datum(v.upper), datum(v.start),
                   datum(v.integer), datum(v.values)});
  }
  Table objectives{
      .key = "objectives", .columns = {data("name"), data("unit"), data("sense")}, .shown = 0};
  for (const auto& o : statement.objectives) {
    objectives.add({datum(o.response.name), datum(o.response.unit),
                    datum(o.sense == optim::Sense::Minimize ? "minimize" : "maximize")});
  }
  Table constraints{
      .key = "constraints",
      .columns = {data("name"), data("unit"), data("lower"), data("upper"), data("required_by")},
      .shown = 0};
  for (const auto& c : statement.constraints) {
    constraints.add({datum(c.response.name), datum(c.response.unit), datum(c.lower), datum(c.upper),
                     datum(c.required_by)});
  }
  document.fact("title", statement.title);
  document.fact("mechanism", statement.mechanism->name);
  document.add(std::move(variables));
  document.add(std::move(objectives));
  document.add(std::move(constraints));
  const std::string words = problems::in_words(statement);
  document.say(words);
  document.fact("words", words);
}

/// "d(force)/d(alpha and stroke) at 12", its parts for programs; nothing where there is none.
Cell derivative_cell(const optim::DerivativeEntry& entry) {
  if (entry.response.empty()) return {};
  const std::string by = entry.second.empty()
                             ? entry.variable
                             : fmt::format("{} and {}", entry.variable, entry.second);
  return {fmt::format("d({})/d({}){}", entry.response, by,
                      entry.angle ? fmt::format(" at {:.6g}", *entry.angle) : ""),
          Json{{"response", entry.response},
               {"variable", entry.variable},
               {"second", entry.second.empty() ? Json(nullptr) : Json(entry.second)},
               {"angle", json_value(entry.angle)}}};
}

/// What differences say of the derivatives, and samples of the shapes; whether they agree.
bool add_derivatives(const std::vector<CheckedVariant>& variants, bool several_objectives,
                     Document& document) {
  Table table{.key = "derivatives",
              .columns = {words("of", "of"), numbers("derivatives", "entries"),
                          words("agree", "agrees"), words("worst", "worst"),
                          numbers("exact", "exact"), numbers("by differences", "difference"),
                          numbers("error", "error"), data("shapes")},
              .caption = "\n"};
  table.columns.front().in_text = variants.size() > 1;
  bool agrees = true, are_right = true;
  std::size_t count = 0;
  std::string shapes;
  for (const CheckedVariant& variant : variants) {
    const optim::DerivativeCheck& result = variant.found;
    const optim::DerivativeEntry& worst = result.worst;
    table.add({label_of(variant, several_objectives),
               {fmt::format("{}", result.entries), result.entries},
               yes_or_no(result.agrees),
               derivative_cell(worst),
               {in_digits(worst.exact, 12), worst.exact},
               {in_digits(worst.difference, 12), worst.difference},
               {fmt::format("{:.1e}", worst.error), worst.error},
               datum(result.shapes)});
    count += result.entries;
    agrees = agrees && result.agrees;
    are_right = are_right && result.shapes.empty();
    for (const std::string& shape : result.shapes) shapes += shape + "\n";
  }
  document.add(std::move(table));
  document.say(fmt::format("{} derivatives compared with finite differences: {}\n", count,
                           agrees ? "all agree" : "they do not agree"));
  document.say(shapes);
  document.fact("compared", count);
  document.fact("agrees", agrees && are_right);
  return agrees && are_right;
}

}  // namespace

CheckedProblem checked_problem(const ProblemStatement& statement, CheckAsked asked,
                               const std::string& file) {
  if (asked.scaling) check_objective(statement, file, "--scaling");
  if (asked.derivatives) check_objective(statement, file, "--derivatives");
  std::optional<Variants> variants;
  if (!statement.objectives.empty()) {
    variants.emplace(BoundProblem(statement));  // or says why not
    for (std::size_t i = 0; i < variants->size(); ++i) variants->problem(i).check();
  }
  CheckedProblem checked;
  Document& document = checked.document;
  add_statement(statement, document);
  if (variants) {
    const Table shapes = shape_table(statement);
    document.add(shapes);
    document.say(shape_legend(shapes));
  }
  const Warnings warnings = warnings_of_file(statement);
  document.say(warnings_text(warnings));
  document.fact("warnings", warnings);
  if (asked.scaling) document.add(scaling_table(variants->problem(0)));
  if (asked.derivatives) {
    checked.agrees = add_derivatives(checked_by_differences(*variants),
                                     statement.objectives.size() > 1, document);
  }
  return checked;
}

std::vector<CheckedVariant> checked_derivatives(const ProblemStatement& statement) {
  return checked_by_differences(variants_of(statement, "a check of derivatives"));
}

Table scaling_of(const ProblemStatement& statement) {
  return scaling_table(variants_of(statement, "scaling").problem(0));
}

}  // namespace camlaw::cli
