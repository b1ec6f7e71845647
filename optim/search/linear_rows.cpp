// SPDX-License-Identifier: MIT
#include "optim/search/linear_rows.h"

#include <algorithm>
#include <cmath>

namespace camlaw::optim {

bool LinearRows::add(const Function& function, double sign, double slack) {
  const std::vector<std::size_t>& inputs = function.inputs();
  std::vector<double> slopes(inputs.size());
  const double value = sign * function.gradient(at_, slopes);
  double steepest = 0;
  for (const double slope : slopes) steepest = std::max(steepest, std::abs(slope));
  if (!(steepest > 0) || !std::isfinite(steepest) || !std::isfinite(value)) return true;
  const double level = share_ * steepest;  // below it a slope is rounding
  Line line;
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    if (std::abs(slopes[k]) <= level) continue;
    line.inputs.push_back(inputs[k]);
    line.slopes.push_back(sign * slopes[k]);
  }
  std::multimap<double, Line>& known = lines_[line.inputs.front()];
  const auto alike = [&](const Line& other) {
    return other.inputs == line.inputs &&
           std::equal(line.slopes.begin(), line.slopes.end(), other.slopes.begin(),
                      [&](double a, double b) { return std::abs(a - b) <= level; });
  };
  for (auto at = known.lower_bound(value - slack); at != known.end() && at->first <= value + slack;
       ++at) {
    if (alike(at->second)) return false;
  }
  known.emplace(value, std::move(line));
  return true;
}

}  // namespace camlaw::optim
