// SPDX-License-Identifier: MIT
#include "optim/verdict/drawn_parts.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "numerics/sampling/sobol_points.h"
#include "optim/problem/interrupted.h"

namespace camlaw::optim {

double Mixture::weight(std::span<const double> u) const {
  double sum = 0;
  for (std::size_t j = 0; j < centres.size(); ++j) {
    // Written so that of a part about a point with the deviation 1 nothing cancels.
    const double spread = spreads[j], narrower = 1 - 1 / (spread * spread);
    double exponent = 0;
    for (std::size_t i = 0; i < u.size(); ++i) {
      const double centre = centres[j][i];
      exponent += centre * (u[i] - centre / 2) * (1 - narrower) + narrower * u[i] * u[i] / 2;
    }
    sum += shares[j] * std::exp(exponent) / std::pow(spread, static_cast<double>(u.size()));
  }
  return 1 / sum;
}

void Tally::add(double weight) {
  sum += weight;
  squares += weight * weight;
  largest = std::max(largest, weight);
  ++hits;
}

void Tally::add(const Tally& other) {
  sum += other.sum;
  squares += other.squares;
  largest = std::max(largest, other.largest);
  hits += other.hits;
}

void PartsCount::add(const PartsCount& other) {
  failing.add(other.failing);
  doubtful.add(other.doubtful);
  by_limit.resize(other.by_limit.size());
  for (std::size_t i = 0; i < by_limit.size(); ++i) by_limit[i].add(other.by_limit[i]);
  impossible += other.impossible;
  samples += other.samples;
}

PartsDrawer::PartsDrawer(const RoomRows& rows, Design x, const std::vector<Variation>& variations)
    : rows_(rows), slack_(rows.slack()), x_(x.begin(), x.end()), variations_(variations) {
  if (variations.size() != x.size()) {
    throw std::invalid_argument("yield: give one variation for each variable");
  }
  for (std::size_t i = 0; i < variations.size(); ++i) {
    if (variations[i].varies()) {
      varying_.push_back(i);
    } else {
      x_[i] += variations[i].lower;
    }
  }
  if (varying_.empty()) throw std::invalid_argument("yield: nothing varies");
}

std::vector<double> PartsDrawer::room(std::span<const double> us) const {
  const std::size_t m = dimensions(), count = us.size() / m;
  std::vector<double> designs, room(limits() * count);
  for (std::size_t k = 0; k < count; ++k) {
    std::vector<double> design = x_;
    for (std::size_t i = 0; i < m; ++i) {
      design[varying_[i]] += variations_[varying_[i]].at(us[k * m + i]);
    }
    designs.insert(designs.end(), design.begin(), design.end());
  }
  rows_.room(designs, count, room);
  return room;
}

std::optional<PartsCount> PartsDrawer::count(const PartsDraw& draw,
                                             const std::function<bool()>& stopped) const {
  try {
    return count_all(draw, stopped);
  } catch (const Interrupted&) {
    return {};
  }
}

std::optional<PartsCount> PartsDrawer::count_all(const PartsDraw& draw,
                                                 const std::function<bool()>& stopped) const {
  const std::size_t m = dimensions(), n = x_.size();
  const bool is_plain = draw.mixture.centres.size() == 1;
  SobolPoints points(m, draw.seed);
  points.skip(draw.from);
  PartsCount counted;
  counted.by_limit.resize(limits());
  // Draws of the first rounds have a few points: to clear whole blocks took longer than to judge
  // them.
  const std::size_t most = std::min(kPartsBlock, draw.count);
  std::vector<double> shares(most * m), us(most * m), designs(most * n);
  for (std::size_t done = 0; done < draw.count; done += kPartsBlock) {
    if (stopped()) return {};
    const std::size_t block = std::min(kPartsBlock, draw.count - done);
    points.next(std::span(shares).first(block * m));
    for (std::size_t k = 0; k < block; ++k) {
      std::copy(x_.begin(), x_.end(), designs.begin() + static_cast<std::ptrdiff_t>(k * n));
      for (std::size_t i = 0; i < m; ++i) {
        const Variation& v = variations_[varying_[i]];
        double off = 0;
        if (is_plain) {
          off = v.at_share(shares[k * m + i]);
        } else {
          us[k * m + i] = draw.mixture.centres[draw.about][i] +
                          draw.mixture.spreads[draw.about] * normal_quantile(shares[k * m + i]);
          off = v.at(us[k * m + i]);
        }
        designs[k * n + varying_[i]] += off;
      }
    }
    count_block(draw, designs, us, block, counted);
  }
  return counted;
}

void PartsDrawer::count_block(const PartsDraw& draw, const std::vector<double>& designs,
                              const std::vector<double>& us, std::size_t block,
                              PartsCount& counted) const {
  const std::size_t m = dimensions();
  const bool is_plain = draw.mixture.centres.size() == 1;
  std::vector<double> room(limits() * block);
  rows_.room(std::span(designs).first(block * x_.size()), block, room);
  for (std::size_t k = 0; k < block; ++k) {
    bool fails = false, may_fail = false, is_possible = true;
    for (std::size_t i = 0; i < limits(); ++i) {
      const double left = room[i * block + k];
      fails |= !(left >= 0);
      may_fail |= !(left - slack_[i] >= 0);
      is_possible &= !std::isnan(left);
    }
    ++counted.samples;
    if (!may_fail) continue;
    const double weight = is_plain ? 1 : draw.mixture.weight(std::span(us).subspan(k * m, m));
    counted.doubtful.add(weight);
    if (!fails) continue;
    counted.failing.add(weight);
    counted.impossible += !is_possible;
    for (std::size_t i = 0; i < limits(); ++i) {
      if (!(room[i * block + k] >= 0)) counted.by_limit[i].add(weight);
    }
  }
}

CountParts counted_here(const PartsDrawer& drawer, const std::function<bool()>& stopped) {
  return [&drawer, &stopped](const std::vector<PartsDraw>& draws) {
    std::vector<PartsCount> counted;
    for (const PartsDraw& draw : draws) {
      auto one = drawer.count(draw, stopped);
      if (!one) break;
      counted.push_back(std::move(*one));
    }
    return counted;
  };
}

}  // namespace camlaw::optim
