// SPDX-License-Identifier: MIT
#include "fitting/constants/agreement.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "optim/fit/identifiability.h"

namespace camlaw::problems {
namespace {

/// From afar a step may be cut a dozen times; near a solution Newton's steps take a few.
constexpr int kSearchSteps = 40, kNearSteps = 15;

/// Apart by no more than what searches that end at the same values differ by.
bool reaches(double low, double high, double value) {
  constexpr double kAlike = 1e-3;  // of their range, or of the value
  const double room = kAlike * std::max(high - low, kAlike * std::abs(value));
  return value >= low - room && value <= high + room;
}

bool contains(const AgreeingValues& solution, const std::vector<double>& x) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!reaches(solution.low[i], solution.high[i], x[i])) return false;
  }
  return true;
}

bool overlap(const AgreeingValues& a, const AgreeingValues& b) {
  for (std::size_t i = 0; i < a.x.size(); ++i) {
    if (a.low[i] > b.high[i] || b.low[i] > a.high[i]) return false;
  }
  return true;
}

/// What both reach.
void join(AgreeingValues& to, const AgreeingValues& from) {
  for (std::size_t i = 0; i < to.x.size(); ++i) {
    to.low[i] = std::min(to.low[i], from.low[i]);
    to.high[i] = std::max(to.high[i], from.high[i]);
  }
  to.about.insert(to.about.end(), from.about.begin(), from.about.end());
}

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return sum;
}

/// Indexes of the places whose neighbours all have a larger misfit, the least first.
std::vector<std::size_t> lowest_places(const std::vector<PrintedModel::Place>& places,
                                       const std::vector<double>& misfits) {
  std::vector<std::size_t> order, result;
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (std::isfinite(misfits[k])) order.push_back(k);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return misfits[a] < misfits[b]; });
  const std::size_t neighbours = places.empty() ? 0 : 2 * places.front().x.size() + 1;
  for (std::size_t at = 0; at < order.size(); ++at) {
    const std::size_t k = order[at];
    // None of those with less is among its neighbours: fewer of all others are nearer.
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t less = 0; less < at; ++less) {
      nearest = std::min(nearest, distance(places[order[less]].coordinates, places[k].coordinates));
    }
    std::size_t nearer = 0;
    for (const std::size_t other : order) {
      if (other != k && distance(places[other].coordinates, places[k].coordinates) < nearest) {
        ++nearer;
      }
    }
    if (at == 0 || nearer >= neighbours) result.push_back(k);
  }
  return result;
}

}  // namespace

Agreement::Agreement(const PrintedModel& model, std::vector<std::size_t> constants)
    : model_(&model), constants_(std::move(constants)) {
  for (const Unknown& u : model.unknowns()) {
    lower_.push_back(u.lower);
    upper_.push_back(u.upper);
  }
  for (const std::size_t c : constants_) {
    if (std::isfinite(model.constants()[c].value)) finite_.push_back(c);
  }
}

bool Agreement::all_agree(std::span<const double> x) const {
  return model_->all_agree(constants_, x);
}

void Agreement::hold(std::size_t unknown, double value) {
  lower_[unknown] = upper_[unknown] = value;
}

/// The default values, and the places with less misfit than all about them. Of a constant that is
/// printed more precisely than places lie close, what counts is a share of its value.
std::vector<std::vector<double>> Agreement::starts() const {
  constexpr std::size_t kStarts = 10;  // each is a search of up to kSearchSteps programs
  // Of the value: so much a constant changes between neighbouring places.
  constexpr double kResolved = 0.05;
  const auto& places = model_->places();
  std::vector<double> misfits;
  for (const auto& place : places) {
    double sum = 0;
    for (const std::size_t c : finite_) {
      const PrintedConstant& printed = model_->constants()[c];
      const double z = (place.at.values[c] - printed.value) /
                       std::hypot(half_of(printed), kResolved * printed.value);
      sum += z * z;
    }
    misfits.push_back(sum);
  }
  std::vector<std::vector<double>> result;
  if (!places.empty() && std::isfinite(misfits.front())) result.push_back(places.front().x);
  for (const std::size_t k : lowest_places(places, misfits)) {
    if (result.size() > kStarts) break;
    if (k != 0) result.push_back(places[k].x);
  }
  return result;
}

