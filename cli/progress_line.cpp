// SPDX-License-Identifier: MIT
#include "cli/progress_line.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

#include "output/document/terminal.h"

namespace camlaw::cli {
namespace {

constexpr int kWidth = 78;  // of the 80 columns that any terminal has

}  // namespace

std::string time_left(double seconds, double done) {
  constexpr double kSoon = 2, kMinutes = 120;  // what is over before is not worth a word
  if (!(done > 0 && done < 1) || seconds < kSoon) return {};
  const double left = seconds * (1 - done) / done;
  return left < kMinutes ? fmt::format("about {:.0f} s left", std::ceil(left))
                         : fmt::format("about {:.0f} min left", std::ceil(left / 60));
}

ProgressLine::ProgressLine(bool shown)
    : shown_(shown && !is_quiet() && isatty(STDERR_FILENO) != 0) {}

ProgressLine::~ProgressLine() { clear(); }

void ProgressLine::show(const std::string& text) {
  if (!shown_ || text == printed_) return;
  printed_ = text;
  fmt::print(stderr, "\r{:{}.{}}", text, kWidth, kWidth);
  std::fflush(stderr);
}

void ProgressLine::show(const std::string& text, double done) {
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - began_;
  const std::string left = time_left(spent.count(), done);
  show(left.empty() ? text : text + ", " + left);
}

void ProgressLine::clear() {
  if (!printed_.empty()) fmt::print(stderr, "\r{:{}}\r", "", kWidth);
  printed_.clear();
}

}  // namespace camlaw::cli
