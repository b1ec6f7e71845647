// SPDX-License-Identifier: MIT
#include <algorithm>

#include "machines/model/mechanism.h"
#include "numerics/lazy.h"

namespace camlaw::problems {
namespace {

std::vector<std::size_t> increasing(std::vector<std::size_t> indices) {
  std::sort(indices.begin(), indices.end());
  indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
  return indices;
}

}  // namespace

ParameterSet::ParameterSet(std::vector<std::size_t> indices)
    : ParameterSet([indices = std::move(indices)] { return indices; }) {}

ParameterSet::ParameterSet(std::initializer_list<std::size_t> indices)
    : ParameterSet(std::vector(indices)) {}

ParameterSet::ParameterSet(std::function<std::vector<std::size_t>()> find)
    : found_(std::make_shared<const Lazy<std::vector<std::size_t>>>(
          [find = std::move(find)] { return increasing(find()); })) {}

const std::vector<std::size_t>& ParameterSet::indices() const {
  static const std::vector<std::size_t> none;
  return found_ ? **found_ : none;
}

bool ParameterSet::holds(std::size_t parameter) const {
  return std::binary_search(begin(), end(), parameter);
}

ParameterSet united(std::vector<ParameterSet> sets) {
  return ParameterSet([sets = std::move(sets)] {
    std::vector<std::size_t> all;
    for (const ParameterSet& set : sets) all.insert(all.end(), set.begin(), set.end());
    return all;
  });
}

}  // namespace camlaw::problems
