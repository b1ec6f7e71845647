// SPDX-License-Identifier: MIT
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>

#include "fitting/motions/law_fit_service.h"
#include "optim/crew/serve.h"

/// A process that works on a study: started by the library, with a socket as its standard input,
/// where the calling process has several threads and cannot be forked.
int main() {
  struct stat file {};
  if (fstat(STDIN_FILENO, &file) != 0 || !S_ISSOCK(file.st_mode)) {
    std::fputs("camlaw-worker: camlaw starts this program by itself; it takes no commands\n",
               stderr);
    return 2;
  }
  return camlaw::optim::serve_as_program(STDIN_FILENO, camlaw::problems::service_of_worker_or_fits);
}
