// SPDX-License-Identifier: MIT
#include "machines/model/law_slopes.h"

#include <algorithm>
#include <cmath>

#include "machines/model/linear_law.h"
#include "machines/model/not_a_number.h"

namespace camlaw::problems {
namespace {

using Four = std::array<double, 4>;

/// (R7) The slopes by the coefficients of a polynomial; returns that by t.
double hand_to_polynomial(const std::vector<double>& coefficients, double t, const Four& slopes,
                          std::vector<double>& owed) {
  double by_t = 0;
  // t^k and the powers below it, from t^(k-1) down to t^(k-4).
  std::array<double, 5> powers{1, 0, 0, 0, 0};
  for (std::size_t k = 0; k < coefficients.size(); ++k) {
    double factor = 1, by_own = 0, by_next = 0;
    for (std::size_t m = 0; m <= 4; ++m) {
      const double derivative = factor * powers[m];  // of t^k, the m-th
      if (m < 4) by_own += slopes[m] * derivative;
      if (m > 0) by_next += slopes[m - 1] * derivative;
      factor *= static_cast<double>(k) - static_cast<double>(m);
    }
    owed[k] += by_own;
    by_t += coefficients[k] * by_next;
    for (std::size_t m = 4; m > 0; --m) powers[m] = powers[m - 1];
    powers[0] *= t;
  }
  return by_t;
}

/// (R7) The same by the three numbers of a harmonic.
double hand_to_harmonic(const Harmonic<double>& h, double t, const Four& slopes,
                        Harmonic<double>& owed) {
  const double w = h.frequency, sine = std::sin(w * t), cosine = std::cos(w * t);
  // The m-th derivative is w^m (p sin + q cos), where (p, q) turns by a right angle each time.
  double p = h.sine, q = h.cosine, power = 1, before = 0;  // before: w^(m-1)
  double by_sine_turned = sine, by_cosine_turned = cosine;
  double by_angle = 0;
  for (std::size_t m = 0; m < 4; ++m) {
    owed.sine += slopes[m] * power * by_sine_turned;
    owed.cosine += slopes[m] * power * by_cosine_turned;
    owed.frequency += slopes[m] * static_cast<double>(m) * before * (p * sine + q * cosine);
    by_angle += slopes[m] * power * (p * cosine - q * sine);
    before = power;
    power *= w;
    const double turned = p;
    p = -q, q = turned;
    const double again = by_sine_turned;
    by_sine_turned = by_cosine_turned, by_cosine_turned = -again;
  }
  owed.frequency += by_angle * t;
  return by_angle * w;
}

/// Whether the numbers of a piece are those of the same one in dual numbers. Coefficients that are
/// 0 and do not move may be left out of one of them.
bool same_form(const Piece<double>& piece, const Piece<Dual>& moved) {
  constexpr double kBeside = 1e-12;  // of the law's length: scalars round in orders of their own
  return piece.polynomial.size() == moved.polynomial.size() &&
         piece.harmonics.size() == moved.harmonics.size() &&
         piece.curves.size() == moved.curves.size() &&
         std::abs(piece.origin - moved.origin.a) <= kBeside;
}

}  // namespace

LawSlopes::LawSlopes(const LawBinding& binding, const Law<double>& law,
                     std::span<const double> values)
    : binding_(binding),
      values_(values.begin(), values.end()),
      pieces_(law.pieces()),
      owed_(law.pieces()),
      places_(owed_.size()) {
  for (Piece<double>& piece : owed_) {
    piece.begin = piece.end = piece.origin = 0;
    std::ranges::fill(piece.polynomial, 0);
    std::ranges::fill(piece.harmonics, Harmonic<double>{0, 0, 0});
    piece.curves.clear();
  }
}

void LawSlopes::add_motion(std::size_t piece, double x, const Four& slopes) {
  if (values_.empty()) return;
  const Piece<double>& its = pieces_[piece];
  Piece<double>& owed = owed_[piece];
  const double t = x - its.origin;
  double by_t = hand_to_polynomial(its.polynomial, t, slopes, owed.polynomial);
  for (std::size_t k = 0; k < its.harmonics.size(); ++k) {
    by_t += hand_to_harmonic(its.harmonics[k], t, slopes, owed.harmonics[k]);
  }
  owed.origin -= by_t;
  places_[piece].push_back({x, slopes});
}

void LawSlopes::add_end(PieceEnd end, double slope) {
  Piece<double>& owed = owed_[end.piece];
  (end.is_end ? owed.end : owed.begin) += slope;
}

std::array<double, kDualWidth> LawSlopes::of_piece(std::size_t piece,
                                                   const Piece<Dual>& moved) const {
  std::array<double, kDualWidth> sum{};
  const Piece<double>& owed = owed_[piece];
  const auto add = [&](double slope, const Dual& number) {
    for (std::size_t lane = 0; lane < sum.size(); ++lane) {
      sum[lane] += slope * number.v[static_cast<int>(lane)];
    }
  };
  add(owed.begin, moved.begin);
  add(owed.end, moved.end);
  const auto add_places = [&](const Piece<Dual>& its) {
    for (const Place& place : places_[piece]) {
      const auto motion = derivatives<4>(its, place.x);
      for (std::size_t m = 0; m < 4; ++m) add(place.slopes[m], motion[m]);
    }
  };
  if (!same_form(pieces_[piece], moved)) {
    add_places(moved);
    return sum;
  }
  add(owed.origin, moved.origin);
  for (std::size_t k = 0; k < owed.polynomial.size(); ++k) {
    add(owed.polynomial[k], moved.polynomial[k]);
  }
  for (std::size_t k = 0; k < owed.harmonics.size(); ++k) {
    add(owed.harmonics[k].sine, moved.harmonics[k].sine);
    add(owed.harmonics[k].cosine, moved.harmonics[k].cosine);
    add(owed.harmonics[k].frequency, moved.harmonics[k].frequency);
  }
  if (!moved.curves.empty()) {
    add_places({moved.begin, moved.end, moved.origin, {}, {}, moved.curves});
  }
  return sum;
}

void LawSlopes::add_to(std::span<double> slopes) const {
  if (values_.empty()) return;
  if (const LinearLaw* linear = binding_.linear_law();
      linear != nullptr && linear->parts.size() == owed_.size()) {
    for (std::size_t p = 0; p < owed_.size(); ++p) {
      for (const LinearLaw::Part& part : linear->parts[p]) {
        const auto sum = of_piece(p, part.piece);
        for (std::size_t k = 0; k < part.count; ++k) slopes[part.inputs[k]] += sum[k];
      }
    }
    return;
  }
  const std::vector<Law<Dual>> laws = binding_.first_laws(values_);
  if (laws.empty()) std::ranges::fill(slopes, kNaN);
  for (std::size_t block = 0; block < laws.size(); ++block) {
    const std::size_t first = block * kDualWidth;
    for (std::size_t p = 0; p < owed_.size(); ++p) {
      const auto sum = of_piece(p, laws[block].pieces()[p]);
      for (std::size_t i = first; i < std::min(first + kDualWidth, slopes.size()); ++i) {
        slopes[i] += sum[i - first];
      }
    }
  }
}

}  // namespace camlaw::problems
