// SPDX-License-Identifier: MIT
#include "optim/study/encoding.h"

#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>

#include "optim/crew/bytes.h"
#include "tests/optim/pareto/outcomes.h"

namespace camlaw::optim::encoding_test {

using namespace study_tests;

TEST_CASE("an outcome comes back from its bytes to the last bit", "[study]") {
  Outcome infeasible;
  infeasible.infeasible = true;
  infeasible.evaluations = -1;
  Outcome failed;
  failed.failure = std::string("a \0 within", 10);
  for (const Outcome& outcome : {Outcome{}, odd_outcome(), infeasible, failed,
                                 Outcome{{FrontPoint{}, FrontPoint{}}, false, 0, ""}}) {
    const auto back = decoded(encoded(outcome));
    REQUIRE(back);
    CHECK(bits(*back) == bits(outcome));
  }
}

TEST_CASE("the sign of zero is kept, and a NaN is one", "[study]") {
  Outcome outcome;
  outcome.points.resize(1);
  outcome.points[0].x = {-0.0, kNan, 0.1, -0.1F};
  CHECK(bits(*decoded(encoded(outcome))) == bits(outcome));
  outcome.points[0].x = {std::bit_cast<double>(std::uint64_t{0xfff8dead'beef0001})};
  CHECK(std::isnan(decoded(encoded(outcome))->points[0].x[0]));
}

TEST_CASE("bytes are CBOR, behind their version", "[study]") {
  // After RFC 8949: lists begin with 0x80 and their length, 1.5 in 32 bits is fa 3f c0 00 00, and
  // 0.1 in 64 bits fb 3f b9 99 99 99 99 99 9a.
  CHECK(bytes_of(std::vector<double>{1.5, 0.1}) ==
        std::string("\x82\x01\x82\xfa\x3f\xc0\x00\x00\xfb\x3f\xb9\x99\x99\x99\x99\x99\x9a", 17));
  CHECK(bytes_of(std::optional<bool>()) == "\x82\x01\xf6");
  CHECK(bytes_of(true) == "\x82\x01\xf5");
  CHECK(bytes_of(-3) == "\x82\x01\x22");
  CHECK(bytes_of(std::string("\xc3\xa4")) == "\x82\x01\x62\xc3\xa4");
  // What is not UTF-8 is a byte string.
  CHECK(bytes_of(std::string("\xe4")) == "\x82\x01\x41\xe4");
  CHECK(value_of_bytes<std::string>("\x82\x01\x41\xe4") == "\xe4");
  // So is what UTF-8 does not write so: longer than it need be, half of a pair, beyond the last.
  CHECK(bytes_of(std::string("\xe0\x80\x80")) == "\x82\x01\x43\xe0\x80\x80");
  CHECK(bytes_of(std::string("\xed\xa0\x80")) == "\x82\x01\x43\xed\xa0\x80");
  CHECK(bytes_of(std::string("\xf0\x80\x80\x80")) == "\x82\x01\x44\xf0\x80\x80\x80");
  CHECK(bytes_of(std::string("\xf4\x90\x80\x80")) == "\x82\x01\x44\xf4\x90\x80\x80");
  CHECK(bytes_of(std::string("\xed\x9f\xbf")) == "\x82\x01\x63\xed\x9f\xbf");
  CHECK(bytes_of(std::string("\xf4\x8f\xbf\xbf")) == "\x82\x01\x64\xf4\x8f\xbf\xbf");
  CHECK(bytes_of(std::string("\xe2\x82")) == "\x82\x01\x42\xe2\x82");
  // Another writer may use 64 bits for every number, and lists that end with a break.
  CHECK(value_of_bytes<std::vector<double>>(std::string(
            "\x9f\x01\x9f\xfb\x3f\xf8\0\0\0\0\0\0\xff\xff", 14)) == std::vector<double>{1.5});
}

TEST_CASE("what is not ours, or of another version, is not read", "[study]") {
  CHECK(value_of_bytes<int>("\x82\x01\x05") == 5);
  CHECK_FALSE(value_of_bytes<int>("\x82\x02\x05"));
  CHECK_FALSE(value_of_bytes<int>("\x05"));
  CHECK_FALSE(value_of_bytes<int>("\x81\x01"));
  CHECK_FALSE(value_of_bytes<int>("\x83\x01\x05\x05"));
  CHECK_FALSE(value_of_bytes<int>("\x82\x01\xa1\x05\x05"));
  CHECK_FALSE(value_of_bytes<int>("\x82\x01\xf5"));
  CHECK_FALSE(value_of_bytes<bool>("\x82\x01\x01"));
  CHECK_FALSE(value_of_bytes<std::uint64_t>("\x82\x01\x22"));
  CHECK_FALSE(value_of_bytes<int>("\x82\x01\x1b\x01\x02\x03\x04\x05\x06\x07\x08"));
  CHECK_FALSE(value_of_bytes<std::vector<double>>("\x82\x01\xf6"));
  CHECK_FALSE(decoded(""));
  // The parser takes stack for each level.
  CHECK_FALSE(decoded(std::string(10'000'000, '\x81')));
}

TEST_CASE("a long outcome goes through", "[study]") {
  Outcome outcome;
  for (int i = 0; i < 500; ++i) {
    outcome.points.push_back(odd_point());
    outcome.points.back().x.assign(200, i);
  }
  CHECK(bits(*decoded(encoded(outcome))) == bits(outcome));
}

TEST_CASE("no part of an outcome's bytes is an outcome, nor is more than them", "[study]") {
  const std::string bytes = encoded(odd_outcome());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    CHECK_FALSE(decoded(std::string_view(bytes).substr(0, size)));
  }
  CHECK_FALSE(decoded(bytes + '\0'));
  CHECK_FALSE(decoded(bytes + bytes));
}

TEST_CASE("damaged bytes give an outcome or none", "[study]") {
  const std::string bytes = encoded(odd_outcome());
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    for (const int flip : {0x01, 0x02, 0x80, 0xff}) {
      std::string damaged = bytes;
      damaged[at] = static_cast<char>(damaged[at] ^ flip);
      const auto outcome = decoded(damaged);
      if (!outcome) continue;
      // What is taken for an outcome can be worked with.
      CHECK(decoded(encoded(*outcome)));
      for (const FrontPoint& p : outcome->points) CHECK_FALSE(to_string(p.verdict).empty());
      CHECK(outcome->points.size() <= 2);
    }
  }
}

TEST_CASE("bytes of a yes or no and of a verdict must be such", "[study]") {
  Outcome outcome;
  const std::string no = encoded(outcome);
  outcome.infeasible = true;
  const std::string yes = encoded(outcome);
  REQUIRE(no.size() == yes.size());
  std::size_t at = 0;
  while (no[at] == yes[at]) ++at;
  std::string neither = no;
  neither[at] = 2;
  CHECK_FALSE(decoded(neither));

  outcome = {{FrontPoint{}}, false, 0, ""};
  outcome.points[0].verdict = Verdict::Certified;
  const std::string one = encoded(outcome);
  outcome.points[0].verdict = Verdict::Failed;
  const std::string other = encoded(outcome);
  at = 0;
  while (one[at] == other[at]) ++at;
  std::string none = one;
  none[at] = 77;
  CHECK_FALSE(decoded(none));
}

TEST_CASE("a list that is said to be longer than the bytes is not made", "[study]") {
  const auto list_of = [](std::uint64_t size) {
    std::string bytes = "\x82\x01\x9b";
    for (int shift = 56; shift >= 0; shift -= 8) bytes += static_cast<char>(size >> shift);
    return bytes;
  };
  for (const std::uint64_t size : {std::uint64_t{1}, std::uint64_t{1} << 40, ~std::uint64_t{0}}) {
    CHECK_FALSE(value_of_bytes<std::vector<double>>(list_of(size)));
  }
  CHECK(value_of_bytes<std::vector<int>>(list_of(1) + '\x05') == std::vector<int>{5});
  // A million empty lists, of which two million were said to come.
  CHECK_FALSE(value_of_bytes<std::vector<std::vector<double>>>(list_of(2'000'000) +
                                                               std::string(1'000'000, '\x80')));
}

TEST_CASE("an order comes back from its bytes to the last bit", "[study]") {
  Order order;
  order.task = {Task::Kind::Toward, 3,  1,  {kInfinity, -0.0},    {1, 2}, {0.1, 1e-300},
                {{1}, {}, {2, 3}},  40, 50, 0xffff'ffff'ffff'fff1};
  order.options = {.solver = "slsqp",
                   .starts = 3,
                   .seed = 12,
                   .time_limit = 0.25,
                   .max_iterations = 17,
                   .max_evaluations = 1'234'567'890'123,
                   .native = {{"ipopt", {{"mu_init", 0.1}, {"mu_strategy", "adaptive"}}},
                              {"crs2", {{"population", std::int64_t{50}}}}},
                   .divides = false};
  const std::string bytes = encoded(order);
  const auto back = decoded_order(bytes);
  REQUIRE(back);
  CHECK(back->task.text() == order.task.text());
  CHECK(back->task.population == 40);
  CHECK(back->task.generations == 50);
  CHECK(back->options.solver == "slsqp");
  CHECK(back->options.starts == 3);
  CHECK(back->options.seed == 12);
  CHECK(back->options.time_limit == 0.25);
  CHECK(back->options.max_iterations == 17);
  CHECK(back->options.max_evaluations == 1'234'567'890'123);
  CHECK(back->options.native == order.options.native);
  CHECK_FALSE(back->options.divides);
  CHECK(encoded(*back) == bytes);
  CHECK(encoded(*decoded_order(encoded(Order{}))) == encoded(Order{}));
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    CHECK_FALSE(decoded_order(std::string_view(bytes).substr(0, size)));
  }
  // The order, its task and the task's kind follow the version.
  REQUIRE(bytes.starts_with("\x82\x01\x82\x8a\x01"));
  std::string no_kind = bytes;
  no_kind[4] = 9;
  CHECK_FALSE(decoded_order(no_kind));
}

TEST_CASE("texts come back from their bytes", "[study]") {
  const std::vector<std::string> texts{"", "two", std::string("a\0b", 3)};
  CHECK(decoded_texts(encoded(texts)) == texts);
  CHECK_FALSE(decoded_texts(encoded(texts) + "x"));
  CHECK_FALSE(decoded_texts("nonsense"));
}

}  // namespace camlaw::optim::encoding_test
