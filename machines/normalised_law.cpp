// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <algorithm>

#include "machines/follower_train/follower_train.h"
#include "machines/model/enclosed.h"
#include "machines/model/law_formula.h"
#include "machines/model/mean_square.h"
#include "machines/model/norm_kernel.h"
#include "machines/model/usual_problem.h"

namespace camlaw::problems {
namespace {

/// What a law is looked at with: undamped followers of up to three natural periods.
struct Followers {
  Given given = {};
  Expression first = given(ratio("period_ratio", "tau", 2));
  Expression second = given(ratio("period_ratio_2", "tau_2", 3));
  Expression third = given(ratio("period_ratio_3", "tau_3", 4));

 private:
  static constexpr MachineParameter ratio(const char* name, const char* symbol, double value) {
    return {name,  symbol, "1", "1", "duration of the law over a follower's natural period",
            value, 1e-3,   1000};
  }
};

using optim::Shape;

template <class F>
MechanismResponse law_curve(const char* name, const char* meaning, std::optional<Quantity> quantity,
                            F motion) {
  static const Cycle cycle{"1", {{0, 1}}};
  MechanismResponse response = curve_response<Followers>(
      {name, "1", "1", meaning}, cycle, [motion](const auto&, const auto& m) { return motion(m); });
  response.of_law = quantity;
  return response;
}

std::vector<MechanismResponse> law_curves() {
  return {
      law_curve("displacement", "s", {}, [](const auto& m) { return m.s; }),
      law_curve("velocity", "s'", Quantity::Velocity, [](const auto& m) { return m.v; }),
      law_curve("acceleration", "s''", Quantity::Acceleration, [](const auto& m) { return m.a; }),
      law_curve("jerk", "s'''; infinite if s'' jumps inside the law", Quantity::Jerk,
                [](const auto& m) { return m.j; }),
      law_curve("moment", "s' s''", Quantity::Moment, [](const auto& m) { return m.v * m.a; })};
}

/// The kernel of a plain number, formula(numbers, law), of what parts(followers) says of them.
template <class Parts, class F>
std::shared_ptr<const optim::Kernel> kernel_in(const Binding& binding, Parts parts, F formula,
                                               Shape shape) {
  return detail::law_number_kernel(binding,
                                   recorded_parts(binding, machine_parts<Followers>(parts), {}),
                                   UnitFactor("1", "1"), formula, shape);
}

/// A response with a kernel of its own over laws that are linear in what varies, where it is
/// convex: special(binding, general), `general` the kernel of the formula.
template <class Parts, class F, class Special>
MechanismResponse convex_number(ResponseAbout about, Proof proof, Parts parts, F formula,
                                Special special) {
  about.shapes = {{{"law"}, Shape::Convex, proof}};
  MechanismResponse response = law_number<Followers>(about, parts, law_kernel(formula));
  response.number = [=, general = response.number](const Binding& binding, Shape shape) {
    if (shape != Shape::Convex) return general(binding, shape);
    return function_of(detail::law_number_variables(binding),
                       special(binding, kernel_in(binding, parts, formula, shape)), shape);
  };
  return response;
}

/// A mean square; over a law that is linear in what varies a quadratic form.
MechanismResponse mean_square_of(const char* name, const char* meaning, int order) {
  return convex_number(
      {name, "1", "1", meaning}, "DS11",
      [](const Followers&) { return std::array<Expression, 0>{}; },
      [order](const auto&, const auto& law) { return mean_square(law, order); },
      [order](const Binding& binding, auto general) {
        return mean_square_kernel(binding.law, order, std::move(general));
      });
}

enum class Wave { Cosine, Sine };

/// The same integrals, enclosed piece by piece in closed form: by parts int q cos(Wx) dx is
/// q sin(Wx)/W + q' cos(Wx)/W^2 - q'' sin(Wx)/W^3 - ..., and with sin(Wx) - cos, sin, cos, ... The
/// state of the follower would be turned at each joint, by which intervals grow with exp(W).
Interval part_by_pieces(const Law<Interval>& law, const Interval& W, Wave part) {
  Interval sum(0.0);
  for (const Piece<Interval>& piece : law.pieces()) {
    for (const bool at_end : {false, true}) {
      const Interval x = at_end ? piece.end : piece.begin, t = x - piece.origin;
      const Interval wave[2] = {sin(W * x), cos(W * x)};
      std::vector<Interval> q = detail::derived(piece.polynomial, 2);
      Interval power = W;
      for (int k = part == Wave::Cosine ? 0 : 3; !q.empty(); ++k) {
        Interval value(0.0);
        for (std::size_t i = q.size(); i-- > 0;) value = value * t + q[i];
        const bool negative = (k % 4 >= 2) == at_end;
        const Interval term = value * wave[k % 2] / power;
        sum += negative ? -term : term;
        q = detail::derived(std::move(q), 1);
        power *= W;
      }
    }
  }
  return sum / W;
}

bool is_polynomial(const Law<Interval>& law) {
  return std::all_of(law.pieces().begin(), law.pieces().end(), [](const auto& piece) {
    return piece.harmonics.empty() && piece.curves.empty();
  });
}

/// (FL1) int cos(Wx) s'' dx / W and int sin(Wx) s'' dx / W of the law, from the state z, z' at its
/// end: int exp(-iWx) s'' dx = -exp(-iW) (z' + iWz).
template <class T>
Possible<T> residual_part(const Law<T>& law, const T& period_ratio, Wave part) {
  using std::cos;
  using std::sin;
  const auto end = FollowerTrain<T>{period_ratio, number<T>(0)}.after(law);
  if (!end) return end.reason();
  const T W = number<T>(2) * pi<T>() * period_ratio;
  const T rate = end->rate / W;
  const T result =
      part == Wave::Cosine ? -(cos(W) * rate) - sin(W) * end->z : cos(W) * end->z - sin(W) * rate;
  if constexpr (std::is_same_v<T, Interval>) {
    if (is_polynomial(law)) return both(result, part_by_pieces(law, W, part));
  }
  return result;
}

/// What matters of a follower, counted from 0: its period ratio.
auto ratio_of(int which) {
  return [which](const Followers& f) {
    return std::array<Expression, 1>{which == 0 ? f.first : which == 1 ? f.second : f.third};
  };
}

auto part_formula(Wave part) {
  return [part](const auto& ratio, const auto& law) { return residual_part(law, ratio[0], part); };
}

std::string numbered(const std::string& name, int which) {
  return which == 0 ? name : fmt::format("{}_{}", name, which + 1);
}

MechanismResponse residual_part(const char* name, Wave part, int which) {
  return law_number<Followers>(
      {numbered(name, which),
       "1",
       "1",
       fmt::format("{} part of the residual vibration at {}",
                   part == Wave::Cosine ? "cosine" : "sine", numbered("period_ratio", which)),
       {{{"law"}, Shape::Linear, "DS10"}}},
      ratio_of(which), law_kernel(part_formula(part)));
}

/// The size of both parts; over a law that is linear in what varies the norm of two linear numbers.
MechanismResponse residual_amplitude(int which) {
  return convex_number(
      {numbered("residual_amplitude", which), "1", "1",
       "amplitude of the residual vibration, undamped, as a fraction of the stroke"},
      "DS10", ratio_of(which),
      []<class T>(std::span<const T> ratio, const Law<T>& law) -> Possible<T> {
        const FollowerTrain<T> train{ratio[0], number<T>(0)};
        const auto end = train.after(law);
        if (!end) return end.reason();
        const T result = train.amplitude(*end);
        if constexpr (std::is_same_v<T, Interval>) {
          const auto c = residual_part(law, ratio[0], Wave::Cosine);
          if (!c) return c.reason();
          const auto s = residual_part(law, ratio[0], Wave::Sine);
          if (!s) return s.reason();
          return both(result, sqrt(boost::numeric::square(*c) + boost::numeric::square(*s)));
        } else {
          return result;
        }
      },
      [which](const Binding& binding, auto general) -> std::shared_ptr<const optim::Kernel> {
        const auto part = [&](Wave p) {
          return kernel_in(binding, ratio_of(which), part_formula(p), Shape::Linear);
        };
        return std::make_shared<NormKernel>(part(Wave::Cosine), part(Wave::Sine),
                                            std::move(general));
      });
}

std::vector<MechanismResponse> responses() {
  std::vector<MechanismResponse> all = law_curves();
  all.push_back(mean_square_of("mean_square_velocity", "mean of s'^2", 1));
  all.push_back(mean_square_of("mean_square_acceleration", "mean of s''^2", 2));
  all.push_back(mean_square_of("mean_square_jerk", "mean of s'''^2", 3));
  for (int which = 0; which < 3; ++which) {
    all.push_back(residual_part("residual_cosine", Wave::Cosine, which));
    all.push_back(residual_part("residual_sine", Wave::Sine, which));
    all.push_back(residual_amplitude(which));
  }
  return all;
}

}  // namespace

Mechanism normalised_law_mechanism() {
  using P = optim::Part;
  return {.name = "law",
          .title = "a normalised motion law without a mechanism",
          .source = "VDI 2143",
          .parameters = parameters_of<Followers>(),
          .responses = responses(),
          .peaks = {{"C_v", "velocity", P::Magnitude,
                     "peak velocity; also max_velocity, and B in older files"},
                    {"C_a", "acceleration", P::Magnitude,
                     "peak acceleration; also max_acceleration, and C in older files"},
                    {"C_j", "jerk", P::Magnitude, "peak jerk; also max_jerk, and D in older files"},
                    {"C_Mdyn", "moment", P::Magnitude,
                     "peak dynamic moment; also max_dynamic_moment, and Cm in older files"}},
          .form = Form::LawAlone,
          .usual = usual_problem({.objective = "C_a",
                                  .limits = {{"C_v", kNone, 1.6}, {"C_j", kNone, 60}},
                                  .others = {"C_Mdyn", "acceleration", "mean_square_acceleration",
                                             "mean_square_jerk", "residual_amplitude"},
                                  .law = "free"})};
}

}  // namespace camlaw::problems
