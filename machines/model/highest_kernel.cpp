// SPDX-License-Identifier: MIT
#include "machines/model/highest_kernel.h"

#include <algorithm>
#include <cmath>

#include "machines/model/highest_along_ranges.h"
#include "machines/model/inner_numbers.h"
#include "machines/model/not_a_number.h"
#include "machines/model/suspect.h"
#include "optim/cycle/proof_time.h"

namespace camlaw::problems {

using optim::Bounds, optim::Design, optim::Function;

Bounds times(double sign, const Bounds& b) { return sign > 0 ? b : Bounds{-b.upper, -b.lower}; }

HighestKernel::HighestKernel(Function f, std::shared_ptr<const Widened> wide, double sign)
    : f_(std::move(f)),
      wide_(std::move(wide)),
      sign_(sign),
      own_(camlaw::problems::own_inputs(f_, *wide_)) {}

Box HighestKernel::box_at(std::span<const double> u) const {
  Box result = wide_->box;
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (!own_.about[i]) continue;
    result[i].lower += u[*own_.about[i]];
    result[i].upper += u[*own_.about[i]];
  }
  return result;
}

Box HighestKernel::box_over(std::span<const Bounds> u) const {
  Box result = wide_->box;
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (!own_.about[i]) continue;
    result[i].lower += u[*own_.about[i]].lower;
    result[i].upper += u[*own_.about[i]].upper;
  }
  return result;
}

std::vector<double> HighestKernel::own_design(std::span<const double> u) const {
  std::vector<double> x(wide_->first);
  for (std::size_t k = 0; k < own_.behind.size(); ++k) x[own_.variables[k]] = u[k];
  return x;
}

bool HighestKernel::may_be_impossible(std::span<const Bounds> u) const {
  if (!wide_->margins) return false;
  std::vector<double> design;
  for (const Bounds& b : u) {
    if (b.lower != b.upper) return false;
    design.push_back(b.lower);
  }
  return !wide_->machines_at(own_design(design)).all_possible;
}

bool HighestKernel::moves(std::span<const Bounds> u) const {
  return std::any_of(own_.about.begin(), own_.about.end(), [&](const auto& about) {
    return about && u[*about].lower != u[*about].upper;
  });
}

double HighestKernel::value(std::span<const double> u) const {
  const Point p = worst(u);
  return settled(u, p, f_.value(design(u, p)));
}

bool HighestKernel::is_beside_pole(std::span<const double> u, const Point& p) const {
  constexpr double kBeside = 1e-7;  // of a range
  const Box ends = box_at(u);
  Box point, near;
  for (const double value : u) point.push_back({value, value});
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double room = kBeside * (ends[i].upper - ends[i].lower);
    near.push_back({std::max(ends[i].lower, p[i] - room), std::min(ends[i].upper, p[i] + room)});
  }
  const Bounds value = f_.range(widened_box(point, near)).value;
  return !(std::isfinite(value.lower) && std::isfinite(value.upper));
}

double HighestKernel::gradient(std::span<const double> u, std::span<double> g) const {
  std::vector<double> all(f_.inputs().size());
  const Point p = worst(u);
  const double value = settled(u, p, f_.gradient(design(u, p), all));
  for (std::size_t k = 0; k < own_.behind.size(); ++k)
    g[k] = std::isnan(value) ? kNaN : all[own_.behind[k]];
  return value;
}

double HighestKernel::hessian(std::span<const double> u, std::span<double> g,
                              std::span<double> h) const {
  const std::size_t n = f_.inputs().size();
  std::vector<double> all(n), second(optim::packed_size(n));
  const Point p = worst(u);
  const double value = settled(u, p, f_.hessian(design(u, p), all, second));
  if (std::isnan(value)) {
    std::fill(g.begin(), g.end(), kNaN);
    std::fill(h.begin(), h.end(), kNaN);
    return value;
  }
  const auto at = [&](std::size_t i, std::size_t k) -> double& {
    return second[optim::packed(std::max(i, k), std::min(i, k))];
  };
  const Box box = box_at(u);
  // Ranges within which the place lies are eliminated one after the other.
  for (const std::size_t m : own_.moved) {
    const std::size_t range = f_.inputs()[m] - wide_->first;
    const bool inside = p[range] > box[range].lower && p[range] < box[range].upper;
    const double bend = at(m, m);
    if (!inside || bend == 0) continue;
    const std::vector<double> column = [&] {
      std::vector<double> c(n);
      for (std::size_t i = 0; i < n; ++i) c[i] = at(i, m);
      return c;
    }();
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = 0; k <= i; ++k) at(i, k) -= column[i] * column[k] / bend;
    }
  }
  for (std::size_t i = 0; i < own_.behind.size(); ++i) {
    g[i] = all[own_.behind[i]];
    for (std::size_t k = 0; k <= i; ++k)
      h[optim::packed(i, k)] = at(own_.behind[i], own_.behind[k]);
  }
  return value;
}

