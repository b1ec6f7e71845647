// SPDX-License-Identifier: MIT
#include "numerics/polynomial/gauss_legendre.h"

#include <boost/math/quadrature/gauss.hpp>
#include <stdexcept>

namespace camlaw {
namespace {

template <int Points>
const GaussLegendre& rule() {
  using Gauss = boost::math::quadrature::gauss<double, Points>;
  static const GaussLegendre known{Gauss::abscissa(), Gauss::weights()};
  return known;
}

}  // namespace

const GaussLegendre& gauss_legendre(int points) {
  switch (points) {
    case 10:
      return rule<10>();
    case 13:
      return rule<13>();
    case 30:
      return rule<30>();
    default:
      throw std::invalid_argument("Gauss-Legendre: the points must be 10, 13 or 30");
  }
}

}  // namespace camlaw
