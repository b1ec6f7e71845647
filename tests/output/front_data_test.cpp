// SPDX-License-Identifier: MIT
#include "output/report/front_data.h"

#include <catch2/catch.hpp>

namespace camlaw::cli::front_data_test {
namespace {

TEST_CASE("designs of a page have as many samples as there is room for", "[report]") {
  // 100 bytes a sample and 2000 beside them; 200 designs in 2.2 MB have 11000 each.
  const auto bytes = [](int samples) { return 2000.0 + 100 * samples; };
  CHECK(samples_within(2.2e6, 200, bytes(12), bytes(240)) == 90);
  CHECK(samples_within(2.2e6, 20, bytes(12), bytes(240)) == 240);
  CHECK(samples_within(1e5, 200, bytes(12), bytes(240)) == 12);
  CHECK(samples_within(1, 1, 5, 5) == 240);  // nothing is drawn
}

}  // namespace
}  // namespace camlaw::cli::front_data_test
