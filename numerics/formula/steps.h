// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
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
  /// The place in the table of a step like this one, or the free place where it belongs.
  std::size_t place_of(const Step& step) const;
  void enlarge();

  std::vector<Step> steps_;
  /// Steps by their hashes, each as one more than its index; 0 is a free place. At most half of the
  /// places, a power of two, are taken, and a step is in the first free place from its hash on. A
  /// table of the library, with a node for each step, takes twice the time of recording.
  std::vector<std::uint32_t> table_;
};

/// Returns how many earlier steps an operation uses.
std::size_t operands(Operation operation);

/// Which steps some of them need, these among them; as many as up to the last of these.
std::vector<bool> needed_for(const std::vector<std::uint32_t>& values,
                             const std::vector<Step>& steps);

/// Which steps an input from `first` on reaches.
std::vector<bool> reached_from(std::size_t first, const std::vector<Step>& steps);

}  // namespace camlaw
