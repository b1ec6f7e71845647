// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <variant>

#include "optim/search/local.h"

/// Work that ends in time whatever it does. Searches look at the clock wherever the model is asked
/// (optim/search/interruptible.h); what they cannot leave, such as one long factorisation, is ended
/// from outside: the work is done in a child process, and the parent keeps the best design that the
/// child has told of.
namespace camlaw::cli {

/// When the work is to be done.
struct Watch {
  std::optional<double> limit;              ///< seconds
  double spent = 0;                         ///< seconds of it that have passed
  const std::atomic<bool>* stop = nullptr;  ///< set where the work is to end with what it has
  /// Seconds behind the limit after which the child is asked to end. Work that looks at the clock
  /// itself, and has no answer where it is asked to end, needs more where the computer is busy.
  double grace = 0.1;
};

/// What the child tells its parent.
class ChildTeller {
 public:
  explicit ChildTeller(int socket) : socket_(socket) {}
  void candidate(const optim::Candidate& candidate) const;
  /// The answer is about to be printed: from now on the child is not ended.
  void answers() const;

 private:
  int socket_;
};

/// The child was ended, or died.
struct Unfinished {
  std::string why;                             ///< "the time limit of 2 s was reached", ...
  std::optional<optim::Candidate> best, last;  ///< designs that the child told of
};

/// Does work in a child process, which goes on as this program would: it prints, and its exit
/// status comes back. Throws what the work throws, as std::invalid_argument or std::runtime_error.
/// At the limit, and on a stop, the child is asked to end (SIGTERM, which sets the stop flag where
/// an Interruptible lives) and has half of what it may be late to do so. It does not outlive the
/// parent. Where the process has several threads, which a child would lack, the work is done here,
/// and ends when it looks at the clock itself.
std::variant<int, Unfinished> watched(const Watch& watch,
                                      const std::function<int(const ChildTeller&)>& work);

/// By how many seconds a command may pass its limit: 1 s, or a tenth of the limit.
double most_late(double limit);

}  // namespace camlaw::cli
