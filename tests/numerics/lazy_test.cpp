// SPDX-License-Identifier: MIT
#include "numerics/lazy.h"

#include <catch2/catch.hpp>
#include <stdexcept>

namespace camlaw {
namespace {

TEST_CASE("a lazy value is made once, when it is asked for, for all its copies", "[lazy]") {
  int made = 0;
  const Lazy<int> value([&made] { return ++made; });
  const Lazy<int> copy = value;
  CHECK(made == 0);
  CHECK(*copy == 1);
  CHECK(*value == 1);
  CHECK(made == 1);
}

TEST_CASE("whoever asks for a lazy value hears why it cannot be made", "[lazy]") {
  int asked = 0;
  const Lazy<int> value([&asked]() -> int {
    if (++asked == 1) throw std::invalid_argument("not yet");
    return 7;
  });
  CHECK_THROWS_AS(*value, std::invalid_argument);
  CHECK(*value == 7);
}

}  // namespace
}  // namespace camlaw
