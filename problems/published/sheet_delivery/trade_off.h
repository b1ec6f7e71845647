// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "optim/verdict/verdict.h"

namespace camlaw::problems {

/// The best guide for one required slow-down.
struct DeliveryChoice {
  double slow_down = 0;  ///< required
  optim::Verdict verdict = {};
  double efficiency = 0;  ///< the least one within the stretch, at its greatest
  double price = 0;       ///< efficiency that one more of slow-down costs, to first order
  std::string law = {};
  double guide_ratio = 0, rod_angle_max = 0;  ///< lambda, and alpha_max in degrees
};

/// The trade-off of the sheet delivery between the slow-down of its carriage and the least
/// efficiency: greatest_least_efficiency.toml for even slow-downs of the range, over its laws,
/// lambda and alpha_max.
struct DeliveryQuestion {
  double least = 0.05, greatest = 0.5;  ///< of the slow-downs
  int points = 10;
  std::function<void(double share)> progress = {};  ///< told what share is done, 0 .. 1
  const std::atomic<bool>* stop = nullptr;
};
/// Throws std::invalid_argument for a range or count that makes none, and optim::Interrupted where
/// `stop` is set before the end.
std::vector<DeliveryChoice> trade_off_sheet_delivery(const DeliveryQuestion& question = {});

}  // namespace camlaw::problems
