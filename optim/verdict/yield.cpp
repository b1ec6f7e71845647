// SPDX-License-Identifier: MIT
#include "optim/verdict/yield.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "numerics/linear/statistics.h"
#include "numerics/sampling/sobol_points.h"
#include "optim/cycle/sizes.h"
#include "optim/problem/interrupted.h"
#include "optim/verdict/limits.h"

namespace camlaw::optim {
namespace {

using Numbers = std::vector<double>;

constexpr int kRepetitions = 32;
constexpr std::size_t kBlock = 512;
constexpr std::size_t kMostInRound = 4096;

class SearchedRooms final : public RoomRows {
 public:
  SearchedRooms(const Problem& problem, Design x) : problem_(problem) {
    problem_.objectives = {no_objective()};
    sizes_ = sizes(problem_, x);
  }

  std::size_t limits() const override { return problem_.constraints.size(); }
  std::vector<double> slack() const override { return Numbers(limits(), 0.0); }
  void room(std::span<const double> designs, std::size_t count,
            std::span<double> room) const override {
    const std::size_t n = problem_.variables.size();
    for (std::size_t k = 0; k < count; ++k) {
      const auto reports = limit_reports(problem_, sizes_, designs.subspan(k * n, n), false);
      for (std::size_t i = 0; i < reports.size(); ++i) {
        room[i * count + k] = reports[i].margin + reports[i].tolerance;
      }
    }
  }

 private:
  Problem problem_;
  Sizes sizes_;
};

/// Where samples are drawn: about some points in normal numbers, with these shares.
struct Mixture {
  std::vector<Numbers> centres;
  Numbers shares;

  /// The normal density over that of the mixture.
  double weight(std::span<const double> u) const {
    double sum = 0;
    for (std::size_t j = 0; j < centres.size(); ++j) {
      double exponent = 0;
      for (std::size_t i = 0; i < u.size(); ++i) {
        exponent += centres[j][i] * (u[i] - centres[j][i] / 2);
      }
      sum += shares[j] * std::exp(exponent);
    }
    return 1 / sum;
  }
};

/// Samples of one kind, weighted.
struct Tally {
  double sum = 0, squares = 0, largest = 0;  ///< of the weights
  std::size_t hits = 0;

  void add(double weight) {
    sum += weight;
    squares += weight * weight;
    largest = std::max(largest, weight);
    ++hits;
  }
  void add(const Tally& other) {
    sum += other.sum;
    squares += other.squares;
    largest = std::max(largest, other.largest);
    hits += other.hits;
  }
};

/// What was counted.
struct Counts {
  Tally failing, doubtful;
  std::vector<Tally> by_limit;
  std::size_t impossible = 0, samples = 0;
};

class Sampler {
 public:
  Sampler(const RoomRows& rows, Design x, const std::vector<Variation>& variations)
      : rows_(rows), slack_(rows.slack()), x_(x.begin(), x.end()), variations_(variations) {
    for (std::size_t i = 0; i < variations.size(); ++i) {
      if (variations[i].varies()) {
        varying_.push_back(i);
      } else {
        x_[i] += variations[i].lower;
      }
    }
  }

  std::size_t dimensions() const { return varying_.size(); }

  /// Adds the sums over the next `count` points about one of the mixture's centres. Whether all of
  /// them were drawn: not where it is stopped, or the rooms are cut short.
  bool draw(const Mixture& mixture, std::size_t about, std::size_t count, SobolPoints& points,
            Counts& counts, const std::function<bool()>& stopped) const {
    try {
      return draw_all(mixture, about, count, points, counts, stopped);
    } catch (const Interrupted&) {
      return false;
    }
  }

