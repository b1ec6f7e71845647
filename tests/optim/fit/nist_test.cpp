// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <fstream>

#include "tests/paths.h"
#include "tests/sets/nist/nist_models.h"
#include "tests/sets/nist/nist_runs.h"
#include "tests/temporary_folder.h"

namespace camlaw::sets::nist_test {
namespace {

/// Where NIST's files lie; empty where there are none.
std::filesystem::path folder() {
  const char* const named = std::getenv("CAMLAW_NIST");
  const std::filesystem::path place =
      named ? std::filesystem::path(named)
            : std::filesystem::path(testing::source()) / ".." / "shared" / "nist";
  return std::filesystem::is_directory(place) ? place : std::filesystem::path();
}

double sum_of_squares(const optim::Residuals& residuals, const std::vector<double>& p) {
  std::vector<double> r(residuals.count());
  residuals.evaluate(p, r, {});
  double sum = 0;
  for (const double v : r) sum += v * v;
  return sum;
}

}  // namespace

TEST_CASE("fits of NIST's sets have the certified digits", "[fit][nist]") {
  if (folder().empty()) {
    WARN("skipped: NIST's files are not here; CAMLAW_NIST names their folder");
    return;
  }
  const std::vector<NistRun> runs = nist_runs(folder());
  REQUIRE(runs.size() == 54);
  double sum = 0;
  for (const NistRun& run : runs) {
    INFO(run.name << " from start " << run.start);
    CHECK(run.parameters >= 10);
    CHECK(run.result.converged);
    CHECK(run.result.reason.empty());
    // The residuals of Lanczos1 are rounding of data with 14 digits: they have three digits.
    CHECK(run.deviations >= (run.name == "Lanczos1" ? 2.5 : 9.5));
    CHECK(run.sum_of_squares >= (run.name == "Lanczos1" ? 2.5 : 9.5));
    sum += run.parameters;
  }
  CHECK(sum / 54 >= 10.5);
}

TEST_CASE("certified parameters of NIST's sets give the certified sums", "[fit][nist]") {
  if (folder().empty()) {
    WARN("skipped: NIST's files are not here; CAMLAW_NIST names their folder");
    return;
  }
  for (const std::string& name : nist_names()) {
    INFO(name);
    const NistSet set = read_nist(folder() / (name + ".dat"));
    const double sum = sum_of_squares(*nist_residuals(set), set.certified);
    // Parameters of 11 digits leave Lanczos1 with residuals of 1e-11.
    if (name != "Lanczos1") CHECK(agreeing_digits(sum, set.sum_of_squares) > 6);
  }
}

TEST_CASE("a file of NIST's form is read", "[fit]") {
  const testing::Folder files;
  const auto path = files / "Misra1a.dat";
  std::ofstream(path) << "Data:          1 Response\r\n"
                         "               y = b1*(1-exp[-b2*x])  +  e\r\n"
                         "  b1 =   500  250   2.3E+02  2.7E+00\r\n"
                         "  b2 =   0.0001  0.0005  5.5E-04  7.2E-06\r\n"
                         "Residual Sum of Squares:    1.2E-01\r\n"
                         "Data:   y       x\r\n"
                         "      10.07E0      77.6E0\r\n"
                         "       .5E0      114.9E0\r\n";
  const NistSet set = read_nist(path);
  CHECK(set.name == "Misra1a");
  CHECK(set.starts[0] == std::vector<double>{500, 0.0001});
  CHECK(set.starts[1] == std::vector<double>{250, 0.0005});
  CHECK(set.certified == std::vector<double>{230, 5.5e-4});
  CHECK(set.deviations == std::vector<double>{2.7, 7.2e-6});
  CHECK(set.sum_of_squares == 0.12);
  CHECK(set.y == std::vector<double>{10.07, 0.5});
  REQUIRE(set.x.size() == 1);
  CHECK(set.x[0] == std::vector<double>{77.6, 114.9});
  CHECK_THROWS_AS(read_nist(files / "none.dat"), std::invalid_argument);
  NistSet other = set;
  other.name = "Misra9";
  CHECK_THROWS_WITH(nist_residuals(other), "'Misra9' is none of NIST's sets");
}

TEST_CASE("digits agree as far as the relative error is small", "[fit]") {
  CHECK(agreeing_digits(1.001, 1) == Approx(3));
  CHECK(agreeing_digits(-2, -2) == 11);
  CHECK(agreeing_digits(5, 1) == 0);
  CHECK(agreeing_digits(std::nan(""), 1) == 0);
}

}  // namespace camlaw::sets::nist_test
