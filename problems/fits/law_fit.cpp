// SPDX-License-Identifier: MIT
#include "problems/fits/law_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "optim/fit/statistics.h"
#include "problems/fits/coefficients.h"
#include "problems/fits/law_limits.h"

namespace camlaw::problems {
namespace {

/// Where the parameters of a fit stand: begin, end, stroke, zero for displacements, coefficients.
struct Layout {
  bool with_zero;
  std::size_t zero() const { return 3; }
  std::size_t first() const { return with_zero ? 4 : 3; }
};

std::vector<LawVariable> variables_of(const Member& law, Layout layout) {
  std::vector<LawVariable> result;
  for (const Coefficient& c : coefficients_of(law, layout.first())) result.push_back(c.at);
  return result;
}

/// (P1) y = zero + h s(u) and its derivatives, u = (x - begin) / (end - begin) within 0 and 1.
class MotionResiduals final : public optim::Residuals {
 public:
  MotionResiduals(const MotionSamples& samples, std::vector<std::size_t> which, const Member& law,
                  Layout layout)
      : samples_(samples),
        which_(std::move(which)),
        layout_(layout),
        binding_(law, variables_of(law, layout)) {}

  std::size_t count() const override { return which_.size(); }

  bool evaluate(std::span<const double> p, std::span<double> r,
                std::span<double> jacobian) const override {
    const double begin = p[0], length = p[1] - p[0], stroke = p[2];
    if (!(length > 0)) return false;
    const std::vector<double> values = binding_.values_at(p);
    const auto k = static_cast<std::size_t>(samples_.order);
    const double unit = std::pow(length, -samples_.order);
    for (std::size_t i = 0; i < which_.size(); ++i) {
      const double u = (samples_.place[which_[i]] - begin) / length;
      const bool moves = u > 0 && u < 1;
      const double at = std::clamp(u, 0.0, 1.0);
      const MotionDerivatives m =
          binding_.motion(at, u < 1 ? Side::Right : Side::Left, values, jacobian.empty() ? 0 : 1);
      // At rest beyond the ends: displacement stays, derivatives are none.
      const double own = k == 0 || moves ? m.value[k] : 0;
      const double zero = layout_.with_zero ? p[layout_.zero()] : 0;
      r[i] = zero + stroke * unit * own - samples_.value[which_[i]];
      if (!std::isfinite(r[i])) return false;
      if (!jacobian.empty()) {
        fill(&jacobian[i * p.size()], p, m, moves ? u : -1, unit * stroke, own);
      }
    }
    return true;
  }

 private:
  /// `u` below 0 at rest; `size` is what s^(k) is multiplied by.
  void fill(double* row, std::span<const double> p, const MotionDerivatives& m, double u,
            double size, double own) const {
    const auto k = static_cast<std::size_t>(samples_.order);
    const double length = p[1] - p[0];
    std::fill_n(row, p.size(), 0.0);
    row[2] = p[2] != 0 ? size / p[2] * own : 0;
    if (layout_.with_zero) row[layout_.zero()] = 1;
    const auto& variables = binding_.variables();
    const bool moves = u >= 0;
    for (std::size_t j = 0; j < variables.size(); ++j) {
      if (moves || k == 0) row[variables[j].variable] = size * m.gradient[j][k];
    }
    if (!moves) return;
    // du/dbegin = (u - 1) / length, du/dend = -u / length; the unit length^-k follows both.
    const double slope = m.value[k + 1];
    const double stretch = samples_.order * own / length;
    row[0] = size * (slope * (u - 1) / length + stretch);
    row[1] = size * (-slope * u / length - stretch);
  }

