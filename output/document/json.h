// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>
#include <vector>

#include "problems/law_files/json_text.h"

/// Values as JSON. Numbers keep every digit that a double has; unbounded ones are the strings "inf"
/// and "-inf", undefined ones null.
namespace camlaw::cli {

using Json = problems::Json;

Json to_json(double value);
Json to_json(const std::vector<double>& values);

/// The same of any value: numbers as to_json has them, an optional that is empty null.
template <class Value>
Json json_value(const Value& value) {
  if constexpr (std::is_floating_point_v<Value> || std::is_same_v<Value, std::vector<double>>) {
    return to_json(value);
  } else if constexpr (requires { value.has_value(); }) {
    return value ? json_value(*value) : Json(nullptr);
  } else {
    return value;
  }
}

}  // namespace camlaw::cli
