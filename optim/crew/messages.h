// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// Messages over a socket between a study and the processes that work on it.
namespace camlaw::optim {

/// Whether all of it went out. No signal is raised where the other end is gone.
bool send_message(int socket, std::string_view bytes);

/// What arrives, put together to messages.
class Inbox {
 public:
  /// Reads once what there is, and waits where there is nothing. False where the other end is gone.
  bool read_some(int socket);
  /// The next message, where all of it has arrived.
  bool take(std::string& message);
  /// Whether what has arrived may be the beginning of a message of so many bytes.
  bool may_become(std::size_t size) const;

 private:
  std::string bytes_;
};

/// Waits for a whole message; false where the other end is gone.
bool receive_message(int socket, Inbox& inbox, std::string& message);

}  // namespace camlaw::optim
