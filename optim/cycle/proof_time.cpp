// SPDX-License-Identifier: MIT
#include "optim/cycle/proof_time.h"

namespace camlaw::optim {
namespace {

thread_local ProofTime* of_this_thread = nullptr;

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

}  // namespace camlaw::optim
