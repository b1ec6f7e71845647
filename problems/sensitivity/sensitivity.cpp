// SPDX-License-Identifier: MIT
#include "problems/sensitivity/sensitivity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "numerics/text/names.h"
#include "numerics/text/units.h"
#include "optim/problem/deadline.h"
#include "problems/statement/parameters.h"

namespace camlaw::problems {
namespace {

/// A part of each parameter that is small beside it, and large beside rounding.
constexpr double kHundredth = 0.01;

std::vector<double> values_of_parameters(const std::vector<DesignParameter>& parameters) {
  std::vector<double> values;
  for (const DesignParameter& parameter : parameters) values.push_back(parameter.value);
  return values;
}

/// What a parameter is compared with: its value, of one near 0 a part of what it may be.
double size_of_parameter(const DesignParameter& parameter) {
  return std::max(std::abs(parameter.value), 1e-3 * std::min(parameter.high - parameter.low, 1.0));
}

/// The slope by a parameter of that size that rounding alone may leave, of a number with this value
/// on a curve that is `largest` in size at most.
double told_slope(double value, double largest, double size) {
  // Sums of laws leave some thousand units of the last place. A value in a rest may be far smaller
  // than those that its curve is computed from.
  constexpr double kTold = 1e-11, kOfCurve = 1e-3;
  return kTold * std::max(std::abs(value), kOfCurve * largest) / size;
}

/// Slopes of no more than `least` are none.
Sensitivity sensitivity_of(double value, double parameter, std::pair<double, double> slopes,
                           double least) {
  const double first = std::abs(slopes.first) <= least ? 0 : slopes.first;
  const double second = std::abs(slopes.second) <= least ? 0 : slopes.second;
  const double size = std::max(std::abs(first), std::abs(second));
  constexpr double kFound = 1e-6;  // a peak's place is found to the root of rounding
  const bool is_kink = second - first > kFound * size;
  Sensitivity result;
  result.slope = is_kink ? (first + second) / 2 : first;
  if (std::abs(result.slope) < kFound * size) result.slope = 0;
  result.low = is_kink ? first : result.slope;
  result.high = is_kink ? second : result.slope;
  const bool has_ratio = value != 0 && parameter != 0;
  result.elasticity =
      has_ratio ? result.slope * parameter / value : std::numeric_limits<double>::quiet_NaN();
  return result;
}

/// The parameter that a range is of.
DesignParameter ranged(const ProblemStatement& design, const std::vector<DesignParameter>& all,
                       std::string_view name) {
  std::string found(name);
  for (const MechanismParameter& p : design.mechanism->parameters) {
    if (p.symbol == name) found = p.name;
  }
  for (const DesignParameter& parameter : all) {
    if (parameter.name == found) return parameter;
  }
  const std::string left_out = parameter_left_out(design);
  if (left_out.starts_with(found + " ")) throw std::invalid_argument(left_out);
  std::vector<std::string> known;
  for (const DesignParameter& parameter : all) known.push_back(parameter.name);
  refuse_name("no objective or limit depends on a continuous parameter", std::string(name), known);
}

/// "10:40 mm" or "10 mm:40 mm".
SensitivityRange read_range(const ProblemStatement& design, const std::vector<DesignParameter>& all,
                            const std::string& text) {
  const std::size_t equals = text.find('=');
  const std::size_t colon = equals == std::string::npos ? equals : text.find(':', equals);
  if (colon == std::string::npos) {
    throw std::invalid_argument(
        fmt::format("'{}' is not a range; write name=lower:upper, such as stroke=10:40 mm", text));
  }
  const std::string name(trimmed(std::string_view(text).substr(0, equals)));
  SensitivityRange range{ranged(design, all, name), 0, 0};
  const DesignParameter& p = range.parameter;
  std::string lower = text.substr(equals + 1, colon - equals - 1);
  const std::string upper(trimmed(std::string_view(text).substr(colon + 1)));
  const bool is_bare = std::none_of(lower.begin(), lower.end(), [](unsigned char c) {
    return std::isalpha(c) != 0 && c != 'e' && c != 'E';
  });
  const std::size_t unit = upper.find_first_not_of("+-.0123456789eE ");
  if (is_bare && unit != std::string::npos) lower += " " + upper.substr(unit);
  range.lower = onto_range(parse_quantity(lower, p.unit, p.unit, name), p.low, p.high);
  range.upper = onto_range(parse_quantity(upper, p.unit, p.unit, name), p.low, p.high);
  if (!(range.lower < range.upper)) {
    throw std::invalid_argument(fmt::format("{}: lower {} is not below upper {}", name,
                                            with_unit(range.lower, p.unit),
                                            with_unit(range.upper, p.unit)));
  }
  if (!(range.lower >= p.low && range.upper <= p.high)) {
    throw std::invalid_argument(fmt::format("{}: {} is not within {}", name,
                                            range_text(range.lower, range.upper, p.unit),
                                            range_text(p.low, p.high, p.unit)));
  }
  return range;
}

/// The slope of a number to one side, by two steps and Richardson's extrapolation; none where the
/// parameter cannot be changed, or the number has no value there.
/// What is no more than `noise` is rounding.
std::optional<double> slope_to(const DesignNumber& number, std::vector<double> x, std::size_t i,
                               double value, double step, double noise) {
  const double at = x[i];
  const auto slope = [&](double h) {
    x[i] = at + h;
    return (number.function.value(x) - value) / (x[i] - at);
  };
  const double far = slope(step), near = slope(step / 2);
  if (std::max(std::abs(far), std::abs(near)) <= noise) return 0;
  const double result = 2 * near - far;
  // What bends or scatters over the step tells nothing.
  const bool agrees = std::abs(far - near) <= 0.05 * std::max(std::abs(far), std::abs(near));
  if (!std::isfinite(result) || !(agrees || far == near)) return {};
  return result;
}

/// A derivative as it is where differences agree with it, else what they say.
Sensitivity checked(const DesignNumber& number, const DesignParameter& parameter,
                    const std::vector<double>& x, std::size_t i, double value, Sensitivity exact,
                    double least) {
  // The error of a difference over this step is some 1e-4 of the slope of a smooth number and 1e-12
  // of its value by rounding. A slope that is a hundredth off is another one: a kink's, or that of
  // another peak.
  constexpr double kStep = 1e-4, kAgrees = 1e-2;
  const double size = size_of_parameter(parameter);
  const double step = kStep * size;
  if (!(x[i] - step >= parameter.low && x[i] + step <= parameter.high)) return exact;
  const double noise = 1e-8 * std::abs(value) / size;
  const auto by_steps = [&](double h) -> std::optional<std::pair<double, double>> {
    const auto up = slope_to(number, x, i, value, h, noise);
    const auto down = slope_to(number, x, i, value, -h, noise);
    if (!up || !down) return {};
    return std::pair(std::min(*up, *down), std::max(*up, *down));
  };
  const auto off_exact = [&](const std::pair<double, double>& slopes) {
    return std::max(std::abs(slopes.first - exact.low), std::abs(slopes.second - exact.high));
  };
  const auto found = by_steps(step);
  if (!found) return exact;
  const auto [low, high] = *found;
  const double scale = std::max({std::abs(low), std::abs(high), 1e-6 * std::abs(value) / size});
  const double off = off_exact(*found);
  if (off <= kAgrees * scale) return exact;
  // A peak's place is found to the root of rounding, and with it the terms that cancel there.
  constexpr double kCancelled = 1e-6;
  if (low == 0 && high == 0 && off <= kCancelled * std::abs(value) / size) {
    return sensitivity_of(value, x[i], {0, 0}, least);
  }
  // Where the slope itself changes as a broken power does, such as that of a load's share of a life
  // at no load, differences come near it slowly.
  constexpr double kShorter = 16, kNearer = 0.75;
  const auto nearer = by_steps(step / kShorter);
  if (!nearer || off_exact(*nearer) <= kNearer * off) return exact;
  const bool is_smooth = high - low <= kAgrees * scale;
  const double middle = (low + high) / 2;
  Sensitivity result =
      sensitivity_of(value, x[i], {is_smooth ? middle : low, is_smooth ? middle : high}, least);
  result.by_difference = true;
  return result;
}

/// Of a curve's part the largest value of the curve in the design.
std::vector<double> sizes_of(const std::vector<DesignNumber>& numbers,
                             const std::vector<DesignParameter>& parameters) {
  std::vector<double> x, sizes;
  for (const DesignParameter& parameter : parameters) x.push_back(parameter.value);
  for (const DesignNumber& number : numbers) {
    const double size = number.response.is_curve() ? number.response.curve().largest(x) : 0;
    sizes.push_back(std::isfinite(size) ? size : 0);
  }
  return sizes;
}

}  // namespace

LocalSensitivity local_sensitivity(const ProblemStatement& design) {
  LocalSensitivity result;
  result.parameters = design_parameters(design);
  result.left_out = parameter_left_out(design);
  const auto numbers = design_numbers(design, result.parameters);
  if (result.parameters.empty() || numbers.empty()) {
    throw std::invalid_argument(
        "no objective or limit depends on a continuous parameter, so there are no sensitivities to "
        "calculate");
  }
  const std::vector<double> x = values_of_parameters(result.parameters);
  const std::vector<double> sizes = sizes_of(numbers, result.parameters);
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const DesignNumber& number = numbers[k];
    NumberSensitivity own{
        number.name, number.unit, number.is_objective, number.function.value(x), {}};
    const auto slopes = number.slopes(x);
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double least = told_slope(own.value, sizes[k], size_of_parameter(result.parameters[i]));
      own.by.push_back(checked(number, result.parameters[i], x, i, own.value,
                               sensitivity_of(own.value, x[i], slopes[i], least), least));
    }
    result.numbers.push_back(std::move(own));
  }
  return result;
}

