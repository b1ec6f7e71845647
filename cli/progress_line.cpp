// SPDX-License-Identifier: MIT
#include "cli/progress_line.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace camlaw::cli {
namespace {

constexpr int kWidth = 78;

}  // namespace

ProgressLine::ProgressLine(bool shown) : shown_(shown && isatty(STDERR_FILENO) != 0) {}

ProgressLine::~ProgressLine() {
  if (printed_) fmt::print(stderr, "\r{:{}}\r", "", kWidth);
}

void ProgressLine::show(const std::string& text) {
  if (!shown_) return;
  printed_ = true;
  fmt::print(stderr, "\r{:{}.{}}", text, kWidth, kWidth);
  std::fflush(stderr);
}

}  // namespace camlaw::cli
