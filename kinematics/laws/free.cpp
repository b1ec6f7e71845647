// SPDX-License-Identifier: MIT
#include "kinematics/laws/free.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "kinematics/laws/spline.h"
#include "numerics/scalar/dual.h"

namespace camlaw {
namespace {

constexpr int kMostDegree = 25;           // as b-spline takes
constexpr double kMostCoefficient = 100;  // as b-spline takes

[[noreturn]] void refuse(const std::string& why) { throw std::invalid_argument(why); }

int repeats(const FreeLaw& shape) { return shape.degree - shape.continuity; }

std::size_t coefficients(const FreeLaw& shape) {
  return static_cast<std::size_t>(shape.degree + 1) +
         shape.knots.size() * static_cast<std::size_t>(repeats(shape));
}

/// Coefficients from the end inwards that the end has a say in.
std::size_t reach(const FreeEnd& end) {
  return end.straight ? 3 : static_cast<std::size_t>(end.vanishing) + 1;
}

/// Whether an end decides the i-th coefficient from it: those before s^(k) vanish, or the third
/// where s'' does.
bool decides(const FreeEnd& end, std::size_t i) {
  return end.straight ? i == 0 || i == 2 : i < reach(end);
}

/// Of a symmetric law, how many knots stand below 1/2; else all.
std::size_t own_knots(const FreeLaw& shape) {
  return shape.symmetric ? shape.knots.size() / 2 : shape.knots.size();
}

/// Indexes of the spline's coefficients that are parameters.
std::vector<std::size_t> free_coefficients(const FreeLaw& shape) {
  const std::size_t count = coefficients(shape);
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < (shape.symmetric ? count / 2 : count); ++i) {
    const bool decided = decides(shape.begin, i) || decides(shape.end, count - 1 - i);
    if (!decided) result.push_back(i);
  }
  return result;
}

void check_knots(const FreeLaw& shape) {
  // 1 - x rounds by less, and what is written with ten digits is meant as it stands.
  constexpr double kKnotRounding = 1e-12;
  const auto& knots = shape.knots;
  for (std::size_t i = 0; i < knots.size(); ++i) {
    if (!(knots[i] > 0 && knots[i] < 1)) {
      refuse(fmt::format("knots: {:.6g} is not strictly between 0 and 1", knots[i]));
    }
    if (i > 0 && !(knots[i] > knots[i - 1])) {
      refuse(fmt::format("knots: {:.6g} does not come after {:.6g}", knots[i], knots[i - 1]));
    }
    const double mirrored = 1 - knots[knots.size() - 1 - i];
    if (shape.symmetric && std::abs(knots[i] - mirrored) > kKnotRounding) {
      refuse(fmt::format("knots: a symmetric law has one at {:.6g} too", 1 - knots[i]));
    }
  }
}

void check_end(const FreeLaw& shape, const FreeEnd& end, const char* name) {
  if (end.vanishing < 0 || end.vanishing >= shape.degree || (end.straight && shape.degree < 2)) {
    refuse(fmt::format("{}: {} cannot be 0 there: of a law of degree {} at most the first {} can",
                       name, end.straight ? "s''" : fmt::format("{} derivatives", end.vanishing),
                       shape.degree, shape.degree - 1));
  }
}

void check(const FreeLaw& shape) {
  if (shape.degree < 1 || shape.degree > kMostDegree) {
    refuse(fmt::format("degree: {} is outside 1 .. {}", shape.degree, kMostDegree));
  }
  if (shape.continuity < 0 || shape.continuity >= shape.degree) {
    refuse(fmt::format("continuity: {} is outside 0 .. {}, which degree {} allows",
                       shape.continuity, shape.degree - 1, shape.degree));
  }
  check_knots(shape);
  check_end(shape, shape.begin, "begin");
  check_end(shape, shape.end, "end");
  if (shape.symmetric && shape.begin != shape.end) {
    refuse("symmetric: the ends are not alike");
  }
  if (reach(shape.begin) + reach(shape.end) > coefficients(shape) ||
      free_coefficients(shape).empty()) {
    refuse(
        fmt::format("nothing is free: the ends{} determine all {} coefficients; a higher degree or "
                    "more knots give more",
                    shape.symmetric ? " and the symmetry" : "", coefficients(shape)));
  }
}

/// Interior knots, each as often as the continuity asks, for those that are parameters.
template <class T>
std::vector<T> repeated_knots(const FreeLaw& shape, const std::vector<T>& own) {
  std::vector<T> places;
  const std::size_t count = shape.knots.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (!shape.moving_knots || (shape.symmetric && 2 * i + 1 == count)) {
      places.push_back(number<T>(shape.knots[i]));
    } else {
      places.push_back(i < own.size() ? own[i] : number<T>(1) - own[count - 1 - i]);
    }
  }
  std::vector<T> result;
  for (const T& place : places) {
    result.insert(result.end(), static_cast<std::size_t>(repeats(shape)), place);
  }
  return result;
}

