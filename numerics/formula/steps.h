// SPDX-License-Identifier: MIT
#pragma once

#include <boost/functional/hash.hpp>
#include <cstdint>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "numerics/formula/formula.h"

/// What lists of steps are written and read with.
namespace camlaw {

/// Writes steps, equal ones once.
class Recorder {
 public:
  std::uint32_t write(const Step& step);
  const Step& at(std::uint32_t step) const { return steps_[step]; }
  const std::vector<Step>& steps() const { return steps_; }

 private:
  /// Numbers by their bits: so NaN is like itself, and -0 is not 0.
  using Key = std::tuple<Operation, std::uint32_t, std::uint32_t, std::uint32_t, std::uint64_t,
                         std::uint64_t, std::uint64_t>;
  std::vector<Step> steps_;
  std::unordered_map<Key, std::uint32_t, boost::hash<Key>> known_;
};

/// Returns how many earlier steps an operation uses.
std::size_t operands(Operation operation);

/// Which steps some of them need, these among them; as many as up to the last of these.
std::vector<bool> needed_for(const std::vector<std::uint32_t>& values,
                             const std::vector<Step>& steps);

/// Which steps an input from `first` on reaches.
std::vector<bool> reached_from(std::size_t first, const std::vector<Step>& steps);

}  // namespace camlaw
