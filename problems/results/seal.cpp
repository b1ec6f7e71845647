// SPDX-License-Identifier: MIT
#include "problems/results/seal.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "optim/study/checksum.h"

namespace camlaw::problems {
namespace {

constexpr const char* kKey = "checksum";

void add(optim::Checksum& checksum, const Json& value);

void add_members(optim::Checksum& checksum, const Json& object, bool outermost) {
  std::vector<std::string> keys;
  for (const auto& [key, member] : object.items()) {
    if (!outermost || key != kKey) keys.push_back(key);
  }
  std::sort(keys.begin(), keys.end());
  checksum.add('o', static_cast<std::int64_t>(keys.size()));
  for (const std::string& key : keys) {
    checksum.add('k', std::string_view(key));
    add(checksum, object[key]);
  }
}

/// A number as other programs may write it: 2 for 2.0.
void add_number(optim::Checksum& checksum, const Json& number) {
  const double value = number.get<double>();
  constexpr double kExact = 9007199254740992;  // 2^53
  if (number.is_number_integer() && std::abs(value) > kExact) {
    checksum.add('l', number.get<std::int64_t>());
  } else {
    checksum.add('d', value);
  }
}

/// As deep as parse_json lets brackets be nested.
void add(optim::Checksum& checksum, const Json& value) {
  if (value.is_object()) return add_members(checksum, value, false);
  if (value.is_number()) return add_number(checksum, value);
  if (value.is_string()) return checksum.add('s', value.get_ref<const std::string&>());
  if (value.is_boolean()) return checksum.add('b', std::int64_t{value.get<bool>()});
  if (!value.is_array()) return checksum.add('n', std::int64_t{0});
  checksum.add('a', static_cast<std::int64_t>(value.size()));
  for (const Json& item : value) add(checksum, item);
}

std::string text_of(const Json& object) {
  optim::Checksum checksum;
  add_members(checksum, object, true);
  return fmt::format("{:016x}", checksum.value());
}

}  // namespace

void seal(Json& object) { object[kKey] = text_of(object); }

Seal seal_of(const Json& object) {
  const auto stated = object.find(kKey);
  if (stated == object.end()) return Seal::None;
  return *stated == text_of(object) ? Seal::Fits : Seal::Broken;
}

}  // namespace camlaw::problems
