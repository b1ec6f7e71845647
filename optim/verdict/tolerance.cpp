// SPDX-License-Identifier: MIT
#include "optim/verdict/tolerance.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "optim/problem/sizes.h"
#include "optim/verdict/limits.h"

namespace camlaw::optim {
namespace {

using Numbers = std::vector<double>;

/// Objectives and margins of designs.
class Measured {
 public:
  Measured(const MultiProblem& problem, Design x)
      : multi_(problem), problem_(problem.alone(0)), sizes_(sizes(problem_, x)) {}

  Numbers at(Design x) const {
    Numbers numbers;
    for (const Objective& objective : multi_.objectives) {
      numbers.push_back(objective_value(objective, x));
    }
    for (const LimitReport& limit : limit_reports(problem_, sizes_, x, false)) {
      numbers.push_back(limit.margin);
    }
    return numbers;
  }

  std::vector<Spread> names() const {
    std::vector<Spread> spreads;
    for (const Objective& o : multi_.objectives) {
      spreads.push_back({.name = o.response.name, .unit = o.response.unit});
    }
    for (const Constraint& c : multi_.constraints) {
      spreads.push_back({.name = c.response.name, .unit = c.response.unit, .is_margin = true});
    }
    return spreads;
  }

  bool meets_limits(const Numbers& numbers) const {
    for (std::size_t i = 0; i < sizes_.constraints.size(); ++i) {
      const double margin = numbers[multi_.objectives.size() + i];
      if (!(margin >= -sizes_.constraints[i].tolerance)) return false;
    }
    return true;
  }

 private:
  const MultiProblem& multi_;
  Problem problem_;
  Sizes sizes_;
};

void widen(std::vector<Spread>& spreads, const Numbers& numbers) {
  for (std::size_t i = 0; i < spreads.size(); ++i) {
    spreads[i].lowest = std::min(spreads[i].lowest, numbers[i]);
    spreads[i].highest = std::max(spreads[i].highest, numbers[i]);
  }
}

std::vector<double> moved(Design x, std::size_t variable, double by) {
  std::vector<double> result(x.begin(), x.end());
  result[variable] += by;
  return result;
}

/// Each variable alone, both ways; the changes, with the sign of the way that raises the number.
std::vector<Numbers> single_changes(const Measured& measured, Design x, const Numbers& tolerances,
                                    std::vector<Spread>& spreads) {
  std::vector<Numbers> rises(spreads.size(), Numbers(x.size(), 0.0));
  for (Spread& spread : spreads) spread.by_variable.assign(x.size(), 0.0);
  for (std::size_t v = 0; v < x.size(); ++v) {
    if (tolerances[v] == 0) continue;
    const Numbers up = measured.at(moved(x, v, tolerances[v]));
    const Numbers down = measured.at(moved(x, v, -tolerances[v]));
    widen(spreads, up);
    widen(spreads, down);
    for (std::size_t i = 0; i < spreads.size(); ++i) {
      const double by_up = up[i] - spreads[i].nominal, by_down = down[i] - spreads[i].nominal;
      spreads[i].by_variable[v] = std::abs(by_up) >= std::abs(by_down) ? by_up : by_down;
      rises[i][v] = up[i] >= down[i] ? 1 : -1;
    }
  }
  return rises;
}

std::vector<double> corner(Design x, const Numbers& tolerances, const Numbers& signs) {
  std::vector<double> result(x.begin(), x.end());
  for (std::size_t v = 0; v < x.size(); ++v) result[v] += signs[v] * tolerances[v];
  return result;
}

/// All corners; of the variables without a tolerance there is one side.
void look_at_corners(const Measured& measured, Design x, const Numbers& tolerances,
                     std::vector<Spread>& spreads) {
  std::vector<std::size_t> off;
  for (std::size_t v = 0; v < x.size(); ++v) {
    if (tolerances[v] > 0) off.push_back(v);
  }
  for (std::size_t bits = 0; bits < (std::size_t{1} << off.size()); ++bits) {
    Numbers signs(x.size(), 0.0);
    for (std::size_t k = 0; k < off.size(); ++k) signs[off[k]] = (bits >> k) & 1U ? 1 : -1;
    widen(spreads, measured.at(corner(x, tolerances, signs)));
  }
}

void sum_up(std::vector<Spread>& spreads, const std::vector<Numbers>& samples) {
  const auto count = static_cast<double>(samples.size());
  for (std::size_t i = 0; i < spreads.size(); ++i) {
    Numbers values;
    for (const Numbers& sample : samples) values.push_back(sample[i]);
    std::sort(values.begin(), values.end());
    double sum = 0, squares = 0;
    for (const double v : values) sum += v;
    spreads[i].mean = sum / count;
    for (const double v : values) squares += (v - spreads[i].mean) * (v - spreads[i].mean);
    spreads[i].deviation = samples.size() > 1 ? std::sqrt(squares / (count - 1)) : 0;
    const auto quantile = [&](double q) {
      return values[static_cast<std::size_t>(q * (count - 1) + 0.5)];
    };
    spreads[i].low = quantile(0.05);
    spreads[i].high = quantile(0.95);
  }
}

void check(Design x, const Numbers& tolerances, std::size_t samples) {
  const bool proper = std::all_of(tolerances.begin(), tolerances.end(),
                                  [](double t) { return t >= 0 && std::isfinite(t); });
  if (tolerances.size() != x.size() || !proper) {
    throw std::invalid_argument("tolerances: one for each variable is wanted, none negative");
  }
  if (samples < 1) throw std::invalid_argument("samples: at least one is needed");
}

}  // namespace

ToleranceReport tolerance_report(const MultiProblem& problem, Design x,
                                 const std::vector<double>& tolerances, std::size_t samples,
                                 std::uint64_t seed) {
  check(x, tolerances, samples);
  constexpr std::ptrdiff_t kAllCorners = 10;
  const Measured measured(problem, x);
  ToleranceReport report;
  report.spreads = measured.names();
  report.samples = samples;
  const Numbers nominal = measured.at(x);
  for (std::size_t i = 0; i < nominal.size(); ++i) {
    Spread& spread = report.spreads[i];
    spread.nominal = spread.lowest = spread.highest = nominal[i];
  }
  const auto rises = single_changes(measured, x, tolerances, report.spreads);
  report.all_corners = std::count_if(tolerances.begin(), tolerances.end(),
                                     [](double t) { return t > 0; }) <= kAllCorners;
  if (report.all_corners) {
    look_at_corners(measured, x, tolerances, report.spreads);
  } else {
    for (const Numbers& signs : rises) {
      Numbers opposite(signs);
      for (double& sign : opposite) sign = -sign;
      widen(report.spreads, measured.at(corner(x, tolerances, signs)));
      widen(report.spreads, measured.at(corner(x, tolerances, opposite)));
    }
  }
  std::mt19937_64 generator(seed);
  std::vector<Numbers> drawn;
  std::size_t good = 0;
  for (std::size_t k = 0; k < samples; ++k) {
    Numbers signs(x.size());
    // In [-1, 1), the same with every library: std's distributions are not.
    for (double& sign : signs) sign = std::ldexp(static_cast<double>(generator() >> 11U), -52) - 1;
    drawn.push_back(measured.at(corner(x, tolerances, signs)));
    widen(report.spreads, drawn.back());
    good += measured.meets_limits(drawn.back());
  }
  report.yield = static_cast<double>(good) / static_cast<double>(samples);
  sum_up(report.spreads, drawn);
  return report;
}

}  // namespace camlaw::optim
