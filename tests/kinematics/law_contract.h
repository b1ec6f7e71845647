// SPDX-License-Identifier: MIT
#pragma once

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <catch2/catch.hpp>
#include <random>
#include <set>

#include "kinematics/laws/catalogue.h"
#include "numerics/scalar/dual.h"
#include "tests/kinematics/reference_data.h"

/// The contract of a motion law, checked by one call: check_law(family, arguments, expected).
namespace camlaw::testing {

using Values = std::array<double, 4>;  // s, v, a, j

/// The largest error seen and where; a NaN stays.
struct Worst {
  double error = 0, x = 0;
  void see(double e, double at) {
    if (!std::isnan(error) && !(e <= error)) error = e, x = at;
  }
};

inline void expect_within(const char* what, const Worst& worst, double tolerance) {
  INFO(what << ", worst at x = " << worst.x);
  CHECK(worst.error <= tolerance);
}

/// Largest finite size of s, v, a, j; at least 1, which unit strokes reach in s and v.
inline Values scales(const Law<double>& law) {
  Values result{1, 1, 1, 1};
  for (int i = 0; i <= 400; ++i) {
    const Values d = law.derivatives<4>(i / 400.0);
    for (std::size_t k = 0; k < 4; ++k) {
      if (std::isfinite(d[k])) result[k] = std::max(result[k], std::abs(d[k]));
    }
  }
  return result;
}

/// A point inside a piece and its distance to the piece's nearer end.
struct Place {
  double x, room;
  const Piece<double>* piece;
};

/// Points inside every piece, no nearer to its ends than 1/20 of it.
inline std::vector<Place> places(const Law<double>& law, int per_piece) {
  std::mt19937 random(12345);
  std::uniform_real_distribution<double> share(0.05, 0.95);
  std::vector<Place> result;
  for (const auto& piece : law.pieces()) {
    for (int i = 0; i < per_piece; ++i) {
      const double x = std::lerp(piece.begin, piece.end, share(random));
      result.push_back({x, std::min(x - piece.begin, piece.end - x), &piece});
    }
  }
  return result;
}

/// Romberg's extrapolation of d(h), d(h/2), ..., whose error runs in powers of h^order.
template <std::size_t N, class F>
std::array<double, N> extrapolated(const F& difference, double h, int levels, int order) {
  std::vector<std::array<double, N>> row;
  for (int i = 0; i < levels; ++i) row.push_back(difference(std::ldexp(h, -i)));
  for (int step = 1; step < levels; ++step) {
    const double factor = std::ldexp(1.0, order * step);
    for (std::size_t i = 0; i + static_cast<std::size_t>(step) < row.size(); ++i) {
      for (std::size_t k = 0; k < N; ++k) {
        row[i][k] = (factor * row[i + 1][k] - row[i][k]) / (factor - 1);
      }
    }
  }
  return row.front();
}

inline void check_pieces(const Law<double>& law) {
  const auto& pieces = law.pieces();
  CHECK(pieces.front().begin == 0);
  CHECK(pieces.back().end == 1);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    CHECK(pieces[i].begin < pieces[i].end);
    if (i > 0) CHECK(std::abs(pieces[i].begin - pieces[i - 1].end) <= 1e-15);
  }
}

inline void check_ends(const Law<double>& law, const Expected& expected) {
  CHECK(to_string(law.ends()) == expected.ends);
  const Values size = scales(law);
  const auto check_end = [&](double x, Side side, End kind, double displacement) {
    INFO("at the end x = " << x);
    const Values d = law.derivatives<4>(x, side);
    CHECK(std::abs(d[0] - displacement) <= 1e-14);
    // The end's own equations in rounded coefficients: a few roundings of the largest value.
    const bool still = kind == End::Rest || kind == End::Reversal;
    const bool steady = kind == End::Velocity || (kind == End::Rest && expected.continuity >= 2);
    if (still) CHECK(std::abs(d[1]) <= 1e-13 * size[1]);
    if (steady) CHECK(std::abs(d[2]) <= 1e-12 * size[2]);
  };
  check_end(0, Side::Right, law.ends().begin, expected.begin);
  check_end(1, Side::Left, law.ends().end, expected.end);
}

inline void check_shape(const Law<double>& law, const Expected& expected) {
  CHECK(continuity(law) == expected.continuity);
  CHECK(is_symmetric(law) == expected.symmetric);
}

