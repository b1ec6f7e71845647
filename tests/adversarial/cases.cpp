// SPDX-License-Identifier: MIT
#include <stdexcept>

#include "tests/adversarial/case.h"

namespace camlaw::adversary {
namespace {

struct Kind {
  std::string name;
  Case (*make)(Random&);
  int weight;  ///< of a hundred cases or so
};

const std::vector<Kind>& all() {
  static const std::vector<Kind> kinds{{"law-rest", law_rest_case, 18},
                                       {"free-law", free_law_case, 8},
                                       {"stretch", stretch_case, 5},
                                       {"cam", cam_case, 12},
                                       {"box", box_case, 12},
                                       {"spike", spike_case, 10},
                                       {"dependent", dependent_case, 7},
                                       {"corner", corner_case, 4},
                                       {"hair", hair_case, 7},
                                       {"jump", jump_case, 4},
                                       {"valleys", valleys_case, 3},
                                       {"smooth", smooth_case, 6},
                                       {"undefined", undefined_case, 4},
                                       {"front-point", front_point_case, 3},
                                       {"wall", wall_case, 4}};
  return kinds;
}

}  // namespace

const std::vector<std::string>& kinds() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const Kind& kind : all()) list.push_back(kind.name);
    return list;
  }();
  return names;
}

Case make_case(std::uint64_t seed, std::uint64_t index, const std::string& kind) {
  Random random(seed, index);
  int total = 0;
  for (const Kind& k : all()) total += k.weight;
  int place = random.below(total);
  for (const Kind& k : all()) {
    if (!kind.empty()) {
      if (k.name == kind) return k.make(random);
    } else if ((place -= k.weight) < 0) {
      return k.make(random);
    }
  }
  throw std::invalid_argument("no class is called " + kind);
}

}  // namespace camlaw::adversary
