// SPDX-License-Identifier: MIT
#include "problems/published/table/stated_model.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "machines/model/given_law.h"
#include "optim/cycle/extremes.h"
#include "optim/problem/deadline.h"
#include "problems/statement/bind.h"
#include "problems/statement/law_names.h"
#include "problems/statement/reading.h"
#include "problems/statement/toml_reader.h"

namespace camlaw::problems::stated {
namespace {

constexpr double kUndefined = std::numeric_limits<double>::quiet_NaN();

/// Where a choice stands that says nothing of a hypothesis, it is as stated.
int choice_of(std::span<const int> choice, std::size_t h) {
  return h < choice.size() ? choice[h] : 0;
}

/// Where the parts of a law that has names for them end, from 0 to 1: a program's segments.
std::vector<double> ends_of_parts(const Member& law) {
  std::vector<double> ends{0};
  if (law.family->spans) {
    for (const NamedSpan& span : law.family->spans(law.arguments)) {
      if (span.end > ends.back() && span.end < 1) ends.push_back(span.end);
    }
  }
  ends.push_back(1);
  return ends;
}

double peak_of(const optim::Trace& trace, optim::Part part) {
  const double value = optim::extreme_of(trace, part).value;
  return part == optim::Part::Magnitude ? std::abs(value) : value;
}

}  // namespace

std::size_t Model::place_in(const std::vector<std::size_t>& by, std::span<const int> choice) const {
  std::size_t place = 0;
  for (const std::size_t h : by) {
    place = place * (table_.hypotheses[h].alternatives.size() + 1) +
            static_cast<std::size_t>(choice_of(choice, h));
  }
  return place;
}

namespace {

/// How many combinations of choices there are.
std::size_t combinations(const StatedTable& table, const std::vector<std::size_t>& by) {
  std::size_t count = 1;
  for (const std::size_t h : by) {
    count *= table.hypotheses[h].alternatives.size() + 1;
    if (count > optim::kMaxCombinations) {
      refuse(table.hypotheses[h].where,
             fmt::format("with the other hypotheses it makes more than {} combinations",
                         optim::kMaxCombinations));
    }
  }
  return count;
}

}  // namespace

Model::NamedByRow Model::law_named(const RowModel& model, std::span<const int> choice) const {
  const StatedRow& row = *model.row;
  if (model.laws_by != kNone && choice_of(choice, model.laws_by) > 0) {
    const StatedHypothesis& hypothesis = table_.hypotheses[model.laws_by];
    const auto k = static_cast<std::size_t>(choice_of(choice, model.laws_by) - 1);
    const auto& map = hypothesis.alternatives[k].departure.laws;
    const auto found = map.find(row.law);
    if (found != map.end()) return {found->second, &hypothesis.where};
  }
  const Entry* law = find(row.where, "law");
  const auto word = table_.laws.find(row.law);
  return {word != table_.laws.end() ? word->second : row.law, law != nullptr ? law : &row.where};
}

std::vector<std::string> Model::settings_of_law(const RowModel& model,
                                                std::span<const int> choice) const {
  std::vector<std::string> settings = model.law_settings;
  for (const std::size_t h : model.law_by) {
    const int k = choice_of(choice, h);
    if (k == 0) continue;
    for (auto& setting : law_settings(model, h, static_cast<std::size_t>(k - 1))) {
      settings.push_back(std::move(setting));
    }
  }
  return settings;
}

/// The law of the name, or without one the law of the file.
Member Model::member_of(const RowModel& model, const NamedByRow& named) const {
  const ProblemStatement& base = bases_.at(model.row->mechanism);
  const MovedBy moved_by = base.mechanism->moved_by;
  if (named.law.empty()) {
    if (moved_by == MovedBy::Law && find(table_.file, "law") == nullptr) {
      refuse(*named.where, fmt::format("{} follows a law; name it, law = \"cosine\", or in [law] "
                                       "for all values",
                                       model.row->response));
    }
    return base.laws.front();
  }
  if (moved_by != MovedBy::Law) {
    refuse(*named.where,
           fmt::format("{} is not moved by a law that a value can name", base.mechanism->name));
  }
  Entry name = *named.where;
  name.kind = Entry::Kind::Text;
  name.text = named.law;
  name.items.clear();
  HeldFiles files;
  return read_law_name(name, files).law;
}

LawOfRow Model::make_law(const RowModel& model, std::span<const int> choice) {
  const NamedByRow named = law_named(model, choice);
  const std::vector<std::string> settings = settings_of_law(model, choice);
  const std::string key =
      fmt::format("{}|{}|{}", model.row->mechanism, named.law, fmt::join(settings, "|"));
  if (const auto known = laws_.find(key); known != laws_.end()) return known->second;
  const ProblemStatement& base = bases_.at(model.row->mechanism);
  Member member = member_of(model, named);
  if (!settings.empty()) {
    ProblemStatement problem = base;
    problem.laws = {member};
    located(*named.where, [&] { set_values(problem, settings); });
    member = problem.laws.front();
  }
  const bool is_possible =
      base.mechanism->moved_by == MovedBy::Nothing || static_cast<bool>(member.possible_law());
  LawOfRow law;
  if (is_possible) law = std::make_shared<LawBinding>(member, std::vector<LawVariable>{});
  return laws_.emplace(key, std::move(law)).first->second;
}

LawOfRow Model::law_of(RowModel& model, std::span<const int> choice) {
  if (model.laws.empty()) model.laws.resize(combinations(table_, model.law_by));
  std::optional<LawOfRow>& law = model.laws[place_in(model.law_by, choice)];
  if (!law) law = make_law(model, choice);
  return *law;
}

double Model::looked_up(const RowModel& model, const LookedUp& number,
                        const std::vector<double>& constants, const LawOfRow& law,
                        Readout readout) {
  Binding binding{constants, {}, {}, law};
  binding.law = given_again(binding);
  if (readout.kind != Readout::Kind::Exact && number.sampled) {
    return read_off(*number.sampled, constants, law->law_at<double>({}),
                    ends_of_parts(law->member_at({})), number.name.part, readout);
  }
  if (number.inner) return number.inner->number(binding).value({});
  const optim::Response response = response_of(*model.problem, number.name, binding);
  if (!response.is_curve()) return response.function().value({});
  const auto trace = response.curve().trace({});
  const std::vector<double> breaks = trace->breaks();
  const bool is_outside = number.place && !(number.place->angle >= breaks.front() &&
                                            number.place->angle <= breaks.back());
  if (is_outside) return kUndefined;
  return number.place ? trace->at(*number.place)[0] : peak_of(*trace, number.name.part);
}

namespace {

/// Whether a hypothesis sets a parameter that a number uses.
bool sets_used(const RowModel& model, const LookedUp& number, std::size_t h) {
  const auto is_used = [&](const auto& set) { return number.uses.holds(set.first); };
  for (const auto& [by, choices] : model.overrides) {
    if (by != h) continue;
    for (const Overrides& overrides : choices) {
      if (std::any_of(overrides.begin(), overrides.end(), is_used)) return true;
    }
  }
  return false;
}

/// Whether a hypothesis changes a number.
bool matters(const RowModel& model, const LookedUp& number, std::size_t h) {
  const bool is_of_law =
      std::find(model.law_by.begin(), model.law_by.end(), h) != model.law_by.end();
  return sets_used(model, number, h) || (number.sees_law && is_of_law) ||
         (number.sampled && model.peaks_by == h);
}

}  // namespace

/// Kept twice: by the row's choices, which is quick to find, and by all that matters to it, which
/// rows share.
double Model::number(RowModel& model, LookedUp& number, const std::vector<double>& constants,
                     std::span<const int> choice) {
  if (number.known.empty()) {
    for (const std::size_t h : model.depends) {
      if (matters(model, number, h)) number.by.push_back(h);
    }
    number.known.resize(combinations(table_, number.by));
  }
  std::optional<double>& known = number.known[place_in(number.by, choice)];
  if (known) return *known;
  const LawOfRow law =
      number.sees_law ? law_of(model, choice)
                      : std::make_shared<LawBinding>(bases_.at(model.row->mechanism).laws.front(),
                                                     std::vector<LawVariable>{});
  Readout readout;
  if (number.sampled && model.peaks_by != kNone && choice_of(choice, model.peaks_by) > 0) {
    const auto k = static_cast<std::size_t>(choice_of(choice, model.peaks_by) - 1);
    readout = table_.hypotheses[model.peaks_by].alternatives[k].departure.peaks.value_or(readout);
  }
  if (law == nullptr) return *(known = kUndefined);
  const std::size_t law_id =
      number.sees_law ? law_ids_.emplace(law.get(), law_ids_.size()).first->second + 1 : 0;
  std::vector<double> key{static_cast<double>(number.id), static_cast<double>(law_id),
                          static_cast<double>(readout.kind), static_cast<double>(readout.steps)};
  for (const std::size_t p : number.uses) key.push_back(constants[p]);
  const auto shared = numbers_.find(key);
  if (shared != numbers_.end()) return *(known = shared->second);
  known = looked_up(model, number, constants, law, readout);
  numbers_.emplace(std::move(key), *known);
  return *known;
}

double Model::value_at(RowModel& model, const std::vector<double>& constants,
                       std::span<const int> choice) {
  std::size_t which = 0;
  if (model.responses_by != kNone) {
    which = model.response_of[static_cast<std::size_t>(choice_of(choice, model.responses_by))];
  }
  RowResponse& response = model.responses[which];
  const MechanismResponse* declared = response.name.response;
  if (declared != nullptr && declared->is_possible && !declared->is_possible(constants)) {
    return kUndefined;
  }
  double value = 0;
  if (response.formula) {
    std::vector<double> all = constants;
    for (LookedUp& held : response.numbers) all.push_back(number(model, held, constants, choice));
    value = (*response.formula)(std::span<const double>(all));
  } else {
    value = number(model, response.numbers.front(), constants, choice);
  }
  value *= response.factor;
  const bool may_cut = model.digits_by != kNone && choice_of(choice, model.digits_by) > 0;
  if (!may_cut) return value;
  const auto k = static_cast<std::size_t>(choice_of(choice, model.digits_by) - 1);
  if (!table_.hypotheses[model.digits_by].alternatives[k].departure.cuts_off) return value;
  const double unit = std::pow(10.0, model.row->printed.number.decimals);
  return std::trunc(value * unit) / unit;
}

double Model::value(std::size_t row, std::span<const int> choice) {
  if (stop_ != nullptr) optim::Deadline({}, stop_).check();
  RowModel& model = rows_[row];
  std::vector<double> constants = model.problem->constants;
  for (const auto& [h, of_choice] : model.overrides) {
    for (const auto& [parameter, value] :
         of_choice[static_cast<std::size_t>(choice_of(choice, h))]) {
      constants[parameter] = value;
    }
  }
  return value_at(model, constants, choice);
}

double Model::value_with(std::size_t row, const Overrides& overrides) {
  RowModel& model = rows_[row];
  std::vector<double> constants = model.problem->constants;
  for (const auto& [parameter, value] : overrides) constants[parameter] = value;
  for (RowResponse& response : model.responses) {
    for (LookedUp& number : response.numbers) {
      std::fill(number.known.begin(), number.known.end(), std::nullopt);  // of other constants
    }
  }
  const double value = value_at(model, constants, {});
  for (RowResponse& response : model.responses) {
    for (LookedUp& number : response.numbers) {
      std::fill(number.known.begin(), number.known.end(), std::nullopt);
    }
  }
  return value;
}

}  // namespace camlaw::problems::stated
