// SPDX-License-Identifier: MIT
#include "kinematics/spans/law_span.h"

#include <fmt/format.h>

#include <array>
#include <optional>

#include "numerics/lanes/sine_cosine.h"

/// s, v, a, j over many points. What a point's result is depends on the law and the point alone, to
/// the last bit, never on its neighbours.
namespace camlaw {
namespace {

/// Points that are looked at together.
constexpr std::size_t kChunk = 512;

double end_of(const Law<double>& law, std::size_t piece) {
  const bool is_last = piece + 1 == law.pieces().size();
  return is_last ? std::nextafter(1.0, 2.0) : law.pieces()[piece].end;
}

/// Whether the loops take the piece's harmonics.
bool has_small_angles(const Piece<double>& piece) {
  const double reach = 1 + std::abs(piece.origin);
  return std::all_of(piece.harmonics.begin(), piece.harmonics.end(), [&](const auto& h) {
    return std::abs(h.frequency) * reach <= lanes::kLargestAngle;
  });
}

// ---------------------------------------------------------------------------------------------

/// A law of several pieces as PieceRows.
struct Table {
  std::vector<double> ends, rows;
  std::size_t degree = 0;
  bool wave = false;

  PieceRows view() const { return {ends.data(), ends.size(), rows.data(), degree, wave}; }
};

/// Returns nothing if the law has a single piece, or a piece that does not fit a row.
std::optional<Table> table_of(const Law<double>& law) {
  if (law.pieces().size() < 2) return {};
  Table table;
  for (const Piece<double>& piece : law.pieces()) {
    if (!piece.is_data() || piece.harmonics.size() > 1 || !has_small_angles(piece)) return {};
    table.wave = table.wave || !piece.harmonics.empty();
    if (!piece.polynomial.empty()) {
      table.degree = std::max(table.degree, piece.polynomial.size() - 1);
    }
  }
  if (table.degree > (table.wave ? 3 : 6)) return {};
  for (std::size_t k = 0; k < law.pieces().size(); ++k) {
    const Piece<double>& piece = law.pieces()[k];
    std::array<double, PieceRows::kNumbers> row{};
    std::copy(piece.polynomial.begin(), piece.polynomial.end(), row.begin());
    row[table.wave ? 4 : 7] = piece.origin;
    for (const auto& h : piece.harmonics) row[5] = h.sine, row[6] = h.cosine, row[7] = h.frequency;
    table.rows.insert(table.rows.end(), row.begin(), row.end());
    table.ends.push_back(end_of(law, k));
  }
  table.rows.resize(table.rows.size() + PieceRows::kNumbers,
                    std::numeric_limits<double>::quiet_NaN());
  return table;
}

// ---------------------------------------------------------------------------------------------

/// A law's pieces as the loops take them, where they do.
class PlainPieces {
 public:
  explicit PlainPieces(const Law<double>& law) : law_(law) {
    std::size_t waves = 0;
    for (const auto& piece : law.pieces()) waves += piece.harmonics.size();
    harmonics_.reserve(3 * waves);  // the pieces point into it
    for (std::size_t k = 0; k < law.pieces().size(); ++k) {
      const Piece<double>& piece = law.pieces()[k];
      is_plain_.push_back(piece.is_data() && has_small_angles(piece));
      numbers_.push_back({piece.begin, end_of(law, k), piece.origin, piece.polynomial.data(),
                          piece.polynomial.size(), harmonics_.data() + harmonics_.size(),
                          piece.harmonics.size()});
      for (const auto& h : piece.harmonics) {
        harmonics_.insert(harmonics_.end(), {h.sine, h.cosine, h.frequency});
      }
    }
  }

  /// Evaluates at most kChunk points, piece by piece.
  void motion(const SpanKernels& kernels, const double* x, std::size_t n, MotionRows out) const {
    for (std::size_t i = 0; i < n;) {
      if (x[i] >= 0 && x[i] <= 1) {
        i += run(kernels, law_.piece_at(x[i], Side::Right), x + i, n - i, out.from(i));
        continue;
      }
      for (double* row : {out.s, out.v, out.a, out.j}) {
        row[i] = std::numeric_limits<double>::quiet_NaN();
      }
      ++i;
    }
  }

 private:
  /// Evaluates the leading points that lie in the piece and returns their number.
  std::size_t run(const SpanKernels& kernels, std::size_t index, const double* x, std::size_t n,
                  MotionRows out) const {
    const PieceNumbers& numbers = numbers_[index];
    if (is_plain_[index]) return kernels.motion(numbers, x, n, out);
    std::size_t i = 0;
    for (; i < n && x[i] >= numbers.low && x[i] < numbers.high; ++i) {
      const auto d = derivatives<4>(law_.pieces()[index], x[i]);
      out.s[i] = d[0];
      out.v[i] = d[1];
      out.a[i] = d[2];
      out.j[i] = d[3];
    }
    return i;
  }

  const Law<double>& law_;
  std::vector<PieceNumbers> numbers_;
  std::vector<bool> is_plain_;
  std::vector<double> harmonics_;  ///< sine, cosine, frequency of each piece's
};

void check_length(const char* name, std::size_t length, std::size_t points) {
  if (length == 0 || length == points) return;
  throw std::invalid_argument(
      fmt::format("evaluate: {} has room for {} values, x has {} points", name, length, points));
}

}  // namespace

void evaluate_by(const SpanKernels& kernels, const Law<double>& law, std::span<const double> x,
                 MotionSpans out) {
  check_length("s", out.s.size(), x.size());
  check_length("v", out.v.size(), x.size());
  check_length("a", out.a.size(), x.size());
  check_length("j", out.j.size(), x.size());
  const std::optional<Table> table = table_of(law);
  const std::optional<PlainPieces> pieces = table ? std::nullopt : std::optional<PlainPieces>(law);
  std::array<double, kChunk> unwanted[4];
  for (std::size_t i = 0; i < x.size(); i += kChunk) {
    const auto row = [&](std::span<double> span, std::size_t instead) {
      return span.empty() ? unwanted[instead].data() : span.data() + i;
    };
    const MotionRows target{row(out.s, 0), row(out.v, 1), row(out.a, 2), row(out.j, 3)};
    const std::size_t n = std::min(x.size() - i, kChunk);
    if (table) {
      kernels.motion_by_rows(table->view(), &x[i], n, target);
    } else {
      pieces->motion(kernels, &x[i], n, target);
    }
  }
}

void evaluate(const Law<double>& law, std::span<const double> x, MotionSpans out) {
  evaluate_by(*span_kernels().front(), law, x, out);
}

}  // namespace camlaw
