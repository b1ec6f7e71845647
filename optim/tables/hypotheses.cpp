// SPDX-License-Identifier: MIT
#include "optim/tables/hypotheses.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <tuple>

#include "optim/tables/hypothesis_search.h"

namespace camlaw::optim {
namespace {

using namespace detail;

void check_row(const PrintedTable& table, std::size_t row) {
  const auto reject = [&](const std::string& what) {
    throw std::invalid_argument(fmt::format("table '{}': row {} {}", table.name, row, what));
  };
  const auto [value, decimals] = table.printed[row];
  if (!std::isfinite(value)) reject(fmt::format("prints {}, which is not finite", value));
  if (decimals < 0 || decimals > kMaxDecimals)
    reject(fmt::format("has {} decimals; use 0 to {}", decimals, kMaxDecimals));
  Mask seen = 0;
  std::size_t combinations = 1;
  for (const std::size_t h : table.depends[row]) {
    if (h >= table.hypotheses.size())
      reject(fmt::format("depends on hypothesis {}; there are {}", h, table.hypotheses.size()));
    if (seen & bit(h)) reject(fmt::format("depends twice on '{}'", table.hypotheses[h].name));
    seen |= bit(h);
    combinations *= choices(table, h);
    if (combinations > kMaxCombinations)
      reject(fmt::format("depends on more than {} combinations", kMaxCombinations));
  }
}

void check(const PrintedTable& table) {
  const auto reject = [&](const std::string& what) {
    throw std::invalid_argument(fmt::format("table '{}': {}", table.name, what));
  };
  if (!table.model) reject("no model");
  if (table.depends.size() != table.printed.size())
    reject(fmt::format("{} printed values, but depends has {} rows", table.printed.size(),
                       table.depends.size()));
  if (table.hypotheses.size() > kMaxHypotheses)
    reject(fmt::format("{} hypotheses; at most {}", table.hypotheses.size(), kMaxHypotheses));
  for (std::size_t row = 0; row < table.printed.size(); ++row) check_row(table, row);
}

/// The smallest part of the winner's departures that fits the row as well as the whole does; of
/// equally small ones the lowest sum of ranks.
std::vector<std::pair<std::size_t, int>> causes(HypothesisRow& row,
                                                const std::vector<std::size_t>& depends,
                                                const Assignment& winner) {
  std::vector<std::size_t> departed;
  std::copy_if(depends.begin(), depends.end(), std::back_inserter(departed),
               [&](std::size_t h) { return winner[h] != 0; });
  std::sort(departed.begin(), departed.end());
  const Fit wanted = row.fit(winner);
  Mask best = 0;
  auto best_cost = std::make_pair(kMaxHypotheses + 1, 0);
  for (Mask subset = 0; subset < bit(departed.size()); ++subset) {
    if (size(subset) > best_cost.first) continue;
    Assignment part(winner.size(), 0);
    int ranks = 0;
    for (std::size_t i = 0; i < departed.size(); ++i)
      if (subset & bit(i)) ranks += part[departed[i]] = winner[departed[i]];
    const auto cost = std::make_pair(size(subset), ranks);
    if (cost < best_cost && row.fit(part) == wanted)
      std::tie(best, best_cost) = std::pair(subset, cost);
  }
  std::vector<std::pair<std::size_t, int>> result;
  for (std::size_t i = 0; i < departed.size(); ++i)
    if (best & bit(i)) result.emplace_back(departed[i], winner[departed[i]]);
  return result;
}

Explanation explain(HypothesisRow& row, const std::vector<std::size_t>& depends,
                    const Assignment& winner) {
  const Assignment stated(winner.size(), 0);
  const Fit as_stated = row.fit(stated);
  const Fit fit = row.fit(winner);
  Explanation result;
  result.value = row.value(stated);
  result.explained_value = row.value(winner);
  result.misprint = fit == Fit::Misprint;
  if (as_stated == Fit::Agrees) {
    result.verdict = Finding::Reproduced;
    result.broken = fit != Fit::Agrees;
  } else if (fit != Fit::Lost) {
    result.verdict = Finding::Explained;
    result.causes = causes(row, depends, winner);
  }
  return result;
}

void count(Reproduction& result) {
  for (const Explanation& row : result.rows) {
    result.reproduced += row.verdict == Finding::Reproduced;
    result.explained += row.verdict == Finding::Explained;
    result.unexplained += row.verdict == Finding::Unexplained;
    result.broken += row.broken;
    result.misprints += row.misprint;
  }
  result.departed =
      result.departures.size() - static_cast<std::size_t>(std::ranges::count(result.departures, 0));
}

}  // namespace

Reproduction reproduce(const PrintedTable& table) {
  check(table);
  Search search(table);
  const std::vector<JudgedChoice>& kept = search.run();
  Reproduction result;
  result.departures = kept.front().choice;
  const std::size_t listed = std::min(kept.size(), kMaxEquals + 1);
  for (std::size_t i = 1; i < listed; ++i) result.equals.push_back(kept[i].choice);
  result.more_equals = kept.size() > listed;
  for (std::size_t row = 0; row < table.printed.size(); ++row) {
    HypothesisRow& memo = search.rows()[row];
    result.rows.push_back(explain(memo, table.depends[row], result.departures));
    result.evaluations += memo.evaluations();
  }
  count(result);
  result.held = table.printed.size() - kept.front().score.lost;
  result.tried = search.tried();
  return result;
}

}  // namespace camlaw::optim