SensitivityRanges sensitivity_ranges(const ProblemStatement& design,
                                     std::span<const std::string> over) {
  const std::vector<DesignParameter> all = design_parameters(design);
  SensitivityRanges result;
  for (const std::string& text : over) {
    result.ranges.push_back(read_range(design, all, text));
    const std::string& name = result.ranges.back().parameter.name;
    const auto same = [&](const SensitivityRange& r) { return r.parameter.name == name; };
    if (std::count_if(result.ranges.begin(), result.ranges.end(), same) > 1) {
      throw std::invalid_argument(fmt::format("{} has two ranges; give one", name));
    }
  }
  if (!over.empty()) return result;
  result.from = RangesFrom::File;
  for (const ParameterRange& range : design.ranges) {
    for (const DesignParameter& parameter : all) {
      if (parameter.of_machine != range.parameter) continue;
      result.ranges.push_back({parameter, range.lower, range.upper});
    }
  }
  if (!result.ranges.empty()) return result;
  result.from = RangesFrom::Hundredths;
  for (const DesignParameter& parameter : all) {
    const double off = kHundredth * std::abs(parameter.value);
    const double lower = std::max(parameter.low, parameter.value - off);
    const double upper = std::min(parameter.high, parameter.value + off);
    if (lower < upper) result.ranges.push_back({parameter, lower, upper});
  }
  return result;
}

GlobalSensitivity global_sensitivity(const ProblemStatement& design, SensitivityRanges over,
                                     const optim::SobolOptions& options,
                                     const std::atomic<bool>* stop) {
  GlobalSensitivity result;
  std::vector<DesignParameter> parameters;
  std::vector<optim::Quantile> quantiles;
  for (const SensitivityRange& range : over.ranges) {
    parameters.push_back(range.parameter);
    quantiles.push_back(optim::even_between(range.lower, range.upper));
  }
  ProblemStatement watched = design;
  watched.stop = stop;
  result.over = std::move(over);
  result.numbers = design_numbers(watched, parameters);
  const auto model = [&](std::span<const double> x, std::span<double> values) {
    optim::Deadline({}, stop).check();
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = result.numbers[i].function.value(x);
    }
  };
  optim::SobolOptions with_sizes = options;
  with_sizes.sizes = sizes_of(result.numbers, parameters);
  result.indices = optim::sobol_indices(quantiles, result.numbers.size(), model, with_sizes);
  return result;
}

}  // namespace camlaw::problems
