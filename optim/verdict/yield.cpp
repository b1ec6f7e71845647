// SPDX-License-Identifier: MIT
#include "optim/verdict/yield.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "numerics/linear/statistics.h"
#include "numerics/sampling/sobol_points.h"
#include "optim/problem/interrupted.h"

namespace camlaw::optim {
namespace {

using Numbers = std::vector<double>;

/// The error is read off their scatter: of 32 it is known to an eighth of itself.
constexpr std::size_t kRepetitions = 32;
/// Whole rounds count: a stop loses those from the first draw on that is not there.
constexpr std::size_t kMostInRound = 4096, kYieldRounds = 16;
/// Rounds are handed out together, a quarter of all points at a time, as workers wait for each
/// other at the end; but no more points than whose draws fit into some 100 MB.
constexpr std::size_t kTogether = 4, kMostTogether = std::size_t{1} << 20;

Mixture plain(std::size_t dimensions) { return {{Numbers(dimensions, 0.0)}, {1.0}, {1.0}}; }

/// The point in the numbers that vary.
Numbers varying_part(const DesignPoint& point, const std::vector<Variation>& variations) {
  Numbers part;
  for (std::size_t i = 0; i < variations.size(); ++i) {
    if (variations[i].varies()) part.push_back(point.u[i]);
  }
  return part;
}

/// About what is meant a fifth of the samples, so that no weight is above five, and a tenth with
/// the spread of what fails; the same share for each limit that has points (TV3).
Mixture about(const FailureRegions& regions, const std::vector<Variation>& variations,
              std::size_t dimensions) {
  constexpr double kMeant = 0.2, kWide = 0.1;
  Mixture mixture = plain(dimensions);
  mixture.shares = {kMeant};
  const auto add = [&](Numbers centre, double share, double spread) {
    mixture.centres.push_back(std::move(centre));
    mixture.shares.push_back(share);
    mixture.spreads.push_back(spread);
  };
  add(Numbers(dimensions, 0.0), kWide, regions.spread);
  const auto limits = std::count_if(regions.of_limit.begin(), regions.of_limit.end(),
                                    [](const auto& points) { return !points.empty(); });
  for (const std::vector<DesignPoint>& points : regions.of_limit) {
    double sum = 0;
    for (const DesignPoint& point : points) sum += normal_share(-std::abs(point.index));
    for (const DesignPoint& point : points) {
      // Half in equal parts, for what is farther may be wider.
      const double likely = normal_share(-std::abs(point.index)) / sum;
      const double share = (1 / static_cast<double>(points.size()) + likely) / 2;
      add(varying_part(point, variations),
          (1 - kMeant - kWide) * share / static_cast<double>(limits), 1);
    }
  }
  return mixture;
}

/// How many of `count` points are drawn about each centre: whole numbers, at least one. About what
/// is meant no less than a fifth of all, so that rounding leaves no weight above five.
std::vector<std::size_t> drawn_about(const Mixture& mixture, std::size_t count) {
  std::vector<std::size_t> own;
  for (const double share : mixture.shares) {
    const double exact = share * static_cast<double>(count);
    own.push_back(std::max<std::size_t>(1, static_cast<std::size_t>(std::llround(exact))));
  }
  const std::size_t others = std::accumulate(own.begin() + 1, own.end(), std::size_t{0});
  own.front() = std::max(own.front(), (others + 3) / 4);
  return own;
}

constexpr double kConfidence = 0.95;  // the interval that is stated beside a yield
constexpr double kLargestWeight = 5;  // a fifth is drawn about what is meant

/// A share of one kind over all repetitions.
struct Estimate {
  double share = 0, error = 0;
  Bounds between;
  Tally all;
};

/// The error that counts: of so few repetitions it scatters itself.
double inflated(double error) {
  return error * student_quantile(kRepetitions - 1, kConfidence) /
         normal_quantile((1 + kConfidence) / 2);
}

/// How many points of a sequence are as good as one that is drawn by itself (theory: TV8a).
double alike(const Estimate& found, double samples) {
  const double independent = found.share * (1 - found.share) / samples;
  if (!(independent > 0)) return 1;
  return std::max(1.0, std::pow(inflated(found.error), 2) / independent);
}

/// Of failures that count alike, few or many (theory: "How sure a fraction is").
Bounds counted_between(const Estimate& found, std::size_t samples) {
  constexpr std::size_t kMany = 640;  // twenty failures, and as many that hold, in each repetition
  if (std::min(found.all.hits, samples - found.all.hits) < kMany) {
    const auto hits = static_cast<double>(found.all.hits), count = static_cast<double>(samples);
    const double clump = alike(found, count);
    const auto between = binomial_interval(hits / clump, count / clump, kConfidence);
    return {between.lower, between.upper};
  }
  const double reach = student_quantile(kRepetitions - 1, kConfidence) * found.error;
  return {std::max(0.0, found.share - reach), std::min(1.0, found.share + reach)};
}

/// Of weighted failures (theory: TV8, TV9): the variance is the larger one of what the weights and
/// what the repetitions tell.
Bounds weighted_between(const Estimate& found, double largest, std::size_t samples) {
  constexpr double kFew = 30;  // of so few the largest weight may not have been met
  const Tally& tally = found.all;
  const auto count = static_cast<double>(samples);
  const double told = tally.squares > 0 ? tally.sum * tally.sum / tally.squares : 0;
  const double variance =
      std::max(tally.squares / (count * count), std::pow(inflated(found.error), 2));
  const double heaviest = told >= kFew ? tally.largest : largest;
  const auto between =
      weighted_poisson_interval(found.share, variance, heaviest / count, kConfidence);
  return {between.lower, std::min(between.upper, 1.0)};
}

/// `largest`: the largest weight that a sample can have. `kind` picks the tally of one repetition.
template <class Kind>
Estimate estimate_of(const std::vector<PartsCount>& all, double largest, const Kind& kind) {
  const auto count = static_cast<double>(all.size());
  Estimate result;
  Numbers shares;
  std::size_t samples = 0;
  for (const PartsCount& one : all) {
    const Tally& own = kind(one);
    shares.push_back(own.sum / static_cast<double>(one.samples));
    result.share += shares.back() / count;
    result.all.add(own);
    samples += one.samples;
  }
  double squares = 0;
  for (const double share : shares) squares += (share - result.share) * (share - result.share);
  result.error = std::sqrt(squares / (count - 1) / count);
  result.between =
      largest == 1 ? counted_between(result, samples) : weighted_between(result, largest, samples);
  return result;
}

void add_up(const std::vector<PartsCount>& all, Yield& result) {
  const double largest = result.by_importance ? kLargestWeight : 1;
  const Estimate failing =
      estimate_of(all, largest, [](const PartsCount& c) -> const Tally& { return c.failing; });
  const Estimate doubtful =
      estimate_of(all, largest, [](const PartsCount& c) -> const Tally& { return c.doubtful; });
  result.failing = failing.share;
  result.error = failing.error;
  result.failing_at_most = doubtful.share;
  result.failing_between = {failing.between.lower, doubtful.between.upper};
  result.failures = failing.all.hits;
  for (std::size_t i = 0; i < result.by_limit.size(); ++i) {
    const Estimate own = estimate_of(
        all, largest, [i](const PartsCount& c) -> const Tally& { return c.by_limit[i]; });
    result.by_limit[i] = own.share;
    result.by_limit_between[i] = own.between;
  }
  for (const PartsCount& one : all) {
    result.samples += one.samples;
    result.impossible += one.impossible;
  }
  if (result.by_importance) {
    // TV10
    const double unseen =
        -kLargestWeight * std::log(1 - kConfidence) / static_cast<double>(result.samples);
    result.unseen_at_most = std::min(1.0, unseen);
  }
}

/// The draws of a round: `count` points more for each repetition, each with points of its own, in
/// blocks. Their weights are of the mixture that is drawn in this round. `from`: how many points
/// about each centre were drawn before; moved on.
std::vector<PartsDraw> round_of(Mixture mixture, std::size_t count, std::uint64_t seed,
                                std::vector<std::size_t>& from) {
  const std::vector<std::size_t> own = drawn_about(mixture, count);
  const auto sum = static_cast<double>(std::accumulate(own.begin(), own.end(), std::size_t{0}));
  for (std::size_t j = 0; j < own.size(); ++j) {
    mixture.shares[j] = static_cast<double>(own[j]) / sum;
  }
  std::vector<PartsDraw> draws;
  for (std::size_t r = 0; r < kRepetitions; ++r) {
    for (std::size_t j = 0; j < own.size(); ++j) {
      for (std::size_t done = 0; done < own[j]; done += kPartsBlock) {
        draws.push_back({mixture, j, mixed(seed, r * 1024 + j), from[j] + done,
                         std::min(kPartsBlock, own[j] - done)});
      }
    }
  }
  for (std::size_t j = 0; j < own.size(); ++j) from[j] += own[j];
  return draws;
}

/// Repetitions of one estimate, in rounds that double the points, so that each stop leaves equally
/// many in all of them.
class Estimator {
 public:
  Estimator(Mixture mixture, std::uint64_t seed, const CountParts& count, std::size_t limits)
      : mixture_(std::move(mixture)),
        seed_(seed),
        count_(count),
        all_(kRepetitions),
        from_(mixture_.centres.size(), 0) {
    for (PartsCount& one : all_) one.by_limit.resize(limits);
  }

