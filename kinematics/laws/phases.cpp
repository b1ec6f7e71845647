// SPDX-License-Identifier: MIT
#include "kinematics/laws/phases.h"

#include <fmt/format.h>

#include "kinematics/laws/families.h"

namespace camlaw {
namespace {

using detail::rest_of_one, detail::rest_to_rest;

Parameter fraction(const char* name, double default_value, const char* meaning) {
  return {name, "1", 0, 1, {default_value}, meaning};
}

/// A peak that an S-curve is made of; older files call it by one letter.
Parameter s_curve_peak(const char* name, const char* also, double high, std::vector<double> value,
                       const char* meaning) {
  const bool list = value.empty();  // the jerk may be left out
  return {.name = name,
          .unit = "1",
          .low = 1,
          .high = high,
          .default_value = std::move(value),
          .meaning = meaning,
          .list = list,
          .also = also};
}

/// The peak jerk of an S-curve's arguments; left out, it makes 1/B + B/C + C/D = 1.
template <class S>
S s_curve_jerk(const Arguments<S>& a) {
  const S one = number<S>(1), &B = a.scalar(0), &C = a.scalar(1);
  return a.list(2).empty() ? C / (one - one / B - B / C) : a.list(2).front();
}

/// Its ramps last C / D, the constant acceleration B / C - C / D, the constant velocity 2 / B - 1.
std::vector<Room> s_curve_rooms() {
  const auto sum = []<class S>(const Arguments<S>& a) {
    const S one = number<S>(1);
    return one - one / a.scalar(0) - a.scalar(0) / a.scalar(1) - a.scalar(1) / s_curve_jerk(a);
  };
  return {
      {"1 - 1/B - B/C",
       []<class S>(const Arguments<S>& a) {
         const S one = number<S>(1);
         return one - one / a.scalar(0) - a.scalar(0) / a.scalar(1);
       },
       false},
      {"B/C - C/D",
       []<class S>(const Arguments<S>& a) {
         return a.scalar(0) / a.scalar(1) - a.scalar(1) / s_curve_jerk(a);
       },
       false},
      {"2/B - 1",
       []<class S>(const Arguments<S>& a) { return number<S>(2) / a.scalar(0) - number<S>(1); },
       false},
      {"1 - 1/B - B/C - C/D",
       [sum]<class S>(const Arguments<S>& a) { return a.list(2).empty() ? number<S>(0) : sum(a); },
       false, true}};
}

std::vector<Family> straight_phases() {
  constexpr double kThird = 1.0 / 3.0;
  return {
      rest_to_rest({"parabolic",
                    {"constant acceleration", "quadratische Parabel", "Parabel"},
                    "2x^2 | 1 - 2(1 - x)^2",
                    1,
                    true,
                    "VDI 2143"},
                   []<class S>(const Arguments<S>&) { return parabolic<S>(); }),
      rest_to_rest(
          {"trapezoidal-velocity",
           {},
           "constant acceleration t1, constant velocity, constant deceleration t2",
           1,
           true,
           "the least C_a for its C_v: C_a = C_v^2 / (C_v - 1) where t1 = t2",
           {fraction("t1", kThird, "accelerating"), fraction("t2", kThird, "decelerating")},
           {rest_of_one("1 - t1 - t2", {1, 1})}},
          []<class S>(const Arguments<S>& a) {
            return possible_trapezoidal_velocity<S>(a.scalar(0), a.scalar(1));
          }),
      rest_to_rest(
          {"trapezoidal-acceleration",
           {"Beschleunigungstrapez"},
           "acceleration: linear ramps, constant between them, zero for the rest, mirrored",
           2,
           true,
           "VDI 2143",
           {fraction("ramp", 0.125, "duration of each of the four ramps"),
            fraction("constant", 0.25, "duration of each phase of constant acceleration")},
           {rest_of_one("1 - 4 ramp - 2 constant", {4, 2})}},
          []<class S>(const Arguments<S>& a) {
            return possible_trapezoidal_acceleration<S>(a.scalar(0), a.scalar(1));
          }),
      rest_to_rest(
          {"s-curve",
           {"seven-phase S-curve", "double S"},
           "seven phases of constant jerk with peaks B = C_v, C = C_a, D = C_j; 1/B + B/C + C/D = "
           "1",
           2,
           true,
           "drive controllers; lambda = 1",
           {s_curve_peak("C_v", "B", 100, {1.6}, "peak velocity"),
            s_curve_peak("C_a", "C", 1e4, {5.8}, "peak acceleration"),
            s_curve_peak("C_j", "D", 1e6, {},
                         "peak jerk; if omitted, it follows from C_v and C_a")},
           s_curve_rooms()},
          []<class S>(const Arguments<S>& a) -> Possible<Law<S>> {
            if (a.list(2).size() > 1) return Impossible{"C_j takes one value at most"};
            const double B = value_of(a.scalar(0)), C = value_of(a.scalar(1));
            if (a.list(2).empty() && !(C * (B - 1) > B * B)) {
              return Impossible{fmt::format(
                  "C_a must be above C_v^2/(C_v - 1), which is {:.6g} for C_v = {:.6g}, and is "
                  "{:.6g}: no jerk reaches it",
                  B * B / (B - 1), B, C)};
            }
            return possible_s_curve<S>(a.scalar(0), a.scalar(1), s_curve_jerk(a));
          }),
  };
}

/// A named member of scca, its fractions over one denominator.
Family scca_member(std::string name, std::vector<std::string> aliases, std::string formula,
                   std::string source, std::array<double, 4> f) {
  return rest_to_rest(
      {std::move(name), std::move(aliases), std::move(formula), 2, true, std::move(source)},
      [f]<class S>(const Arguments<S>&) { return scca_of<S>(f[0], f[1], f[2], f[3]); });
}

std::vector<Family> modified_laws() {
  const char* handbook = "VDI 2143; Hikari Cam table";
  const char* help = "MechDesigner help";
  return {
      scca_member("modified-trapezoid",
                  {"MT", "mod. trapezoid", "modifiziertes Beschleunigungstrapez"},
                  "acceleration quarter sine 1/8, constant 1/4, quarter cosine 1/8, mirrored",
                  handbook, {1, 2, 1, 4}),
      scca_member("modified-sine",
                  {"MS", "mod. sine", "modifizierte Sinuslinie", "modifizierte Sinoide"},
                  "acceleration sine over 1/8, 3/4, 1/8", handbook, {1, 0, 3, 4}),
      scca_member("modified-sine-cv20", {"MCV20"}, "scca a=0.2 b=0 c=0.6", help, {1, 0, 3, 5}),
      scca_member("modified-sine-cv33", {"MCV33"}, "scca a=1/6 b=0 c=1/2", help, {1, 0, 3, 6}),
      scca_member("modified-sine-cv50", {"MCV50"}, "scca a=0.125 b=0 c=0.375",
                  "tarukichi cam curve page", {1, 0, 3, 8}),
      scca_member("modified-sine-cv66", {"MCV66"}, "scca a=1/12 b=0 c=1/4", help, {1, 0, 3, 12}),
      scca_member("modified-sine-cv75", {"MCV75"}, "scca a=0.0625 b=0 c=0.1875", help,
                  {1, 0, 3, 16}),
      scca_member("lazy-modified-trapezoid", {}, "scca a=b=c=1/3", help, {1, 1, 1, 3}),
      scca_member("cycloidal-cv50", {}, "half-sine ramps 1/4, constant velocity 1/2", help,
                  {1, 0, 1, 4}),
  };
}

std::vector<Family> trigonometric_phases() {
  return {
      rest_to_rest({"scca",
                    {"sine-constant-cosine acceleration"},
                    "acceleration: quarter sine a/2, constant b/2, quarter cosine c/2, zero "
                    "1-a-b-c, mirrored",
                    2,
                    true,
                    "Norton, Cam Design and Manufacturing Handbook",
                    {fraction("a", 0.3, "duration of both sine ramps, as a fraction of the whole"),
                     fraction("b", 0.2, "duration of both phases of constant acceleration"),
                     fraction("c", 0.3, "duration of both cosine ramps")},
                    {rest_of_one("1 - a - b - c", {1, 1, 1})}},
                   []<class S>(const Arguments<S>& a) {
                     return possible_scca<S>(a.scalar(0), a.scalar(1), a.scalar(2));
                   }),
      rest_to_rest(
          {"universal",
           {"universal cam curve", "Makino"},
           "acceleration: quarter sine d1, constant d2, quarter cosine d3, zero d4, the same below "
           "zero d5, d6, d7 = 1 - the others",
           2,
           false,
           "Makino",
           {fraction("d1", 0.1, "sine ramp up"), fraction("d2", 0.1, "constant acceleration"),
            fraction("d3", 0.15, "cosine ramp down"), fraction("d4", 0.05, "constant velocity"),
            fraction("d5", 0.2, "sine ramp of the deceleration"),
            fraction("d6", 0.2, "constant deceleration")},
           {rest_of_one("1 - d1 - d2 - d3 - d4 - d5 - d6", {1, 1, 1, 1, 1, 1})}},
          []<class S>(const Arguments<S>& a) {
            std::vector<S> d;
            S rest = number<S>(1);
            for (std::size_t i = 0; i < 6; ++i) {
              d.push_back(a.scalar(i));
              rest = rest - a.scalar(i);
            }
            d.push_back(rest);
            return possible_universal<S>(d);
          }),
  };
}

}  // namespace

std::vector<Family> phase_families() {
  std::vector<Family> all = straight_phases();
  for (auto* group : {modified_laws, trigonometric_phases}) {
    for (Family& family : group()) all.push_back(std::move(family));
  }
  return all;
}

}  // namespace camlaw
