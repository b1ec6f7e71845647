// SPDX-License-Identifier: MIT
#include "cli/files.h"

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstring>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>

#include "cli/inputs.h"
#include "cli/replacing.h"
#include "problems/law_files/json_text.h"
#include "tests/temporary_folder.h"

namespace camlaw::cli::files_test {
namespace {

namespace fs = std::filesystem;
using Catch::Matchers::Contains;

using testing::Folder, testing::read, testing::write;

using Names = std::set<std::string>;

}  // namespace

TEST_CASE("files are written whole, with every byte", "[files]") {
  const Folder folder;
  const std::string binary("a\0b\r\n\xff", 6), large(3'000'000, 'x');
  write_files({{folder / "a", binary}, {folder / "b", large}, {folder / "empty", ""}});
  CHECK(read(folder / "a") == binary);
  CHECK(read(folder / "b") == large);
  CHECK(read(folder / "empty").empty());
  CHECK(folder.content() == Names{"a", "b", "empty"});
}

TEST_CASE("missing folders are made", "[files]") {
  const Folder folder;
  write_files({{folder / "x/y/z.txt", "1"}, {folder / "x/y/w.txt", "2"}});
  CHECK(read(folder / "x/y/z.txt") == "1");
  CHECK(folder.content() == Names{"x", "x/y", "x/y/z.txt", "x/y/w.txt"});
}

TEST_CASE("a file that stands there is replaced", "[files]") {
  const Folder folder;
  write(folder / "a", "old and longer");
  write_files({{folder / "a", "new"}});
  CHECK(read(folder / "a") == "new");
  CHECK(folder.content() == Names{"a"});
}

TEST_CASE("no files are no work", "[files]") { CHECK_NOTHROW(write_files({})); }

TEST_CASE("where the folder cannot be, the error names the file", "[files]") {
  const Folder folder;
  write(folder / "plain", "not a folder");
  const fs::path below = folder / "plain/x.csv", deeper = folder / "plain/y/x.csv";
  CHECK_THROWS_AS(write_files({{below, "1"}}), std::runtime_error);
  CHECK_THROWS_WITH(write_files({{below, "1"}}), Contains(below.string()));
  CHECK_THROWS_WITH(write_files({{deeper, "1"}}), Contains(deeper.string()));
  CHECK(read(folder / "plain") == "not a folder");
  CHECK(folder.content() == Names{"plain"});
}

TEST_CASE("a folder is not a file", "[files]") {
  const Folder folder;
  fs::create_directory(folder / "results");
  CHECK_THROWS_WITH(write_files({{folder / "results", "1"}}),
                    Contains((folder / "results")) && Contains("folder"));
  CHECK(folder.content() == Names{"results"});
}

TEST_CASE("a name that is too long is refused and named", "[files]") {
  const Folder folder;
  const std::string name(300, 'n');  // file systems end at 255
  CHECK_THROWS_WITH(write_files({{folder / name, "1"}}), Contains(name));
  CHECK(folder.content().empty());
}

TEST_CASE("a second file that fails leaves nothing of the first", "[files]") {
  const Folder folder;
  write(folder / "plain", "");
  CHECK_THROWS(write_files({{folder / "first", "1"}, {folder / "plain/second", "2"}}));
  CHECK(folder.content() == Names{"plain"});
  fs::create_directory(folder / "results");
  CHECK_THROWS(write_files({{folder / "first", "1"}, {folder / "results", "2"}}));
  CHECK(folder.content() == Names{"plain", "results"});
}

TEST_CASE("old content stays when the new cannot be written", "[files]") {
  const Folder folder;
  write(folder / "first", "old");
  write(folder / "plain", "");
  for (const auto& bad : {folder / "plain/second", folder / std::string(300, 'n')}) {
    CHECK_THROWS(write_files({{folder / "first", "new"}, {bad, "2"}}));
    CHECK_THROWS(write_files({{bad, "2"}, {folder / "first", "new"}}));
    CHECK(read(folder / "first") == "old");
  }
  CHECK(folder.content() == Names{"first", "plain"});
}

TEST_CASE("folders made for a file that is not written do not stay", "[files]") {
  const Folder folder;
  write(folder / "plain", "");
  CHECK_THROWS(write_files({{folder / "new/deep/first", "1"}, {folder / "plain/second", "2"}}));
  CHECK(folder.content() == Names{"plain"});
}

TEST_CASE("where a rename fails, files that had their new content get the old one back",
          "[files]") {
  const Folder folder;
  write(folder / "first", "old");
  {
    Replacing replacing;
    replacing.add(folder / "first", "new", folder / "first");
    replacing.add(folder / "made", "new", folder / "made");
    const Names before = folder.content();
    replacing.add(folder / "last", "new", folder / "last");
    for (const auto& name : folder.content()) {
      if (before.count(name) == 0) fs::remove(folder / name);  // somebody takes it away
    }
    CHECK_THROWS_WITH(replacing.commit(), Contains("last"));
    CHECK(read(folder / "first") == "old");
  }
  CHECK(folder.content() == Names{"first"});
}

TEST_CASE("no link that stands where a file is prepared is followed", "[files]") {
  const Folder folder;
  write(folder / "victim", "precious");
  // The names that used to be taken.
  for (int i = 0; i < 3; ++i) {
    fs::create_symlink("victim", folder / (".camlaw-" + std::to_string(getpid()) + "-" +
                                           std::to_string(i) + ".tmp"));
  }
  write_files({{folder / "a", "1"}, {folder / "b", "2"}});
  CHECK(read(folder / "victim") == "precious");
  CHECK(read(folder / "b") == "2");
}

TEST_CASE("a file keeps its permissions, and a new one gets those of the mask", "[files]") {
  const Folder folder;
  write(folder / "old", "x");
  fs::permissions(folder / "old", fs::perms(0640));
  const mode_t mask = umask(0027);
  write_files({{folder / "old", "1"}, {folder / "new", "2"}});
  umask(mask);
  CHECK(fs::status(folder / "old").permissions() == fs::perms(0640));
  CHECK(fs::status(folder / "new").permissions() == fs::perms(0640));
}

TEST_CASE("one place for two files is refused before anything is written", "[files]") {
  const Folder folder;
  write(folder / "a", "old");
  CHECK_THROWS_WITH(write_files({{folder / "a", "1"}, {folder / "a", "2"}}), Contains("a"));
  CHECK_THROWS(write_files({{folder / "a", "1"}, {folder / "./a", "2"}}));
  CHECK(read(folder / "a") == "old");
  CHECK(folder.content() == Names{"a"});
}

TEST_CASE("a link is followed, not replaced", "[files]") {
  const Folder folder;
  write(folder / "real", "old");
  fs::create_symlink("real", folder / "link");
  write_files({{folder / "link", "new"}});
  CHECK(fs::is_symlink(folder / "link"));
  CHECK(read(folder / "real") == "new");
  CHECK(folder.content() == Names{"link", "real"});
}

TEST_CASE("a link is followed to what is not there yet", "[files]") {
  const Folder folder;
  fs::create_directory(folder / "made");
  fs::create_symlink("made/new", folder / "link");
  fs::create_symlink("link", folder / "again");
  fs::create_symlink("nowhere", folder / "dir");
  check_writable({folder / "again", folder / "dir/file"});
  write_files({{folder / "again", "1"}, {folder / "dir/file", "2"}});
  CHECK(fs::is_symlink(folder / "link"));
  CHECK(fs::is_symlink(folder / "dir"));
  CHECK(read(folder / "made/new") == "1");
  CHECK(read(folder / "nowhere/file") == "2");
  CHECK(folder.content() ==
        Names{"again", "dir", "link", "made", "made/new", "nowhere", "nowhere/file"});
  // To begin with a file is fine there, and not where it is already.
  fs::remove(folder / "made/new");
  CHECK_NOTHROW(refuse_existing({{folder / "again", ""}}));
  write(folder / "made/new", "mine");
  CHECK_THROWS_WITH(refuse_existing({{folder / "again", ""}}), Contains("exists already"));
}

TEST_CASE("one place is known behind links to what is not there yet", "[files]") {
  const Folder folder;
  fs::create_symlink("new", folder / "link");
  fs::create_symlink("../" + fs::path(folder.path()).filename().string() + "/new", folder / "far");
  for (const char* other : {"new", "far"}) {
    CHECK_THROWS_WITH(write_files({{folder / "link", "1"}, {folder / other, "2"}}),
                      Contains("two outputs go to one file"));
  }
  CHECK(folder.content() == Names{"far", "link"});
}

TEST_CASE("links in a circle are an error of the file", "[files]") {
  const Folder folder;
  fs::create_symlink("b", folder / "a");
  fs::create_symlink("a", folder / "b");
  for (const char* name : {"a", "a/file"}) {
    const std::string says = "cannot write '" + (folder / name) + "': Too many levels";
    CHECK_THROWS_WITH(write_files({{folder / name, "1"}}), Contains(says));
    CHECK_THROWS_WITH(check_writable({folder / name}), Contains(says));
  }
  CHECK(folder.content() == Names{"a", "b"});
}

TEST_CASE("what is not a regular file is not replaced by one", "[files]") {
  // A socket stands for devices: root may rename over /dev/null.
  const Folder folder;
  const fs::path path = folder / "socket";
  const int descriptor = socket(AF_UNIX, SOCK_STREAM, 0);
  REQUIRE(descriptor >= 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  REQUIRE(path.string().size() < sizeof address.sun_path);
  std::strcpy(address.sun_path, path.c_str());
  const void* raw = &address;
  REQUIRE(bind(descriptor, static_cast<const sockaddr*>(raw), sizeof address) == 0);
  close(descriptor);
  CHECK_THROWS_AS(write_files({{path, "1"}}), std::runtime_error);
  CHECK(fs::is_socket(path));
}

TEST_CASE("whether files can be written is found out without leaving anything", "[files]") {
  const Folder folder;
  write(folder / "kept", "as it was");
  check_writable({folder / "kept", folder / "new/deep/file"});
  CHECK(folder.content() == Names{"kept"});
  CHECK(read(folder / "kept") == "as it was");
  CHECK_THROWS_WITH(check_writable({folder / "a", folder / "kept/b"}), Contains("kept/b"));
  CHECK_THROWS_WITH(check_writable({"/dev/null/x"}), Contains("/dev/null/x"));
  CHECK(folder.content() == Names{"kept"});
}

TEST_CASE("an output that is an input is refused, by whatever name", "[files]") {
  const Folder folder;
  write(folder / "a", "input");
  write(folder / "b", "other");
  fs::create_symlink("a", folder / "link");
  keep_input(folder / "a");
  CHECK_NOTHROW(check_writable({folder / "b", folder / "none"}));
  for (const char* name : {"a", "./a", "link"}) {
    CHECK_THROWS_AS(write_files({{folder / name, "output"}}), std::invalid_argument);
    CHECK_THROWS_WITH(check_writable({folder / name}), Contains("is an input of this run"));
    CHECK(remove_files({folder / name}).empty());
  }
  CHECK(read(folder / "a") == "input");
}

TEST_CASE("endings are read in small letters", "[files]") {
  CHECK(ending_of("x/a.DXF") == ".dxf");
  CHECK(ending_of("a.b.Json") == ".json");
  CHECK(ending_of("x.y/a").empty());
}

TEST_CASE("files of an earlier run are removed, nothing else", "[files]") {
  const Folder folder;
  write(folder / "old", "x");
  fs::create_directory(folder / "dir");
  const auto removed = remove_files({folder / "old", folder / "dir", folder / "none"});
  CHECK(removed == std::vector<fs::path>{folder / "old"});
  CHECK(folder.content() == Names{"dir"});
}

TEST_CASE("a folder's outputs are replaced as camlaw left them, and not otherwise", "[files]") {
  const Folder folder;
  const fs::path a = folder / "out/a.csv", b = folder / "out/b.svg", c = folder / "out/c.json";
  write_out({a, b}, {{a, "first"}, {b, "picture"}}, false);
  write_out({a, b}, {{a, "second"}}, false);
  CHECK(read(a) == "second");
  CHECK(folder.content() == Names{"out", "out/.camlaw.json", "out/a.csv"});  // b was removed
  // What nobody wrote here stays, whether it would be replaced or left over.
  write(b, "mine");
  CHECK_THROWS_WITH(check_out({a, b}),
                    Contains("out/b.svg' is not in the list of files that camlaw wrote there") &&
                        Contains("choose another folder for --out") && !Contains("a.csv"));
  CHECK_THROWS_AS(write_out({a, b}, {{a, "third"}, {b, "picture"}}, false), RefusedOutput);
  CHECK(read(a) == "second");
  CHECK_NOTHROW(check_out({a}, {b}));
  write_out({a, b}, {{a, "third"}}, false);
  CHECK(read(b) == "mine");
  // What was changed since is named too, and neither replaced nor removed.
  write_out({a, c}, {{a, "fourth"}, {c, "{}"}}, false);
  write(c, "{\"mine\": 1}");
  CHECK_THROWS_WITH(check_out({a, c}), Contains("out/c.json' was changed since camlaw wrote it"));
  CHECK_THROWS_WITH(check_out({a}, {c}), Contains("c.json' was changed"));
  CHECK_THROWS_AS(write_out({a, c}, {{a, "fifth"}}, false), RefusedOutput);
  CHECK(read(a) == "fourth");
  CHECK(read(c) == "{\"mine\": 1}");
  // An empty file is nobody's work, and one as long as ours is not ours.
  write(c, "");
  CHECK_NOTHROW(check_out({a, c}));
  write(a, "Fourth");
  CHECK_THROWS_AS(check_out({a}), RefusedOutput);
}

TEST_CASE("a record of outputs that is damaged, or none, gives nothing away", "[files]") {
  const Folder folder;
  const fs::path a = folder / "out/a.csv", record = folder / "out/.camlaw.json";
  write_out({a}, {{a, "first"}}, false);
  std::string text = read(record);
  text.replace(text.find("a.csv"), 5, "b.csv");
  for (const std::string& bad : {text, std::string("[1]"), std::string("notes"), "{" + text}) {
    write(record, bad);
    CHECK_THROWS_WITH(check_out({a}), Contains("is not the list of outputs that camlaw keeps"));
    CHECK_THROWS_AS(write_out({a}, {{a, "second"}}, false), RefusedOutput);
    CHECK(read(record) == bad);
  }
  fs::remove(record);
  CHECK_THROWS_WITH(check_out({a}),
                    Contains("a.csv' is not in the list of files that camlaw wrote there"));
}

}  // namespace camlaw::cli::files_test
