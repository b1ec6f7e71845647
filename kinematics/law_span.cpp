// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <bit>
#include <cstdint>

#include "kinematics/law.h"

/// The hot loop: s, v, a, j over many points. Points are taken in runs that lie in one piece, and
/// each kind of piece has a loop without branches.
namespace camlaw {
namespace {

/// Where results go; the loops always write all four.
struct Out {
  double *s, *v, *a, *j;
};

/// t to a power known to the compiler; 1 for none.
template <int Exponent>
double power(double t) {
  double result = 1;
  for (int i = 0; i < Exponent; ++i) result *= t;
  return result;
}

/// The derivative of order m of a polynomial whose coefficients below Low are zero, as at rest:
/// what becomes of term k is c[k] t^(k - m). Drawing out t^(Low - m) spares the work of the zeros.
template <int Degree, int Low, int m>
double derivative(const double* c, double t) {
  double sum = c[Degree];
  for (int k = Degree - 1; k >= std::max(Low, m); --k) sum = sum * t + c[k];
  return power<Low - m>(t) * sum;
}

/// Polynomial of a degree known to the compiler, its coefficients below Low zero; its origin is 0
/// where Low is not.
template <int Degree, int Low>
void run_polynomial(const Piece<double>& piece, const double* x, std::size_t n, Out out) {
  double c[4][Degree + 1]{};
  for (int k = 0; k <= Degree; ++k) c[0][k] = piece.polynomial[static_cast<std::size_t>(k)];
  for (int m = 1; m < 4; ++m) {
    for (int k = m; k <= Degree; ++k) c[m][k] = (k - m + 1) * c[m - 1][k];
  }
  const double origin = piece.origin;
  for (std::size_t i = 0; i < n; ++i) {
    const double t = Low > 0 ? x[i] : x[i] - origin;
    out.s[i] = derivative<Degree, Low, 0>(c[0], t);
    out.v[i] = derivative<Degree, Low, 1>(c[1], t);
    out.a[i] = derivative<Degree, Low, 2>(c[2], t);
    out.j[i] = derivative<Degree, Low, 3>(c[3], t);
  }
}

template <int Degree>
void run_degree(const Piece<double>& piece, const double* x, std::size_t n, Out out) {
  if constexpr (Degree >= 5) {  // the least that can rest at both ends without a jump of s''
    const double* c = piece.polynomial.data();
    if (piece.origin == 0 && c[0] == 0 && c[1] == 0 && c[2] == 0) {
      return c[3] == 0 ? run_polynomial<Degree, 4>(piece, x, n, out)
                       : run_polynomial<Degree, 3>(piece, x, n, out);
    }
  }
  run_polynomial<Degree, 0>(piece, x, n, out);
}

/// A linear part and one harmonic: the cycloid and every phase of the modified laws.
void run_harmonic(const Piece<double>& piece, const double* x, std::size_t n, Out out) {
  const Harmonic<double> h = piece.harmonics.front();
  const std::size_t terms = piece.polynomial.size();
  const double c0 = terms > 0 ? piece.polynomial[0] : 0, c1 = terms > 1 ? piece.polynomial[1] : 0;
  const double w = h.frequency, w2 = w * w;
  for (std::size_t i = 0; i < n; ++i) {
    const double t = x[i] - piece.origin;
    const double sine = std::sin(w * t), cosine = std::cos(w * t);
    const double wave = h.sine * sine + h.cosine * cosine;
    const double slope = w * (h.sine * cosine - h.cosine * sine);
    out.s[i] = c0 + c1 * t + wave;
    out.v[i] = c1 + slope;
    out.a[i] = -w2 * wave;
    out.j[i] = -w2 * slope;
  }
}

void run_general(const Piece<double>& piece, const double* x, std::size_t n, Out out) {
  for (std::size_t i = 0; i < n; ++i) {
    const auto d = derivatives<4>(piece, x[i]);
    out.s[i] = d[0];
    out.v[i] = d[1];
    out.a[i] = d[2];
    out.j[i] = d[3];
  }
}

void run_piece(const Piece<double>& piece, const double* x, std::size_t n, Out out) {
  const bool polynomial = piece.harmonics.empty() && piece.curves.empty();
  if (polynomial) {
    switch (piece.polynomial.size()) {
      case 2:
        return run_degree<1>(piece, x, n, out);
      case 3:
        return run_degree<2>(piece, x, n, out);
      case 4:
        return run_degree<3>(piece, x, n, out);
      case 5:
        return run_degree<4>(piece, x, n, out);
      case 6:
        return run_degree<5>(piece, x, n, out);
      case 7:
        return run_degree<6>(piece, x, n, out);
      case 8:
        return run_degree<7>(piece, x, n, out);
      case 9:
        return run_degree<8>(piece, x, n, out);
      case 10:
        return run_degree<9>(piece, x, n, out);
      default:
        break;
    }
  }
  if (piece.curves.empty() && piece.harmonics.size() == 1 && piece.polynomial.size() <= 2) {
    return run_harmonic(piece, x, n, out);
  }
  run_general(piece, x, n, out);
}

/// Points that are looked at together.
constexpr std::size_t kBlock = 32;

/// Whether kBlock points lie in [low, high), 0 <= low. Doubles from 0 up stand in the order of
/// their bits read as integers; the sign bit of a difference tells a point outside, a negative one
/// and a NaN too. Unlike comparisons of doubles this runs on two points at a time without AVX.
bool block_inside(const double* x, double low, double high) {
  const auto first = std::bit_cast<std::uint64_t>(low);
  const auto last = std::bit_cast<std::uint64_t>(high) - 1;
  std::uint64_t outside = 0;
  for (std::size_t k = 0; k < kBlock; ++k) {
    const auto bits = std::bit_cast<std::uint64_t>(x[k]);
    outside |= bits | (last - bits);
  }
  for (std::size_t k = 0; first != 0 && k < kBlock; ++k) {
    outside |= std::bit_cast<std::uint64_t>(x[k]) - first;
  }
  return outside >> 63 == 0;
}

/// How many points from the first on lie in [low, high).
std::size_t run_length(const double* x, std::size_t n, double low, double high) {
  const auto inside = [&](std::size_t i) { return x[i] >= low && x[i] < high; };
  std::size_t i = 0;
  while (i < std::min<std::size_t>(n, 4) && inside(i)) ++i;
  if (i < 4) return i;  // points out of order: no block to look for
  i = 0;
  while (i + kBlock <= n && block_inside(x + i, low, high)) i += kBlock;
  while (i < n && inside(i)) ++i;
  return i;
}

void check_length(const char* name, std::size_t length, std::size_t points) {
  if (length == 0 || length == points) return;
  throw std::invalid_argument(
      fmt::format("evaluate: {} has room for {} values, x has {} points", name, length, points));
}

}  // namespace

void evaluate(const Law<double>& law, std::span<const double> x, MotionSpans out) {
  check_length("s", out.s.size(), x.size());
  check_length("v", out.v.size(), x.size());
  check_length("a", out.a.size(), x.size());
  check_length("j", out.j.size(), x.size());
  // Results go through buffers where a span is not wanted.
  constexpr std::size_t kChunk = 512;
  double unwanted[4][kChunk];
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const auto& pieces = law.pieces();
  for (std::size_t i = 0; i < x.size();) {
    const bool inside = x[i] >= 0 && x[i] <= 1;
    const std::size_t index = inside ? law.piece_at(x[i], Side::Right) : 0;
    const Piece<double>& piece = pieces[index];
    const double high = index + 1 == pieces.size() ? std::nextafter(1.0, 2.0) : piece.end;
    std::size_t n = std::min(x.size() - i, kChunk);
    n = inside ? run_length(x.data() + i, n, index == 0 ? 0.0 : piece.begin, high) : 1;
    const auto place = [&](std::span<double> span, int buffer) {
      return span.empty() ? unwanted[buffer] : span.data() + i;
    };
    const Out target{place(out.s, 0), place(out.v, 1), place(out.a, 2), place(out.j, 3)};
    if (inside) {
      run_piece(piece, x.data() + i, std::max<std::size_t>(n, 1), target);
    } else {
      *target.s = *target.v = *target.a = *target.j = kNan;
    }
    i += std::max<std::size_t>(n, 1);
  }
}

}  // namespace camlaw
