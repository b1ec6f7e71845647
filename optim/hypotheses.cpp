// SPDX-License-Identifier: MIT
#include "optim/hypotheses.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <compare>
#include <cstdint>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <tuple>

namespace camlaw::optim {
namespace {

using Mask = std::uint64_t;  // a set of hypotheses

Mask bit(std::size_t hypothesis) { return Mask{1} << hypothesis; }
std::size_t size(Mask set) { return static_cast<std::size_t>(std::popcount(set)); }

std::size_t choices(const Table& table, std::size_t hypothesis) {
  return table.hypotheses[hypothesis].alternatives.size() + 1;
}

void check_row(const Table& table, std::size_t row) {
  const auto reject = [&](const std::string& what) {
    throw std::invalid_argument(fmt::format("table '{}': row {} {}", table.name, row, what));
  };
  const auto [value, decimals] = table.printed[row];
  if (!std::isfinite(value)) reject(fmt::format("prints {}, which is not finite", value));
  if (decimals < 0 || decimals > kMaxDecimals)
    reject(fmt::format("has {} decimals; accepted are 0 to {}", decimals, kMaxDecimals));
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

void check(const Table& table) {
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

enum class Fit : std::uint8_t { Unknown, Agrees, Misprint, Lost };  // better first

/// What the completions of a partial choice can do for one row: their best fit, and the hypotheses
/// that depart in every completion under which the row holds.
struct Outlook {
  Fit best = Fit::Unknown;
  Mask needed = 0;
};

/// One row: the tree of the choices it depends on, taken in search order, with everything computed
/// about it memoised. A node is (level, index): `level` choices are made, and `index` is their
/// mixed-radix number.
class Row {
 public:
  Row(const Table& table, std::size_t row, const std::vector<std::size_t>& order)
      : table_(table), row_(row), scratch_(table.hypotheses.size(), 0) {
    for (const std::size_t h : order) {
      const auto& depends = table.depends[row];
      if (std::find(depends.begin(), depends.end(), h) == depends.end()) continue;
      depends_.push_back(h);
      if (table.hypotheses[h].unstated) unstated_ |= bit(h);
      first_.push_back(first_.back() + leaves_);
      leaves_ *= choices(table, h);
    }
    outlooks_.resize(first_.back() + leaves_);
    values_.resize(leaves_);
  }

  const Outlook& look(std::size_t level, std::size_t index) {
    Outlook& known = outlooks_[first_[level] + index];
    if (known.best == Fit::Unknown)
      known = level == depends_.size() ? evaluate(index) : over_children(level, index);
    return known;
  }
  Fit fit(const Choice& choice) { return look(depends_.size(), leaf(choice)).best; }
  double value(const Choice& choice) {
    look(depends_.size(), leaf(choice));
    return values_[leaf(choice)];
  }
  std::size_t leaves() const { return leaves_; }
  std::size_t evaluations() const { return evaluations_; }

 private:
  std::size_t leaf(const Choice& choice) const {
    std::size_t index = 0;
    for (const std::size_t h : depends_)
      index = index * choices(table_, h) + static_cast<std::size_t>(choice[h]);
    return index;
  }

  /// Writes the choices of a node into scratch_ and returns the hypotheses that depart in it.
  Mask decode(std::size_t level, std::size_t index) {
    Mask departed = 0;
    for (; level > 0; --level) {
      const std::size_t h = depends_[level - 1];
      scratch_[h] = static_cast<int>(index % choices(table_, h));
      if (scratch_[h] != 0) departed |= bit(h);
      index /= choices(table_, h);
    }
    return departed;
  }

  Outlook evaluate(std::size_t index) {
    const Mask departed = decode(depends_.size(), index);
    values_[index] = std::numeric_limits<double>::quiet_NaN();
    if ((unstated_ & ~departed) == 0) {
      values_[index] = table_.model(row_, scratch_);
      ++evaluations_;
    }
    const PrintedNumber print = table_.printed[row_];
    if (agrees(print, values_[index])) return {Fit::Agrees, departed};
    const bool misprint = table_.allow_misprints && one_digit_misprint(print, values_[index]);
    return {misprint ? Fit::Misprint : Fit::Lost, departed};
  }

  Outlook over_children(std::size_t level, std::size_t index) {
    const Mask least =
        decode(level, index) | unstated_;  // no completion that holds departs in less
    const std::size_t radix = choices(table_, depends_[level]);
    Outlook all{Fit::Lost, ~Mask{0}};
    for (std::size_t child = index * radix; child < (index + 1) * radix; ++child) {
      const Outlook& outlook = look(level + 1, child);
      if (outlook.best == Fit::Lost) continue;
      all = {std::min(all.best, outlook.best), all.needed & outlook.needed};
      if (all.best == Fit::Agrees && all.needed == least) break;  // the rest cannot improve on it
    }
    return all;
  }

  const Table& table_;
  std::size_t row_;
  std::vector<std::size_t> depends_;
  Mask unstated_ = 0;
  std::size_t leaves_ = 1;
  std::vector<std::size_t> first_{0};  // of each level in outlooks_
  std::vector<Outlook> outlooks_;
  std::vector<double> values_;  // of the leaves
  Choice scratch_;
  std::size_t evaluations_ = 0;
};

/// Smaller is better.
struct Score {
  std::size_t lost = 0;
  std::size_t departures = 0;
  std::size_t misprints = 0;
  std::size_t ranks = 0;
  auto operator<=>(const Score&) const = default;
};

struct Candidate {
  Score score;
  Choice choice;
  auto operator<=>(const Candidate&) const = default;
};

bool equals(const Score& a, const Score& b) {
  return std::tie(a.lost, a.departures) == std::tie(b.lost, b.departures);
}

/// Depth-first branch and bound over the hypotheses, the most widely depended-on first.
class Search {
 public:
  explicit Search(const Table& table)
      : table_(table), choice_(table.hypotheses.size(), 0), dependents_(table.hypotheses.size()) {
    for (std::size_t row = 0; row < table.depends.size(); ++row)
      for (const std::size_t h : table.depends[row]) dependents_[h].push_back(row);
    order_.resize(table.hypotheses.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::stable_sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
      return dependents_[a].size() > dependents_[b].size();
    });
    for (std::size_t row = 0; row < table.depends.size(); ++row)
      rows_.emplace_back(table, row, order_);
    nodes_.resize(rows_.size());
    cheap_first_.resize(rows_.size());
    std::iota(cheap_first_.begin(), cheap_first_.end(), std::size_t{0});
    std::stable_sort(cheap_first_.begin(), cheap_first_.end(), [&](std::size_t a, std::size_t b) {
      return rows_[a].leaves() < rows_[b].leaves();
    });
  }

  /// The best assignment and its equals, best first; one more than are listed, to tell whether
  /// there are more.
  const std::vector<Candidate>& run() {
    descend(0, 0, 0);
    return kept_;
  }
  std::vector<Row>& rows() { return rows_; }
  std::size_t tried() const { return tried_; }

 private:
  struct Node {
    std::size_t level = 0;
    std::size_t index = 0;
  };

  void descend(std::size_t depth, Mask departed, std::size_t ranks) {
    ++tried_;
    const std::optional<Score> bound = optimistic(departed, ranks);
    if (!bound) return;
    if (depth == order_.size()) return keep({*bound, choice_});
    const std::size_t h = order_[depth];
    for (std::size_t c = 0; c < choices(table_, h); ++c) {
      choice_[h] = static_cast<int>(c);
      for (const std::size_t row : dependents_[h])
        nodes_[row] = {nodes_[row].level + 1, nodes_[row].index * choices(table_, h) + c};
      descend(depth + 1, c == 0 ? departed : departed | bit(h), ranks + c);
      for (const std::size_t row : dependents_[h])
        nodes_[row] = {nodes_[row].level - 1, nodes_[row].index / choices(table_, h)};
    }
    choice_[h] = 0;
  }

  /// A score that no completion of the current partial choice beats (its own score if complete), or
  /// nothing if none can be kept. Admissible: a completion that loses no more rows than the bound
  /// holds every row that can hold, so it departs in all that those rows need.
  std::optional<Score> optimistic(Mask departed, std::size_t ranks) {
    Score bound{.departures = size(departed), .ranks = ranks};
    Mask needed = departed;
    for (const std::size_t row : cheap_first_) {
      if (hopeless(bound)) return std::nullopt;
      const Outlook& outlook = rows_[row].look(nodes_[row].level, nodes_[row].index);
      if (outlook.best == Fit::Lost) {
        ++bound.lost;
        continue;
      }
      if (outlook.best == Fit::Misprint) ++bound.misprints;
      needed |= outlook.needed;
      bound.departures = size(needed) + bound.misprints;
      bound.ranks = ranks + size(needed & ~departed);
    }
    return hopeless(bound) ? std::nullopt : std::optional(bound);
  }

  bool hopeless(const Score& bound) const {
    if (kept_.empty()) return false;
    const Score& best = kept_.front().score;
    if (std::tie(bound.lost, bound.departures) > std::tie(best.lost, best.departures)) return true;
    return kept_.size() == kKept && bound > kept_.back().score;
  }

  void keep(Candidate candidate) {
    if (!kept_.empty() && !equals(candidate.score, kept_.front().score)) kept_.clear();
    kept_.insert(std::upper_bound(kept_.begin(), kept_.end(), candidate), std::move(candidate));
    if (kept_.size() > kKept) kept_.pop_back();
  }

  static constexpr std::size_t kKept = 1 + kMaxEquals + 1;

  const Table& table_;
  Choice choice_;
  std::vector<std::vector<std::size_t>> dependents_;  // rows, per hypothesis
  std::vector<std::size_t> order_;                    // hypotheses
  std::vector<Row> rows_;
  std::vector<Node> nodes_;               // where the partial choice stands in each row's tree
  std::vector<std::size_t> cheap_first_;  // rows
  std::vector<Candidate> kept_;
  std::size_t tried_ = 0;
};

/// The smallest part of the winner's departures that fits the row as well as the whole does; of
/// equally small ones the lowest sum of ranks.
std::vector<std::pair<std::size_t, int>> causes(Row& row, const std::vector<std::size_t>& depends,
                                                const Choice& winner) {
  std::vector<std::size_t> departed;
  std::copy_if(depends.begin(), depends.end(), std::back_inserter(departed),
               [&](std::size_t h) { return winner[h] != 0; });
  std::sort(departed.begin(), departed.end());
  const Fit wanted = row.fit(winner);
  Mask best = 0;
  auto best_cost = std::make_pair(kMaxHypotheses + 1, 0);
  for (Mask subset = 0; subset < bit(departed.size()); ++subset) {
    if (size(subset) > best_cost.first) continue;
    Choice part(winner.size(), 0);
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

Explanation explain(Row& row, const std::vector<std::size_t>& depends, const Choice& winner) {
  const Choice stated(winner.size(), 0);
  const Fit as_stated = row.fit(stated);
  const Fit fit = row.fit(winner);
  Explanation result;
  result.value = row.value(stated);
  result.explained_value = row.value(winner);
  result.misprint = fit == Fit::Misprint;
  if (as_stated == Fit::Agrees) {
    result.verdict = Verdict::Reproduced;
    result.broken = fit != Fit::Agrees;
  } else if (fit != Fit::Lost) {
    result.verdict = Verdict::Explained;
    result.causes = causes(row, depends, winner);
  }
  return result;
}

void count(Reproduction& result) {
  for (const Explanation& row : result.rows) {
    result.reproduced += row.verdict == Verdict::Reproduced;
    result.explained += row.verdict == Verdict::Explained;
    result.unexplained += row.verdict == Verdict::Unexplained;
    result.broken += row.broken;
    result.misprints += row.misprint;
  }
  result.departed =
      result.departures.size() - static_cast<std::size_t>(std::ranges::count(result.departures, 0));
}

}  // namespace

Reproduction reproduce(const Table& table) {
  check(table);
  Search search(table);
  const std::vector<Candidate>& kept = search.run();
  Reproduction result;
  result.departures = kept.front().choice;
  const std::size_t listed = std::min(kept.size(), kMaxEquals + 1);
  for (std::size_t i = 1; i < listed; ++i) result.equals.push_back(kept[i].choice);
  result.more_equals = kept.size() > listed;
  for (std::size_t row = 0; row < table.printed.size(); ++row) {
    Row& memo = search.rows()[row];
    result.rows.push_back(explain(memo, table.depends[row], result.departures));
    result.evaluations += memo.evaluations();
  }
  count(result);
  result.held = table.printed.size() - kept.front().score.lost;
  result.tried = search.tried();
  return result;
}

}  // namespace camlaw::optim
