// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "optim/pareto/task.h"

namespace camlaw::optim {

/// What processes of one build tell each other, as bytes, every number to the last bit.

std::string encoded(const Outcome& outcome);
/// None where the bytes are not those of one outcome.
std::optional<Outcome> decoded(std::string_view bytes);

/// A task and how it is to be carried out.
struct Order {
  Task task;
  OptimiseOptions options;  ///< but for stop and progress, which are of one process
};
std::string encoded(const Order& order);
std::optional<Order> decoded_order(std::string_view bytes);

std::string encoded(const std::vector<std::string>& texts);
std::optional<std::vector<std::string>> decoded_texts(std::string_view bytes);

}  // namespace camlaw::optim
