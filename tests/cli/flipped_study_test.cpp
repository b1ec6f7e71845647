// SPDX-License-Identifier: MIT
// A study in which single bits are flipped: all that is told of its front stays as it was, or the
// damage is named.
#include <catch2/catch.hpp>
#include <fstream>
#include <random>

#include "output/answers/front_output.h"
#include "tests/cutter_study.h"
#include "tests/flipped.h"
#include "tests/temporary_folder.h"

namespace camlaw::cli::flipped_study_test {
namespace {

using testing::flipped, testing::write;

constexpr int kFlips = 1000;

/// What came of a file with a flipped bit.
struct Tally {
  int refused = 0, same = 0, named = 0, silent = 0;
};

/// Everything that is told of a study's front, and whether something is said of the record.
std::pair<std::string, bool> told(const std::string& path) {
  optim::StudyRecord record = optim::StudyRecord::read(path);
  const problems::FrontStudy study = problems::FrontStudy::of(record);
  const problems::StoredFront stored = problems::stored_front(study, record);
  const FrontAnswer answer{study, stored};
  const std::string text = text_of(front_document(answer)) + json_of(front_document(answer)).dump();
  return {text, !answer.notes.empty()};
}

}  // namespace

TEST_CASE("no flipped bit of a study changes its front silently", "[heavy]") {
  const testing::Folder folder;
  const std::string path = folder / "s.db";
  testing::make_cutter_study(path, 6);
  const std::string bytes = testing::read(path);
  const auto whole = told(path);
  REQUIRE_FALSE(whole.second);
  std::mt19937_64 random(19);
  Tally tally;
  for (int i = 0; i < kFlips; ++i) {
    const std::string damaged = flipped(bytes, random);
    write(folder / "t.db", damaged);
    try {
      const auto [text, named] = told(folder / "t.db");
      ++(named ? tally.named : text == whole.first ? tally.same : tally.silent);
    } catch (const std::invalid_argument& error) {  // exit status 2
      CHECK(std::string(error.what()).size() > 10);
      ++tally.refused;
    }
  }
  CAPTURE(tally.refused, tally.same, tally.named);
  CHECK(tally.silent == 0);
  CHECK(tally.named > kFlips / 20);
  CHECK(tally.refused > 0);
  CHECK(tally.same > 0);
}

}  // namespace camlaw::cli::flipped_study_test
