// SPDX-License-Identifier: MIT
#include "fitting/motions/sketches.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

#include "fitting/motions/fit_parameters.h"
#include "fitting/motions/motion_residuals.h"
#include "numerics/linear/dense.h"
#include "numerics/linear/statistics.h"
#include "optim/problem/function.h"

namespace camlaw::problems {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

/// Of the samples before a motion, in it and after it that may depart: else they would not show the
/// law and its ends.
constexpr double kMostOfPart[] = {0.75, 0.6, 0.75};
constexpr std::size_t kLeastOfPart = 9;  ///< fewer samples show no rest

enum Part : std::size_t { Before, Within, After };
using PartCounts = std::array<std::size_t, 3>;

Part part_at(double place, const MotionGuess& motion) {
  return place < motion.begin ? Before : place > motion.end ? After : Within;
}

bool leaves_enough(const PartCounts& gone, const PartCounts& all) {
  for (const Part part : {Before, Within, After}) {
    if (all[part] < kLeastOfPart) continue;
    if (static_cast<double>(gone[part]) > kMostOfPart[part] * static_cast<double>(all[part])) {
      return false;
    }
  }
  return true;
}

/// Neighbouring samples, as blocks from the first to before the last.
struct BlockRange {
  std::size_t first, last;
};

/// What a law leaves of a motion, to first order in its numbers, without samples in windows; sums
/// of blocks of neighbours make it cheap to try many.
class LawWithout {
 public:
  /// `left` and `columns`: residuals and Jacobian, by place, in deviations of the noise; `parts`:
  /// where each of the samples lies; `scatter`: of each.
  LawWithout(VectorXd left, const MatrixXd& columns, const std::vector<Part>& parts,
             const std::vector<double>& scatter)
      : count_(static_cast<std::size_t>(left.size())) {
    MatrixXd basis(left.size(), 0);
    if (columns.cols() > 0) {
      basis = optim::column_space(columns.colwise().normalized());
      left -= basis * (basis.transpose() * left);
    }
    // Every pair of blocks bounds a window: twice as many take four times as long. A block of one
    // sample would be a window for each outlier.
    constexpr std::size_t kBlocks = 80, kLeastOfBlock = 2;
    blocks_ = std::min(kBlocks, std::max<std::size_t>(1, count_ / kLeastOfBlock));
    const Index p = basis.cols();
    information_.assign(1, MatrixXd::Zero(p, p));
    pulled_.assign(1, VectorXd::Zero(p));
    squares_.assign(1, 0);
    parts_.assign(1, {});
    scatter_.assign(1, 0);
    for (std::size_t k = 0; k < blocks_; ++k) {
      const auto from = static_cast<Index>(begin_of(k)),
                 size = static_cast<Index>(begin_of(k + 1)) - from;
      const MatrixXd own = basis.middleRows(from, size);
      const VectorXd r = left.segment(from, size);
      information_.emplace_back(information_.back() + own.transpose() * own);
      pulled_.emplace_back(pulled_.back() + own.transpose() * r);
      squares_.push_back(squares_.back() + r.squaredNorm());
      scatter_.push_back(
          std::accumulate(scatter.begin() + from, scatter.begin() + from + size, scatter_.back()));
      PartCounts counts = parts_.back();
      for (Index i = from; i < from + size; ++i) ++counts[parts[static_cast<std::size_t>(i)]];
      parts_.push_back(counts);
    }
  }

  std::size_t blocks() const { return blocks_; }
  /// The sample that a block begins with.
  std::size_t begin_of(std::size_t block) const { return block * count_ / blocks_; }
  /// The scatter of what the windows take away.
  double scatter_in(const std::vector<BlockRange>& windows) const {
    double sum = 0;
    for (const BlockRange& w : windows) sum += scatter_[w.last] - scatter_[w.first];
    return sum;
  }
  /// Whether what the windows leave shows the motion and the rests beside it.
  bool leave_enough(const std::vector<BlockRange>& windows) const {
    PartCounts gone{};
    for (const BlockRange& w : windows) {
      for (const Part part : {Before, Within, After}) {
        gone[part] += parts_[w.last][part] - parts_[w.first][part];
      }
    }
    return leaves_enough(gone, parts_.back());
  }

  /// (WR3) The least sum of squares outside the windows; none where the samples there do not
  /// determine the law.
  std::optional<double> squares(const std::vector<BlockRange>& windows) const {
    constexpr double kLeast = 1e-4;  // of what all samples say of a number
    MatrixXd information = information_.back();
    VectorXd pulled = pulled_.back();
    double squares = squares_.back();
    for (const BlockRange& w : windows) {
      information -= information_[w.last] - information_[w.first];
      pulled -= pulled_[w.last] - pulled_[w.first];
      squares -= squares_[w.last] - squares_[w.first];
    }
    if (pulled.size() == 0) return squares;
    const auto inverse = optim::positive_definite_inverse(information, kLeast);
    if (!inverse) return {};
    return std::max(squares - pulled.dot(*inverse * pulled), 0.0);
  }

