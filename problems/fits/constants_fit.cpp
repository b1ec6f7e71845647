// SPDX-License-Identifier: MIT
#include "problems/fits/constants_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "kinematics/peaks.h"
#include "optim/cycle/peak_function.h"
#include "optim/fit/identifiability.h"
#include "optim/fit/least_squares.h"
#include "optim/pareto/shifted.h"
#include "optim/search/optimise.h"
#include "problems/fits/coefficients.h"
#include "problems/fits/simplest.h"

namespace camlaw::problems {
namespace {

using optim::Function;

constexpr int kPlaces = 24;  ///< that are looked at before the search begins
constexpr std::size_t kStarts = 4;
constexpr int kIterations = 100;

/// A number to be found: a coefficient of the law or a parameter of the machine.
struct Unknown {
  std::string name, unit;
  bool of_law;
  std::size_t parameter, element;  ///< of the family, or of the mechanism
  double lower, upper, standard;
};

std::vector<Unknown> unknowns_of(const ConstantsQuestion& question, const Member& law) {
  std::vector<Unknown> result;
  for (const VariableStatement& v : question.machine.variables) {
    if (v.of_law) continue;
    result.push_back({v.name, v.unit, false, v.parameter, 0, v.lower, v.upper, v.start});
  }
  for (const Coefficient& c : coefficients_of(law)) {
    result.push_back({c.name, c.unit, true, c.at.parameter, c.at.element, c.low, c.high, c.value});
  }
  return result;
}

/// The printed constants as functions of the unknowns.
class Model {
 public:
  Model(const ConstantsQuestion& question, Member law)
      : question_(question), law_(std::move(law)), unknowns_(unknowns_of(question, law_)) {
    std::vector<LawVariable> of_law;
    Binding machine;
    machine.constants = question.machine.constants;
    for (std::size_t i = 0; i < unknowns_.size(); ++i) {
      const Unknown& u = unknowns_[i];
      if (u.of_law) {
        of_law.push_back({u.parameter, u.element, i});
      } else {
        machine.parameters.push_back(u.parameter);
        machine.variables.push_back(i);
      }
    }
    machine.law = std::make_shared<LawBinding>(law_, std::move(of_law));
    Binding alone;  // the law's own constants do not see the machine
    alone.constants = law_alone().constants;
    alone.law = machine.law;
    for (const PrintedConstant& c : question.constants) {
      const Binding& binding = c.of == question.machine.mechanism ? machine : alone;
      const optim::Response response = make_response(*c.of, c.response, binding);
      functions_.push_back(response.is_curve()
                               ? optim::peak_function(response, c.response.part, unknowns_.size())
                               : response.function());
    }
  }

  /// Values of the unknowns over their ranges, the standard ones first, and the constants there.
  struct Place {
    std::vector<double> x, values;
  };
  const std::vector<Place>& places() const {
    for (int n = static_cast<int>(places_.size()); n < kPlaces && !unknowns_.empty(); ++n) {
      Place place{place_of(n), {}};
      for (const Function& f : functions_) place.values.push_back(f.value(place.x));
      places_.push_back(std::move(place));
    }
    return places_;
  }

  const std::vector<Unknown>& unknowns() const { return unknowns_; }
  const Function& function(std::size_t constant) const { return functions_[constant]; }
  const std::vector<PrintedConstant>& constants() const { return question_.constants; }

  std::vector<double> standard() const {
    std::vector<double> result;
    for (const Unknown& u : unknowns_) result.push_back(u.standard);
    return result;
  }
  double value(std::size_t constant, std::span<const double> x) const {
    return functions_[constant].value(x);
  }
  bool agrees(std::size_t constant, std::span<const double> x) const {
    constexpr double kRounding = 1e-9;  // of the interval, which a search may end on the edge of
    const PrintedConstant& c = constants()[constant];
    const double v = value(constant, x);
    if (std::isinf(c.value)) return v == c.value || is_unbounded(c, x);
    const double room = kRounding * std::max(c.high - c.low, std::abs(c.value));
    return v >= c.low - room && v <= c.high + room;
  }
  Member law_at(std::span<const double> x) const {
    Member result = law_;
    for (std::size_t i = 0; i < unknowns_.size(); ++i) {
      const Unknown& u = unknowns_[i];
      if (u.of_law) result.arguments.values()[u.parameter][u.element] = x[i];
    }
    return result;
  }