  /// Draws until each repetition has so many points. Whether it was not stopped.
  bool draw_to(std::size_t each) {
    while (done_ < each) {
      std::vector<Round> rounds;
      std::vector<PartsDraw> draws;
      const std::size_t until = done_ + std::clamp(each / kTogether, kMostInRound, kMostTogether);
      for (std::size_t at = done_; at < std::min(each, until); at += rounds.back().points) {
        const std::size_t most = std::clamp(each / kYieldRounds, kMostInRound, kMostTogether);
        // At least one about each centre.
        const std::size_t points =
            std::min({each - at, std::max<std::size_t>(at, mixture_.centres.size()), most});
        for (PartsDraw& draw : round_of(mixture_, points, seed_, from_)) {
          draws.push_back(std::move(draw));
        }
        rounds.push_back({points, draws.size()});
      }
      if (!add(rounds, count_(draws))) return false;
    }
    return true;
  }
  std::size_t failures() const {
    std::size_t sum = 0;
    for (const PartsCount& one : all_) sum += one.failing.hits;
    return sum;
  }
  void add_to(Yield& result) const {
    if (done_ > 0) add_up(all_, result);
  }

 private:
  struct Round {
    std::size_t points = 0;  ///< of each repetition
    std::size_t end = 0;     ///< of its draws
  };