 private:
  std::size_t count_, blocks_ = 1;
  std::vector<MatrixXd> information_;  ///< sums over the blocks before
  std::vector<VectorXd> pulled_;
  std::vector<double> squares_, scatter_;
  std::vector<PartCounts> parts_;
};

/// The window that helps most beside those that are there; none where none helps. `in`: how many
/// times its scatter a sample may leave for it to stay.
std::optional<BlockRange> next_window(const LawWithout& law, const std::vector<BlockRange>& windows,
                                      double in) {
  constexpr double kMost = 0.5;  // of all samples
  // A window that is a tenth too wide or too narrow still leads to the right one.
  constexpr double kWider = 1.2;
  const auto value = [&](const std::vector<BlockRange>& of) -> std::optional<double> {
    const auto squares = law.squares(of);
    if (!squares) return {};
    return *squares + in * law.scatter_in(of);
  };
  const auto before = value(windows);
  if (!before) return {};
  double least = *before;
  std::optional<BlockRange> best;
  std::vector<BlockRange> with = windows;
  with.push_back({0, 0});
  const auto most = static_cast<std::size_t>(kMost * static_cast<double>(law.blocks()));
  for (std::size_t width = 2; width <= most;
       width = std::max(width + 1, static_cast<std::size_t>(kWider * static_cast<double>(width)))) {
    for (std::size_t first = 0; first + width <= law.blocks(); ++first) {
      const BlockRange window{first, first + width};
      const bool meets = std::any_of(windows.begin(), windows.end(), [&](const BlockRange& w) {
        return window.first <= w.last && w.first <= window.last;
      });
      if (meets) continue;
      with.back() = window;
      if (!law.leave_enough(with)) continue;
      const auto own = value(with);
      if (own && *own < least) least = *own, best = window;
    }
  }
  return best;
}

LawWithout law_without(const MotionSamples& samples, const std::vector<std::size_t>& order,
                       const LawFit& fit, const Scatter& scatter) {
  const std::size_t n = samples.place.size(), p = fit.fit.parameters.size();
  std::vector<double> r(n), rows(n * p);
  const auto count = static_cast<Index>(n);
  if (!MotionResiduals(samples, fit.law, fit.skew).evaluate(values_of(fit.fit), r, rows)) {
    return {VectorXd::Constant(count, optim::kInfinity), MatrixXd(count, 0),
            std::vector<Part>(n, Within), std::vector<double>(n)};
  }
  std::vector<std::size_t> free;
  for (std::size_t j = 0; j < p; ++j) {
    const optim::FittedParameter& one = fit.fit.parameters[j];
    if (!one.at_bound && one.standard_deviation != 0) free.push_back(j);
  }
  VectorXd left(count);
  MatrixXd columns(count, static_cast<Index>(free.size()));
  std::vector<Part> parts;
  std::vector<double> own;
  for (Index i = 0; i < count; ++i) {
    const std::size_t k = order[static_cast<std::size_t>(i)];
    left[i] = r[k] / scatter.noise;
    own.push_back(scatter.squares[k]);
    parts.push_back(part_at(samples.place[k], fit.motion()));
    for (std::size_t j = 0; j < free.size(); ++j) {
      columns(i, static_cast<Index>(j)) = rows[k * p + free[j]];
    }
  }
  return {std::move(left), columns, parts, own};
}

/// Adds a law with the one and two windows that help it most, to first order.
void add_with_windows(const MotionSamples& samples, const std::vector<std::size_t>& order,
                      const LawFit& fit, const LawWithout& law, double in, Sketch sketch,
                      std::vector<Sketch>& sketches) {
  std::vector<BlockRange> windows;
  while (windows.size() < kMostStretches) {
    const auto next = next_window(law, windows, in);
    if (!next) return;
    windows.push_back(*next);
    const std::size_t from = law.begin_of(next->first), to = law.begin_of(next->last) - 1;
    sketch.windows.push_back(
        {samples.place[order[from]], samples.place[order[to]], 0, to - from + 1});
    sketch.score = departure_score(*law.squares(windows) + law.scatter_in(windows), order.size(),
                                   fit, windows.size());
    sketches.push_back(sketch);
  }
}

}  // namespace

double departure_score(double squares, std::size_t samples, const LawFit& law,
                       std::size_t stretches) {
  constexpr double kOfStretch = 6;  // its ends, and a curve of four numbers between
  const std::size_t coefficients = law.numbers - std::min(law.numbers, law.base);
  return squares +
         std::log(static_cast<double>(samples)) *
             (static_cast<double>(law.numbers) + kOfStretch * static_cast<double>(stretches)) +
         2 * std::log(3.0) * static_cast<double>(coefficients);
}

std::vector<Sketch> sketches_of(const FoundMotion& motion, const std::vector<LawFit>& ranking,
                                const Scatter& scatter) {
  constexpr double kIns[] = {2, 1.1};
  const MotionSamples& samples = motion.samples;
  const std::vector<std::size_t> order = optim::order_of(samples.place);
  std::vector<Sketch> result;
  for (std::size_t l = 0; l < ranking.size(); ++l) {
    const LawFit& fit = ranking[l];
    const LawWithout law = law_without(samples, order, fit, scatter);
    const auto squares = law.squares({});
    if (!squares || !std::isfinite(*squares)) continue;
    const Sketch whole{l, {}, departure_score(*squares, order.size(), fit, 0)};
    result.push_back(whole);
    for (const double in : kIns) {
      add_with_windows(samples, order, fit, law, in, whole, result);
    }
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const Sketch& a, const Sketch& b) { return a.score < b.score; });
  return result;
}

bool shows_motion(const MotionSamples& samples, const LawFit& law,
                  const std::vector<Departure>& departures) {
  PartCounts gone{}, all{};
  for (const double place : samples.place) {
    const Part part = part_at(place, law.motion());
    ++all[part];
    if (departs(place, departures)) ++gone[part];
  }
  return leaves_enough(gone, all);
}

}  // namespace camlaw::problems