 private:
  bool draw_all(const Mixture& mixture, std::size_t about, std::size_t count, SobolPoints& points,
                Counts& counts, const std::function<bool()>& stopped) const {
    const std::size_t m = dimensions(), n = x_.size();
    const bool is_plain = mixture.centres.size() == 1;
    Numbers shares(kBlock * m), us(kBlock * m), designs(kBlock * n);
    for (std::size_t done = 0; done < count; done += kBlock) {
      if (stopped()) return false;
      const std::size_t block = std::min(kBlock, count - done);
      points.next(std::span(shares).first(block * m));
      for (std::size_t k = 0; k < block; ++k) {
        std::copy(x_.begin(), x_.end(), designs.begin() + static_cast<std::ptrdiff_t>(k * n));
        for (std::size_t i = 0; i < m; ++i) {
          const Variation& v = variations_[varying_[i]];
          double off = 0;
          if (is_plain) {
            off = v.at_share(shares[k * m + i]);
          } else {
            us[k * m + i] = mixture.centres[about][i] + normal_quantile(shares[k * m + i]);
            off = v.at(us[k * m + i]);
          }
          designs[k * n + varying_[i]] += off;
        }
      }
      count_block(mixture, is_plain, designs, us, block, counts);
    }
    return true;
  }

  void count_block(const Mixture& mixture, bool is_plain, const Numbers& designs, const Numbers& us,
                   std::size_t block, Counts& counts) const {
    const std::size_t limits = rows_.limits(), m = dimensions();
    Numbers room(limits * block);
    rows_.room(std::span(designs).first(block * x_.size()), block, room);
    for (std::size_t k = 0; k < block; ++k) {
      bool fails = false, may_fail = false, is_possible = true;
      for (std::size_t i = 0; i < limits; ++i) {
        const double left = room[i * block + k];
        fails |= !(left >= 0);
        may_fail |= !(left - slack_[i] >= 0);
        is_possible &= !std::isnan(left);
      }
      ++counts.samples;
      if (!may_fail) continue;
      const double weight = is_plain ? 1 : mixture.weight(std::span(us).subspan(k * m, m));
      counts.doubtful.add(weight);
      if (!fails) continue;
      counts.failing.add(weight);
      counts.impossible += !is_possible;
      for (std::size_t i = 0; i < limits; ++i) {
        if (!(room[i * block + k] >= 0)) counts.by_limit[i].add(weight);
      }
    }
  }