  const MotionSamples& samples_;
  std::vector<std::size_t> which_;
  Layout layout_;
  LawBinding binding_;
};

void check(const MotionSamples& samples, const MotionGuess& guess) {
  if (samples.place.size() != samples.value.size()) {
    throw std::invalid_argument("samples: as many values as places are wanted");
  }
  if (samples.place.size() < 2) throw std::invalid_argument("samples: two at least are wanted");
  for (std::size_t i = 0; i < samples.place.size(); ++i) {
    if (std::isfinite(samples.place[i]) && std::isfinite(samples.value[i])) continue;
    throw std::invalid_argument(fmt::format("sample {} is no finite number", i + 1));
  }
  if (!(guess.end > guess.begin) || guess.to == guess.from) {
    throw std::invalid_argument("samples: they show no motion");
  }
}

std::vector<std::size_t> all_of(const MotionSamples& samples) {
  std::vector<std::size_t> which(samples.place.size());
  std::iota(which.begin(), which.end(), std::size_t{0});
  return which;
}

std::vector<optim::FitParameter> parameters_of(const MotionSamples& samples, const Member& law,
                                               const MotionGuess& guess, Layout layout) {
  const double length = guess.end - guess.begin, stroke = guess.to - guess.from;
  constexpr double kBeyond = 0.3;  // of the length: an end is looked for that far off its guess
  std::vector<optim::FitParameter> result;
  const std::string& unit = samples.place_unit;
  result.push_back({"begin", unit, guess.begin - kBeyond * length, guess.begin + kBeyond * length,
                    guess.begin, length});
  result.push_back(
      {"end", unit, guess.end - kBeyond * length, guess.end + kBeyond * length, guess.end, length});
  result.push_back(
      {"stroke", samples.unit, -optim::kInfinity, optim::kInfinity, stroke, std::abs(stroke)});
  if (layout.with_zero) {
    result.push_back(
        {"zero", samples.unit, -optim::kInfinity, optim::kInfinity, guess.from, std::abs(stroke)});
  }
  for (const Coefficient& c : coefficients_of(law)) {
    const bool is_held = is_end_value(law, c);
    result.push_back(
        {c.name, c.unit, is_held ? c.value : c.low, is_held ? c.value : c.high, c.value});
  }
  return result;
}

/// Held where they start: a fit of begin, end, stroke and zero with the law as it is tells where a
/// fit of all finds the right valley.
std::vector<optim::FitParameter> with_held(std::vector<optim::FitParameter> parameters,
                                           std::size_t first) {
  for (std::size_t j = first; j < parameters.size(); ++j) {
    parameters[j].lower = parameters[j].upper = parameters[j].start;
  }
  return parameters;
}

/// What fits to the same residuals are compared by.
double merit(const optim::FitResult& fit) { return fit.loss_scale.value_or(fit.sum_of_squares); }

/// How far a fit looks.
enum class Search { Near, Far };

/// Laws of several coefficients have valleys in which longer motions with other coefficients nearly
/// do as well: a far search begins at shorter and longer motions too.
optim::FitResult in_stages(std::vector<optim::FitParameter> parameters,
                           const optim::Residuals& residuals, const optim::FitOptions& options,
                           std::size_t first, Search search) {
  constexpr double kLonger[] = {-0.1, 0.1};
  constexpr double kExact = 1e-9;
  if (parameters.size() == first) return optim::fit(parameters, residuals, options);
  const auto rough = optim::fit(with_held(parameters, first), residuals, options);
  for (std::size_t j = 0; j < first; ++j) parameters[j].start = rough.parameters[j].value;
  optim::FitResult best = optim::fit(parameters, residuals, options);
  const double stroke = rough.parameters[2].value;
  for (const double longer : kLonger) {
    // Where the samples do not determine the numbers no start helps.
    const bool is_single = parameters.size() < first + 2 || !best.free_directions.empty();
    if (search == Search::Near || is_single || best.rms < kExact * std::abs(stroke)) break;
    std::vector<optim::FitParameter> others = parameters;
    const double by = longer * (rough.parameters[1].value - rough.parameters[0].value);
    others[0].start = std::clamp(others[0].start - by, others[0].lower, others[0].upper);
    others[1].start = std::clamp(others[1].start + by, others[1].lower, others[1].upper);
    optim::FitResult other = optim::fit(others, residuals, options);
    if (merit(other) < merit(best) * (1 - kExact)) best = std::move(other);
  }
  return best;
}

optim::FitResult fitted(const MotionSamples& samples, const std::vector<std::size_t>& which,
                        const Member& law, const MotionGuess& guess, const LawFitOptions& options,
                        Search search) {
  const Layout layout{samples.order == 0};
  const MotionResiduals residuals(samples, which, law, layout);
  optim::FitOptions fit;
  fit.loss = options.loss;
  fit.loss_scale = options.loss_scale;
  fit.confidence = options.confidence;
  const auto parameters = parameters_of(samples, law, guess, layout);
  const auto limit = limit_of(law);
  if (!limit) return in_stages(parameters, residuals, fit, layout.first(), search);
  std::vector<double> start;
  for (const auto& p : parameters) start.push_back(p.start);
  const LimitedResiduals limited(residuals, *limit, layout.first(), start);
  return limited.of_coefficients(
      in_stages(limited.limited(parameters), limited, fit, layout.first(), search), parameters,
      options.confidence);
}

std::vector<double> values_of(const optim::FitResult& fit) {
  std::vector<double> result;
  for (const auto& p : fit.parameters) result.push_back(p.value);
  return result;
}

LawFit fit_of(const MotionSamples& samples, const Member& law, const MotionGuess& guess,
              const LawFitOptions& options, Search search);

}  // namespace

double LawFit::value(double place, int order) const {
  const double length = end - begin;
  const double u = (place - begin) / length;
  const auto k = static_cast<std::size_t>(order);
  if (k > 0 && !(u >= 0 && u <= 1)) return 0;
  const auto d =
      law.law().derivatives<4>(std::clamp(u, 0.0, 1.0), u < 1 ? Side::Right : Side::Left);
  return (k == 0 ? from : 0) + (to - from) * d[k] * std::pow(length, -order);
}

LawFit fit_law(const MotionSamples& samples, const Member& law, const MotionGuess& guess,
               const LawFitOptions& options) {
  check(samples, guess);
  return fit_of(samples, law, guess, options, Search::Far);
}

namespace {

LawFit fit_of(const MotionSamples& samples, const Member& law, const MotionGuess& guess,
              const LawFitOptions& options, Search search) {
  const Layout layout{samples.order == 0};
  LawFit result{law, fitted(samples, all_of(samples), law, guess, options, search)};
  const std::vector<double> x = values_of(result.fit);
  for (const LawVariable& v : variables_of(law, layout)) {
    result.law.arguments.values()[v.parameter][v.element] = x[v.variable];
  }
  result.begin = x[0];
  result.end = x[1];
  result.from = layout.with_zero ? x[layout.zero()] : 0;
  result.to = result.from + x[2];
  // Under a loss what it sums, so that a far point does not decide which law is best.
  double sum = 0;
  for (std::size_t i = 0; i < result.fit.residuals.size(); ++i) {
    const double r = result.fit.residuals[i];
    sum += options.loss == optim::Loss::None
               ? r * r
               : optim::loss_at(options.loss, result.fit.loss_scale.value_or(1), r).rho;
  }
  // What is left at the size of rounding tells no laws apart.
  constexpr double kRounding = 1e-10;
  double size = 0;
  for (const double y : samples.value) size = std::max(size, std::abs(y));
  const std::size_t n = samples.value.size();
  sum = std::max(sum, static_cast<double>(n) * std::pow(kRounding * size, 2));
  result.criterion = optim::aicc(n, x.size(), sum);
  return result;
}

/// The median of the few outermost values, which a far-off one does not move.
double outer_value(const MotionSamples& samples, bool first) {
  std::vector<std::size_t> order = all_of(samples);
  const std::size_t few = samples.place.size() < 30 ? 1 : 3;
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(few), order.end(),
                    [&](std::size_t a, std::size_t b) {
                      return first ? samples.place[a] < samples.place[b]
                                   : samples.place[a] > samples.place[b];
                    });
  std::vector<double> values;
  for (std::size_t i = 0; i < few; ++i) values.push_back(samples.value[order[i]]);
  return optim::median(values);
}

}  // namespace

