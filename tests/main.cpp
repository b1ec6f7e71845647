// SPDX-License-Identifier: MIT
#define CATCH_CONFIG_RUNNER
#include <catch2/catch.hpp>
#include <cstdio>

namespace {

/// Keeps the final counts for the last line of output.
struct Counts : Catch::TestEventListenerBase {
  using TestEventListenerBase::TestEventListenerBase;
  static inline std::size_t passed = 0;
  static inline std::size_t failed = 0;
  static inline bool ran = false;  ///< not where tests were only listed

  void testRunEnded(const Catch::TestRunStats& stats) override {
    const auto& cases = stats.totals.testCases;
    passed = cases.passed + cases.failedButOk;
    failed = cases.failed;
    ran = true;
  }
};
CATCH_REGISTER_LISTENER(Counts)

}  // namespace

int main(int argc, char* argv[]) {
  const int status = Catch::Session().run(argc, argv);
  std::fflush(stderr);
  if (Counts::ran) std::printf("%zu passed, %zu failed\n", Counts::passed, Counts::failed);
  return status;
}
