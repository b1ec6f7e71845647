// SPDX-License-Identifier: MIT
// Ranges over boxes of the design hold every value and slope inside, whatever the mechanism.
#include "machines/registry.h"
#include "tests/machines/mechanism_fixture.h"
#include "tests/random_numbers.h"

namespace camlaw::problems::ranges_test {
namespace {

using namespace testing;
using optim::Bounds;

struct BoxedDesign {
  std::vector<Bounds> box;
  std::vector<double> point(camlaw::testing::Random& random) const {
    std::vector<double> x;
    for (const Bounds& side : box) x.push_back(random(side.lower, side.upper));
    return x;
  }
};

/// A box about a design, some share of its magnitudes wide.
BoxedDesign boxed(const std::vector<double>& x, double share, camlaw::testing::Random& random) {
  BoxedDesign result;
  for (const double value : x) {
    const double middle = value * random(0.9, 1.1), half = share * std::max(0.1, std::abs(value));
    result.box.push_back({middle - half, middle + half});
  }
  return result;
}

/// Up to three of what the response uses.
std::vector<std::string> some_parameters(const Mechanism& mechanism,
                                         const std::vector<std::size_t>& uses,
                                         camlaw::testing::Random& random) {
  std::vector<std::string> names;
  for (const std::size_t i : uses) {
    const MechanismParameter& p = mechanism.parameters[i];
    const double chance = 3.0 / static_cast<double>(uses.size());
    if (!p.integer && p.default_value != 0 && names.size() < 3 && random(0, 1) < chance) {
      names.push_back(p.name);
    }
  }
  return names;
}

/// Whether the range is known; fails where a value or a slope of a point inside is outside it.
bool holds(const optim::Function& f, const BoxedDesign& design, camlaw::testing::Random& random) {
  constexpr double kRounding = 1e-10;
  const optim::BoxRange range = f.range(design.box);
  REQUIRE(range.slopes.size() == f.inputs().size());
  std::vector<double> g(f.inputs().size());
  for (int i = 0; i < 12; ++i) {
    const std::vector<double> x = design.point(random);
    const double value = f.gradient(x, g);
    if (!std::isfinite(value)) continue;
    const double slack = kRounding * std::abs(value);
    CHECK(range.value.lower <= value + slack);
    CHECK(value - slack <= range.value.upper);
    for (std::size_t k = 0; k < g.size(); ++k) {
      if (!std::isfinite(g[k])) continue;
      INFO("by variable " << f.inputs()[k]);
      const double size = std::abs(x[f.inputs()[k]]) + 1e-6;
      const double slope_slack = kRounding * (std::abs(g[k]) + std::abs(value) / size);
      CHECK(range.slopes[k].lower <= g[k] + slope_slack);
      CHECK(g[k] - slope_slack <= range.slopes[k].upper);
    }
  }
  return std::isfinite(range.value.upper - range.value.lower);
}

}  // namespace

TEST_CASE("ranges over boxes hold the values and slopes inside", "[mechanism][bound]") {
  camlaw::testing::Random random(23);
  int known = 0, curves_known = 0;
  for (const Mechanism& mechanism : mechanisms()) {
    for (const MechanismResponse& response : mechanism.responses) {
      for (const double share : {1e-4, 1e-2, 0.2}) {
        const bool with_law = response.sees_law && random(0, 1) < 0.5;
        const TestDesign design =
            design_of(mechanism, with_law ? "polynomial-5 alpha=2" : "poly-3-4-5",
                      with_law ? std::vector<std::string>{"alpha"} : std::vector<std::string>{},
                      some_parameters(mechanism, response.uses.indices(), random));
        INFO(mechanism.name << ", " << response.name << ", boxes of " << share);
        const optim::Response made = response_of(mechanism, response.name, design.binding);
        const BoxedDesign box = boxed(design.x, share, random);
        if (!made.is_curve()) {
          known += holds(made.function(), box, random);
          continue;
        }
        const double end = response.along == "1" ? 1 : 360;
        for (int i = 0; i < 4; ++i) {
          curves_known += holds(made.curve().at({random(0, end)}), box, random);
        }
      }
    }
  }
  // Numbers that peaks or integrals over the cycle go into have no range.
  CHECK(known > 150);
  CHECK(curves_known > 1000);
}

TEST_CASE("a shape of several places of one variable adds up its slopes", "[mechanism][bound]") {
  // One variable stands behind two parameters of the machine.
  const Mechanism& mechanism = find_mechanism("disc-cam-roller");
  TestDesign design = design_of(mechanism, "cycloidal", {}, {"base_radius", "roller_radius"});
  design.binding.variables = {0, 0};
  const auto row = response_of(mechanism, "pressure_angle", design.binding).curve().at({50});
  REQUIRE(row.inputs().size() == 1);
  camlaw::testing::Random random(2);
  CHECK(holds(row, {{{20, 22}}}, random));
}

}  // namespace camlaw::problems::ranges_test