MotionGuess guess_motion(const MotionSamples& samples) {
  const auto [low, high] = std::minmax_element(samples.place.begin(), samples.place.end());
  MotionGuess guess;
  guess.begin = *low;
  guess.end = *high;
  if (samples.order == 0) {
    guess.from = outer_value(samples, true);
    guess.to = outer_value(samples, false);
    return guess;
  }
  // Of a derivative: where it is not zero, the stroke by its greatest value.
  double greatest = 0;
  for (const double v : samples.value) {
    if (std::abs(v) > std::abs(greatest)) greatest = v;
  }
  constexpr double kRest = 0.01;
  double begin = guess.end, end = guess.begin;
  for (std::size_t i = 0; i < samples.place.size(); ++i) {
    if (!(std::abs(samples.value[i]) > kRest * std::abs(greatest))) continue;
    begin = std::min(begin, samples.place[i]);
    end = std::max(end, samples.place[i]);
  }
  if (end > begin) guess = {begin, end, 0, 1};
  constexpr double kTypicalB = 1.8, kTypicalC = 5.5;
  const double length = guess.end - guess.begin;
  guess.from = 0;
  guess.to =
      samples.order == 1 ? greatest * length / kTypicalB : greatest * length * length / kTypicalC;
  return guess;
}

namespace {

/// A fit and the law that it began with.
struct Tried {
  LawFit fit;
  const Member* law;
};

bool comes_before(const Tried& a, const Tried& b) { return a.fit.criterion < b.fit.criterion; }

/// Searches far for the laws of several coefficients: for those that may yet be the best. Where the
/// best leaves noise, that is those which are nearly as good; where it leaves a curve, all.
void search_far(std::vector<Tried>& ranking, const MotionSamples& samples, const MotionGuess& guess,
                const LawFitOptions& options) {
  constexpr double kNoise = 0.2, kNearly = 10;
  const LawFit& best = ranking.front().fit;
  const bool leaves_noise = neighbour_correlation(samples, best) < kNoise;
  const double limit = best.criterion + kNearly;
  for (Tried& tried : ranking) {
    if (coefficients_of(*tried.law).size() < 2) continue;
    if (leaves_noise && tried.fit.criterion > limit) continue;
    Tried other{fit_of(samples, *tried.law, guess, options, Search::Far), tried.law};
    if (comes_before(other, tried)) tried = std::move(other);
  }
}

/// Those within two of the best explain the samples as well: of them the simplest comes first.
void put_simplest_first(std::vector<LawFit>& ranking) {
  constexpr double kAsWell = 2;
  const auto as_well = std::find_if(ranking.begin(), ranking.end(), [&](const LawFit& fit) {
    return fit.criterion > ranking.front().criterion + kAsWell;
  });
  const auto simplest =
      std::min_element(ranking.begin(), as_well, [](const LawFit& a, const LawFit& b) {
        return a.fit.parameters.size() < b.fit.parameters.size();
      });
  if (simplest != as_well) std::rotate(ranking.begin(), simplest, simplest + 1);
}

}  // namespace

