// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "cli/commands.h"
#include "optim/problem/check_derivatives.h"
#include "output/answers/next_step.h"
#include "output/answers/optimum_output.h"
#include "output/answers/shape_output.h"
#include "output/answers/warnings.h"
#include "output/document/printing.h"
#include "problems/statement/bind.h"

namespace camlaw::cli {
namespace {

struct CheckOptions {
  std::string file;
  bool derivatives = false, scaling = false;
};

std::string entry_text(const optim::DerivativeEntry& entry) {
  const std::string by = entry.second.empty()
                             ? entry.variable
                             : fmt::format("{} and {}", entry.variable, entry.second);
  return fmt::format("d({})/d({}){}: exact {:.12g}, by differences {:.12g}, error {:.1e}",
                     entry.response, by, entry.angle ? fmt::format(" at {:.6g}", *entry.angle) : "",
                     entry.exact, entry.difference, entry.error);
}

/// Prints what the differences say of one combination of options; whether they agree.
bool check_problem(const optim::Problem& problem, const std::string& label) {
  const auto result = optim::check_derivatives(problem, problem.start());
  if (!label.empty()) say("{}\n", label);
  say("{} derivatives compared with differences: {}\n", result.entries,
      result.agrees ? "all agree" : "they do not agree");
  if (result.entries > 0) say("worst: {}\n", entry_text(result.worst));
  for (const std::string& shape : result.shapes) say("{}\n", shape);
  return result.agrees && result.shapes.empty();
}

/// The first combination with each law, and each objective: laws differ in their formulas, other
/// choices only in numbers.
class Variants {
 public:
  explicit Variants(problems::BoundProblem bound) : bound_(std::move(bound)) {}

  std::size_t size() const { return count_of_laws() * objectives().size(); }
  std::string label(std::size_t i) const {
    std::string text = has_laws() ? "law " + choices().front().options[i % count_of_laws()] : "";
    if (objectives().size() > 1) {
      text += (text.empty() ? "" : ", ") + objectives()[i / count_of_laws()].response.name;
    }
    return text;
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

  problems::BoundProblem bound_;
};

int run_check(const CheckOptions& options) {
  const auto statement = problems::read_problem_file(options.file);
  std::optional<Variants> variants;
  if (statement.objectives.empty() && (options.derivatives || options.scaling)) {
    throw std::invalid_argument(fmt::format(
        "{}: {} looks at the objective, and there is none; write [objective] minimize = \"...\"",
        options.file, options.scaling ? "--scaling" : "--derivatives"));
  }
  if (!statement.objectives.empty()) {
    variants.emplace(problems::BoundProblem(statement));  // or says why not
    for (std::size_t i = 0; i < variants->size(); ++i) variants->problem(i).check();
  }
  print_text(problems::in_words(statement));
  if (variants) print_text("\n" + text_of(shape_table(statement)));
  print_text(warnings_text(doubts_of(statement)));
  if (options.scaling) say("\n{}", text_of(scaling_table(variants->problem(0))));
  if (!options.derivatives) {
    say_next(search_command(statement, options.file));
    return kDone;
  }
  say("\n");
  bool agrees = true;
  for (std::size_t i = 0; i < variants->size(); ++i) {
    agrees = check_problem(variants->problem(i), variants->label(i)) && agrees;
  }
  return agrees ? kDone : kFailed;
}

}  // namespace

Command check_command() {
  const auto options = std::make_shared<CheckOptions>();
  return {.name = "check",
          .help = "Check a problem file and say it in words",
          .options = {problem_file(options->file),
                      {"--derivatives",
                       &options->derivatives,
                       {},
                       "compare every derivative with differences"},
                      {"--scaling",
                       &options->scaling,
                       {},
                       "show what variables and limits are divided by"}},
          .examples = {{"camlaw check problems/cams/roller_least_base.toml",
                        "the file said back in words, every name and unit checked"},
                       {"camlaw check problems/spine_cutter/least_force.toml --derivatives",
                        "and its derivatives against differences"}},
          .run = [options] { return run_check(*options); }};
}

}  // namespace camlaw::cli
