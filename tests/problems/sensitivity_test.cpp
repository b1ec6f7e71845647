// SPDX-License-Identifier: MIT
#include "problems/sensitivity/sensitivity.h"

#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <optional>
#include <utility>

#include "machines/registry.h"
#include "problems/sensitivity/design_numbers.h"
#include "problems/statement/bind.h"
#include "problems/statement/first_file.h"
#include "problems/statement/parameters.h"
#include "tests/paths.h"
#include "tests/shipped_problems.h"

namespace camlaw::problems::sensitivity_test {
namespace {

using Catch::Matchers::Contains;

ProblemStatement shipped_statement(const std::string& name) {
  return read_problem_file(testing::source("problems/") + name);
}

/// y = 3 p^2 q^-1.5 r^0 and a linear one, of a machine of one's own.
ProblemStatement power_law() {
  return read_problem(R"toml(
[machine]
name = "powers"
[machine.parameters.p]
unit = "mm"
default = 5
lower = 0
[machine.parameters.q]
unit = "kg"
default = 2
lower = 0.1
[machine.parameters.r]
default = 7
[responses.y]
formula = "3 * (p / (1 mm))^2 * (q / (1 kg))^(-1.5)"
[responses.z]
formula = "2 * p / (1 mm) - 4 * q / (1 kg)"
[variables.p]
lower = 1
upper = 10
[objective]
minimize = "y"
[[constraints]]
response = "z"
upper = 100
)toml",
                      "powers.toml");
}

const Sensitivity& by(const LocalSensitivity& local, const std::string& number,
                      const std::string& parameter) {
  for (const NumberSensitivity& n : local.numbers) {
    if (n.name != number) continue;
    for (std::size_t i = 0; i < local.parameters.size(); ++i) {
      if (local.parameters[i].name == parameter) return n.by[i];
    }
  }
  FAIL("no derivative of " + number + " by " + parameter);
  return local.numbers.front().by.front();
}

/// The value of a number of a design in which one parameter has another value.
double value_at(const ProblemStatement& design, const std::string& number,
                const DesignParameter& parameter, double value) {
  const auto all = design_numbers(design, {parameter});
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const auto& n) { return n.name == number; });
  REQUIRE(found != all.end());
  return found->function.value(std::vector<double>{value});
}

/// Richardson's central difference, of steps h and h / 2.
double difference(const ProblemStatement& design, const std::string& number,
                  const DesignParameter& p, double h) {
  const auto central = [&](double step) {
    return (value_at(design, number, p, p.value + step) -
            value_at(design, number, p, p.value - step)) /
           (2 * step);
  };
  return (4 * central(h / 2) - central(h)) / 3;
}

}  // namespace

TEST_CASE("the elasticity of a power law is its exponent", "[sensitivity]") {
  const LocalSensitivity local = local_sensitivity(power_law());
  REQUIRE(local.parameters.size() == 2);  // nothing depends on r
  CHECK(local.parameters[0].varies);
  CHECK_FALSE(local.parameters[1].varies);
  CHECK(by(local, "y", "p").elasticity == Approx(2).epsilon(1e-12));
  CHECK(by(local, "y", "q").elasticity == Approx(-1.5).epsilon(1e-12));
  CHECK(by(local, "y", "p").slope == Approx(6 * 5 * std::pow(2, -1.5)).epsilon(1e-12));
  CHECK(by(local, "z", "p").slope == Approx(2).epsilon(1e-12));
  CHECK(by(local, "z", "q").slope == Approx(-4).epsilon(1e-12));
  CHECK_FALSE(by(local, "z", "q").is_kink());
}

