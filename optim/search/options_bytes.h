// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>

#include "optim/crew/bytes.h"
#include "optim/search/optimise.h"

/// What of searches is sent to other processes (optim/crew/bytes.h).
namespace camlaw::optim {

/// Why no other process can search so: "no other process knows the solver mine"; empty where any
/// can.
std::string why_confined(const OptimiseOptions& options);

template <>
inline constexpr int kLast<Verdict> = static_cast<int>(Verdict::Failed);

/// Without what is of one process: stop and whoever is told of the search. Names every member, so
/// that one which is added is not forgotten.
template <class Archive, class O>
requires std::is_same_v<std::remove_const_t<O>, OptimiseOptions>
void visit(Archive& archive, O& options) {
  auto& [solver, starts, seed, time_limit, spent, iterations, evaluations, memory, native, divides,
         narrows, stop, progress, candidate] = options;
  archive(solver), archive(starts), archive(seed), archive(time_limit), archive(spent);
  archive(iterations), archive(evaluations), archive(memory), archive(native), archive(divides);
  archive(narrows);
}

}  // namespace camlaw::optim
