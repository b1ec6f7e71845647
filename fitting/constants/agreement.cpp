// SPDX-License-Identifier: MIT
#include "fitting/constants/agreement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "optim/cycle/sizes.h"
#include "optim/fit/identifiability.h"
#include "optim/fit/least_squares.h"
#include "optim/fit/residuals.h"
#include "optim/pareto/shifted.h"
#include "optim/search/deadline.h"
#include "optim/search/local.h"
#include "optim/search/optimise.h"

namespace camlaw::problems {
namespace {

constexpr int kIterations = 100, kFitIterations = 20;

double half_of(const PrintedConstant& printed) { return (printed.high - printed.low) / 2; }

/// (f - value) / half of some of the constants: at most one where they agree.
class PrintResiduals final : public optim::Residuals {
 public:
  PrintResiduals(const PrintedModel& model, std::vector<std::size_t> which)
      : model_(model), which_(std::move(which)) {}
  std::size_t count() const override { return which_.size(); }
  bool evaluate(std::span<const double> p, std::span<double> r,
                std::span<double> jacobian) const override {
    const auto here = model_.at(p);
    for (std::size_t k = 0; k < which_.size(); ++k) {
      const PrintedConstant& c = model_.constants()[which_[k]];
      r[k] = (here->values[which_[k]] - c.value) / half_of(c);
      if (!std::isfinite(r[k])) return false;
      if (jacobian.empty()) continue;
      for (std::size_t i = 0; i < p.size(); ++i) {
        jacobian[k * p.size() + i] = here->slopes[which_[k] * p.size() + i] / half_of(c);
      }
    }
    return true;
  }

