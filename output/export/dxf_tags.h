// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <Eigen/Core>
#include <iterator>
#include <string>

#include "output/export/chords.h"

/// The text of DXF: pairs of a group code and a value.
namespace camlaw::problems::dxf {

/// Group codes and values, one each line.
class Tags {
 public:
  void text(int code, const std::string& value) {
    fmt::format_to(std::back_inserter(text_), "{:3}\n{}\n", code, value);
  }
  void integer(int code, int value) { text(code, std::to_string(value)); }
  /// Enough digits for every use of a length, an angle or a knot.
  void real(int code, double value) { text(code, fmt::format("{:.10f}", rounded(value, 10))); }
  void handle(int code, int value) { text(code, fmt::format("{:X}", value)); }
  void point(int code, const Eigen::Vector2d& p) {
    real(code, p.x());
    real(code + 10, p.y());
    real(code + 20, 0);
  }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

}  // namespace camlaw::problems::dxf
