// SPDX-License-Identifier: MIT
#include "output/answers/optimum_output.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "output/answers/buildable_output.h"
#include "output/answers/law_output.h"
#include "output/answers/limit_text.h"
#include "output/answers/next_better.h"
#include "output/answers/objective_cases.h"
#include "output/answers/open_objective.h"
#include "output/answers/price_step.h"
#include "output/answers/price_words.h"
#include "output/answers/reached_output.h"
#include "output/answers/search_facts.h"
#include "output/answers/value_lines.h"
#include "output/answers/variable_words.h"
#include "output/answers/warnings.h"
#include "output/document/formatting.h"
#include "output/document/printing.h"
#include "output/document/short_version.h"
#include "problems/results/design_json.h"
#include "problems/results/seal.h"
#include "problems/statement/parameters.h"

namespace camlaw::cli {
namespace {

using optim::Assessment;
using optim::LimitReport;
using optim::VariableReport;

std::string shaded_headline(optim::Verdict verdict, const problems::Buildability& built) {
  const Headline line = headline(std::string(to_string(verdict)), built);
  const bool good = verdict == optim::Verdict::Certified && !line.spoilt;
  const bool bad = verdict == optim::Verdict::Infeasible || verdict == optim::Verdict::Failed;
  return shaded(line.text, good ? Shade::Good : bad ? Shade::Bad : Shade::Unsure);
}

const Assessment& assessment(const Answer& answer) { return answer.optimum.found.assessment; }

std::string objective_name(const Answer& answer) {
  return answer.bound.statement().objectives.front().response.name;
}

const std::string& objective_unit(const Answer& answer) {
  return answer.optimum.problem.objective().response.unit;
}

/// Whether the search ended at a design: where nothing varies, one whose objective is a number.
bool is_at_design(const Answer& answer) {
  const optim::Optimum& optimum = answer.optimum;
  if (optimum.found.x.size() != optimum.problem.variables.size()) return false;
  return !optimum.found.x.empty() || !std::isnan(assessment(answer).objective.value);
}

/// The statement of that design; where there is none, the problem's.
problems::ProblemStatement stated_design(const Answer& answer) {
  return is_at_design(answer) ? answer.bound.at(answer.optimum.options, answer.optimum.found.x)
                              : answer.bound.statement();
}

/// How the design stands to the limits, and what each costs.
void add_limits(const Answer& answer, Document& document) {
  const bool priced = has_prices(assessment(answer));
  const bool is_design = is_at_design(answer);
  const problems::ProblemStatement design = stated_design(answer);
  std::vector<LimitReport> limits = answer.limits();
  std::vector<std::optional<LimitReport>> none(limits.size());
  const SidedLimits sided = is_design ? both_sides(design, std::move(limits))
                                      : SidedLimits{std::move(limits), std::move(none)};
  Table table = limits_table(sided, design);
  table.columns.insert(table.columns.end(),
                       {data("multiplier"), data("at_rest"), data("eased_by"), data("eased_gain")});
  std::vector<std::string> prices;
  for (std::size_t i = 0; i < sided.limits.size(); ++i) {
    const LimitReport& limit = sided.limits[i];
    const PricedStep eased = told_step(limit, assessment(answer));
    table.rows[i].insert(table.rows[i].end(), {datum(limit.multiplier), datum(limit.at_rest),
                                               datum(eased.step), datum(eased.gain)});
    prices.push_back(price_text(limit, priced));
  }
  if (!prices.empty()) document.say("\n");
  document.add(std::move(table));
  const bool are_tried = optim::is_feasible(assessment(answer));  // others are not worth a proof
  if (!prices.empty()) {
    document.add(sides_table(sided, design, priced ? "price" : "", prices, are_tried));
  }
  for (std::size_t i = 0; is_design && i < sided.limits.size(); ++i) {
    document.say(undecided_line(sided.limits[i], design, i));
    if (sided.others[i]) document.say(undecided_line(*sided.others[i], design, i));
  }
  for (std::size_t i = 0; i < sided.limits.size(); ++i) {
    const auto& by = design.constraints[i].required_by;
    if (!by) continue;
    document.say(fmt::format("{} is a limit because {} requires it\n", sided.limits[i].name, *by));
  }
}

/// The solver asked for, and the one that ended the search where that is another: what a global
/// method finds a local one polishes.
std::string solver_words(const Answer& answer) {
  const optim::Found& found = answer.optimum.found;
  const bool another = answer.asked != "auto" && answer.asked != found.solver;
  return fmt::format(
      "solver {} ({})",
      another ? fmt::format("{}, then {}", answer.asked, found.solver) : found.solver,
      found.why_solver);
}

std::string how(const Answer& answer) {
  const optim::Found& found = answer.optimum.found;
  const auto counted = [](auto count, const char* what) {
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
  };
  std::string text =
      fmt::format("{} in {}, {:.3g} s; {}", counted(found.evaluations, "evaluation"),
                  counted(found.solves, "solve"), answer.optimum.wall_s, solver_words(answer));
  if (found.starts > 1) text += "\n" + words_of_starts(found);
  // Where all are settled, the verdict has these numbers.
  if (answer.optimum.combinations > 1 && !found.assessment.global) {
    text += fmt::format("\n{} combinations, {} problems solved", answer.optimum.combinations,
                        answer.optimum.solved);
  }
  return text;
}

/// "  law: rise 90 deg by cycloidal to 1, ...", where a motion program was chosen.
std::string program_line(const Answer& answer) {
  const problems::ProblemStatement& statement = answer.bound.statement();
  const problems::MovedBy moved_by = statement.mechanism->moved_by;
  const bool is_chosen = statement.chooses_law() && moved_by == problems::MovedBy::Program;
  const std::optional<Member> law = is_chosen ? answer.law() : std::nullopt;
  return law ? fmt::format("  law: {}\n", law_in_words(*law, moved_by)) : "";
}

/// What the numbers shown are, where they are not those of an answer; else empty.
std::string what_is_shown(const Answer& answer) {
  const Assessment& a = assessment(answer);
  if (optim::is_feasible(a) || !is_at_design(answer) || std::isnan(a.objective.value)) return "";
  if (answer.optimum.found.solves == 0) return "not an answer: the values at the start";
  return a.verdict == optim::Verdict::Infeasible
             ? "not an answer: the design that comes nearest to the limits"
             : "not an answer: the design at which the search ended";
}

/// The objective and the other variables, where there is a design.
std::string design_text(const Answer& answer, const ObjectivePlace& worst) {
  const optim::ObjectiveReport& objective = assessment(answer).objective;
  const problems::ResponseName& response = answer.bound.statement().objectives.front().response;
  if (std::isnan(objective.value)) return "no design was found\n";
  std::string text =
      fmt::format("{} = {}{}\n", objective_name(answer),
                  with_unit(fmt::format("{:.10g}", objective.value + 0.0), objective_unit(answer)),
                  worst.words.empty() ? "" : fmt::format("  ({})", worst.words));
  std::string list = program_line(answer);
  const auto values = answer.values();
  list += value_lines(values, list.empty() ? 0 : 1, response.name);
  return list.empty() ? text : text + "\n" + list;
}

}  // namespace

std::vector<DesignValue> Answer::values() const {
  std::vector<DesignValue> result;
  for (std::size_t i = 0; i < space.choices.size() && i < optimum.options.size(); ++i) {
    const optim::Choice& choice = space.choices[i];
    const std::size_t option = optimum.options[i];
    // Of a law not the option's words, which have the starts of what varies.
    const bool is_law = i == 0 && bound.statement().chooses_law();
    const auto chosen = is_law ? law() : std::nullopt;
    result.push_back({choice.name, choice.unit, chosen ? chosen->label() : choice.options[option],
                      choice.values.empty() ? std::nan("") : choice.values[option]});
  }
  const std::vector<VariableReport>& variables = optimum.found.assessment.variables;
  for (std::size_t i = 0; i < variables.size(); ++i) {
    const VariableReport& v = variables[i];
    result.push_back({v.name, v.unit, variable_in_words(optimum, i), v.value,
                      problems::measure_of(bound.statement(), v.name, v.value)});
  }
  return result;
}

std::optional<Member> Answer::law() const {
  if (bound.statement().mechanism->moved_by == problems::MovedBy::Nothing) return std::nullopt;
  if (!bound.statement().cams.empty()) return std::nullopt;  // there are several
  if (optimum.found.x.size() != optimum.problem.variables.size()) return {};
  const Member found = bound.at(optimum.options, optimum.found.x).laws.front();
  if (found.family->listed && !found.possible_law()) return {};  // the design makes no law
  return found.listed();
}

problems::Buildability buildability_of(const Answer& answer) {
  const optim::Optimum& optimum = answer.optimum;
  if (!optim::is_feasible(optimum.found.assessment)) return {};
  return problems::buildability(answer.bound.at(optimum.options, optimum.found.x));
}

std::vector<LimitReport> Answer::limits() const {
  return problems::as_stated(bound.statement(), optimum.found.assessment.limits);
}

namespace {

Json active_bounds(const Assessment& a) {
  Json bounds = Json::array();
  for (const VariableReport& v : a.variables) {
    if (!v.at_lower && !v.at_upper) continue;
    const PricedStep eased = told_step(v, a);
    bounds.push_back({{"name", v.name},
                      {"side", v.at_upper ? "upper" : "lower"},
                      {"multiplier", to_json(v.multiplier)},
                      {"eased_by", to_json(eased.step)},
                      {"eased_gain", to_json(eased.gain)}});
  }
  return bounds;
}

/// What classes of laws hold and no program is made of.
Json left_out_json(const problems::ProblemStatement& statement) {
  Json all = Json::array();
  for (const problems::LeftOut& left : statement.left_out) {
    all.push_back({{"what", left.what}, {"why", left.why}});
  }
  return all;
}

void add_design(const Answer& answer, Document& document) {
  const Assessment& a = assessment(answer);
  Json variables = Json::object(), units = Json::object();
  for (const DesignValue& value : answer.values()) {
    variables[value.name] = value.json();
    if (!value.unit.empty()) units[value.name] = value.unit;
  }
  const problems::ProblemStatement design = stated_design(answer);
  const ObjectivePlace worst =
      std::isnan(a.objective.value) ? ObjectivePlace{} : objective_place(design, a.objective.angle);
  const OpenObjective open = open_objective(answer, design);
  const std::string shown = what_is_shown(answer);
  document.say("\n" + (shown.empty() ? "" : shown + "\n") + design_text(answer, worst) +
               next_better(answer) + open.line);
  document.fact("shown", shown);
  document.fact("objective", a.objective.value);
  document.fact("objective_name", objective_name(answer));
  document.fact("objective_unit", objective_unit(answer));
  document.fact("objective_worst_angle_deg", worst.angle);
  document.fact("objective_case", worst.load_case);
  document.fact("objective_worst_at", worst.worst_at);
  document.fact("objective_tolerance", a.objective.tolerance);
  document.fact("best_possible", a.best_possible);
  document.fact("objective_proved",
                Json{to_json(a.objective.proved.lower), to_json(a.objective.proved.upper)});
  document.fact("objective_undecided", open.undecided);
  document.fact("objective_why_not_proved", open.why_not_proved);
  document.fact("variables", variables);
  document.fact("units", units);
  if (std::isnan(a.objective.value)) return;
  if (Table cases = objective_cases(design); !cases.rows.empty()) {
    cases.caption = "\n";
    document.add(std::move(cases));
  }
}

/// What holds the design where it is, and how well that is known.
void add_conditions(const Answer& answer, Document& document) {
  const Assessment& a = assessment(answer);
  if (!a.active.empty()) document.say(fmt::format("\nactive: {}\n", fmt::join(a.active, ", ")));
  const std::string unknown = unknown_price_words(answer);
  if (const std::string costs = price_words(answer, unknown); !costs.empty())
    document.say("\n" + costs);
  if (const std::string cure = cure_words(answer); !cure.empty()) document.say("\n" + cure);
  if (std::isfinite(a.kkt_residual) &&
      !answer.optimum.found.x.empty()) {  // else nothing was varied
    const std::string condition =
        std::isnan(a.condition) ? ""
        : std::isinf(a.condition)
            ? "; condition number of the active limits infinite: their multipliers are not unique"
            : fmt::format("; condition number of the active limits {:.2g}", a.condition);
    const std::string residual = a.kkt_residual < std::numeric_limits<double>::epsilon()
                                     ? "rounding"
                                     : fmt::format("{:.1e}", a.kkt_residual);
    document.say(
        fmt::format("\n{} conditions met to {}{}\n",
                    a.verdict == optim::Verdict::Infeasible ? "least-violation" : "optimality",
                    residual, condition));
  }
  document.fact("no_price", unknown);
  document.fact("active", a.active);
  document.fact("active_bounds", active_bounds(a));
  document.fact("blamed", a.blamed);
  document.fact("cures", cures_json(answer));
  document.fact("kkt_residual", a.kkt_residual);
  document.fact("second_order", a.second_order);
  document.fact("condition", a.condition);
  document.fact("global", a.global);
}

/// How knots were added to a free law, and what more of them would gain.
void add_knots(const Answer& answer, Document& document) {
  if (!answer.knots) return;
  const problems::RefinedKnots& knots = *answer.knots;
  Table table{.key = "rounds",
              .columns = {numbers("knots", "knots"), numbers(objective_name(answer), "objective"),
                          words("verdict", "verdict")}};
  for (const problems::KnotRound& round : knots.rounds) {
    table.add({Cell(fmt::format("{}", round.knots), round.knots),
               Cell(in_digits(round.objective), round.objective),
               std::string(optim::to_string(round.verdict))});
  }
  const std::string unit = objective_unit(answer);
  const std::string left =
      knots.left && *knots.left > 0
          ? fmt::format("; if the last rounds' trend continues, further knots would gain about {}",
                        with_unit(fmt::format("{:.1g}", *knots.left), unit))
          : "";
  Document own;
  const char* how =
      knots.knots.size() > knots.rounds.front().knots ? ", added where they gain" : "";
  own.say(fmt::format("\n{} knots{}; {}{}\n", knots.knots.size(), how, knots.ended, left));
  own.add(std::move(table));
  own.fact("places", knots.knots);
  own.fact("ended", knots.ended);
  own.fact("left", knots.left);
  document.add("knots", std::move(own));
}

void add_search(const Answer& answer, Document& document) {
  const optim::Found& found = answer.optimum.found;
  document.say(how(answer) + "\n");
  document.fact("starts", found.starts);
  document.fact("agreed", found.agreed);
  document.fact("combinations", answer.optimum.combinations);
  document.fact("evaluations", found.evaluations);
  document.fact("iterations", found.iterations);
  document.fact("solves", found.solves);
  document.fact("solver", found.solver);
  document.fact("solver_asked", answer.asked);
  document.fact("why_solver", found.why_solver);
  document.fact("seed", answer.seed);
}

}  // namespace

Document answer_document(const Answer& answer) {
  const Assessment& a = assessment(answer);
  const std::string& title = answer.bound.statement().title;
  const std::optional<Member> law = answer.law();
  Document document;
  document.fact("format", problems::kResultFormat.text());
  document.fact("program", short_version());
  if (!title.empty()) document.say(title + "\n");
  document.fact("title", title);
  const std::string shown = shaded_headline(a.verdict, answer.built);
  document.say(fmt::format("{}{}{}\n", shown, answer.built.fails() ? "\n" : ": ", a.reason));
  document.fact("status", optim::to_string(answer.optimum.found.status));
  document.fact("verdict", optim::to_string(a.verdict));
  document.fact("reason", a.reason);
  if (a.global) document.say(fmt::format("global: {}\n", *a.global));
  document.say(warnings_text(answer.warnings));
  document.fact("warnings", answer.warnings);
  document.fact("left_out", left_out_json(answer.bound.statement()));
  add_design(answer, document);
  add_limits(answer, document);
  document.add(reached_document(answer.reached));
  document.add(buildable_document(answer.built));
  add_conditions(answer, document);
  add_knots(answer, document);
  add_search(answer, document);
  document.fact("law", law ? Json(law->name()) : Json(nullptr));
  document.fact("design", problems::recorded_design(answer.bound, answer.optimum.options,
                                                    answer.optimum.found.x));
  return document;
}

Table scaling_table(const optim::Problem& problem) {
  const optim::Scales scales = optim::scales(problem, problem.start());
  Table table{.key = "scaling",
              .columns = {words("scaling", "of"), numbers("scale", "scale"),
                          numbers("tolerance", "tolerance"), words("unit", "unit")},
              .caption = "\n"};
  const auto digits = [](double value) { return Cell(in_digits(value), value); };
  for (std::size_t i = 0; i < problem.variables.size(); ++i) {
    table.add(
        {problem.variables[i].name, digits(scales.variables[i]), {}, problem.variables[i].unit});
  }
  table.add({problem.objective().response.name + " (objective)", digits(scales.objective),
             digits(scales.objective_tolerance), problem.objective().response.unit});
  for (std::size_t i = 0; i < problem.constraints.size(); ++i) {
    table.add({problem.constraints[i].response.name, digits(scales.constraints[i].scale),
               digits(scales.constraints[i].tolerance), problem.constraints[i].response.unit});
  }
  return table;
}

}  // namespace camlaw::cli
