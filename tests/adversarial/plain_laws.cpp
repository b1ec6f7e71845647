// SPDX-License-Identifier: MIT
#include "tests/adversarial/plain_laws.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>

namespace camlaw::adversary {
namespace {

using std::numbers::pi;

/// s and three derivatives of a polynomial.
Motion polynomial_at(const std::vector<double>& c, double t) {
  double s = 0, v = 0, a = 0, j = 0;
  for (std::size_t k = c.size(); k-- > 0;) {
    j = j * t + a;
    a = a * t + v;
    v = v * t + s;
    s = s * t + c[k];
  }
  return {s, 1 - s, v, 2 * a, 6 * j};
}

/// From the motion seen from the right end, where r stands for s and w for u.
Motion mirrored(const Motion& m) { return {1 - m.s, m.s, m.v, -m.a, m.j}; }

/// A law with s(x) + s(1 - x) = 1 from its left half.
class Symmetric : public PlainLaw {
 public:
  Motion at(int, double u, double w) const override { return u <= w ? half(u) : mirrored(half(w)); }

 private:
  virtual Motion half(double x) const = 0;
};

class SymmetricPolynomial final : public Symmetric {
 public:
  explicit SymmetricPolynomial(std::vector<double> c) : c_(std::move(c)) {}

 private:
  Motion half(double x) const override { return polynomial_at(c_, x); }
  std::vector<double> c_;
};

/// The polynomial s with s(0) = 0 and this velocity.
LawPtr from_velocity(const std::vector<double>& v) {
  std::vector<double> s{0};
  for (std::size_t k = 0; k < v.size(); ++k) s.push_back(v[k] / static_cast<double>(k + 1));
  return std::make_shared<SymmetricPolynomial>(s);
}

/// Coefficients of (x (1 - x))^k.
std::vector<double> q_power(int k) {
  std::vector<double> c(static_cast<std::size_t>(2 * k + 1), 0.0);
  double binomial = 1;
  for (int i = 0; i <= k; ++i) {
    c[static_cast<std::size_t>(k + i)] = i % 2 == 0 ? binomial : -binomial;
    binomial = binomial * (k - i) / (i + 1);
  }
  return c;
}

void add(std::vector<double>& to, double factor, const std::vector<double>& c) {
  to.resize(std::max(to.size(), c.size()), 0.0);
  for (std::size_t i = 0; i < c.size(); ++i) to[i] += factor * c[i];
}

/// Coefficients of P_n(1 - 2 x): (-1)^k C(n, k) C(n + k, k).
std::vector<double> shifted_legendre(int n) {
  std::vector<double> c;
  double term = 1;
  for (int k = 0; k <= n; ++k) {
    c.push_back(term);
    term *= -static_cast<double>(n - k) * (n + k + 1) / ((k + 1.0) * (k + 1.0));
  }
  return c;
}

/// t - sin t without cancellation.
double arc_less_sine(double t) {
  if (t > 0.7) return t - std::sin(t);
  double term = t * t * t / 6, sum = term;
  for (int k = 4; k < 24; k += 2) {
    term *= -t * t / (k * (k + 1.0));
    sum += term;
  }
  return sum;
}

class Fourier final : public Symmetric {
 public:
  explicit Fourier(std::vector<double> a) : a_(std::move(a)) {}

 private:
  Motion half(double x) const override {
    Motion m{0, 1, 0, 0, 0};
    for (std::size_t i = 0; i < a_.size(); ++i) {
      const double w = 2 * pi * static_cast<double>(i + 1), sine = std::sin(w * x / 2);
      m.s += a_[i] / w * arc_less_sine(w * x);
      m.v += a_[i] * 2 * sine * sine;
      m.a += a_[i] * w * std::sin(w * x);
      m.j += a_[i] * w * w * std::cos(w * x);
    }
    m.r = 1 - m.s;
    return m;
  }
  std::vector<double> a_;
};

class Cosine final : public Symmetric {
  Motion half(double x) const override {
    const double sine = std::sin(pi * x / 2), s = sine * sine;
    return {s, 1 - s, pi / 2 * std::sin(pi * x), pi * pi / 2 * std::cos(pi * x),
            -pi * pi * pi / 2 * std::sin(pi * x)};
  }
};

/// Pieces of polynomials: s from the left end of each, r from the right end.
class Pieces final : public PlainLaw {
 public:
  struct Piece {
    double begin, length;
    std::vector<double> left, right;  ///< powers of x - begin; of end - x
  };
  explicit Pieces(std::vector<Piece> list) : list_(std::move(list)) {}

