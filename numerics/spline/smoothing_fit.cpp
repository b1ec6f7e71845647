// SPDX-License-Identifier: MIT
#include "numerics/spline/smoothing_fit.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "numerics/polynomial/gauss_legendre.h"

namespace camlaw::optim {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Median of |e| of a normal distribution is 1 / 1.4826 of its deviation.
constexpr double kNormalOverMedian = 1.4826022185056018;
/// 95 % efficient where nothing is wrong (Holland and Welsch 1977).
constexpr double kHuber = 1.345, kBisquare = 4.685;

/// (O3) Equations whose sum of squares is the integral of (s^(m))^2: its values at Gauss' points,
/// which are exact for the polynomials in each span.
BandTriangle penalty_rows(const SplineBasis& basis, const SplineUnknowns& unknowns, int order) {
  const auto& [places, weights] = gauss_legendre(kMostDegree + 1);
  BandTriangle triangle = unknowns.triangle();
  std::vector<std::vector<BandRow>> by_first(triangle.columns() + 1);
  for (std::size_t span = 0; span < basis.spans(); ++span) {
    const double half = 0.5 * (basis.places()[span + 1] - basis.places()[span]);
    const double middle = std::midpoint(basis.places()[span], basis.places()[span + 1]);
    const auto add = [&](double u, double weight) {
      const auto row = unknowns.equation(basis.row_in(span, middle + half * u, order), 0,
                                         std::sqrt(weight * half));
      by_first[row.first].push_back(row);
    };
    for (std::size_t k = 0; k < places.size(); ++k) {
      const double u = places[k], weight = weights[k];
      add(u, weight);
      if (u != 0) add(-u, weight);
    }
  }
  for (const auto& rows : by_first) {
    for (const BandRow& row : rows) triangle.add(row);
  }
  return triangle;
}

BandRow scaled(BandRow row, double factor) {
  for (double& entry : row.band) entry *= factor;
  for (double& entry : row.border) entry *= factor;
  row.right *= factor;
  return row;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return std::midpoint(*std::max_element(values.begin(), middle), *middle);
}

/// (O9) What is left of a weight at the studentised residual t.
double kept_weight(Reweighting reweighting, double t) {
  if (reweighting == Reweighting::Huber) return std::min(1.0, kHuber / std::abs(t));
  const double u = t / kBisquare;
  return std::abs(u) < 1 ? (1 - u * u) * (1 - u * u) : 0;
}

/// What stays as it is while mu and the weights change.
struct Equations {
  const SplineBasis& basis;
  const SplineUnknowns& unknowns;
  const SmoothingOptions& options;
  std::vector<SplineSample> samples;  ///< in the order of their equations' first columns
  BandTriangle penalty;
};

/// The same with what is kept of each sample's weight, 0 to 1.
struct Weighed {
  const Equations& all;
  const std::vector<double>& kept;
  BandTriangle data;  ///< the samples' equations taken together
  double count;       ///< of samples that are kept
};

struct Solution {
  std::vector<double> unknowns;
  std::shared_ptr<const BandInverse> inverse;
  double degrees_of_freedom = 0, squares = 0;
};

/// In the order of their equations' first columns, which keeps rotations few.
std::vector<SplineSample> sorted(const SplineBasis& basis, const SplineUnknowns& unknowns,
                                 std::vector<SplineSample> samples) {
  std::vector<std::pair<std::size_t, std::size_t>> order;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    order.emplace_back(unknowns.equation(basis.row(samples[i].x, 0), 0, 1).first, i);
  }
  std::sort(order.begin(), order.end());
  std::vector<SplineSample> result;
  for (const auto& [column, i] : order) result.push_back(samples[i]);
  return result;
}

BandRow equation_of(const Equations& all, const std::vector<double>& kept, std::size_t i) {
  const SplineSample& sample = all.samples[i];
  return all.unknowns.equation(all.basis.row(sample.x, 0), sample.y,
                               std::sqrt(sample.weight * kept[i]));
}

Weighed weighed(const Equations& all, const std::vector<double>& kept) {
  Weighed result{all, kept, all.unknowns.triangle(),
                 std::accumulate(kept.begin(), kept.end(), 0.0)};
  for (std::size_t i = 0; i < kept.size(); ++i) result.data.add(equation_of(all, kept, i));
  return result;
}

