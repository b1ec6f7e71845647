// SPDX-License-Identifier: MIT
#include "kinematics/expansion.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "kinematics/laws/catalogue.h"

namespace camlaw::expansion_test {
namespace {

constexpr std::size_t kOrders = Expansion::kOrders;
using Exact = long double;  // 11 bits more than the numbers under test

/// The derivatives of a piece without curves by falling powers and by phase shifts of sine.
std::array<Exact, kOrders> plain_derivatives(const Piece<double>& piece, Exact x) {
  std::array<Exact, kOrders> d{};
  const Exact t = x - Exact(piece.origin);
  for (std::size_t k = 0; k < kOrders; ++k) {
    for (std::size_t i = k; i < piece.polynomial.size(); ++i) {
      Exact term = piece.polynomial[i];
      for (std::size_t f = 0; f < k; ++f) term *= static_cast<Exact>(i - f);
      d[k] += term * std::pow(t, static_cast<Exact>(i - k));
    }
    for (const auto& h : piece.harmonics) {
      const Exact w = h.frequency, phase = w * t + static_cast<Exact>(k) * std::acos(Exact(0));
      d[k] += std::pow(w, static_cast<Exact>(k)) *
              (h.sine * std::sin(phase) + h.cosine * std::cos(phase));
    }
  }
  return d;
}

/// How large the terms of the k-th derivative are: rounding is relative to this.
Exact size_of_terms(const Piece<double>& piece, std::size_t k) {
  Piece<double> all = piece;
  for (double& c : all.polynomial) c = std::abs(c);
  Exact size = 0;
  for (const auto& h : piece.harmonics) {
    size += (std::abs(h.sine) + std::abs(h.cosine)) * std::pow(h.frequency, Exact(k));
  }
  all.harmonics.clear();
  return size + std::abs(plain_derivatives(all, 1 + std::abs(all.origin))[k]);
}

bool contains(const Interval& range, Exact value) {
  return Exact(range.lower()) <= value && value <= Exact(range.upper());
}

std::vector<Law<double>> data_laws() {
  std::vector<Law<double>> laws;
  for (const Family& family : catalogue()) {
    const Law<double> law = family.make(family.defaults());
    if (law.is_data()) laws.push_back(law);
  }
  laws.push_back(find_law("legendre c=40,-20,10,5,-3,2,1,0.5").law());
  laws.push_back(find_law("fourier a=0.3,-0.2,0.1,0.05,0.7").law());
  return laws;
}

}  // namespace

TEST_CASE("an expansion encloses the piece over its stretch and at the middle", "[expansion]") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (const Law<double>& law : data_laws()) {
    for (const auto& piece : law.pieces()) {
      const PieceExpander expander(piece_as<Interval>(piece));
      for (const double width : {0.0, 1e-9, 1e-3, 0.1, 1.0}) {
        const double begin = std::lerp(piece.begin, piece.end, uniform(random));
        const Interval x(begin, std::min(1.0, begin + width));
        const Expansion e = expander(x);
        for (int i = 0; i <= 20; ++i) {
          const Exact at = x.lower() + (Exact(x.upper()) - x.lower()) * i / 20;
          const auto d = plain_derivatives(piece, at);
          for (std::size_t k = 0; k < kOrders; ++k) REQUIRE(contains(e.over[k], d[k]));
        }
        const auto middle = plain_derivatives(piece, e.middle);
        for (std::size_t k = 0; k < kOrders; ++k) {
          REQUIRE(contains(e.at[k], middle[k]));
          REQUIRE(boost::numeric::width(e.at[k]) <= 2e-14L * size_of_terms(piece, k) + 1e-290L);
        }
      }
    }
  }
}

TEST_CASE("an expansion holds for every coefficient within the intervals", "[expansion]") {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto wide = [&](double value, double by) { return Interval(value - by, value + by); };
  const auto some = [&](const Interval& range) {
    return std::clamp(std::lerp(range.lower(), range.upper(), (uniform(random) + 1) / 2),
                      range.lower(), range.upper());
  };
  for (const double by : {1e-15, 1e-6, 1e-2}) {
    Piece<Interval> piece{Interval(0.0), Interval(1.0), wide(0.3, by), {}, {}, {}};
    for (int i = 0; i < 8; ++i) piece.polynomial.push_back(wide(3 * uniform(random), by));
    piece.harmonics.push_back({wide(0.7, by), wide(-0.4, by), wide(9.1, by)});
    const PieceExpander expander(piece);
    for (int trial = 0; trial < 300; ++trial) {
      Piece<double> one{0, 1, some(piece.origin), {}, {}, {}};
      for (const Interval& c : piece.polynomial) one.polynomial.push_back(some(c));
      const auto& h = piece.harmonics.front();
      one.harmonics.push_back({some(h.sine), some(h.cosine), some(h.frequency)});
      const double begin = (uniform(random) + 1) / 2;
      const Expansion e = expander(Interval(begin, begin + 0.01));
      const auto d = plain_derivatives(one, begin + 0.005L * (1 + uniform(random)));
      for (std::size_t k = 0; k < kOrders; ++k) REQUIRE(contains(e.over[k], d[k]));
    }
  }
}

TEST_CASE("bounds close on the range as the square of the stretch", "[expansion]") {
  for (const char* name : {"poly-4-5-6-7", "cycloidal", "modified-sine"}) {
    INFO(name);
    const Law<double> law = find_law(name).law();
    const auto& piece = law.pieces().front();
    const PieceExpander expander(piece_as<Interval>(piece));
    const auto excess = [&](double width) {  // of s' over what its ends span
      const double begin = 0.4 * piece.end;
      const Expansion e = expander(Interval(begin, begin + width));
      const auto low = plain_derivatives(piece, begin),
                 high = plain_derivatives(piece, begin + width);
      return static_cast<double>(boost::numeric::width(e.over[1]) - std::abs(high[1] - low[1]));
    };
    for (const double width : {0.04, 0.02, 0.01}) {
      CHECK(excess(width) >= 0);
      CHECK(excess(width / 2) <= 0.3 * excess(width) + 1e-13);
    }
  }
}

TEST_CASE("pieces with curves, and polynomials of many terms, are enclosed too", "[expansion]") {
  for (const char* name : {"elliptic n=1.1", "inclined-sinusoid", "stoddart exponents=3,4.5,20"}) {
    INFO(name);
    const Law<double> law = find_law(name).law();
    const Law<Interval> exact = find_law(name).law<Interval>();
    const PieceExpander expander(exact.pieces().front());
    const Expansion e = expander(Interval(0.3, 0.31));
    for (int i = 0; i <= 10; ++i) {
      const double x = std::min(0.31, 0.3 + 0.001 * i);
      const auto d = law.derivatives<kOrders>(x);
      const auto tight = exact.derivatives<kOrders>(Interval(x));
      for (std::size_t k = 0; k < kOrders; ++k) {
        CHECK(d[k] == Approx(boost::numeric::median(tight[k])).margin(1e-6));
        CHECK(boost::numeric::overlap(tight[k], e.over[k]));
      }
    }
  }
  Piece<double> many{0, 1, 0.5, std::vector<double>(30, 0.1), {}, {}};
  const Expansion e = PieceExpander(piece_as<Interval>(many))(Interval(0.8, 0.9));
  for (int i = 0; i <= 10; ++i) {
    const auto d = plain_derivatives(many, 0.8L + 0.01L * i);
    for (std::size_t k = 0; k < kOrders; ++k) CHECK(contains(e.over[k], d[k]));
  }
}

}  // namespace camlaw::expansion_test