/// The ratio (c2 - c1) / (c1 - c0) at which s'' vanishes at the first of clamped knots.
template <class T>
T straight_ratio(int degree, const std::vector<T>& knots) {
  const auto p = static_cast<std::size_t>(degree);
  return (knots[p + 2] - knots[2]) / (knots[p + 1] - knots[1]);
}

/// The clamped knots seen from the other end.
template <class T>
std::vector<T> mirrored(const std::vector<T>& knots) {
  std::vector<T> result;
  for (std::size_t i = knots.size(); i-- > 0;) result.push_back(number<T>(1) - knots[i]);
  return result;
}

/// All coefficients of the spline, from those that are parameters.
template <class T>
std::vector<T> all_coefficients(const FreeLaw& shape, const std::vector<T>& own,
                                const std::vector<T>& interior) {
  const std::size_t count = coefficients(shape);
  const T zero = number<T>(0), one = number<T>(1);
  std::vector<T> c(count, zero);
  for (std::size_t i = 0; i < reach(shape.end); ++i) c[count - 1 - i] = one;
  const auto free = free_coefficients(shape);
  for (std::size_t k = 0; k < free.size(); ++k) c[free[k]] = own[k];
  const std::vector<T> knots = detail::clamped(shape.degree, interior);
  if (shape.begin.straight) c[2] = c[1] + c[1] * straight_ratio(shape.degree, knots);
  if (shape.symmetric) {
    for (std::size_t i = 0; i < count / 2; ++i) c[count - 1 - i] = one - c[i];
    if (count % 2 == 1) c[count / 2] = number<T>(0.5);
  } else if (shape.end.straight) {
    const T ratio = straight_ratio(shape.degree, mirrored(knots));
    c[count - 3] = c[count - 2] - (one - c[count - 2]) * ratio;
  }
  return c;
}

/// Where there are not as many values as parameters.
std::optional<Impossible> bad_count(const char* name, std::size_t given, std::size_t wanted) {
  if (given == wanted) return {};
  return Impossible{fmt::format("{}: {} given, but {} are needed", name, given, wanted)};
}

/// Interior knots and coefficients.
template <class T>
Possible<std::pair<std::vector<T>, std::vector<T>>> spline_of(const FreeLaw& shape,
                                                              const Arguments<T>& arguments) {
  const std::vector<T> none;
  const std::vector<T>& own = shape.moving_knots ? arguments.list(1) : none;
  auto fault = bad_count("coefficients", arguments.list(0).size(), free_coefficients(shape).size());
  if (!fault && shape.moving_knots) fault = bad_count("knots", own.size(), own_knots(shape));
  if (fault) return std::move(*fault);
  std::vector<T> knots = repeated_knots(shape, own);
  std::vector<T> all = all_coefficients(shape, arguments.list(0), knots);
  return std::pair(std::move(knots), std::move(all));
}

