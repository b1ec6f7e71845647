// SPDX-License-Identifier: MIT
#include "problems/tolerance/reached.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "machines/model/robust_number.h"
#include "numerics/linear/statistics.h"
#include "numerics/sampling/sobol_points.h"
#include "optim/cycle/peak_function.h"
#include "problems/statement/ranges.h"
#include "problems/tolerance/tolerance.h"

namespace camlaw::problems {
namespace {

constexpr double kSure = 0.95;  // the interval beside a share that is reached

std::vector<VariationStatement> of_the_machine(const ProblemStatement& design) {
  std::vector<VariationStatement> result = variations_of(design);
  std::erase_if(result, [](const VariationStatement& v) { return v.parameter.of_law; });
  return result;
}

/// The limits with a reliability, by their numbers.
std::vector<std::size_t> with_a_reliability(const ProblemStatement& design) {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < design.constraints.size(); ++i) {
    if (is_quantile(design.constraints[i])) result.push_back(i);
  }
  return result;
}

/// Whether all limits are formulas in which nothing is searched for, so that parts are cheap.
bool are_formulas(const std::vector<ConstraintStatement>& limits) {
  return std::all_of(limits.begin(), limits.end(), [](const ConstraintStatement& limit) {
    const MechanismResponse* response = limit.response.response;
    return response == nullptr || (response->write && !response->curve && response->inner.empty());
  });
}

/// So many that what no sample saw (TV10) is a quarter of what may fail: with fewer no design could
/// be known to reach what is asked for.
std::size_t least_parts(const std::vector<ReachedShare>& limits) {
  constexpr double kQuarter = 60;  // four times the 15 of (TV10)
  double least = 1;
  for (const ReachedShare& limit : limits) least = std::min(least, 1 - limit.wanted);
  return static_cast<std::size_t>(std::ceil(kQuarter / least));
}

IsReached reach_of(const optim::Bounds& between, double wanted) {
  if (between.lower >= wanted) return IsReached::Yes;
  return between.upper < wanted ? IsReached::No : IsReached::NotDecided;
}

/// The share of parts that break a limit, and between which shares that lies.
struct Failing {
  double share;
  optim::Bounds between;
};

ReachedShare reached_share(std::size_t limit, double wanted, const Failing& failing,
                           const optim::Yield& yield) {
  const double most = std::min(1.0, failing.between.upper + yield.unseen_at_most);
  const optim::Bounds between{1 - most, 1 - failing.between.lower};
  return {limit, {}, wanted, 1 - failing.share, between, reach_of(between, wanted)};
}

/// Limits that are judged by the same parts: those of one response each, by their numbers; or one
/// that a part must hold in several cases at once.
using JudgedTogether = std::vector<std::size_t>;

std::vector<JudgedTogether> judged_together(const ProblemStatement& design) {
  std::vector<JudgedTogether> all(1);
  for (const std::size_t i : with_a_reliability(design)) {
    if (design.constraints[i].in_cases.empty()) {
      all.front().push_back(i);
    } else {
      all.push_back({i});
    }
  }
  if (all.front().empty()) all.erase(all.begin());
  return all;
}

optim::Yield yield_of_limits(const VariedDesign& varied, const std::vector<ReachedShare>& limits,
                             std::uint64_t seed) {
  ToleranceOptions options;
  options.seed = seed;
  constexpr std::size_t kCheap = 100000;  // where no search is needed a part takes microseconds
  if (are_formulas(varied.design.constraints)) {
    options.samples = kCheap;
  } else {
    options.least = least_parts(limits);
  }
  GridReport grid;
  optim::Yield yield = yield_of(varied, options, grid);
  if (yield.stopped) throw optim::Interrupted();
  return yield;
}

void judge_limits(const ProblemStatement& design, const optim::Deadline& deadline,
                  std::uint64_t seed, ReachedReliability& reached) {
  std::map<std::string, int> seen;
  for (const std::size_t i : with_a_reliability(design)) {
    const ConstraintStatement& limit = design.constraints[i];
    std::string name = limit.response.name;
    const int number = ++seen[name];
    if (number > 1) name += fmt::format(" ({})", number);
    // What is known until it is worked out.
    reached.limits.push_back({i, std::move(name), *limit.reliability, std::nan(""), {0, 1}});
  }
  std::vector<ReachedShare> found;
  std::size_t samples = 0;
  for (const JudgedTogether& numbers : judged_together(design)) {
    ProblemStatement only = design;
    only.objectives.clear();
    only.constraints.clear();
    for (const std::size_t i : numbers) {
      for (ConstraintStatement& own : of_each_part(design, design.constraints[i])) {
        only.constraints.push_back(std::move(own));
      }
    }
    const VariedDesign varied = varied_design(only, of_the_machine(design), deadline);
    const optim::Yield yield = yield_of_limits(varied, reached.limits, seed);
    samples = samples == 0 ? yield.samples : std::min(samples, yield.samples);
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      const ConstraintStatement& limit = design.constraints[numbers[k]];
      const bool at_once = !limit.in_cases.empty();
      const Failing failing = at_once ? Failing{yield.failing, yield.failing_between}
                                      : Failing{yield.by_limit[k], yield.by_limit_between[k]};
      found.push_back(reached_share(numbers[k], *limit.reliability, failing, yield));
    }
  }
  std::sort(found.begin(), found.end(),
            [](const ReachedShare& a, const ReachedShare& b) { return a.limit < b.limit; });
  for (std::size_t i = 0; i < found.size(); ++i) found[i].name = reached.limits[i].name;
  reached.limits = std::move(found);
  reached.samples = samples;
}

