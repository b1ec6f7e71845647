// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <compare>
#include <numeric>
#include <optional>
#include <tuple>
#include <vector>

#include "optim/tables/hypothesis_row.h"

/// The search of optim/tables/hypotheses.h over all rows (internal).
namespace camlaw::optim::detail {

/// Smaller is better.
struct Score {
  std::size_t lost = 0;
  std::size_t departures = 0;
  std::size_t misprints = 0;
  std::size_t ranks = 0;
  auto operator<=>(const Score&) const = default;
};

struct JudgedChoice {
  Score score;
  Assignment choice;
  auto operator<=>(const JudgedChoice&) const = default;
};

inline bool equals(const Score& a, const Score& b) {
  return std::tie(a.lost, a.departures) == std::tie(b.lost, b.departures);
}

/// Depth-first branch and bound over the hypotheses, the most widely depended-on first.
class Search {
 public:
  explicit Search(const PrintedTable& table)
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
  const std::vector<JudgedChoice>& run() {
    descend(0, 0, 0);
    return kept_;
  }
  std::vector<HypothesisRow>& rows() { return rows_; }
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

  void keep(JudgedChoice candidate) {
    if (!kept_.empty() && !equals(candidate.score, kept_.front().score)) kept_.clear();
    kept_.insert(std::upper_bound(kept_.begin(), kept_.end(), candidate), std::move(candidate));
    if (kept_.size() > kKept) kept_.pop_back();
  }

  /// The best, those as good that are listed, and one more, which tells that there are others.
  static constexpr std::size_t kKept = 1 + kMaxEquals + 1;

  const PrintedTable& table_;
  Assignment choice_;
  std::vector<std::vector<std::size_t>> dependents_;  // rows, per hypothesis
  std::vector<std::size_t> order_;                    // hypotheses
  std::vector<HypothesisRow> rows_;
  std::vector<Node> nodes_;               // where the partial choice stands in each row's tree
  std::vector<std::size_t> cheap_first_;  // rows
  std::vector<JudgedChoice> kept_;
  std::size_t tried_ = 0;
};

}  // namespace camlaw::optim::detail
