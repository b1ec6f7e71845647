// SPDX-License-Identifier: MIT
#include "fitting/constants/agreement_steps.h"

#include <algorithm>
#include <cmath>

#include "optim/solvers/small_program.h"

namespace camlaw::problems {
namespace {

/// In scales: shorter steps change the last digits of the constants, longer ones leave any range.
constexpr double kLeastReach = 1e-10, kMostReach = 1e4;

/// A law may end where its room does: most of the way there.
std::vector<double> short_of(const std::vector<double>& from, const std::vector<double>& to) {
  constexpr double kShare = 0.9;  // at the very end the law may have no length left for a phase
  std::vector<double> result = from;
  for (std::size_t i = 0; i < from.size(); ++i) result[i] += kShare * (to[i] - from[i]);
  return result;
}

}  // namespace

double half_of(const PrintedConstant& printed) {
  // Of the value: what is printed with all digits still has a width to divide by.
  constexpr double kRounding = 1e-9;
  return std::max((printed.high - printed.low) / 2, kRounding * std::abs(printed.value));
}

/// slopes . (y - x) - share t <= limit, with t the largest misfit at y.
struct AgreementSteps::Row {
  std::vector<double> slopes;
  double limit;
  double share = 0;
};

bool AgreementSteps::is_of_peak(const Row& row) { return row.share > 0; }

AgreementSteps::AgreementSteps(const PrintedModel& model, std::vector<std::size_t> constants,
                               std::vector<double> lower, std::vector<double> upper)
    : model_(&model),
      constants_(std::move(constants)),
      lower_(std::move(lower)),
      upper_(std::move(upper)) {}

double AgreementSteps::misfit(std::span<const double> x) const {
  const auto here = model_->at(x);
  double largest = 0;
  for (const std::size_t c : constants_) {
    const PrintedConstant& printed = model_->constants()[c];
    const double z = std::abs(here->values[c] - printed.value) / half_of(printed);
    if (!std::isfinite(z)) return std::nan("");
    largest = std::max(largest, z);
  }
  return largest;
}

bool AgreementSteps::agrees(std::span<const double> x) const {
  return model_->all_agree(constants_, x);
}

/// Of every constant both limits, in halves of what is printed alike.
std::vector<AgreementSteps::Row> AgreementSteps::rows_at(std::span<const double> x) const {
  const auto here = model_->at(x);
  std::vector<Row> rows;
  for (const std::size_t c : constants_) {
    const PrintedConstant& printed = model_->constants()[c];
    const double half = half_of(printed), z = (here->values[c] - printed.value) / half;
    for (const double side : {1.0, -1.0}) {
      Row row{{}, -side * z, 1};
      for (std::size_t i = 0; i < x.size(); ++i) {
        const double slope = here->slopes[c * x.size() + i] / half;
        row.slopes.push_back(std::isfinite(slope) ? side * slope : 0);
      }
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

std::vector<AgreementSteps::Row> AgreementSteps::rooms_at(std::span<const double> x,
                                                          bool is_inside) const {
  const auto here = model_->at(x);
  const std::size_t first = model_->constants().size();
  std::vector<Row> rows;
  for (std::size_t k = 0; k < model_->rooms().size(); ++k) {
    const auto& room = model_->rooms()[k];
    const double left = here->values[first + k];
    for (const double side : {1.0, -1.0}) {
      const double limit = side > 0 ? room.high - left : left - room.low;
      if (!std::isfinite(limit)) continue;
      Row row{{}, is_inside ? std::max(0.0, limit) : limit};
      for (std::size_t i = 0; i < x.size(); ++i) {
        row.slopes.push_back(side * here->slopes[(first + k) * x.size() + i]);
      }
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

/// What limits steps from x at a place that was gone too far to: a peak is the highest of several,
/// and a room may end in a curve, so that more limits hold than x itself shows.
void AgreementSteps::add_cuts(const std::vector<double>& beyond, std::vector<Row>& cuts) const {
  std::vector<Row> own = rooms_at(beyond, false);
  if (std::isfinite(misfit(beyond))) {
    std::vector<Row> rows = rows_at(beyond);
    for (std::size_t k = 0; k < constants_.size(); ++k) {
      const bool lowest = model_->constants()[constants_[k]].response.part == optim::Part::Lowest;
      own.push_back(std::move(rows[2 * k + (lowest ? 1 : 0)]));
    }
  }
  for (Row& cut : own) {
    for (std::size_t i = 0; i < beyond.size(); ++i) cut.limit += cut.slopes[i] * beyond[i];
    cuts.push_back(std::move(cut));
  }
  // Each is a row of every program; the last ones lie near where the steps are.
  constexpr std::size_t kMost = 12;
  if (cuts.size() > kMost) {
    cuts.erase(cuts.begin(), cuts.end() - static_cast<std::ptrdiff_t>(kMost));
  }
}

/// The rows of x and those of cuts, as steps from x.
std::vector<AgreementSteps::Row> AgreementSteps::rows_with(const std::vector<double>& x,
                                                           const std::vector<Row>& cuts) const {
  std::vector<Row> rows = rows_at(x);
  for (Row cut : cuts) {
    for (std::size_t i = 0; i < x.size(); ++i) cut.limit -= cut.slopes[i] * x[i];
    rows.push_back(std::move(cut));
  }
  return rows;
}

/// The step that makes the largest misfit least, or an unknown greatest with a misfit of no more
/// than one; no unknown changes by more than `reach` of its scale.
std::optional<AgreementSteps::Step> AgreementSteps::step(const std::vector<double>& x, double reach,
                                                         std::vector<Row> rows,
                                                         const Aim& aim) const {
  constexpr double kInside = 1 - 1e-6;  // of the misfit
  const auto& [unknown, sign, enough] = aim;
  std::vector<std::size_t> free;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (upper_[i] > lower_[i]) free.push_back(i);
  }
  if (free.empty()) return {};
  const double misfit = this->misfit(x);
  for (Row& row : rooms_at(x, true)) rows.push_back(std::move(row));
  // Variables: how far each unknown goes up, how far down, and what the misfit loses.
  const auto n = static_cast<Eigen::Index>(free.size());
  const auto m = static_cast<Eigen::Index>(rows.size());
  const Eigen::Index size = 2 * n + (unknown ? 0 : 1);
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(m + size, size);
  Eigen::VectorXd limits = Eigen::VectorXd::Zero(m + size);
  Eigen::VectorXd gain = Eigen::VectorXd::Zero(size);
  for (Eigen::Index r = 0; r < m; ++r) {
    const Row& row = rows[static_cast<std::size_t>(r)];
    double largest = 0;
    for (Eigen::Index j = 0; j < n; ++j) {
      const std::size_t i = free[static_cast<std::size_t>(j)];
      const double by = row.slopes[i] * reach * model_->scales()[i].size;
      matrix(r, 2 * j) = by;
      matrix(r, 2 * j + 1) = -by;
      largest = std::max(largest, std::abs(by));
    }
    limits[r] = row.limit + row.share * (unknown ? kInside : misfit);
    if (!unknown) matrix(r, size - 1) = row.share * misfit;
    if (unknown && limits[r] < 0 && limits[r] > -2 * (1 - kInside)) limits[r] = 0;
    constexpr double kNotZero = 1e-300;  // rows of zeros stay what they are
    const double by =
        std::max({largest, std::abs(limits[r]), unknown ? 0.0 : row.share * misfit, kNotZero});
    matrix.row(r) /= by;
    limits[r] /= by;
    if (limits[r] < 0) {  // says nothing of steps from here
      matrix.row(r).setZero();
      limits[r] = 1;
    }
  }
  for (Eigen::Index j = 0; j < n; ++j) {
    const std::size_t i = free[static_cast<std::size_t>(j)];
    const double most = reach * model_->scales()[i].size;
    matrix(m + 2 * j, 2 * j) = matrix(m + 2 * j + 1, 2 * j + 1) = 1;
    limits[m + 2 * j] = std::clamp((upper_[i] - x[i]) / most, 0.0, 1.0);
    limits[m + 2 * j + 1] = std::clamp((x[i] - lower_[i]) / most, 0.0, 1.0);
    if (unknown == i) gain[2 * j] = sign, gain[2 * j + 1] = -sign;
  }
  if (!unknown) {
    matrix(m + size - 1, size - 1) = 1;
    limits[m + size - 1] = std::clamp(1 - enough / misfit, 0.0, 1.0);
    gain[size - 1] = 1;
  }
  const auto solution = optim::greatest_gain(gain, matrix, limits);
  if (!solution) return {};
  Step result{x, unknown ? 0 : (*solution)[size - 1] * misfit};
  for (Eigen::Index j = 0; j < n; ++j) {
    const std::size_t i = free[static_cast<std::size_t>(j)];
    const double change = (*solution)[2 * j] - (*solution)[2 * j + 1];
    result.to[i] =
        std::clamp(x[i] + change * reach * model_->scales()[i].size, lower_[i], upper_[i]);
  }
  if (unknown) result.gain = sign * (result.to[*unknown] - x[*unknown]);
  return result;
}

/// The largest change between two places, as a share of an unknown's scale.
double AgreementSteps::share_of(const std::vector<double>& from,
                                const std::vector<double>& to) const {
  double share = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    share = std::max(share, std::abs(to[i] - from[i]) / model_->scales()[i].size);
  }
  return share;
}

std::optional<std::vector<double>> AgreementSteps::to_agreement(std::vector<double> x, int steps,
                                                                double enough) const {
  double reach = 0.5, here = misfit(x);
  if (std::isnan(here)) return {};
  std::vector<Row> cuts;
  double before = here;  // some steps ago
  for (int k = 0; k < steps && !agrees(x); ++k) {
    // A start that five steps bring no tenth nearer is in a valley of its own; the next start may
    // not be. Within two widths of the print it goes on.
    constexpr int kEvery = 5;
    constexpr double kSlow = 0.9;
    if (k % kEvery == kEvery - 1) {
      if (here > kSlow * before && here > 2) return {};
      before = here;
    }
    auto next = step(x, reach, rows_with(x, cuts), {.enough = enough});
    constexpr double kNoGain = 1e-9;  // what rounding makes of the small program
    if (!next || next->gain <= kNoGain * here) return {};
    if (std::isnan(misfit(next->to))) next->to = short_of(x, next->to);
    const double there = misfit(next->to), gained = here - there;  // NaN where there is no law
    if (gained > 0.1 * next->gain) {
      if (gained > 0.7 * next->gain) reach = std::min(2 * reach, kMostReach);
      x = next->to;
      here = there;
      std::erase_if(cuts, is_of_peak);
    } else {
      reach = 0.35 * std::min(reach, share_of(x, next->to));
      if (reach < kLeastReach) return {};
      add_cuts(next->to, cuts);
    }
  }
  if (!agrees(x)) return {};
  return x;
}

std::vector<std::vector<double>> AgreementSteps::to_extreme(std::size_t unknown, double sign,
                                                            std::vector<double> x) const {
  // A path along the edge of what agrees bends; each step is led back onto it by at most four.
  constexpr int kSteps = 100, kBack = 4;
  constexpr double kEnd = 1e-7;         // of the scale
  constexpr double kAtEdge = 1 - 1e-4;  // of the misfit: farther inside, the path would be lost
  std::vector<std::vector<double>> path{x};
  double reach = 0.25;
  std::vector<Row> cuts;
  const double size = model_->scales()[unknown].size;
  for (int k = 0; k < kSteps; ++k) {
    const auto next = step(x, reach, rows_with(x, cuts), {unknown, sign});
    const double least = kEnd * std::min(size, std::abs(x[unknown] - path.front()[unknown]));
    if (!next || !(next->gain > least)) {
      if (cuts.empty()) break;
      cuts.clear();  // they may have been too strict
      continue;
    }
    std::optional<std::vector<double>> there = next->to;
    if (std::isnan(misfit(*there))) there = short_of(x, next->to);
    if (!agrees(*there)) there = to_agreement(*there, kBack, kAtEdge);
    if (there && sign * ((*there)[unknown] - x[unknown]) > 0.1 * next->gain) {
      x = *there;
      path.push_back(x);
      reach = std::min(2 * reach, kMostReach);
      std::erase_if(cuts, is_of_peak);
      continue;
    }
    reach = 0.35 * std::min(reach, share_of(x, next->to));
    if (reach < kLeastReach) break;
    add_cuts(next->to, cuts);
  }
  return path;
}

}  // namespace camlaw::problems
