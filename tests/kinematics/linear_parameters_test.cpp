// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <set>
#include <string>

#include "kinematics/laws/catalogue.h"
#include "numerics/scalar/dual.h"

namespace camlaw::linear_parameters_test {
namespace {

/// One element of a list parameter, or the value of a plain one.
struct Element {
  std::size_t parameter, index;
};

std::vector<Element> elements(const Member& member, bool linear) {
  std::vector<Element> result;
  for (std::size_t p = 0; p < member.family->parameters.size(); ++p) {
    const Parameter& parameter = member.family->parameters[p];
    if (parameter.structural || parameter.linear != linear) continue;
    for (std::size_t i = 0; i < member.arguments.list(p).size(); ++i) result.push_back({p, i});
  }
  return result;
}

/// Of s, v, a, j over many x: the largest second derivative along a direction in the parameters,
/// next to the largest first one.
struct Bend {
  double first = 0, second = 0;
};

Bend bend(const Member& member, const std::vector<Element>& along, const std::vector<double>& by) {
  Arguments<Dual2> arguments = member.arguments.as<Dual2>();
  for (std::size_t k = 0; k < along.size(); ++k) {
    Dual2& value = arguments.values()[along[k].parameter][along[k].index];
    value.a.v[0] = by[k];
    value.v[0] = Dual(by[k]);
  }
  const Law<Dual2> law = member.family->make(arguments);
  Bend result;
  for (int i = 0; i < 40; ++i) {
    for (const Dual2& d : law.derivatives<4>((i + 0.37) / 40)) {
      result.first = std::max(result.first, std::abs(d.v[0].a));
      result.second = std::max(result.second, std::abs(d.v[0].v[0]));
    }
  }
  return result;
}

/// The default members, some more so that every list has elements, and skewed ones.
std::vector<Member> members() {
  std::vector<Member> result;
  for (const Family& family : catalogue()) result.push_back({&family, family.defaults()});
  for (const char* text :
       {"polynomial-5 alpha=7", "polynomial-7 A=-30", "legendre c=40,-20,10,5,-3,2,1,0.5",
        "fourier a=0.3,-0.2,0.1,0.05,0.7", "boundary-5 s0=0.2 v0=1 a0=-3 s1=0.9 v1=0.3 a1=2",
        "boundary-7 s0=0.2 v0=1 a0=-3 j0=5 v1=0.3 a1=2 j1=-7",
        "b-spline degree=3 knots=0.3,0.6 coefficients=0,0.1,0.3,0.6,0.9,1",
        "table x=0,0.2,0.5,1 s=0,0.1,0.6,1 v=0,1,1.5,0", "s-curve B=1.6 C=5.8 D=58.52174",
        "polynomial-5 alpha=-5 crossover=0.4", "polynomial-7 A=20 crossover=0.6",
        "legendre c=-3,1,-0.3 crossover=0.35", "fourier a=0.1,0.05 crossover=0.7"}) {
    result.push_back(find_law(text));
  }
  return result;
}

}  // namespace

TEST_CASE("a law is affine in its linear parameters together", "[catalogue]") {
  std::mt19937 random(2024);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int seen = 0;
  for (const Member& member : members()) {
    const auto along = elements(member, true);
    if (along.empty()) continue;
    ++seen;
    INFO(member.name());
    for (int trial = 0; trial < 8; ++trial) {
      std::vector<double> by(along.size());
      for (double& b : by) b = uniform(random);
      const Bend found = bend(member, along, by);
      CHECK(found.first > 1e-3);
      CHECK(found.second <= 1e-12 * found.first);
    }
  }
  CHECK(seen == 20);  // eight families, twelve more members
}

TEST_CASE("a law is not affine in any other parameter", "[catalogue]") {
  std::set<std::string> names;
  for (const Member& member : members()) {
    for (const Element& element : elements(member, false)) {
      // Of a repeated knot no copy can move past the others.
      const Parameter& parameter = member.family->parameters[element.parameter];
      INFO(member.name() << ", " << parameter.name << " " << element.index);
      CHECK(bend(member, {element}, {1}).second > 1e-3);
      names.insert(parameter.name);
    }
  }
  CHECK(names.contains("knots"));
  CHECK(names.contains("C_j"));
  CHECK(names.contains(kCrossover));
}

TEST_CASE("the linear parameters are these", "[catalogue]") {
  std::set<std::string> flagged;
  for (const Family& family : catalogue()) {
    for (const Parameter& parameter : family.parameters) {
      if (parameter.linear) flagged.insert(family.name + " " + parameter.name);
    }
  }
  std::set<std::string> expected{
      "polynomial-5 alpha",   "polynomial-7 A", "legendre c", "fourier a", "table s", "table v",
      "b-spline coefficients"};
  for (const char* value : {"s0", "v0", "a0", "s1", "v1", "a1"}) {
    expected.insert(std::string("boundary-5 ") + value);
    expected.insert(std::string("boundary-7 ") + value);
  }
  expected.insert({"boundary-7 j0", "boundary-7 j1"});
  CHECK(flagged == expected);
}

}  // namespace camlaw::linear_parameters_test
