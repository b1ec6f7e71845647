// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

/// Points that fill a cube more evenly than chance does.
namespace camlaw {

/// Sobol's sequence with a random digital shift: each point by itself is even over the open cube,
/// and means over 2^m of them come nearer to the integral than those of independent points do.
/// Equal seeds, equal bits. Without a seed there is no shift, and the sequence begins after its
/// first point, a corner of the cube. Sequence: Boost.Random, with the directions of Joe and Kuo
/// 2008; shift: Cranley and Patterson 1976 in base 2 (Owen 1998, "Latin supercube sampling").
class SobolPoints {
 public:
  /// Of at least one dimension and at most 3667. Throws std::invalid_argument for others.
  SobolPoints(std::size_t dimensions, std::optional<std::uint64_t> seed);
  ~SobolPoints();
  SobolPoints(SobolPoints&&) noexcept;

  /// The next points, one behind the other; the span holds a whole number of them.
  void next(std::span<double> points);
  /// Leaves the next so many points out, in a time that does not depend on their number.
  void skip(std::size_t count);

 private:
  struct Sequence;
  std::unique_ptr<Sequence> sequence_;
  std::vector<std::uint64_t> shift_;
};

/// Numbers that look random, one for each seed and place: of Steele, Lea and Flood 2014 (SplitMix).
std::uint64_t mixed(std::uint64_t seed, std::uint64_t place);

/// The normal distribution: its density, its share below u, and the u below which a share lies.
double normal_density(double u);
double normal_share(double u);
double normal_quantile(double share);

}  // namespace camlaw