TEST_CASE("indices of a linear limit are the shares of its variance", "[sensitivity]") {
  const std::vector<std::string> over{"p=4:6 mm", "q = 1 kg : 3 kg"};
  const ProblemStatement design = power_law();
  const auto global =
      global_sensitivity(design, sensitivity_ranges(design, over), {.samples = 2048});
  REQUIRE(global.numbers.size() == 2);
  CHECK(global.numbers[1].name == "z");
  // The variances go as (2 * 2)^2 and (4 * 2)^2.
  CHECK(global.indices[1].first[0].value == Approx(0.2).margin(0.01));
  CHECK(global.indices[1].first[1].value == Approx(0.8).margin(0.01));
  CHECK(global.indices[1].total[1].value == Approx(0.8).margin(0.01));
  CHECK(global.indices[1].mean == Approx(2).margin(0.02));
}

namespace {

/// A cam with a limit over its return alone, which is reached at its ends: 0 of every design.
std::string over_the_return(const std::string& response, const std::string& more) {
  return R"(
mechanism = "disc-cam-roller"
[[program.segments]]
name = "rise"
angle = 120
law = "cycloidal"
[[program.segments]]
name = "high"
angle = 40
[[program.segments]]
name = "return"
angle = 120
law = "cycloidal"
[[program.segments]]
name = "low"
[variables.base_radius]
lower = 20
upper = 80
[objective]
minimize = "base_radius"
[[constraints]]
response = ")" +
         response + "\"\nover = \"return\"\nupper = \"35 deg\"\n" + more;
}

}  // namespace

TEST_CASE("limits over a part of the cycle are sensitive as they are without variations and ranges",
          "[sensitivity]") {
  for (const char* response : {"pressure_angle", "peak pressure_angle"}) {
    const auto slope_with = [&](const std::string& more) {
      const auto local = local_sensitivity(read_problem(over_the_return(response, more), "f.toml"));
      for (const NumberSensitivity& number : local.numbers) {
        if (number.is_objective) continue;
        for (std::size_t i = 0; i < local.parameters.size(); ++i) {
          if (local.parameters[i].name == "stroke") return number.by[i].slope;
        }
      }
      return std::nan("");
    };
    const double plain = slope_with("");
    INFO(response);
    CHECK(std::isfinite(plain));
    CHECK(slope_with("[variation.base_radius]\nplus = \"0.1 mm\"\n") == plain);
    CHECK(slope_with("[ranges.offset]\nlower = 0\nupper = 0.1\n") == plain);
  }
}

TEST_CASE("what only rounding changes has no indices", "[sensitivity]") {
  const ProblemStatement design = read_problem(over_the_return("pressure_angle", ""), "f.toml");
  const std::vector<std::string> over{"stroke=10:20 mm", "base_radius=30:60 mm"};
  const auto global =
      global_sensitivity(design, sensitivity_ranges(design, over), {.samples = 256});
  for (std::size_t i = 0; i < global.numbers.size(); ++i) {
    const bool is_limit = !global.numbers[i].is_objective;
    if (is_limit) CHECK(std::abs(global.indices[i].highest) < 1e-12);
    CHECK(std::isnan(global.indices[i].first[0].value) == is_limit);
    CHECK(std::isnan(global.indices[i].total[1].value) == is_limit);
  }
}

TEST_CASE("derivatives of peaks over the cycle are those of differences", "[sensitivity]") {
  for (const char* name : {"cams/roller_least_base.toml", "spine_cutter/least_force.toml",
                           "own/bearing_load.toml", "cams/speed_range.toml"}) {
    const ProblemStatement design = shipped_statement(name);
    const LocalSensitivity local = local_sensitivity(design);
    REQUIRE_FALSE(local.parameters.empty());
    std::size_t compared = 0;
    for (const NumberSensitivity& number : local.numbers) {
      for (std::size_t i = 0; i < local.parameters.size(); ++i) {
        const DesignParameter& p = local.parameters[i];
        const Sensitivity& s = number.by[i];
        const double h = 1e-3 * std::abs(p.value);
        if (h == 0 || s.is_kink() || p.value - h < p.low || p.value + h > p.high) continue;
        INFO(name << ": " << number.name << " by " << p.name);
        const double expected = difference(design, number.name, p, h);
        const double size = std::abs(number.value / p.value);
        CHECK(s.slope == Approx(expected).epsilon(1e-5).margin(1e-7 * size));
        ++compared;
      }
    }
    CHECK(compared >= 4);
  }
}

