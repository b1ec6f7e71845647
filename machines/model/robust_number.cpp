// SPDX-License-Identifier: MIT
#include "machines/model/robust_number.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "machines/model/inner_numbers.h"
#include "machines/model/kept_parameters.h"
#include "machines/model/over_ranges.h"
#include "machines/model/recent.h"
#include "numerics/linear/statistics.h"
#include "numerics/sampling/sobol_points.h"
#include "optim/cycle/peak_function.h"
#include "optim/problem/deadline.h"

namespace camlaw::problems {
namespace {

using optim::Function;

/// Over fixed offsets of the ranges; the widened box holds none of them.
class RobustKernel final : public optim::Kernel {
 public:
  RobustKernel(Function f, const Widened& wide, std::vector<Point> offsets, const Robust& robust)
      : f_(std::move(f)),
        first_(wide.first),
        base_(wide.box),
        own_(camlaw::problems::own_inputs(f_, wide)),
        offsets_(std::move(offsets)),
        robust_(robust) {}

  const std::vector<std::size_t>& own_inputs() const { return own_.variables; }

  double value(std::span<const double> u) const override { return result(*values(u)); }

  double gradient(std::span<const double> u, std::span<double> slopes) const override {
    const auto g = slopes.first(own_.behind.size());  // there may be room for more
    const auto all = values(u);
    if (!is_number(*all)) return without_number(g);
    std::fill(g.begin(), g.end(), 0.0);
    for (const auto& [sample, weight] : weights(*all)) {
      optim::check_deadline();
      std::vector<double> own(f_.inputs().size());
      f_.gradient(design(u, offsets_[sample]), own);
      for (std::size_t i = 0; i < g.size(); ++i) g[i] += weight * own[own_.behind[i]];
    }
    return result(*all);
  }

  double hessian(std::span<const double> u, std::span<double> by_input,
                 std::span<double> by_two) const override {
    const auto g = by_input.first(own_.behind.size());
    const auto h = by_two.first(optim::packed_size(g.size()));
    const auto all = values(u);
    if (!is_number(*all)) {
      without_number(h);
      return without_number(g);
    }
    const std::size_t n = g.size();
    std::fill(g.begin(), g.end(), 0.0);
    std::fill(h.begin(), h.end(), 0.0);
    const double deviation = robust_.is_quantile ? 0 : deviation_of(*all);
    const bool bends = deviation > 0 && robust_.factor != 0;
    std::vector<std::vector<double>> slopes;
    for (const auto& [sample, weight] : weights(*all)) {
      optim::check_deadline();
      std::vector<double> own(f_.inputs().size()), second(optim::packed_size(own.size()));
      f_.hessian(design(u, offsets_[sample]), own, second);
      std::vector<double> slope(n);
      for (std::size_t i = 0; i < n; ++i) {
        slope[i] = own[own_.behind[i]];
        g[i] += weight * slope[i];
        for (std::size_t k = 0; k <= i; ++k) {
          const std::size_t a = own_.behind[i], b = own_.behind[k];
          h[optim::packed(i, k)] += weight * second[optim::packed(std::max(a, b), std::min(a, b))];
        }
      }
      if (bends) slopes.push_back(std::move(slope));
    }
    if (bends) add_bend(*all, slopes, deviation, h);
    return result(*all);
  }

  /// Parts that were drawn stand for all: nothing is proved of these.
  bool is_searched() const override { return true; }

  std::string why_undefined(std::span<const double> u) const override {
    for (const Point& offset : offsets_) {
      if (std::string why = f_.why_undefined(design(u, offset)); !why.empty()) return why;
    }
    return {};
  }

 private:
  std::vector<double> design(std::span<const double> u, const Point& offset) const {
    std::vector<double> x(first_ + offset.size());
    for (std::size_t k = 0; k < own_.variables.size(); ++k) x[own_.variables[k]] = u[k];
    for (std::size_t i = 0; i < offset.size(); ++i) {
      const double meant = own_.about[i] ? u[*own_.about[i]] : base_[i].lower;
      x[first_ + i] = meant + offset[i];
    }
    return x;
  }

