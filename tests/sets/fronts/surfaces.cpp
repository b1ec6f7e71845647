// SPDX-License-Identifier: MIT
#include "tests/sets/fronts/surfaces.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "tests/sets/fronts/formulas.h"

namespace camlaw::sets {
namespace {

using optim::Function, optim::Problem, optim::Shape;
constexpr std::size_t kRest = 10;  ///< variables that lead away from the front

/// Variables from 0 to 1 that start where no objective is at its best.
Problem stated(const std::string& name, std::size_t variables, std::vector<Function> objectives) {
  Problem problem{fmt::format("{}, {} objectives", name, objectives.size()), {}, {}, {}};
  for (std::size_t i = 0; i < variables; ++i) {
    problem.variables.push_back(
        {.name = fmt::format("x{}", i + 1), .lower = 0, .upper = 1, .start = 0.4});
  }
  for (std::size_t i = 0; i < objectives.size(); ++i) {
    problem.objectives.push_back({{fmt::format("f{}", i + 1), "1", std::move(objectives[i])}});
  }
  return problem;
}

/// 1 + sum of (x - 1/2)^2 over the variables from `first` on: one on the front.
template <class U>
auto one_and_rest(const U& u, std::size_t first) {
  auto value = 1.0 + 0.0 * u[0];
  for (std::size_t i = first; i < u.size(); ++i) value = value + square(u[i] - 0.5);
  return value;
}

/// Objective k of DTLZ2.
template <class U>
auto on_sphere(const U& u, std::size_t k, std::size_t objectives) {
  using std::cos, std::sin;
  auto value = 1.0 + 0.0 * u[0];
  for (std::size_t i = 0; i + k + 1 < objectives; ++i) value = value * cos(0.5 * kPi * u[i]);
  if (k > 0) value = value * sin(0.5 * kPi * u[objectives - 1 - k]);
  return value;
}

/// Objective k of the simplex of DTLZ1.
template <class U>
auto on_simplex(const U& u, std::size_t k, std::size_t objectives) {
  auto value = 1.0 + 0.0 * u[0];
  for (std::size_t i = 0; i + k + 1 < objectives; ++i) value = value * u[i];
  if (k > 0) value = value * (1.0 - u[objectives - 1 - k]);
  return value;
}

/// A front that is shape(u, k, objectives) where the rest of the variables is one half.
template <class F>
KnownSurface shaped(const std::string& name, std::size_t objectives, F shape) {
  std::vector<Function> parts;
  for (std::size_t k = 0; k < objectives; ++k) {
    parts.push_back(formula(objectives - 1 + kRest, [k, objectives, shape](const auto& u) {
      return one_and_rest(u, objectives - 1) * shape(u, k, objectives);
    }));
  }
  const auto costs = [objectives, shape](const std::vector<double>& u) {
    std::vector<double> result;
    for (std::size_t k = 0; k < objectives; ++k) result.push_back(shape(u, k, objectives));
    return result;
  };
  return {stated(name, objectives - 1 + kRest, std::move(parts)), costs, objectives - 1, true};
}

KnownSurface sphere(std::size_t objectives) {
  return shaped("sphere", objectives,
                [](const auto& u, std::size_t k, std::size_t n) { return on_sphere(u, k, n); });
}

KnownSurface inverted(std::size_t objectives) {
  return shaped("inverted", objectives, [](const auto& u, std::size_t k, std::size_t n) {
    return 0.5 * (1.0 - on_simplex(u, k, n));
  });
}

/// The square of the distance from corner k of a simplex, whose last corner is the origin.
template <class U>
auto from_corner(const U& u, std::size_t k, std::size_t n) {
  auto value = 0.0 * u[0];
  for (std::size_t i = 0; i + 1 < n; ++i) value = value + square(u[i] - (i == k ? 1.0 : 0.0));
  return value;
}

/// Every design within the simplex is on the front.
KnownSurface centres(std::size_t objectives) {
  std::vector<Function> parts;
  for (std::size_t k = 0; k < objectives; ++k) {
    parts.push_back(formula(
        objectives - 1, [k, objectives](const auto& u) { return from_corner(u, k, objectives); },
        Shape::Convex));
  }
  const auto costs = [objectives](const std::vector<double>& u) {
    std::vector<double> x;  // within the simplex: coordinates of DTLZ1's
    for (std::size_t k = 0; k + 1 < objectives; ++k) x.push_back(on_simplex(u, k, objectives));
    std::vector<double> result;
    for (std::size_t k = 0; k < objectives; ++k) result.push_back(from_corner(x, k, objectives));
    return result;
  };
  return {stated("centres", objectives - 1, std::move(parts)), costs, objectives - 1, true};
}

/// The last objective of DTLZ7 where the others are u and the rest adds up to g.
template <class U, class G>
auto last_of_patches(const U& u, const G& g, std::size_t objectives) {
  using std::sin;
  auto sum = static_cast<double>(objectives) * g;
  for (std::size_t i = 0; i + 1 < objectives; ++i) {
    sum = sum - u[i] * (1.0 + sin(3.0 * kPi * u[i]));
  }
  return sum;
}

/// Where u (1 + sin(3 pi u)) is greater than for any smaller u, from 0 to 1: that is where less of
/// one objective is more of the last. Two stretches, as long as a share of [0, 1] each.
class Records {
 public:
  Records() {
    const double first = top(0.1, 0.4);
    const double second = top(0.7, 1);
    double low = 0.5, high = second;  // as high as the first top
    for (int i = 0; i < 60; ++i) {
      const double middle = (low + high) / 2;
      (height(middle) < height(first) ? low : high) = middle;
    }
    first_ = first;
    begin_ = high;
    end_ = second;
  }
  double operator()(double share) const {
    const double along = share * (first_ + end_ - begin_);
    return along <= first_ ? along : begin_ + along - first_;
  }

