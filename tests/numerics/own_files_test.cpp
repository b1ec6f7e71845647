// SPDX-License-Identifier: MIT
#include "numerics/own_files.h"

#include <catch2/catch.hpp>
#include <filesystem>

#include "tests/temporary_folder.h"

namespace camlaw::own_files_test {
namespace {

namespace fs = std::filesystem;

/// Beside the running program, gone afterwards.
class Beside {
 public:
  Beside(const std::string& name, fs::perms permissions)
      : path_(fs::read_symlink("/proc/self/exe").parent_path() / name) {
    testing::write(path_, "x");
    fs::permissions(path_, permissions);
  }
  Beside(const Beside&) = delete;
  Beside& operator=(const Beside&) = delete;
  ~Beside() { fs::remove(path_); }
  std::string path() const { return path_.string(); }

 private:
  fs::path path_;
};

TEST_CASE("what is installed with the program is found beside it", "[own files]") {
  const Beside file("camlaw-test-own-file", fs::perms::owner_read);
  CHECK(own_file("camlaw-test-own-file") == file.path());
  CHECK_FALSE(own_program("camlaw-test-own-file"));
  CHECK_FALSE(own_file("camlaw-test-no-such-file"));
  CHECK_FALSE(own_file("."));

  const Beside program("camlaw-test-own-program", fs::perms::owner_all);
  CHECK(own_program("camlaw-test-own-program") == program.path());
}

TEST_CASE("in the build folder the plug-ins are found", "[own files]") {
  const auto plugin = own_file("camlaw-nsga2.so");
  REQUIRE(plugin);
  CHECK(fs::path(*plugin).parent_path().filename() == "plugins");
}

TEST_CASE("in the build folder the problem files are found", "[own files]") {
  const auto problems = own_data("problems");
  REQUIRE(problems);
  CHECK(fs::exists(fs::path(*problems) / "cams/roller_least_base.toml"));
  CHECK_FALSE(own_data("no-such-folder"));
}

}  // namespace
}  // namespace camlaw::own_files_test