/// Limits at breaks: each side is its own piece, and they agree up to the law's class.
inline void check_sides(const Law<double>& law, const Expected& expected) {
  const Values size = scales(law);
  const auto& pieces = law.pieces();
  for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
    const double x = pieces[i].end;
    INFO("at the break x = " << x);
    const Values left = law.derivatives<4>(x, Side::Left);
    const Values right = law.derivatives<4>(x, Side::Right);
    CHECK(law.piece_at(x, Side::Left) == i);
    CHECK(law.piece_at(x, Side::Right) == i + 1);
    CHECK(left == derivatives<4>(pieces[i], x));
    CHECK(right == derivatives<4>(pieces[i + 1], x));
    for (std::size_t k = 0; k < 4 && static_cast<int>(k) <= expected.continuity; ++k) {
      CHECK(std::abs(left[k] - right[k]) <= 1e-11 * size[k]);
    }
  }
}

/// A step against which the piece runs slowly: three central differences leave h^6 f^(7) / (64 7!),
/// for sin(w x) with w h = 0.1 a part 3e-12 of f'. Half-ellipses, powers and the like have
/// singular points, some beside the stretch, and take a step short against the distance to them.
inline double difference_step(const Place& place) {
  const double width = place.piece->end - place.piece->begin;
  if (!place.piece->is_data()) return std::min(width / 400, place.room / 32);
  double fastest = static_cast<double>(place.piece->polynomial.size()) / width;
  for (const auto& h : place.piece->harmonics) fastest = std::max(fastest, std::abs(h.frequency));
  return std::min(0.1 / fastest, place.room / 2);
}

/// v, a, j against differences of s, v, a. Rounding leaves about 1e-16 / h of the lower derivative.
inline void check_differences(const Law<double>& law) {
  const Values size = scales(law);
  Worst worst;
  for (const Place& place : places(law, 6)) {
    const auto central = [&](double h) {
      const Values up = law.derivatives<4>(place.x + h), down = law.derivatives<4>(place.x - h);
      return Values{(up[0] - down[0]) / (2 * h), (up[1] - down[1]) / (2 * h),
                    (up[2] - down[2]) / (2 * h), 0};
    };
    const Values slope = extrapolated<4>(central, difference_step(place), 3, 2);
    const Values d = law.derivatives<4>(place.x);
    for (std::size_t k = 0; k < 3; ++k) {
      worst.see(std::abs(slope[k] - d[k + 1]) / std::max(size[k], size[k + 1]), place.x);
    }
  }
  expect_within("differences of s, v, a", worst, 1e-10);
}

inline void check_dual_argument(const Law<double>& law) {
  const Values size = scales(law);
  Worst worst;
  for (const Place& place : places(law, 6)) {
    const Values d = law.derivatives<4>(place.x);
    const auto dual = law.derivatives<4>(Dual(place.x, 1));
    for (std::size_t k = 0; k < 4; ++k) {
      worst.see(std::abs(dual[k].a - d[k]) / size[k], place.x);
      if (k < 3) worst.see(std::abs(dual[k].v[1] - d[k + 1]) / size[k + 1], place.x);
      for (const int other : {0, 2, 3}) worst.see(std::abs(dual[k].v[other]), place.x);
    }
  }
  expect_within("derivatives through Dual x", worst, 1e-13);
}

/// Every sample of a box lies in the enclosure over it. The slack is for the rounding of the
/// sample.
inline void check_intervals(const Law<double>& law, const Law<Interval>& proved) {
  const Values size = scales(law);
  std::mt19937 random(54321);
  std::uniform_real_distribution<double> uniform(0, 1);
  Worst outside;
  for (int i = 0; i < 24; ++i) {
    const double width = std::pow(10.0, -4 * uniform(random));
    const double low = (1 - width) * uniform(random);
    const Interval box(low, low + width);
    const auto of_plain = law.derivatives<4>(box), of_proved = proved.derivatives<4>(box);
    for (int n = 0; n <= 8; ++n) {
      const double x = std::min(box.upper(), std::lerp(box.lower(), box.upper(), n / 8.0));
      for (const Side side : {Side::Left, Side::Right}) {
        const Values d = law.derivatives<4>(x, side);
        for (std::size_t k = 0; k < 4; ++k) {
          if (!std::isfinite(d[k])) continue;
          for (const Interval& hull : {of_plain[k], of_proved[k]}) {
            const bool empty = !(hull.lower() <= hull.upper());
            outside.see(empty ? 1 : (hull.lower() - d[k]) / size[k], x);
            outside.see(empty ? 1 : (d[k] - hull.upper()) / size[k], x);
          }
        }
      }
    }
  }
  expect_within("samples outside their enclosure", outside, 1e-13);
  Worst wide;  // an enclosure of everything would pass the above
  for (const Place& place : places(law, 4)) {
    const auto d = proved.derivatives<4>(Interval(place.x));
    for (std::size_t k = 0; k < 4; ++k) wide.see(width(d[k]) / size[k], place.x);
  }
  expect_within("width of enclosures at points", wide, 1e-10);
}