  int pieces() const override { return static_cast<int>(list_.size()); }
  double begin(int k) const override { return list_[static_cast<std::size_t>(k)].begin; }
  double length(int k) const override { return list_[static_cast<std::size_t>(k)].length; }
  Motion at(int k, double u, double w) const override {
    const Piece& p = list_[static_cast<std::size_t>(k)];
    return u <= w ? polynomial_at(p.left, u * p.length)
                  : mirrored(polynomial_at(p.right, w * p.length));
  }

 private:
  std::vector<Piece> list_;
};

/// x - sin x, however small x is.
double sine_rest(double x) {
  if (std::abs(x) > 0.5) return x - std::sin(x);
  const double q = x * x;
  return x * q / 6 *
         (1 - q / 20 * (1 - q / 42 * (1 - q / 72 * (1 - q / 110 * (1 - q / 156 * (1 - q / 210))))));
}

/// Quarter sine, constant and quarter cosine of height `level` from rest, then straight on.
class Acceleration {
 public:
  Acceleration(std::array<double, 3> durations, double level) : d_(durations), level_(level) {
    for (int k = 0; k < 3; ++k) {
      const Motion end = at(k, d_[static_cast<std::size_t>(k)]);
      s_.push_back(end.s), v_.push_back(end.v);
    }
  }
  /// t from the phase's begin; the fourth phase is the straight one.
  Motion at(int phase, double t) const {
    const auto before = static_cast<std::size_t>(phase);
    const double s0 = phase > 0 ? s_[before - 1] : 0, v0 = phase > 0 ? v_[before - 1] : 0;
    if (phase == 3) return {s0 + v0 * t, 0, v0, 0, 0};
    const double d = d_[before];
    if (phase == 1) return {s0 + t * (v0 + level_ * t / 2), 0, v0 + level_ * t, level_, 0};
    if (d == 0) return {s0, 0, v0, phase == 0 ? 0 : level_, 0};
    const double w = pi / 2 / d, x = w * t, half = std::sin(x / 2), sine = std::sin(x);
    if (phase == 0) {
      return {level_ / (w * w) * sine_rest(x), 0, level_ / w * 2 * half * half, level_ * sine,
              level_ * w * std::cos(x)};
    }
    return {s0 + v0 * t + level_ / (w * w) * 2 * half * half, 0, v0 + level_ / w * sine,
            level_ * std::cos(x), -level_ * w * sine};
  }
  double speed() const { return v_.back(); }
  double stroke() const { return s_.back(); }

 private:
  std::array<double, 3> d_;
  double level_;
  std::vector<double> s_, v_;
};

class Universal final : public PlainLaw {
 public:
  explicit Universal(const std::array<double, 7>& d)
      : d_(d), up_({d[0], d[1], d[2]}, 1), down_({d[6], d[5], d[4]}, 1) {
    const double ratio = up_.speed() / down_.speed();
    const double level = 1 / (up_.stroke() + up_.speed() * d[3] + ratio * down_.stroke());
    up_ = Acceleration({d[0], d[1], d[2]}, level);
    down_ = Acceleration({d[6], d[5], d[4]}, level * ratio);
  }
  int pieces() const override { return 7; }
  double begin(int k) const override {
    double sum = 0;
    for (int i = 0; i < k; ++i) sum += length(i);
    return sum;
  }
  double length(int k) const override { return d_[static_cast<std::size_t>(k)]; }
  /// The accelerating half from the left end of the law, the other one from the right.
  Motion at(int k, double u, double w) const override {
    if (k > 3) return mirrored(down_.at(6 - k, w * length(k)));
    Motion m = up_.at(k, u * length(k));
    m.r = 1 - m.s;
    return m;
  }

