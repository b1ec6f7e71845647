// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "problems/law_files/json_type.h"
#include "problems/sweeps/axis.h"

/// The combinations of a sweep and the order in which they are worked out, both fixed by what is
/// asked alone.
namespace camlaw::problems {

/// What a sweep is asked for.
struct SweepSettings {
  std::vector<std::string> set = {};  ///< the same in all combinations, as set_values takes it
  /// The same in all too, but set in each with what is swept: of a table that is swept, which may
  /// be possible only as a whole.
  std::vector<std::string> together = {};
  std::vector<SweepAxis> axes = {};
  std::optional<Sampling> sampling = {};
  bool evaluates = false;  ///< the file's own design in each combination, without a search
  bool is_cold = false;    ///< each search begins as a single run does
  /// Of `set` what --set itself says, which fixes the parts that it names; the rest begins.
  std::vector<std::string> fixed = {};
};

/// Adds what `--set` says, each an axis or the same in all combinations.
void add_settings(SweepSettings& settings, const std::vector<std::string>& assignments);
/// Throws std::invalid_argument where one of these sets a name to one value that is swept too.
void check_set_or_swept(const SweepSettings& settings, const std::vector<std::string>& assignments);
/// What `--sample` and `--over` say.
Sampling stated_sampling(const std::string& sample, std::uint64_t seed,
                         const std::vector<std::string>& over);

/// A name that is swept: an axis, or a range of the sampling.
struct SweptName {
  std::string name, unit;
  bool is_numeric = false;
};

/// A value of one combination.
struct SweptValue {
  std::string text;       ///< as `--set` takes it
  double number = 0;      ///< of a numeric name, in its unit
  std::size_t index = 0;  ///< of an axis, which of its values
};

class SweepPlan {
 public:
  /// What is set of a table that is swept becomes set together with it: ranges.speed.lower where
  /// ranges.speed.upper is swept. Throws std::invalid_argument where nothing is swept, a name is
  /// swept twice, a sampling has no ranges, or there are more than kMostSwept combinations.
  explicit SweepPlan(SweepSettings settings);

  const SweepSettings& settings() const { return settings_; }
  /// The axes, then the ranges of the sampling.
  const std::vector<SweptName>& names() const { return names_; }
  /// Gives numbers that are swept without a unit the unit that they have in the problem.
  void take_units(const std::function<std::string(const std::string& name)>& unit_of);
  std::size_t size() const { return size_; }
  /// Of each name. Combinations count with the last axis running fastest but for the samples, which
  /// run faster still.
  std::vector<SweptValue> values(std::size_t combination) const;
  /// What set_values takes beside the file and `settings().set`.
  std::vector<std::string> assignments(std::size_t combination) const;

  /// Combinations one after the other: the first of each chain begins as a single run does, every
  /// other one at the design of the one before, which differs from it by one step of one number, or
  /// is a near sample. Chains are at most kChain long, so that there are some to share out and
  /// a wrong turn does not lead far.
  std::vector<std::vector<std::size_t>> chains() const;

 private:
  std::size_t samples() const { return samples_.empty() ? 1 : samples_.size(); }
  std::vector<std::size_t> in_sequence() const;
  std::optional<std::size_t> chained_axis() const;

  SweepSettings settings_;
  std::vector<SweptName> names_;
  std::vector<std::vector<double>> samples_;
  std::size_t size_ = 1;
};

/// A sweep of a hundred combinations has a dozen chains to share out.
inline constexpr std::size_t kChain = 8;

/// As a record keeps it, and back. Throws std::invalid_argument for what is damaged.
Json to_json(const SweepSettings& settings);
SweepSettings sweep_settings(const Json& record, std::vector<std::string> set);

}  // namespace camlaw::problems
