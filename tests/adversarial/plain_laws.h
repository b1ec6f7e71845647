// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <memory>
#include <vector>

/// Motion laws from the textbook, in doubles. No code of kinematics/ is used: these are the
/// judge's. What vanishes at a rest is worked out from the end that it vanishes at, so that its
/// sign is right however near.
namespace camlaw::adversary {

/// Of one place: displacement, what is left of it (1 - s), and the derivatives.
struct Motion {
  double s = 0, r = 1, v = 0, a = 0, j = 0;
};

/// A law with its numbers: smooth pieces, each looked at from both of its ends: u from 0 to 1 and
/// w = 1 - u, each exact where it is small.
class PlainLaw {
 public:
  virtual ~PlainLaw() = default;
  virtual int pieces() const { return 1; }
  virtual double begin(int) const { return 0; }
  virtual double length(int) const { return 1; }
  virtual Motion at(int piece, double u, double w) const = 0;
};
using LawPtr = std::shared_ptr<const PlainLaw>;

/// s' = q (6 + 0.6 alpha - 3 alpha q), q = x (1 - x); theory (S3).
LawPtr polynomial_5(double alpha);
/// s' = A q^2 + (140 - 14 A / 3) q^3; theory (S4).
LawPtr polynomial_7(double a);
/// s'' = 6 P1(u) + c[0] P3(u) + c[1] P5(u) + ..., u = 1 - 2 x; theory (G1).
LawPtr legendre(const std::vector<double>& c);
/// s' = 1 - sum a_n cos(2 pi n x), a_1 = 1 - the others; theory (F1), (F2).
LawPtr fourier(const std::vector<double>& higher);
/// (1 - cos(pi x)) / 2.
LawPtr cosine();
/// The polynomial whose velocity is proportional to q^k: 1 the cubic, 2 the 3-4-5, 3 the 4-5-6-7.
LawPtr rest_polynomial(int k);
/// 2 x^2, then 1 - 2 (1 - x)^2.
LawPtr parabolic();
/// Constant acceleration over t1, constant velocity, constant deceleration over t2.
LawPtr trapezoidal_velocity(double t1, double t2);
/// Seven phases of acceleration: quarter sine up, constant, quarter cosine down, none, and the same
/// below zero. Of a fourth phase below zero the same formulas, which is not a law.
LawPtr universal(const std::array<double, 7>& durations);
/// A symmetric law whose acceleration changes sign at c instead of 1/2; theory (X1), (X2).
LawPtr crossed(LawPtr symmetric, double c);
/// B-spline with a knot of full multiplicity at 0 and 1; `knots` inside, each `multiplicity` times.
LawPtr spline(int degree, const std::vector<double>& knots, int multiplicity,
              const std::vector<double>& coefficients);

/// One term of a law in a file: p sin(w t) + q cos(w t), t = x.
struct Wave {
  double sine, cosine, frequency;
};
/// One piece over [0, 1]: a polynomial in x and waves.
LawPtr waves(std::vector<double> polynomial, std::vector<Wave> terms);

}  // namespace camlaw::adversary
