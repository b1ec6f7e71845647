// SPDX-License-Identifier: MIT
#include "problems/fits/corner.h"

#include <Eigen/QR>
#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace camlaw::problems {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The samples of a window, the corner's neighbourhood, in few points of equal weight.
struct Window {
  VectorXd x, s;
  double noise;
  CornerSides scale;  ///< of the powers on each side; 0: a dwell
};

/// (I10) The powers that leave the level: order, order + stride, ..., `terms` of them on each
/// moving side. Laws of sines have odd powers alone, a stride of 2.
struct Shape {
  int order, stride, terms;
};

struct Fit {
  double squares = std::numeric_limits<double>::infinity();
  VectorXd coefficients;
};

MatrixXd columns(const Window& window, const Shape& shape, double place) {
  const int sides = (window.scale.before > 0) + (window.scale.after > 0);
  MatrixXd A = MatrixXd::Zero(window.x.size(), 1 + sides * shape.terms);
  for (Index i = 0; i < A.rows(); ++i) {
    A(i, 0) = 1;
    const double distance = window.x[i] - place;
    const double scale = distance < 0 ? window.scale.before : window.scale.after;
    if (scale == 0) continue;
    const Index first = distance < 0 || window.scale.before == 0 ? 1 : 1 + shape.terms;
    const double u = std::abs(distance) / scale;
    const double more = shape.stride == 2 ? u * u : u;
    double power = std::pow(u, shape.order);
    for (int k = 0; k < shape.terms; ++k, power *= more) A(i, first + k) = power;
  }
  return A;
}

Fit fitted(const Window& window, const Shape& shape, double place) {
  const MatrixXd A = columns(window, shape, place);
  Fit fit;
  fit.coefficients = A.householderQr().solve(window.s);
  const double squares = (window.s - A * fit.coefficients).squaredNorm();
  if (std::isfinite(squares)) fit.squares = squares;  // not so where a side has no samples
  return fit;
}

struct Found {
  double place, squares;
};

/// Over the place the squares have several valleys: a grid finds the right one.
Found best_place(const Window& window, const Shape& shape, double low, double high) {
  constexpr int kSteps = 40;
  const double step = (high - low) / kSteps;
  const auto squares = [&](double place) { return fitted(window, shape, place).squares; };
  Found best{low, std::numeric_limits<double>::infinity()};
  for (int i = 0; i <= kSteps; ++i) {
    const double place = low + i * step, here = squares(place);
    if (here < best.squares) best = {place, here};
  }
  constexpr int kBits = 24;
  const auto [place, least] = boost::math::tools::brent_find_minima(
      squares, std::max(low, best.place - step), std::min(high, best.place + step), kBits);
  return least < best.squares ? Found{place, least} : best;
}

/// The error of the place: it moves the fit by its slope there, as one more column.
double error_of(const Window& window, const Shape& shape, double place) {
  const MatrixXd A = columns(window, shape, place);
  const VectorXd c = A.colPivHouseholderQr().solve(window.s);
  const double h = 1e-4 * std::max(window.scale.before, window.scale.after);
  const VectorXd slope =
      (columns(window, shape, place + h) * c - columns(window, shape, place - h) * c) / (2 * h);
  const double own = (slope - A * A.colPivHouseholderQr().solve(slope)).norm();
  return own > 0 ? window.noise / own : std::numeric_limits<double>::infinity();
}

/// Neighbours are averaged where there are more than a fit needs.
Window window_of(const CornerSamples& samples, const CornerSides& sides, double share, double guess,
                 double noise) {
  const auto at = [&](double x) {
    return static_cast<std::size_t>(std::lower_bound(samples.x.begin(), samples.x.end(), x) -
                                    samples.x.begin());
  };
  const std::size_t begin = sides.before > 0 ? at(guess - share * sides.before) : 0;
  const std::size_t end = sides.after > 0 ? at(guess + share * sides.after) : samples.x.size();
  constexpr std::size_t kMost = 600;
  const std::size_t group = (end - begin + kMost - 1) / kMost;
  Window window{{}, {}, noise, {share * sides.before, share * sides.after}};
  if (group == 0) return window;
  const std::size_t count = (end - begin) / group;
  window.x = window.s = VectorXd::Zero(static_cast<Index>(count));
  for (std::size_t i = 0; i < count * group; ++i) {
    window.x[static_cast<Index>(i / group)] += samples.x[begin + i] / static_cast<double>(group);
    window.s[static_cast<Index>(i / group)] += samples.s[begin + i] / static_cast<double>(group);
  }
  window.noise = noise / std::sqrt(static_cast<double>(group));
  return window;
}