Bounds HighestKernel::enclose(std::span<const double> u) const {
  Box box;
  for (const double value : u) box.push_back({value, value});
  return range(box).value;
}

std::shared_ptr<const optim::Kernel> HighestKernel::proved() const {
  if (!is_enclosed()) return nullptr;
  return std::make_shared<HighestKernel>(asking_proof());
}

HighestKernel HighestKernel::asking_proof() const {
  HighestKernel result = *this;
  result.asks_proof_ = is_enclosed();
  return result;
}

HighestKernel HighestKernel::looking_along_ranges() const {
  HighestKernel result = *this;
  result.looks_along_ = true;
  return result;
}

Highest HighestKernel::highest_over(std::span<const Bounds> box) const {
  constexpr Division kDivision{.halvings = 14, .parts = 1000};
  const auto over = [&](const Box& ranges) {
    const optim::BoxRange all = f_.range(widened_box(box, ranges));
    OverBox result{times(sign_, all.value), std::vector<Bounds>(ranges.size(), Bounds{0, 0})};
    for (const std::size_t m : own_.moved) {
      result.slopes[f_.inputs()[m] - wide_->first] = times(sign_, all.slopes[m]);
    }
    return result;
  };
  const auto at = [&](const Point& p) {
    Box point;
    for (const double value : p) point.push_back({value, value});
    return times(sign_, f_.range(widened_box(box, point)).value);
  };
  return highest_within(box_over(box), kDivision, at, over);
}

optim::BoxRange HighestKernel::range(std::span<const Bounds> box) const {
  optim::BoxRange result;
  if (may_be_impossible(box)) {
    result.slopes.resize(own_.behind.size());
    return result;
  }
  const Box all = box_over(box);
  Bounds highest = highest_over(box).value;
  if (moves(box)) highest.lower = largest_lower(box);
  result.value = times(sign_, highest);
  const optim::BoxRange whole = f_.range(widened_box(box, all));
  for (const std::size_t k : own_.behind) result.slopes.push_back(whole.slopes[k]);
  return result;
}

/// What the highest value is above at each design of a box: that at the ends of its ranges, and in
/// their middle.
double HighestKernel::largest_lower(std::span<const Bounds> u) const {
  double largest = -optim::kInfinity;
  for (const double share : {0.0, 0.5, 1.0}) {
    Box part = wide_->box;
    for (std::size_t i = 0; i < part.size(); ++i) {
      const double off = wide_->box[i].lower + share * (wide_->box[i].upper - wide_->box[i].lower);
      part[i] = {off, off};
      if (!own_.about[i]) continue;
      part[i] = {u[*own_.about[i]].lower + off, u[*own_.about[i]].upper + off};
    }
    largest = std::max(largest, times(sign_, f_.range(widened_box(u, part)).value).lower);
  }
  return largest;
}

Point HighestKernel::impossible_place(std::span<const double> u) const {
  if (machines_) return machines_->impossible;
  return wide_->margins ? wide_->machines_at(own_design(u)).impossible : Point{};
}

HighestKernel HighestKernel::knowing(std::shared_ptr<const MachinesOfBox> machines) const {
  HighestKernel result = *this;
  result.machines_ = std::move(machines);
  return result;
}

std::string HighestKernel::why_undefined(std::span<const double> u) const {
  std::vector<Point> places = places_of(box_at(u));
  if (Point impossible = impossible_place(u); !impossible.empty())
    places.insert(places.begin(), std::move(impossible));
  for (const Point& p : places) {
    if (std::string why = f_.why_undefined(design(u, p)); !why.empty()) return why;
  }
  return {};
}

Point HighestKernel::searched(std::span<const double> u) const {
  return *recent_->get(u, [&] {
    const auto height = [&](const Point& p) { return sign_ * f_.value(design(u, p)); };
    return climbed_highest(places_of(box_at(u)), height, u);
  });
}

Point HighestKernel::worst(std::span<const double> u) const {
  const auto height = [&](const Point& p) { return sign_ * f_.value(design(u, p)); };
  const Point found = searched(u);
  if (!asks_proof_ || std::isnan(height(found))) return found;
  Box here;
  for (const double value : u) here.push_back({value, value});
  const Highest bounded = highest_over(here);
  const Point suspect = suspect_of(bounded);
  if (!suspect.empty() && std::isnan(height(suspect))) return suspect;
  if (bounded.place.empty() || !(height(bounded.place) > height(found))) return found;
  return climb(bounded.place, u);
}

Box HighestKernel::left(std::span<const double> u) const {
  Box here;
  for (const double value : u) here.push_back({value, value});
  return highest_over(here).left;
}