 private:
  /// Jumps of a derivative, at the ends too, make the next one's peak infinite: prints say so,
  /// where the responses are those within the pieces.
  bool is_unbounded(const PrintedConstant& printed, std::span<const double> x) const {
    if (printed.of->name != "law" || printed.value < 0) return false;
    const Peaks<double> its = peaks(law_at(x).law());
    if (printed.name == "C") return std::isinf(its.C());
    return printed.name == "D" && std::isinf(its.D());
  }

  std::vector<double> place_of(int number) const {
    std::vector<double> x = standard();
    if (number == 0) return x;
    for (std::size_t i = 0; i < x.size(); ++i) {
      // Additive recurrence by powers of the plastic constant: even in few dimensions and in many.
      constexpr double kStep = 0.7548776662466927;
      const double power = std::pow(kStep, 1 + static_cast<double>(i));
      const double share = std::fmod(0.5 + number * power, 1.0);
      x[i] = unknowns_[i].lower + share * (unknowns_[i].upper - unknowns_[i].lower);
    }
    return x;
  }

  const ConstantsQuestion& question_;
  Member law_;
  std::vector<Unknown> unknowns_;
  std::vector<Function> functions_;
  mutable std::vector<Place> places_;
};

/// (f - value) / half of some of the constants: at most one where they agree.
class PrintResiduals final : public optim::Residuals {
 public:
  PrintResiduals(const Model& model, std::vector<std::size_t> which)
      : model_(model), which_(std::move(which)) {}
  std::size_t count() const override { return which_.size(); }
  bool evaluate(std::span<const double> p, std::span<double> r,
                std::span<double> jacobian) const override {
    for (std::size_t k = 0; k < which_.size(); ++k) {
      const PrintedConstant& c = model_.constants()[which_[k]];
      const Function& f = model_.function(which_[k]);
      const double half = (c.high - c.low) / 2;
      std::vector<double> g(f.inputs().size());
      r[k] = ((jacobian.empty() ? f.value(p) : f.gradient(p, g)) - c.value) / half;
      if (!std::isfinite(r[k])) return false;
      if (jacobian.empty()) continue;
      std::fill_n(jacobian.begin() + static_cast<std::ptrdiff_t>(k * p.size()), p.size(), 0.0);
      for (std::size_t i = 0; i < g.size(); ++i) {
        jacobian[k * p.size() + f.inputs()[i]] = g[i] / half;
      }
    }
    return true;
  }

 private:
  const Model& model_;
  std::vector<std::size_t> which_;
};

/// The question with which values some constants agree.
class Search {
 public:
  Search(const Model& model, std::vector<std::size_t> which)
      : model_(&model), which_(std::move(which)) {
    for (const Unknown& u : model.unknowns()) {
      lower_.push_back(u.lower);
      upper_.push_back(u.upper);
    }
  }

  /// Values with which all of them agree, no two alike.
  std::vector<std::vector<double>> solutions() const {
    std::vector<std::vector<double>> result;
    if (model_->unknowns().empty()) {
      if (all_agree({})) result.emplace_back();
      return result;
    }
    for (const std::vector<double>& start : starts()) {
      const bool agrees = all_agree(start);
      const auto x = agrees ? start : solved_from(start);
      if (!x || !all_agree(*x)) continue;
      const bool known = std::any_of(result.begin(), result.end(),
                                     [&](const auto& other) { return are_alike(*x, other); });
      if (!known) result.push_back(*x);
      if (agrees && start == model_->standard()) break;  // nothing explains the prints better
    }
    return result;
  }

  bool all_agree(std::span<const double> x) const {
    return std::all_of(which_.begin(), which_.end(),
                       [&](std::size_t c) { return model_->agrees(c, x); });
  }

