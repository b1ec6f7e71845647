// SPDX-License-Identifier: MIT
#include "fitting/samples/stand_ins.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "numerics/linear/dense.h"
#include "numerics/linear/statistics.h"

namespace camlaw::problems {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index kNodes = 5;  // of a block

/// Polynomials orthonormal over the places of a block, and the matrix of their recurrence.
struct Orthonormal {
  MatrixXd columns;  ///< the values of each at the places
  MatrixXd jacobi;
};

/// By Stieltjes' procedure (Gautschi 2004, Orthogonal Polynomials, 2.2.3); as many as there are
/// places that differ. `t` lie in [-1, 1].
Orthonormal orthonormal(const VectorXd& t) {
  constexpr double kNothing = 1e-10;  // next to the places' distance
  Orthonormal result{MatrixXd(t.size(), kNodes), MatrixXd::Zero(kNodes, kNodes)};
  VectorXd next = VectorXd::Constant(t.size(), 1 / std::sqrt(static_cast<double>(t.size())));
  Index count = 0;
  for (double length = 0; count < kNodes; ++count) {
    result.columns.col(count) = next;
    const VectorXd moved = t.cwiseProduct(next);
    result.jacobi(count, count) = next.dot(moved);
    VectorXd rest = moved - result.jacobi(count, count) * next;
    if (count > 0) rest -= length * result.columns.col(count - 1);
    length = rest.norm();
    if (!(length > kNothing)) break;
    next = rest / length;
    if (count + 1 < kNodes) result.jacobi(count + 1, count) = length;
  }
  const Index found = std::min(count + 1, kNodes);
  result.columns.conservativeResize(Eigen::NoChange, found);
  result.jacobi.conservativeResize(found, found);
  return result;
}

/// How many samples a block has, and how wide it is at most.
struct BlockSize {
  std::size_t count;
  double width;
};

}  // namespace

SampleBlocks::SampleBlocks(const MotionSamples& samples, double low, double high)
    : samples_(samples) {
  constexpr std::size_t kBlocks = 160;  // from low to high
  constexpr double kAtRest = 8;         // times as wide and as many beyond
  constexpr double kUneven = 1.5;       // times the width of a block of evenly spread samples
  const std::size_t n = samples.place.size();
  if (!std::is_sorted(samples.place.begin(), samples.place.end())) {
    order_ = optim::order_of(samples.place);
  }
  if (n == 0) return;
  low = std::max(low, place(0)), high = std::min(high, place(n - 1));
  const auto inside = static_cast<std::size_t>(
      std::count_if(samples.place.begin(), samples.place.end(),
                    [&](double place) { return place >= low && place <= high; }));
  const BlockSize moving{std::max<std::size_t>(inside / kBlocks, 1),
                         kUneven * (high - low) / kBlocks};
  for (std::size_t first = 0; first < n;) {
    const double begin = place(first);
    const bool rests = begin < low || begin > high;
    const double size = rests ? kAtRest : 1;
    const double end = std::min(begin + size * moving.width,
                                begin < low ? low : std::numeric_limits<double>::infinity());
    const auto most = static_cast<std::size_t>(size) * moving.count;
    std::size_t count = 1;
    while (first + count < n && count < most && place(first + count) < end) ++count;
    add_block(first, count);
    first += count;
  }
}

void SampleBlocks::add_block(std::size_t first, std::size_t count) {
  Block block{first, count, places_.size(), 0, 0};
  const auto n = static_cast<Index>(count);
  if (n <= kNodes) {
    for (std::size_t i = first; i < first + count; ++i) {
      places_.push_back(place(i)), values_.push_back(samples_.value[at(i)]), roots_.push_back(1);
    }
  } else {
    const double from = place(first), to = place(first + count - 1);
    const double middle = from + (to - from) / 2, half = to > from ? (to - from) / 2 : 1;
    VectorXd t(n), y(n);
    for (Index i = 0; i < n; ++i) {
      const std::size_t k = first + static_cast<std::size_t>(i);
      t[i] = (place(k) - middle) / half;
      y[i] = samples_.value[at(k)];
    }
    const double mean = y.mean();
    y.array() -= mean;
    const Orthonormal basis = orthonormal(t);
    const VectorXd parts = basis.columns.transpose() * y;
    block.rest = (y - basis.columns * parts).squaredNorm();
    const optim::SymmetricEigen nodes = optim::symmetric_eigen(basis.jacobi);
    for (Index k = 0; k < nodes.values.size(); ++k) {
      // sqrt(n) times the first entry of its eigenvector is the root of a node's weight (Golub and
      // Welsch 1969), and the polynomials' values there are the vector over that entry.
      const double root = std::sqrt(static_cast<double>(n)) * nodes.vectors(0, k);
      places_.push_back(middle + half * nodes.values[k]);
      values_.push_back(mean + parts.dot(nodes.vectors.col(k)) / root);
      roots_.push_back(std::abs(root));
    }
  }
  block.nodes = places_.size() - block.node;
  blocks_.push_back(block);
}

std::vector<bool> SampleBlocks::broken(std::span<const double> breaks, double beside) const {
  std::vector<bool> result;
  for (std::size_t k = 0; k < blocks_.size(); ++k) {
    const Block& block = blocks_[k];
    const double from = place(block.first), to = place(block.first + block.count - 1);
    // A break in a gap between samples is in no block.
    const double reach = beside * (to - from);
    result.push_back(std::any_of(breaks.begin(), breaks.end(), [&](double at) {
      return at >= from - reach && at <= to + reach;
    }));
  }
  return result;
}

StandIns SampleBlocks::stand_ins(std::span<const double> breaks) const {
  constexpr double kBeside = 0.25;  // of a block's width
  StandIns result(samples_.none());
  result.all = samples_.place.size();
  const std::vector<bool> is_broken = broken(breaks, kBeside);
  const auto add = [&](double place, double value, double root) {
    result.samples.place.push_back(place);
    result.samples.value.push_back(value);
    result.roots.push_back(root);
  };
  for (std::size_t k = 0; k < blocks_.size(); ++k) {
    const Block& block = blocks_[k];
    if (is_broken[k]) {
      for (std::size_t i = block.first; i < block.first + block.count; ++i) {
        add(place(i), samples_.value[at(i)], 1);
      }
      continue;
    }
    for (std::size_t i = block.node; i < block.node + block.nodes; ++i) {
      add(places_[i], values_[i], roots_[i]);
    }
    result.rest += block.rest;
  }
  return result;
}

bool SampleBlocks::are_for(std::span<const double> breaks, std::span<const double> others) const {
  constexpr double kBeside = 0.25;  // of a block's width, as in stand_ins()
  const std::vector<bool> kept = broken(breaks, kBeside), needed = broken(others, 0);
  for (std::size_t k = 0; k < blocks_.size(); ++k) {
    if (needed[k] && !kept[k]) return false;
  }
  return true;
}

bool are_very_many(const MotionSamples& samples) {
  // So few are fitted as fast as their stand-ins are made.
  constexpr std::size_t kVeryMany = 4000;
  return samples.place.size() >= kVeryMany;
}

}  // namespace camlaw::problems
