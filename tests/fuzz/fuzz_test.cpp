// SPDX-License-Identifier: MIT
// Thousands of spoilt files for each reader: what cannot be read is refused, nothing else is
// thrown. The long run, guided by what is covered, is camlaw_guided of the preset "fuzz"
// (docs/design.md).
#include <catch2/catch.hpp>

#include "tests/fuzz/mutations.h"
#include "tests/fuzz/targets.h"

namespace camlaw::fuzz::fuzz_test {
namespace {

void check_spoilt_files(const std::string& name) {
  constexpr int kFiles = 1000;
  const Target& target = find_target(name);
  const auto seeds = corpus(target);
  REQUIRE(!seeds.empty());
  for (const std::string& seed : seeds) target.read(seed);
  std::mt19937_64 random(19);
  for (int i = 0; i < kFiles; ++i) {
    const std::string file = mutated(seeds, target.is_text ? Shape::Text : Shape::Binary, random);
    INFO("file " << i << ":\n" << file.substr(0, 2000));
    CHECK_NOTHROW(target.read(file));
  }
}

}  // namespace

TEST_CASE("spoilt problem files are read or refused", "[fuzz]") { check_spoilt_files("problem"); }
TEST_CASE("spoilt published tables are read or refused", "[fuzz]") { check_spoilt_files("table"); }
TEST_CASE("spoilt law files are read or refused", "[fuzz]") { check_spoilt_files("law"); }
TEST_CASE("spoilt results are read or refused", "[fuzz]") { check_spoilt_files("result"); }
TEST_CASE("spoilt studies are read or refused", "[fuzz]") { check_spoilt_files("study"); }
TEST_CASE("spoilt tables of samples are read or refused", "[fuzz]") {
  check_spoilt_files("samples");
}

}  // namespace camlaw::fuzz::fuzz_test
