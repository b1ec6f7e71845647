// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <cstdlib>
#include <string>

#include "tests/paths.h"

TEST_CASE("the API's reference builds without warnings where Doxygen is installed", "[documents]") {
  if (std::system("command -v doxygen >/dev/null") != 0) {
    WARN("doxygen is not installed");
    return;
  }
  CHECK(std::system("doxygen '" CAMLAW_BUILD_DIR "/Doxyfile' >/dev/null") == 0);
}

TEST_CASE("what is installed builds and runs programs, and makes packages", "[install][heavy]") {
  const std::string command = std::string("CXXFLAGS='") + CAMLAW_CXX_FLAGS + "' " +
                              camlaw::testing::source("tests/install/check_install.sh") +
                              " '" CAMLAW_BUILD_DIR "' '" + camlaw::testing::source() + "'";
  CHECK(std::system(command.c_str()) == 0);
}
