// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <vector>

#include "machines/model/mechanism.h"

namespace camlaw::problems {
namespace {

using Indices = std::vector<std::size_t>;

TEST_CASE("a set of parameters is increasing, each once, and found when it is asked for",
          "[mechanism]") {
  CHECK(ParameterSet().indices().empty());
  CHECK(ParameterSet{7, 2, 7}.indices() == Indices{2, 7});
  int found = 0;
  const ParameterSet late([&found] {
    ++found;
    return Indices{5, 3, 5};
  });
  const ParameterSet all = united({late, {4}, ParameterSet()});
  CHECK(found == 0);
  CHECK(all.indices() == Indices{3, 4, 5});
  CHECK(all.holds(4));
  CHECK_FALSE(all.holds(6));
  CHECK(late.holds(3));
  CHECK(found == 1);
}

}  // namespace
}  // namespace camlaw::problems