/// The member of the catalogue's family.
Member as_b_spline(const FreeLaw& shape, const Arguments<double>& arguments) {
  const auto [knots, coefficients] = spline_of(shape, arguments).value();
  const Family& family = find_family("b-spline");
  Member result{&family, family.defaults()};
  auto& values = result.arguments.values();
  values[family.parameter("degree")] = {static_cast<double>(shape.degree)};
  values[family.parameter("knots")] = knots;
  values[family.parameter("coefficients")] = coefficients;
  return result;
}

/// The knots that are parameters, where they are stated.
std::vector<double> knot_arguments(const FreeLaw& shape) {
  const std::size_t count = shape.moving_knots ? own_knots(shape) : 0;
  return {shape.knots.begin(), shape.knots.begin() + static_cast<std::ptrdiff_t>(count)};
}

/// `start` at the means of each `degree` neighbouring knots.
std::vector<double> starting_coefficients(const FreeLaw& shape, const Law<double>& start) {
  const auto knots = detail::clamped(shape.degree, repeated_knots(shape, knot_arguments(shape)));
  std::vector<double> result;
  for (const std::size_t i : free_coefficients(shape)) {
    double sum = 0;
    for (int k = 1; k <= shape.degree; ++k) sum += knots[i + static_cast<std::size_t>(k)];
    result.push_back(start(std::clamp(sum / shape.degree, 0.0, 1.0)).s);
  }
  return result;
}

/// The arguments of the member that is such a law.
Arguments<double> moving_as(const FreeLaw& shape, const Law<double>& law) {
  const std::vector<double> own = knot_arguments(shape);
  const std::vector<double> all =
      spline_coefficients(law, shape.degree, repeated_knots(shape, own));
  std::vector<std::vector<double>> lists(1);
  for (const std::size_t i : free_coefficients(shape)) lists.front().push_back(all[i]);
  if (shape.moving_knots) lists.push_back(own);
  return Arguments<double>(std::move(lists));
}

std::string formula_of(const FreeLaw& shape) {
  return fmt::format("the {}spline of degree {} with {} {}knots, C{}",
                     shape.symmetric ? "symmetric " : "", shape.degree, shape.knots.size(),
                     shape.moving_knots ? "moving " : "", shape.continuity);
}

}  // namespace

std::vector<double> even_knots(int n) {
  std::vector<double> knots;
  for (int i = 1; i <= n; ++i) knots.push_back(static_cast<double>(i) / (n + 1));
  return knots;
}

Member free_law(const FreeLaw& shape, const Law<double>& start) {
  check(shape);
  std::vector<Parameter> parameters{
      {"coefficients", "1", -kMostCoefficient, kMostCoefficient,
       starting_coefficients(shape, start),
       "coefficients of the spline, except those that the ends determine", true, false, true}};
  // A piece is moved by degree + 1 neighbours, and by those that an end decides from these.
  constexpr std::size_t kDecided = 3;
  parameters.back().reach = static_cast<std::size_t>(shape.degree) + 1 + kDecided;
  if (shape.moving_knots) {
    parameters.push_back(
        {"knots", "1", 0, 1, knot_arguments(shape), "abscissas where the pieces meet", true});
  }
  Family family{
      .name = "free",
      .aliases = {},
      .formula = formula_of(shape),
      .parameters = std::move(parameters),
      .ends = "by parameters",
      .continuity = 0,
      .symmetric = shape.symmetric,
      .source = "stated",
      .maker = [shape]<class S>(const Arguments<S>& arguments) -> Possible<Law<S>> {
        const auto spline = spline_of(shape, arguments);
        if (!spline) return spline.reason();
        return possible_b_spline<S>(shape.degree, spline->first, spline->second);
      },
      .listed =
          [shape](const Arguments<double>& arguments) { return as_b_spline(shape, arguments); },
      .moving_as = [shape](const Law<double>& law) { return moving_as(shape, law); }};
  family.continuity = continuity(family.make(family.defaults()));
  const auto owned = std::make_shared<const Family>(std::move(family));
  return {owned, owned->defaults()};
}

}  // namespace camlaw
