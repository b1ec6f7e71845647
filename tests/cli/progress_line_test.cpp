// SPDX-License-Identifier: MIT
#include "cli/progress_line.h"

#include <catch2/catch.hpp>

#include "cli/search_progress.h"
#include "output/answers/front_words.h"

namespace camlaw::cli::progress_line_test {

TEST_CASE("the time left follows from the share that is done", "[program]") {
  CHECK(time_left(10, 0.25) == "about 30 s left");  // a quarter took 10 s
  CHECK(time_left(119, 0.5) == "about 119 s left");
  CHECK(time_left(60, 0.1) == "about 9 min left");
  CHECK(time_left(4, 0.99) == "about 1 s left");
}

TEST_CASE("nothing is said of the time left where it is not known or soon over", "[program]") {
  CHECK(time_left(10, 0).empty());
  CHECK(time_left(10, 1).empty());
  CHECK(time_left(1, 0.5).empty());
}

TEST_CASE("a search says how far it is and how good its best design", "[program]") {
  CHECK(state_text({.combinations = 100, .done = 0.279, .best = 49.2, .unit = "mm"}) ==
        "27 of 100 combinations, best 49.2 mm");
  CHECK(state_text({.done = 0.5}) == "50 % searched, no design within the limits yet");
  CHECK(state_text({.iteration = 12, .best = 0.123456789, .unit = "1"}) ==
        "iteration 12, best 0.12346");
  CHECK(state_text({.iteration = 4, .best = 17.8, .unit = "mm", .stage = "knots, round 3"}) ==
        "knots, round 3: iteration 4, best 17.8 mm");
}

TEST_CASE("a front never counts more points than were asked for", "[program]") {
  CHECK(counted_points({.points = 27, .wanted = 40}) == "27 of 40 points");
  CHECK(counted_points({.points = 40, .wanted = 40}) == "40 of 40 points");
  CHECK(counted_points({.points = 54, .wanted = 40}) == "54 points, 40 asked for");
}

TEST_CASE("a front says how many of its points are found", "[program]") {
  CHECK(front_progress({.tasks = 9, .points = 5, .wanted = 8}) == "front: 5 of 8 points");
  CHECK(front_progress({.wanted = 8}) == "front: no point yet");
  CHECK(front_progress({.tasks = 1, .wanted = 8}) == "front: 1 search, no point yet");
  CHECK(front_progress({.tasks = 3, .wanted = 8}) == "front: 3 searches, no point yet");
}

}  // namespace camlaw::cli::progress_line_test
