// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numbers>

#include "numerics/scalar/interval.h"
#include "optim/problem/automatic_curve.h"
#include "tests/adversarial/api_model.h"
#include "tests/adversarial/case.h"

namespace camlaw::adversary {

Case box_cam_case(Random& random);
Case spike_file_case(Random& random);
Case flat_law_case(Random& random);
Case quiet_law_case(Random& random);

namespace {

using optim::Shape;

/// Builds the program's problem and the judge's side by side.
struct Both {
  Case test;
  std::shared_ptr<ApiModel> model = std::make_shared<ApiModel>();
  optim::Problem problem;

  explicit Both(const std::string& kind) {
    test.kind = kind;
    problem.name = kind;
  }
  void vary(const std::string& name, double lower, double upper, double start, double low,
            double high) {
    problem.variables.push_back({.name = name, .lower = lower, .upper = upper, .start = start});
    test.plain.variables.push_back({name, lower, upper, low, high});
  }
  std::vector<std::size_t> all() const {
    std::vector<std::size_t> inputs;
    for (std::size_t i = 0; i < problem.variables.size(); ++i) inputs.push_back(i);
    return inputs;
  }
  int respond(const std::string& name, std::function<double(const Point&, double)> f, bool curve) {
    model->responses.push_back({std::move(f), curve});
    test.plain.names.push_back(name);
    return static_cast<int>(model->responses.size()) - 1;
  }
  /// A number f(u) of all variables.
  template <class F>
  void seek(F f, bool least, Shape shape = Shape::General) {
    problem.objectives = {
        {.response = {.name = "cost", .measure = optim::function(all(), f, shape)},
         .sense = least ? optim::Sense::Minimize : optim::Sense::Maximize}};
    test.plain.objective = respond(
        "cost", [f](const Point& x, double) { return f(x); }, false);
    test.plain.sense = least ? 1 : -1;
  }
  template <class F>
  void limit(const std::string& name, F f, std::optional<double> lower, std::optional<double> upper,
             Shape shape = Shape::General, std::optional<double> tolerance = {}) {
    problem.constraints.push_back(
        {.response = {.name = name, .measure = optim::function(all(), f, shape)},
         .lower = lower,
         .upper = upper,
         .tolerance = tolerance});
    test.plain.limits.push_back({respond(
                                     name, [f](const Point& x, double) { return f(x); }, false),
                                 lower, upper});
  }
  /// What the limit that was stated last is made of.
  void made_of(std::function<double(const Point&)> magnitude) {
    model->responses.back().magnitude = std::move(magnitude);
  }
  Case made() {
    test.plain.model = model;
    test.api = problem;
    return test;
  }
};

/// A box about a place: `wide` times the sensible one, that place anywhere in it.
std::array<double, 2> box_about(Random& random, double place, double wide) {
  const double share = random.unit();
  return {place - share * wide, place + (1 - share) * wide};
}

using std::exp;

/// A limit with an exponential: maximise x with exp(k x) <= c, told with the bound at 0.
Case exponential_case(Random& random) {
  Both both("box");
  const double k = random.rounded(0.5, 2), c = random.rounded(1, 20), best = std::log(c) / k;
  const double wide = random.power(-16, 9);
  const auto box = box_about(random, best, wide);
  const double upper = std::min(box[1], 300.0 / k), lower = std::max(box[0], -300.0 / k);
  both.vary("x", lower, upper, lower + (upper - lower) * random.unit(), best - 1, best + 1);
  const bool two = random.chance(0.5);
  if (two) both.vary("y", 0, 1, random.unit(), 0, 1);
  both.seek([two](const auto& u) { return two ? u[0] + u[1] * 0.1 : u[0] * 1.0; }, false,
            Shape::Linear);
  both.limit(
      "growth",
      [k, c, two](const auto& u) { return two ? exp(k * u[0]) + u[1] - c : exp(k * u[0]) - c; }, {},
      0.0, random.chance(0.5) ? Shape::Convex : Shape::General,
      random.chance(0.3) ? std::optional<double>(1e-6) : std::nullopt);
  both.made_of([k, c](const Point& at) { return exp(k * at[0]) + c; });
  return both.made();
}

/// Limits at 0 of polynomials, in boxes from 1e-6 to 1e6 times the sensible one.
Case hyperbola_case(Random& random) {
  Both both("box");
  const double a = random.rounded(0.5, 3), b = random.rounded(0.5, 3);
  // x y >= a, least x + b y: x = sqrt(a b), y = sqrt(a / b).
  const double x = std::sqrt(a * b), y = std::sqrt(a / b), wide = random.power(-18, 19);
  for (const auto& [name, place] : {std::pair{"x", x}, std::pair{"y", y}}) {
    auto box = box_about(random, place, wide);
    box[0] = std::max(box[0], 1e-3);
    both.vary(name, box[0], box[1], box[0] + (box[1] - box[0]) * random.unit(), place / 2,
              place * 2);
  }
  both.seek([b](const auto& u) { return u[0] + b * u[1]; }, true, Shape::Linear);
  both.limit("product", [a](const auto& u) { return u[0] * u[1] - a; }, 0.0, {});
  both.made_of([a](const Point& at) { return std::abs(at[0] * at[1]) + a; });
  return both.made();
}

/// A curve with a spike between any grid of the program: x0 + x1 cos + spike, least x0.
Case spike_curve_case(Random& random) {
  Both both("spike");
  const double place = random.between(0.03, 0.97),
               width = std::ldexp(1 + random.unit(), -10 - random.below(6));
  const double height = random.rounded(0.5, 3), swing = random.rounded(0.2, 1),
               top = random.rounded(4, 6);
  both.vary("level", -10, 10, random.between(-9, 0), -5, 5);
  const auto curve = [=](const auto& u, const auto& angle) {
    using std::cos;
    const auto z = (angle - place) * (1 / width);
    return u[0] + swing * cos(angle * 6.0) + height / (1.0 + z * z);
  };
  both.seek([](const auto& u) { return u[0] * 1.0; }, false, Shape::Linear);
  const bool enclosed = random.chance(0.9);
  const optim::Response response{
      .name = "spiked",
      .measure = enclosed ? optim::curve<Interval>({0}, 0, 1, curve, Shape::Linear)
                          : optim::curve({0}, 0, 1, curve, Shape::Linear)};
  both.problem.constraints.push_back({.response = response, .upper = top});
  const int index = both.respond(
      "spiked", [curve](const Point& x, double angle) { return curve(x, angle); }, true);
  both.test.plain.limits.push_back({index, {}, top});
  for (int i = -40; i <= 40; ++i) {
    const double u = place + 0.2 * i * width;
    if (u > 0 && u < 1) both.model->besides.push_back({0, u, 1 - u});
  }
  return both.made();
}

/// Linear limits, some of them sums of others or written twice.
Case linear_case(Random& random, const std::string& kind, int dependent) {
  Both both(kind);
  const int n = 2 + random.below(4), rows = n + random.below(4);
  for (int i = 0; i < n; ++i) {
    const double wide = random.rounded(1, 10);
    both.vary("x" + std::to_string(i), -wide, wide, random.between(-wide, wide), -wide, wide);
  }
  std::vector<std::vector<double>> a;
  std::vector<double> b;
  Point inside;
  for (int i = 0; i < n; ++i) inside.push_back(random.between(-0.5, 0.5));
  const auto times = [&](const std::vector<double>& row, const Point& x) {
    double sum = 0;
    for (std::size_t i = 0; i < row.size(); ++i) sum += row[i] * x[i];
    return sum;
  };
  for (int k = 0; k < rows; ++k) {
    std::vector<double> row;
    for (int i = 0; i < n; ++i) row.push_back(random.rounded(-1, 1));
    a.push_back(row);
    b.push_back(times(row, inside) + random.rounded(0, 1));
  }
  for (int k = 0; k < dependent; ++k) {
    const auto i = static_cast<std::size_t>(random.below(rows)),
               j = static_cast<std::size_t>(random.below(rows));
    if (random.chance(0.4)) {
      a.push_back(a[i]);
      b.push_back(b[i]);
    } else {
      std::vector<double> row;
      for (std::size_t c = 0; c < a[i].size(); ++c) row.push_back(a[i][c] + a[j][c]);
      a.push_back(row);
      b.push_back(b[i] + b[j]);
    }
  }
  std::vector<double> cost;
  for (int i = 0; i < n; ++i) cost.push_back(random.rounded(-1, 1));
  const auto linear = [](std::vector<double> row) {
    return [row](const auto& u) {
      auto sum = row[0] * u[0];
      for (std::size_t i = 1; i < row.size(); ++i) sum = sum + row[i] * u[i];
      return sum;
    };
  };
  both.seek(linear(cost), true, Shape::Linear);
  for (std::size_t k = 0; k < a.size(); ++k) {
    both.limit("row" + std::to_string(k), linear(a[k]), {}, b[k], Shape::Linear);
  }
  both.model->is_affine = true;
  both.test.smooth = kind == "smooth";
  return both.made();
}

/// A formula whose enclosure is right and wide: it shows the value to `width` only.
template <class F>
class VagueKernel final : public optim::Kernel {
 public:
  VagueKernel(F f, double width) : kernel_(std::move(f)), width_(width) {}
  double value(std::span<const double> u) const override { return kernel_.value(u); }
  double gradient(std::span<const double> u, std::span<double> g) const override {
    return kernel_.gradient(u, g);
  }
  double hessian(std::span<const double> u, std::span<double> g,
                 std::span<double> h) const override {
    return kernel_.hessian(u, g, h);
  }
  optim::Bounds enclose(std::span<const double> u) const override {
    const double value = kernel_.value(u);
    return {value - width_, value + width_};
  }
  bool is_enclosed() const override { return true; }