 private:
  std::array<double, 7> d_;
  Acceleration up_, down_;
};

class Crossed final : public PlainLaw {
 public:
  Crossed(LawPtr law, double c) : law_(std::move(law)), c_(c) {}
  int pieces() const override { return 2; }
  double begin(int k) const override { return k == 0 ? 0 : c_; }
  double length(int k) const override { return k == 0 ? c_ : 1 - c_; }
  Motion at(int k, double u, double w) const override {
    // Each half of the law is stretched to its part and scaled so that the velocity stays.
    const double share = k == 0 ? 2 * c_ : 2 * (1 - c_);
    const Motion m = k == 0 ? law_->at(0, u / 2, 0.5 + w / 2) : law_->at(0, 0.5 + u / 2, w / 2);
    const double s = k == 0 ? share * m.s : 1 - share * m.r;
    const double r = k == 0 ? 1 - share * m.s : share * m.r;
    return {s, r, m.v, m.a / share, m.j / (share * share)};
  }

 private:
  LawPtr law_;
  double c_;
};

/// Taylor coefficients, by the piece's own x, at one end of a span: from the control points of all
/// derivatives and de Boor's algorithm at the knot. `from_right` mirrors the spline before.
class SplineTaylor {
 public:
  SplineTaylor(int degree, std::vector<double> knots, const std::vector<double>& c)
      : degree_(degree), knots_(std::move(knots)) {
    control_.push_back(c);
    for (int d = 1; d <= degree; ++d) {
      const auto& above = control_.back();
      std::vector<double> next;
      const int p = degree - d + 1;
      for (std::size_t i = 0; i + 1 < above.size(); ++i) {
        const double width =
            knots_[i + static_cast<std::size_t>(p + d)] - knots_[i + static_cast<std::size_t>(d)];
        next.push_back(width > 0 ? p * (above[i + 1] - above[i]) / width : 0);
      }
      control_.push_back(next);
    }
  }
  /// At the left end of the span knots[span], knots[span + 1].
  std::vector<double> at(std::size_t span) const {
    const double x = knots_[span];
    std::vector<double> taylor;
    double factorial = 1;
    for (int d = 0; d <= degree_; ++d) {
      const int p = degree_ - d;
      const auto& c = control_[static_cast<std::size_t>(d)];
      // The d-th derivative lives on the knots without d at each end.
      const std::size_t first = span - static_cast<std::size_t>(degree_);
      std::vector<double> b(c.begin() + static_cast<std::ptrdiff_t>(first),
                            c.begin() + static_cast<std::ptrdiff_t>(first) + p + 1);
      for (int level = 1; level <= p; ++level) {
        for (int i = p; i >= level; --i) {
          const std::size_t left = span - static_cast<std::size_t>(p - i);
          const double low = knots_[left];
          const double high = knots_[left + static_cast<std::size_t>(p - level + 1)];
          const double share = (x - low) / (high - low);
          auto& upper = b[static_cast<std::size_t>(i)];
          upper = (1 - share) * b[static_cast<std::size_t>(i - 1)] + share * upper;
        }
      }
      if (d > 0) factorial *= d;
      taylor.push_back(b.back() / factorial);
    }
    return taylor;
  }

 private:
  int degree_;
  std::vector<double> knots_;
  std::vector<std::vector<double>> control_;
};

class Waves final : public PlainLaw {
 public:
  Waves(std::vector<double> c, std::vector<Wave> terms)
      : c_(std::move(c)), terms_(std::move(terms)) {}
  Motion at(int, double u, double) const override {
    const auto known = known_.find(u);
    if (known != known_.end()) return known->second;
    Motion m = polynomial_at(c_, u);
    // From one frequency to the next the angle turns by the same where they are evenly spaced;
    // every sixteenth is worked out anew, so that no rounding gathers.
    const double step = terms_.size() > 1 ? terms_[1].frequency - terms_[0].frequency : 0;
    const double turn_sine = std::sin(step * u), turn_cosine = std::cos(step * u);
    double sine = 0, cosine = 1;
    for (std::size_t i = 0; i < terms_.size(); ++i) {
      const Wave& t = terms_[i];
      const double w = t.frequency;
      const bool even =
          i % 16 != 0 && std::abs(w - terms_[i - 1].frequency - step) <= 1e-15 * std::abs(w);
      const double before = sine;
      sine = even ? sine * turn_cosine + cosine * turn_sine : std::sin(w * u);
      cosine = even ? cosine * turn_cosine - before * turn_sine : std::cos(w * u);
      m.s += t.sine * sine + t.cosine * cosine;
      m.v += w * (t.sine * cosine - t.cosine * sine);
      m.a -= w * w * (t.sine * sine + t.cosine * cosine);
      m.j -= w * w * w * (t.sine * cosine - t.cosine * sine);
    }
    m.r = 1 - m.s;
    return known_[u] = m;
  }

