// SPDX-License-Identifier: MIT
#include "kinematics/laws/trigonometric.h"

#include "kinematics/laws/families.h"

namespace camlaw {
namespace {

using detail::rest_to_rest;

std::vector<Family> fixed_harmonics() {
  const char* rothbart = "Rothbart (ed.), Cam Design Handbook, 2004, p. 104";
  return {
      rest_to_rest({"cosine",
                    {"SHM", "simple harmonic", "simple harmonic motion", "cosine of acceleration",
                     "einfache Sinuslinie", "einfache Sinoide", "Косинусоїда"},
                    "(1 - cos(pi x)) / 2",
                    1,
                    true,
                    "VDI 2143; the spine-cutter study"},
                   []<class S>(const Arguments<S>&) { return cosine<S>(); }),
      {"harmonic",
       {"cosine from reversal to reversal"},
       "(1 - cos(pi x)) / 2",
       {},
       "U-U",
       kSmooth,
       true,
       "VDI 2143",
       []<class S>(const Arguments<S>&) { return harmonic<S>(); }},
      rest_to_rest({"cycloidal",
                    {"cycloid", "sine of acceleration", "sinusoid", "Bestehorn",
                     "Bestehorn-Sinoide", "geneigte Sinuslinie", "Синусоїда", "Со"},
                    "x - sin(2 pi x) / (2 pi)",
                    2,
                    true,
                    "VDI 2143; Bestehorn"},
                   []<class S>(const Arguments<S>&) { return cycloidal<S>(); }),
      {"double-harmonic",
       {},
       "[(1 - cos(pi x)) - (1 - cos(2 pi x)) / 4] / 2",
       {},
       "R-U",
       3,
       false,
       "Rothbart (ed.), Cam Design Handbook, 2004",
       []<class S>(const Arguments<S>&) { return double_harmonic<S>(); }},
      rest_to_rest({"freudenstein-1-3",
                    {},
                    "x - [27/28 sin(2 pi x) + 1/84 sin(6 pi x)] / (2 pi)",
                    2,
                    true,
                    rothbart},
                   []<class S>(const Arguments<S>&) { return freudenstein_1_3<S>(); }),
      rest_to_rest(
          {"freudenstein-1-3-5",
           {},
           "x - m [sin(2 pi x) + sin(6 pi x) / 54 + sin(10 pi x) / 1250] / (2 pi), m = 1125 / 1192",
           2,
           true,
           rothbart},
          []<class S>(const Arguments<S>&) { return freudenstein_1_3_5<S>(); }),
      rest_to_rest({"gutman-1-3",
                    {},
                    "x - 15 / (32 pi) sin(2 pi x) - 1 / (96 pi) sin(6 pi x)",
                    2,
                    true,
                    "Gutman, 1961"},
                   []<class S>(const Arguments<S>&) { return gutman_1_3<S>(); }),
  };
}

std::vector<Family> harmonic_series() {
  const auto level = [](const char* name, double default_value, const char* meaning) {
    return Parameter{name, "1", -100, 100, {default_value}, meaning};
  };
  constexpr double kPi = std::numbers::pi;
  return {
      rest_to_rest(
          {"fourier",
           {"sine series"},
           "x - sum a_n sin(2 pi n x) / (2 pi n), a_1 = 1 - the others",
           2,
           true,
           "Freudenstein, 1960",
           {detail::linear({"a", "1", -10, 10, {0, 0.05}, "a_2, a_3, ...: any number", true})}},
          []<class S>(const Arguments<S>& a) { return fourier<S>(a.list(0)); }),
      rest_to_rest(
          {"triple-harmonic",
           {},
           "s'' = h1 sin(2 pi x) + h2 sin(4 pi x) + h3 sin(6 pi x), "
           "h1/(2 pi) + h2/(4 pi) + h3/(6 pi) = 1",
           4,
           true,
           "MechDesigner help; default: no jerk at the ends and the crossover",
           {level("h1", 9 * kPi / 4, "level of the first harmonic"),
            level("h2", 0, "level of the second"), level("h3", -3 * kPi / 4, "level of the third")},
           {detail::sum_of_one(
               detail::rest_of_one("1 - h1/(2 pi) - h2/(4 pi) - h3/(6 pi)",
                                   {1 / (2 * kPi), 1 / (4 * kPi), 1 / (6 * kPi)}))}},
          []<class S>(const Arguments<S>& a) {
            return possible_triple_harmonic<S>(a.scalar(0), a.scalar(1), a.scalar(2));
          }),
  };
}

}  // namespace

std::vector<Family> harmonic_families() {
  std::vector<Family> all = fixed_harmonics();
  for (Family& family : harmonic_series()) all.push_back(std::move(family));
  return all;
}

}  // namespace camlaw
