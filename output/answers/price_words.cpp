// SPDX-License-Identifier: MIT
#include "output/answers/price_words.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "optim/verdict/unknown_prices.h"
#include "output/answers/price_step.h"
#include "output/document/formatting.h"

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
        "  the limit on {} holds the design where the motion rests, and easing it there gains more "
        "than in proportion: it has no price\n",
        limit.name);
  }
  for (const optim::VariableReport& v : a.variables) {
    add(fmt::format("easing the {} bound of {}", v.at_upper ? "upper" : "lower", v.name), v.unit,
        priced_step(v, a.objective.value));
  }
  return text.empty() ? unknown : "what each limit costs, to first order\n" + text + unknown;
}

}  // namespace camlaw::cli
