// SPDX-License-Identifier: MIT
#include "output/export/curve_fit.h"

#include <boost/math/tools/minima.hpp>

namespace camlaw::problems {
namespace {

/// The top of value(x) between two places on both sides of a higher one.
template <class Value>
double top_between(double low, double high, const Value& value) {
  constexpr int kBits = 10;  // which leave 1e-3 of the way, and 1e-6 of the rise over it
  return -boost::math::tools::brent_find_minima([&](double x) { return -value(x); }, low, high,
                                                kBits)
              .second;
}

}  // namespace

double worst_over(const PlaneCurve& curve, const CurveSpan& span, double enough,
                  const DistanceAt& distance) {
  // A deviation has a few waves over a span, as of an arc or a cubic from a smooth curve.
  constexpr int kLooks = 16;
  const auto look = [&](double place) {
    const optim::Place here{std::lerp(span.from.angle, span.to.angle, place / kLooks)};
    return distance(here, curve.at(here).at);
  };
  // Most spans that are too long show it in the middle.
  const double middle = look(kLooks / 2);
  if (middle > enough) return middle;
  const auto places = optim::even_places(span.from.angle, span.to.angle, kLooks);
  const auto points = curve.points(places);
  std::vector<double> values;
  for (std::size_t i = 0; i < places.size(); ++i) values.push_back(distance(places[i], points[i]));
  double worst = *std::max_element(values.begin(), values.end());
  for (std::size_t i = 1; i < kLooks && worst <= enough; ++i) {
    // Others, at half the highest, are not the highest in between.
    if (values[i] < values[i - 1] || values[i] < values[i + 1] || values[i] < worst / 2) continue;
    const auto place = static_cast<double>(i);
    worst = std::max(worst, top_between(place - 1, place + 1, look));
  }
  return worst;
}

}  // namespace camlaw::problems
