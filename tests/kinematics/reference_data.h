// SPDX-License-Identifier: MIT
#pragma once

#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "kinematics/shape.h"
#include "tests/paths.h"

/// What the tests of laws run over: members of the families beside the defaults, and tables of
/// constants read from files.
namespace camlaw::testing {

/// What a law is known to be before it is built.
struct Expected {
  std::string ends;  ///< VDI 2143 pair
  int continuity;
  bool symmetric;
  double begin = 0, end = 1;  ///< s(0) and s(1)
};

/// A law by the name that find_law takes.
struct KnownMember {
  std::string name;
  Expected expected;
};

/// Members of every family with parameters, inside their ranges and at ends of them. The class of a
/// law whose crossover is moved is 2 at most where its jerk does not vanish there: the two parts
/// are stretched differently.
inline std::vector<KnownMember> known_members() {
  return {
      // a(0) = 6 + 0.6 alpha vanishes at alpha = -10 alone: the 3-4-5, class 2.
      {"polynomial-5 alpha=-10", {"R-R", 2, true}},
      {"polynomial-5 alpha=-5 crossover=0.5", {"R-R", 1, true}},
      {"polynomial-5 alpha=0", {"R-R", 1, true}},
      {"polynomial-5 alpha=3", {"R-R", 1, true}},
      {"polynomial-5 alpha=3 crossover=0.62", {"R-R", 1, false}},
      // j(0) = 2 A: class 3 at A = 0 alone.
      {"polynomial-7 A=-40", {"R-R", 2, true}},
      {"polynomial-7 A=0", {"R-R", 3, true}},
      {"polynomial-7 A=30 crossover=0.3", {"R-R", 2, false}},
      {"legendre c=-6", {"R-R", 2, true}},                // c3 = 0.6 alpha: the 3-4-5 again
      {"legendre c=0.5,-0.3,0.2,0.1", {"R-R", 1, true}},  // order 9
      {"legendre c=-1.5,0.4,0.3,-0.2,0.1,-0.1,0.05,-0.02", {"R-R", 1, true}},  // order 17
      {"legendre c=-1.5,0.4,0.3,-0.2 crossover=0.3", {"R-R", 1, false}},
      {"cubic crossover=0.3", {"R-R", 1, false}},
      {"poly-4-5-6-7 crossover=0.62", {"R-R", 2, false}},
      {"poly-3-5-7 crossover=0.3", {"R-R", 2, false}},
      {"cosine crossover=0.3", {"R-R", 1, false}},
      {"cycloidal crossover=0.62", {"R-R", 2, false}},
      {"parabolic crossover=0.62", {"R-R", 1, false}},
      {"modified-sine crossover=0.3", {"R-R", 2, false}},
      {"modified-trapezoid crossover=0.62", {"R-R", 2, false}},
      {"half-ellipse-velocity crossover=0.62", {"R-R", 1, false}},
      {"half-ellipse-acceleration crossover=0.3", {"R-R", 2, false}},
      {"stoddart exponents=4,8,12,16", {"R-R", 3, false}},
      {"stoddart exponents=3,4.5,6", {"R-R", 2, false}},
      {"stoddart exponents=2.5,4,5.5", {"R-R", 2, false}},  // jerk without bound at 0
      // Two exponents leave a(1) free: a turn, whose jerk does not vanish.
      {"stoddart exponents=2.5,3.5", {"R-U", 2, false}},
      {"stoddart exponents=3,4.5,6 crossover=0.62", {"R-R", 2, false}},
      {"fourier a=0.1,-0.05", {"R-R", 2, true}},
      {"fourier a=-0.08,0.03,0.01,-0.005 crossover=0.3", {"R-R", 2, false}},
      {"triple-harmonic h1=5.1968 h2=1.769 h3=0.6057", {"R-R", 2, true}},
      // Jerk and, by symmetry, s'''' vanish at the crossover, so that class 4 stays.
      {"triple-harmonic crossover=0.3", {"R-R", 4, false}},
      {"trapezoidal-velocity t1=0.2 t2=0.4", {"R-R", 1, false}},
      {"trapezoidal-acceleration ramp=0.1 constant=0.15", {"R-R", 2, true}},
      {"trapezoidal-acceleration ramp=0.1 constant=0.15 crossover=0.3", {"R-R", 2, false}},
      {"s-curve B=1.8 C=6", {"R-R", 2, true}},
      {"s-curve B=1.6 C=5.8 D=58.5", {"R-R", 2, true}},
      {"scca a=0.2 b=0.3 c=0.4", {"R-R", 2, true}},
      {"scca a=0 b=0.5 c=0.3", {"R-R", 1, true}},
      {"scca a=0.25 b=0 c=0.5", {"R-R", 2, true}},
      {"universal d1=0.05 d2=0.3 d3=0.05 d4=0.02 d5=0.1 d6=0.2", {"R-R", 2, false}},
      {"universal d1=0.1 d2=0.1 d3=0.2 d4=0 d5=0.2 d6=0.2", {"R-R", 2, false}},
      {"universal crossover=0.62", {"R-R", 2, false}},
      {"elliptic n=0.6", {"R-R", 1, true}},
      {"elliptic n=0.8", {"R-R", 1, true}},
      {"elliptic n=1", {"R-R", 1, true}},
      {"elliptic n=2", {"R-R", 1, true}},
      {"elliptic n=0.8 crossover=0.3", {"R-R", 1, false}},
      {"inclined-sinusoid angle=60", {"R-R", 2, true}},
      {"inclined-sinusoid angle=75 crossover=0.62", {"R-R", 2, false}},
      {"inclined-sinusoid angle=90", {"R-R", 2, true}},
      {"inclined-sinusoid angle=110", {"R-R", 2, true}},
      // A knot m times leaves class degree - m. Two equal coefficients at an end make v = 0 there,
      // three a = 0 too.
      {"b-spline degree=2 knots=0.5 coefficients=0,0,1,1", {"U-U", 1, true}},
      {"b-spline degree=3 knots=0.3,0.3,0.6 coefficients=0,0,0.2,0.5,0.9,1.05,1",
       {"U-B", 1, false}},
      {"b-spline degree=4 knots=0.25,0.5,0.5,0.5,0.75 "
       "coefficients=0,0,0,0.2,0.45,0.55,0.8,1,1,1",
       {"R-R", 1, true}},
      {"b-spline degree=4 knots=0.2,0.35,0.6 coefficients=-0.1,0,0.1,0.5,0.7,1.2,1.2,0.9",
       {"B-B", 3, false, -0.1, 0.9}},
      {"table x=0,0.4,1 s=0,0.3,1", {"B-B", kSmooth, false}},  // one parabola
      {"table x=0,0.15,0.3,0.45,0.6,0.8,0.9,1 s=0,0.02,0.11,0.38,0.71,0.94,0.99,1",
       {"B-B", 4, false}},
      // Double knots of degree 5 leave class 3, but the jerk at the turns does not vanish: class 2.
      {"table x=0,0.2,0.5,0.7,0.85,1 s=0,0.05,0.5,0.85,0.97,1 v=0,0.7,2,1.3,0.4,0",
       {"U-U", 2, false}},
  };
}

/// Rows of a comma-separated file with a line of names; fields may stand in quotes.
using Row = std::map<std::string, std::string>;

inline std::vector<std::string> split_fields(const std::string& line) {
  std::vector<std::string> fields{""};
  bool quoted = false;
  for (const char c : line) {
    if (c == '"')
      quoted = !quoted;
    else if (c == ',' && !quoted)
      fields.emplace_back();
    else if (c != '\r')
      fields.back() += c;
  }
  return fields;
}

/// Reads a table by its path from the root of the repository.
inline std::vector<Row> read_table(const std::string& path) {
  std::ifstream file(testing::source(path));
  if (!file) throw std::runtime_error("cannot read " + path);
  std::string line;
  std::getline(file, line);
  const auto names = split_fields(line);
  std::vector<Row> rows;
  while (std::getline(file, line)) {
    const auto fields = split_fields(line);
    if (fields.size() != names.size()) throw std::runtime_error(path + ": bad row: " + line);
    Row row;
    for (std::size_t i = 0; i < names.size(); ++i) row[names[i]] = fields[i];
    rows.push_back(row);
  }
  return rows;
}

}  // namespace camlaw::testing
