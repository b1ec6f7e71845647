// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <string>

#include "output/document/formatting.h"
#include "output/document/json.h"

namespace camlaw::cli {

/// An option or a variable of a design.
struct DesignValue {
  std::string name, unit, text;
  double number;             ///< NaN for a choice in words
  std::string measure = {};  ///< the same in the unit that it is stated in, "21.6 mm"

  /// "0.98 (21.6 mm)", "50 mm".
  std::string words() const {
    return with_unit(text, unit) + (measure.empty() ? "" : " (" + measure + ")");
  }
  Json json() const { return std::isnan(number) ? Json(text) : to_json(number); }
};

}  // namespace camlaw::cli
