// SPDX-License-Identifier: MIT
#include "output/answers/sweep_answer.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace camlaw::cli {
namespace {

std::vector<std::string> active_of(const SweepRow& row) {
  std::vector<std::string> active;
  for (const optim::Standing& limit : row.limits) {
    if (limit.price != 0) active.push_back(limit.name);
  }
  for (const problems::SweptVariable& v : row.variables) {
    if (v.at_lower != v.at_upper) {
      active.push_back(fmt::format("{} at its {} bound", v.name, v.at_lower ? "lower" : "upper"));
    }
  }
  return active;
}

SweepRow row_of(const problems::SweepStudy& study, const problems::SweptCombinations& sweep,
                std::size_t i) {
  SweepRow row{.values = study.plan().values(i), .verdict = "not done", .reason = {}};
  const auto& outcome = sweep.outcomes[i];
  if (!outcome) return row;
  row.evaluations = outcome->evaluations;
  row.is_warm = sweep.is_warm[i];
  row.is_global = outcome->is_global;
  if (outcome->points.empty()) {
    row.state = outcome->infeasible ? SweepState::NoDesign : SweepState::Failed;
    row.verdict =
        to_string(outcome->infeasible ? optim::Verdict::Infeasible : optim::Verdict::Failed);
    row.reason = outcome->failure;
    return row;
  }
  const optim::FrontPoint& point = outcome->points.front();
  const bool is_met = std::all_of(point.limits.begin(), point.limits.end(),
                                  [](const optim::Standing& limit) { return limit.met; });
  const bool is_failed = point.verdict == optim::Verdict::Failed;
  row.state = !is_failed ? SweepState::Design : is_met ? SweepState::Failed : SweepState::Passes;
  const bool is_proved = std::all_of(point.limits.begin(), point.limits.end(),
                                     [](const optim::Standing& limit) { return limit.proved; });
  const std::string evaluated = row.state != SweepState::Design ? "violates a limit"
                                : is_proved                     ? "meets every limit"
                                                                : "meets every limit, not proved";
  row.verdict =
      study.plan().settings().evaluates ? evaluated : std::string(to_string(point.verdict));
  if (row.state == SweepState::Failed) row.verdict = "failed";
  row.reason = point.reason;
  row.objectives = point.objectives;
  row.variables = study.variables(i, point.x);
  row.limits = point.limits;
  if (!study.plan().settings().evaluates) row.active = active_of(row);
  return row;
}

}  // namespace

SweepAnswer::SweepAnswer(const problems::SweepStudy& of, const problems::SweptCombinations& sweep)
    : study(of), is_stopped(sweep.done() < sweep.outcomes.size()) {
  for (std::size_t i = 0; i < sweep.outcomes.size(); ++i) rows.push_back(row_of(of, sweep, i));
}

std::size_t SweepAnswer::count(SweepState state) const {
  return static_cast<std::size_t>(std::count_if(
      rows.begin(), rows.end(), [&](const SweepRow& row) { return row.state == state; }));
}

std::string SweepAnswer::swept_title(std::size_t name) const {
  const problems::SweptName& swept = study.plan().names()[name];
  return study.is_start(swept) ? "start of " + swept.name : swept.name;
}

bool SweepAnswer::has_warm() const {
  return std::any_of(rows.begin(), rows.end(), [](const SweepRow& row) { return row.is_warm; });
}

bool SweepAnswer::is_better(double a, double b) const {
  constexpr double kEqual = 1e-9;  // of their size: else rounding would choose between equal laws
  if (std::isnan(a) || std::isnan(b)) return std::isnan(b) && !std::isnan(a);
  if (std::abs(a - b) <= kEqual * std::max(std::abs(a), std::abs(b))) return false;
  return study.statement().objectives.front().sense == optim::Sense::Minimize ? a < b : a > b;
}

std::optional<std::size_t> SweepAnswer::best() const { return best_with(0, ""); }

std::optional<std::size_t> SweepAnswer::best_with(std::size_t name,
                                                  const std::string& value) const {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const SweepRow& row = rows[i];
    if (row.state != SweepState::Design || std::isnan(row.objectives.front())) continue;
    if (!value.empty() && row.values[name].text != value) continue;
    if (best && !is_better(row.objectives.front(), rows[*best].objectives.front())) continue;
    best = i;
  }
  return best;
}

std::string SweepAnswer::objective_title(std::size_t objective) const {
  const problems::ResponseName& response = study.statement().objectives.at(objective).response;
  return response.unit == "1" ? response.name
                              : fmt::format("{} [{}]", response.name, response.unit);
}

std::string combination_text(const SweepAnswer& answer, std::size_t row) {
  std::vector<std::string> parts;
  const auto& names = answer.study.plan().names();
  for (std::size_t k = 0; k < names.size(); ++k) {
    parts.push_back(fmt::format("{} = {}", answer.swept_title(k), answer.rows[row].values[k].text));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace camlaw::cli
