// SPDX-License-Identifier: MIT
#include "numerics/spline/smoothing_spline.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <tuple>

#include "numerics/spline/band_triangle.h"

namespace camlaw::optim {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Median of |e| of a normal distribution is 1 / 1.4826 of its deviation.
constexpr double kNormalOverMedian = 1.4826022185056018;
/// 95 % efficient where nothing is wrong (Holland and Welsch 1977).
constexpr double kHuber = 1.345, kBisquare = 4.685;

[[noreturn]] void refuse(const std::string& why) {
  throw std::invalid_argument("smoothing spline: " + why);
}

struct Sample {
  double x, y, weight;
  std::size_t index;  ///< as given
};

void check_lengths(std::size_t x, std::size_t y, std::size_t weights) {
  if (x != y || (weights != 0 && weights != x)) {
    refuse(
        fmt::format("{} places, {} values and {} weights do not belong together", x, y, weights));
  }
}

void check_options(const SmoothingOptions& options) {
  if (options.penalty < 1 || options.penalty > options.degree) {
    refuse(fmt::format("the penalty's order {} is not from 1 to the degree {}", options.penalty,
                       options.degree));
  }
  if (options.mu && !(*options.mu > 0 && std::isfinite(*options.mu))) {
    refuse(fmt::format("mu = {:.6g} is not above 0", *options.mu));
  }
  if (!(options.caution >= 1)) refuse(fmt::format("caution {:.6g} is below 1", options.caution));
  if (options.spans && *options.spans < 1) {
    refuse(fmt::format("{} spans are too few", *options.spans));
  }
  if (!options.knots.empty() && options.spans) refuse("both knots and spans are given");
  if (!(options.outlier_chance > 0 && options.outlier_chance < 1)) {
    refuse(fmt::format("the chance of outliers, {:.6g}, is not between 0 and 1",
                       options.outlier_chance));
  }
}

std::vector<Sample> checked_samples(std::span<const double> x, std::span<const double> y,
                                    std::span<const double> weights) {
  check_lengths(x.size(), y.size(), weights.size());
  std::vector<Sample> samples;
  samples.reserve(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double weight = weights.empty() ? 1 : weights[i];
    if (!std::isfinite(x[i]) || !std::isfinite(y[i])) {
      refuse(fmt::format("sample {} is not finite: x = {}, y = {}", i, x[i], y[i]));
    }
    if (!(weight > 0 && std::isfinite(weight))) {
      refuse(fmt::format("the weight of sample {} is {}, not above 0", i, weight));
    }
    samples.push_back({x[i], y[i], weight, i});
  }
  if (samples.empty()) refuse("there are no samples");
  return samples;
}

std::vector<double> places_of(const SmoothingOptions& options, const std::vector<Sample>& samples) {
  if (options.periodic && !options.range) refuse("a periodic one needs a range, its period");
  const auto [low, high] = std::minmax_element(
      samples.begin(), samples.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
  const auto [begin, end] = options.range.value_or(std::pair(low->x, high->x));
  if (!(begin < end) || !std::isfinite(end - begin)) {
    refuse(fmt::format("its range, {:.6g} to {:.6g}, is empty", begin, end));
  }
  if (low->x < begin || high->x > end) {
    refuse(fmt::format("sample {} at {:.6g} lies outside {:.6g} to {:.6g}",
                       low->x < begin ? low->index : high->index, low->x < begin ? low->x : high->x,
                       begin, end));
  }
  std::vector<double> places{begin};
  if (options.knots.empty()) {
    const int least = options.periodic ? options.degree + 1 : 1;
    const int half = static_cast<int>(std::min<std::size_t>(samples.size() / 2, 1000));
    const int spans = options.spans.value_or(std::max(half, least));
    for (int i = 1; i < spans; ++i) places.push_back(begin + (end - begin) * i / spans);
  }
  places.insert(places.end(), options.knots.begin(), options.knots.end());
  places.push_back(end);
  return places;
}

/// Fewer different places than m + 1 leave a polynomial that nothing holds, or nothing to smooth.
void check_places(std::vector<Sample>& samples, int penalty) {
  std::sort(samples.begin(), samples.end(), [](const auto& a, const auto& b) {
    return std::tie(a.x, a.index) < std::tie(b.x, b.index);
  });
  int different = 1;
  for (std::size_t i = 1; i < samples.size(); ++i) different += samples[i].x > samples[i - 1].x;
  if (different < penalty + 1) {
    refuse(fmt::format("samples at {} different places are too few, a penalty of order {} needs {}",
                       different, penalty, penalty + 1));
  }
}

/// (O3) Equations whose sum of squares is the integral of (s^(m))^2: its values at Gauss' points,
/// which are exact for the polynomials in each span.
BandTriangle penalty_rows(const SplineBasis& basis, const SplineUnknowns& unknowns, int order) {
  using Gauss = boost::math::quadrature::gauss<double, kMostDegree + 1>;
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
    for (std::size_t k = 0; k < Gauss::abscissa().size(); ++k) {
      const double u = Gauss::abscissa()[k], weight = Gauss::weights()[k];
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

}  // namespace

/// Carries a fit from samples to the spline.
class SmoothingFit {
 public:
  SmoothingFit(std::vector<Sample> samples, const SmoothingOptions& options)
      : options_(options),
        samples_(std::move(samples)),
        spline_(SplineBasis(options.degree, places_of(options, samples_), options.periodic),
                SplineUnknowns({options.degree, places_of(options, samples_), options.periodic},
                               options.begin, options.end)),
        penalty_(penalty_rows(spline_.basis_, spline_.unknowns_, options.penalty)),
        data_(spline_.unknowns_.triangle()),
        kept_(samples_.size(), 1.0) {
    sort_samples();
  }

  SmoothingSpline run() {
    spline_.samples_.resize(samples_.size());
    // Few steps settle it; where weights go on oscillating the last ones are as good as any.
    constexpr int kMostSteps = 30;
    constexpr double kSettled = 1e-3;
    for (int step = 0; step < kMostSteps; ++step) {
      fit();
      if (options_.reweighting == Reweighting::None || reweight(step) < kSettled) break;
    }
    flag();
    return std::move(spline_);
  }

 private:
  struct Solution {
    std::vector<double> unknowns;
    std::shared_ptr<const BandInverse> inverse;
    double degrees_of_freedom = 0, squares = 0;
  };

  /// In the order of their equations' first columns, which keeps rotations few.
  void sort_samples() {
    const auto first = [&](const Sample& sample) {
      return spline_.unknowns_.equation(row_of(sample), 0, 1).first;
    };
    std::vector<std::pair<std::size_t, std::size_t>> order;
    for (std::size_t i = 0; i < samples_.size(); ++i) order.emplace_back(first(samples_[i]), i);
    std::sort(order.begin(), order.end());
    std::vector<Sample> sorted;
    sorted.reserve(samples_.size());
    for (const auto& [column, i] : order) sorted.push_back(samples_[i]);
    samples_ = std::move(sorted);
  }

  SplineBasis::Row row_of(const Sample& sample) const { return spline_.basis_.row(sample.x, 0); }
  BandRow equation_of(std::size_t i) const {
    const Sample& sample = samples_[i];
    return spline_.unknowns_.equation(row_of(sample), sample.y,
                                      std::sqrt(sample.weight * kept_[i]));
  }

  /// (O4) All equations, those of the samples taken together before.
  Solution solve(double mu) const {
    BandTriangle whole = spline_.unknowns_.triangle();
    for (std::size_t i = 0; i < whole.rows(); ++i) {
      whole.add(data_.row(i));
      whole.add(scaled(penalty_.row(i), std::sqrt(mu)));
    }
    Solution result;
    result.unknowns = whole.solve();
    result.inverse = std::make_shared<const BandInverse>(whole);
    for (std::size_t i = 0; i < data_.rows(); ++i) {
      result.degrees_of_freedom += result.inverse->form(data_.row(i));
    }
    result.squares = data_.rest() + data_.misfit(result.unknowns);
    return result;
  }

  double samples_kept() const {
    double sum = 0;
    for (const double kept : kept_) sum += kept;
    return sum;
  }

  double score(double mu) const {
    const Solution solution = solve(mu);
    if (options_.choice == SmoothingChoice::LeaveOneOut) return left_out(solution);
    const double n = samples_kept();
    const double rest = n - options_.caution * solution.degrees_of_freedom;
    // Within rounding of 0 every sample is met, and the quotient says nothing.
    if (!(rest > 1e-6 * n)) return kInfinity;
    return n * solution.squares / (rest * rest);
  }

  /// (O7)
  double left_out(const Solution& solution) const {
    const auto c = spline_.unknowns_.coefficients(solution.unknowns);
    double sum = 0;
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      const double e = samples_[i].y - value(c, row_of(samples_[i]));
      const double h = solution.inverse->form(equation_of(i));
      const double rest = 1 - options_.caution * h;
      if (!(rest > 1e-6)) return kInfinity;
      sum += samples_[i].weight * kept_[i] * (e / rest) * (e / rest);
    }
    return sum / samples_kept();
  }

  static double value(const std::vector<double>& c, const SplineBasis::Row& row) {
    double sum = 0;
    for (std::size_t k = 0; k < row.values.size(); ++k) {
      if (row.values[k] != 0) sum += row.values[k] * c[(row.span + k) % c.size()];
    }
    return sum;
  }

  /// From where not even the finest waves that the knots allow are smoothed to where nothing but
  /// the polynomial of degree m - 1 is left, as log10 mu: a wave of length l has
  /// integral (s^(m))^2 = (2 pi / l)^2m integral s^2.
  std::pair<double, double> range_of_mu() const {
    const auto& places = spline_.basis_.places();
    const double length = places.back() - places.front();
    double least = length, weight = 0;
    for (std::size_t i = 1; i < places.size(); ++i) {
      least = std::min(least, places[i] - places[i - 1]);
    }
    for (std::size_t i = 0; i < samples_.size(); ++i) weight += samples_[i].weight * kept_[i];
    const double scale = std::log10(weight / length), power = 2 * options_.penalty;
    return {scale + power * std::log10(least / std::numbers::pi) - 6,
            scale + power * std::log10(length / std::numbers::pi) + 4};
  }

  /// A grid finds the valley, as there may be several, and Brent's method its lowest place.
  double chosen_mu() const {
    const auto [low, high] = range_of_mu();
    const int steps = static_cast<int>(std::ceil(2 * (high - low)));
    const double step = (high - low) / steps;
    const auto at = [&](double exponent) { return score(std::pow(10.0, exponent)); };
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

  void fit() {
    data_ = spline_.unknowns_.triangle();
    for (std::size_t i = 0; i < samples_.size(); ++i) data_.add(equation_of(i));
    spline_.mu_ = options_.mu ? *options_.mu : chosen_mu();
    const Solution solution = solve(spline_.mu_);
    for (const double unknown : solution.unknowns) {
      if (!std::isfinite(unknown)) refuse("the samples do not determine it");
    }
    spline_.coefficients_ = spline_.unknowns_.coefficients(solution.unknowns);
    spline_.inverse_ = solution.inverse;
    spline_.degrees_of_freedom_ = solution.degrees_of_freedom;
    const double rest = samples_kept() - solution.degrees_of_freedom;
    spline_.sigma_ = rest > 0 ? std::sqrt(solution.squares / rest) : 0;
    squares_ = solution.squares;
    look_at_samples();
  }

  /// Residuals, leverages and (O8) without sigma.
  void look_at_samples() {
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      const Sample& sample = samples_[i];
      const auto row = row_of(sample);
      const double e = sample.y - value(spline_.coefficients_, row);
      const double q =
          sample.weight * spline_.inverse_->form(spline_.unknowns_.equation(row, 0, 1));
      const double h = std::min(kept_[i] * q, 1.0), rest = 1 - h;
      const double t = rest > 0 ? e / rest * std::sqrt(sample.weight / (1 + q / rest)) : 0;
      spline_.samples_[sample.index] = {e, h, kept_[i], t, false};
    }
  }

  /// New weights from the residuals; how much the largest change is.
  double reweight(int step) {
    std::vector<double> sizes;
    double largest = 0;
    for (const auto& sample : spline_.samples_) sizes.push_back(std::abs(sample.studentised));
    for (const auto& sample : samples_) {
      largest = std::max(largest, std::abs(sample.y) * std::sqrt(sample.weight));
    }
    // Samples without noise have a median that is rounding, or 0.
    const double rounding = 1e-14 * largest;
    spline_.sigma_ = kNormalOverMedian * median(std::move(sizes)) + rounding;
    // The bisquare has many fixed points: it starts from Huber's.
    const bool early = step < 5;
    const auto how = early ? Reweighting::Huber : options_.reweighting;
    double change = early && options_.reweighting == Reweighting::Bisquare ? 1 : 0;
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      const double t = spline_.samples_[samples_[i].index].studentised / judged();
      const double kept = t == 0 ? 1 : kept_weight(how, t);
      change = std::max(change, std::abs(kept - kept_[i]));
      kept_[i] = kept;
    }
    return change;
  }

  /// What robust fits hold a sample's residual against.
  double judged() const { return std::max(spline_.sigma_, options_.least_noise); }

  /// Studentises and flags.
  void flag() {
    const auto n = static_cast<double>(samples_.size());
    const double tail = options_.outlier_chance / (2 * n);
    const bool robust = options_.reweighting != Reweighting::None;
    const double rest = n - spline_.degrees_of_freedom_ - 1;
    const bool by_t = !robust && rest > 1;
    spline_.outlier_bound_ =
        by_t ? boost::math::quantile(boost::math::complement(boost::math::students_t(rest), tail))
             : boost::math::quantile(boost::math::complement(boost::math::normal(), tail));
    for (auto& sample : spline_.samples_) {
      const double t = sample.studentised;
      const double squares = squares_ - t * t;  // without this sample
      const double sigma = by_t ? std::sqrt(std::max(squares, 0.0) / rest) : judged();
      sample.studentised = t == 0 ? 0 : t / sigma;
      sample.outlying = std::abs(sample.studentised) > spline_.outlier_bound_;
    }
  }

  const SmoothingOptions& options_;
  std::vector<Sample> samples_;
  SmoothingSpline spline_;
  BandTriangle penalty_, data_;
  std::vector<double> kept_;  ///< by place in samples_
  double squares_ = 0;
};

namespace {

/// Factors that pick out one derivative. Those above the degree are all 0.
std::span<const double> unit_of(int order) {
  static constexpr auto kUnits = [] {
    std::array<double, 2 * kMostDegree + 3> units{};
    units[kMostDegree + 1] = 1;
    return units;
  }();
  const auto kept = static_cast<std::size_t>(std::clamp(order, 0, kMostDegree + 1));
  return std::span(kUnits).subspan(kMostDegree + 1 - kept, kept + 1);
}

}  // namespace

SplineBasis::Row SmoothingSpline::combined_row(double x, std::span<const double> factors) const {
  const std::size_t span = basis_.span_at(x);
  SplineBasis::Row sum{span, {}};
  for (std::size_t order = 0; order < factors.size(); ++order) {
    if (factors[order] == 0) continue;
    const auto row = basis_.row_in(span, x, static_cast<int>(order));
    for (std::size_t k = 0; k < sum.values.size(); ++k) {
      sum.values[k] += factors[order] * row.values[k];
    }
  }
  return sum;
}

double SmoothingSpline::operator()(double x, int order) const {
  return combination(x, unit_of(order));
}

double SmoothingSpline::combination(double x, std::span<const double> factors) const {
  const double at = basis_.inside(x);
  if (std::isnan(at)) return at;
  const auto row = combined_row(at, factors);
  double sum = 0;
  for (std::size_t k = 0; k <= static_cast<std::size_t>(basis_.degree()); ++k) {
    sum += row.values[k] * coefficients_[(row.span + k) % coefficients_.size()];
  }
  return sum;
}

double SmoothingSpline::standard_error(double x, int order) const {
  return standard_error(x, unit_of(order));
}

double SmoothingSpline::standard_error(double x, std::span<const double> factors) const {
  const double at = basis_.inside(x);
  if (std::isnan(at)) return at;
  const auto equation = unknowns_.equation(combined_row(at, factors), 0, 1);
  return sigma_ * std::sqrt(std::max(inverse_->form(equation), 0.0));
}

SmoothingSpline smoothing_spline(std::span<const double> x, std::span<const double> y,
                                 const SmoothingOptions& options, std::span<const double> weights) {
  check_options(options);
  std::vector<Sample> samples = checked_samples(x, y, weights);
  check_places(samples, options.penalty);
  return SmoothingFit(std::move(samples), options).run();
}

}  // namespace camlaw::optim
