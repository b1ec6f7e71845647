// SPDX-License-Identifier: MIT
#include "kinematics/law.h"

#include <fmt/format.h>

/// The hot loop: s, v, a, j over many points. Points are taken in runs that lie in one piece, and
/// each kind of piece has a loop without branches.
namespace camlaw {
namespace {

/// Where results go; the loops always write all four.
struct Out {
  double *s, *v, *a, *j;
};

/// Polynomial of a degree known to the compiler, with ready coefficients for every derivative.
template <int Degree>
void run_polynomial(const std::vector<double>& c, double origin, const double* x, std::size_t n,
                    Out out) {
  double s[Degree + 1], v[Degree + 1]{}, a[Degree + 1]{}, j[Degree + 1]{};
  for (int k = 0; k <= Degree; ++k) s[k] = c[static_cast<std::size_t>(k)];
  for (int k = 1; k <= Degree; ++k) v[k - 1] = k * s[k];
  for (int k = 1; k < Degree; ++k) a[k - 1] = k * v[k];
  for (int k = 1; k + 1 < Degree; ++k) j[k - 1] = k * a[k];
  for (std::size_t i = 0; i < n; ++i) {
    const double t = x[i] - origin;
    double sum_s = s[Degree], sum_v = 0, sum_a = 0, sum_j = 0;
    for (int k = Degree - 1; k >= 0; --k) sum_s = sum_s * t + s[k];
    for (int k = Degree - 1; k >= 0; --k) sum_v = sum_v * t + v[k];
    for (int k = Degree - 2; k >= 0; --k) sum_a = sum_a * t + a[k];
    for (int k = Degree - 3; k >= 0; --k) sum_j = sum_j * t + j[k];
    out.s[i] = sum_s;
    out.v[i] = sum_v;
    out.a[i] = sum_a;
    out.j[i] = sum_j;
  }
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
      case 2: return run_polynomial<1>(piece.polynomial, piece.origin, x, n, out);
      case 3: return run_polynomial<2>(piece.polynomial, piece.origin, x, n, out);
      case 4: return run_polynomial<3>(piece.polynomial, piece.origin, x, n, out);
      case 5: return run_polynomial<4>(piece.polynomial, piece.origin, x, n, out);
      case 6: return run_polynomial<5>(piece.polynomial, piece.origin, x, n, out);
      case 7: return run_polynomial<6>(piece.polynomial, piece.origin, x, n, out);
      case 8: return run_polynomial<7>(piece.polynomial, piece.origin, x, n, out);
      case 9: return run_polynomial<8>(piece.polynomial, piece.origin, x, n, out);
      case 10: return run_polynomial<9>(piece.polynomial, piece.origin, x, n, out);
      default: break;
    }
  }
  if (piece.curves.empty() && piece.harmonics.size() == 1 && piece.polynomial.size() <= 2) {
    return run_harmonic(piece, x, n, out);
  }
  run_general(piece, x, n, out);
}

/// How many points from the first on lie in [low, high).
std::size_t run_length(const double* x, std::size_t n, double low, double high) {
  constexpr std::size_t kBlock = 32;
  std::size_t i = 0;
  while (i + kBlock <= n) {  // whole blocks without branches
    int outside = 0;
    for (std::size_t k = 0; k < kBlock; ++k) outside += !(x[i + k] >= low) | !(x[i + k] < high);
    if (outside != 0) break;
    i += kBlock;
  }
  while (i < n && x[i] >= low && x[i] < high) ++i;
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