  const RoomRows& rows_;
  Numbers slack_;
  Numbers x_;
  const std::vector<Variation>& variations_;
  std::vector<std::size_t> varying_;
};

Mixture plain(std::size_t dimensions) { return {{Numbers(dimensions, 0.0)}, {1.0}}; }

/// About what is meant a fifth of the samples, so that no weight is above five.
Mixture about(const std::vector<DesignPoint>& points, std::size_t dimensions) {
  constexpr double kMeant = 0.2;
  Mixture mixture = plain(dimensions);
  mixture.shares = {kMeant};
  for (const DesignPoint& point : points) {
    mixture.centres.push_back(point.u);
    mixture.shares.push_back((1 - kMeant) / static_cast<double>(points.size()));
  }
  return mixture;
}

/// One of the repetitions: its points about each centre, with shifts of their own.
struct Repetition {
  std::vector<SobolPoints> points;
  Counts counts;
};

std::vector<Repetition> repetitions(const Sampler& sampler, const Mixture& mixture,
                                    const YieldOptions& options, std::size_t limits) {
  std::vector<Repetition> all(kRepetitions);
  for (std::size_t r = 0; r < all.size(); ++r) {
    all[r].counts.by_limit.resize(limits);
    for (std::size_t j = 0; j < mixture.centres.size(); ++j) {
      all[r].points.emplace_back(sampler.dimensions(), mixed(options.seed, r * 1024 + j));
    }
  }
  return all;
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

/// Draws about `count` points more for each repetition; their order decides nothing. The weights
/// are of the mixture that is drawn in this round. Whether it was drawn to its end.
bool draw_round(const Sampler& sampler, Mixture mixture, std::size_t count,
                const std::function<bool()>& stopped, std::vector<Repetition>& all) {
  const std::vector<std::size_t> own = drawn_about(mixture, count);
  double sum = 0;
  for (const std::size_t points : own) sum += static_cast<double>(points);
  for (std::size_t j = 0; j < own.size(); ++j) {
    mixture.shares[j] = static_cast<double>(own[j]) / sum;
  }
  for (Repetition& one : all) {
    for (std::size_t j = 0; j < own.size(); ++j) {
      if (!sampler.draw(mixture, j, own[j], one.points[j], one.counts, stopped)) return false;
    }
  }
  return true;
}

/// An interval that holds a share at 95 %, from few samples too (theory: TV8).
Bounds interval_of(const Tally& tally, double largest, std::size_t samples) {
  constexpr double kConfidence = 0.95;
  const auto count = static_cast<double>(samples);
  const auto found =
      largest == 1 ? binomial_interval(tally.hits, samples, kConfidence)
                   : weighted_poisson_interval(tally.sum / count, tally.squares / (count * count),
                                               largest / count, kConfidence);
  return {found.lower, std::min(found.upper, 1.0)};
}

/// A share of one kind over all repetitions.
struct Estimate {
  double share = 0, error = 0;
  Bounds between;
  Tally all;
};

/// `largest`: the largest weight that a sample can have. `kind` picks the tally of one repetition.
template <class Kind>
Estimate estimate_of(const std::vector<Repetition>& all, double largest, const Kind& kind) {
  constexpr double kMany = 640;  // twenty failures, and as many that hold, in each repetition
  const auto count = static_cast<double>(all.size());
  Estimate result;
  Numbers shares;
  std::size_t samples = 0;
  for (const Repetition& one : all) {
    const Tally& own = kind(one.counts);
    shares.push_back(own.sum / static_cast<double>(one.counts.samples));
    result.share += shares.back() / count;
    result.all.add(own);
    samples += one.counts.samples;
  }
  double squares = 0;
  for (const double share : shares) squares += (share - result.share) * (share - result.share);
  result.error = std::sqrt(squares / (count - 1) / count);
  const Tally& tally = result.all;
  const double told = tally.squares > 0 ? tally.sum * tally.sum / tally.squares : 0;
  const bool is_even = largest == 1;
  const double others = is_even ? static_cast<double>(samples - tally.hits) : kInfinity;
  if (std::min(told, others) >= kMany) {
    const double reach = student_quantile(kRepetitions - 1, 0.95) * result.error;
    result.between = {std::max(0.0, result.share - reach), std::min(1.0, result.share + reach)};
    return result;
  }
  // Of so few the largest weight may not have been met.
  constexpr double kFew = 30;
  const bool is_known = !is_even && told >= kFew;
  result.between = interval_of(tally, is_known ? tally.largest : largest, samples);
  return result;
}

void add_up(const std::vector<Repetition>& all, Yield& result) {
  constexpr double kLargestWeight = 5;  // a fifth is drawn about what is meant
  const double largest = result.by_importance ? kLargestWeight : 1;
  const Estimate failing =
      estimate_of(all, largest, [](const Counts& c) -> const Tally& { return c.failing; });
  const Estimate doubtful =
      estimate_of(all, largest, [](const Counts& c) -> const Tally& { return c.doubtful; });
  result.failing = failing.share;
  result.error = failing.error;
  result.failing_at_most = doubtful.share;
  result.failing_between = {failing.between.lower, doubtful.between.upper};
  result.failures = failing.all.hits;
  for (std::size_t i = 0; i < result.by_limit.size(); ++i) {
    const Estimate own =
        estimate_of(all, largest, [i](const Counts& c) -> const Tally& { return c.by_limit[i]; });
    result.by_limit[i] = own.share;
    result.by_limit_between[i] = own.between;
  }
  for (const Repetition& one : all) {
    result.samples += one.counts.samples;
    result.impossible += one.counts.impossible;
  }
}

/// Repetitions of one estimate, in rounds that double the points, so that each stop leaves equally
/// many in all of them.
class Estimator {
 public:
  Estimator(const Sampler& sampler, Mixture mixture, const YieldOptions& options,
            std::size_t limits)
      : sampler_(sampler),
        mixture_(std::move(mixture)),
        stopped_(options.stopped),
        all_(repetitions(sampler, mixture_, options, limits)) {}

  /// Draws until each repetition has so many points. Whether it was not stopped.
  bool draw_to(std::size_t each) {
    while (done_ < each) {
      const std::size_t wanted = std::max<std::size_t>(done_, 1);
      const std::size_t round = std::min({each - done_, wanted, kMostInRound});
      std::vector<Counts> before;
      for (const Repetition& one : all_) before.push_back(one.counts);
      if (!draw_round(sampler_, mixture_, round, stopped_, all_)) {
        // A round counts as a whole, or not at all.
        for (std::size_t r = 0; r < all_.size(); ++r) all_[r].counts = std::move(before[r]);
        return false;
      }
      done_ += round;
    }
    return true;
  }
  std::size_t failures() const {
    std::size_t sum = 0;
    for (const Repetition& one : all_) sum += one.counts.failing.hits;
    return sum;
  }
  void add_to(Yield& result) const {
    if (done_ > 0) add_up(all_, result);
  }

 private:
  const Sampler& sampler_;
  Mixture mixture_;
  const std::function<bool()>& stopped_;
  std::vector<Repetition> all_;
  std::size_t done_ = 0;
};

/// The points of different limits; those of equations that cannot break are none.
std::vector<DesignPoint> points_of(const std::vector<RoomSlopes>& slopes, Design x,
                                   const std::vector<Variation>& variations,
                                   const std::function<bool()>& stopped, Yield& result) {
  constexpr double kFarthest = 8;  // beyond that no share is left that counts
  std::vector<DesignPoint> points;
  for (const RoomSlopes& room : slopes) {
    result.stopped = result.stopped || stopped();
    if (result.stopped) break;
    std::optional<DesignPoint> found;
    try {
      found = design_point(room, x, variations);
    } catch (const Interrupted&) {
      result.stopped = true;
      break;
    }
    result.indices.push_back(found ? std::optional(found->index) : std::nullopt);
    if (found && std::abs(found->index) < kFarthest) points.push_back(*found);
  }
  return points;
}

/// The point in the numbers that vary.
DesignPoint varying_part(const DesignPoint& point, const std::vector<Variation>& variations) {
  DesignPoint part{{}, point.index};
  for (std::size_t i = 0; i < variations.size(); ++i) {
    if (variations[i].varies()) part.u.push_back(point.u[i]);
  }
  return part;
}

}  // namespace

std::unique_ptr<RoomRows> searched_rooms(const Problem& problem, Design x) {
  return std::make_unique<SearchedRooms>(problem, x);
}

Yield yield(const RoomRows& rows, const std::vector<RoomSlopes>& slopes, Design x,
            const std::vector<Variation>& variations, const YieldOptions& options) {
  if (variations.size() != x.size()) {
    throw std::invalid_argument("yield: give one variation for each variable");
  }
  const Sampler sampler(rows, x, variations);
  if (sampler.dimensions() == 0) throw std::invalid_argument("yield: nothing varies");
  if (options.samples < 1) throw std::invalid_argument("samples: at least one is needed");
  Yield result;
  result.by_limit.assign(rows.limits(), 0.0);
  result.by_limit_between.assign(rows.limits(), Bounds{0, 1});
  constexpr std::size_t kFirst = 4096;
  constexpr double kRare = 0.01;
  const auto each = std::max<std::size_t>(1, options.samples / kRepetitions);
  const std::size_t tried = std::min<std::size_t>(kFirst / kRepetitions, each);
  Estimator as_meant(sampler, plain(sampler.dimensions()), options, rows.limits());
  result.stopped = !as_meant.draw_to(tried);
  const double rare = kRare * static_cast<double>(tried * kRepetitions);
  if (result.stopped || static_cast<double>(as_meant.failures()) >= rare) {
    result.stopped = result.stopped || !as_meant.draw_to(each);
    if (!result.stopped) points_of(slopes, x, variations, options.stopped, result);
    as_meant.add_to(result);
    return result;
  }
  std::vector<DesignPoint> points = points_of(slopes, x, variations, options.stopped, result);
  for (DesignPoint& point : points) point = varying_part(point, variations);
  result.by_importance = !points.empty() && !result.stopped;
  if (result.by_importance) {
    Estimator near(sampler, about(points, sampler.dimensions()), options, rows.limits());
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
