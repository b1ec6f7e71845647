// SPDX-License-Identifier: MIT
// MPI as a plug-in: what does not ask for it needs no MPI.
#include "optim/crew/mpi_plugin.h"

#include <mpi.h>

#include <climits>
#include <list>
#include <set>
#include <string>

namespace {

/// A message on its way out.
struct Sending {
  std::string bytes;
  MPI_Request request = MPI_REQUEST_NULL;
};

/// MPI is one for a process.
struct Ranks {
  int size = 1;
  std::list<Sending> sending;
  std::set<int> gone;
  MPI_Message found = MPI_MESSAGE_NULL;
  std::size_t found_size = 0;
};

Ranks& ranks() {
  static Ranks all;
  return all;
}

constexpr int kTag = 1;  // any number will do, as there is one kind of message

void forget_sent() {
  ranks().sending.remove_if([](Sending& message) {
    int done = 0;
    return MPI_Test(&message.request, &done, MPI_STATUS_IGNORE) != MPI_SUCCESS || done != 0;
  });
}

const char* send(int rank, const char* bytes, std::size_t count) {
  if (count > INT_MAX) return "a message of more than 2 GiB";
  forget_sent();
  Sending& message = ranks().sending.emplace_back();
  message.bytes.assign(bytes, count);
  const int failed = MPI_Isend(message.bytes.data(), static_cast<int>(count), MPI_BYTE, rank, kTag,
                               MPI_COMM_WORLD, &message.request);
  if (failed == MPI_SUCCESS) return nullptr;
  ranks().sending.pop_back();
  ranks().gone.insert(rank);
  return "the rank cannot be reached";
}

bool found_from(int source, int* rank, std::size_t* count) {
  int found = 0;
  MPI_Status status;
  const int failed = MPI_Improbe(source, kTag, MPI_COMM_WORLD, &found, &ranks().found, &status);
  if (failed != MPI_SUCCESS && source != MPI_ANY_SOURCE) ranks().gone.insert(source);
  if (failed != MPI_SUCCESS || found == 0) return false;
  int length = 0;
  MPI_Get_count(&status, MPI_BYTE, &length);
  *rank = status.MPI_SOURCE;
  *count = ranks().found_size = static_cast<std::size_t>(length);
  return true;
}

int probe(int* rank, std::size_t* count) {
  forget_sent();
  int found = 0;
  MPI_Status status;
  // Where a rank has failed a look for any message may fail too: then each is looked at by itself.
  if (MPI_Iprobe(MPI_ANY_SOURCE, kTag, MPI_COMM_WORLD, &found, &status) == MPI_SUCCESS) {
    return found != 0 && found_from(status.MPI_SOURCE, rank, count);
  }
  for (int source = 0; source < ranks().size; ++source) {
    if (!ranks().gone.contains(source) && found_from(source, rank, count)) return 1;
  }
  return 0;
}

const char* receive(char* bytes) {
  const int failed = MPI_Mrecv(bytes, static_cast<int>(ranks().found_size), MPI_BYTE,
                               &ranks().found, MPI_STATUS_IGNORE);
  return failed == MPI_SUCCESS ? nullptr : "a message was cut short";
}

int is_gone(int rank) { return ranks().gone.contains(rank) ? 1 : 0; }

void close() {
  for (Sending& message : ranks().sending) MPI_Wait(&message.request, MPI_STATUS_IGNORE);
  ranks().sending.clear();
  MPI_Finalize();
}

}  // namespace

const char* CAMLAW_MPI(CamlawMpi* opened) {
  int provided = 0;
  if (MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided) != MPI_SUCCESS) {
    return "MPI does not start";
  }
  if (provided < MPI_THREAD_FUNNELED) return "this MPI does not allow for threads";
  MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN);
  MPI_Comm_rank(MPI_COMM_WORLD, &opened->rank);
  MPI_Comm_size(MPI_COMM_WORLD, &opened->size);
  ranks().size = opened->size;
  opened->send = send;
  opened->probe = probe;
  opened->receive = receive;
  opened->is_gone = is_gone;
  opened->close = close;
  return nullptr;
}
