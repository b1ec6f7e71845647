// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "optim/pareto/task.h"

namespace camlaw::optim {

/// How long the searches of a study take, as those before them tell: by their evaluations, which do
/// not depend on who counts. Where the long ones are handed out first, all workers end at about the
/// same time; what is found does not depend on it.
class Efforts {
 public:
  void learn(const Task& task, const Outcome& outcome);
  /// Places in `tasks`. Those of a kind and combination of which nothing is known come first; what
  /// is expected to take equally long stays in its order.
  std::vector<std::size_t> longest_first(const std::vector<Task>& tasks) const;

 private:
  struct Mean {
    double sum = 0, count = 0;
  };
  using Like = std::pair<Task::Kind, std::size_t>;  ///< kind and part
  std::map<Like, Mean> known_;
};

}  // namespace camlaw::optim
