// SPDX-License-Identifier: MIT
#pragma once

namespace camlaw::optim {

/// A stretch in which a library is at work that may end the program by itself. MUMPS, the linear
/// solver of Ipopt, has MPI_ABORT for what it holds to be impossible, and LAPACK has XERBLA: in
/// Fortran both are STOP, which ends the program with status 0, as if all were well. In such a
/// stretch an end with status 0 becomes an error on standard error and status 1 (EXIT_FAILURE).
class ExitGuard {
 public:
  /// `library` names it in the message, and outlives the guard. Null: the program's own code is at
  /// work, called by the library, and may end as it likes.
  explicit ExitGuard(const char* library);
  ExitGuard(const ExitGuard&) = delete;
  ExitGuard& operator=(const ExitGuard&) = delete;
  ~ExitGuard();

 private:
  const char* before_;
};

}  // namespace camlaw::optim
