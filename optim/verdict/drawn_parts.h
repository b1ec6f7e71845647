// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "optim/verdict/room_rows.h"
#include "optim/verdict/variation.h"

/// Parts that are drawn about a design, and how many of them break a limit. What is drawn is plain
/// data, and what is counted follows from it to the last bit: so it does not matter who counts.
namespace camlaw::optim {

/// Where parts are drawn: about some points in normal numbers, with these shares and deviations.
struct Mixture {
  std::vector<std::vector<double>> centres;
  std::vector<double> shares, spreads;

  /// The normal density over that of the mixture.
  double weight(std::span<const double> u) const;
};

/// Points of a sequence about one of the centres: `count` of them, after the first `from`.
struct PartsDraw {
  Mixture mixture = {};
  std::size_t about = 0;
  std::uint64_t seed = 0;
  std::size_t from = 0, count = 0;
};

/// Parts of one kind, weighted.
struct Tally {
  double sum = 0, squares = 0, largest = 0;  ///< of the weights
  std::size_t hits = 0;

  void add(double weight);
  void add(const Tally& other);
};

struct PartsCount {
  Tally failing, doubtful;
  std::vector<Tally> by_limit;
  std::size_t impossible = 0, samples = 0;

  void add(const PartsCount& other);
};

/// Counts what each draw comes to, in their order; where the work is stopped, those up to there.
using CountParts = std::function<std::vector<PartsCount>(const std::vector<PartsDraw>&)>;

/// Draws parts about a design. The rooms are referred to.
class PartsDrawer {
 public:
  /// Throws std::invalid_argument where there are not as many variations as variables, or none
  /// varies.
  PartsDrawer(const RoomRows& rows, Design x, const std::vector<Variation>& variations);

  /// How many numbers vary.
  std::size_t dimensions() const { return varying_.size(); }
  std::size_t limits() const { return rows_.limits(); }
  /// The room of each limit at parts in normal numbers, those that vary of one part behind those of
  /// the one before: [limit * count + part], as RoomRows has it.
  std::vector<double> room(std::span<const double> us) const;
  /// None where it is stopped, or the rooms are cut short.
  std::optional<PartsCount> count(const PartsDraw& draw,
                                  const std::function<bool()>& stopped) const;

 private:
  std::optional<PartsCount> count_all(const PartsDraw& draw,
                                      const std::function<bool()>& stopped) const;
  void count_block(const PartsDraw& draw, const std::vector<double>& designs,
                   const std::vector<double>& us, std::size_t block, PartsCount& counted) const;

  const RoomRows& rows_;
  std::vector<double> slack_, x_;
  std::vector<Variation> variations_;
  std::vector<std::size_t> varying_;
};

/// Counts in the calling thread. Both are referred to.
CountParts counted_here(const PartsDrawer& drawer, const std::function<bool()>& stopped);

/// Points of a draw that are judged together.
inline constexpr std::size_t kPartsBlock = 512;

}  // namespace camlaw::optim
