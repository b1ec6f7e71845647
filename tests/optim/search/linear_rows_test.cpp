// SPDX-License-Identifier: MIT
#include "optim/search/linear_rows.h"

#include <catch2/catch.hpp>
#include <limits>
#include <memory>
#include <vector>

#include "machines/model/affine_row.h"

namespace camlaw::optim::linear_rows_test {
namespace {

/// constant + slopes * u.
Function line(double constant, std::vector<double> slopes, std::vector<std::size_t> inputs) {
  return {std::move(inputs),
          std::make_shared<problems::AffineRow>(constant, std::move(slopes), 0.0, 0.0),
          Shape::Linear};
}

}  // namespace

TEST_CASE("rows that say the same are known, whatever their sign and inputs without a slope",
          "[exchange]") {
  const std::vector<double> at{1, 2, 3, 4};
  LinearRows rows(at, 1e-9);
  CHECK(rows.add(line(1, {2, -3}, {1, 2}), 1, 1e-9));
  CHECK_FALSE(rows.add(line(1, {2, -3}, {1, 2}), 1, 1e-9));
  CHECK_FALSE(rows.add(line(-1, {-2, 3}, {1, 2}), -1, 1e-9));  // a return that mirrors the rise
  CHECK_FALSE(rows.add(line(1, {0, 2, -3, 0}, {0, 1, 2, 3}), 1, 1e-9));
  CHECK_FALSE(rows.add(line(1 + 1e-11, {2, -3 + 1e-11}, {1, 2}), 1, 1e-9));
}

TEST_CASE("rows that differ in value, slope, sign or input are not", "[exchange]") {
  const std::vector<double> at{1, 2, 3, 4};
  LinearRows rows(at, 1e-9);
  CHECK(rows.add(line(1, {2, -3}, {1, 2}), 1, 1e-9));
  CHECK(rows.add(line(1.001, {2, -3}, {1, 2}), 1, 1e-9));
  CHECK(rows.add(line(1, {2, -3.001}, {1, 2}), 1, 1e-9));
  CHECK(rows.add(line(1, {2, -3}, {1, 2}), -1, 1e-9));
  CHECK(rows.add(line(4, {2, -3}, {1, 3}), 1, 1e-9));
  // Other slopes that happen to give the same value there.
  CHECK(rows.add(line(-4 - 2, {3, -2}, {1, 2}), 1, 1e-9));
}

TEST_CASE("rows without slopes, or that are not numbers, are all kept", "[exchange]") {
  const std::vector<double> at{1, 2};
  LinearRows rows(at, 1e-9);
  for (int i = 0; i < 2; ++i) {
    CHECK(rows.add(line(1, {0, 0}, {0, 1}), 1, 1e-9));
    CHECK(rows.add(line(std::numeric_limits<double>::quiet_NaN(), {1, 0}, {0, 1}), 1, 1e-9));
  }
}

}  // namespace camlaw::optim::linear_rows_test