 private:
  std::vector<double> c_;
  std::vector<Wave> terms_;
  mutable std::unordered_map<double, Motion> known_;  ///< hundreds of waves are slow
};

}  // namespace

LawPtr polynomial_5(double alpha) {
  std::vector<double> v;
  add(v, 6 + 0.6 * alpha, q_power(1));
  add(v, -3 * alpha, q_power(2));
  return from_velocity(v);
}

LawPtr polynomial_7(double a) {
  std::vector<double> v;
  add(v, a, q_power(2));
  add(v, 140 - 14 * a / 3, q_power(3));
  return from_velocity(v);
}

LawPtr legendre(const std::vector<double>& c) {
  std::vector<double> a;
  add(a, 6, shifted_legendre(1));
  for (std::size_t i = 0; i < c.size(); ++i)
    add(a, c[i], shifted_legendre(3 + 2 * static_cast<int>(i)));
  std::vector<double> v{0};
  for (std::size_t k = 0; k < a.size(); ++k) v.push_back(a[k] / static_cast<double>(k + 1));
  return from_velocity(v);
}

LawPtr fourier(const std::vector<double>& higher) {
  std::vector<double> a{1};
  for (const double next : higher) {
    a.front() -= next;
    a.push_back(next);
  }
  return std::make_shared<Fourier>(a);
}

LawPtr cosine() { return std::make_shared<Cosine>(); }

LawPtr rest_polynomial(int k) {
  constexpr double kScale[] = {1, 6, 30, 140, 630};  // one over the integral of q^k
  std::vector<double> v;
  add(v, kScale[k], q_power(k));
  return from_velocity(v);
}

LawPtr parabolic() {
  return std::make_shared<Pieces>(std::vector<Pieces::Piece>{{0, 0.5, {0, 0, 2}, {0.5, 2, -2}},
                                                             {0.5, 0.5, {0.5, 2, -2}, {0, 0, 2}}});
}

LawPtr trapezoidal_velocity(double t1, double t2) {
  const double b = 1 / (1 - (t1 + t2) / 2), middle = 1 - t1 - t2;
  const double first = b * t1 / 2, last = b * t2 / 2;
  // r of the first piece from its right end, s of the last from its left one; between, straight.
  return std::make_shared<Pieces>(
      std::vector<Pieces::Piece>{{0, t1, {0, 0, b / t1 / 2}, {1 - first, b, -b / t1 / 2}},
                                 {t1, middle, {first, b}, {last, b}},
                                 {1 - t2, t2, {1 - last, b, -b / t2 / 2}, {0, 0, b / t2 / 2}}});
}

LawPtr universal(const std::array<double, 7>& durations) {
  return std::make_shared<Universal>(durations);
}

LawPtr crossed(LawPtr symmetric, double c) {
  return std::make_shared<Crossed>(std::move(symmetric), c);
}

LawPtr spline(int degree, const std::vector<double>& knots, int multiplicity,
              const std::vector<double>& coefficients) {
  const auto ends = static_cast<std::size_t>(degree + 1);
  std::vector<double> full(ends, 0.0);
  for (const double knot : knots)
    full.insert(full.end(), static_cast<std::size_t>(multiplicity), knot);
  full.insert(full.end(), ends, 1.0);
  std::vector<double> back(full.rbegin(), full.rend()),
      rest(coefficients.rbegin(), coefficients.rend());
  for (double& knot : back) knot = 1 - knot;
  for (double& c : rest) c = 1 - c;
  const SplineTaylor left(degree, full, coefficients), right(degree, back, rest);
  std::vector<Pieces::Piece> list;
  for (std::size_t i = 0; i + 1 < full.size(); ++i) {
    if (!(full[i + 1] > full[i])) continue;
    list.push_back({full[i], full[i + 1] - full[i], left.at(i), right.at(full.size() - 2 - i)});
  }
  return std::make_shared<Pieces>(list);
}

LawPtr waves(std::vector<double> polynomial, std::vector<Wave> terms) {
  return std::make_shared<Waves>(std::move(polynomial), std::move(terms));
}

}  // namespace camlaw::adversary