 private:
  static double height(double u) { return u * (1 + std::sin(3 * kPi * u)); }
  static double top(double low, double high) {
    for (int i = 0; i < 200; ++i) {
      const double a = low + (high - low) / 3, b = high - (high - low) / 3;
      (height(a) < height(b) ? low : high) = height(a) < height(b) ? a : b;
    }
    return (low + high) / 2;
  }

  double first_, begin_, end_;
};

KnownSurface patches(std::size_t objectives) {
  std::vector<Function> parts;
  for (std::size_t k = 0; k + 1 < objectives; ++k) {
    parts.push_back(optim::function<Interval>(
        {k}, [](const auto& u) { return 1.0 * u[0]; }, Shape::Linear));
  }
  parts.push_back(formula(objectives - 1 + kRest, [objectives](const auto& u) {
    auto rest = 0.0 * u[0];
    for (std::size_t i = objectives - 1; i < u.size(); ++i) rest = rest + u[i];
    return last_of_patches(u, 2.0 + (9.0 / static_cast<double>(kRest)) * rest, objectives);
  }));
  const auto costs = [objectives, records = Records()](const std::vector<double>& shares) {
    std::vector<double> result;
    for (std::size_t i = 0; i + 1 < objectives; ++i) result.push_back(records(shares[i]));
    result.push_back(last_of_patches(result, 2.0, objectives));
    return result;
  };
  return {stated("patches", objectives - 1 + kRest, std::move(parts)), costs, objectives - 1,
          false};
}

/// Objective k along the curve: falls or rises with u, ever more bent.
template <class U>
auto along_curve(const U& u, std::size_t k) {
  auto power = (k % 2 == 0) ? 1.0 * u : 1.0 - u;
  auto value = power;
  for (std::size_t i = 1; i < k; ++i) value = value * power;
  return value;
}

KnownSurface curve(std::size_t objectives) {
  std::vector<Function> parts;
  for (std::size_t k = 0; k < objectives; ++k) {
    parts.push_back(formula(
        1 + kRest, [k](const auto& u) { return one_and_rest(u, 1) - 1.0 + along_curve(u[0], k); }));
  }
  const auto costs = [objectives](const std::vector<double>& u) {
    std::vector<double> result;
    for (std::size_t k = 0; k < objectives; ++k) result.push_back(along_curve(u[0], k));
    return result;
  };
  return {stated("curve", 1 + kRest, std::move(parts)), costs, 1, true};
}

}  // namespace

KnownSurface known_surface(const std::string& name, std::size_t objectives) {
  if (objectives < 3) throw std::invalid_argument("a surface has three objectives or more");
  if (name == "sphere") return sphere(objectives);
  if (name == "inverted") return inverted(objectives);
  if (name == "centres") return centres(objectives);
  if (name == "patches") return patches(objectives);
  if (name == "curve") return curve(objectives);
  throw std::invalid_argument(fmt::format("no surface is called '{}'", name));
}

}  // namespace camlaw::sets