/// s against the quadrature of v, piece by piece: tanh-sinh where an end may be singular.
inline void check_integral(const Law<double>& law) {
  using boost::math::quadrature::gauss_kronrod;
  static boost::math::quadrature::tanh_sinh<double> tanh_sinh;
  Worst worst;
  for (const auto& piece : law.pieces()) {
    const auto velocity = [&](double x) { return derivatives<2>(piece, x)[1]; };
    for (const double share : {0.37, 1.0}) {
      const double end = std::lerp(piece.begin, piece.end, share);
      const double risen =
          law.derivatives<1>(end, Side::Left)[0] - law.derivatives<1>(piece.begin, Side::Right)[0];
      const double area = piece.is_data() ? gauss_kronrod<double, 31>::integrate(
                                                velocity, piece.begin, end, 6, 1e-13)
                                          : tanh_sinh.integrate(velocity, piece.begin, end, 1e-13);
      worst.see(std::abs(area - risen), end);
    }
  }
  expect_within("s against the integral of v", worst, 1e-11);
}

/// The law with one value moved; nothing where the family does not take it.
inline std::optional<Law<double>> moved(const Family& family, Arguments<double> arguments,
                                        std::size_t parameter, std::size_t index, double step) {
  arguments.values()[parameter][index] += step;
  try {
    return family.make(arguments);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

/// s, v, a by one parameter through Dual, against differences in the parameter: central ones, or
/// one-sided where the value lies on the edge of what makes a law; false where it cannot move.
inline bool check_parameter(const Family& family, const Arguments<double>& arguments,
                            std::size_t parameter, std::size_t index) {
  const Law<double> law = family.make(arguments);
  auto seeded = arguments.as<Dual>();
  seeded.values()[parameter][index].v[2] = 1;
  const Law<Dual> dual = family.make(seeded);
  double narrowest = 1;
  for (const auto& p : law.pieces()) narrowest = std::min(narrowest, p.end - p.begin);
  // Breaks that move with the parameter must not pass the points looked at.
  const double value = arguments.list(parameter)[index];
  double h = std::min(1e-3 * std::max(1.0, std::abs(value)), 0.02 * narrowest);
  const bool above = moved(family, arguments, parameter, index, h).has_value();
  const bool below = moved(family, arguments, parameter, index, -h).has_value();
  if (!above && !below) return false;
  if (!above) h = -h;
  const bool central = above && below;
  const int levels = central ? 3 : 5;
  std::vector<Law<double>> up, down;
  for (int i = 0; i < levels; ++i) {
    up.push_back(*moved(family, arguments, parameter, index, std::ldexp(h, -i)));
    down.push_back(central ? *moved(family, arguments, parameter, index, -std::ldexp(h, -i)) : law);
  }
  const Values size = scales(law);
  Worst values, slopes;
  for (const auto& piece : law.pieces()) {
    for (const double share : {0.23, 0.57, 0.81}) {  // not the middle, where crossovers move
      const double x = std::lerp(piece.begin, piece.end, share);
      const Values plain = law.derivatives<4>(x);
      const auto d = dual.derivatives<4>(x);
      const auto difference = [&](double step) {
        const auto level = static_cast<std::size_t>(std::lround(std::log2(h / step)));
        const Values a = up[level].derivatives<4>(x), b = down[level].derivatives<4>(x);
        Values result;
        for (std::size_t k = 0; k < 4; ++k) result[k] = (a[k] - b[k]) / (central ? 2 * step : step);
        return result;
      };
      const Values slope = extrapolated<4>(difference, h, levels, central ? 2 : 1);
      for (std::size_t k = 0; k < 3; ++k) {
        values.see(std::abs(d[k].a - plain[k]) / size[k], x);
        slopes.see(std::abs(d[k].v[2] - slope[k]) / std::max(size[k], std::abs(slope[k])), x);
      }
    }
  }
  INFO("parameter " << family.parameters[parameter].name << "[" << index << "] = " << value);
  expect_within("values of the Dual law", values, 1e-13);
  // At 0.5 the crossover of an asymmetric law is left where it is; beside 0.5 it is moved.
  const bool jumps = family.parameters[parameter].name == "crossover" && value == 0.5;
  if (jumps && !is_symmetric(law)) return true;
  // Rounding: 1e-16 / 5e-6, the shortest step, at worst.
  expect_within("derivatives by the parameter", slopes, central ? 1e-9 : 1e-8);
  return true;
}

/// Every parameter at these values; the names of those that could be moved.
inline std::set<std::string> check_parameters(const Family& family,
                                              const Arguments<double>& arguments) {
  std::set<std::string> checked;
  for (std::size_t p = 0; p < family.parameters.size(); ++p) {
    if (family.parameters[p].structural) continue;
    const auto& list = arguments.list(p);
    for (std::size_t i = 0; i < list.size(); ++i) {
      // Of a repeated knot no copy can move past the others.
      const bool repeated =
          (i > 0 && list[i - 1] == list[i]) || (i + 1 < list.size() && list[i + 1] == list[i]);
      if (family.parameters[p].name == "knots" && repeated) continue;
      if (check_parameter(family, arguments, p, i)) checked.insert(family.parameters[p].name);
    }
  }
  return checked;
}

/// Scales of s, v, a, j by their terms: what rounding is relative to where large terms cancel.
inline Values term_sizes(const Law<double>& law) {
  Values result = scales(law);
  for (const auto& piece : law.pieces()) {
    Piece<double> all = piece;  // all terms add up at the far end of this one
    all.harmonics.clear(), all.curves.clear();
    for (double& c : all.polynomial) c = std::abs(c);
    const double reach = std::max(piece.end - piece.origin, piece.origin - piece.begin);
    const Values d = derivatives<4>(all, piece.origin + reach);
    for (std::size_t k = 0; k < 4; ++k) result[k] = std::max(result[k], d[k]);
  }
  return result;
}

/// The fast way through many points against the plain one.
inline void check_spans(const Law<double>& law) {
  std::mt19937 random(777);
  std::uniform_real_distribution<double> uniform(-0.1, 1.1);
  std::vector<double> x;
  for (int i = 0; i <= 1200; ++i) x.push_back(i / 1200.0);  // sorted, in long runs
  for (int i = 0; i < 200; ++i) x.push_back(uniform(random));
  for (const auto& piece : law.pieces()) {
    x.insert(x.end(), {piece.end, piece.begin, std::nextafter(piece.end, 0.0),
                       std::nextafter(piece.begin, 1.0)});
  }
  x.insert(x.end(), {std::nan(""), -0.0, 1.0, std::nextafter(1.0, 2.0), -1e-300, 0.5,
                     std::numeric_limits<double>::infinity()});
  std::array<std::vector<double>, 4> curves;
  for (auto& curve : curves) curve.resize(x.size());
  evaluate(law, x, {curves[0], curves[1], curves[2], curves[3]});
  const Values size = term_sizes(law);
  Worst worst;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Values d = law.derivatives<4>(x[i]);
    for (std::size_t k = 0; k < 4; ++k) {
      const double fast = curves[k][i];
      const bool same = fast == d[k] || (std::isnan(fast) && std::isnan(d[k]));
      worst.see(same ? 0 : std::abs(fast - d[k]) / size[k], x[i]);
      if (!(x[i] >= 0 && x[i] <= 1)) CHECK(std::isnan(fast));
    }
  }
  expect_within("many points at once", worst, 1e-14);
  std::vector<double> alone(x.size());
  evaluate(law, x, {.s = {}, .v = {}, .a = alone, .j = {}});
  CHECK(std::equal(alone.begin(), alone.end(), curves[2].begin(),
                   [](double p, double q) { return p == q || (std::isnan(p) && std::isnan(q)); }));
}

/// All of the contract for one member of a family.
inline void check_law(const Family& family, const Arguments<double>& arguments,
                      const Expected& expected) {
  const Law<double> law = family.make(arguments);
  check_pieces(law);
  check_ends(law, expected);
  check_shape(law, expected);
  check_sides(law, expected);
  check_differences(law);
  check_dual_argument(law);
  check_intervals(law, family.make(arguments.as<Interval>()));
  check_integral(law);
  check_parameters(family, arguments);
  check_spans(law);
}

}  // namespace camlaw::testing
