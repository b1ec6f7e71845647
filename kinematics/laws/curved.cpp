// SPDX-License-Identifier: MIT
#include "kinematics/laws/curved.h"

#include "kinematics/laws/families.h"

namespace camlaw {

std::vector<Family> curved_families() {
  using detail::rest_to_rest;
  return {
      rest_to_rest({"half-ellipse-velocity",
                    {"half-ellipse of velocity", "Півеліпс"},
                    "s' = (4 / pi) sqrt(1 - (2x - 1)^2)",
                    1,
                    true,
                    "the die-press study"},
                   []<class S>(const Arguments<S>&) { return half_ellipse_velocity<S>(); }),
      rest_to_rest({"half-ellipse-acceleration",
                    {},
                    "s'' = (16 / pi) sqrt(1 - (4x - 1)^2), mirrored",
                    2,
                    true,
                    "half-ellipses of acceleration, as the die-press study has one of velocity"},
                   []<class S>(const Arguments<S>&) { return half_ellipse_acceleration<S>(); }),
      rest_to_rest(
          {"elliptic",
           {},
           "[1 - cos(pi x) / sqrt(1 - k sin^2(pi x))] / 2, k = (n^2 - 1) / n^2",
           1,
           true,
           "Rothbart (ed.), Cam Design Handbook, 2004; C_v = n pi / 2 from n = sqrt(2/3) on",
           {{"n", "1", 0.2, 5, {1.2}, "ratio of the ellipse's axes; 1 is the cosine law"}}},
          []<class S>(const Arguments<S>& a) { return elliptic<S>(a.scalar(0)); }),
      rest_to_rest({"inclined-sinusoid",
                    {"inclined sinusoid of displacement", "Похила синусоїда", "Нахилена синусоїда"},
                    "x = t - cot(angle) sin(2 pi t) / (2 pi), s = t - sin(2 pi t) / (2 pi)",
                    2,
                    true,
                    "Alt; Wildt; the die-press study",
                    {{"angle",
                      "deg",
                      50,
                      130,
                      {82},
                      "angle between the sine's ordinates and the x axis in the unit square; 90 "
                      "gives the cycloid"}}},
                   []<class S>(const Arguments<S>& a) {
                     return inclined_sinusoid<S>(a.scalar(0) * pi<S>() / number<S>(180));
                   }),
  };
}

}  // namespace camlaw
