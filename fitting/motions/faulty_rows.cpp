// SPDX-License-Identifier: MIT
#include "fitting/motions/faulty_rows.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "fitting/samples/lift_samples.h"
#include "numerics/linear/statistics.h"
#include "numerics/polynomial/lagrange.h"
#include "numerics/tables/turn.h"

namespace camlaw::problems {
namespace {

FaultyRow row_of(const MotionRecord& record, std::size_t i, double distance) {
  const std::size_t line = record.lines.empty() ? 0 : record.lines[i];
  return {line, record.samples.place[i], record.samples.value[i], distance};
}

/// Removes samples by their indexes.
void remove(MotionRecord& record, const std::vector<std::size_t>& which) {
  std::vector<bool> goes(record.samples.place.size());
  for (const std::size_t i : which) goes[i] = true;
  const auto keep = [&](auto& values) {
    std::size_t to = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!goes[i]) values[to++] = values[i];
    }
    values.resize(to);
  };
  keep(record.samples.place);
  keep(record.samples.value);
  if (!record.lines.empty()) keep(record.lines);
}

/// Samples by place, from which those at the ends may be taken.
struct Remaining {
  std::vector<std::size_t> order;
  std::size_t first, last;  ///< of those that are left
  const std::vector<double>& place;

  double at(std::size_t k) const { return place[order[k]]; }
  double range() const { return at(last) - at(first); }
};

/// The gap that parts few samples at an end from all others: which end, and where.
struct Parting {
  bool at_begin;
  std::size_t inner;  ///< the outermost of those that stay
};

/// What most neighbours are apart.
double usual_step(const Remaining& left) {
  std::vector<double> steps;
  for (std::size_t k = left.first; k < left.last; ++k) {
    const double step = left.at(k + 1) - left.at(k);
    if (step > 0) steps.push_back(step);
  }
  return steps.empty() ? 0 : optim::median(steps);
}

std::optional<Parting> parting(const Remaining& left, std::size_t most, bool is_angle) {
  constexpr double kGap = 10;  // times the range of all others: a pause of the record is shorter
  // Rows that go on beyond a turn in the same steps are no strays: they come round again.
  constexpr double kApart = 3;
  const bool is_long = is_angle && left.range() > kLongestTurn;
  const double apart = is_long ? kApart * usual_step(left) : 0;
  for (std::size_t k = 0; k < most; ++k) {
    const std::size_t inner = left.first + k + 1, outer = left.last - k - 1;
    if (outer <= inner) break;
    const double before = left.at(inner) - left.at(inner - 1),
                 after = left.at(outer + 1) - left.at(outer);
    const double within_begin = left.at(left.last) - left.at(inner),
                 within_end = left.at(outer) - left.at(left.first);
    const bool fits_begin = is_long && before > apart && within_begin <= kLongestTurn,
               fits_end = is_long && after > apart && within_end <= kLongestTurn;
    const double own = is_angle ? kTurnDegrees : 0;  // a turn is not far for an angle
    if (fits_begin || before > kGap * std::max(within_begin, own / kGap))
      return Parting{true, inner};
    if (fits_end || after > kGap * std::max(within_end, own / kGap)) return Parting{false, outer};
  }
  return {};
}

struct OddOne {
  std::size_t sample;
  double by;
};