/// (O4)
Solution solve(const Weighed& samples, double mu) {
  const BandTriangle& data = samples.data;
  BandTriangle whole = samples.all.unknowns.triangle();
  for (std::size_t i = 0; i < whole.rows(); ++i) {
    whole.add(data.row(i));
    whole.add(scaled(samples.all.penalty.row(i), std::sqrt(mu)));
  }
  Solution result{whole.solve(), std::make_shared<const BandInverse>(whole)};
  for (std::size_t i = 0; i < data.rows(); ++i) {
    result.degrees_of_freedom += result.inverse->form(data.row(i));
  }
  result.squares = data.rest() + data.misfit(result.unknowns);
  return result;
}

/// (O7)
double left_out(const Weighed& samples, const Solution& solution) {
  const Equations& all = samples.all;
  const auto c = all.unknowns.coefficients(solution.unknowns);
  double sum = 0;
  for (std::size_t i = 0; i < all.samples.size(); ++i) {
    const SplineSample& sample = all.samples[i];
    const double e = sample.y - all.basis.value(all.basis.row(sample.x, 0), c);
    const double h = solution.inverse->form(equation_of(all, samples.kept, i));
    const double rest = 1 - all.options.caution * h;
    if (!(rest > 1e-6)) return kInfinity;
    sum += sample.weight * samples.kept[i] * (e / rest) * (e / rest);
  }
  return sum / samples.count;
}

/// (O6) or (O7)
double score(const Weighed& samples, double mu) {
  const SmoothingOptions& options = samples.all.options;
  const Solution solution = solve(samples, mu);
  if (options.choice == SmoothingChoice::LeaveOneOut) return left_out(samples, solution);
  const double n = samples.count, rest = n - options.caution * solution.degrees_of_freedom;
  // Within rounding of 0 every sample is met, and the quotient says nothing.
  if (!(rest > 1e-6 * n)) return kInfinity;
  return n * solution.squares / (rest * rest);
}

/// From where not even the finest waves that the knots allow are smoothed to where nothing but the
/// polynomial of degree m - 1 is left, as log10 mu: a wave of length l has
/// integral (s^(m))^2 = (2 pi / l)^2m integral s^2.
std::pair<double, double> range_of_mu(const Weighed& samples) {
  const auto& places = samples.all.basis.places();
  const double length = places.back() - places.front();
  double least = length, weight = 0;
  for (std::size_t i = 1; i < places.size(); ++i) {
    least = std::min(least, places[i] - places[i - 1]);
  }
  for (std::size_t i = 0; i < samples.kept.size(); ++i) {
    weight += samples.all.samples[i].weight * samples.kept[i];
  }
  const double scale = std::log10(weight / length), power = 2 * samples.all.options.penalty;
  return {scale + power * std::log10(least / std::numbers::pi) - 6,
          scale + power * std::log10(length / std::numbers::pi) + 4};
}

/// A grid finds the valley, as there may be several, and Brent's method its lowest place.
double chosen_mu(const Weighed& samples) {
  const auto [low, high] = range_of_mu(samples);
  const int steps = static_cast<int>(std::ceil(2 * (high - low)));
  const double step = (high - low) / steps;
  const auto at = [&](double exponent) { return score(samples, std::pow(10.0, exponent)); };
  int best = steps;
  double lowest = kInfinity;
  for (int i = 0; i <= steps; ++i) {
    const double here = at(low + i * step);
    if (here < lowest) lowest = here, best = i;
  }
  const double left = low + std::max(best - 1, 0) * step;
  const double right = low + std::min(best + 1, steps) * step;
  constexpr int kBits = 12;  // mu to a thousandth: near the lowest place the score is level
  const auto [exponent, found] = boost::math::tools::brent_find_minima(at, left, right, kBits);
  return std::pow(10.0, found < lowest ? exponent : low + best * step);
}

/// Residuals, leverages and (O8) without sigma.
std::vector<SmoothedSample> looked_at(const Weighed& samples, const SmoothedFit& fit) {
  const Equations& all = samples.all;
  std::vector<SmoothedSample> result(all.samples.size());
  for (std::size_t i = 0; i < all.samples.size(); ++i) {
    const SplineSample& sample = all.samples[i];
    const auto row = all.basis.row(sample.x, 0);
    const double e = sample.y - all.basis.value(row, fit.coefficients);
    const double q = sample.weight * fit.inverse->form(all.unknowns.equation(row, 0, 1));
    const double h = std::min(samples.kept[i] * q, 1.0), rest = 1 - h;
    const double t = rest > 0 ? e / rest * std::sqrt(sample.weight / (1 + q / rest)) : 0;
    result[sample.index] = {e, h, samples.kept[i], t, false};
  }
  return result;
}

