// SPDX-License-Identifier: MIT
#pragma once

#include "kinematics/laws/catalogue.h"
#include "kinematics/transform.h"
#include "numerics/scalar/dual.h"

/// The catalogue's entries, one function per group of laws.
namespace camlaw {

std::vector<Family> polynomial_families();
std::vector<Family> harmonic_families();
std::vector<Family> phase_families();
std::vector<Family> curved_families();
std::vector<Family> spline_families();

namespace detail {

/// The parameter, marked as one in which s is affine (a skewed law too: families with a crossover
/// that have such parameters are symmetric whatever their values, so the skewing is fixed).
inline Parameter linear(Parameter parameter) {
  parameter.linear = true;
  return parameter;
}

/// What a rest-to-rest family says of itself.
struct RestToRest {
  std::string name;
  std::vector<std::string> aliases;
  std::string formula;
  int continuity;
  bool symmetric;
  std::string source;
  std::vector<Parameter> parameters = {};
  std::vector<Room> rooms = {};
};

/// (FS5) 1 - sum factors[i] p[i] of a family's first parameters.
inline Room rest_of_one(std::string name, std::vector<double> factors) {
  return {std::move(name), [factors]<class S>(const Arguments<S>& a) {
            S rest = number<S>(1);
            for (std::size_t i = 0; i < factors.size(); ++i) {
              rest = rest - number<S>(factors[i]) * a.scalar(i);
            }
            return rest;
          }};
}

/// The same where nothing may be left.
inline Room sum_of_one(Room room) {
  room.is_equal = true;
  return room;
}

/// The entry for a rest-to-rest law, from a function that makes a Law or, where arguments may make
/// none, a Possible<Law>. It takes one more parameter, `crossover`: the asymmetric variants.
template <class F>
Family rest_to_rest(RestToRest about, F construct) {
  const std::size_t index = about.parameters.size();
  // Without a skew the law keeps its pieces.
  constexpr double kNoSkew = 0.5;
  Parameter crossover{
      kCrossover,
      "1",
      0.02,
      0.98,
      {kNoSkew},
      "where the acceleration of a symmetric law changes sign; 0.5 leaves every law unchanged, "
      "and laws that are not symmetric are skewed in the same way"};
  crossover.joins_at = kNoSkew;
  about.parameters.push_back(std::move(crossover));
  return {std::move(about.name),
          std::move(about.aliases),
          std::move(about.formula),
          std::move(about.parameters),
          "R-R",
          about.continuity,
          about.symmetric,
          std::move(about.source),
          [construct, index]<class S>(const Arguments<S>& a) -> Possible<Law<S>> {
            Possible<Law<S>> law = construct(a);
            const S& at = a.scalar(index);
            if (!law || is_number(at, kNoSkew)) return law;
            return skewed(*law, at);
          },
          {},
          std::move(about.rooms)};
}

}  // namespace detail
}  // namespace camlaw