  std::shared_ptr<const std::vector<double>> values(std::span<const double> u) const {
    return recent_.get(u, [&] {
      std::vector<double> all;
      for (const Point& offset : offsets_) {
        optim::check_deadline();  // each may be a search along a curve
        all.push_back(f_.value(design(u, offset)));
      }
      return all;
    });
  }

  static bool is_number(const std::vector<double>& all) {
    return std::none_of(all.begin(), all.end(), [](double value) { return std::isnan(value); });
  }
  static double without_number(std::span<double> derivatives) {
    std::fill(derivatives.begin(), derivatives.end(), std::nan(""));
    return std::nan("");
  }
  static double mean_of(const std::vector<double>& all) {
    double sum = 0;
    for (const double value : all) sum += value;
    return sum / static_cast<double>(all.size());
  }
  static double deviation_of(const std::vector<double>& all) {
    const double mean = mean_of(all);
    double squares = 0;
    for (const double value : all) squares += (value - mean) * (value - mean);
    return std::sqrt(squares / static_cast<double>(all.size() - 1));
  }

  double result(const std::vector<double>& all) const {
    if (robust_.is_quantile) return optim::quantile(all, robust_.share);
    const double mean = mean_of(all);
    return robust_.factor == 0 ? mean : mean + robust_.factor * deviation_of(all);
  }

  /// The derivatives of the result by the samples' values (TV6).
  std::vector<std::pair<std::size_t, double>> weights(const std::vector<double>& all) const {
    std::vector<std::pair<std::size_t, double>> result;
    const auto count = static_cast<double>(all.size());
    if (robust_.is_quantile) {
      const std::vector<std::size_t> order = optim::order_of(all);
      const double place = robust_.share * (count - 1);
      const auto below = std::min(static_cast<std::size_t>(place), all.size() - 2);
      const double beyond = place - static_cast<double>(below);
      return {{order[below], 1 - beyond}, {order[below + 1], beyond}};
    }
    const double mean = mean_of(all), deviation = deviation_of(all);
    for (std::size_t k = 0; k < all.size(); ++k) {
      const double spread =
          deviation > 0 ? robust_.factor * (all[k] - mean) / (deviation * (count - 1)) : 0;
      result.emplace_back(k, 1 / count + spread);
    }
    return result;
  }

  /// Of the deviation: what the samples' slopes add (TV7).
  void add_bend(const std::vector<double>& all, const std::vector<std::vector<double>>& slopes,
                double deviation, std::span<double> h) const {
    const std::size_t n = slopes.front().size();
    const auto count = static_cast<double>(all.size());
    const double mean = mean_of(all), share = robust_.factor / (deviation * (count - 1));
    std::vector<double> middle(n, 0.0), of_deviation(n, 0.0);
    for (const auto& slope : slopes) {
      for (std::size_t i = 0; i < n; ++i) middle[i] += slope[i] / count;
    }
    for (std::size_t k = 0; k < slopes.size(); ++k) {
      for (std::size_t i = 0; i < n; ++i) {
        of_deviation[i] += (all[k] - mean) * slopes[k][i] / (deviation * (count - 1));
        for (std::size_t j = 0; j <= i; ++j) {
          h[optim::packed(i, j)] += share * (slopes[k][i] - middle[i]) * (slopes[k][j] - middle[j]);
        }
      }
    }
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        h[optim::packed(i, j)] -= robust_.factor / deviation * of_deviation[i] * of_deviation[j];
      }
    }
  }

  Function f_;
  std::size_t first_;
  Box base_;
  OwnInputs own_;
  std::vector<Point> offsets_;
  Robust robust_;
  mutable Recent<std::vector<double>> recent_;  ///< the samples' values
};

