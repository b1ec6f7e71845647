// SPDX-License-Identifier: MIT
#include "problems/refinement/divided_knots.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace camlaw::problems {
namespace {

/// Highest derivative of a polynomial piece, and its order.
struct Top {
  double value = 0;
  int order = 0;
};

Top top_of(const Piece<double>& piece) {
  double value = 0;
  const int degree = static_cast<int>(piece.polynomial.size()) - 1;
  if (degree >= 0) value = piece.polynomial.back();
  for (int k = 2; k <= degree; ++k) value *= k;
  return {value, degree};
}

const Piece<double>& piece_at(const Law<double>& law, double x) {
  const auto& pieces = law.pieces();
  const auto found = std::find_if(pieces.begin(), pieces.end(),
                                  [&](const Piece<double>& piece) { return x <= piece.end; });
  return found == pieces.end() ? pieces.back() : *found;
}

constexpr double kShortest = 1.0 / 65536;  // a span: each order of derivatives divides by it

/// Of the spans that are not short those that together promise most of what they all do.
std::vector<bool> chosen_spans(std::vector<double> promise, const std::vector<double>& knots) {
  constexpr double kMost = 0.85;  // the spans with the rest are many and gain little
  double from = 0;
  for (std::size_t i = 0; i < promise.size(); ++i) {
    const double to = i < knots.size() ? knots[i] : 1;
    if (to - from < 2 * kShortest) promise[i] = 0;
    from = to;
  }
  std::vector<std::size_t> order(promise.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return promise[a] > promise[b]; });
  const double all = std::accumulate(promise.begin(), promise.end(), 0.0);
  std::vector<bool> chosen(promise.size(), false);
  double sum = 0;
  for (const std::size_t i : order) {
    if (!(sum < kMost * all)) break;
    sum += promise[i];
    chosen[i] = true;
  }
  return chosen;
}

/// The place about which chosen spans are what was halved in the last round, at half its size, and
/// promise as much as it did; none where they are not, or where no knot or end lies there.
std::optional<double> shrunk_about(const Halved& now, const Halved& before,
                                   const std::vector<double>& knots) {
  constexpr double kRounding = 1e-12;  // of sums of knots
  constexpr double kKept = 0.75;       // where all derivatives have limits half of it is left
  if (!(now.promise > kKept * before.promise)) return {};
  const double place = 2 * now.from - before.from;
  if (std::abs(2 * (now.to - now.from) - (before.to - before.from)) > kRounding) return {};
  if (place < now.from - kRounding || place > now.to + kRounding) return {};
  for (const double end : {0.0, 1.0}) {
    if (std::abs(place - end) <= kRounding) return end;
  }
  const auto knot =
      std::ranges::find_if(knots, [&](double k) { return std::abs(place - k) <= kRounding; });
  return knot == knots.end() ? std::nullopt : std::optional(*knot);
}

/// (KN2) Adds a knot in the middle of each span between `ends`, which lie next to one another.
/// Where the last round did the same at twice the size, about a place where a derivative grows
/// without bound, further rounds would repeat that: twice as many of them as at the last time are
/// taken at once.
void halve(const std::vector<double>& ends, double promise, const DividedKnots& divided, int most,
           DividedKnots& result) {
  Halved own{ends.front(), ends.back(), promise};
  std::optional<double> about;
  for (const Halved& before : divided.last) {
    about = shrunk_about(own, before, divided.knots);
    if (!about) continue;
    own.times = std::min(2 * before.times, most);
    break;
  }
  double shortest = 1;
  for (std::size_t i = 1; i < ends.size(); ++i)
    shortest = std::min(shortest, ends[i] - ends[i - 1]);
  while (own.times > 1 && std::ldexp(shortest, -own.times) < kShortest) --own.times;
  for (int k = 0; k < own.times; ++k) {
    for (std::size_t i = 1; i < ends.size(); ++i) {
      const double middle = 0.5 * (ends[i - 1] + ends[i]);
      result.knots.push_back(k == 0 ? middle : *about + std::ldexp(middle - *about, -k));
    }
  }
  if (about) {  // the last of them halved this
    own.from = *about + std::ldexp(own.from - *about, 1 - own.times);
    own.to = *about + std::ldexp(own.to - *about, 1 - own.times);
  }
  result.last.push_back(own);
}

}  // namespace

std::vector<double> promises(const Law<double>& law, const std::vector<double>& knots) {
  std::vector<double> ends{0};
  ends.insert(ends.end(), knots.begin(), knots.end());
  ends.push_back(1);
  std::vector<Top> tops;
  std::vector<double> accelerations;
  int degree = 0;
  double mean = 0;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const double middle = 0.5 * (ends[i] + ends[i + 1]);
    tops.push_back(top_of(piece_at(law, middle)));
    degree = std::max(degree, tops.back().order);
    accelerations.push_back(std::abs(law(middle).a));
    mean += accelerations.back() / static_cast<double>(ends.size() - 1);
  }
  const auto value = [&](std::size_t i) { return tops[i].order == degree ? tops[i].value : 0; };
  std::vector<double> result(tops.size(), 0.0);
  for (std::size_t i = 0; i < tops.size() && mean > 0; ++i) {
    double jumps = 0;
    if (i > 0) jumps += std::abs(value(i) - value(i - 1));
    if (i + 1 < tops.size()) jumps += std::abs(value(i + 1) - value(i));
    result[i] = jumps * std::pow(ends[i + 1] - ends[i], std::max(1, degree - 2)) /
                (accelerations[i] + mean);
  }
  return result;
}

int DividedKnots::halvings() const {
  int most = 1;
  for (const Halved& halved : last) most = std::max(most, halved.times);
  return most;
}

DividedKnots with_more(const DividedKnots& divided, std::vector<double> promise, bool symmetric,
                       int most) {
  constexpr double kSame = 1e-12;  // two knots
  const std::size_t last = promise.size() - 1;
  if (symmetric) {
    for (std::size_t i = 0; i <= last / 2; ++i)
      promise[i] = promise[last - i] = std::max(promise[i], promise[last - i]);
  }
  const std::vector<bool> chosen = chosen_spans(promise, divided.knots);
  DividedKnots result{divided.knots};
  std::vector<double> ends;  // of chosen spans next to one another
  double largest = 0;        // of what these promise
  double from = 0;
  for (std::size_t i = 0; i <= last; ++i) {
    const double to = i < last ? divided.knots[i] : 1;
    if (chosen[i] || (symmetric && chosen[last - i])) {
      if (ends.empty()) ends.push_back(from);
      ends.push_back(to);
      largest = std::max(largest, promise[i]);
    } else if (!ends.empty()) {
      halve(ends, largest, divided, most, result);
      ends.clear();
      largest = 0;
    }
    from = to;
  }
  if (!ends.empty()) halve(ends, largest, divided, most, result);
  std::vector<double>& knots = result.knots;
  std::ranges::sort(knots);
  const auto same = [](double a, double b) { return b - a < kSame; };
  knots.erase(std::unique(knots.begin(), knots.end(), same), knots.end());
  return result;
}

}  // namespace camlaw::problems