  /// A round counts as a whole, or not at all. Whether all are there.
  bool add(const std::vector<Round>& rounds, const std::vector<PartsCount>& counted) {
    std::size_t begin = 0;
    for (const Round& round : rounds) {
      if (counted.size() < round.end) return false;
      const std::size_t of_each = (round.end - begin) / all_.size();
      for (std::size_t k = begin; k < round.end; ++k) {
        all_[(k - begin) / of_each].add(counted[k]);
      }
      done_ += round.points;
      begin = round.end;
    }
    return true;
  }

  Mixture mixture_;
  std::uint64_t seed_;
  const CountParts& count_;
  std::vector<PartsCount> all_;    ///< of each repetition
  std::vector<std::size_t> from_;  ///< points drawn about each centre
  std::size_t done_ = 0;
};

/// The index of each limit; none of equations that cannot break.
void add_indices(const std::vector<std::vector<DesignPoint>>& of_limit, Yield& result) {
  for (const std::vector<DesignPoint>& points : of_limit) {
    result.indices.push_back(points.empty() ? std::nullopt : std::optional(points.front().index));
  }
}

/// The regions to draw parts about; none where it is stopped.
FailureRegions regions_of(const PartsDrawer& drawer, const std::vector<RoomSlopes>& slopes,
                          Design x, const std::vector<Variation>& variations,
                          const YieldOptions& options, Yield& result) {
  constexpr double kFarthest = 8;  // beyond that no share is left that counts
  // An eighth of all parts finds them.
  constexpr std::size_t kShare = 8, kFewest = 192, kMost = 3072;
  constexpr std::uint64_t kRegions = std::uint64_t{1} << 33U;
  FailureRegions regions;
  if (slopes.empty()) return regions;
  try {
    regions = failure_regions(drawer, slopes, x, variations,
                              {std::clamp(options.samples / kShare, kFewest, kMost),
                               mixed(options.seed, kRegions), options.stopped});
  } catch (const Interrupted&) {
    result.stopped = true;
    return {};
  }
  add_indices(regions.of_limit, result);
  // The nearest ones, so few that some samples are drawn about each.
  constexpr std::size_t kAboutEach = 4;
  const std::size_t most =
      std::max<std::size_t>(1, options.samples / (kRepetitions * kAboutEach * drawer.limits()));
  for (std::vector<DesignPoint>& points : regions.of_limit) {
    if (points.size() > most) points.resize(most);
    std::erase_if(points, [](const DesignPoint& p) { return std::abs(p.index) >= kFarthest; });
  }
  return regions;
}

/// Without a look at parts: those that the limits' slopes lead to.
void find_indices(const std::vector<RoomSlopes>& slopes, Design x,
                  const std::vector<Variation>& variations, const std::function<bool()>& stopped,
                  Yield& result) {
  std::vector<std::vector<DesignPoint>> of_limit;
  try {
    for (const RoomSlopes& room : slopes) {
      result.stopped = result.stopped || stopped();
      if (result.stopped) break;
      of_limit.push_back(failing_points(room, x, variations, {}));
    }
  } catch (const Interrupted&) {
    result.stopped = true;
  }
  add_indices(of_limit, result);
}

}  // namespace

Yield yield(const PartsDrawer& drawer, const std::vector<RoomSlopes>& slopes, Design x,
            const std::vector<Variation>& variations, const YieldOptions& options) {
  if (options.samples < 1) throw std::invalid_argument("samples: at least one is needed");
  const CountParts count = options.count ? options.count : counted_here(drawer, options.stopped);
  const std::size_t limits = drawer.limits();
  Yield result;
  result.by_limit.assign(limits, 0.0);
  result.by_limit_between.assign(limits, Bounds{0, 1});
  // A yield of 99 % leaves some 41 failures among them, enough for an error of 16 %.
  constexpr std::size_t kFirst = 4096;
  constexpr double kRare = 0.01;  // rarer failures are drawn where they are likely
  const auto each = std::max<std::size_t>(1, options.samples / kRepetitions);
  const std::size_t tried = std::min<std::size_t>(kFirst / kRepetitions, each);
  Estimator as_meant(plain(drawer.dimensions()), options.seed, count, limits);
  result.stopped = !as_meant.draw_to(tried);
  const double rare = kRare * static_cast<double>(tried * kRepetitions);
  if (result.stopped || static_cast<double>(as_meant.failures()) >= rare) {
    result.stopped = result.stopped || !as_meant.draw_to(each);
    if (!result.stopped) find_indices(slopes, x, variations, options.stopped, result);
    as_meant.add_to(result);
    return result;
  }
  const FailureRegions regions = regions_of(drawer, slopes, x, variations, options, result);
  const bool has_points = std::any_of(regions.of_limit.begin(), regions.of_limit.end(),
                                      [](const auto& points) { return !points.empty(); });
  result.by_importance = has_points && !result.stopped;
  if (result.by_importance) {
    // Points of their own: few of the first failed, which is why these are drawn.
    constexpr std::uint64_t kOthers = std::uint64_t{1} << 32U;
    Estimator near(about(regions, variations, drawer.dimensions()), mixed(options.seed, kOthers),
                   count, limits);
    result.stopped = !near.draw_to(each);
    near.add_to(result);
  }
  if (result.samples == 0) {
    result.by_importance = false;
    result.stopped = result.stopped || !as_meant.draw_to(each);
    as_meant.add_to(result);
  }
  return result;
}

}  // namespace camlaw::optim