/// Repetitions of parts that are drawn, with the values of a response.
std::vector<std::vector<double>> values_of(const optim::Function& f, const VariedDesign& varied,
                                           std::size_t each, std::uint64_t seed) {
  // As those of a yield: the error is read off their scatter.
  constexpr std::uint64_t kRepetitions = 32;
  const std::size_t n = varied.meant.size();
  std::vector<std::vector<double>> all;
  std::vector<double> shares(n);
  for (std::uint64_t r = 0; r < kRepetitions; ++r) {
    SobolPoints points(n, mixed(seed, r));
    all.emplace_back();
    for (std::size_t k = 0; k < each; ++k) {
      points.next(shares);
      std::vector<double> part = varied.meant;
      for (std::size_t i = 0; i < n; ++i) part[i] += varied.variations[i].at_share(shares[i]);
      all.back().push_back(f.value(part));
    }
  }
  return all;
}

struct Moments {
  double mean = 0, deviation = 0;
};

Moments moments_of(const std::vector<double>& values) {
  const auto count = static_cast<double>(values.size());
  Moments result;
  double squares = 0;
  for (const double value : values) result.mean += value / count;
  for (const double value : values) squares += (value - result.mean) * (value - result.mean);
  result.deviation = std::sqrt(squares / (count - 1));
  return result;
}

double taken(const std::vector<double>& values, double factor) {
  const Moments own = moments_of(values);
  return own.mean + factor * own.deviation;
}

/// mean + factor * deviation: Student's interval over the repetitions.
optim::Bounds mean_between(const std::vector<std::vector<double>>& all, double factor,
                           double value) {
  std::vector<double> own;
  for (const auto& values : all) own.push_back(taken(values, factor));
  const double error = moments_of(own).deviation / std::sqrt(static_cast<double>(own.size()));
  const double reach = optim::student_quantile(static_cast<int>(own.size()) - 1, kSure) * error;
  return {value - reach, value + reach};
}

/// The values in order between which the quantile lies: as many as lie below it are binomial.
optim::Bounds quantile_between(std::vector<double> values, double share) {
  const auto count = static_cast<double>(values.size());
  const double reach =
      normal_quantile((1 + kSure) / 2) * std::sqrt(count * share * (1 - share)) + 1;
  std::sort(values.begin(), values.end());
  const auto at = [&](double place) {
    return values[static_cast<std::size_t>(std::clamp(place, 0.0, count - 1))];
  };
  return {at(std::floor(count * share - reach)), at(std::ceil(count * share + reach))};
}

bool has_robust_objective(const ProblemStatement& problem) {
  return problem.objectives.size() == 1 && problem.objectives.front().robust;
}

