// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

#include <string>
#include <string_view>

/// What is the same of every process that this one starts.
namespace camlaw::optim {

/// Whether this process has one thread: only then may it be forked. What another thread has locked
/// (of the allocator, of a library) would stay locked in the child for ever.
bool has_one_thread();

/// The two ends of a socket for messages; no process that is started keeps them open. Both are
/// negative, and errno is set, where there is none to be had.
struct SocketEnds {
  int mine = -1, its = -1;
};
SocketEnds new_socket();

/// Of a process that has closed its socket, as waitpid tells it; one that lives on for a second
/// after that is ended.
int status_of(pid_t process);

/// "PROCESS was killed by signal 9 (Killed)", "PROCESS ended by itself with status 1".
std::string how_it_died(std::string_view process, int status);

}  // namespace camlaw::optim
