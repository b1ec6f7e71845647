// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <bit>
#include <cstdint>

#include "kinematics/law.h"

/// The hot loop: s, v, a, j over many points. A piece takes points for as long as they lie in it,
/// and each kind of piece has a loop of its own.
namespace camlaw {
namespace {

/// Where results go; the loops always write all four.
struct Out {
  double *s, *v, *a, *j;
};

/// The points [low, high) that a piece takes, 0 <= low.
struct Limits {
  double low, high;

  bool hold(double x) const { return x >= low && x < high; }
};

/// Points that are looked at together.
constexpr std::size_t kBlock = 32;

/// Calls point(i) for a block; whether all its points lie within the limits. Doubles from 0 up
/// stand in the order of their bits read as integers, so the sign bit of a difference tells a point
/// outside, a negative one and a NaN too. Unlike comparisons of doubles this runs on two points at
/// a time without AVX, in the same loop as the arithmetic.
template <bool FromZero, class Point>
bool run_block(Limits limits, const double* x, std::size_t i, Point point) {
  const auto first = std::bit_cast<std::uint64_t>(limits.low);
  const auto last = std::bit_cast<std::uint64_t>(limits.high) - 1;
  std::uint64_t outside = 0;
  for (std::size_t k = i; k < i + kBlock; ++k) {
    const auto bits = std::bit_cast<std::uint64_t>(x[k]);
    outside |= bits | (last - bits);
    if constexpr (!FromZero) outside |= bits - first;
    point(k);
  }
  return outside >> 63 == 0;
}

/// Calls point(i) for i = 0, 1, ... while x[i] lies within the limits; how many did. At most kBlock
/// points beyond are computed for nothing, to be overwritten by the piece that holds them.
template <class Point>
std::size_t run_blocks(Limits limits, const double* x, std::size_t n, Point point) {
  std::size_t i = 0;
  if (n >= kBlock && limits.hold(x[1]) && limits.hold(x[2])) {  // else out of order: no blocks
    if (limits.low == 0) {
      while (i + kBlock <= n && run_block<true>(limits, x, i, point)) i += kBlock;
    } else {
      while (i + kBlock <= n && run_block<false>(limits, x, i, point)) i += kBlock;
    }
  }
  for (; i < n && limits.hold(x[i]); ++i) point(i);
  return i;
}

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
std::size_t run_polynomial(const Piece<double>& piece, Limits limits, const double* __restrict x,
                           std::size_t n, Out out) {
  double c[4][Degree + 1]{};
  for (int k = 0; k <= Degree; ++k) c[0][k] = piece.polynomial[static_cast<std::size_t>(k)];
  for (int m = 1; m < 4; ++m) {
    for (int k = m; k <= Degree; ++k) c[m][k] = (k - m + 1) * c[m - 1][k];
  }
  const double origin = piece.origin;
  double* __restrict s = out.s, * __restrict v = out.v, * __restrict a = out.a, * __restrict j = out.j;
  return run_blocks(limits, x, n, [&](std::size_t i) {
    const double t = Low > 0 ? x[i] : x[i] - origin;
    s[i] = derivative<Degree, Low, 0>(c[0], t);
    v[i] = derivative<Degree, Low, 1>(c[1], t);
    a[i] = derivative<Degree, Low, 2>(c[2], t);
    j[i] = derivative<Degree, Low, 3>(c[3], t);
  });
}

template <int Degree>
std::size_t run_degree(const Piece<double>& piece, Limits limits, const double* x, std::size_t n,
                       Out out) {
  if constexpr (Degree >= 5) {  // the least that can rest at both ends without a jump of s''
    const double* c = piece.polynomial.data();
    if (piece.origin == 0 && c[0] == 0 && c[1] == 0 && c[2] == 0) {
      return c[3] == 0 ? run_polynomial<Degree, 4>(piece, limits, x, n, out)
                       : run_polynomial<Degree, 3>(piece, limits, x, n, out);
    }
  }
  return run_polynomial<Degree, 0>(piece, limits, x, n, out);
}

/// A linear part and one harmonic: the cycloid and every phase of the modified laws.
std::size_t run_harmonic(const Piece<double>& piece, Limits limits, const double* x, std::size_t n,
                         Out out) {
  const Harmonic<double> h = piece.harmonics.front();
  const std::size_t terms = piece.polynomial.size();
  const double c0 = terms > 0 ? piece.polynomial[0] : 0, c1 = terms > 1 ? piece.polynomial[1] : 0;
  const double w = h.frequency, w2 = w * w;
  std::size_t i = 0;
  for (; i < n && limits.hold(x[i]); ++i) {
    const double t = x[i] - piece.origin;
    const double sine = std::sin(w * t), cosine = std::cos(w * t);
    const double wave = h.sine * sine + h.cosine * cosine;
    const double slope = w * (h.sine * cosine - h.cosine * sine);
    out.s[i] = c0 + c1 * t + wave;
    out.v[i] = c1 + slope;
    out.a[i] = -w2 * wave;
    out.j[i] = -w2 * slope;
  }
  return i;
}

std::size_t run_general(const Piece<double>& piece, Limits limits, const double* x, std::size_t n,
                        Out out) {
  std::size_t i = 0;
  for (; i < n && limits.hold(x[i]); ++i) {
    const auto d = derivatives<4>(piece, x[i]);
    out.s[i] = d[0];
    out.v[i] = d[1];
    out.a[i] = d[2];
    out.j[i] = d[3];
  }
  return i;
}

/// Takes points while they lie in the piece; how many did, at least the first.
std::size_t run_piece(const Piece<double>& piece, Limits limits, const double* x, std::size_t n,
                      Out out) {
  const bool polynomial = piece.harmonics.empty() && piece.curves.empty();
  if (polynomial) {
    switch (piece.polynomial.size()) {
      case 2:
        return run_degree<1>(piece, limits, x, n, out);
      case 3:
        return run_degree<2>(piece, limits, x, n, out);
      case 4:
        return run_degree<3>(piece, limits, x, n, out);
      case 5:
        return run_degree<4>(piece, limits, x, n, out);
      case 6:
        return run_degree<5>(piece, limits, x, n, out);
      case 7:
        return run_degree<6>(piece, limits, x, n, out);
      case 8:
        return run_degree<7>(piece, limits, x, n, out);
      case 9:
        return run_degree<8>(piece, limits, x, n, out);
      case 10:
        return run_degree<9>(piece, limits, x, n, out);
      default:
        break;
    }
  }
  if (piece.curves.empty() && piece.harmonics.size() == 1 && piece.polynomial.size() <= 2) {
    return run_harmonic(piece, limits, x, n, out);
  }
  return run_general(piece, limits, x, n, out);
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
    const auto place = [&](std::span<double> span, int buffer) {
      return span.empty() ? unwanted[buffer] : span.data() + i;
    };
    const Out target{place(out.s, 0), place(out.v, 1), place(out.a, 2), place(out.j, 3)};
    if (!(x[i] >= 0 && x[i] <= 1)) {
      *target.s = *target.v = *target.a = *target.j = kNan;
      ++i;
      continue;
    }
    const std::size_t index = law.piece_at(x[i], Side::Right);
    const bool is_last = index + 1 == pieces.size();
    const Limits limits{pieces[index].begin,
                        is_last ? std::nextafter(1.0, 2.0) : pieces[index].end};
    i += run_piece(pieces[index], limits, x.data() + i, std::min(x.size() - i, kChunk), target);
  }
}

}  // namespace camlaw
