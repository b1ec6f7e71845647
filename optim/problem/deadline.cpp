// SPDX-License-Identifier: MIT
#include "optim/problem/deadline.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

namespace camlaw::optim {
namespace {

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

Deadline::Deadline(std::optional<double> limit, const std::atomic<bool>* stop, double spent)
    : limit_(limit), stop_(stop), began_(now() - spent) {}

std::optional<double> Deadline::left() const {
  if (!limit_) return {};
  constexpr double kLeast = 1e-3;  // s: solvers take 0 for no limit
  return std::max(kLeast, *limit_ - (now() - began_));
}

double Deadline::spent() const { return now() - began_; }

bool Deadline::stopped() const { return stop_ != nullptr && stop_->load(); }

bool Deadline::passed() const { return stopped() || (limit_ && now() - began_ >= *limit_); }

void Deadline::check() const {
  if (passed()) throw Interrupted();
}

namespace {

thread_local const Deadline* of_this_work = nullptr;

}  // namespace

DeadlineScope::DeadlineScope(const Deadline& deadline) : before_(of_this_work) {
  of_this_work = &deadline;
}

DeadlineScope::~DeadlineScope() { of_this_work = before_; }

void check_deadline() {
  if (of_this_work != nullptr) of_this_work->check();
}

std::string Deadline::reason() const {
  const bool late = limit_ && now() - began_ >= *limit_;
  return late ? fmt::format("the time limit of {:g} s was reached", *limit_) : "stopped";
}

}  // namespace camlaw::optim
