// SPDX-License-Identifier: MIT
#include "optim/cycle/proof_time.h"

namespace camlaw::optim {
namespace {

thread_local ProofTime* of_this_thread = nullptr;
thread_local std::int64_t parts_of_this_thread = 0;

}  // namespace

ProofTime::ProofTime(const Deadline& deadline) : deadline_(deadline), before_(of_this_thread) {
  of_this_thread = this;
}

ProofTime::~ProofTime() { of_this_thread = before_; }

bool ProofTime::is_over() {
  if (of_this_thread == nullptr || !of_this_thread->deadline_.passed()) return false;
  of_this_thread->ended_ = true;
  return true;
}

void PartsOfBounds::look_at(std::int64_t count) { parts_of_this_thread += count; }

std::int64_t PartsOfBounds::looked_at() { return parts_of_this_thread; }

}  // namespace camlaw::optim
