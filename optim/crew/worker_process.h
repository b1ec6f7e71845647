// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "optim/crew/crew.h"
#include "optim/crew/messages.h"

namespace camlaw::optim {

/// A process that carries out orders, one at a time. It ends with this object.
class WorkerProcess {
 public:
  /// A copy of this process, which must have one thread. `others` are closed in it. Throws
  /// std::runtime_error where there is no process to be had.
  static WorkerProcess forked(const Service& service, const std::vector<WorkerProcess>& others);
  /// A program; the process may have any number of threads. Does not wait for it: what it is given
  /// goes to it once it has said that it is a worker, and read() and late() tell where it is not
  /// one. Throws as forked() does, and where the program cannot be executed.
  static WorkerProcess started(const WorkerProgram& program);

  WorkerProcess(WorkerProcess&& other) noexcept;
  WorkerProcess& operator=(WorkerProcess&& other) noexcept;
  ~WorkerProcess();

  bool is_forked() const { return forked_; }
  int socket() const { return socket_; }
  /// Whether it waits for an order; not so where it has ended meanwhile.
  bool is_idle() const;
  bool is_busy() const { return errand_.has_value(); }
  bool has_ended() const { return process_ < 0; }
  std::size_t errand() const { return *errand_; }

  /// Gives it the order of an errand. False where the process is gone.
  bool give(std::size_t errand, const std::string& order);
  /// Asks it to answer with what it has.
  void ask_to_end() const;

  /// What has come of the errand, after some bytes have arrived.
  struct News {
    std::vector<std::string> told = {};      ///< on the way
    std::optional<std::string> answer = {};  ///< to the order
    std::string died = {};                   ///< how, where it did
    std::string failed_to_start = {};        ///< why; the order was not looked at
  };
  News read();
  /// The end of one that has not said within its patience that it is a worker; else nothing.
  News late();

 private:
  /// Of a program: what it has said so far.
  enum class Stage : char { Started, Greeted, Ready };
  /// What waits for the greeting, and how long.
  struct Awaited {
    WorkerProgram program = {};
    std::chrono::steady_clock::time_point latest = {};
    std::string order = {};
  };

  WorkerProcess(pid_t process, int socket, bool forked);
  void end();
  News died(News news);
  News refuse(const std::string& why);
  News hear_greeting();

  pid_t process_;
  int socket_;
  bool forked_;
  Stage stage_;
  Awaited awaited_;
  Inbox inbox_;
  std::optional<std::size_t> errand_;
};

}  // namespace camlaw::optim
