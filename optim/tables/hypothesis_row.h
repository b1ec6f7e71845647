// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

#include "optim/tables/hypotheses.h"

/// One printed value in the search of optim/tables/hypotheses.h (internal).
namespace camlaw::optim::detail {

using Mask = std::uint64_t;  // a set of hypotheses

inline Mask bit(std::size_t hypothesis) { return Mask{1} << hypothesis; }
inline std::size_t size(Mask set) { return static_cast<std::size_t>(std::popcount(set)); }

inline std::size_t choices(const PrintedTable& table, std::size_t hypothesis) {
  return table.hypotheses[hypothesis].alternatives.size() + 1;
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
class HypothesisRow {
 public:
  HypothesisRow(const PrintedTable& table, std::size_t row, const std::vector<std::size_t>& order)
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
  Fit fit(const Assignment& choice) { return look(depends_.size(), leaf(choice)).best; }
  double value(const Assignment& choice) {
    look(depends_.size(), leaf(choice));
    return values_[leaf(choice)];
  }
  std::size_t leaves() const { return leaves_; }
  std::size_t evaluations() const { return evaluations_; }

 private:
  std::size_t leaf(const Assignment& choice) const {
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

  const PrintedTable& table_;
  std::size_t row_;
  std::vector<std::size_t> depends_;
  Mask unstated_ = 0;
  std::size_t leaves_ = 1;
  std::vector<std::size_t> first_{0};  // of each level in outlooks_
  std::vector<Outlook> outlooks_;
  std::vector<double> values_;  // of the leaves
  Assignment scratch_;
  std::size_t evaluations_ = 0;
};

}  // namespace camlaw::optim::detail