TEST_CASE("where peaks are equally high the derivatives to both sides are given", "[sensitivity]") {
  // max(u x, 1 - x) over the cycle: at u = 1 both ends are 1 high; the slope by u is 0 or 1.
  const ProblemStatement design = read_problem(R"toml(
[machine]
name = "two peaks"
moved_by = "law"
[machine.parameters.u]
default = 1
lower = 0
[responses.f]
formula = "max(u * x, 1 - x)"
[law]
name = "cycloidal"
[objective]
minimize = "highest f"
[variables.u]
lower = 0.1
upper = 4
start = 1
)toml",
                                               "peaks.toml");
  const LocalSensitivity local = local_sensitivity(design);
  const Sensitivity& s = by(local, "highest f", "u");
  CHECK(s.is_kink());
  CHECK(s.low == Approx(0).margin(1e-9));
  CHECK(s.high == Approx(1).epsilon(1e-9));
}

namespace {

/// The usual problem of a machine with limits on each of its responses that is a number, at its own
/// values.
ProblemStatement with_every_limit(const Mechanism& mechanism) {
  std::string text = first_file(mechanism);
  for (const EvaluatedResponse& r : evaluate(read_problem(text, mechanism.name + ".toml"))) {
    const double low = r.is_curve ? r.lowest : r.value, high = r.is_curve ? r.highest : r.value;
    const bool is_own = std::ranges::any_of(mechanism.responses,
                                            [&](const auto& own) { return own.name == r.name; });
    if (!is_own || !std::isfinite(low) || !std::isfinite(high)) continue;
    text += fmt::format("\n[[constraints]]\nresponse = \"{}\"\nupper = {:.17g}\n", r.name, high);
    if (r.is_curve && low < high) text += fmt::format("lower = {:.17g}\n", low);
  }
  return read_problem(text, mechanism.name + ".toml");
}

/// Of a number by a parameter the slopes to either side, each from two steps; none where they do
/// not agree, or cannot be made.
std::optional<std::pair<double, double>> slopes_by_steps(const DesignNumber& number,
                                                         const std::vector<DesignParameter>& all,
                                                         std::size_t i, double share) {
  std::vector<double> x;
  for (const DesignParameter& p : all) x.push_back(p.value);
  const double at = x[i], value = number.function.value(x);
  const double step = share * std::max(std::abs(at), 1e-2);
  if (!(at - step >= all[i].low && at + step <= all[i].high)) return {};
  const double size = std::max(std::abs(at), 1e-2), noise = 1e-7 * std::abs(value) / size;
  const auto one_sided = [&](double h) -> std::optional<double> {
    const auto slope = [&](double by) {
      x[i] = at + by;
      const double result = (number.function.value(x) - value) / (x[i] - at);
      x[i] = at;
      return result;
    };
    const double far = slope(h), near = slope(h / 2);
    if (!std::isfinite(far + near)) return {};
    if (std::max(std::abs(far), std::abs(near)) <= noise) return 0;
    if (std::abs(far - near) > 0.02 * std::max(std::abs(far), std::abs(near)) + noise) return {};
    return 2 * near - far;
  };
  const auto up = one_sided(step), down = one_sided(-step);
  if (!up || !down) return {};
  return std::pair(std::min(*up, *down), std::max(*up, *down));
}

/// Compares every derivative of a design with steps to either side; how many.
int compare_with_steps(const ProblemStatement& design) {
  const LocalSensitivity local = local_sensitivity(design);
  const auto numbers = design_numbers(design, local.parameters);
  int compared = 0;
  for (std::size_t n = 0; n < numbers.size(); ++n) {
    const double value = local.numbers[n].value;
    if (!std::isfinite(value)) continue;
    for (std::size_t i = 0; i < local.parameters.size(); ++i) {
      const auto steps = slopes_by_steps(numbers[n], local.parameters, i, 2e-5);
      if (!steps) continue;
      const Sensitivity& s = local.numbers[n].by[i];
      const double at = local.parameters[i].value;
      const double scale = std::max({std::abs(steps->first), std::abs(steps->second),
                                     1e-5 * std::abs(value) / std::max(std::abs(at), 1e-2)});
      INFO(design.mechanism->name << ": " << numbers[n].name << " by " << local.parameters[i].name
                                  << ": " << s.low << " to " << s.high << ", by steps "
                                  << steps->first << " to " << steps->second);
      const auto off = [&](const std::pair<double, double>& by) {
        return std::max(std::abs(s.low - by.first), std::abs(s.high - by.second));
      };
      ++compared;
      if (off(*steps) <= 0.02 * scale) continue;
      // What changes as a broken power is come near slowly.
      const auto nearer = slopes_by_steps(numbers[n], local.parameters, i, 2e-6);
      REQUIRE(nearer);
      CHECK(off(*nearer) <= 0.75 * off(*steps));
    }
  }
  return compared;
}

}  // namespace

