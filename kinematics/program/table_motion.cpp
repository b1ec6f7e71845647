// SPDX-License-Identifier: MIT
#include "kinematics/program/table_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "kinematics/peaks.h"
#include "kinematics/program/segments.h"
#include "numerics/spline/smoothing_spline.h"

namespace camlaw {
namespace {

constexpr std::size_t kFewest = 8;  // rows that a curve of degree 5 can be told from
constexpr std::size_t kDegree = 5;  // a spline of this degree has a smooth jerk

void check_rows(std::span<const double> x, std::span<const double> s) {
  if (x.size() != s.size() || x.size() < kFewest) {
    throw std::invalid_argument(fmt::format(
        "a motion needs at least {} rows over the cycle; {} are given", kFewest, x.size()));
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    const bool follows = i == 0 ? x[0] >= 0 : x[i] > x[i - 1];
    if (!follows || !(x[i] < 1) || !std::isfinite(s[i])) {
      throw std::invalid_argument(
          "angles must increase within one cycle, each with a displacement");
    }
  }
}

/// Through every row.
Law<double> interpolated(std::span<const double> x, std::span<const double> s) {
  Segment<double> whole{1, s.front(), s.front()};
  whole.joins = true;
  for (std::size_t i = 1; i < x.size(); ++i) whole.points.push_back({x[i] - x[0], s[i]});
  const Law<double> from_first = program_law<double>({whole}).value();
  if (x[0] == 0) return from_first;
  // It begins at the first row: what lies beyond the cycle's end comes first.
  std::vector<Piece<double>> before, after;
  for (const Piece<double>& piece : from_first.pieces()) {
    Piece<double> placed = detail::map_piece(piece, 1.0, -x[0], 1.0, 0.0);
    if (placed.begin < 1) after.push_back(placed);
    if (placed.end <= 1) continue;
    Piece<double> early = detail::map_piece(piece, 1.0, 1 - x[0], 1.0, 0.0);
    early.begin = std::max(early.begin, 0.0);
    after.back().end = std::min(after.back().end, 1.0);
    before.push_back(std::move(early));
  }
  before.insert(before.end(), after.begin(), after.end());
  before.front().begin = 0;
  before.back().end = 1;
  return Law<double>(std::move(before), {End::Motion, End::Motion});
}

/// A spline's pieces. Each meets its neighbours in what both read from one place, so that no
/// rounding is left for a jump.
Law<double> law_of(const optim::SmoothingSpline& spline) {
  const std::vector<double>& places = spline.basis().places();
  std::vector<std::array<double, 3>> states;
  for (const double x : places) states.push_back({spline(x), spline(x, 1), spline(x, 2)});
  states.back() = states.front();
  std::vector<Piece<double>> pieces;
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const double share = places[i + 1] - places[i];
    const auto conditions = [&](const std::array<double, 3>& state) {
      return std::vector<double>{state[0], share * state[1], share * share * state[2]};
    };
    const Law<double> law =
        boundary_polynomial<double>(conditions(states[i]), conditions(states[i + 1]));
    for (auto& piece : detail::pieces_over(law, places[i], share, 0.0, 1.0)) {
      piece.end = places[i + 1];
      pieces.push_back(std::move(piece));
    }
  }
  pieces.back().end = 1;
  return Law<double>(std::move(pieces), {End::Motion, End::Motion});
}

double deviation_of(const optim::SmoothingSpline& spline) {
  double squares = 0;
  for (const auto& sample : spline.samples()) squares += sample.residual * sample.residual;
  return std::sqrt(squares / static_cast<double>(spline.samples().size()));
}

optim::SmoothingSpline smoothed(std::span<const double> x, std::span<const double> s,
                                std::optional<double> mu, std::optional<int> spans = {}) {
  optim::SmoothingOptions options;
  options.degree = static_cast<int>(kDegree);
  options.periodic = true;
  options.range = {0.0, 1.0};
  options.mu = mu;
  options.spans = spans;
  return smoothing_spline(x, s, options);
}

/// The mu with which a spline deviates as stated: deviations grow with it. Where half as many spans
/// as rows cannot come so near, there are as many.
optim::SmoothingSpline with_deviation(std::span<const double> x, std::span<const double> s,
                                      double wanted) {
  double low = -40, high = 5;  // powers of 10
  std::optional<int> spans;
  const auto at = [&](double power) { return smoothed(x, s, std::pow(10.0, power), spans); };
  const auto reaches = [&] { return std::pair(deviation_of(at(low)), deviation_of(at(high))); };
  auto [least, most] = reaches();
  if (least > wanted || most < wanted) {
    spans = static_cast<int>(x.size());
    low = -20;  // enough of it to tell the spline where it has more spans than rows
    std::tie(least, most) = reaches();
  }
  if (least > wanted || most < wanted) {
    throw std::invalid_argument(
        fmt::format("no smoothing spline is exactly that far from the rows; possible distances are "
                    "from {:.3g} to {:.3g} of the table's range",
                    least, most));
  }
  constexpr int kHalvings = 40;  // 45 powers of ten are halved to 1e-10 of one
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (deviation_of(at(middle)) < wanted ? low : high) = middle;
  }
  return at(low);
}

}  // namespace

TableMotion table_motion(std::span<const double> x, std::span<const double> s,
                         const TableSmoothing& smoothing) {
  check_rows(x, s);
  using Kind = TableSmoothing::Kind;
  const Law<double> exact = interpolated(x, s);
  if (smoothing.kind == Kind::None) return {exact};
  const optim::SmoothingSpline spline = smoothing.kind == Kind::Automatic
                                            ? smoothed(x, s, {})
                                            : with_deviation(x, s, smoothing.deviation);
  TableMotion result{law_of(spline), deviation_of(spline)};
  for (const auto& sample : spline.samples()) {
    result.greatest = std::max(result.greatest, std::abs(sample.residual));
  }
  result.acceleration_kept = peaks(result.law).max_acceleration() / peaks(exact).max_acceleration();
  return result;
}

}  // namespace camlaw
