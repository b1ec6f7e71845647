// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "fitting/samples/motion_samples.h"

/// Few samples that stand for very many: what they leave of a curve, and what no curve follows, is
/// what the many leave of it (docs/optimisation.md, "Very many samples").
namespace camlaw::problems {

/// (FS10) sum_i (f(x_i) - y_i)^2 of all = sum_k roots[k]^2 (f(place[k]) - value[k])^2 + rest.
struct StandIns {
  StandIns() = default;
  /// Each stands for itself.
  StandIns(MotionSamples own) : samples(std::move(own)), all(samples.place.size()) {}

  MotionSamples samples;
  std::vector<double> roots;  ///< of how many of all samples each stands for; none: 1 each
  std::size_t all = 0;        ///< samples that they stand for
  double rest = 0;            ///< sum of squares
};

/// All samples in blocks of neighbours, each narrow beside a motion. A block's stand-ins are the
/// nodes of Gauss's quadrature over its places with the values of the polynomial through its
/// samples by least squares: (FS10) holds for curves that are polynomials of the fourth degree
/// within each block.
class SampleBlocks {
 public:
  /// For motions between the places `low` and `high`; far beyond these, where all is at rest,
  /// blocks are wider. Keeps a reference to the samples.
  SampleBlocks(const MotionSamples& samples, double low, double high);
  SampleBlocks(const SampleBlocks&) = delete;
  SampleBlocks& operator=(const SampleBlocks&) = delete;

  /// With the samples themselves in blocks that one of the places lies in or just beside: there the
  /// curve's derivatives may jump.
  StandIns stand_ins(std::span<const double> breaks) const;
  /// Whether those for some breaks are so for others too: each of these lies in a block, or beyond
  /// all, of which the samples stand for themselves.
  bool are_for(std::span<const double> breaks, std::span<const double> others) const;

 private:
  struct Block {
    std::size_t first = 0, count = 0;  ///< of the samples, by place
    std::size_t node = 0, nodes = 0;
    double rest = 0;
  };

  std::size_t at(std::size_t i) const { return order_.empty() ? i : order_[i]; }
  double place(std::size_t i) const { return samples_.place[at(i)]; }
  void add_block(std::size_t first, std::size_t count);
  std::vector<bool> broken(std::span<const double> breaks, double beside) const;

  const MotionSamples& samples_;
  std::vector<std::size_t> order_;  ///< by place; empty where the samples are
  std::vector<Block> blocks_;
  std::vector<double> places_, values_, roots_;  ///< of all nodes
};

/// Whether there are so many samples that fits go by stand-ins.
bool are_very_many(const MotionSamples& samples);

}  // namespace camlaw::problems