/// Values with which all agree: where searches end, and of the places that happen to do those that
/// lie farthest out.
std::vector<std::vector<double>> Agreement::found() const {
  std::vector<std::vector<double>> result;
  const std::vector<double> defaults = model_->defaults();
  if (all_agree(defaults)) result.push_back(defaults);
  std::vector<const std::vector<double>*> agreeing;
  for (const auto& place : model_->places()) {
    if (all_agree(place.x)) agreeing.push_back(&place.x);
  }
  for (std::size_t i = 0; i < defaults.size() && !agreeing.empty(); ++i) {
    const auto [low, high] = std::minmax_element(
        agreeing.begin(), agreeing.end(), [i](auto* a, auto* b) { return (*a)[i] < (*b)[i]; });
    result.push_back(**low);
    result.push_back(**high);
  }
  if (finite_.empty()) return result;
  for (const std::vector<double>& start : starts()) {
    const auto x = steps().to_agreement(start, kSearchSteps);
    if (x && all_agree(*x)) result.push_back(*x);
  }
  return result;
}

/// Where the stretches of all constants overlap.
std::vector<AgreeingValues> Agreement::of_one_unknown() const {
  Stretches stretches{{lower_[0], upper_[0]}};
  for (const std::size_t c : finite_) stretches = common(stretches, model_->stretches(c));
  const std::vector<double> defaults = model_->defaults();
  std::vector<AgreeingValues> result;
  for (const auto& [low, high] : stretches) {
    std::vector<double> middle{low + (high - low) / 2};
    if (defaults[0] >= low && defaults[0] <= high && all_agree(defaults)) middle = defaults;
    for (const double x : {middle[0], low, high}) {
      if (!all_agree(std::span(&x, 1))) continue;
      AgreeingValues solution{{x}, {low}, {high}, {{low}, {high}}};
      result.insert(middle == defaults ? result.begin() : result.end(), std::move(solution));
      break;
    }
  }
  return result;
}

AgreeingValues Agreement::ranged(const std::vector<double>& x,
                                 std::span<const std::vector<double>> others) const {
  AgreeingValues result{x, x, x, {x}};
  if (finite_.empty()) {
    result.low = lower_;
    result.high = upper_;
    return result;
  }
  const auto go = [&](std::size_t i, double sign, const std::vector<double>& from) {
    for (auto& other : steps().to_extreme(i, sign, from)) {
      for (std::size_t j = 0; j < x.size(); ++j) {
        result.low[j] = std::min(result.low[j], other[j]);
        result.high[j] = std::max(result.high[j], other[j]);
      }
      result.about.push_back(std::move(other));
    }
  };
  // Twice, since what is reached on the path to one end may lead farther to another: from the
  // farthest that is known, then from some others too, as an end may be one of several corners.
  constexpr std::size_t kOthers = 4;
  for (std::size_t k = 0; k < 2 * x.size(); ++k) {
    const std::size_t i = k % x.size();
    if (!(upper_[i] > lower_[i])) continue;
    for (const double sign : {-1.0, 1.0}) {
      std::vector<double> from = x;
      for (const auto& other : result.about) {
        if (sign * other[i] > sign * from[i]) from = other;
      }
      for (const auto& other : others) {
        if (sign * other[i] > sign * from[i] && contains(result, other)) from = other;
      }
      go(i, sign, from);
      if (k < x.size()) continue;
      go(i, sign, x);
      std::size_t more = 0;
      for (auto other = others.rbegin(); other != others.rend() && more < kOthers; ++other) {
        if (contains(result, *other)) go(i, sign, *other), ++more;
      }
    }
  }
  return result;
}

AgreeingValues Agreement::within(const std::vector<double>& x) const { return ranged(x, {}); }