/// The same parts whatever the problem.
std::vector<Point> offsets_of(const std::vector<VaryingParameter>& varying, std::size_t count) {
  // Any would do: it is the same for all, so that their designs compare.
  constexpr std::uint64_t kSeed = 1;
  SobolPoints points(varying.size(), kSeed);
  std::vector<Point> offsets(count, Point(varying.size()));
  for (Point& offset : offsets) {
    points.next(offset);
    for (std::size_t i = 0; i < varying.size(); ++i) {
      offset[i] = varying[i].off.at_share(offset[i]);
    }
  }
  return offsets;
}

double read_robust_number(std::string_view text, std::string_view whole) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc{} && end == text.data() + text.size() && std::isfinite(value)) {
    return value;
  }
  throw std::invalid_argument(fmt::format(
      "'{}' is not understood; write \"mean\", \"mean + 3 sigma\" or \"quantile 0.99\"", whole));
}

}  // namespace

std::string Robust::text() const {
  if (is_quantile) return fmt::format("quantile {:.10g}", share);
  if (factor == 0) return "mean";
  return fmt::format("mean {} {:.10g} sigma", factor < 0 ? '-' : '+', std::abs(factor));
}

std::size_t Robust::parts() const {
  // The mean of 32 even points of few numbers is good to some per cent of the deviation; a quantile
  // has four points beyond it at least.
  constexpr std::size_t kOfMean = 32, kLeast = 64;
  constexpr double kBeyond = 4;
  if (!is_quantile) return kOfMean;
  const double of = parts_for.value_or(share), beyond = std::min(of, 1 - of);
  return std::max(kLeast, std::bit_ceil(static_cast<std::size_t>(kBeyond / beyond)));
}

Robust parse_robust(std::string_view text) {
  std::string packed;
  for (const char c : text) {
    if (c != ' ') packed += c;
  }
  const std::string_view words = packed;
  if (words == "mean") return {};
  if (words.starts_with("quantile")) {
    const double share = read_robust_number(words.substr(8), text);
    if (!(share >= 1 - kLargestShare && share <= kLargestShare)) {
      throw std::invalid_argument(
          fmt::format("the fraction of a quantile must be between {:g} and {:g}; {:g} is given",
                      1 - kLargestShare, kLargestShare, share));
    }
    return {true, 0, share, {}};
  }
  const bool is_sum = words.starts_with("mean+"), is_difference = words.starts_with("mean-");
  if ((!is_sum && !is_difference) || !words.ends_with("sigma")) read_robust_number("", text);
  const std::string_view number = words.substr(5, words.size() - 10);
  const double factor = number.empty() ? 1 : read_robust_number(number, text);
  if (factor < 0) read_robust_number("", text);
  return {false, is_sum ? factor : -factor, 0, {}};
}

std::shared_ptr<const MechanismResponse> robust_number(std::shared_ptr<const Mechanism> mechanism,
                                                       const ResponseName& of,
                                                       const std::vector<VaryingParameter>& varying,
                                                       const Robust& robust) {
  auto result = std::make_shared<MechanismResponse>(*of.response);
  make_plain_number(*result);
  result->meaning = robust.text() + " over the parts as manufactured: " + of.response->meaning;
  std::vector<TakenRange> ranges;
  for (const VaryingParameter& v : varying) ranges.push_back({{v.parameter, 0, 0}, true});
  result->possible_by.ranges = parameters_of(ranges);
  result->number = [mechanism = std::move(mechanism), of, ranges, robust,
                    offsets = offsets_of(varying, robust.parts())](const Binding& binding,
                                                                   optim::Shape) {
    const Widened wide = widened(binding, ranges);
    const optim::Response made = make_response(*mechanism, of, wide.binding);
    const Function f = made.is_curve()
                           ? optim::peak_function(made, of.part, wide.first + ranges.size())
                           : made.function();
    auto kernel = std::make_shared<RobustKernel>(f, wide, offsets, robust);
    std::vector<std::size_t> inputs = kernel->own_inputs();
    return Function(std::move(inputs), std::move(kernel));
  };
  return result;
}

}  // namespace camlaw::problems