  /// The least and the greatest of an unknown about a solution.
  std::pair<double, double> range(std::size_t unknown, const std::vector<double>& about) const {
    std::pair<double, double> result{about[unknown], about[unknown]};
    for (const optim::Sense sense : {optim::Sense::Minimize, optim::Sense::Maximize}) {
      optim::Problem problem = stated(about);
      problem.objective = {
          {model_->unknowns()[unknown].name, "1", optim::variable_function(unknown)}, sense};
      const auto x = answer(problem);
      if (!x || !all_agree(*x)) continue;
      result.first = std::min(result.first, (*x)[unknown]);
      result.second = std::max(result.second, (*x)[unknown]);
    }
    return result;
  }

  void hold(std::size_t unknown, double value) { lower_[unknown] = upper_[unknown] = value; }
  /// A solution with what is held now, near another.
  std::optional<std::vector<double>> near(std::vector<double> about) const {
    for (std::size_t i = 0; i < about.size(); ++i) {
      about[i] = std::clamp(about[i], lower_[i], upper_[i]);
    }
    if (all_agree(about)) return about;
    const auto x = balanced(about);
    if (x && all_agree(*x)) return x;
    return {};
  }

  /// Whether the residuals determine each unknown here, to first order.
  std::vector<bool> determined(const std::vector<double>& at) const {
    const PrintResiduals residuals(*model_, finite());
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

 private:
  std::vector<std::size_t> finite() const {
    std::vector<std::size_t> result;
    for (const std::size_t c : which_) {
      if (std::isfinite(model_->constants()[c].value)) result.push_back(c);
    }
    return result;
  }

  bool are_alike(const std::vector<double>& a, const std::vector<double>& b) const {
    constexpr double kAlike = 1e-3;
    for (std::size_t i = 0; i < a.size(); ++i) {
      const double size = std::max({std::abs(a[i]), std::abs(b[i]), 1e-3});
      if (std::abs(a[i] - b[i]) > kAlike * size) return false;
    }
    return true;
  }

  std::vector<optim::FitParameter> parameters(const std::vector<double>& start) const {
    std::vector<optim::FitParameter> result;
    for (std::size_t i = 0; i < start.size(); ++i) {
      const Unknown& u = model_->unknowns()[i];
      result.push_back({u.name, u.unit, lower_[i], upper_[i], start[i]});
    }
    return result;
  }

  /// The standard values, and the places with the least sum of squares.
  std::vector<std::vector<double>> starts() const {
    const auto& places = model_->places();
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t k = 0; k < places.size(); ++k) {
      double sum = 0;
      for (const std::size_t c : finite()) {
        const PrintedConstant& printed = model_->constants()[c];
        const double z = (places[k].values[c] - printed.value) / (printed.high - printed.low);
        sum += z * z;
      }
      if (std::isfinite(sum)) order.emplace_back(k == 0 ? -1 : sum, k);
    }
    std::sort(order.begin(), order.end());
    std::vector<std::vector<double>> result;
    for (std::size_t i = 0; i < std::min(order.size(), 1 + kStarts); ++i) {
      result.push_back(places[order[i].second].x);
    }
    return result;
  }

  std::optional<std::vector<double>> solved_from(const std::vector<double>& start) const {
    const std::vector<std::size_t> numbers = finite();
    if (numbers.empty()) return start;
    std::vector<double> x;
    double largest = 0;
    try {
      optim::FitOptions options;
      options.max_iterations = kIterations;
      const optim::FitResult found =
          optim::fit(parameters(start), PrintResiduals(*model_, numbers), options);
      for (const auto& p : found.parameters) x.push_back(p.value);
      largest = std::abs(found.residuals[found.largest]);
    } catch (const std::invalid_argument&) {
      return {};  // no law, or no number, there
    }
    if (all_agree(x)) return x;
    // The least sum of squares n z^2 has no residual beyond sqrt(n), where all could be below one.
    if (largest > std::sqrt(static_cast<double>(numbers.size()))) return {};
    return balanced(x);
  }

