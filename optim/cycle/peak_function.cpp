// SPDX-License-Identifier: MIT
#include "optim/cycle/peak_function.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "optim/cycle/extremes.h"
#include "optim/cycle/peak_slopes.h"

namespace camlaw::optim {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

enum class Look { Sampled, Proved };

class PeakKernel final : public Kernel {
 public:
  PeakKernel(Response response, Part part, Look look)
      : response_(std::move(response)), part_(part), look_(look) {}

  double value(std::span<const double> u) const override {
    const Extreme peak = find(u);
    return part_ == Part::Magnitude ? std::abs(peak.value) : peak.value;
  }

  double gradient(std::span<const double> u, std::span<double> g) const override {
    const auto trace = response_.curve().trace(u);
    const Extreme peak = find(*trace);
    const double sign = sign_of(peak);
    fill(peak_slopes(response_.curve(), *trace, peak.place, u), sign, g);
    return sign * peak.value;
  }

  /// Of the peak at the place p: f_uu, less f_up f_up^T / f_pp where p lies inside a smooth
  /// stretch and so moves with u (docs/optimisation.md, "Second order"). Not numbers where the peak
  /// is an edge of the formula that moves.
  double hessian(std::span<const double> u, std::span<double> g,
                 std::span<double> h) const override {
    const auto trace = response_.curve().trace(u);
    const Extreme peak = find(*trace);
    const double sign = sign_of(peak), result = sign * peak.value;
    const Function f = response_.curve().at(response_.curve().tied(peak.place, u));
    const std::vector<std::size_t>& inputs = f.inputs();
    std::vector<double> slopes(inputs.size()), second(packed_size(inputs.size()));
    f.hessian(u, slopes, second);
    const PeakSlopes known = peak_slopes(response_.curve(), *trace, peak.place, u);
    fill(known, sign, g);
    if (known.moves_with_edge) {
      std::fill(h.begin(), h.end(), kNaN);
      return result;
    }
    std::fill(h.begin(), h.end(), 0.0);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      for (std::size_t k = 0; k <= i; ++k) {
        h[packed(inputs[i], inputs[k])] = sign * second[packed(i, k)];
      }
    }
    const std::vector<double> breaks = trace->breaks();
    if (std::binary_search(breaks.begin(), breaks.end(), peak.place.angle)) return result;
    const std::vector<double> moved = response_.curve().slope_gradient(peak.place, u);
    const double bend = trace->at(peak.place)[2];
    for (std::size_t i = 0; i < u.size(); ++i) {
      for (std::size_t k = 0; k <= i; ++k) {
        h[packed(i, k)] -= moved.empty() ? kNaN : sign * moved[i] * moved[k] / bend;
      }
    }
    return result;
  }

  bool is_searched() const override { return true; }
  std::shared_ptr<const Kernel> proved() const override {
    return std::make_shared<PeakKernel>(response_, part_, Look::Proved);
  }
  /// Between the peak found and the least bound above it that intervals prove.
  Bounds enclose(std::span<const double> u) const override {
    const auto trace = response_.curve().trace(u);
    const ProvedExtreme found = proved_extreme_of(*trace, part_);
    const Place place = found.peak.place;
    const Bounds here = enclosed_at(*trace, place);
    const double value = found.peak.value, room = found.proved ? found.slack : kInfinity;
    if (part_ == Part::Lowest) return {value - room, here.upper};
    if (part_ == Part::Highest) return {here.lower, value + room};
    const double least = value < 0 ? -here.upper : here.lower;
    return {std::max(least, 0.0), std::abs(value) + room};
  }

 private:
  double sign_of(const Extreme& peak) const {
    return part_ == Part::Magnitude && peak.value < 0 ? -1 : 1;
  }
  static void fill(const PeakSlopes& slopes, double sign, std::span<double> g) {
    for (std::size_t i = 0; i < g.size(); ++i) g[i] = sign * slopes.by[i];
  }
  Extreme find(const Trace& trace) const {
    return look_ == Look::Proved ? proved_extreme_of(trace, part_).peak : extreme_of(trace, part_);
  }
  Extreme find(std::span<const double> u) const { return find(*response_.curve().trace(u)); }

  Response response_;
  Part part_;
  Look look_;
};

}  // namespace

Function peak_function(const Response& response, Part part, std::size_t variables) {
  std::vector<std::size_t> all(variables);
  std::iota(all.begin(), all.end(), std::size_t{0});
  return {std::move(all), std::make_shared<PeakKernel>(response, part, Look::Sampled),
          peak_shape(response.shape(), part)};
}

SizedProblem with_peaks_as_numbers(const Problem& problem, const Scales& scales) {
  const std::size_t n = problem.variables.size();
  const auto number = [&](const Response& curve, Part part) {
    return Response{curve.name, curve.unit, peak_function(curve, part, n)};
  };
  SizedProblem result{problem, scales};
  for (Objective& objective : result.problem.objectives) {
    if (!objective.response.is_curve()) continue;
    objective.response = number(objective.response, objective.part);
    objective.part = Part::Value;
  }
  result.problem.constraints.clear();
  result.scales.constraints.clear();
  for (std::size_t i = 0; i < problem.constraints.size(); ++i) {
    const auto add = [&](Constraint side) {
      result.problem.constraints.push_back(std::move(side));
      result.scales.constraints.push_back(scales.constraints[i]);
    };
    const Constraint& c = problem.constraints[i];
    if (!c.response.is_curve()) {
      add(c);
      continue;
    }
    Constraint upper = c, lower = c;
    upper.response = number(c.response, Part::Highest);
    lower.response = number(c.response, Part::Lowest);
    upper.lower.reset();
    lower.upper.reset();
    if (c.upper) add(std::move(upper));
    if (c.lower) add(std::move(lower));
  }
  return result;
}

}  // namespace camlaw::optim
