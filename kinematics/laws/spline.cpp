// SPDX-License-Identifier: MIT
#include "kinematics/laws/spline.h"

#include <fmt/format.h>

#include <Eigen/SparseLU>

#include "kinematics/laws/families.h"

namespace camlaw {
namespace {

/// (FL3) The polar form of a polynomial of this degree, of coefficients about 0, at as many places:
/// each power k becomes the mean of all products of k of them.
double polar_form(const std::vector<double>& polynomial, const std::vector<double>& places) {
  std::vector<double> products{1};  // elementary symmetric functions of the places so far
  for (const double place : places) {
    products.push_back(0);
    for (std::size_t k = products.size() - 1; k > 0; --k) products[k] += place * products[k - 1];
  }
  double result = 0, count = 1;  // count: of products of k places
  for (std::size_t k = 0; k < std::min(polynomial.size(), products.size()); ++k) {
    result += polynomial[k] * products[k] / count;
    count *= static_cast<double>(places.size() - k) / static_cast<double>(k + 1);
  }
  return result;
}

}  // namespace

std::vector<double> spline_coefficients(const Law<double>& law, int degree,
                                        const std::vector<double>& interior) {
  const std::vector<double> knots = detail::clamped(degree, interior);
  const auto p = static_cast<std::size_t>(degree);
  std::vector<double> result;
  for (std::size_t i = 0; i + p + 1 < knots.size(); ++i) {
    std::size_t longest = i;  // of the spans in which the coefficient counts
    for (std::size_t k = i; k <= i + p; ++k) {
      if (knots[k + 1] - knots[k] > knots[longest + 1] - knots[longest]) longest = k;
    }
    const double middle = 0.5 * (knots[longest] + knots[longest + 1]);
    const Piece<double>& piece = law.pieces()[law.piece_at(middle, Side::Right)];
    std::vector<double> places;
    for (std::size_t k = i + 1; k <= i + p; ++k) places.push_back(knots[k] - piece.origin);
    result.push_back(polar_form(piece.polynomial, places));
  }
  return result;
}

}  // namespace camlaw

