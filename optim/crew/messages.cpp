// SPDX-License-Identifier: MIT
#include "optim/crew/messages.h"

#include <sys/socket.h>

#include <cerrno>
#include <cstdint>
#include <cstring>

namespace camlaw::optim {
namespace {

using Size = std::uint64_t;  ///< what a message begins with: the number of bytes that follow

bool send_all(int socket, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(sent));
  }
  return true;
}

}  // namespace

bool send_message(int socket, std::string_view bytes) {
  const Size size = bytes.size();
  char head[sizeof size];
  std::memcpy(head, &size, sizeof size);
  return send_all(socket, {head, sizeof head}) && send_all(socket, bytes);
}

bool Inbox::read_some(int socket) {
  char block[1U << 16U];
  const ssize_t count = recv(socket, block, sizeof block, 0);
  if (count < 0) return errno == EINTR || errno == EAGAIN;
  bytes_.append(block, static_cast<std::size_t>(count));
  return count > 0;
}

bool Inbox::take(std::string& message) {
  Size size = 0;
  if (bytes_.size() < sizeof size) return false;
  std::memcpy(&size, bytes_.data(), sizeof size);
  if (bytes_.size() - sizeof size < size) return false;
  message = bytes_.substr(sizeof size, size);
  bytes_.erase(0, sizeof size + size);
  return true;
}

bool Inbox::may_become(std::size_t size) const {
  Size its = size;
  if (bytes_.size() >= sizeof its) std::memcpy(&its, bytes_.data(), sizeof its);
  return its == size;
}

bool receive_message(int socket, Inbox& inbox, std::string& message) {
  while (!inbox.take(message)) {
    if (!inbox.read_some(socket)) return false;
  }
  return true;
}

}  // namespace camlaw::optim
