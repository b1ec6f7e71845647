// SPDX-License-Identifier: MIT
#include "optim/verdict/sobol_indices.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <tuple>

#include "numerics/sampling/sobol_points.h"

namespace camlaw::optim {
namespace {

constexpr std::size_t kMostInputs = 1000, kMostSamples = std::size_t{1} << 22;
constexpr double kUndefinedIndex = std::numeric_limits<double>::quiet_NaN();

/// The values of a sample: of its point A, of B, and of A with each input from B.
struct SampleValues {
  double a, b;
  std::vector<double> mixed;
};

struct Sums {
  double first, total;
};

/// The two indices of an input, (SI3) and (SI4), of samples counted so often, with (SI5) their
/// common mean and variance.
std::vector<Sums> estimated(const std::vector<SampleValues>& samples,
                            const std::vector<std::uint32_t>& which, std::size_t inputs) {
  double mean = 0, square = 0;
  const double count = static_cast<double>(which.size());
  for (const std::uint32_t i : which) mean += samples[i].a + samples[i].b;
  mean /= 2 * count;
  for (const std::uint32_t i : which) {
    square += (samples[i].a - mean) * (samples[i].a - mean) +
              (samples[i].b - mean) * (samples[i].b - mean);
  }
  const double variance = square / (2 * count);
  std::vector<Sums> sums(inputs, {0, 0});
  for (const std::uint32_t i : which) {
    const SampleValues& s = samples[i];
    for (std::size_t k = 0; k < inputs; ++k) {
      const double change = s.mixed[k] - s.a;
      sums[k].first += (s.b - mean) * change;
      sums[k].total += change * change;
    }
  }
  for (Sums& sum : sums) {
    sum.first /= count * variance;
    sum.total /= 2 * count * variance;
  }
  return sums;
}

/// The interval that holds 95 % of some numbers.
std::pair<double, double> interval_of(std::vector<double> numbers) {
  std::sort(numbers.begin(), numbers.end());
  const auto at = [&](double share) {
    return numbers[static_cast<std::size_t>(
        std::llround(share * static_cast<double>(numbers.size() - 1)))];
  };
  return {at(0.025), at(0.975)};
}

/// Whether values differ by more than their rounding.
bool changes(const SobolIndices& indices, double made_of) {
  constexpr double kRounding = 1e-13;  // a few hundred units of the last place
  const double size = std::max({std::abs(indices.lowest), std::abs(indices.highest), made_of});
  return indices.highest - indices.lowest > kRounding * size;
}

SobolIndices indices_of(const std::vector<SampleValues>& all, std::size_t inputs, double made_of,
                        const SobolOptions& options) {
  std::vector<SampleValues> samples;
  for (const SampleValues& sample : all) {
    const bool has_values = std::isfinite(sample.a) && std::isfinite(sample.b) &&
                            std::all_of(sample.mixed.begin(), sample.mixed.end(),
                                        [](double v) { return std::isfinite(v); });
    if (has_values) samples.push_back(sample);
  }
  SobolIndices result;
  result.samples = samples.size();
  result.undefined = all.size() - samples.size();
  const SobolEstimate none{kUndefinedIndex, kUndefinedIndex, kUndefinedIndex};
  result.first.assign(inputs, none);
  result.total.assign(inputs, none);
  result.mean = result.deviation = result.lowest = result.highest = kUndefinedIndex;
  if (samples.empty()) return result;
  double sum = 0, square = 0;
  result.lowest = result.highest = samples.front().a;
  for (const SampleValues& s : samples) {
    for (const double v : {s.a, s.b}) {
      sum += v;
      result.lowest = std::min(result.lowest, v), result.highest = std::max(result.highest, v);
    }
  }
  const double count = 2 * static_cast<double>(samples.size());
  result.mean = sum / count;
  for (const SampleValues& s : samples) {
    for (const double v : {s.a, s.b}) square += (v - result.mean) * (v - result.mean);
  }
  result.deviation = std::sqrt(square / count);
  if (!changes(result, made_of) || samples.size() < 2) return result;
  std::vector<std::uint32_t> which(samples.size());
  for (std::size_t i = 0; i < which.size(); ++i) which[i] = static_cast<std::uint32_t>(i);
  const std::vector<Sums> best = estimated(samples, which, inputs);
  std::vector<std::vector<double>> first(inputs), total(inputs);
  std::mt19937_64 random(options.seed);
  for (std::size_t r = 0; r < options.resamples; ++r) {
    for (auto& i : which) i = static_cast<std::uint32_t>(random() % samples.size());
    const std::vector<Sums> again = estimated(samples, which, inputs);
    for (std::size_t k = 0; k < inputs; ++k) {
      if (!std::isfinite(again[k].first) || !std::isfinite(again[k].total)) continue;
      first[k].push_back(again[k].first), total[k].push_back(again[k].total);
    }
  }
  for (std::size_t k = 0; k < inputs; ++k) {
    result.first[k].value = best[k].first, result.total[k].value = best[k].total;
    if (first[k].empty()) continue;
    std::tie(result.first[k].low, result.first[k].high) = interval_of(std::move(first[k]));
    std::tie(result.total[k].low, result.total[k].high) = interval_of(std::move(total[k]));
  }
  return result;
}

}  // namespace

Quantile even_between(double lower, double upper) {
  return [=](double share) { return lower + (upper - lower) * share; };
}

std::vector<SobolIndices> sobol_indices(std::span<const Quantile> inputs, std::size_t outputs,
                                        const SampledModel& model, const SobolOptions& options) {
  const std::size_t k = inputs.size();
  if (k == 0 || k > kMostInputs || outputs == 0) {
    throw std::invalid_argument(fmt::format(
        "Sobol indices of {} inputs and {} numbers; use 1 to {} inputs and 1 number or more", k,
        outputs, kMostInputs));
  }
  if (options.samples < 2 || options.samples > kMostSamples) {
    throw std::invalid_argument(
        fmt::format("Sobol indices from {} samples; use 2 to {}", options.samples, kMostSamples));
  }
  const std::size_t count = std::bit_ceil(options.samples);
  SobolPoints sequence(2 * k, options.seed);
  std::vector<std::vector<SampleValues>> all(outputs);
  std::vector<double> values(outputs), x(k), a(k), b(k), point(2 * k);
  const auto ask = [&] {
    std::fill(values.begin(), values.end(), kUndefinedIndex);
    model(x, values);
  };
  for (std::size_t i = 0; i < count; ++i) {
    if (options.progress) options.progress(static_cast<double>(i) / static_cast<double>(count));
    sequence.next(point);
    for (std::size_t j = 0; j < k; ++j) a[j] = inputs[j](point[j]), b[j] = inputs[j](point[k + j]);
    x = a;
    ask();
    for (std::size_t o = 0; o < outputs; ++o) all[o].push_back({values[o], 0, {}});
    x = b;
    ask();
    for (std::size_t o = 0; o < outputs; ++o) all[o].back().b = values[o];
    for (std::size_t j = 0; j < k; ++j) {
      x = a;
      x[j] = b[j];
      ask();
      for (std::size_t o = 0; o < outputs; ++o) all[o].back().mixed.push_back(values[o]);
    }
  }
  std::vector<SobolIndices> result;
  for (std::size_t o = 0; o < outputs; ++o) {
    const double made_of = o < options.sizes.size() ? options.sizes[o] : 0;
    result.push_back(indices_of(all[o], k, made_of, options));
  }
  return result;
}

}  // namespace camlaw::optim
