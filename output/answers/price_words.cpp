// SPDX-License-Identifier: MIT
#include "output/answers/price_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "optim/verdict/unknown_prices.h"
#include "output/answers/price_step.h"
#include "output/document/formatting.h"
#include "problems/statement/bind.h"
#include "problems/statement/buildable.h"
#include "problems/statement/parameters.h"

namespace camlaw::cli {

bool has_prices(const optim::Assessment& a) {
  return a.verdict == optim::Verdict::Certified || a.verdict == optim::Verdict::Feasible;
}

std::string price_text(const optim::LimitReport& limit, bool priced) {
  if (!priced) return "";
  if (std::isnan(limit.multiplier)) return "not known";
  if (limit.multiplier != 0) return fmt::format("{:.4g}", limit.multiplier);
  return limit.at_rest ? "at rest" : "";
}

std::string unknown_price_words(const Answer& answer) {
  const optim::Optimum& optimum = answer.optimum;
  if (!has_prices(answer.optimum.found.assessment)) return {};
  return optim::why_no_price(optimum.problem, optimum.found.assessment, optimum.found.x);
}

std::string price_words(const Answer& answer, const std::string& why) {
  const optim::Assessment& a = answer.optimum.found.assessment;
  const std::string unknown = why.empty() ? "" : why + "\n";
  if (a.verdict != optim::Verdict::Certified) return unknown;
  const optim::Optimum& optimum = answer.optimum;
  const problems::ObjectiveStatement& objective = answer.bound.statement().objectives.front();
  std::string text;
  const auto add = [&](const std::string& what, const std::string& unit,
                       const std::optional<PricedStep>& priced) {
    if (!priced) return;
    const bool falls = objective.sense == optim::Sense::Minimize;
    text += fmt::format(
        "  {} by {} would {} {} by {}\n", what, with_unit(in_digits(priced->step), unit),
        falls == (priced->gain > 0) ? "reduce" : "increase", objective.response.name,
        with_unit(fmt::format("{:.4g}", std::abs(priced->gain)),
                  optimum.problem.objective().response.unit));
  };
  for (const optim::LimitReport& limit : a.limits) {
    add(fmt::format("easing the limit on {}", limit.name), limit.unit,
        priced_step(limit, a.objective.value));
    if (!limit.at_rest) continue;
    text += fmt::format(
        "  the limit on {} holds the design where the motion is at rest, and easing it there gains "
        "more than in proportion: it has no price\n",
        limit.name);
  }
  for (const optim::VariableReport& v : a.variables) {
    add(fmt::format("easing the {} bound of {}", v.at_upper ? "upper" : "lower", v.name), v.unit,
        priced_step(v, a.objective.value));
  }
  return text.empty() ? unknown : "what each limit costs, to first order\n" + text + unknown;
}

namespace {

/// A step that is enough: rounded up to the digits that are shown.
double rounded_up(double by) {
  constexpr int kDigits = 4;
  const double unit = std::pow(10.0, std::floor(std::log10(by)) + 1 - kDigits);
  const double steps = by / unit;
  constexpr double kRounding = 1e-6;  // of a step that is whole but for rounding
  return std::ceil(steps - kRounding) * unit;
}

/// The limit with two sides that a cure eases; null where it eases another.
const problems::ConstraintStatement* two_sided(const problems::ProblemStatement& problem,
                                               const optim::Easing& easing) {
  if (easing.is_bound) return nullptr;
  for (const problems::ConstraintStatement& c : problem.constraints) {
    if (c.response.name == easing.name && c.lower && c.upper) return &c;
  }
  return nullptr;
}

/// The side that a cure eases: "both" of a limit on the size of a curve.
const char* side_of(const problems::ProblemStatement& problem, const optim::Easing& easing) {
  const problems::ConstraintStatement* limit = two_sided(problem, easing);
  if (limit != nullptr && *limit->lower == -*limit->upper) return "both";
  return easing.is_upper ? "upper" : "lower";
}

/// "the limit on undercut", "the upper limit on", "both limits on".
std::string limit_words(const problems::ProblemStatement& problem, const optim::Easing& easing) {
  if (two_sided(problem, easing) == nullptr) return "the limit on " + easing.name;
  const std::string side = side_of(problem, easing);
  return side == "both" ? "both limits on " + easing.name
                        : fmt::format("the {} limit on {}", side, easing.name);
}

/// "easing the upper bound of base_radius by 1.2 mm".
std::string easing_words(const problems::ProblemStatement& problem, const optim::Easing& easing) {
  const std::string what =
      easing.is_bound ? fmt::format("the {} bound of {}", side_of(problem, easing), easing.name)
                      : limit_words(problem, easing);
  return fmt::format("easing {} by {}", what,
                     with_unit(in_digits(rounded_up(easing.by), 4), easing.unit));
}

/// What the design shown does not meet, as easings; empty where one of them has no number.
std::vector<optim::Easing> missed_limits(const Answer& answer) {
  std::vector<optim::Easing> missed;
  const std::vector<optim::LimitReport> limits = answer.limits();
  const auto others = problems::other_sides(
      answer.bound.at(answer.optimum.options, answer.optimum.found.x), limits);
  const auto is_added = [&](const optim::LimitReport& limit) {
    if (limit.met) return true;
    if (limit.is_equation || !std::isfinite(limit.margin)) return false;
    missed.push_back({.name = limit.name,
                      .unit = limit.unit,
                      .is_bound = false,
                      .is_upper = limit.is_upper,
                      .bound = limit.bound,
                      .by = -limit.margin,
                      .x = answer.optimum.found.x});
    return true;
  };
  for (std::size_t i = 0; i < limits.size(); ++i) {
    if (!is_added(limits[i]) || (others[i] && !is_added(*others[i]))) return {};
  }
  return missed;
}

/// Whether the machine and the responses of the problem have no value beyond the eased bound.
bool is_beyond_validity(const problems::ProblemStatement& problem, const optim::Easing& easing) {
  if (easing.is_bound) return false;
  const auto is_passed = [&](const problems::ValidityLimit& limit) {
    if (limit.response != easing.name) return false;
    return easing.is_upper ? easing.bound + easing.by > limit.upper
                           : easing.bound - easing.by < limit.lower;
  };
  const auto is_any_passed = [&](const auto& limits) {
    return std::any_of(limits.begin(), limits.end(), is_passed);
  };
  const auto asks_for_it = [&](const auto& asked) {
    return asked.response.response != nullptr &&
           is_any_passed(asked.response.response->defined_while);
  };
  return is_any_passed(problem.mechanism->validity) ||
         std::any_of(problem.objectives.begin(), problem.objectives.end(), asks_for_it) ||
         std::any_of(problem.constraints.begin(), problem.constraints.end(), asks_for_it);
}

/// Whether the machine does not accept what the eased bound lets a parameter be.
bool is_refused(const problems::ProblemStatement& problem, const optim::Easing& easing) {
  if (!easing.is_bound) return false;
  const double eased = easing.bound + (easing.is_upper ? easing.by : -easing.by);
  return std::any_of(problem.variables.begin(), problem.variables.end(),
                     [&](const problems::VariableStatement& v) {
                       if (v.of_law || v.name != easing.name) return false;
                       const auto& parameter = problem.mechanism->parameters[v.parameter];
                       return eased < parameter.low || eased > parameter.high;
                     });
}

struct Cures {
  std::vector<optim::Easing> easings;
  bool alone = true;  ///< each is enough; else all together
};

Cures cures_of(const Answer& answer) {
  const optim::Found& found = answer.optimum.found;
  if (found.assessment.verdict != optim::Verdict::Infeasible || found.x.empty()) return {};
  const auto is_beyond = [&](const optim::Easing& easing) {
    return is_beyond_validity(answer.bound.statement(), easing) ||
           is_refused(answer.bound.statement(), easing);
  };
  std::vector<optim::Easing> alone = answer.easings.all;
  std::erase_if(alone, is_beyond);
  if (!alone.empty()) return {std::move(alone), true};
  std::vector<optim::Easing> together = missed_limits(answer);
  if (std::any_of(together.begin(), together.end(), is_beyond)) return {};
  const bool is_one = together.size() < 2;
  return {std::move(together), is_one};
}

/// The checks that [buildable] requires and that fail at the design of a cure.
std::vector<std::string> still_failing(const Answer& answer, const optim::Easing& easing) {
  const problems::Buildability built =
      problems::buildability(answer.bound.at(answer.optimum.options, easing.x));
  std::vector<std::string> names;
  for (const problems::BuildableAnswer& check : built.checks) {
    if (built.required && check.built == problems::Built::Fails) names.push_back(check.check->name);
  }
  return names;
}

std::string failing_words(const std::vector<std::string>& names) {
  return names.empty() ? ""
                       : fmt::format("; then [buildable] still fails: {}", problems::listed(names));
}

}  // namespace

std::string cure_words(const Answer& answer) {
  const auto [all, alone] = cures_of(answer);
  const std::string& cut = answer.easings.cut_short;
  const std::string cut_words =
      cut.empty() ? "" : fmt::format("not every remedy was looked for: {}\n", cut);
  if (all.empty()) return cut_words;
  const char* const by_this = answer.space.choices.empty() ? "" : " by this combination";
  if (!alone) {
    constexpr std::size_t kEasing = 7;  // "easing "
    std::vector<std::string> parts;
    for (const optim::Easing& easing : all)
      parts.push_back(easing_words(answer.bound.statement(), easing).substr(kEasing));
    return fmt::format(
        "from the design above, this would let every limit be met\n  easing {} together{}\n{}",
        problems::listed(parts), failing_words(still_failing(answer, all.front())), cut_words);
  }
  std::string text = fmt::format("{} would let every limit be met{}\n",
                                 all.size() == 1 ? "this" : "each of these alone", by_this);
  for (const optim::Easing& easing : all) {
    text += fmt::format("  {}{}\n", easing_words(answer.bound.statement(), easing),
                        failing_words(still_failing(answer, easing)));
  }
  return text + cut_words;
}

Json cures_json(const Answer& answer) {
  const auto [all, alone] = cures_of(answer);
  const std::string& cut = answer.easings.cut_short;
  if (all.empty() && cut.empty()) return nullptr;
  Json list = Json::array();
  for (const optim::Easing& easing : all) {
    list.push_back({{"name", easing.name},
                    {"is_bound", easing.is_bound},
                    {"side", side_of(answer.bound.statement(), easing)},
                    {"unit", easing.unit},
                    {"bound", to_json(easing.bound)},
                    {"by", to_json(easing.by)},
                    {"still_fails", still_failing(answer, easing)}});
  }
  return {{"alone", alone},
          {"easings", std::move(list)},
          {"cut_short", cut.empty() ? Json(nullptr) : Json(cut)}};
}

}  // namespace camlaw::cli