TEST_CASE("the peak at a place where the formula changes over moves with that place",
          "[sensitivity]") {
  // Turning the rise by a dwell moves the place at which the next roller takes over, and no value.
  const ProblemStatement design = read_problem(R"toml(
mechanism = "parallel-index-cam"
[[program.segments]]
name = "dwell"
angle = "80 deg"
[[program.segments]]
name = "index"
angle = "200 deg"
law = "modified-sine"
[[program.segments]]
name = "rest"
[constants]
stations = 8
rollers = 8
plates = 3
axis_distance = "177.44 mm"
turret_radius = "129.25 mm"
[variables.roller_radius]
lower = "3.5 mm"
upper = "14 mm"
start = "7 mm"
[objective]
minimize = "roller_radius"
[[constraints]]
response = "undercut"
upper = 1.4
[[constraints]]
response = "second_undercut"
upper = 1.4
)toml",
                                               "index.toml");
  const LocalSensitivity local = local_sensitivity(design);
  for (const char* number : {"highest undercut", "highest second_undercut"}) {
    INFO(number);
    for (const char* parameter :
         {"dwell_angle", "index_angle", "index_crossover", "axis_distance", "turret_radius"}) {
      INFO(parameter);
      CHECK_FALSE(by(local, number, parameter).by_difference);
    }
    const Sensitivity& turned = by(local, number, "dwell_angle");
    CHECK(std::abs(turned.slope) < 1e-8);
    CHECK(std::abs(by(local, number, "index_angle").slope) > 1e-3);
  }
  CHECK(compare_with_steps(design) > 10);
}

TEST_CASE("the peak at a corner of a formula has the slopes of both sides by their steepness",
          "[sensitivity]") {
  // min(u x, 2 (1 - x)): they meet at x = 2 / (2 + u), with 2 u / (2 + u), whose slope by u is
  // 4 / (2 + u)^2.
  const ProblemStatement design = read_problem(R"toml(
[machine]
name = "ridge"
moved_by = "law"
[machine.parameters.u]
default = 1.3
lower = 0
[responses.f]
formula = "min(u * x, 2 * (1 - x))"
[law]
name = "cycloidal"
[objective]
minimize = "highest f"
[variables.u]
lower = 0.1
upper = 4
start = 1.3
)toml",
                                               "ridge.toml");
  const LocalSensitivity local = local_sensitivity(design);
  const Sensitivity& s = by(local, "highest f", "u");
  CHECK_FALSE(s.is_kink());
  CHECK_FALSE(s.by_difference);
  CHECK(s.slope == Approx(4 / (3.3 * 3.3)).epsilon(1e-5));
}