void judge_objective(const ProblemStatement& design, const optim::Deadline& deadline,
                     std::uint64_t seed, ReachedReliability& reached) {
  if (!has_robust_objective(design)) return;
  const Robust& robust = *design.objectives.front().robust;
  ProblemStatement only = design;
  only.constraints.clear();
  const VariedDesign varied = varied_design(only, of_the_machine(design), deadline);
  const optim::Objective& sought = varied.problem.objectives.front();
  const optim::Function f =
      sought.response.is_curve()
          ? optim::peak_function(sought.response, sought.part, varied.meant.size())
          : sought.response.function();
  // What is known until it is worked out.
  reached.objective = {design.objectives.front().response.name,
                       sought.response.unit,
                       std::nan(""),
                       {std::nan(""), std::nan("")}};
  // Values beyond a quantile: its error is some eighth of the share beyond.
  constexpr double kBeyond = 64;
  // Of each repetition: a deviation of 2048 values is known to 1.6 %.
  constexpr std::size_t kEach = 64;
  const double beyond = robust.is_quantile ? std::min(robust.share, 1 - robust.share) : 1;
  const auto each = std::max(kEach, static_cast<std::size_t>(std::ceil(kBeyond / beyond / 32)));
  const auto all = values_of(f, varied, each, seed);
  std::vector<double> values;
  for (const auto& own : all) values.insert(values.end(), own.begin(), own.end());
  ReachedObjective& result = *reached.objective;
  result.samples = values.size();
  if (std::any_of(values.begin(), values.end(), [](double v) { return std::isnan(v); })) {
    return;
  }
  if (robust.is_quantile) {
    result.value = optim::quantile(values, robust.share);
    result.between = quantile_between(values, robust.share);
  } else {
    result.value = taken(values, robust.factor);
    result.between = mean_between(all, robust.factor, result.value);
  }
}

}  // namespace

std::string_view to_string(IsReached reach) {
  switch (reach) {
    case IsReached::Yes:
      return "reached";
    case IsReached::No:
      return "not reached";
    case IsReached::NotDecided:
      break;
  }
  return "not decided";
}

bool ReachedReliability::all() const {
  return cut_short.empty() && std::all_of(limits.begin(), limits.end(), [](const auto& limit) {
           return limit.reach == IsReached::Yes;
         });
}

std::string ReachedReliability::fault() const {
  if (!cut_short.empty()) {
    return "the share of parts that hold the limits with a reliability was not calculated: " +
           cut_short;
  }
  for (const ReachedShare& limit : limits) {
    if (limit.reach == IsReached::Yes) continue;
    return fmt::format(
        "{} {} its reliability: between {:.6g} % and {:.6g} % of all parts hold it, {:.6g} % are "
        "asked for",
        limit.name, limit.reach == IsReached::No ? "does not reach" : "is not known to reach",
        100 * limit.between.lower, 100 * limit.between.upper, 100 * limit.wanted);
  }
  return {};
}

ReachedReliability reached_by(const ProblemStatement& design, const optim::Deadline& deadline,
                              std::uint64_t seed) {
  ReachedReliability result;
  try {
    judge_limits(design, deadline, seed, result);
    judge_objective(design, deadline, seed, result);
  } catch (const optim::Interrupted&) {
    const bool is_open = result.samples == 0 && !result.limits.empty();
    if (is_open) result.cut_short = deadline.reason();
    if (!is_open && result.objective) result.objective->cut_short = deadline.reason();
  }
  return result;
}

bool is_judged(const ProblemStatement& problem) {
  return has_robust_objective(problem) || !with_a_reliability(problem).empty();
}

std::function<void(optim::Assessment&)> held_to_parts(const ProblemStatement& design) {
  return [&design](optim::Assessment& assessment) {
    if (!with_a_reliability(design).empty()) hold_to(reached_by(design), assessment);
  };
}

void hold_to(const ReachedReliability& reached, optim::Assessment& assessment) {
  if (reached.all() || !optim::is_feasible(assessment)) return;
  assessment.verdict = optim::Verdict::Failed;
  assessment.reason = reached.fault();
  for (const ReachedShare& limit : reached.limits) {
    if (limit.reach != IsReached::Yes && limit.limit < assessment.limits.size()) {
      assessment.limits[limit.limit].met = false;
    }
  }
}

}  // namespace camlaw::problems
