// SPDX-License-Identifier: MIT
// Gradients of means over the cycle by a pass back, against passes forward and differences.
#include "machines/model/mean_slopes.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "machines/registry.h"
#include "tests/machines/mechanism_fixture.h"

namespace camlaw::problems::mean_slopes_test {
namespace {

using testing::design_of, testing::response_of, testing::TestDesign, testing::with_dwells;

/// Some slopes by the motion and by the ends of every piece, different for each.
struct Slopes {
  double operator()(std::size_t piece, int k) const {
    return std::cos(1.0 + 3.0 * static_cast<double>(piece) + 0.7 * k);
  }
};

constexpr std::array<double, 2> kShares{0.2, 0.65};

/// What LawSlopes hands to the parameters.
std::vector<double> handed_back(const LawBinding& binding, const std::vector<double>& values) {
  const Slopes slope;
  const auto law = binding.possible_law_of<double>(std::span<const double>(values)).value();
  LawSlopes slopes(binding, law, values);
  for (std::size_t p = 0; p < law.pieces().size(); ++p) {
    const Piece<double>& piece = law.pieces()[p];
    for (const double share : kShares) {
      slopes.add_motion(p, std::lerp(piece.begin, piece.end, share),
                        {slope(p, 0), slope(p, 1), slope(p, 2), slope(p, 3)});
    }
    slopes.add_end({p, false}, slope(p, 4));
    slopes.add_end({p, true}, slope(p, 5));
  }
  std::vector<double> result(values.size());
  slopes.add_to(result);
  return result;
}

/// The same from the law in dual numbers.
std::vector<double> forward(const LawBinding& binding, const std::vector<double>& values) {
  const Slopes slope;
  const auto plain = binding.possible_law_of<double>(std::span<const double>(values)).value();
  std::vector<double> result(values.size());
  const std::vector<Law<Dual>> laws = binding.first_laws(values);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Law<Dual>& law = laws[i / kDualWidth];
    Dual sum(0.0);
    for (std::size_t p = 0; p < law.pieces().size(); ++p) {
      const Piece<Dual>& piece = law.pieces()[p];
      for (const double share : kShares) {
        const auto motion =
            derivatives<4>(piece, std::lerp(plain.pieces()[p].begin, plain.pieces()[p].end, share));
        for (int m = 0; m < 4; ++m) sum += slope(p, m) * motion[static_cast<std::size_t>(m)];
      }
      sum += slope(p, 4) * piece.begin + slope(p, 5) * piece.end;
    }
    result[i] = sum.v[static_cast<int>(i % kDualWidth)];
  }
  return result;
}

}  // namespace

TEST_CASE("slopes by a law's parameters are handed back through its pieces", "[mechanism]") {
  struct Case {
    Member member;
    std::vector<std::string> parameters;
  };
  // Linear ones, moving breaks, harmonics whose frequency moves, curves, programs.
  const std::vector<Case> cases{
      {find_law("legendre c=-3,1"), {"c"}},
      {find_law("b-spline"), {"coefficients"}},
      {find_law("fourier"), {"a"}},
      {find_law("scca"), {"a", "b", "c"}},
      {find_law("universal"), {"d1", "d2", "d3", "d4", "d5", "d6"}},
      {find_law("elliptic"), {"n"}},
      {find_law("inclined-sinusoid"), {"angle"}},
      {with_dwells("scca"), {"rise_angle", "rise_a", "rise_b", "return_angle"}},
      {with_dwells("b-spline"), {"rise_coefficients", "rise_angle"}},
  };
  for (const Case& one : cases) {
    INFO(one.member.family->name);
    const LawBinding binding(one.member, testing::law_variables(one.member, one.parameters));
    std::vector<double> values;
    for (const LawVariable& v : binding.variables()) {
      values.push_back(one.member.arguments.list(v.parameter)[v.element]);
    }
    const auto back = handed_back(binding, values), expected = forward(binding, values);
    double size = 0;
    for (const double slope : expected) size = std::max(size, std::abs(slope));
    CHECK(size > 0);
    for (std::size_t i = 0; i < values.size(); ++i) {
      CHECK(back[i] == Approx(expected[i]).epsilon(1e-12).margin(1e-12 * size));
    }
  }
}

TEST_CASE("a mean's gradient includes the places at which its integrand decides", "[mechanism]") {
  // With friction the force jumps where the follower reverses, and the flank that bears changes.
  const Mechanism& cam = find_mechanism("disc-cam-roller");
  TestDesign design = design_of(cam, with_dwells("scca"), {"rise_angle", "rise_a", "return_angle"},
                                {"base_radius", "guide_friction", "spring_preload"});
  Binding& binding = design.binding;
  for (const auto& [name, value] :
       {std::pair("offset", 6.0), std::pair("mass", 3.0), std::pair("base_radius", 70.0),
        std::pair("guide_friction", 0.1), std::pair("spring_preload", 5.0)}) {
    const std::size_t parameter = cam.parameter(name);
    binding.constants[parameter] = value;
    for (std::size_t k = 0; k < binding.parameters.size(); ++k) {
      if (binding.parameters[k] == parameter) design.x[binding.variables[k]] = value;
    }
  }
  for (const char* name : {"torque_rms", "equivalent_load", "life"}) {
    INFO(name);
    const optim::Function f = response_of(cam, name, binding).function();
    const std::size_t n = f.inputs().size();
    std::vector<double> back(n), forward(n), second(optim::packed_size(n));
    REQUIRE(f.gradient(design.x, back) == Approx(f.value(design.x)).epsilon(1e-14));
    f.hessian(design.x, forward, second);
    double size = 0;
    for (const double slope : forward) size = std::max(size, std::abs(slope));
    for (std::size_t i = 0; i < n; ++i) {
      CHECK(back[i] == Approx(forward[i]).epsilon(1e-10).margin(1e-10 * size));
    }
  }
}

}  // namespace camlaw::problems::mean_slopes_test
