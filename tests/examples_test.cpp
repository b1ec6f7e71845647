// SPDX-License-Identifier: MIT
#include <array>
#include <catch2/catch.hpp>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "machines/registry.h"
#include "tests/paths.h"

namespace {

const std::string kFormulas = camlaw::testing::source("docs/machine-formulas");

std::string file_text(const std::string& path) {
  std::ifstream stream(path);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

std::string output_of(const std::string& command) {
  std::string result;
  FILE* pipe = popen(command.c_str(), "r");
  REQUIRE(pipe != nullptr);
  std::array<char, 256> buffer;
  while (std::fgets(buffer.data(), buffer.size(), pipe) != nullptr) result += buffer.data();
  CHECK(pclose(pipe) == 0);
  return result;
}

/// Whether a page shows the example, without its licence line.
bool shows(const std::string& page, const std::string& file) {
  const std::string example = file_text(file);
  const std::string shown = example.substr(example.find('\n') + 1);
  CHECK(shown.size() > 500);
  return file_text(page).find(shown) != std::string::npos;
}

}  // namespace

TEST_CASE("the README shows the example that is compiled here") {
  CHECK(shows(camlaw::testing::source("README.md"),
              camlaw::testing::source("examples/peaks_and_cam.cpp")));
}

TEST_CASE("the page of optimisation shows the solver that is registered here", "[solvers]") {
  CHECK(shows(camlaw::testing::source("docs/optimisation.md"),
              camlaw::testing::source("examples/own_solver.cpp")));
  // From 2 (x - 1) + y = 0 and x + 4 y = 0: x = 8/7, y = -2/7, and (1 - 16 + 8) / 49 = -1/7.
  CHECK(output_of(camlaw::testing::own_solver_program()) ==
        "-0.142857 at (1.142857, -0.285714) by compass: certified optimum\n");
}

TEST_CASE("the example prints what the library's closed forms give") {
  const std::string output = output_of(camlaw::testing::example_program());
  // Modified sine: C = 4 pi^2 / (4 + pi); B = C (1/8 (2/pi) + 3/8 (2/pi)) = C / pi.
  CHECK(output.find("C_v = 1.7596033860, C_a = 5.5279570") != std::string::npos);
  CHECK(output.find("dC/da = ") != std::string::npos);
  // The root of max s' / (R + 8 mm + s) = tan 30 deg, by a grid of 2 million points.
  CHECK(output.find("least base radius 44.08 mm: certified") != std::string::npos);
}

TEST_CASE("the page of laws is what the catalogue prints") {
  const std::string page = output_of(camlaw::testing::program() + " laws --markdown");
  CHECK(page.find("| modified-sine |") != std::string::npos);
  CHECK(page == file_text(camlaw::testing::source("docs/laws.md")));
}

TEST_CASE("the page of mechanisms is what the program prints", "[documents]") {
  const std::string page = output_of(camlaw::testing::program() + " mechanisms --markdown");
  CHECK(page.find("## disc-cam-roller") != std::string::npos);
  CHECK(page == file_text(camlaw::testing::source("docs/mechanisms.md")));
}

TEST_CASE("the pages of the machines' formulas are what they are computed by", "[documents]") {
  std::size_t pages = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kFormulas)) {
    INFO(entry.path());
    const std::string page = output_of(camlaw::testing::program() + " mechanisms " +
                                       entry.path().stem().string() + " --formulas");
    CHECK(page.find("&= ") != std::string::npos);
    CHECK(page == file_text(entry.path()));
    ++pages;
  }
  CHECK(pages == camlaw::problems::mechanisms().size());
}