 private:
  const PrintedModel& model_;
  std::vector<std::size_t> which_;
};

bool are_alike(const std::vector<double>& a, const std::vector<double>& b) {
  constexpr double kAlike = 1e-3;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double size = std::max({std::abs(a[i]), std::abs(b[i]), 1e-3});
    if (std::abs(a[i] - b[i]) > kAlike * size) return false;
  }
  return true;
}

std::optional<std::vector<double>> answer(const optim::Problem& problem) {
  optim::OptimiseOptions options;
  options.solver = "slsqp";
  options.starts = 1;
  options.max_iterations = kIterations;
  const optim::Found found =
      optim::search_continuous(problem, options, optim::Deadline({}, nullptr), false);
  if (found.x.empty()) return {};
  return found.x;
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

std::vector<std::vector<double>> Agreement::solutions() const {
  const std::vector<double> defaults = model_->defaults();
  if (all_agree(defaults)) return {defaults};  // nothing explains the prints better
  std::vector<std::vector<double>> result;
  if (defaults.empty()) return result;
  for (const std::vector<double>& start : starts()) {
    const auto x = all_agree(start) ? start : solved_from(start);
    if (!x || !all_agree(*x)) continue;
    const bool known = std::any_of(result.begin(), result.end(),
                                   [&](const auto& other) { return are_alike(*x, other); });
    if (!known) result.push_back(*x);
  }
  return result;
}

bool Agreement::all_agree(std::span<const double> x) const {
  return std::all_of(constants_.begin(), constants_.end(),
                     [&](std::size_t c) { return model_->agrees(c, x); });
}

std::pair<double, double> Agreement::range(std::size_t unknown,
                                           const std::vector<double>& about) const {
  std::pair<double, double> result{about[unknown], about[unknown]};
  for (const optim::Sense sense : {optim::Sense::Minimize, optim::Sense::Maximize}) {
    optim::Problem problem = stated(about);
    problem.objectives = {
        {{model_->unknowns()[unknown].name, "1", optim::variable_function(unknown)}, sense}};
    const auto x = answer(problem);
    if (!x || !all_agree(*x)) continue;
    result.first = std::min(result.first, (*x)[unknown]);
    result.second = std::max(result.second, (*x)[unknown]);
  }
  return result;
}

void Agreement::hold(std::size_t unknown, double value) {
  lower_[unknown] = upper_[unknown] = value;
}

std::optional<std::vector<double>> Agreement::near(std::vector<double> about) const {
  for (std::size_t i = 0; i < about.size(); ++i) {
    about[i] = std::clamp(about[i], lower_[i], upper_[i]);
  }
  if (all_agree(about)) return about;
  const auto x = balanced(about);
  if (x && all_agree(*x)) return x;
  return {};
}

std::vector<bool> Agreement::determined(const std::vector<double>& at) const {
  const PrintResiduals residuals(*model_, finite_);
  std::vector<double> r(residuals.count()), j(r.size() * at.size());
  std::vector<bool> result(at.size(), false);
  if (r.empty() || at.empty() || !residuals.evaluate(at, r, j)) return result;
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Eigen::MatrixXd jacobian = Eigen::Map<const Rows>(
      j.data(), static_cast<Eigen::Index>(r.size()), static_cast<Eigen::Index>(at.size()));
  result.assign(at.size(), true);
  for (const Eigen::VectorXd& direction : optim::identify(jacobian).directions) {
    for (std::size_t i = 0; i < at.size(); ++i) {
      if (direction[static_cast<Eigen::Index>(i)] != 0) result[i] = false;
    }
  }
  return result;
}

/// Sum of squares, in the intervals' widths.
double Agreement::misfit(const PrintedModel::Place& place) const {
  double sum = 0;
  for (const std::size_t c : finite_) {
    const PrintedConstant& printed = model_->constants()[c];
    const double z = (place.at.values[c] - printed.value) / (printed.high - printed.low);
    sum += z * z;
  }
  return sum;
}

/// Whether every constant may take its printed value between two places of one unknown: it goes
/// from one value to the other, and where it turns in between no further than its slopes lead.
bool Agreement::may_cross(const PrintedModel::Place& a, const PrintedModel::Place& b) const {
  const double length = b.x[0] - a.x[0];
  return std::all_of(finite_.begin(), finite_.end(), [&](std::size_t c) {
    const auto [low, high] = std::minmax(a.at.values[c], b.at.values[c]);
    const double begin = a.at.slopes[c], end = b.at.slopes[c];
    const double turn = length * std::max(std::abs(begin), std::abs(end)) / 2;
    constexpr double kShare = 0.1;  // of a stretch without a turn, for one that ends can not show
    const double room = begin * end > 0 ? kShare * (high - low) : turn;
    const PrintedConstant& printed = model_->constants()[c];
    return printed.high >= low - room && printed.low <= high + room;  // not of NaN
  });
}

/// Of one unknown: where between neighbouring places all constants may take their printed values.
std::vector<std::vector<double>> Agreement::crossings() const {
  std::vector<const PrintedModel::Place*> order;
  for (const auto& place : model_->places()) order.push_back(&place);
  std::sort(order.begin(), order.end(),
            [](const auto* a, const auto* b) { return a->x[0] < b->x[0]; });
  std::vector<std::vector<double>> result;
  for (std::size_t i = 0; i + 1 < order.size(); ++i) {
    const auto &a = *order[i], &b = *order[i + 1];
    if (!may_cross(a, b)) continue;
    const std::size_t c = finite_.front();
    const double share =
        (model_->constants()[c].value - a.at.values[c]) / (b.at.values[c] - a.at.values[c]);
    const double inside = share >= 0 && share <= 1 ? share : 0.5;
    result.push_back({a.x[0] + inside * (b.x[0] - a.x[0])});
  }
  return result;
}

/// The default values, and the places with the least sum of squares.
std::vector<std::vector<double>> Agreement::starts() const {
  if (model_->unknowns().size() == 1 && !finite_.empty()) return crossings();
  constexpr std::size_t kStarts = 4;
  const auto& places = model_->places();
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const double sum = misfit(places[k]);
    if (std::isfinite(sum)) order.emplace_back(k == 0 ? -1 : sum, k);
  }
  std::sort(order.begin(), order.end());
  std::vector<std::vector<double>> result;
  for (std::size_t i = 0; i < std::min(order.size(), 1 + kStarts); ++i) {
    result.push_back(places[order[i].second].x);
  }
  return result;
}

std::optional<std::vector<double>> Agreement::solved_from(const std::vector<double>& start) const {
  if (finite_.empty()) return start;
  std::vector<optim::FitParameter> parameters;
  for (std::size_t i = 0; i < start.size(); ++i) {
    const Unknown& u = model_->unknowns()[i];
    // Numbered, since a size of the machine and a coefficient of the law may have the same name.
    parameters.push_back(
        {fmt::format("{} {}", i + 1, u.name), u.unit, lower_[i], upper_[i], start[i]});
  }
  optim::FitOptions options;
  options.max_iterations = kFitIterations;
  const auto found = optim::possible_fit(parameters, PrintResiduals(*model_, finite_), options);
  if (!found) return {};  // no law, or no number, there
  std::vector<double> x;
  for (const auto& p : found->parameters) x.push_back(p.value);
  const double largest = std::abs(found->residuals[found->largest]);
  if (all_agree(x)) return x;
  // The least sum of squares n z^2 has no residual beyond sqrt(n), where all could be below one.
  if (largest > std::sqrt(static_cast<double>(finite_.size()))) return {};
  return balanced(x);
}

/// Where the largest residual is least: the sum of squares may leave one out of its interval that
/// others had room for.
std::optional<std::vector<double>> Agreement::balanced(const std::vector<double>& about) const {
  optim::Problem problem = stated(about);
  const std::size_t t = about.size();
  optim::Variable largest;
  largest.name = "largest";
  largest.start = 1;
  largest.scale = 1;
  problem.variables.push_back(largest);
  problem.objectives = {{{"largest", "1", optim::variable_function(t)}}};
  problem.constraints.clear();
  for (const std::size_t c : finite_) {
    const PrintedConstant& printed = model_->constants()[c];
    const double half = half_of(printed);
    for (const double side : {-1.0, 1.0}) {
      optim::Constraint limit;
      limit.response = optim::shifted(model_->response(c), side * half, t);
      (side < 0 ? limit.upper : limit.lower) = printed.value;
      limit.tolerance = 1e-3 * half;
      problem.constraints.push_back(std::move(limit));
    }
  }
  auto x = answer(problem);
  if (x) x->pop_back();
  return x;
}

/// After which the first of the constants has left its interval; by default where none notices.
std::optional<double> Agreement::typical_change(std::size_t unknown,
                                                const std::vector<double>& about) const {
  const auto here = model_->at(about);
  double steepest = 0;
  for (const std::size_t c : finite_) {
    const double slope = std::abs(here->slopes[c * about.size() + unknown]);
    steepest = std::max(steepest, slope / half_of(model_->constants()[c]));
  }
  constexpr double kLeast = 1e-12;  // of the number itself: nothing is printed so precisely
  const double change = std::max(1 / steepest, kLeast * std::abs(about[unknown]));
  if (!(change < upper_[unknown] - lower_[unknown])) return {};
  return change;
}

optim::Problem Agreement::stated(const std::vector<double>& about) const {
  optim::Problem problem;
  problem.name = "constants";
  for (std::size_t i = 0; i < about.size(); ++i) {
    const Unknown& u = model_->unknowns()[i];
    problem.variables.push_back({u.name, u.unit, lower_[i], upper_[i], about[i]});
    problem.variables.back().scale = typical_change(i, about);
  }
  for (const std::size_t c : finite_) {
    const PrintedConstant& printed = model_->constants()[c];
    optim::Constraint limit;
    limit.response = model_->response(c);
    // A little within: what the search takes for met is then met.
    const double half = half_of(printed), inside = 1e-4 * half;
    limit.lower = printed.low + inside;
    limit.upper = printed.high - inside;
    limit.tolerance = inside;
    limit.scale = half;
    problem.constraints.push_back(std::move(limit));
  }
  return problem;
}

}  // namespace camlaw::problems