/// Whether each moving side has samples enough for so many terms.
bool is_enough(const Window& window, const Shape& shape, double place) {
  Index before = 0;
  while (before < window.x.size() && window.x[before] < place) ++before;
  const Index after = window.x.size() - before;
  const Index wanted = 2 * shape.terms + 1;
  return (window.scale.before == 0 ? before > 1 : before >= wanted) &&
         (window.scale.after == 0 ? after > 1 : after >= wanted);
}

struct Candidate {
  Shape shape;
  Found found;
  double cost;     ///< chi square and what its parameters cost
  double excess;   ///< of chi square over what noise explains, in its deviations
  double reduced;  ///< chi square by degree of freedom
};

/// (I11) What Bayes' criterion says of a shape at its best place; none where samples are too few.
std::optional<Candidate> candidate_of(const Window& window, const Shape& shape, double low,
                                      double high) {
  if (!is_enough(window, shape, 0.5 * (low + high))) return {};
  const int sides = (window.scale.before > 0) + (window.scale.after > 0);
  const double parameters = 2 + sides * shape.terms;
  const double n = static_cast<double>(window.x.size()), rest = n - parameters;
  if (!(rest > 0)) return {};
  const Found found = best_place(window, shape, low, high);
  const double chi = found.squares / (window.noise * window.noise);
  // Powers other than the third, a jump of the jerk, need strong evidence: noise hardly tells them
  // apart, and the place depends on it.
  // And Bayes' criterion twice over: powers that are hardly there move the place most.
  constexpr double kStrong = 25, kPenalty = 2;
  const double cost = chi + kPenalty * std::log(n) * parameters + (shape.order == 3 ? 0 : kStrong);
  return Candidate{shape, found, cost, (chi - rest) / std::sqrt(2 * rest), chi / rest};
}

/// All shapes, the best one first.
std::vector<Candidate> candidates(const Window& window, double low, double high) {
  std::vector<Candidate> found;
  for (const int order : {3, 2, 4}) {
    for (const int stride : {1, 2}) {
      for (int terms = 2; terms <= 4; ++terms) {
        const auto one = candidate_of(window, {order, stride, terms}, low, high);
        if (one) found.push_back(*one);
      }
    }
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.cost < b.cost; });
  return found;
}

/// Half of how far the places of shapes lie apart that are nearly as good as the best.
double spread(const std::vector<Candidate>& found) {
  constexpr double kNearly = 25;  // what two terms more may cost
  double least = found.front().found.place, most = least;
  for (const Candidate& candidate : found) {
    if (candidate.cost > found.front().cost + kNearly) continue;
    least = std::min(least, candidate.found.place);
    most = std::max(most, candidate.found.place);
  }
  return 0.5 * (most - least);
}

}  // namespace

Corner find_corner(const CornerSamples& samples, const CornerSides& sides, double guess, double low,
                   double high, double noise) {
  constexpr double kUnexplained = 4;
  Corner corner{guess, 0, 0.5 * (high - low)};
  double from = low, to = high;
  for (const double share : {0.5, 0.25, 0.125, 0.0625}) {
    const Window window = window_of(samples, sides, share, corner.place, noise);
    const auto found = candidates(window, from, to);
    if (found.empty()) break;
    const Candidate& best = found.front();
    const double place = best.found.place;
    const double error =
        error_of(window, best.shape, place) * std::sqrt(std::max(best.reduced, 1.0));
    corner = {place, fitted(window, best.shape, place).coefficients[0],
              std::hypot(error, spread(found))};
    if (best.excess < kUnexplained) break;
    // A wider window has told where to look.
    const double margin = 0.25 * share * std::max(sides.before, sides.after);
    from = std::max(low, place - margin);
    to = std::min(high, place + margin);
  }
  return corner;
}

}  // namespace camlaw::problems