  /// Where the largest residual is least: the sum of squares may leave one out of its interval that
  /// others had room for.
  std::optional<std::vector<double>> balanced(const std::vector<double>& about) const {
    optim::Problem problem = stated(about);
    const std::size_t t = about.size();
    optim::Variable largest;
    largest.name = "largest";
    largest.start = 1;
    largest.scale = 1;
    problem.variables.push_back(largest);
    problem.objective = {{"largest", "1", optim::variable_function(t)}};
    problem.constraints.clear();
    for (const std::size_t c : finite()) {
      const PrintedConstant& printed = model_->constants()[c];
      const double half = (printed.high - printed.low) / 2;
      const optim::Response response{printed.name, "1", model_->function(c)};
      for (const double side : {-1.0, 1.0}) {
        optim::Constraint limit;
        limit.response = optim::shifted(response, side * half, t);
        (side < 0 ? limit.upper : limit.lower) = printed.value;
        limit.tolerance = 1e-3 * half;
        problem.constraints.push_back(std::move(limit));
      }
    }
    auto x = answer(problem);
    if (x) x->pop_back();
    return x;
  }

  optim::Problem stated(const std::vector<double>& about) const {
    optim::Problem problem;
    problem.name = "constants";
    for (std::size_t i = 0; i < about.size(); ++i) {
      const Unknown& u = model_->unknowns()[i];
      problem.variables.push_back({u.name, u.unit, lower_[i], upper_[i], about[i]});
    }
    for (const std::size_t c : finite()) {
      const PrintedConstant& printed = model_->constants()[c];
      optim::Constraint limit;
      limit.response = {printed.name, "1", model_->function(c)};
      // A little within: what the search takes for met is then met.
      const double half = (printed.high - printed.low) / 2, inside = 1e-4 * half;
      limit.lower = printed.low + inside;
      limit.upper = printed.high - inside;
      limit.tolerance = inside;
      limit.scale = half;
      problem.constraints.push_back(std::move(limit));
    }
    return problem;
  }

  static std::optional<std::vector<double>> answer(const optim::Problem& problem) {
    optim::OptimiseOptions options;
    options.solver = "slsqp";
    options.starts = 1;
    options.max_iterations = kIterations;
    const optim::Found found =
        optim::search_continuous(problem, options, optim::Deadline({}, nullptr), false);
    if (found.x.empty()) return {};
    return found.x;
  }

  const Model* model_;
  std::vector<std::size_t> which_;
  std::vector<double> lower_, upper_;
};

/// Each unknown in turn at the simplest value that leaves the others values to agree with.
ConstantsFit rounded(const Model& model, const std::vector<std::size_t>& which,
                     std::vector<double> x) {
  ConstantsFit result{model.law_at(x), {}, {}, 0, false, true};
  Search search(model, which);
  const auto determined = search.determined(x);
  const auto& unknowns = model.unknowns();
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    FoundNumber number{unknowns[i].name, unknowns[i].unit, unknowns[i].of_law};
    number.identifiable = determined[i];
    result.identifiable = result.identifiable && determined[i];
    const auto [low, high] = search.range(i, x);
    std::tie(number.low, number.high) =
        i == 0 ? std::pair(low, high) : Search(model, which).range(i, x);
    SimpleNumber simple = simplest_between(low, high);
    int digits = simple.digits + 1;
    if (low <= unknowns[i].standard && unknowns[i].standard <= high) {
      simple.value = unknowns[i].standard;
      digits = 0;
    }
    Search held = search;
    held.hold(i, simple.value);
    if (const auto near = held.near(x)) {
      x = *near;
      search = held;
      result.cost += digits;
    } else {  // the interval has a gap there
      search.hold(i, x[i]);
      constexpr int kAllDigits = 17;
      result.cost += kAllDigits;
    }
    number.value = x[i];
    result.numbers.push_back(std::move(number));
  }
  result.law = model.law_at(x);
  result.consistent = true;
  for (std::size_t c = 0; c < model.constants().size(); ++c) {
    const PrintedConstant& printed = model.constants()[c];
    const bool agrees = model.agrees(c, x);
    result.constants.push_back({printed, model.value(c, x), agrees});
    result.consistent = result.consistent && agrees;
    if (!agrees) result.cost += printed.digits + 1;
  }
  return result;
}

/// Subsets of n with `left_out` elements missing.
std::vector<std::vector<std::size_t>> subsets(std::size_t n, std::size_t left_out) {
  std::vector<std::vector<std::size_t>> result;
  std::vector<bool> out(n, false);
  std::fill(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(left_out), true);
  do {
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < n; ++i) {
      if (!out[i]) kept.push_back(i);
    }
    result.push_back(std::move(kept));
  } while (std::prev_permutation(out.begin(), out.end()));
  return result;
}

