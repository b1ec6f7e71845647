// SPDX-License-Identifier: MIT
#include "fitting/motions/corner.h"

#include <Eigen/Core>
#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "numerics/linear/dense.h"

namespace camlaw::problems {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The samples of a window, the corner's neighbourhood, in few points of equal weight.
struct Window {
  VectorXd x, s;
  double noise;
  CornerSides scale;   ///< of the powers on each side; 0: a dwell
  double others = 0;   ///< chi square of the samples beyond it, by the smooth curve
  double freedom = 0;  ///< the curve's degrees of freedom there
  double samples = 0;  ///< with those beyond
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
  fit.coefficients = optim::householder_qr(A).solve(window.s);
  const double squares = (window.s - A * fit.coefficients).squaredNorm();
  if (std::isfinite(squares)) fit.squares = squares;  // not so where a side has no samples
  return fit;
}

/// The place of least squares, and the squares at even places around.
struct Found {
  double place, squares;
  double step;
  std::vector<double> grid;
};

/// Over the place the squares have several valleys: a grid finds the right one.
Found best_place(const Window& window, const Shape& shape, double low, double high) {
  constexpr int kSteps = 40;  // they tell valleys apart; Brent's method goes on between two of them
  const double step = (high - low) / kSteps;
  const auto squares = [&](double place) { return fitted(window, shape, place).squares; };
  Found best{low, std::numeric_limits<double>::infinity(), step, {}};
  for (int i = 0; i <= kSteps; ++i) {
    const double place = low + i * step, here = squares(place);
    best.grid.push_back(here);
    if (here < best.squares) best.place = place, best.squares = here;
  }
  constexpr int kBits = 24;  // half of a double's digits: the squares at their least tell no more
  const auto [place, least] = boost::math::tools::brent_find_minima(
      squares, std::max(low, best.place - step), std::min(high, best.place + step), kBits);
  if (least < best.squares) best.place = place, best.squares = least;
  return best;
}

/// The error of the place: it moves the fit by its slope there, as one more column.
double error_of(const Window& window, const Shape& shape, double place) {
  const MatrixXd A = columns(window, shape, place);
  const VectorXd c = optim::least_squares(A, window.s);
  constexpr double kStep = 1e-4;  // squared it is far below what the place is known to
  const double h = kStep * std::max(window.scale.before, window.scale.after);
  const VectorXd slope =
      (columns(window, shape, place + h) * c - columns(window, shape, place - h) * c) / (2 * h);
  const double own = (slope - A * optim::least_squares(A, slope)).norm();
  return own > 0 ? window.noise / own : std::numeric_limits<double>::infinity();
}

/// Neighbours are averaged where there are more than a fit needs.
CornerSamples in_few(const CornerSamples& all) {
  constexpr std::size_t kMost = 600;  // samples: each place of the grid takes a fit to all of them
  const std::size_t group = (all.x.size() + kMost - 1) / kMost;
  if (group < 2) return all;
  CornerSamples few;
  const double share = 1 / static_cast<double>(group);
  for (std::size_t i = 0; i + group <= all.x.size(); i += group) {
    double x = 0, s = 0, curve = 0, leverage = 0;
    for (std::size_t k = i; k < i + group; ++k) {
      x += share * all.x[k], s += share * all.s[k], curve += share * all.curve[k];
      leverage += all.leverage[k];
    }
    few.x.push_back(x), few.s.push_back(s), few.curve.push_back(curve);
    few.leverage.push_back(leverage);
  }
  return few;
}

Window window_of(const CornerSamples& samples, const CornerSides& sides, double share,
                 double centre, double noise) {
  const double infinity = std::numeric_limits<double>::infinity();
  const double low = sides.before > 0 ? centre - share * sides.before : -infinity;
  const double high = sides.after > 0 ? centre + share * sides.after : infinity;
  Window window{{}, {}, noise, {share * sides.before, share * sides.after}};
  std::vector<double> x, s;
  for (std::size_t i = 0; i < samples.x.size(); ++i) {
    if (samples.x[i] >= low && samples.x[i] <= high) {
      x.push_back(samples.x[i]), s.push_back(samples.s[i]);
    } else {
      window.others += std::pow((samples.s[i] - samples.curve[i]) / noise, 2);
      window.freedom += samples.leverage[i];
    }
  }
  window.x = VectorXd::Map(x.data(), static_cast<Index>(x.size()));
  window.s = VectorXd::Map(s.data(), static_cast<Index>(s.size()));
  window.samples = static_cast<double>(samples.x.size());
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

/// One way in which the lift may leave its level, in one window.
struct CornerCandidate {
  double place, error;  ///< mean and deviation of the place, were this the way
  double level;
  double cost;  ///< (I11)
};

/// What laws begin with: a jump of the jerk in three of five, else of the acceleration or of the
/// jerk's slope. -2 ln of their shares.
double prior_cost(int order) { return order == 3 ? 1.0 : 3.2; }

/// Mean and deviation over a grid's places, each as likely as its squares say, and on how many
/// places they rest.
struct Moments {
  double mean, deviation, places;
};

Moments moments(const Window& window, const Found& found, double low) {
  double sum = 0, first = 0, second = 0;
  for (std::size_t i = 0; i < found.grid.size(); ++i) {
    const double away = low + static_cast<double>(i) * found.step - found.place;
    const double excess = (found.grid[i] - found.squares) / (window.noise * window.noise);
    const double likely = std::exp(-0.5 * excess);
    sum += likely, first += likely * away, second += likely * away * away;
  }
  if (!(sum > 0)) return {found.place, found.step, 0};
  const double mean = first / sum, variance = second / sum - mean * mean;
  return {found.place + mean, std::sqrt(std::max(variance, 0.0) + found.step * found.step / 12),
          sum};
}

/// Where noise blurs the place too much for its squares to be a parabola: moments over a grid that
/// is made finer until several of its places are likely.
Moments fine_moments(const Window& window, const Shape& shape, Found found, double low) {
  constexpr int kRounds = 12;    // a round makes the grid ten times finer: twelve reach rounding
  constexpr double kEnough = 4;  // a mean and a deviation over fewer places would be the grid's
  Moments result = moments(window, found, low);
  for (int round = 0; round < kRounds && result.places < kEnough; ++round) {
    low = found.place - 2 * found.step;
    found = best_place(window, shape, low, found.place + 2 * found.step);
    result = moments(window, found, low);
  }
  return result;
}

/// Whether the lift goes one way only from the level on each side, but for what noise hides.
bool goes_one_way(const Window& window, const Shape& shape, const VectorXd& coefficients) {
  constexpr int kSteps = 24;  // polynomials of up to four terms turn at most three times
  const bool both = window.scale.before > 0 && window.scale.after > 0;
  for (int side = 0; side < (both ? 2 : 1); ++side) {
    double highest = 0, lowest = 0, back = 0, now = 0;
    for (int i = 1; i <= kSteps; ++i) {
      const double u = static_cast<double>(i) / kSteps, more = shape.stride == 2 ? u * u : u;
      double power = std::pow(u, shape.order);
      now = 0;
      for (int k = 0; k < shape.terms; ++k, power *= more) {
        now += coefficients[1 + side * shape.terms + k] * power;
      }
      highest = std::max(highest, now), lowest = std::min(lowest, now);
      back = std::max(back, std::min(highest - now, now - lowest));
    }
    constexpr double kOfTravel = 1e-3;  // of the way: so little of a turn is the series' own misfit
    if (std::max(back, std::min(highest, -lowest)) > window.noise + kOfTravel * std::abs(now))
      return false;
  }
  return true;
}

/// On Bayes' criterion: powers that are hardly there move the place most.
constexpr double kPenalty = 1.2;

/// None where samples are too few.
std::optional<CornerCandidate> candidate_of(const Window& window, const Shape& shape, double low,
                                            double high) {
  if (!is_enough(window, shape, 0.5 * (low + high))) return {};
  const int sides = (window.scale.before > 0) + (window.scale.after > 0);
  const double parameters = 2 + sides * shape.terms;
  const Found found = best_place(window, shape, low, high);
  const double rest = static_cast<double>(window.x.size()) - parameters;
  const double chi = found.squares / (window.noise * window.noise);
  if (!(rest > 0) || !std::isfinite(chi)) return {};
  double place = found.place, error = error_of(window, shape, place);
  // Where noise blurs more than a step, the squares are not a parabola of the place.
  const VectorXd coefficients = fitted(window, shape, place).coefficients;
  if (!goes_one_way(window, shape, coefficients)) return {};
  if (!(error < 1.5 * found.step)) {
    const Moments blurred = fine_moments(window, shape, found, low);
    place = blurred.mean, error = blurred.deviation;
  }
  error *= std::sqrt(std::max(chi / rest, 1.0));
  const double cost = chi + window.others +
                      kPenalty * std::log(window.samples) * (parameters + window.freedom) +
                      prior_cost(shape.order);
  return CornerCandidate{place, error, coefficients[0], cost};
}

void add_candidates(const Window& window, double low, double high,
                    std::vector<CornerCandidate>& all) {
  for (const int order : {3, 2, 4}) {
    for (const int stride : {1, 2}) {
      for (int terms = 2; terms <= 4; ++terms) {
        const auto one = candidate_of(window, {order, stride, terms}, low, high);
        if (one) all.push_back(*one);
      }
    }
  }
}

/// (I12) The candidates' mean, each as likely as its cost says. Its error is the deviation from
/// there of candidates whose costs count a fifth less: none of them is quite the law.
Corner mean_of(const std::vector<CornerCandidate>& all) {
  const auto best = std::min_element(all.begin(), all.end(),
                                     [](const auto& a, const auto& b) { return a.cost < b.cost; });
  const auto mean = [&](double temper, const auto& of) {
    double sum = 0, weighted = 0;
    for (const CornerCandidate& c : all) {
      const double likely = std::exp(-0.5 * (c.cost - best->cost) / temper);
      sum += likely, weighted += likely * of(c);
    }
    return weighted / sum;
  };
  constexpr double kDoubt = 1.25;  // tau of (I12): no series is exactly the law
  const double away = mean(1, [&](const CornerCandidate& c) { return c.place - best->place; });
  const double place = best->place + away;
  const double squares = mean(kDoubt, [&](const CornerCandidate& c) {
    return (c.place - place) * (c.place - place) + c.error * c.error;
  });
  return {place, best->level, std::sqrt(squares)};
}

}  // namespace

Corner find_corner(const CornerSamples& samples, const CornerSides& sides, double guess, double low,
                   double high, double noise) {
  Corner corner{guess, 0, 0.5 * (high - low)};
  const CornerSamples few = in_few(samples);
  const double group = static_cast<double>(samples.x.size()) /
                       std::max<double>(1, static_cast<double>(few.x.size()));
  std::vector<CornerCandidate> all;
  double from = low, to = high;
  for (const double share : {0.5, 0.25, 0.125, 0.0625}) {
    const Window window =
        window_of(few, sides, share, corner.place, noise / std::sqrt(std::round(group)));
    add_candidates(window, from, to, all);
    if (all.empty()) break;
    corner = mean_of(all);
    // A wider window has told where to look.
    const double margin =
        std::max(0.25 * share * std::max(sides.before, sides.after), 4 * corner.place_error);
    from = std::max(low, corner.place - margin);
    to = std::min(high, corner.place + margin);
  }
  return corner;
}

}  // namespace camlaw::problems