 private:
  optim::AutomaticKernel<F> kernel_;
  double width_;
};

/// Equations of which some follow from the others, and a convex quadratic objective whose optimum
/// is chosen beforehand: c = -Q x* - A' m.
Case equations_case(Random& random) {
  Both both("dependent");
  const int n = 6 + random.below(2), rank = 2 + random.below(4), rows = rank + random.below(2);
  const bool whole = random.chance(0.4);
  Point best;
  for (int i = 0; i < n; ++i) {
    best.push_back(random.rounded(-1, 1));
    both.vary("x" + std::to_string(i), -5, 5, random.between(-3, 3), -2, 2);
  }
  std::vector<std::vector<double>> a;
  for (int k = 0; k < rows; ++k) {
    std::vector<double> row(static_cast<std::size_t>(n), 0.0);
    if (k < rank) {
      for (double& x : row) x = whole ? std::round(random.between(-4, 4)) : random.between(-4, 4);
    } else {
      const auto& one = a[static_cast<std::size_t>(random.below(rank))];
      const auto& other = a[static_cast<std::size_t>(random.below(rank))];
      for (std::size_t i = 0; i < row.size(); ++i) row[i] = one[i] - 2 * other[i];
    }
    if (std::all_of(row.begin(), row.end(), [](double x) { return x == 0; })) row[0] = 1;
    a.push_back(row);
  }
  std::vector<double> q, c(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) q.push_back(random.rounded(0.5, 2));
  for (std::size_t i = 0; i < c.size(); ++i) c[i] = -q[i] * best[i];
  std::vector<double> b;
  for (const auto& row : a) {
    const double m = random.rounded(-1, 1);
    double sum = 0;
    for (std::size_t i = 0; i < row.size(); ++i) c[i] -= m * row[i], sum += row[i] * best[i];
    b.push_back(sum);
  }
  both.seek(
      [q, c](const auto& u) {
        auto sum = c[0] * u[0];
        for (std::size_t i = 0; i < q.size(); ++i)
          sum = sum + 0.5 * q[i] * u[i] * u[i] + (i > 0 ? c[i] : 0.0) * u[i];
        return sum;
      },
      true, random.chance(0.6) ? Shape::Convex : Shape::General);
  for (std::size_t k = 0; k < a.size(); ++k) {
    both.limit(
        "equation" + std::to_string(k),
        [row = a[k]](const auto& u) {
          auto sum = row[0] * u[0];
          for (std::size_t i = 1; i < row.size(); ++i) sum = sum + row[i] * u[i];
          return sum;
        },
        b[k], b[k], Shape::Linear);
  }
  both.test.known = best;
  return both.made();
}

}  // namespace

Case box_case(Random& random) {
  const int which = random.below(3);
  return which == 0   ? box_cam_case(random)
         : which == 1 ? exponential_case(random)
                      : hyperbola_case(random);
}

Case spike_case(Random& random) {
  return random.chance(0.4) ? spike_file_case(random) : spike_curve_case(random);
}

Case dependent_case(Random& random) {
  if (random.chance(0.25)) return flat_law_case(random);
  if (random.chance(0.35)) return quiet_law_case(random);
  return random.chance(0.5) ? equations_case(random)
                            : linear_case(random, "dependent", 1 + random.below(3));
}

Case corner_case(Random& random) { return linear_case(random, "corner", 0); }

Case smooth_case(Random& random) {
  if (random.chance(0.3)) return linear_case(random, "smooth", 0);
  // The point of an ellipse that is nearest to a place outside it, or the place itself within.
  Both both("smooth");
  const double a = random.rounded(0.5, 2), b = random.rounded(0.5, 2),
               size = random.rounded(0.5, 3);
  const double px = random.rounded(-3, 3), py = random.rounded(-3, 3);
  both.vary("x", -5, 5, random.between(-4, 4), -3, 3);
  both.vary("y", -5, 5, random.between(-4, 4), -3, 3);
  both.seek(
      [=](const auto& u) { return (u[0] - px) * (u[0] - px) + (u[1] - py) * (u[1] - py) + 1.0; },
      true, Shape::Convex);
  both.limit(
      "ellipse", [=](const auto& u) { return a * u[0] * u[0] + b * u[1] * u[1]; }, {}, size,
      random.chance(0.5) ? Shape::Convex : Shape::General);
  if (random.chance(0.5))
    both.limit(
        "plane", [=](const auto& u) { return u[0] + a * u[1]; }, {}, random.rounded(0.1, 1),
        Shape::Linear);
  both.test.smooth = true;
  return both.made();
}

Case vague_front_case(Random& random) {
  // Distances from three places, with enclosures of a hundredth of them.
  Case test;
  test.kind = "front-point";
  optim::Problem problem;
  problem.name = "three places";
  for (const char* name : {"x", "y"}) {
    problem.variables.push_back(
        {.name = name, .lower = -3, .upper = 3, .start = random.between(-2, 2)});
  }
  const double width = std::ldexp(1 + random.unit(), -10 + random.below(6));
  for (int i = 0; i < 3; ++i) {
    const double px = random.rounded(-1, 1) + (i == 0 ? -1 : 1), py = i == 2 ? 1.5 : 0;
    const auto distance = [px, py](const auto& u) {
      return (u[0] - px) * (u[0] - px) + (u[1] - py) * (u[1] - py) + 1.0;
    };
    const auto kernel = std::make_shared<VagueKernel<decltype(distance)>>(distance, width);
    problem.objectives.push_back(
        {.response = {.name = "distance" + std::to_string(problem.objectives.size() + 1),
                      .measure = optim::Function({0, 1}, kernel, Shape::Convex)}});
  }
  test.vague_front = problem;
  return test;
}

Case valleys_case(Random& random) {
  // (x^2 - 1)^2 + tilt x + (y - x / 2)^2: valleys at -1 and 1 whose depths differ by 2 tilt.
  Both both("valleys");
  const double tilt =
      std::ldexp(1 + random.unit(), -20 + random.below(14)) * (random.chance(0.5) ? 1 : -1);
  both.vary("x", -3, 3, random.between(-3, 3), -2, 2);
  both.vary("y", -3, 3, random.between(-3, 3), -2, 2);
  both.seek(
      [=](const auto& u) {
        const auto well = u[0] * u[0] - 1.0, off = u[1] - 0.5 * u[0];
        return well * well + tilt * u[0] + off * off + 1.0;
      },
      true);
  if (random.chance(0.5))
    both.limit(
        "sum", [](const auto& u) { return u[0] + u[1]; }, random.rounded(-2, 0.5), {},
        Shape::Linear);
  return both.made();
}

}  // namespace camlaw::adversary
