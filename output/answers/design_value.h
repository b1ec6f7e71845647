// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <string>

#include "output/document/json.h"

namespace camlaw::cli {

/// An option or a variable of a design.
struct DesignValue {
  std::string name, unit, text;
  double number;  ///< NaN for a choice in words

  Json json() const { return std::isnan(number) ? Json(text) : to_json(number); }
};

}  // namespace camlaw::cli
