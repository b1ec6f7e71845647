// SPDX-License-Identifier: MIT
#include <array>
#include <catch2/catch.hpp>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>

namespace {

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

}  // namespace

TEST_CASE("the README shows the example that is compiled here") {
  const std::string example = file_text(CAMLAW_SOURCE_DIR "/examples/peaks_and_cam.cpp");
  const std::string shown = example.substr(example.find('\n') + 1);  // without the licence line
  CHECK(shown.size() > 500);
  CHECK(file_text(CAMLAW_SOURCE_DIR "/README.md").find(shown) != std::string::npos);
}

TEST_CASE("the example prints what the library's closed forms give") {
  const std::string output = output_of(CAMLAW_EXAMPLE);
  // Modified sine: C = 4 pi^2 / (4 + pi); B = C (1/8 (2/pi) + 3/8 (2/pi)) = C / pi.
  CHECK(output.find("B = 1.7596033860, C = 5.5279570") != std::string::npos);
  // R = 30 mm B / (pi tan 30 deg)
  CHECK(output.find("cam radius 29.10 mm") != std::string::npos);
  CHECK(output.find("dC/da = ") != std::string::npos);
}

TEST_CASE("the page of laws is what the catalogue prints") {
  const std::string page = output_of(CAMLAW_PROGRAM " laws --markdown");
  CHECK(page.find("| modified-sine |") != std::string::npos);
  CHECK(page == file_text(CAMLAW_SOURCE_DIR "/docs/laws.md"));
}

TEST_CASE("the page of mechanisms is what the program prints", "[documents]") {
  const std::string page = output_of(CAMLAW_PROGRAM " mechanisms --markdown");
  CHECK(page.find("## disc-cam-roller") != std::string::npos);
  CHECK(page == file_text(CAMLAW_SOURCE_DIR "/docs/mechanisms.md"));
}