/// The fit with these weights; no sample is flagged.
Possible<SmoothedFit> fitted(const Weighed& samples) {
  const auto& [basis, unknowns, options, in_order, penalty] = samples.all;
  SmoothedFit fit{basis, unknowns};
  fit.mu = options.mu ? *options.mu : chosen_mu(samples);
  Solution solution = solve(samples, fit.mu);
  for (const double unknown : solution.unknowns) {
    if (std::isfinite(unknown)) continue;
    return Impossible{"smoothing spline: the samples do not determine it"};
  }
  fit.coefficients = unknowns.coefficients(solution.unknowns);
  fit.inverse = std::move(solution.inverse);
  fit.degrees_of_freedom = solution.degrees_of_freedom;
  fit.squares = solution.squares;
  const double rest = samples.count - fit.degrees_of_freedom;
  fit.sigma = rest > 0 ? std::sqrt(fit.squares / rest) : 0;
  fit.samples = looked_at(samples, fit);
  return fit;
}

/// Sigma by the median of the residuals.
double robust_sigma(const Equations& all, const SmoothedFit& fit) {
  std::vector<double> sizes;
  double largest = 0;
  for (const auto& sample : fit.samples) sizes.push_back(std::abs(sample.studentised));
  for (const auto& sample : all.samples) {
    largest = std::max(largest, std::abs(sample.y) * std::sqrt(sample.weight));
  }
  // Samples without noise have a median that is rounding, or 0.
  const double rounding = 1e-14 * largest;
  return kNormalOverMedian * median(std::move(sizes)) + rounding;
}

/// What robust fits hold a sample's residual against.
double judged(const SmoothedFit& fit, const SmoothingOptions& options) {
  return std::max(fit.sigma, options.least_noise);
}

/// (O9) What is kept of each weight after a fit.
std::vector<double> kept_after(const Equations& all, const SmoothedFit& fit,
                               Reweighting reweighting) {
  std::vector<double> kept;
  for (const SplineSample& sample : all.samples) {
    const double t = fit.samples[sample.index].studentised / judged(fit, all.options);
    kept.push_back(t == 0 ? 1 : kept_weight(reweighting, t));
  }
  return kept;
}

/// Fits again with the weights that each fit leaves, until these stay.
Possible<SmoothedFit> reweighted(const Equations& all) {
  // Few steps settle it; where weights go on oscillating the last ones are as good as any.
  constexpr int kMostReweightings = 30;
  constexpr double kSettled = 1e-3;
  const Reweighting wanted = all.options.reweighting;
  std::vector<double> kept(all.samples.size(), 1.0);
  for (int step = 0;; ++step) {
    auto found = fitted(weighed(all, kept));
    if (!found || wanted == Reweighting::None) return found;
    SmoothedFit& fit = *found;
    fit.sigma = robust_sigma(all, fit);
    // The bisquare has many fixed points: it starts from Huber's.
    const bool early = step < 5;
    const auto next = kept_after(all, fit, early ? Reweighting::Huber : wanted);
    double change = early && wanted == Reweighting::Bisquare ? 1 : 0;
    for (std::size_t i = 0; i < kept.size(); ++i) {
      change = std::max(change, std::abs(next[i] - kept[i]));
    }
    if (change < kSettled || step + 1 == kMostReweightings) return found;
    kept = next;
  }
}

/// Studentises and flags.
void flag(const SmoothingOptions& options, SmoothedFit& fit) {
  const auto n = static_cast<double>(fit.samples.size());
  const double tail = options.outlier_chance / (2 * n);
  const double rest = n - fit.degrees_of_freedom - 1;
  const bool by_t = options.reweighting == Reweighting::None && rest > 1;
  fit.outlier_bound =
      by_t ? boost::math::quantile(boost::math::complement(boost::math::students_t(rest), tail))
           : boost::math::quantile(boost::math::complement(boost::math::normal(), tail));
  for (auto& sample : fit.samples) {
    const double t = sample.studentised;
    const double squares = fit.squares - t * t;  // without this sample
    const double sigma = by_t ? std::sqrt(std::max(squares, 0.0) / rest) : judged(fit, options);
    sample.studentised = t == 0 ? 0 : t / sigma;
    sample.outlying = std::abs(sample.studentised) > fit.outlier_bound;
  }
}

}  // namespace

Possible<SmoothedFit> smoothed(const SplineBasis& basis, std::vector<SplineSample> samples,
                               const SmoothingOptions& options) {
  if (auto why = SplineUnknowns::fault(basis, options.begin, options.end)) return std::move(*why);
  const SplineUnknowns unknowns(basis, options.begin, options.end);
  auto fit = reweighted({basis, unknowns, options, sorted(basis, unknowns, std::move(samples)),
                         penalty_rows(basis, unknowns, options.penalty)});
  if (fit) flag(options, *fit);
  return fit;
}

}  // namespace camlaw::optim
