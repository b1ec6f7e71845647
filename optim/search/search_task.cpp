// SPDX-License-Identifier: MIT
#include "optim/search/search_task.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "optim/search/everywhere.h"
#include "optim/search/local.h"
#include "optim/search/options_bytes.h"
#include "optim/solvers/solver.h"

namespace camlaw::optim {

template <>
inline constexpr int kLast<SearchTask::Kind> = static_cast<int>(SearchTask::Kind::Tree);
template <>
inline constexpr int kLast<FirstStart> = static_cast<int>(FirstStart::InVain);
template <>
inline constexpr int kLast<StartEnd> = static_cast<int>(StartEnd::NotBegun);
template <>
inline constexpr int kLast<Status> = static_cast<int>(Status::Failed);

// Each visit names every member, so that one which is added is not forgotten.

template <class Archive, class B>
requires std::is_same_v<std::remove_const_t<B>, Bounds>
void visit(Archive& archive, B& bounds) {
  auto& [lower, upper] = bounds;
  archive(lower), archive(upper);
}

template <class Archive, class P>
requires std::is_same_v<std::remove_const_t<P>, Place>
void visit(Archive& archive, P& place) {
  auto& [angle, from_left, joint] = place;
  archive(angle), archive(from_left), archive(joint);
}

template <class Archive, class L>
requires std::is_same_v<std::remove_const_t<L>, LimitReport>
void visit(Archive& archive, L& limit) {
  auto& [name, unit, value, bound, is_upper, margin, tolerance, worst_angle, from_left, is_equation,
         met, proved, left, multiplier, at_rest] = limit;
  archive(name), archive(unit), archive(value), archive(bound), archive(is_upper), archive(margin);
  archive(tolerance), archive(worst_angle), archive(from_left), archive(is_equation), archive(met);
  archive(proved), archive(left), archive(multiplier), archive(at_rest);
}

template <class Archive, class O>
requires std::is_same_v<std::remove_const_t<O>, ObjectiveReport>
void visit(Archive& archive, O& objective) {
  auto& [value, angle, from_left, sign, proved, tolerance] = objective;
  archive(value), archive(angle), archive(from_left), archive(sign), archive(proved);
  archive(tolerance);
}

template <class Archive, class V>
requires std::is_same_v<std::remove_const_t<V>, VariableReport>
void visit(Archive& archive, V& variable) {
  auto& [name, unit, value, lower, upper, at_lower, at_upper, multiplier] = variable;
  archive(name), archive(unit), archive(value), archive(lower), archive(upper), archive(at_lower);
  archive(at_upper), archive(multiplier);
}

template <class Archive, class A>
requires std::is_same_v<std::remove_const_t<A>, Assessment>
void visit(Archive& archive, A& assessment) {
  auto& [verdict, reason, objective, variables, limits, kkt_residual, condition, second_order,
         is_global, at_moving_break, active, blamed, global, best_possible, sign,
         objective_measure] = assessment;
  archive(verdict), archive(reason), archive(objective), archive(variables), archive(limits);
  archive(kkt_residual), archive(condition), archive(second_order), archive(is_global);
  archive(at_moving_break), archive(active), archive(blamed), archive(global);
  archive(best_possible), archive(sign), archive(objective_measure);
}

template <class Archive, class F>
requires std::is_same_v<std::remove_const_t<F>, Found>
void visit(Archive& archive, F& found) {
  auto& [x, assessment, status, solver, why_solver, starts, planned_starts, agreed, iterations,
         evaluations, solves] = found;
  archive(x), archive(assessment), archive(status), archive(solver), archive(why_solver);
  archive(starts), archive(planned_starts), archive(agreed), archive(iterations);
  archive(evaluations), archive(solves);
}

/// Without the function, which find_functions() finds again.
template <class Archive, class P>
requires std::is_same_v<std::remove_const_t<P>, Push>
void visit(Archive& archive, P& push) {
  auto& [constraint, variable, function, sign, size, at_rest, price, place, rest] = push;
  archive(constraint), archive(variable), archive(sign), archive(size), archive(at_rest);
  archive(price), archive(place), archive(rest);
}

template <class Archive, class C>
requires std::is_same_v<std::remove_const_t<C>, ConstraintScale>
void visit(Archive& archive, C& one) {
  auto& [scale, tolerance, default_tolerance] = one;
  archive(scale), archive(tolerance), archive(default_tolerance);
}

template <class Archive, class S>
requires std::is_same_v<std::remove_const_t<S>, Scales>
void visit(Archive& archive, S& scales) {
  auto& [variables, own, objective, objective_tolerance, objective_typical, constraints] = scales;
  archive(variables), archive(own), archive(objective), archive(objective_tolerance);
  archive(objective_typical), archive(constraints);
}

template <class Archive, class T>
requires std::is_same_v<std::remove_const_t<T>, Trail>
void visit(Archive& archive, T& trail) {
  auto& [found, message, told, scales, last, thrown, at_edge, is_judged, in_vain, unbounded,
         design_elsewhere, none_elsewhere] = trail;
  archive(found), archive(message), archive(told), archive(scales), archive(last), archive(thrown);
  archive(at_edge.x), archive(at_edge.cost), archive(is_judged), archive(in_vain);
  archive(unbounded), archive(design_elsewhere), archive(none_elsewhere);
}

template <class Archive, class F>
requires std::is_same_v<std::remove_const_t<F>, FromStart>
void visit(Archive& archive, F& start) {
  auto& [trail, objective, end] = start;
  archive(trail), archive(objective), archive(end);
}

template <class Archive, class D>
requires std::is_same_v<std::remove_const_t<D>, IntegerDesign>
void visit(Archive& archive, D& design) {
  auto& [x, objective, starts, agreed] = design;
  archive(x), archive(objective), archive(starts), archive(agreed);
}

template <class Archive, class O>
requires std::is_same_v<std::remove_const_t<O>, IntegerOutcome>
void visit(Archive& archive, O& outcome) {
  auto& [found, combinations, solved, complete, infeasible, all_infeasible, bounds_hold, enumerated,
         neighbours_tried, designs] = outcome;
  archive(found), archive(combinations), archive(solved), archive(complete), archive(infeasible);
  archive(all_infeasible), archive(bounds_hold), archive(enumerated), archive(neighbours_tried),
      archive(designs);
}

template <class Archive, class T>
requires std::is_same_v<std::remove_const_t<T>, SearchTask>
void visit(Archive& archive, T& task) {
  auto& [kind, options, integers, start, first, known, how, tells_progress, tells_candidates] =
      task;
  archive(kind), archive(options), archive(integers), archive(start), archive(first);
  archive(known), archive(how), archive(tells_progress), archive(tells_candidates);
}

template <class Archive, class P>
requires std::is_same_v<std::remove_const_t<P>, Progress>
void visit(Archive& archive, P& progress) {
  auto& [iteration, objective, violation, done] = progress;
  archive(iteration), archive(objective), archive(violation), archive(done);
}

template <class Archive, class C>
requires std::is_same_v<std::remove_const_t<C>, Candidate>
void visit(Archive& archive, C& candidate) {
  auto& [options, x, is_best, assessment] = candidate;
  archive(options), archive(x), archive(is_best), archive(assessment);
}

std::string encoded(const SearchTask& task) { return bytes_of(task); }
std::optional<SearchAnswer> decoded_answer(std::string_view bytes) {
  return value_of_bytes<SearchAnswer>(bytes);
}
std::optional<SearchNews> decoded_news(std::string_view bytes) {
  return value_of_bytes<SearchNews>(bytes);
}

std::string why_confined(const OptimiseOptions& options) {
  const auto why = [](const std::string& solver) {
    return "other processes do not know the solver " + solver;
  };
  if (is_registered(options.solver)) return why(options.solver);
  for (const auto& [solver, native] : options.native) {
    if (is_registered(solver)) return why(solver);
  }
  return "";
}

const Problem& SearchDesk::problem(const std::vector<std::size_t>& options) {
  if (!problem_ || options_ != options) {
    problem_ = space_.problem(options);
    options_ = options;
  }
  return *problem_;
}

SearchAnswer SearchDesk::carry_out(const SearchTask& task, const Deadline& deadline) {
  const Problem& whole = problem(task.options);
  if (task.kind == SearchTask::Kind::Tree) return search_tree(whole, task.how, deadline);
  if (task.kind == SearchTask::Kind::Everywhere)
    return search_everywhere(whole, task.how, deadline, task.known);
  const Problem held = task.integers.empty() ? whole : with_integers(whole, task.integers);
  if (task.kind == SearchTask::Kind::Continuous)
    return search_continuous(held, task.how, deadline, Depth::Combination, task.known);
  const bool is_alone = task.integers.empty();
  return search_one_start(is_alone ? whole : held, task.how, deadline, task.start, task.first);
}

namespace {

/// Hands on what a search tells.
void listen(SearchTask& task, const Bench& bench) {
  if (!bench.tell) return;
  const auto tell = [&bench](SearchNews news) { bench.tell(bytes_of(news)); };
  if (task.tells_progress) task.how.progress = tell;
  if (!task.tells_candidates) return;
  task.how.candidate = [tell, options = task.options](Candidate candidate) {
    candidate.options = options;
    tell(std::move(candidate));
  };
}

}  // namespace

Service search_service(std::shared_ptr<SearchDesk> desk) {
  return [desk = std::move(desk)](const std::string& order,
                                  const Bench& bench) -> std::optional<std::string> {
    auto task = value_of_bytes<SearchTask>(order);
    if (!task) return "";
    listen(*task, bench);
    OptimiseOptions& how = task->how;
    how.stop = bench.stop;
    std::optional<double> limit = how.time_limit;
    const bool may_leave = bench.leave_after && (!limit || how.spent + *bench.leave_after < *limit);
    if (may_leave) limit = how.spent + *bench.leave_after;
    const Deadline deadline(limit, bench.stop, how.spent);
    const SearchAnswer answer = desk->carry_out(*task, deadline);
    constexpr double kNearly = 1e-3;  // s: a solver may look at a clock that ticks otherwise
    if (may_leave && deadline.spent() > *limit - kNearly && !deadline.stopped()) return {};
    return bytes_of(answer);
  };
}

}  // namespace camlaw::optim
