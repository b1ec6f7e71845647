// SPDX-License-Identifier: MIT
#pragma once

#include <csignal>
#include <functional>
#include <string>
#include <string_view>

#include "optim/crew/crew.h"

/// The part of a process that carries out orders.
namespace camlaw::optim {

/// What a worker sends: a letter that says what it is, and its bytes.
inline constexpr char kAnswer = 'a', kNews = 'n';

/// Asks a worker to answer with what it has. It is a signal that does nothing to a process that has
/// not begun to listen.
inline constexpr int kFarewellSignal = SIGURG;

/// Carries out what arrives at the socket and answers each, until the other end is gone. An
/// interrupt or a request to end, which may be sent to all processes at once, is for whoever gives
/// the orders to handle, and ignored here: else work that was cut short would be taken for work
/// that failed.
void serve(int socket, const Service& service);

/// What a program that is started for this says first. The number counts the versions of what is
/// said after it (messages.h, bytes.h).
inline constexpr std::string_view kGreeting = "camlaw worker 2";

/// The whole of a program that is started for this: greets, takes the problem from the socket,
/// answers with an empty message, or with what `service_of` throws, and serves. Ends at once where
/// the other end goes away in the middle of an order. Returns the exit status.
int serve_as_program(int socket, const std::function<Service(const std::string&)>& service_of);

}  // namespace camlaw::optim