/// Of the constants that are not among `which`.
double cost_of_others(const ConstantsQuestion& question, const std::vector<std::size_t>& which) {
  double cost = 0;
  for (std::size_t c = 0; c < question.constants.size(); ++c) {
    const bool kept = std::find(which.begin(), which.end(), c) != which.end();
    if (!kept) cost += question.constants[c].digits + 1;
  }
  return cost;
}

bool is_better(const ConstantsFit& a, const ConstantsFit& b) {
  return std::pair(a.cost, !a.consistent) < std::pair(b.cost, !b.consistent);
}

}  // namespace

namespace {

/// Explanations that cost at most `limit`.
std::vector<ConstantsFit> explanations(const ConstantsQuestion& question, const Member& law,
                                       double limit) {
  const Model model(question, law);
  if (model.unknowns().empty()) return {rounded(model, {}, {})};  // nothing to look for
  const std::size_t count = question.constants.size();
  for (std::size_t left_out = 0; left_out < count; ++left_out) {
    std::vector<ConstantsFit> found;
    for (const auto& which : subsets(count, left_out)) {
      if (cost_of_others(question, which) > limit) continue;
      for (const auto& x : Search(model, which).solutions()) {
        found.push_back(rounded(model, which, x));
      }
    }
    if (found.empty()) continue;
    std::stable_sort(found.begin(), found.end(), is_better);
    return found;
  }
  return {};
}

}  // namespace

ProblemStatement law_alone() {
  ProblemStatement machine;
  machine.mechanism = &find_mechanism("law");
  for (const MechanismParameter& p : machine.mechanism->parameters) {
    machine.constants.push_back(p.standard);
  }
  return machine;
}

std::vector<ConstantsFit> fit_constants(const ConstantsQuestion& question, const Member& law) {
  return explanations(question, law, optim::kInfinity);
}

std::vector<ConstantsFit> rank_laws(const ConstantsQuestion& question,
                                    const std::vector<Member>& laws) {
  // What contradicts more than the best explanation costs is not looked for: fixed laws, which are
  // quick, first.
  std::vector<std::pair<std::size_t, const Member*>> order;
  for (const Member& law : laws) {
    const std::size_t unknowns = unknowns_of(question, law).size();
    if (unknowns <= question.constants.size()) order.emplace_back(unknowns, &law);
  }
  std::stable_sort(order.begin(), order.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<ConstantsFit> result;
  double best = optim::kInfinity;
  for (const auto& [unknowns, law] : order) {
    for (ConstantsFit& fit : explanations(question, *law, best)) {
      best = std::min(best, fit.cost);
      result.push_back(std::move(fit));
    }
  }
  std::stable_sort(result.begin(), result.end(), is_better);
  return result;
}

std::vector<Member> laws_to_try() {
  std::vector<Member> result;
  for (const Family& family : catalogue()) {
    const auto& parameters = family.parameters;
    // A spline or a table is a curve of its own, not a law.
    constexpr std::size_t kFew = 4;
    const bool is_data = std::any_of(parameters.begin(), parameters.end(), [](const Parameter& p) {
      return p.list && p.standard.size() > kFew;
    });
    if (!is_data) result.push_back({&family, family.standard()});
  }
  return result;
}

}  // namespace camlaw::problems
