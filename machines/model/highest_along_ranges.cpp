// SPDX-License-Identifier: MIT
#include "machines/model/highest_along_ranges.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "optim/cycle/proof_time.h"

namespace camlaw::problems {
namespace {

/// The highest place of a function so far; of one whose value is not a number the first such place.
struct Best {
  Point place;
  double value;

  bool is_number() const { return !std::isnan(value); }
  void look_at(const Point& p, double there) {
    if (!is_number() || !(there > value || std::isnan(there))) return;
    place = p;
    value = there;
  }
};

void look_along(std::size_t range, const optim::Bounds& ends, const ManyHeights& values,
                std::vector<Best>& best) {
  constexpr int kSteps = 32;  // a top that the grid misses may be as narrow along one range
  std::map<Point, std::vector<std::size_t>> same;
  for (std::size_t i = 0; i < best.size(); ++i) {
    if (best[i].is_number()) same[best[i].place].push_back(i);
  }
  for (auto& [from, functions] : same) {
    Point p = from;
    for (int step = 0; step <= kSteps && !functions.empty(); ++step) {
      p[range] = std::lerp(ends.lower, ends.upper, static_cast<double>(step) / kSteps);
      const std::vector<double> there = values(p, functions);
      for (std::size_t k = 0; k < functions.size(); ++k) best[functions[k]].look_at(p, there[k]);
      std::erase_if(functions, [&](std::size_t i) { return !best[i].is_number(); });
    }
  }
}

}  // namespace

void Heights::add(Point place, double value) {
  places.push_back(std::move(place));
  values.push_back(value);
}

bool Heights::is_undefined() const { return !values.empty() && std::isnan(values.back()); }

double Heights::at(const Point& place) const {
  const auto found = std::find(places.begin(), places.end(), place);
  return values[static_cast<std::size_t>(found - places.begin())];
}

std::vector<Heights> heights_along_ranges(const Box& box, const std::vector<Point>& places,
                                          std::size_t count, const ManyHeights& values) {
  std::vector<Heights> result(count);
  std::vector<std::size_t> functions(count);
  std::iota(functions.begin(), functions.end(), std::size_t{0});
  for (const Point& p : places) {
    if (functions.empty()) break;
    const std::vector<double> there = values(p, functions);
    for (std::size_t k = 0; k < functions.size(); ++k) result[functions[k]].add(p, there[k]);
    std::erase_if(functions, [&](std::size_t i) { return result[i].is_undefined(); });
  }
  if (optim::ProofTime::is_over()) return result;
  std::vector<Best> best;
  for (const Heights& heights : result) {
    best.push_back({heights.places.front(), heights.values.front()});
    for (std::size_t k = 0; k < heights.places.size(); ++k) {
      best.back().look_at(heights.places[k], heights.values[k]);
    }
  }
  for (std::size_t range = 0; range < box.size(); ++range) {
    if (box[range].lower < box[range].upper) look_along(range, box[range], values, best);
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (!result[i].is_undefined()) result[i].add(std::move(best[i].place), best[i].value);
  }
  return result;
}

}  // namespace camlaw::problems