TEST_CASE("derivatives of every response of every machine are those of steps to either side",
          "[sensitivity][heavy]") {
  int compared = 0;
  for (const Mechanism& mechanism : mechanisms()) {
    INFO(mechanism.name);
    compared += compare_with_steps(with_every_limit(mechanism));
  }
  CHECK(compared > 1000);
}

TEST_CASE("ranges are those that are stated, else the file's, else hundredths", "[sensitivity]") {
  const ProblemStatement ranged = shipped_statement("cams/speed_range.toml");
  const auto of_file = sensitivity_ranges(ranged, {});
  CHECK(of_file.from == RangesFrom::File);
  REQUIRE(of_file.ranges.size() == 2);
  CHECK(of_file.ranges[0].lower == Approx(60));
  CHECK(of_file.ranges[0].upper == Approx(350));
  const auto none = sensitivity_ranges(power_law(), {});
  CHECK(none.from == RangesFrom::Hundredths);
  REQUIRE(none.ranges.size() == 2);
  CHECK(none.ranges[0].lower == Approx(4.95));
  CHECK(none.ranges[0].upper == Approx(5.05));
  const std::vector<std::string> stated{"p=1 cm:20 mm"};
  const auto own = sensitivity_ranges(power_law(), stated);
  CHECK(own.from == RangesFrom::Stated);
  CHECK(own.ranges[0].lower == Approx(10));
  struct Wrong {
    std::vector<std::string> over;
    const char* says;
  };
  for (const Wrong& wrong :
       {Wrong{{"p"}, "lower:upper"}, Wrong{{"p=3 mm"}, "lower:upper"}, Wrong{{"d=1:2"}, "d"},
        Wrong{{"p=2:1 mm"}, "not below"}, Wrong{{"p=1:2 kg"}, "kg"},
        Wrong{{"p=1:2", "p=3:4"}, "two ranges"}, Wrong{{"q=0:1 kg"}, "not within"},
        Wrong{{"p=:"}, "p"}, Wrong{{"=1:2"}, ""}}) {
    INFO(wrong.over.front());
    CHECK_THROWS_WITH(sensitivity_ranges(power_law(), wrong.over), Contains(wrong.says));
  }
}

TEST_CASE("times that stay leave no derivative by the one speed whose angles a file has",
          "[sensitivity][servo-axis]") {
  const std::string axis =
      "mechanism = 'servo-axis'\n[constants]\nstroke = '90 deg'\n%[program]\nsegments = [{name = "
      "'go', time = '0.2 s', law = '3-4-5'}, {name = 'wait', time = '0.1 s'}, {name = 'back', time "
      "= "
      "'0.3 s', law = '3-4-5'}, {name = 'rest'}]\n[variables.gear_ratio]\nlower = 2\nupper = 20\n"
      "[objective]\nminimize = 'torque_rms'\n";
  const auto with = [&](const std::string& constants, const std::string& more = "") {
    std::string text = axis;
    text.replace(text.find('%'), 1, constants);
    return read_problem(text + more, "axis.toml");
  };
  const ProblemStatement fixed = with("speed = '60 rpm'\n");
  const LocalSensitivity local = local_sensitivity(fixed);
  CHECK(std::none_of(local.parameters.begin(), local.parameters.end(),
                     [](const auto& p) { return p.name == "speed"; }));
  CHECK_THAT(local.left_out, Contains("speed is left out") && Contains("[variables.speed]"));
  CHECK_THROWS_WITH(sensitivity_ranges(fixed, std::vector<std::string>{"speed=50:60 rpm"}),
                    Contains("speed is left out"));
  // Where the speed varies, the derivative is that of the times: rms torque as sqrt(speed).
  const ProblemStatement follows =
      with("", "[variables.speed]\nlower = '30 rpm'\nupper = '90 rpm'\nstart = '60 rpm'\n");
  const LocalSensitivity varied = local_sensitivity(follows);
  CHECK(varied.left_out.empty());
  ProblemStatement faster = fixed, slower = fixed;
  set_value(faster, "speed=60.6 rpm");
  set_value(slower, "speed=59.4 rpm");
  const auto rms = [](const ProblemStatement& problem) {
    for (const auto& response : evaluate(problem)) {
      if (response.name == "torque_rms") return response.value;
    }
    return 0.0;
  };
  CHECK(by(varied, "torque_rms", "speed").slope ==
        Approx((rms(faster) - rms(slower)) / 1.2).epsilon(1e-3));
}