std::vector<AgreeingValues> Agreement::solutions() const {
  if (model_->unknowns().empty()) {
    if (!all_agree({})) return {};
    return {AgreeingValues{}};
  }
  if (model_->unknowns().size() == 1) return of_one_unknown();
  std::vector<AgreeingValues> result;
  const std::vector<std::vector<double>> points = found();
  for (const std::vector<double>& x : points) {
    const bool known = std::any_of(result.begin(), result.end(),
                                   [&](const AgreeingValues& other) { return contains(other, x); });
    if (known) continue;
    AgreeingValues solution = ranged(x, points);
    const auto same = std::find_if(result.begin(), result.end(), [&](const AgreeingValues& other) {
      return overlap(other, solution);
    });
    if (same == result.end()) {
      result.push_back(std::move(solution));
    } else {
      join(*same, solution);
    }
  }
  return result;
}

std::optional<std::vector<double>> Agreement::near(const AgreeingValues& solution,
                                                   std::size_t unknown) const {
  const double value = lower_[unknown];
  // Those that come nearest from below and from above.
  const std::vector<double>*below = nullptr, *above = nullptr;
  const auto look = [&](const std::vector<double>& x) {
    if (x[unknown] <= value && (below == nullptr || x[unknown] > (*below)[unknown])) below = &x;
    if (x[unknown] >= value && (above == nullptr || x[unknown] < (*above)[unknown])) above = &x;
  };
  look(solution.x);
  for (const auto& x : solution.about) look(x);
  std::vector<std::vector<double>> starts{solution.x};
  if (below != nullptr) starts.push_back(*below);
  if (above != nullptr) starts.push_back(*above);
  if (below != nullptr && above != nullptr) {
    const double length = (*above)[unknown] - (*below)[unknown];
    const double share = length > 0 ? (value - (*below)[unknown]) / length : 0;
    std::vector<double> between = *below;
    for (std::size_t i = 0; i < between.size(); ++i) {
      between[i] += share * ((*above)[i] - (*below)[i]);
    }
    starts.insert(starts.begin(), std::move(between));
  }
  for (std::vector<double>& start : starts) {
    for (std::size_t i = 0; i < start.size(); ++i) {
      start[i] = std::clamp(start[i], lower_[i], upper_[i]);
    }
    if (all_agree(start)) return start;
    const auto x = steps().to_agreement(start, kNearSteps);
    if (x && all_agree(*x)) return x;
  }
  return {};
}

std::vector<bool> Agreement::determined(const std::vector<double>& at) const {
  std::vector<bool> result(at.size(), false);
  if (finite_.empty() || at.empty()) return result;
  const auto here = model_->at(at);
  // What must add up to something is as good as a constant.
  std::vector<std::pair<std::size_t, double>> rows;
  for (const std::size_t c : finite_) rows.emplace_back(c, half_of(model_->constants()[c]));
  for (std::size_t k = 0; k < model_->rooms().size(); ++k) {
    const auto& room = model_->rooms()[k];
    if (std::isfinite(room.high)) rows.emplace_back(model_->constants().size() + k, room.high);
  }
  Eigen::MatrixXd jacobian(static_cast<Eigen::Index>(rows.size()),
                           static_cast<Eigen::Index>(at.size()));
  for (Eigen::Index r = 0; r < jacobian.rows(); ++r) {
    const auto& [row, half] = rows[static_cast<std::size_t>(r)];
    for (Eigen::Index i = 0; i < jacobian.cols(); ++i) {
      jacobian(r, i) = here->slopes[row * at.size() + static_cast<std::size_t>(i)] / half;
    }
  }
  if (!jacobian.allFinite()) return result;
  result.assign(at.size(), true);
  for (const Eigen::VectorXd& direction : optim::identify(jacobian).directions) {
    for (std::size_t i = 0; i < at.size(); ++i) {
      if (direction[static_cast<Eigen::Index>(i)] != 0) result[i] = false;
    }
  }
  return result;
}

}  // namespace camlaw::problems
