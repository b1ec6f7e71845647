// SPDX-License-Identifier: MIT
#include "output/answers/rulers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/law_conditions.h"
#include "kinematics/peaks.h"
#include "kinematics/program/segment_merits.h"
#include "kinematics/shape.h"
#include "optim/crew/crew.h"

namespace camlaw::cli {
namespace {

using problems::ProblemStatement;

/// The laws of the catalogue that can take the free law's place.
std::vector<Member> rivals_of(const Law<double>& free) {
  const LawConditions wanted = conditions_of(free);
  std::vector<Member> result;
  for (const Family& family : catalogue()) {
    if (family.name == "b-spline" || family.name == "table") continue;
    const Member member{&family, family.defaults()};
    if (meets(member.law(), wanted)) result.push_back(member);
  }
  return result;
}

/// Combinations of choices that each rival is tried with at most: beyond that the rivals would take
/// far longer than the answer.
constexpr double kMostChoices = 100;

/// Combinations of the choices of a problem.
double choices_of(const ProblemStatement& statement) {
  double product = 1;
  for (const auto& v : statement.variables) {
    if (!v.values.empty()) product *= static_cast<double>(v.values.size());
    if (v.values.empty() && v.integer) product *= std::floor(v.upper) - std::ceil(v.lower) + 1;
  }
  return product;
}

/// The answer's problem with other laws: nothing of a law varies, and where `held` no choice.
ProblemStatement with_laws(const Answer& answer, std::vector<Member> laws, bool held) {
  ProblemStatement statement = answer.bound.at(answer.optimum.options, answer.optimum.found.x);
  std::erase_if(statement.variables, [&](const auto& variable) {
    return variable.of_law || (held && (variable.integer || !variable.values.empty()));
  });
  if (laws.size() == 1) laws.push_back(laws.front());  // a choice wants two
  statement.laws = std::move(laws);
  return statement;
}

bool is_stopped(const optim::OptimiseOptions& search) {
  return search.stop != nullptr && *search.stop;
}

/// Tries the rivals.
void try_rivals(const Answer& answer, std::vector<Member> rivals,
                const optim::OptimiseOptions& search, int workers, Rulers& result) {
  result.finished = !is_stopped(search) && !(search.time_limit && *search.time_limit <= 0);
  if (!result.finished) return;
  ProblemStatement free = with_laws(answer, rivals, false);
  result.held = choices_of(free) > kMostChoices;
  const problems::BoundProblem bound(result.held ? with_laws(answer, std::move(rivals), true)
                                                 : std::move(free));
  result.reoptimised = !bound.statement().variables.empty();
  optim::Crew crew({.workers = workers});
  const optim::Optimum best = optim::optimise(bound.space(), search, crew);
  result.finished = !is_stopped(search) &&
                    !(search.time_limit && search.spent + best.wall_s >= *search.time_limit);
  if (optim::is_feasible(best.found.assessment)) {
    result.best = {bound.statement().laws[best.options.front()].label(),
                   best.found.assessment.objective.value};
  }
}

/// The least acceleration for a law's velocity: a limit for laws that begin and end at rest,
/// whether or not the acceleration vanishes there too.
std::optional<double> least_for(const Law<double>& law, const Peaks<double>& peak) {
  const bool rests = vanishes(law, false, 1) && vanishes(law, true, 1);
  if (!rests || !std::isfinite(peak.max_acceleration())) return {};
  return least_acceleration(peak.max_velocity());
}

/// The same of the dynamic moment, for velocity and acceleration.
std::optional<double> least_moment_for(const Law<double>& law, const Peaks<double>& peak) {
  if (!least_for(law, peak) || !std::isfinite(peak.max_dynamic_moment())) return {};
  return least_dynamic_moment(peak.max_velocity(), peak.max_acceleration());
}

/// A share in percent, without what is rounding.
std::string percent(double share) {
  return fmt::format("{:.3g} %", std::abs(share) < 1e-9 ? 0 : 100 * share);
}

}  // namespace

namespace {

/// What can be said of a law alone.
Rulers measured(const Law<double>& law) {
  const auto peak = peaks(law);
  Rulers result{peak, limit_index(peak)};
  result.least_acceleration = least_for(law, peak);
  result.least_moment = least_moment_for(law, peak);
  return result;
}

}  // namespace

std::optional<Rulers> rulers(const Answer& answer, const optim::OptimiseOptions& search,
                             int workers) {
  const std::optional<Member> law = answer.law();
  if (!law) return {};
  Rulers result = measured(law->law());
  // What the free law has at its start it has everywhere.
  const auto& laws = answer.bound.statement().laws;
  const auto free = std::find_if(laws.begin(), laws.end(),
                                 [](const Member& m) { return bool(m.family->listed); });
  std::vector<Member> rivals = rivals_of(free->law());
  result.rivals = static_cast<int>(rivals.size());
  if (!rivals.empty()) try_rivals(answer, std::move(rivals), search, workers, result);
  return result;
}

namespace {

/// What a law is like, by itself.
std::string merits_text(const std::string& what, const Rulers& r) {
  std::string text =
      fmt::format("\n{}\n  C_v = {:.7g}   C_a = {:.7g}   C_j = {}   C_Mdyn = {:.7g}\n", what,
                  r.peaks.max_velocity(), r.peaks.max_acceleration(),
                  std::isinf(r.peaks.max_jerk()) ? "infinite: acceleration jumps"
                                                 : fmt::format("{:.7g}", r.peaks.max_jerk()),
                  r.peaks.max_dynamic_moment());
  if (r.lambda) {
    text += fmt::format("  lambda = {:.6f}, {} below 1, which no law exceeds\n", *r.lambda,
                        percent(1 - *r.lambda));
  }
  if (r.least_acceleration) {
    // Beyond 2 the least is that of 2: a law need not use all the velocity.
    text += fmt::format("  C_a is {} above {:.7g}, the least for {}\n",
                        percent(r.peaks.max_acceleration() / *r.least_acceleration - 1),
                        *r.least_acceleration,
                        r.peaks.max_velocity() > 2 ? "a velocity of at most C_v" : "this C_v");
  }
  if (r.least_moment) {
    text +=
        fmt::format("  C_Mdyn is {} above {:.7g}, the least for at most these C_v and C_a\n",
                    percent(r.peaks.max_dynamic_moment() / *r.least_moment - 1), *r.least_moment);
  }
  return text;
}

std::string rulers_text(const Answer& answer, const Rulers& r) {
  std::string text = merits_text("the law", r);
  const std::string among =
      fmt::format("{} laws of the catalogue{}{}", r.rivals,
                  r.reoptimised ? ", with everything else searched again for each" : "",
                  r.held ? ", choices as in the answer" : "");
  if (!r.finished)
    text += "  figures of merit not finished: stopped before every named law was tried\n";
  if (!r.best && !r.finished) return text;
  if (!r.best) return text + fmt::format("  no named law meets the limits, of {}\n", among);
  const double own = answer.optimum.found.assessment.objective.value;
  return text + fmt::format("  the best named law is {} with {} = {:.7g}{}, {} {} (of {})\n",
                            r.best->law, answer.bound.statement().objectives.front().response.name,
                            r.best->objective,
                            answer.optimum.problem.objective().response.unit == "1"
                                ? ""
                                : " " + answer.optimum.problem.objective().response.unit,
                            percent(std::abs(r.best->objective / own - 1)),
                            r.best->objective >= own ? "more" : "less", among);
}

void add_merits(const Rulers& r, Document& document) {
  document.fact("C_v", r.peaks.max_velocity());
  document.fact("C_a", r.peaks.max_acceleration());
  document.fact("C_j", r.peaks.max_jerk());
  document.fact("C_Mdyn", r.peaks.max_dynamic_moment());
  document.fact("lambda", r.lambda);
  document.fact("least_C_a_for_C_v", r.least_acceleration);
  document.fact("least_C_Mdyn_for_C_v_and_C_a", r.least_moment);
}

}  // namespace

Document rulers_document(const Answer& answer, const Rulers& r) {
  Json best = nullptr;
  if (r.best) best = {{"law", r.best->law}, {"objective", to_json(r.best->objective)}};
  Document document;
  document.say(rulers_text(answer, r));
  add_merits(r, document);
  document.fact("named_laws", r.rivals);
  document.fact("reoptimised", r.reoptimised);
  document.fact("choices_held", r.held);
  document.fact("finished", r.finished);
  document.fact("best_named", best);
  return document;
}

std::vector<std::string> free_segments(const ProblemStatement& statement) {
  std::vector<std::string> names;
  const Member& program = statement.laws.front();
  if (!program.family->spans) return names;
  for (const NamedSpan& span : program.family->spans(program.arguments)) {
    const bool is_free = std::any_of(
        statement.variables.begin(), statement.variables.end(),
        [&](const auto& v) { return v.of_law && v.law_parameter == span.name + "_coefficients"; });
    if (is_free) names.push_back(span.name);
  }
  return names;
}

Document segment_rulers(const Answer& answer) {
  Document all;
  const std::optional<Member> law = answer.law();
  if (!law) return all;
  const std::vector<std::string> free = free_segments(answer.bound.statement());
  for (const SegmentMerits& segment : segment_merits(*law)) {
    const bool is_free = std::find(free.begin(), free.end(), segment.name) != free.end();
    if (!is_free || !segment.law) continue;
    const Rulers own = measured(*segment.law);
    Document document;
    document.say(merits_text("segment " + segment.name, own));
    add_merits(own, document);
    all.add(segment.name, std::move(document));
  }
  return all;
}

}  // namespace camlaw::cli
