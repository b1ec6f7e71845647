// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// What a sweep runs through, as people write it.
namespace camlaw::problems {

/// A name that `--set` takes, with each of the values that it gets in turn.
struct SweepAxis {
  std::string name;
  std::string unit = {};             ///< of the numbers, as it is written; empty: the listed one
  std::vector<std::string> values;   ///< as `--set` takes them: "60 rpm", "cycloidal"
  std::vector<double> numbers = {};  ///< the same in `unit`; empty where the values are words
  bool is_class = false;             ///< the values are all laws of a class

  bool is_numeric() const { return !numbers.empty(); }
};

/// A range that samples are drawn from.
struct SampledRange {
  std::string name, unit;
  double low = 0, high = 0;
};

enum class SampleMethod {
  Sobol,           ///< the Sobol sequence, which fills the box evenly for any count
  LatinHypercube,  ///< one sample in each of `count` slices of every range
};

struct Sampling {
  SampleMethod method = SampleMethod::Sobol;
  std::size_t count = 0;
  std::uint64_t seed = 1;
  std::vector<SampledRange> over;
};

/// What `--set` of a sweep says: "speed=60:15:120 rpm" from, step and to; "law=cycloidal,
/// modified-sine" and "roller_radius=10,12 mm" one after the other; "law=all" and other classes of
/// laws each law. A word in double quotes is a name, whatever it holds: 'roller="A, long","10"', a
/// quote in it doubled.
/// Of one value alone none: it is the same in all combinations. Throws
/// std::invalid_argument where a range has no end, a value is there twice, or there are too many.
std::optional<SweepAxis> parse_axis(const std::string& assignment);

/// A value as the list of an axis has it, read back by parse_axis: in double quotes where it would
/// read as several values or a range, such as "A, long" and "M:1". Not for laws.
std::string listed_value(const std::string& value);

/// "radius=10:40 mm".
SampledRange parse_sampled_range(const std::string& assignment);
/// "sobol 64" or "lhs 64".
Sampling parse_sampling(const std::string& text, std::uint64_t seed);
std::string to_string(SampleMethod method);

/// The samples, each one number for every range, rounded to eight digits. Of equal sampling equal
/// to the last bit.
std::vector<std::vector<double>> samples_of(const Sampling& sampling);

/// "60 rpm".
std::string swept_value(double number, const std::string& unit);

inline constexpr std::size_t kMostSwept = 100'000;

}  // namespace camlaw::problems