/// Among few samples the one without which the others are smooth.
std::optional<OddOne> odd_one(const MotionSamples& samples) {
  // A cubic takes four neighbours, and four more rows have to judge a row without it.
  constexpr std::size_t kLeast = 9;
  constexpr double kOdd = 8;  // of the others' largest miss: noise makes no such multiple
  const std::vector<std::size_t> order = optim::order_of(samples.place);
  if (order.size() < kLeast) return {};
  std::vector<double> x, s;
  for (const std::size_t i : order) x.push_back(samples.place[i]), s.push_back(samples.value[i]);
  // What sample k misses the cubic by through the four nearest of the others but `without`.
  const auto miss = [&](std::size_t k, std::size_t without) {
    std::vector<std::size_t> near;
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (i != k && i != without) near.push_back(i);
    }
    const auto distance = [&](std::size_t i) { return i > k ? i - k : k - i; };
    std::partial_sort(near.begin(), near.begin() + 4, near.end(),
                      [&](std::size_t a, std::size_t b) {
                        return std::pair(distance(a), a) < std::pair(distance(b), b);
                      });
    return lagrange_miss(x, s, std::span(near).first(4), k);
  };
  // The outermost are reached only by going on beyond the others.
  for (std::size_t odd = 0; odd < order.size(); ++odd) {
    double others = 0;
    for (std::size_t k = 0; k < order.size(); ++k) {
      if (k != odd) others = std::max(others, std::abs(miss(k, odd)));
    }
    const double own = miss(odd, odd);
    if (others > 0 && std::isfinite(own) && std::abs(own) > kOdd * others) {
      return OddOne{order[odd], own};
    }
  }
  return {};
}

}  // namespace

bool are_few(std::size_t off, std::size_t rows) {
  // Slips of a hand or of a probe: more have a cause that the fit does not know.
  constexpr std::size_t kFew = 3, kOneIn = 50;
  return off <= std::max(kFew, rows / kOneIn);
}

void leave_out_stray_places(MotionRecord& record) {
  // Of fewer rows each may be the one that counts. One in twenty at an end may be of another
  // record.
  constexpr std::size_t kLeast = 5, kOneIn = 20;
  const std::size_t count = record.samples.place.size();
  if (count < kLeast) return;
  Remaining left{optim::order_of(record.samples.place), 0, count - 1, record.samples.place};
  std::vector<std::size_t> stray;
  std::size_t most = std::max<std::size_t>(1, count / kOneIn);
  const bool is_angle = record.samples.place_unit == "deg";
  while (most > 0) {
    const auto found = parting(left, most, is_angle);
    if (!found) break;
    const double inner = left.at(found->inner);
    const std::size_t from = found->at_begin ? left.first : found->inner + 1,
                      to = found->at_begin ? found->inner : left.last + 1;
    for (std::size_t k = from; k < to; ++k) {
      stray.push_back(left.order[k]);
      record.stray.push_back(row_of(record, left.order[k], std::abs(left.at(k) - inner)));
    }
    most -= to - from;
    found->at_begin ? left.first = found->inner : left.last = found->inner;
  }
  remove(record, stray);
}

void leave_out_far_values(MotionRecord& record, double period) {
  // Fewer rows leave a smoothing spline no freedom (bad_samples).
  constexpr std::size_t kEnough = 24;
  const MotionSamples& samples = record.samples;
  std::vector<std::size_t> far;
  std::vector<double> distances;
  if (samples.place.size() >= kEnough) {
    auto lift = lift_samples(samples.place, samples.value,
                             period > 0 ? std::optional(period) : std::nullopt, {},
                             rounding_deviation(samples));
    if (lift) {  // else it is no motion, or there are too few neighbours to tell
      far = std::move(lift->outlying);
      distances = std::move(lift->off);
    }
  } else if (const auto odd = odd_one(samples)) {
    far = {odd->sample};
    distances = {odd->by};
  }
  for (std::size_t k = 0; k < far.size(); ++k) {
    record.far.push_back(row_of(record, far[k], distances[k]));
  }
  std::sort(record.far.begin(), record.far.end(), [](const FaultyRow& a, const FaultyRow& b) {
    return std::abs(a.distance) > std::abs(b.distance);
  });
  remove(record, far);
}

std::size_t put_back(MotionRecord& record, const std::function<bool(const FaultyRow&)>& is_good) {
  const auto bad = std::stable_partition(record.far.begin(), record.far.end(), is_good);
  for (auto row = record.far.begin(); row != bad; ++row) {
    record.samples.place.push_back(row->place);
    record.samples.value.push_back(row->value);
    if (!record.lines.empty()) record.lines.push_back(static_cast<std::uint32_t>(row->line));
  }
  const auto count = static_cast<std::size_t>(bad - record.far.begin());
  record.far.erase(record.far.begin(), bad);
  return count;
}

}  // namespace camlaw::problems
