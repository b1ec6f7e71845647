// SPDX-License-Identifier: MIT
#include "output/answers/front_answer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "output/answers/law_output.h"
#include "output/answers/warnings.h"
#include "problems/statement/parameters.h"

namespace camlaw::cli {
namespace {

using Parts = std::vector<std::string>;

/// "rise=cycloidal", "return=cosine": what moves, of "program rise=cycloidal return=cosine".
Parts parts_of(const Member& program) {
  Parts parts;
  std::istringstream names(program.family->name);
  for (std::string part; names >> part;) parts.push_back(part);
  return parts;
}

bool is_among(const Parts& parts, const std::string& part) {
  return std::find(parts.begin(), parts.end(), part) != parts.end();
}

/// "rise cycloidal, return cosine": the parts that not all the programs have.
std::string differing(const Member& program, const Parts& common) {
  std::string result;
  for (const std::string& part : parts_of(program)) {
    if (!is_among(common, part)) result += (result.empty() ? "" : ", ") + part;
  }
  std::replace(result.begin(), result.end(), '=', ' ');
  return result;
}

/// What a program is called among those to choose from: by what differs, else by its number too.
std::string program_name(const std::vector<Member>& all, std::size_t i) {
  Parts common = parts_of(all[i]);
  for (const Member& other : all) {
    std::erase_if(common, [theirs = parts_of(other)](const std::string& part) {
      return !is_among(theirs, part);
    });
  }
  const std::string mine = differing(all[i], common);
  const auto as_mine = std::count_if(all.begin(), all.end(), [&](const Member& other) {
    return differing(other, common) == mine;
  });
  if (as_mine == 1) return mine;
  return fmt::format("{}{}program {}", mine, mine.empty() ? "" : ", ", i + 1);
}

}  // namespace

using optim::FrontPoint;

FrontAnswer::FrontAnswer(const problems::FrontStudy& of, const optim::Front& found)
    : study(of),
      front(found),
      ruler(problems::front_ruler(of.bound().statement())),
      warnings(warnings_of(*this)) {
  for (const FrontPoint& point : front.points) {
    built.push_back(problems::buildability(study.design(point)));
  }
}

FrontAnswer::FrontAnswer(const problems::FrontStudy& of, const problems::StoredFront& stored)
    : FrontAnswer(of, stored.front) {
  faults = stored.faults;
  notes = stored.notes;
  resuming = stored.resuming;
}

FrontAnswer::FrontAnswer(const problems::FrontStudy& of, const optim::Front& found,
                         const FrontAnswer& other)
    : study(of),
      front(found),
      ruler(other.ruler),
      warnings(other.warnings),
      built(other.built),
      faults(other.faults),
      notes(other.notes),
      resuming(other.resuming) {}

double FrontAnswer::value(std::size_t i, double cost) const {
  return front.objectives[i].sense == optim::Sense::Minimize ? cost : -cost;
}

std::vector<DesignValue> FrontAnswer::values(const FrontPoint& point) const {
  const auto& space = study.space();
  const auto options = space.options(point.part);
  std::vector<DesignValue> result;
  const std::size_t first = study.bound().statement().chooses_law() ? 1 : 0;
  for (std::size_t i = first; i < space.choices.size(); ++i) {
    const optim::Choice& choice = space.choices[i];
    result.push_back({choice.name, choice.unit, choice.options[options[i]],
                      choice.values.empty() ? std::nan("") : choice.values[options[i]]});
  }
  const optim::Problem problem = space.problem(options);
  for (std::size_t i = 0; i < point.x.size(); ++i) {
    const optim::Variable& v = problem.variables[i];
    result.push_back({v.name, v.unit, fmt::format("{:.7g}", point.x[i]), point.x[i],
                      problems::measure_of(study.bound().statement(), v.name, point.x[i])});
  }
  return result;
}

std::string FrontAnswer::law(const FrontPoint& point) const {
  const auto law = study.law(point);
  if (!law) return "";
  return law_in_words(*law, study.bound().statement().mechanism->moved_by);
}

std::string FrontAnswer::family(const FrontPoint& point) const {
  const auto& statement = study.bound().statement();
  if (statement.mechanism->moved_by == problems::MovedBy::Program) {
    if (statement.laws.size() == 1) return "program";
    return program_name(statement.laws, study.space().options(point.part).front());
  }
  const std::string its_law = law(point);
  return its_law.substr(0, its_law.find(' '));
}

std::size_t FrontAnswer::failing() const {
  return static_cast<std::size_t>(
      std::count_if(built.begin(), built.end(), [](const auto& b) { return b.fails(); }));
}

std::vector<optim::Costs> FrontAnswer::costs() const { return optim::costs_of(front.points); }

}  // namespace camlaw::cli
