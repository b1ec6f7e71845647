// SPDX-License-Identifier: MIT
#pragma once

#include "optim/problem/problem.h"

/// How much memory there is, and for how many searches side by side.
namespace camlaw::optim {

/// Bytes that this process may still take: of the machine, of its control groups and of its limit
/// of address space the least. Infinite where nothing is known.
double free_memory();

/// As many of the workers as have room for the searches of a problem in so many bytes. Throws
/// MemoryRefusal where not one has.
int workers_with_room(int workers, const Problem& problem, double allowed);

}  // namespace camlaw::optim