std::vector<LawFit> rank_fits(const MotionSamples& samples, const std::vector<Member>& laws,
                              const MotionGuess& guess, const LawFitOptions& options) {
  check(samples, guess);
  std::vector<Tried> all;
  for (const Member& law : laws) {
    try {
      all.push_back({fit_of(samples, law, guess, options, Search::Near), &law});
    } catch (const std::invalid_argument&) {  // its acceleration jumps to infinity, and the like
    }
  }
  if (all.empty()) return {};
  std::stable_sort(all.begin(), all.end(), comes_before);
  search_far(all, samples, guess, options);
  std::stable_sort(all.begin(), all.end(), comes_before);
  std::vector<LawFit> ranking;
  for (Tried& tried : all) ranking.push_back(std::move(tried.fit));
  put_simplest_first(ranking);
  return ranking;
}

double cross_validated(const MotionSamples& samples, const LawFit& fit,
                       const LawFitOptions& options) {
  constexpr std::size_t kFolds = 10;
  const Layout layout{samples.order == 0};
  const std::size_t n = samples.place.size();
  return optim::cross_validated_error(
      n, std::min(kFolds, n), [&](const auto& kept, const auto& left_out) {
        const MotionGuess guess{fit.begin, fit.end, fit.from, fit.to};
        const auto part = fitted(samples, kept, fit.law, guess, options, Search::Near);
        const MotionResiduals others(samples, left_out, fit.law, layout);
        std::vector<double> r(left_out.size());
        if (!others.evaluate(values_of(part), r, {})) return std::nan("");
        return std::inner_product(r.begin(), r.end(), r.begin(), 0.0);
      });
}

double neighbour_correlation(const MotionSamples& samples, const LawFit& fit) {
  // Under a loss what it counts of them, so that far-off ones do not hide a curve.
  std::vector<double> counted = fit.fit.residuals;
  for (std::size_t i = 0; i < counted.size(); ++i) counted[i] *= fit.fit.weights[i];
  return optim::neighbour_correlation(samples.place, counted);
}

}  // namespace camlaw::problems
