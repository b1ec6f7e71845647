// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

/// Between the library and the plug-in that has MPI: plain C, as the plug-in is loaded by name. All
/// functions are called by the thread that opened it.
struct CamlawMpi {
  int rank, size;
  /// Takes the bytes over and does not wait until they have arrived. Null, or what went wrong.
  const char* (*send)(int rank, const char* bytes, std::size_t count);
  /// Whether a message is here; of which rank, and how long it is.
  int (*probe)(int* rank, std::size_t* count);
  /// Reads the message that probe() has found.
  const char* (*receive)(char* bytes);
  /// Whether a rank is known to have ended.
  int (*is_gone)(int rank);
  /// Ends MPI in this process; waits for the other ranks to do the same.
  void (*close)();
};

/// The function's name; its number grows when what is passed changes.
#define CAMLAW_MPI camlaw_mpi_1

extern "C" {
/// Begins MPI. Null, or what went wrong, which lives as long as the process.
const char* CAMLAW_MPI(CamlawMpi* opened);
using CamlawMpiOpen = const char* (*)(CamlawMpi* opened);
}
