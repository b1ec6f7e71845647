// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "optim/problem/problem.h"
#include "problems/statement/statement.h"
#include "tests/adversarial/plain_problem.h"
#include "tests/adversarial/random.h"

/// One problem twice: as the program gets it, and as the judge has it.
namespace camlaw::adversary {

struct Case {
  std::string kind;  ///< its class
  std::string text;  ///< a problem file; empty where `api` is stated
  problems::HeldFiles files = {};
  std::optional<optim::Problem> api = {};
  /// A front whose numbers come with enclosures that are too wide to show anything.
  std::optional<optim::Problem> vague_front = {};
  PlainProblem plain;
  /// Of a front: what is to be least, each a peak; the text has [[objectives]] then.
  struct Sought {
    int response;
    Part part;
  };
  std::vector<Sought> front = {};
  std::optional<Point> known = {};  ///< the global optimum, where it was chosen beforehand
  bool smooth = false;              ///< counts where the share of certificates is asked for
  bool evaluated = false;           ///< the printed peaks are compared too
};

/// The classes, in the order of the table.
const std::vector<std::string>& kinds();

/// The case of that number, a function of seed and number alone; of one class where it is named.
Case make_case(std::uint64_t seed, std::uint64_t index, const std::string& kind = "");

// Of single classes; cases_*.cpp.
Case law_rest_case(Random& random);
Case free_law_case(Random& random);
Case cam_case(Random& random);
Case box_case(Random& random);
Case spike_case(Random& random);
Case dependent_case(Random& random);
Case hair_case(Random& random);
Case smooth_case(Random& random);
Case corner_case(Random& random);
Case valleys_case(Random& random);
Case undefined_case(Random& random);
Case jump_case(Random& random);
Case stretch_case(Random& random);
Case front_point_case(Random& random);
Case wall_case(Random& random);

}  // namespace camlaw::adversary
