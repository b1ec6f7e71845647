// SPDX-License-Identifier: MIT
#include "optim/study/recorded_hands.h"

#include <SQLiteCpp/SQLiteCpp.h>

#include <catch2/catch.hpp>
#include <functional>
#include <map>
#include <vector>

#include "tests/temporary_folder.h"

namespace camlaw::optim::recorded_hands_test {
namespace {

using testing::Folder;

/// Asks for the squares of numbers.
class Squares final : public Errands {
 public:
  explicit Squares(std::size_t count) : count_(count) {}
  std::optional<std::size_t> next() override {
    if (next_ == count_ || is_done()) return {};
    return next_++;
  }
  std::optional<std::string> order(std::size_t number) override {
    return std::string("\0\xff square ", 10) + std::to_string(number);
  }
  void answered(std::size_t number, const std::string& answer) override {
    answers[number] = answer;
  }
  bool is_answer(std::size_t, const std::string& answer) const override {
    return answer.starts_with(std::string("\0 ", 2));
  }
  void lost(std::size_t, const std::string&) override {}
  bool is_done() const override { return answers.size() >= most; }

  std::map<std::size_t, std::string> answers;
  std::size_t most = 1000;  ///< answers, after which it ends

 private:
  std::size_t count_, next_ = 0;
};

/// Answers each order by itself, and counts them.
struct Counting {
  std::vector<std::size_t> served;
  Hands hands() {
    return [this](Errands& errands, const Service&) {
      while (const auto number = errands.next()) {
        served.push_back(*number);
        errands.answered(*number, std::string("\0 ", 2) + std::to_string(*number * *number));
      }
    };
  }
};

/// By what is recorded in a file. How many were served.
std::vector<std::size_t> run(const std::string& path, Squares& squares) {
  StudyRecord record = StudyRecord::begin(path, {{"problem", "squares"}}, true, [](const auto&) {});
  Counting others;
  recorded_hands(others.hands(), record)(squares, {});
  return others.served;
}

}  // namespace

TEST_CASE("what a record has answers to is not asked again", "[study]") {
  const Folder folder;
  const std::string path = folder / "s.db";
  Squares some(10), all(10), more(12);
  some.most = 4;
  CHECK(run(path, some) == std::vector<std::size_t>{0, 1, 2, 3});
  CHECK(run(path, all) == std::vector<std::size_t>{4, 5, 6, 7, 8, 9});
  REQUIRE(all.answers.size() == 10);
  for (const auto& [number, answer] : all.answers) {
    CHECK(answer == std::string("\0 ", 2) + std::to_string(number * number));
  }
  CHECK(run(path, more) == std::vector<std::size_t>{10, 11});
  CHECK(more.answers.size() == 12);
}

TEST_CASE("an answer that is not as it was written is asked for again", "[study]") {
  const Folder folder;
  const std::string path = folder / "s.db";
  Squares first(5), again(5), last(5);
  run(path, first);
  {
    SQLite::Database base(path, SQLite::OPEN_READWRITE);
    CHECK(base.exec("UPDATE answer SET answer = x'00' WHERE instr(question, x'33') > 0") == 1);
    CHECK(base.exec("UPDATE answer SET checksum = 1 WHERE instr(question, x'34') > 0") == 1);
  }
  CHECK(run(path, again) == std::vector<std::size_t>{3, 4});
  CHECK(again.answers == first.answers);
  CHECK(run(path, last).empty());
}

TEST_CASE("what is not an answer is neither recorded nor believed of a record", "[study]") {
  const Folder folder;
  StudyRecord record = StudyRecord::create(folder / "s.db", {{"problem", "squares"}});
  Squares wrong(3), right(3);
  record.put_answer(*right.order(1), "of another program");
  recorded_hands(
      [](Errands& errands, const Service&) {
        while (const auto number = errands.next()) errands.answered(*number, "nonsense");
      },
      record)(wrong, {});
  CHECK(wrong.answers.size() == 3);
  CHECK_FALSE(record.answer(*right.order(0)));
  Counting others;
  recorded_hands(others.hands(), record)(right, {});
  CHECK(others.served == std::vector<std::size_t>{0, 1, 2});
  CHECK(*record.answer(*right.order(1)) == right.answers[1]);
}

TEST_CASE("an answer that is empty, as it was cut short, is not recorded", "[study]") {
  const Folder folder;
  StudyRecord record = StudyRecord::create(folder / "s.db", {{"problem", "squares"}});
  Squares cut(3), whole(3);
  recorded_hands(
      [](Errands& errands, const Service&) {
        while (const auto number = errands.next()) errands.answered(*number, "");
      },
      record)(cut, {});
  CHECK(cut.answers.size() == 3);
  Counting others;
  recorded_hands(others.hands(), record)(whole, {});
  CHECK(others.served.size() == 3);
}

}  // namespace camlaw::optim::recorded_hands_test