namespace camlaw::detail {

std::optional<Impossible> bad_spline(int degree, const std::vector<double>& interior,
                                     std::size_t coefficients) {
  if (degree < 1) return Impossible{"degree must be at least 1"};
  const std::size_t wanted = static_cast<std::size_t>(degree) + 1 + interior.size();
  if (coefficients != wanted) {
    return Impossible{
        fmt::format("coefficients: {} given, degree {} with {} interior knots needs {}",
                    coefficients, degree, interior.size(), wanted)};
  }
  std::size_t repeats = 0;
  for (std::size_t i = 0; i < interior.size(); ++i) {
    if (!(interior[i] > 0 && interior[i] < 1)) {
      return Impossible{fmt::format("knots: {:.6g} is not strictly between 0 and 1", interior[i])};
    }
    if (i > 0 && interior[i] < interior[i - 1]) {
      return Impossible{"knots: they must not decrease"};
    }
    repeats = i > 0 && interior[i] == interior[i - 1] ? repeats + 1 : 1;
    if (repeats > static_cast<std::size_t>(degree)) {
      return Impossible{
          fmt::format("knots: {:.6g} is repeated more than degree {} allows", interior[i], degree)};
    }
  }
  return {};
}

Possible<TableSpline> table_spline(const std::vector<double>& x, std::size_t samples,
                                   std::size_t velocities) {
  if (x.size() != samples || (velocities != 0 && velocities != samples)) {
    return Impossible{
        fmt::format("table: x, s and v must have the same length, but have {}, {} and {}", x.size(),
                    samples, velocities)};
  }
  if (samples < 2 || x.front() != 0 || x.back() != 1) {
    return Impossible{"table: x must run from 0 to 1 over at least two samples"};
  }
  for (std::size_t i = 1; i < samples; ++i) {
    if (!(x[i] > x[i - 1])) {
      return Impossible{
          fmt::format("table: x must increase, but {:.6g} follows {:.6g}", x[i], x[i - 1])};
    }
  }
  TableSpline spline{5, {}, samples, velocities != 0};
  const std::size_t conditions = samples + velocities;
  if (conditions < 6) {
    spline.degree = static_cast<int>(conditions) - 1;
  } else if (!spline.with_velocity) {
    spline.knots.assign(x.begin() + 3, x.end() - 3);
  } else {
    for (std::size_t i = 1; i + 1 < samples; ++i) {
      // Conditions number 2n, coefficients 6 + knots: the outer two knots stay single.
      const int copies = samples == 3 ? 0 : i == 1 || i + 2 == samples ? 1 : 2;
      spline.knots.insert(spline.knots.end(), static_cast<std::size_t>(copies), x[i]);
    }
  }
  return spline;
}

namespace {

/// Values (order 0) or slopes (order 1) at x of the basis functions that do not vanish there.
std::vector<double> basis_row(const TableSpline& spline, const std::vector<double>& knots,
                              std::size_t span, int order, double x) {
  const auto p = static_cast<std::size_t>(spline.degree);
  const std::size_t count = knots.size() - p - 1;
  std::vector<double> row;
  for (std::size_t i = span - p; i <= span; ++i) {
    std::vector<double> unit(count, 0.0);
    unit[i] = 1;
    if (order == 0) {
      row.push_back(de_boor(span, spline.degree, 0, knots, unit, x));
    } else {
      row.push_back(de_boor(span, spline.degree - 1, 1, knots,
                            derivative_coefficients(spline.degree, 0, knots, unit), x));
    }
  }
  return row;
}

Eigen::SparseMatrix<double> collocation(const TableSpline& spline, const std::vector<double>& x) {
  const std::vector<double> knots = clamped(spline.degree, spline.knots);
  const auto p = static_cast<std::size_t>(spline.degree);
  const auto size = static_cast<Eigen::Index>(knots.size() - p - 1);
  const int orders = spline.with_velocity ? 2 : 1;
  std::vector<Eigen::Triplet<double>> entries;
  std::size_t span = p;
  for (std::size_t i = 0; i < x.size(); ++i) {
    while (span + p + 2 < knots.size() && knots[span + 1] <= x[i]) ++span;
    for (int order = 0; order < orders; ++order) {
      const auto row = basis_row(spline, knots, span, order, x[i]);
      for (std::size_t k = 0; k < row.size(); ++k) {
        entries.emplace_back(static_cast<int>(i) * orders + order, static_cast<int>(span - p + k),
                             row[k]);
      }
    }
  }
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace

Possible<std::vector<std::vector<double>>> solve_table(
    const TableSpline& spline, const std::vector<double>& x,
    const std::vector<std::vector<double>>& columns) {
  const Eigen::SparseMatrix<double> matrix = collocation(spline, x);
  Eigen::SparseLU<Eigen::SparseMatrix<double>> lu(matrix);
  if (lu.info() != Eigen::Success) {
    return Impossible{"table: the samples do not determine a spline"};
  }
  std::vector<std::vector<double>> result;
  for (const auto& column : columns) {
    const Eigen::Map<const Eigen::VectorXd> b(column.data(),
                                              static_cast<Eigen::Index>(column.size()));
    Eigen::VectorXd c = lu.solve(b);
    c += lu.solve(b - matrix * c);  // one step of refinement
    result.emplace_back(c.data(), c.data() + c.size());
  }
  return result;
}

}  // namespace camlaw::detail

namespace camlaw {

std::vector<Family> spline_families() {
  using detail::linear;
  const std::vector<double> tenths{0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1};
  const std::vector<double> rise{0,       0.00856, 0.05792, 0.16308, 0.31744, 0.5,
                                 0.68256, 0.83692, 0.94208, 0.99144, 1};  // of the 3-4-5
  const char* de_boor = "de Boor, A Practical Guide to Splines";
  return {
      {"b-spline",
       {"spline"},
       "sum of coefficients times B-splines, clamped at 0 and 1",
       {{"degree", "1", 1, 25, {5}, "degree of the polynomial pieces", false, true},
        {"knots",
         "1",
         0,
         1,
         {},
         "knots inside (0, 1), in increasing order; a repeated one lowers the continuity",
         true},
        linear({"coefficients",
                "1",
                -100,
                100,
                {0, 0, 0, 1, 1, 1},
                "as many as degree + 1 + number of knots",
                true})},
       "by parameters",
       2,
       true,
       de_boor,
       []<class S>(const Arguments<S>& a) {
         return possible_b_spline<S>(static_cast<int>(value_of(a.scalar(0))), a.list(1), a.list(2));
       }},
      {"table",
       {"sampled law"},
       "the spline through samples of s, or of s and v",
       {{"x", "1", 0, 1, tenths, "abscissas of the samples, from 0 to 1", true, true},
        linear({"s", "1", -10, 10, rise, "displacements", true}),
        linear({"v", "1", -1000, 1000, {}, "velocities s', where known", true})},
       "by parameters",
       2,
       true,
       de_boor,
       []<class S>(const Arguments<S>& a) {
         std::vector<double> x;
         for (const S& place : a.list(0)) x.push_back(value_of(place));
         return possible_table<S>(x, a.list(1), a.list(2));
       }},
  };
}

}  // namespace camlaw
