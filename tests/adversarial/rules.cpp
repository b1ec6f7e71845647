// SPDX-License-Identifier: MIT
#include "tests/adversarial/rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>

#include "optim/cycle/extremes.h"
#include "optim/pareto/pareto.h"
#include "optim/verdict/verdict.h"
#include "problems/statement/bind.h"

namespace camlaw::adversary {
namespace {

double processor_s() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

std::string words(const Point& x) {
  std::string result;
  for (const double value : x) result += fmt::format("{}{:.9g}", result.empty() ? "" : ", ", value);
  return "(" + result + ")";
}

std::vector<std::string> names_of(const PlainProblem& plain) {
  std::vector<std::string> names;
  for (const PlainVariable& v : plain.variables) names.push_back(v.name);
  return names;
}

/// Whether one side of a limit has room everywhere at a design, a thousandth of its size at least,
/// by the powers with which it vanishes at rests; how much.
std::optional<double> room_of(const Model& model, const Look& look, const std::vector<Spot>& grid,
                              const Side& side, double tolerance) {
  const Peak peak = peak_of(model, look, grid, side.response, side.sign, side.bound, true);
  const double room = -peak.divided / std::max(peak.scale, tolerance * 1e3);
  return room > 1e-3 ? std::optional(room) : std::nullopt;
}

/// The side of its limit that a report tells of.
bool is_told(const PlainProblem& plain, const SaidLimit& said, const Side& side) {
  const PlainLimit& limit = plain.limits[static_cast<std::size_t>(side.limit)];
  return !(limit.lower && limit.upper) || said.is_upper == (side.sign > 0);
}

/// The objective may be off by its own tolerance and by ten times what the tolerances of the limits
/// are worth that it stands at; but where these are worth more than a thousandth of it that is no
/// excuse.
double slack_of(const PlainProblem& plain, const Outcome& outcome) {
  const Answer& answer = outcome.answer;
  const double size = std::abs(answer.objective);
  const auto look = plain.model->look(answer.x);
  double worth = 0;
  for (const Side& side : sides(plain)) {
    const SaidLimit& said = answer.limits[static_cast<std::size_t>(side.limit)];
    if (said.price == 0 || !is_told(plain, said, side) || look == nullptr) continue;
    if (!said.is_equation &&
        room_of(*plain.model, *look, outcome.truth.grid, side, said.tolerance)) {
      continue;
    }
    worth += std::abs(said.price) * said.tolerance;
  }
  return answer.objective_tolerance + std::min(10 * worth, 1e-3 * size) + 1e-9 * size;
}

/// What a search found is true of the places that it looked at. Its design is looked at again, more
/// closely, and led within the limits where it passes one between them; dropped where it cannot be.
void confirm(const PlainProblem& plain, const std::vector<Spot>& fine, Truth& truth) {
  if (!truth.best) return;
  const auto meets = [&](const Point& x) {
    const auto look = plain.model->look(x);
    return look != nullptr && violation_of(plain, *look, x, fine, true) <= kRounding &&
           !std::isnan(objective_of(plain, *look, fine, true));
  };
  if (!meets(*truth.best)) truth.best = descend(plain, fine, *truth.best);
  if (!truth.best || !meets(*truth.best)) {
    truth.best.reset();
    return;
  }
  truth.value = objective_of(plain, *plain.model->look(*truth.best), fine, true);
}

/// (a): a better design.
void judge_optimum(const Case& test, Outcome& outcome) {
  const Answer& answer = outcome.answer;
  const PlainProblem& plain = test.plain;
  const double slack = slack_of(plain, outcome);
  const auto gain = [&](double value) { return plain.sense * (answer.objective - value); };
  const bool beaten = outcome.truth.best && gain(outcome.truth.value) > slack;
  const auto tell = [&](const Point& x, double value) {
    outcome.wrong.push_back(
        {'a',
         fmt::format("{:.9g} at {} is better than {:.9g} at {}, by {:.2g} where {:.2g} is allowed",
                     value, words(x), answer.objective, words(answer.x), gain(value), slack)});
  };
  if (answer.said == Said::Feasible) {
    outcome.right = !beaten;
    return;
  }
  if (answer.said != Said::Certified) return;
  if (beaten && answer.global) return tell(*outcome.truth.best, outcome.truth.value);
  if (answer.global) return;
  Truth near;
  near.best = descend(plain, outcome.truth.grid, answer.x);
  confirm(plain, outcome.fine, near);
  if (near.best && gain(near.value) > slack) return tell(*near.best, near.value);
  outcome.other_valley = beaten;
}

/// (b): a limit that is passed though it is said to be met. (d): one that is said to push though it
/// has room. (f): a tolerance that has grown with the box.
void judge_limits(const Case& test, Outcome& outcome) {
  const PlainProblem& plain = test.plain;
  const Answer& answer = outcome.answer;
  const Model& model = *plain.model;
  const auto look = model.look(answer.x);
  if (look == nullptr) {
    outcome.wrong.push_back({'b', "there is no such machine at " + words(answer.x)});
    return;
  }
  const auto& grid = outcome.fine;
  for (const Side& side : sides(plain)) {
    const SaidLimit& said = answer.limits[static_cast<std::size_t>(side.limit)];
    const Extreme high = extreme_of(model, *look, grid, side.response, side.sign, true);
    const double over = high.value - side.sign * side.bound;
    const std::string where =
        model.is_curve(side.response) ? fmt::format(" at {:.9g}", look->angle(high.at)) : "";
    // A number that stands at 0 tells nothing of its size but by its terms.
    const bool curve = model.is_curve(side.response);
    const double own =
        curve ? high.magnitude : std::max(look->magnitude(side.response), std::abs(side.bound));
    // "Met wherever it was evaluated, but not proved" claims no more than that.
    const bool claimed = said.met && (said.proved || answer.said == Said::Certified);
    // No tolerance of ours is as large as a ten-thousandth of what it is about.
    const double most = own > 0 ? std::min(said.tolerance, 1e-4 * own) : said.tolerance;
    if (claimed && !(over <= most * (1 + 1e-6) + 1e-12 * high.magnitude)) {
      outcome.wrong.push_back(
          {'b',
           fmt::format("{} is {:.9g}{}, {:.3g} beyond {:.9g}; met to {:.3g}, it says", said.name,
                       side.sign * high.value, where, over, side.bound, said.tolerance)});
    }
    if (side.bound == 0 && own > 0 && said.tolerance > 1e-4 * own) {
      outcome.wrong.push_back(
          {'f', fmt::format("the tolerance of {}, {:.3g}, is {:.2g} of what it is made of, {:.3g}",
                            said.name, said.tolerance, said.tolerance / own, own)});
    }
    if (said.is_equation || !is_told(plain, said, side)) continue;
    const double worth = std::abs(said.price) * std::max(high.magnitude, std::abs(side.bound));
    if (!(worth > 1e-5 * std::abs(answer.objective))) continue;
    const auto room = room_of(model, *look, grid, side, said.tolerance);
    if (!room) continue;
    outcome.wrong.push_back({'d', fmt::format("{} has room everywhere, {:.2g} of its size at "
                                              "least, and is said to be worth {:.3g} a unit",
                                              said.name, *room, said.price)});
  }
}

/// (e): a printed peak that is exceeded.
void judge_peaks(const Case& test, const problems::ProblemStatement& design, Outcome& outcome) {
  const PlainProblem& plain = test.plain;
  const auto look = plain.model->look(outcome.answer.x);
  if (look == nullptr) return;
  const auto printed = problems::evaluate(design);
  for (std::size_t i = 0; i < plain.names.size(); ++i) {
    const int response = static_cast<int>(i);
    if (!plain.model->is_curve(response)) continue;
    const auto found = std::find_if(printed.begin(), printed.end(),
                                    [&](const auto& p) { return p.name == plain.names[i]; });
    if (found == printed.end() || !found->is_curve) continue;
    if (!found->proved) continue;  // it is printed as sampled
    for (const double sign : {1.0, -1.0}) {
      const Extreme high = extreme_of(*plain.model, *look, outcome.fine, response, sign, true);
      const double said = sign > 0 ? found->highest : found->lowest;
      if (!std::isfinite(said) || !(sign * said < high.value - 1e-6 * high.magnitude)) continue;
      outcome.wrong.push_back(
          {'e', fmt::format("{} {} is printed as {:.6g} and is {:.6g} at {:.6g}",
                            sign > 0 ? "highest" : "lowest", plain.names[i], said,
                            sign * high.value, look->angle(high.at))});
    }
  }
}

/// (f): another verdict on the same design in a wider box.
void judge_box(const Case& test, const optim::Optimum& optimum, Outcome& outcome) {
  const Answer wide = in_wider_box(optimum, 1e3, names_of(test.plain));
  // Judged again in its own box: what only a search sees is no matter of the box.
  const Answer answer = in_wider_box(optimum, 1, names_of(test.plain));
  for (std::size_t i = 0; i < wide.limits.size(); ++i) {
    if (wide.limits[i].met == answer.limits[i].met) continue;
    outcome.wrong.push_back(
        {'f', fmt::format("{} is {} here, and {} in a box a thousand times as wide",
                          answer.limits[i].name, answer.limits[i].met ? "met" : "not met",
                          wide.limits[i].met ? "met" : "not met")});
  }
  if (answer.at_a_bound || wide.said == answer.said || answer.said == Said::Infeasible) return;
  // A lower bound over the box, which certifies where the conditions hold to less than their
  // tolerance, says nothing of a wider box.
  if (optimum.found.assessment.kkt_residual > optim::kKktTolerance) return;
  outcome.wrong.push_back(
      {'f', fmt::format("{} here, and {} in a box a thousand times as wide ({})", word(answer.said),
                        word(wide.said), wide.reason)});
}

bool is_affine(const PlainProblem& plain) { return plain.model->affine(); }

Truth truth_of(const Case& test, const Answer& answer, Random random) {
  const PlainProblem& plain = test.plain;
  if (is_affine(plain)) return solve_linear(plain);
  if (test.known) {
    Truth truth;
    truth.grid = grid_of(*plain.model);
    truth.best = test.known;
    truth.value = objective_of(plain, *plain.model->look(*test.known), truth.grid, true);
    truth.bound = truth.value;
    return truth;
  }
  std::vector<Point> starts;
  if (!answer.x.empty()) starts.push_back(answer.x);
  return search(plain, starts, random);
}

/// (a) at each point of a front: the least of each objective, the others no greater than there.
void judge_front(const Case& test, const problems::BoundProblem& bound, double& solved_at,
                 Outcome& outcome) {
  const optim::Front front = optim::pareto(bound.front_space(), {.points = 3});
  solved_at = processor_s();
  Answer& answer = outcome.answer;
  answer.said = front.points.empty() ? Said::Infeasible : Said::Certified;
  answer.global = true;
  outcome.right = true;
  for (const optim::FrontPoint& point : front.points) {
    answer.global = answer.global && point.is_global;
    if (point.verdict == optim::Verdict::Certified) continue;
    answer.said = Said::Feasible;
    answer.reason = point.reason;
  }
  outcome.right = answer.said == Said::Feasible;
  // A front without points says that there are no designs.
  if (front.points.empty()) {
    PlainProblem alone = test.plain;
    alone.objective = test.front[0].response;
    alone.part = test.front[0].part;
    outcome.truth = solve_linear(alone);
    if (!outcome.truth.best) return;
    outcome.wrong.push_back(
        {'c', "the front is empty, and " + words(*outcome.truth.best) + " meets every limit"});
    return;
  }
  for (const optim::FrontPoint& point : front.points) {
    for (std::size_t i = 0; i < test.front.size(); ++i) {
      PlainProblem one = test.plain;
      one.objective = test.front[i].response;
      one.part = test.front[i].part;
      double slack = 1e-5 * std::abs(point.objectives[i]), worth = 0;
      for (std::size_t k = 0; k < test.front.size(); ++k) {
        if (k == i) continue;
        PlainLimit limit{test.front[k].response, {}, point.objectives[k]};
        if (test.front[k].part == Part::Magnitude) limit.lower = -point.objectives[k];
        one.limits.push_back(limit);
        if (point.weights.size() <= k || !(point.weights[i] > 0)) continue;
        worth += point.weights[k] / point.weights[i] * 1e-6 * std::abs(point.objectives[k]);
      }
      slack += std::min(10 * worth, 1e-3 * std::abs(point.objectives[i]));
      Truth truth = solve_linear(one);
      if (outcome.truth.grid.empty()) outcome.truth = truth;
      // What counts nothing at an end of the front may be less elsewhere at no price.
      const bool counts = point.weights.size() > i && point.weights[i] > 0;
      if (!truth.best || !(point.objectives[i] - truth.value > slack)) continue;
      outcome.right = false;
      if (!(point.is_global && point.verdict == optim::Verdict::Certified) || !counts) continue;
      outcome.wrong.push_back(
          {'a', fmt::format("point with objectives {}: objective {} may be {:.9g} at {}",
                            words(point.objectives), i + 1, truth.value, words(*truth.best))});
    }
  }
}

/// (g): a point that is certified though the enclosures of its own numbers do not show them.
void judge_vague_front(const optim::Problem& problem, double& solved_at, Outcome& outcome) {
  const optim::Front front = optim::pareto(problem, {.points = 3});
  solved_at = processor_s();
  outcome.answer.said = Said::Feasible;
  for (const optim::FrontPoint& point : front.points) {
    if (point.verdict != optim::Verdict::Certified) continue;
    outcome.answer.said = Said::Certified;
    for (std::size_t i = 0; i < problem.objectives.size(); ++i) {
      const optim::Bounds shown = problem.objectives[i].response.function().enclose(point.x);
      if (shown.upper - shown.lower <= 1e-5 * std::abs(point.objectives[i])) continue;
      outcome.wrong.push_back(
          {'g', fmt::format("a point is certified whose objective {}, {:.9g}, is shown to lie "
                            "between {:.6g} and {:.6g} only",
                            i + 1, point.objectives[i], shown.lower, shown.upper)});
      return;
    }
  }
}

}  // namespace

Outcome judged(const Case& test, Random random) {
  Outcome outcome;
  const auto names = names_of(test.plain);
  double from = processor_s();
  try {
    std::optional<optim::Optimum> optimum;
    std::optional<problems::BoundProblem> bound;
    if (test.vague_front) {
      double solved_at = from;
      judge_vague_front(*test.vague_front, solved_at, outcome);
      outcome.solve_s = solved_at - from;
      outcome.judge_s = processor_s() - solved_at;
      return outcome;
    }
    if (!test.front.empty()) {
      bound.emplace(problems::read_problem(test.text, test.kind, test.files));
      double solved_at = from;
      judge_front(test, *bound, solved_at, outcome);
      outcome.solve_s = solved_at - from;
      outcome.judge_s = processor_s() - solved_at;
      return outcome;
    }
    if (test.api) {
      optimum = optim::optimise(*test.api);
    } else {
      bound.emplace(problems::read_problem(test.text, test.kind, test.files));
      optimum = optim::optimise(bound->space());
    }
    outcome.answer = answer_of(*optimum, names);
    outcome.solve_s = processor_s() - from;
    from = processor_s();
    const Answer& answer = outcome.answer;
    outcome.truth = truth_of(test, answer, random);
    outcome.fine = grid_of(*test.plain.model, kCloser);
    if (!is_affine(test.plain) && !test.known) confirm(test.plain, outcome.fine, outcome.truth);
    if (answer.said == Said::Certified || answer.said == Said::Feasible) {
      judge_optimum(test, outcome);
      judge_limits(test, outcome);
      judge_box(test, *optimum, outcome);
      if (test.evaluated && bound) {
        judge_peaks(test, bound->at(optimum->options, optimum->found.x), outcome);
      }
    } else if (answer.said == Said::Infeasible && outcome.truth.best) {
      outcome.wrong.push_back(
          {'c', fmt::format("{:.9g} at {} meets every limit; infeasible{}, it says: {}",
                            outcome.truth.value, words(*outcome.truth.best),
                            answer.global ? " everywhere" : "", answer.reason)});
    }
  } catch (const std::exception& error) {
    outcome.crashed = true;
    outcome.answer.reason = error.what();
  }
  (outcome.solve_s == 0 ? outcome.solve_s : outcome.judge_s) = processor_s() - from;
  return outcome;
}

double difference(const Case& test, Random random, std::string& where) {
  if (test.vague_front) return 0;
  const PlainProblem& plain = test.plain;
  double worst = 0;
  Point x;
  for (const PlainVariable& v : plain.variables) {
    x.push_back(random.between(std::max(v.low, v.lower), std::min(v.high, v.upper)));
  }
  const auto look = plain.model->look(x);
  if (look == nullptr) return 0;
  const auto compare = [&](const std::string& name, double theirs, double ours, double size) {
    const double off = std::abs(theirs - ours) / std::max(size, 1e-300);
    if (!(off <= worst) && !(std::isnan(theirs) && std::isnan(ours))) {
      worst = off;
      where = fmt::format("{}: {:.9g} there, {:.9g} here, design {}", name, theirs, ours, words(x));
    }
  };
  const auto grid = grid_of(*plain.model);
  if (!test.front.empty() || test.vague_front)
    return 0;  // of the same curves as other problems of laws
  const optim::Problem problem =
      test.api ? *test.api
               : problems::BoundProblem(problems::read_problem(test.text, test.kind, test.files))
                     .space()
                     .problem({});
  std::vector<double> design(problem.variables.size());
  for (std::size_t i = 0; i < design.size(); ++i) {
    for (std::size_t k = 0; k < x.size(); ++k) {
      if (problem.variables[i].name == plain.variables[k].name) design[i] = x[k];
    }
  }
  const auto of_response = [&](const optim::Response& response, int index,
                               const std::string& name) {
    if (!response.is_curve()) {
      const double ours = look->value(index, {0, 0.5, 0.5});
      return compare(name, response.function().value(design), ours, std::abs(ours));
    }
    const Extreme size = extreme_of(*plain.model, *look, grid, index, 1, false);
    const auto trace = response.curve().trace(design);
    for (int i = 0; i < 12; ++i) {
      const Spot at = grid[static_cast<std::size_t>(random.below(static_cast<int>(grid.size())))];
      if (at.u < 1e-3 || at.w < 1e-3) continue;
      compare(fmt::format("{} at {:.9g}", name, look->angle(at)), trace->at({look->angle(at)})[0],
              look->value(index, at), size.magnitude);
    }
  };
  of_response(problem.objective().response, plain.objective, "objective");
  for (std::size_t i = 0; i < plain.limits.size(); ++i) {
    of_response(problem.constraints[i].response, plain.limits[i].response,
                problem.constraints[i].response.name);
  }
  return worst;
}

}  // namespace camlaw::adversary
