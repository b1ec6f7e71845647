// SPDX-License-Identifier: MIT
#include "output/document/terminal.h"

namespace camlaw::cli {
namespace {

bool quiet_ = false;

}  // namespace

void set_quiet(bool quiet) { quiet_ = quiet; }
bool is_quiet() { return quiet_; }

}  // namespace camlaw::cli
