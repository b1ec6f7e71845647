// SPDX-License-Identifier: MIT
#include "kinematics/laws/polynomial.h"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <map>
#include <mutex>

#include "kinematics/laws/families.h"
#include "kinematics/laws/free_ends.h"

namespace camlaw {

namespace detail {

const std::vector<double>& legendre_taylor(int n, double middle) {
  using Real = boost::multiprecision::cpp_bin_float_100;
  static std::map<std::pair<int, double>, std::vector<double>> kept;
  static std::mutex guard;
  const std::lock_guard lock(guard);
  const auto found = kept.find({n, middle});
  if (found != kept.end()) return found->second;
  const Real u = 1 - 2 * Real(middle);
  std::vector<Real> previous{1}, current{u, 1};
  if (n == 0) current = previous;
  for (int k = 1; k < n; ++k) {
    std::vector<Real> next(current.size() + 1, Real(0));
    for (std::size_t i = 0; i < current.size(); ++i) {
      next[i] += (2 * k + 1) * u * current[i] / (k + 1);
      next[i + 1] += (2 * k + 1) * current[i] / (k + 1);
    }
    for (std::size_t i = 0; i < previous.size(); ++i) next[i] -= k * previous[i] / (k + 1);
    previous = std::move(current);
    current = std::move(next);
  }
  std::vector<double> nearest;
  for (const Real& c : current) nearest.push_back(static_cast<double>(c));
  return kept[{n, middle}] = std::move(nearest);
}

}  // namespace detail

namespace {

using detail::linear;
using detail::rest_to_rest;

std::vector<Family> whole_polynomials() {
  const char* rule = "Stoddart's rule";
  return {
      {"constant-velocity",
       {"straight line", "linear", "Gerade"},
       "x",
       {},
       "G-G",
       kSmooth,
       true,
       "VDI 2143",
       []<class S>(const Arguments<S>&) { return constant_velocity<S>(); }},
      rest_to_rest(
          {"cubic", {"0000"}, "3x^2 - 2x^3", 1, true, "the 0000 of the spine-cutter study"},
          []<class S>(const Arguments<S>&) { return cubic<S>(); }),
      rest_to_rest({"poly-3-4-5",
                    {"3-4-5", "3-4-5 polynomial", "Polynom 5. Grades",
                     "third-degree parabola of acceleration", "Складна парабола третього степеня"},
                    "10x^3 - 15x^4 + 6x^5",
                    2,
                    true,
                    "VDI 2143"},
                   []<class S>(const Arguments<S>&) { return poly_3_4_5<S>(); }),
      rest_to_rest({"poly-4-5-6-7",
                    {"4-5-6-7", "4-5-6-7 polynomial", "Polynom 7. Grades"},
                    "35x^4 - 84x^5 + 70x^6 - 20x^7",
                    3,
                    true,
                    "Rothbart (ed.), Cam Design Handbook, 2004"},
                   []<class S>(const Arguments<S>&) { return poly_4_5_6_7<S>(); }),
      rest_to_rest({"poly-5-6-7-8-9",
                    {"5-6-7-8-9 polynomial", "Polynom 9. Grades"},
                    "126x^5 - 420x^6 + 540x^7 - 315x^8 + 70x^9",
                    4,
                    true,
                    rule},
                   []<class S>(const Arguments<S>&) { return poly_5_6_7_8_9<S>(); }),
      rest_to_rest({"poly-3-5-7", {}, "(35x^3 - 42x^5 + 15x^7) / 8", 2, false, rule},
                   []<class S>(const Arguments<S>&) {
                     return stoddart<S>({3, 5, 7});
                   }),
      rest_to_rest({"poly-4-6-8-10", {}, "10x^4 - 20x^6 + 15x^8 - 4x^10", 3, false, rule},
                   []<class S>(const Arguments<S>&) {
                     return stoddart<S>({4, 6, 8, 10});
                   }),
      {"rothbart-8",
       {"eighth-degree polynomial"},
       "6.09755x^3 - 20.78040x^5 + 26.73155x^6 - 13.60965x^7 + 2.56095x^8",
       {},
       "R-U",
       2,
       false,
       "Rothbart (ed.), Cam Design Handbook, 2004, p. 100",
       []<class S>(const Arguments<S>&) { return rothbart_8<S>(); }},
      {"quick-return",
       {"throw"},
       "10x^4 - 14x^5 + 5x^6",
       {},
       "R-U",
       3,
       false,
       "MechDesigner help",
       []<class S>(const Arguments<S>&) { return quick_return<S>(); }},
  };
}

std::vector<Family> study_polynomials() {
  const char* study = "the spine-cutter study";
  const Parameter alpha{"alpha", "1",  -30,
                        30,      {-3}, "0 is the cubic, -10 the 3-4-5; a(0) = 6 + 0.6 alpha"};
  const Parameter big_a{"A", "1", -100, 200, {48}, "0 is the 4-5-6-7, 30 the 3-4-5"};
  const char* formula5 = "s' = q (6 + 0.6 alpha - 3 alpha q), q = x (1 - x)";
  const char* formula7 = "s' = A q^2 + (140 - 14 A / 3) q^3, q = x (1 - x)";
  const auto member5 = [&](const char* name, double value) {
    return rest_to_rest(
        {name, {}, formula5, 1, true, study},
        [value]<class S>(const Arguments<S>&) { return polynomial_5<S>(number<S>(value)); });
  };
  const auto member7 = [&](const char* name, double value) {
    return rest_to_rest(
        {name, {}, formula7, 2, true, study},
        [value]<class S>(const Arguments<S>&) { return polynomial_7<S>(number<S>(value)); });
  };
  return {
      rest_to_rest(
          {"polynomial-5", {"Поліном 5-ї степені"}, formula5, 1, true, study, {linear(alpha)}},
          []<class S>(const Arguments<S>& a) { return polynomial_5<S>(a.scalar(0)); }),
      rest_to_rest(
          {"polynomial-7", {"Поліном 7-ї степені"}, formula7, 2, true, study, {linear(big_a)}},
          []<class S>(const Arguments<S>& a) { return polynomial_7<S>(a.scalar(0)); }),
      member5("polynomial-5 alpha=-3", -3),
      member5("polynomial-5 alpha=-5", -5),
      member7("polynomial-7 A=48", 48),
      member7("polynomial-7 A=6", 6),
  };
}

std::vector<Family> free_polynomials() {
  return {
      rest_to_rest(
          {"legendre",
           {"symmetric polynomial"},
           "s'' = 6 P1(u) + c3 P3(u) + c5 P5(u) + ..., u = 1 - 2x, P the Legendre polynomials",
           1,
           true,
           "the general symmetric polynomial; c3 = 0.6 alpha is polynomial-5",
           {linear({"c", "1", -1000, 1000, {-1.8, 0.2}, "c3, c5, c7, ...: any odd order", true})}},
          []<class S>(const Arguments<S>& a) { return legendre<S>(a.list(0)); }),
      rest_to_rest({"stoddart",
                    {"pqrs", "polydyne"},
                    "sum of C_p x^p, C_p = product of q / (q - p) over the other exponents q",
                    2,
                    true,
                    "Stoddart, Polydyne cam design, 1953",
                    {{"exponents",
                      "1",
                      2,
                      100,
                      {3, 4, 5},
                      "two or more, different; need not be integers",
                      true,
                      true}}},
                   []<class S>(const Arguments<S>& a) {
                     std::vector<double> exponents;
                     for (const S& p : a.list(0)) exponents.push_back(value_of(p));
                     return possible_stoddart<S>(std::move(exponents));
                   }),
  };
}

constexpr const char *kBoundary5 = "boundary-5", *kBoundary7 = "boundary-7";
constexpr const char* kDisplacementLetter = "s";

/// s, v, a, j at an end, as many as wanted.
std::vector<Parameter> end_values(int count, char end, double displacement) {
  const std::array<const char*, 4> letters{kDisplacementLetter, "v", "a", "j"};
  const std::array<const char*, 4> meanings{"displacement", "velocity s'", "acceleration s''",
                                            "jerk s'''"};
  std::vector<Parameter> result;
  for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
    result.push_back(linear({std::string(letters[k]) + end,
                             "1",
                             -1e4,
                             1e4,
                             {k == 0 ? displacement : 0.0},
                             std::string(meanings[k]) + " at x = " + end}));
  }
  return result;
}

/// The polynomial with `count` values given at either end.
Family boundary_family(int count, std::string name, std::string alias, std::string formula) {
  std::vector<Parameter> parameters = end_values(count, '0', 0);
  for (Parameter& parameter : end_values(count, '1', 1)) parameters.push_back(std::move(parameter));
  return {std::move(name),
          {std::move(alias)},
          std::move(formula),
          std::move(parameters),
          "by parameters",
          count - 1,
          true,
          "VDI 2143",
          [count]<class S>(const Arguments<S>& a) {
            std::vector<S> begin, end;
            for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
              begin.push_back(a.scalar(k));
              end.push_back(a.scalar(k + static_cast<std::size_t>(count)));
            }
            return possible_boundary_polynomial<S>(begin, end);
          }};
}

std::vector<Family> boundary_polynomials() {
  return {boundary_family(3, kBoundary5, "Polynom 5. Grades mit Randwerten",
                          "the polynomial of degree 5 with s, s', s'' given at both ends"),
          boundary_family(4, kBoundary7, "Polynom 7. Grades mit Randwerten",
                          "the polynomial of degree 7 with s, s', s'', s''' given at both ends")};
}

}  // namespace

bool has_free_ends(const Family& family) {
  return family.name == kBoundary5 || family.name == kBoundary7;
}

bool is_end_displacement(std::string_view parameter) {
  return parameter.size() == 2 && parameter.starts_with(kDisplacementLetter);
}

std::vector<Family> polynomial_families() {
  std::vector<Family> all = whole_polynomials();
  for (auto* group : {study_polynomials, free_polynomials, boundary_polynomials}) {
    for (Family& family : group()) all.push_back(std::move(family));
  }
  return all;
}

}  // namespace camlaw