TEST_CASE("every shipped problem with an objective has sensitivities", "[sensitivity][heavy]") {
  for (const std::string& file : testing::shipped_problem_files()) {
    INFO(file);
    const ProblemStatement design = read_problem_file(file);
    if (design.objectives.empty() || design_parameters(design).empty()) continue;
    if (design_numbers(design, design_parameters(design)).empty()) continue;
    const LocalSensitivity local = local_sensitivity(design);
    for (const NumberSensitivity& number : local.numbers) {
      CHECK(number.by.size() == local.parameters.size());
    }
  }
}

TEST_CASE("slopes at a joint of the law are those of this joint", "[sensitivity]") {
  // (M9), (M37), (M38) at the lowest position: N = F_0 / cos alpha / (1 -+ mu tan alpha (2 a + l) /
  // l) where the return ends and where the rise begins, with tan alpha = e / y_0. What is left of s
  // there by rounding gives no slope by the spring's rate.
  for (const std::string law : {"poly-3-4-5", "poly-4-5-6-7", "cycloidal", "modified-sine"}) {
    INFO(law);
    const ProblemStatement design = read_problem(R"toml(
mechanism = "disc-cam-roller"
[constants]
base_radius = "40 mm"
stroke = "20 mm"
roller_radius = "8 mm"
mass = "1 kg"
spring_rate = "5 N/mm"
spring_preload = "100 N"
offset = "5 mm"
overhang = "40 mm"
guide_length = "60 mm"
[[program.segments]]
name = "rise"
angle = "90 deg"
law = ")toml" + law + R"toml("
[[program.segments]]
name = "high"
angle = "60 deg"
[[program.segments]]
name = "return"
angle = "90 deg"
law = ")toml" + law + R"toml("
[[program.segments]]
name = "low"
[variables.speed]
lower = "10 rpm"
upper = "200 rpm"
start = "100 rpm"
[objective]
minimize = "speed"
[[constraints]]
response = "contact_force"
lower = "0 N"
)toml",
                                                 "joint.toml");
    const LocalSensitivity local = local_sensitivity(design);
    const double height = std::sqrt(48 * 48 - 5 * 5), tangent = 5 / height;
    const double force = 100 * std::sqrt(1 + tangent * tangent);
    const double slope = force * tangent * (2 * 40 + 60) / 60;
    const Sensitivity& friction = by(local, "lowest contact_force", "guide_friction");
    CHECK(friction.low == Approx(-slope).epsilon(1e-6));
    CHECK(friction.high == Approx(slope).epsilon(1e-6));
    const Sensitivity& preload = by(local, "lowest contact_force", "spring_preload");
    CHECK(preload.low == Approx(force / 100).epsilon(1e-9));
    CHECK(preload.high == Approx(force / 100).epsilon(1e-9));
    for (const char* nothing : {"spring_rate", "stroke", "rise_angle", "return_angle",
                                "rise_crossover", "return_crossover"}) {
      const Sensitivity& none = by(local, "lowest contact_force", nothing);
      INFO(nothing);
      CHECK(none.low == 0);
      CHECK(none.high == 0);
    }
  }
}

}  // namespace camlaw::problems::sensitivity_test