Point HighestKernel::climbed_highest(const std::vector<Point>& places,
                                     const std::function<double(const Point&)>& value,
                                     std::span<const double> u) const {
  if (const Point impossible = impossible_place(u);
      !impossible.empty() && std::isnan(f_.value(design(u, impossible)))) {
    return impossible;
  }
  const Box box = box_at(u);
  if (optim::ProofTime::is_over()) return tops_of(box, places, value).front();
  const std::vector<Point> tops = [&] {
    if (!looks_along_) return tops_of(box, places, value);
    const auto one = [&](const Point& p, const auto&) { return std::vector{value(p)}; };
    const Heights known = heights_along_ranges(box, places, 1, one).front();
    return tops_of(box, known.places, [&](const Point& p) { return known.at(p); });
  }();
  Point best = climb(tops.front(), u);
  if (tops.size() == 1) return best;
  const auto height = [&](const Point& p) { return sign_ * f_.value(design(u, p)); };
  double highest = height(best);
  for (std::size_t i = 1; i < tops.size() && !std::isnan(highest); ++i) {
    Point other = climb(tops[i], u);
    const double there = height(other);
    if (!(there > highest) && !std::isnan(there)) continue;
    highest = there;
    best = std::move(other);
  }
  return best;
}

double HighestKernel::settled(std::span<const double> u, const Point& p, double value) const {
  constexpr double kSteep = 1e6;  // times another value: what rises so far may have a pole
  if (!f_.is_enclosed()) return value;
  Point corner;
  for (const Bounds& b : box_at(u)) corner.push_back(b.lower);
  const double other = std::abs(f_.value(design(u, corner)));
  if (std::abs(value) <= kSteep * other) return value;
  return is_beside_pole(u, p) ? kNaN : value;
}

double HighestKernel::uphill(const Point& p, std::span<const double> u, Point& slopes) const {
  std::vector<double> all(f_.inputs().size());
  const double value = sign_ * f_.gradient(design(u, p), all);
  slopes.assign(wide_->box.size(), 0.0);
  for (const std::size_t m : own_.moved) slopes[f_.inputs()[m] - wide_->first] = sign_ * all[m];
  return value;
}

Point HighestKernel::climb(const Point& from, std::span<const double> u) const {
  const Box box = box_at(u);
  Point slopes;
  const double here = uphill(from, u, slopes);
  if (std::isnan(here) || is_top(from, box, slopes)) return from;
  if (box.size() == 1) {
    const auto along = [&](double at) {
      Point there;
      const double value = uphill({at}, u, there);
      return Rise{value, there[0]};
    };
    if (const auto top = top_along(from[0], {here, slopes[0]}, box[0], along)) return {*top};
  }
  return climbed(from, box, [&](const Point& p) {
    const std::size_t n = f_.inputs().size();
    std::vector<double> all(n), second(optim::packed_size(n));
    Slopes result{sign_ * f_.hessian(design(u, p), all, second), Point(wide_->box.size()),
                  Point(optim::packed_size(wide_->box.size()))};
    for (const std::size_t m : own_.moved) {
      const std::size_t i = f_.inputs()[m] - wide_->first;
      result.first[i] = sign_ * all[m];
      for (const std::size_t l : own_.moved) {
        const std::size_t k = f_.inputs()[l] - wide_->first;
        if (k > i) continue;
        result.second[optim::packed(i, k)] =
            sign_ * second[optim::packed(std::max(m, l), std::min(m, l))];
      }
    }
    return result;
  });
}

std::vector<double> HighestKernel::design(std::span<const double> u, const Point& p) const {
  std::vector<double> x(wide_->first + p.size());
  for (std::size_t k = 0; k < own_.behind.size(); ++k) x[own_.variables[k]] = u[k];
  std::copy(p.begin(), p.end(), x.begin() + static_cast<std::ptrdiff_t>(wide_->first));
  return x;
}

std::vector<Bounds> HighestKernel::widened_box(std::span<const Bounds> u, const Box& ranges) const {
  std::vector<Bounds> all(wide_->first + ranges.size(), Bounds{0, 0});
  for (std::size_t k = 0; k < own_.behind.size(); ++k) all[own_.variables[k]] = u[k];
  std::copy(ranges.begin(), ranges.end(), all.begin() + static_cast<std::ptrdiff_t>(wide_->first));
  return all;
}

Function highest_of(const Function& f, std::shared_ptr<const Widened> wide, double sign) {
  return function_of_highest(HighestKernel(f, std::move(wide), sign));
}

Function function_of_highest(HighestKernel kernel) {
  std::vector<std::size_t> inputs = kernel.own_inputs();
  return {std::move(inputs), std::make_shared<const HighestKernel>(std::move(kernel))};
}

}  // namespace camlaw::problems
