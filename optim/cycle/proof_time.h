// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "optim/problem/deadline.h"

namespace camlaw::optim {

/// While one of these lives, the proofs over a cycle that this thread makes end where its deadline
/// has passed, undecided: the part of the cycle at which they are is what is left. What is searched
/// for, such as the values that the proofs are about, is found all the same; over ranges of
/// parameters it is then the highest of a few places, without a climb from there.
class ProofTime {
 public:
  /// The deadline must outlive it.
  explicit ProofTime(const Deadline& deadline);
  ProofTime(const ProofTime&) = delete;
  ProofTime& operator=(const ProofTime&) = delete;
  ~ProofTime();

  /// Whether any of the proofs was ended by it.
  bool has_ended_any() const { return ended_; }
  /// To be asked by a proof that ends where it is: whether the deadline of this thread's proofs has
  /// passed. There may be none.
  static bool is_over();

 private:
  const Deadline& deadline_;
  bool ended_ = false;
  ProofTime* before_;
};

/// Counts the parts that a curve's bounds over one stretch of the cycle were made of, such as those
/// of its ranges: a proof that asked for too many ends where it is, undecided.
class PartsOfBounds {
 public:
  /// A part that takes long to bound counts for several.
  static void look_at(std::int64_t count);
  /// By this thread, so far.
  static std::int64_t looked_at();
};

}  // namespace camlaw::optim
