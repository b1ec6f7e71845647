// SPDX-License-Identifier: MIT
#include "optim/verdict/failure_regions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "numerics/sampling/sobol_points.h"
#include "optim/problem/interrupted.h"

namespace camlaw::optim {
namespace {

using Numbers = std::vector<double>;

double product(const Numbers& a, const Numbers& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

double size_of(const Numbers& u) { return std::sqrt(product(u, u)); }

Numbers times(double factor, Numbers u) {
  for (double& value : u) value *= factor;
  return u;
}

/// TV13: parts that are drawn about the point fall beyond u too, but for one deviation.
bool covers(const DesignPoint& point, const Numbers& u) {
  constexpr double kShort = 1;
  const double distance = size_of(point.u);
  return product(point.u, u) >= distance * (distance - kShort);
}

/// The points of one limit, as they are found.
class LimitPoints {
 public:
  LimitPoints(const RoomSlopes& room, Design x, const std::vector<Variation>& variations)
      : room_(room), x_(x), variations_(variations), slopes_(x.size()) {
    if (auto nearest = design_point(room_, x_, variations_)) {
      points_.push_back(std::move(*nearest));
    }
  }

  bool fails(const Numbers& u) {
    Numbers at(x_.begin(), x_.end());
    for (std::size_t i = 0; i < u.size(); ++i) at[i] += variations_[i].at(u[i]);
    return !(room_(at, slopes_) >= 0);
  }

  void look_opposite() {
    if (points_.empty()) return;
    const Numbers nearest = points_.front().u;
    for (const double factor : {1.0, 1.25, 1.5}) {
      const Numbers opposite = times(-factor, nearest);
      if (!fails(opposite)) continue;
      add_from(opposite);
      return;
    }
  }

  void look_from(const std::vector<Numbers>& failing) {
    // A ring of radius four takes nine, a sphere of five sixteen. In many dimensions no number of
    // them covers a sphere, which is what the wide part of the mixture is for.
    constexpr std::size_t kMost = 16;
    constexpr int kInVain = 4;
    int in_vain = 0;
    for (const Numbers& u : failing) {
      if (points_.size() >= kMost || in_vain == kInVain) return;
      if (!is_covered(u) && !add_from(u)) ++in_vain;
    }
  }

  std::vector<DesignPoint> sorted() {
    std::sort(points_.begin(), points_.end(), [](const DesignPoint& a, const DesignPoint& b) {
      return std::abs(a.index) < std::abs(b.index);
    });
    return points_;
  }

 private:
  bool is_covered(const Numbers& u) const {
    return std::any_of(points_.begin(), points_.end(),
                       [&](const DesignPoint& point) { return covers(point, u); });
  }

  /// Whether its share counts beside that of the nearest.
  bool counts(const DesignPoint& point) const {
    constexpr double kShare = 1e-4;
    double nearest = kInfinity;
    for (const DesignPoint& own : points_) nearest = std::min(nearest, product(own.u, own.u));
    return product(point.u, point.u) <= nearest - 2 * std::log(kShare);
  }

  /// From the middle straight to a failing part, the first failure that halving finds.
  Numbers edge_before(const Numbers& failing) {
    constexpr int kHalvings = 12;  // to 1/4096 of the distance
    double holds = 0, breaks = 1;
    for (int k = 0; k < kHalvings; ++k) {
      const double middle = (holds + breaks) / 2;
      (fails(times(middle, failing)) ? breaks : holds) = middle;
    }
    return times(breaks, failing);
  }

  /// The design point that the search reaches from there; where that is known already or there is
  /// none, as where the model gives no number, the edge itself.
  bool add_from(const Numbers& failing) {
    const Numbers edge = edge_before(failing);
    // Where steps slide slowly along the limit the edge does as well.
    constexpr int kSteps = 12;
    auto found = design_point(room_, x_, variations_, {edge, kSteps});
    if (!found || is_covered(found->u)) found = DesignPoint{edge, size_of(edge)};
    if (is_covered(found->u) || !counts(*found)) return false;
    points_.push_back(std::move(*found));
    return true;
  }

  const RoomSlopes& room_;
  Design x_;
  const std::vector<Variation>& variations_;
  Numbers slopes_;
  std::vector<DesignPoint> points_;
};

/// How widely parts are drawn to find the regions: those of an index of 3 are met by two in a
/// hundred at 1.5, of an index of 8 at 4.
constexpr std::array kSpreads{1.5, 2.5, 4.0};

/// Parts drawn widely, and the limits that they break.
struct WideParts {
  std::vector<Numbers> u;    ///< in all numbers
  std::vector<double> room;  ///< [limit * count + k]
};

WideParts drawn_widely(const PartsDrawer& drawer, const std::vector<Variation>& variations,
                       const RegionsOptions& options) {
  // No share that counts lies beyond, and there each part takes a search of its own (theory: TV5).
  constexpr double kFarthest = 6;
  const std::size_t m = drawer.dimensions(), limits = drawer.limits();
  const std::size_t each = std::max<std::size_t>(1, options.samples / kSpreads.size());
  WideParts parts;
  std::vector<Numbers> rooms;
  for (std::size_t s = 0; s < kSpreads.size(); ++s) {
    SobolPoints points(m, mixed(options.seed, s));
    for (std::size_t done = 0; done < each; done += kPartsBlock) {
      if (options.stopped()) throw Interrupted();
      const std::size_t block = std::min(kPartsBlock, each - done);
      Numbers us(block * m);
      points.next(us);
      for (double& u : us) {
        u = std::clamp(kSpreads[s] * normal_quantile(u), -kFarthest, kFarthest);
      }
      rooms.push_back(drawer.room(us));
      for (std::size_t k = 0; k < block; ++k) {
        Numbers own(variations.size(), 0.0);
        for (std::size_t i = 0, next = k * m; i < own.size(); ++i) {
          if (variations[i].varies()) own[i] = us[next++];
        }
        parts.u.push_back(std::move(own));
      }
    }
  }
  for (std::size_t i = 0; i < limits; ++i) {
    for (const Numbers& room : rooms) {
      const auto block = static_cast<std::ptrdiff_t>(room.size() / limits);
      const auto from = room.begin() + static_cast<std::ptrdiff_t>(i) * block;
      parts.room.insert(parts.room.end(), from, from + block);
    }
  }
  return parts;
}

/// Those that break one limit, nearest first.
std::vector<Numbers> failing_of(const WideParts& parts, std::size_t limit) {
  std::vector<Numbers> failing;
  for (std::size_t k = 0; k < parts.u.size(); ++k) {
    if (!(parts.room[limit * parts.u.size() + k] >= 0)) failing.push_back(parts.u[k]);
  }
  std::stable_sort(failing.begin(), failing.end(), [](const Numbers& a, const Numbers& b) {
    return product(a, a) < product(b, b);
  });
  return failing;
}

/// TV14: over all that fail, each as likely as it is made.
double spread_of(const WideParts& parts, std::size_t limits, std::size_t dimensions) {
  // Below, the wide part of a mixture would tell nothing that the others do not; above, most of its
  // parts would lie where no share counts.
  constexpr double kLeast = 1.25, kMost = 3;
  const auto n = static_cast<double>(dimensions);
  const std::size_t count = parts.u.size();
  double sum = 0, weights = 0;
  for (std::size_t k = 0; k < count; ++k) {
    bool fails = false;
    for (std::size_t i = 0; i < limits; ++i) fails |= !(parts.room[i * count + k] >= 0);
    if (!fails) continue;
    const double square = product(parts.u[k], parts.u[k]);
    double density = 0;
    for (const double s : kSpreads) {
      density += std::exp(square / 2 * (1 - 1 / (s * s)) - n * std::log(s));
    }
    sum += square / density;
    weights += 1 / density;
  }
  return weights > 0 ? std::clamp(std::sqrt(sum / (n * weights)), kLeast, kMost) : kLeast;
}

}  // namespace

std::vector<DesignPoint> failing_points(const RoomSlopes& room, Design x,
                                        const std::vector<Variation>& variations,
                                        const std::vector<Numbers>& failing) {
  LimitPoints points(room, x, variations);
  // Of a limit that the middle breaks no part beyond an edge is told from one before it.
  if (!points.fails(Numbers(x.size(), 0.0))) {
    points.look_opposite();
    points.look_from(failing);
  }
  return points.sorted();
}

FailureRegions failure_regions(const PartsDrawer& drawer, const std::vector<RoomSlopes>& slopes,
                               Design x, const std::vector<Variation>& variations,
                               const RegionsOptions& options) {
  const WideParts parts = drawn_widely(drawer, variations, options);
  FailureRegions result;
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    if (options.stopped()) throw Interrupted();
    result.of_limit.push_back(failing_points(slopes[i], x, variations, failing_of(parts, i)));
  }
  result.spread = spread_of(parts, drawer.limits(), drawer.dimensions());
  return result;
}

}  // namespace camlaw::optim
